// Round sides that are nearly flat relative to a small shape: of balls, and of cylinders and capsules with equal ends.
//
// A round side touches a flat face in one point or line, which moves by R times the angle (R: the radius) when the face
// rotates. If this is from one end of the face to the other within a step, a box rocks from one corner to the other
// forever, deeper each time. So a round side that deviates from its tangent plane, over the extent of the other shape,
// by no more than the depth of a core (core_depth_of) is replaced by that plane. If it deviates more, but corners of
// the face may still touch within a step, these are added to the contact.
#pragma once

#include "collision/core_sweep.h"
#include "collision/manifold.h"
#include "shapes/convex.h"

#include <optional>

namespace cairn {

// Whether a round side may be replaced by its tangent plane for another shape anywhere on it. `width`: the least width
// of `other`, m.
bool may_be_flat(const Geometry& round, const Geometry& other, float width);

// A half-space that replaces a shape.
struct FlatSide {
    math::DVec3 up; // its unit normal
    double height;  // of the center of the other shape above the plane, m
};
// For a round side that may be flat: the tangent plane below the middle of `other`, which extends `reach` m from there;
// nothing if that is beside or beyond the end of a cylinder or capsule. Both shapes are given in one frame.
std::optional<FlatSide> flat_side_under(const Convex& round, const Convex& other, double reach);

// Whether a face that touches a round side is within the speculative margin, `margin` m, of it everywhere.
bool is_nearly_flat(const Geometry& round, const Geometry& other, float margin);
// Adds the corners of such a face to the contact, with their own separations: those farthest from the one or two points
// that the contact has, as these hold the body already. `margin`: the greatest separation, m. The normal is from
// `other` to `round`.
void add_corners(const Convex& round, const Convex& other, double reach, double margin, Manifold& out);

} // namespace cairn
