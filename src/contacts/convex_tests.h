// Tests of pairs of shapes that no wide kernel does.
#pragma once

#include "collision/contact_memory.h"
#include "collision/surface_contact.h"
#include "state/state.h"

namespace cairn {

// Pairs of shapes that no wide kernel tests (convex_tests.cpp), with points up to `margin` meters apart. `guess`: the
// normal of the last step, or zero; `memory`: see collide_convex.
struct PosedShape {
    const Geometry& geometry;
    const ShapeData& data;
    const ShapePose& pose;
    math::Vec3 arm; // from the body's center of mass to the shape's origin
};
Manifold test_convex_pair(PairKind kind, const PosedShape& a, const PosedShape& b, math::Vec3 guess, float margin,
                          ContactMemory& memory);
// Of two convex shapes that have not touched so far: where they are apart, the points are as far apart, at least. The
// normal is that of inset cores, which sharp tips and rims are far outside of: along it shapes may overlap that do not.
void part_points(const PosedShape& a, const PosedShape& b, Manifold& manifold);
// Of any pair but groups, in the order of its test, by a wide kernel or one at a time. `guess`: a direction from the
// first to the second along which they are thought to be nearest, or zero.
Manifold test_posed_pair(PairKind kind, const PosedShape& first, const PosedShape& second, math::Vec3 guess,
                         float margin);
// All directions in which the convex shape `a` touches a mesh or height field, deepest first; `hits` is emptied before.
// Where there are none, returns how far apart they are at least; nothing farther than `reach` is looked at.
float find_patches(const PosedShape& a, const PosedShape& surface, float margin, float reach, SurfaceScratch& scratch,
                   std::vector<Manifold>& hits);

// Of a contact with a one-way shape that holds nothing so far: whether A is not wholly beyond that, and so goes
// through.
bool goes_through(const Shapes& shapes, const ContactInfo& contact);

inline PosedShape posed_shape(const Shapes& shapes, std::uint32_t shape) {
    return {shapes.geometry[shape], shapes.data[shape], shapes.poses[shape], shapes.links[shape].arm};
}

} // namespace cairn
