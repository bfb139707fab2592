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
// Of the points of a contact that has some.
float min_separation(const ContactInfo& contact, const ContactRecord& record);
// `count`: how many points it has.
void forget_impulses(ContactRecord& record, int count);

} // namespace cairn
