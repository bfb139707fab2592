// What is round about an axis and touches a face: turning about its axis, or about the normal, changes nothing there.
#pragma once

#include "contacts/contexts.h"
#include "contacts/convex_tests.h"

namespace cairn {

// An axis of a shape's frame: 0 to 2, that about which it is round is 1.
math::Vec3 axis_of(const ShapePose& pose, int i);

// Whether a shape touches another by a flat face with that normal, as far as its geometry says.
bool is_flat(const Geometry& shape, const ShapePose& pose, math::Vec3 normal);
// Whether a manifold tells that its normal is that of a face of its first shape, or of the second: of hulls, cylinders,
// meshes and height fields, of which is_flat does not know.
bool touches_by_face(PairKind kind, const Manifold& m, bool is_second);

bool has_corners(const Geometry& shape);

// Which of two shapes, of which something is round, touches the other by a face. `normal`: from A to B.
enum class TouchingFace : std::uint8_t { none, of_a, of_b };
TouchingFace touching_face(const Shapes& shapes, const ContactInfo& contact, const Manifold& manifold,
                           math::Vec3 normal, const ShapePose& pose_a, const ShapePose& pose_b);
// Whether the normal of a contact, as its record has it, is that of a face, or of two edges: it turns with the bodies,
// and not with where they are. The side of what is round is no such face, even if it has several places of touch.
bool has_own_normal(const Shapes& shapes, const ContactInfo& contact, const ContactRecord& record);
// Whether what lay on a face when its record was written is beyond the end of that with this manifold.
bool leaves_face(const Shapes& shapes, const ContactInfo& contact, const ContactRecord& last, const Manifold& manifold,
                 const ShapePose& pose_a, const ShapePose& pose_b);

// Whether a shape that is round about an axis touches another on a face, by the only point: the solver follows the
// place, however it turns about its axis and the normal.
bool is_followed(PairKind kind, const Geometry& shape, const Geometry& other, const ShapePose& pose_of_other,
                 const Manifold& m, bool other_is_second);

// Of what turns with w: the part that tilts the axis toward the normal, and so brings points nearer.
math::Vec3 tilting_part(const Geometry& shape, const ShapePose& pose, math::Vec3 w, math::Vec3 normal);

// What two surfaces are round about where they meet with that normal, from A to B: for the solver to follow it, as in
// ContactRecord. Nothing if one is not round, or not in a way that is followed.
struct RoundPair {
    float about = 0;
    math::Vec3 axis;
};
RoundPair round_pair(const Geometry& a, const ShapePose& pose_a, const Geometry& b, const ShapePose& pose_b,
                     math::Vec3 normal);

// Takes from a manifold of cylinders or capsules the points that do not come to touch in the step, as the bodies tilt
// about the lowest one by their spins, what pulls at them, and what they meet. So what rolls on a rim has one point.
// `touches`: whether the pair did before; of those that did not, only what something else carries is looked at.
void drop_what_stays_apart(const NarrowInput& in, const ContactInfo& contact, bool touches, const PosedShape& a,
                           const PosedShape& b, float dt, Manifold& manifold);

} // namespace cairn
