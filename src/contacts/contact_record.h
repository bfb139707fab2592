// The points of a contact: from the kernel's manifold to the record, with the impulses of the last step.
#pragma once

#include "state/state.h"
#include "state/touch.h"

namespace cairn {

// Arm and separation of a point; its normal impulse summed over the last step's substeps.
inline const float* point_of(const ContactRecord& r, int i) { return i == 0 ? r.first_point : r.more_points[i - 1]; }
inline float* point_of(ContactRecord& r, int i) { return i == 0 ? r.first_point : r.more_points[i - 1]; }
inline float total_of(const ContactRecord& r, int i) { return i == 0 ? r.first_total : r.more_totals[i - 1]; }

// Writes the record of a contact from the kernel's manifold, which has points. Impulses go on where points stay.
void write_record(const Shapes& shapes, ContactInfo& contact, ContactRecord& record, const Manifold& manifold,
                  const Moment& moment);
// A round surface does not turn with its body: how far it is to the point midway between the surfaces from the center
// or axis that it is round about, with that normal; 0 where the surface is flat. For cones the mean radius of
// curvature. Rounded shapes touch by a corner, an edge or a rim of their core, and what is around that; also where a
// face lies flat.
float contact_radius(const Geometry& shape, const ShapePose& pose, math::Vec3 outwards, float separation);
// Of the points of a contact that has some.
float min_separation(const ContactInfo& contact, const ContactRecord& record);
// `count`: how many points it has.
void forget_impulses(ContactRecord& record, int count);

} // namespace cairn
