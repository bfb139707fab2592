// Contacts of a face with a shape that is round about an axis: rotation about that axis, or about the normal, does not
// change them.
#pragma once

#include "contacts/contexts.h"
#include "contacts/convex_tests.h"

namespace cairn {

// Axis i of a shape's frame, in world axes; a shape of revolution is round about axis 1.
math::Vec3 axis_of(const ShapePose& pose, int i);

// Whether the side of a shape with that normal is a flat face, as far as its geometry tells.
bool is_flat(const Geometry& shape, const ShapePose& pose, math::Vec3 normal);
// Whether the features of a manifold mark its normal as that of a face of the first shape, or of the second: for hulls,
// cylinders, meshes and height fields, which is_flat does not cover.
bool touches_by_face(PairKind kind, const Manifold& m, bool is_second);

bool has_corners(const Geometry& shape);

// Which of two shapes, at least one of them round, touches the other by a face. `normal`: from A to B.
enum class TouchingFace : std::uint8_t { none, of_a, of_b };
TouchingFace touching_face(const Shapes& shapes, const ContactInfo& contact, const Manifold& manifold,
                           math::Vec3 normal, const ShapePose& pose_a, const ShapePose& pose_b);
// Whether the normal in a contact's record is that of a face or of two edges: then it depends on the rotations of the
// bodies, but not on their positions. The side of a round shape is no such face, even if it touches in several places.
bool has_own_normal(const Shapes& shapes, const ContactInfo& contact, const ContactRecord& record);
// Whether a shape that lay on a face when `last` was written is beyond the end of that face in this manifold.
bool leaves_face(const Shapes& shapes, const ContactInfo& contact, const ContactRecord& last, const Manifold& manifold,
                 const ShapePose& pose_a, const ShapePose& pose_b);

// Whether a shape that is round about an axis touches a face of another in a single point. The solver tracks this
// point, however the shape rotates about its axis and the normal.
bool is_followed(PairKind kind, const Geometry& shape, const Geometry& other, const ShapePose& pose_of_other,
                 const Manifold& m, bool other_is_second);

// The part of the angular velocity w that tilts the shape's axis toward the normal, and so brings points nearer.
math::Vec3 tilting_part(const Geometry& shape, const ShapePose& pose, math::Vec3 w, math::Vec3 normal);

// The point or axis about which two surfaces are round where they touch; `normal`: from A to B. The solver uses it to
// update the normal (see ContactRecord). Empty if one surface is not round, or if the solver does not track the pair.
struct RoundPair {
    float about = 0;
    math::Vec3 axis;
};
RoundPair round_pair(const Geometry& a, const ShapePose& pose_a, const Geometry& b, const ShapePose& pose_b,
                     math::Vec3 normal);

// Removes from a manifold of cylinders or capsules the points that will not touch within the step, given how the bodies
// tilt about the lowest point by their angular velocities, by gravity and by the approach. So a shape that rolls on its
// rim has one point. `touches`: whether the pair did before; other pairs are handled only if A has another contact.
void drop_separated_points(const NarrowInput& in, const ContactInfo& contact, bool touches, const PosedShape& a,
                           const PosedShape& b, float dt, Manifold& manifold);

} // namespace cairn
