// Tests of shape pairs that have no wide kernel.
#pragma once

#include "collision/contact_memory.h"
#include "collision/surface_contact.h"
#include "state/state.h"

namespace cairn {

// A shape at a pose, as the pair tests below take it.
struct PosedShape {
    const Geometry& geometry;
    const ShapeData& data;
    const ShapePose& pose;
    math::Vec3 arm; // from the body's center of mass to the shape's origin
};
// Tests a pair that has no wide kernel; contact points have separations up to `margin` meters. `guess`: the normal of
// the last step, or zero; `memory`: see collide_convex.
Manifold test_convex_pair(PairKind kind, const PosedShape& a, const PosedShape& b, math::Vec3 guess, float margin,
                          ContactMemory& memory);
// Corrects the separations in the manifold of two convex shapes that have not touched so far: if the shapes are
// separated, the least separation becomes their distance. The manifold's normal is that of inset cores, far outside of
// which sharp tips and rims lie: along it, shapes may overlap that are separated.
void part_points(const PosedShape& a, const PosedShape& b, Manifold& manifold);
// Tests any pair except a mesh contact, with the shapes in the order of its test, by a wide kernel or one at a time.
// `guess`: the expected normal, from the first shape to the second, or zero.
Manifold test_posed_pair(PairKind kind, const PosedShape& first, const PosedShape& second, math::Vec3 guess,
                         float margin);
// Finds one manifold per direction in which the convex shape `a` touches a mesh or height field, deepest first, in
// `hits`, which is emptied before. If there are none, returns a lower bound of the distance; nothing farther than
// `reach` is tested.
float find_patches(const PosedShape& a, const PosedShape& surface, float margin, float reach, SurfaceScratch& scratch,
                   std::vector<Manifold>& hits);

// Whether a contact with a one-way shape that has no points so far lets A pass: A is not wholly beyond that shape.
bool goes_through(const Shapes& shapes, const ContactInfo& contact);

inline PosedShape posed_shape(const Shapes& shapes, std::uint32_t shape) {
    return {shapes.geometry[shape], shapes.data[shape], shapes.poses[shape], shapes.links[shape].arm};
}

} // namespace cairn
