// Contact points: from the kernel's manifold to the contact record, together with the impulses of the last step.
#pragma once

#include "state/state.h"
#include "state/touch.h"

namespace cairn {

// Accessors for contact point i: its arm and separation; its normal impulse, summed over the last step's substeps.
inline const float* point_of(const ContactRecord& r, int i) { return i == 0 ? r.first_point : r.more_points[i - 1]; }
inline float* point_of(ContactRecord& r, int i) { return i == 0 ? r.first_point : r.more_points[i - 1]; }
inline float total_of(const ContactRecord& r, int i) { return i == 0 ? r.first_total : r.more_totals[i - 1]; }

// Writes the record of a contact from a manifold that has points. Points that stay in place keep their impulses.
void write_record(const Shapes& shapes, ContactInfo& contact, ContactRecord& record, const Manifold& manifold,
                  const Moment& moment);
// The distance, m, from the center or axis that a surface is round about to the point midway between the surfaces, with
// that normal; 0 where the surface is flat. A round surface does not turn with its body. For cones it is the mean
// radius of curvature. Rounded shapes touch by a corner, an edge or a rim of their core, and the rounding about it,
// even where a face lies flat.
float contact_radius(const Geometry& shape, const ShapePose& pose, math::Vec3 outwards, float separation);
// The smallest separation of the points of a contact that has some, m.
float min_separation(const ContactInfo& contact, const ContactRecord& record);
// Clears the warm-starting impulses. `count`: the number of contact points.
void forget_impulses(ContactRecord& record, int count);

} // namespace cairn
