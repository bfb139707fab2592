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
// The smallest separation of the points of a contact that has some, m.
float min_separation(const ContactInfo& contact, const ContactRecord& record);
// Clears the warm-starting impulses. `count`: the number of contact points.
void forget_impulses(ContactRecord& record, int count);

} // namespace cairn
