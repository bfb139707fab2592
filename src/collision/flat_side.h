// Round sides that are nearly flat for what is small beside them: of balls, and of cylinders and capsules with equal
// ends.
//
// What is round touches a flat face by one point or line, and as that face turns by a little the place moves on: with
// the radius R by R times the angle. Where that is from one end of the face to the other in a step, a box falls from
// one corner on the other for ever, deeper each time. So a round side that is nowhere farther from its tangent plane,
// over the reach of the other shape, than what that may be inside (core_depth_of) is met as that plane. Where it is
// farther, but corners of the face may still come to touch in a step, they belong to the contact as well.
#pragma once

#include "collision/core_sweep.h"
#include "collision/manifold.h"
#include "shapes/convex.h"

#include <optional>

namespace cairn {

// Whether that is so for a shape somewhere beside the other one. `width`: the least of `other`, m.
bool may_be_flat(const Geometry& round, const Geometry& other, float width);

// A half-space in place of a shape.
struct FlatSide {
    math::DVec3 up; // its unit normal
    double height;  // of the center of the other shape above it, m
};
// Of one that may be flat: the plane under the middle of `other`, which reaches so far from there, m; nothing where
// that is beside or beyond the end of a cylinder or capsule. Both are given in one frame.
std::optional<FlatSide> flat_side_under(const Convex& round, const Convex& other, double reach);

// Whether all of a face that a round side touches is as near to it as contacts look ahead, `margin` m.
bool is_nearly_flat(const Geometry& round, const Geometry& other, float margin);
// Then the corners of that face belong to the contact, with their own distances: those that are farthest from the point
// or the two points that it has, as a body is held there already. `margin`: points are no farther apart, m. The normal
// is from `other` to what is round.
void add_corners(const Convex& round, const Convex& other, double reach, double margin, Manifold& out);

} // namespace cairn
