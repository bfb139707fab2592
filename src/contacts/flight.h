// Pairs that are about to meet, or to separate, in free flight. The solver is not needed for them, as no contact and no
// joint constrains either body. They meet at the place and time that their exact motions give
// (impacts/resolve_impacts.h).
#pragma once

#include "contacts/contexts.h"

namespace cairn {

// Whether a pair may be left to free flight, provided that no other contact constrains its bodies, which is known only
// after all pairs have been tested. Neither joints nor sleep may hold the bodies, and one of these must hold: the
// shapes are separated by more than the margin of the contact; or the distance changes by more than the margin within
// the step; or the shapes do not touch yet, and in this step would not touch or would bounce; or a body rotates so far
// that the contact cannot stay as it is in the step. A body that comes to rest on another is left to the solver.
bool may_meet_in_flight(const NarrowInput& in, const Contacts& contacts, const ContactInfo& contact,
                        const Manifold& manifold, float dt);

// After all pairs of the step have been tested: pairs that may meet in free flight and whose bodies nothing constrains
// are listed in NarrowScratch::in_flight and are no contacts; the others become ordinary contacts.
void settle_flights(const NarrowInput& in, const FollowUpContext& context, ThreadPool& thread_pool, float dt);

// Whether rotation can make the contact of two bodies wrong by more than its margin at the end of the step, wherever
// the contact is and whatever its normal. Few bodies rotate so fast.
bool may_turn_away(const Bodies& bodies, const ContactInfo& contact, float dt);

// Whether a pair overlaps already at the first point of its manifold, and still will after the step: it needs no search
// for a touch, does not stay separated, and does not meet in free flight, as it does not turn away.
inline bool stays_in_contact(const Bodies& bodies, const ContactInfo& c, const Manifold& m, float dt) {
    return m.count > 0 && m.points[0][3] <= 0 && !c.is_trigger && !may_turn_away(bodies, c, dt);
}

} // namespace cairn
