// Pairs that are about to meet, or part, in free flight: the solver is not needed there, as no contact and no joint
// holds either of the two. They meet where and when their real motions say (impacts/resolve_impacts.h).
#pragma once

#include "contacts/contexts.h"

namespace cairn {

// Whether the shapes are apart, and no joint or sleep keeps their bodies from flying: by more than the margin of the
// contact, or so that they close or open more than that in the step, or they do not touch, and in the step would not or
// would bounce; or whether one turns so far that their contact cannot stay as it is in the step. What settles down on
// something is the solver's.
// Whether another contact holds one of the bodies shows when all pairs are known.
bool may_meet_in_flight(const NarrowInput& in, const Contacts& contacts, const ContactInfo& contact,
                        const Manifold& manifold, float dt);

// All pairs of the step have been tested: of those that may meet in flight, the ones whose bodies nothing holds are
// listed in NarrowScratch::in_flight, and are no contacts; the others are contacts like any.
void settle_flights(const NarrowInput& in, const FollowUpContext& context, ThreadPool& thread_pool, float dt);

// Whether a contact of the two can be off by more than its margin at the end of the step, as they turn, wherever it is
// and however its normal lies: few turn so fast.
bool may_turn_away(const Bodies& bodies, const ContactInfo& contact, float dt);

// Whether a pair has met already, at the point that its test gives first, and will be there after the step: no touch of
// it is to come, it does not stay apart, and it does not meet in flight, as it does not turn away.
inline bool stays_in_contact(const Bodies& bodies, const ContactInfo& c, const Manifold& m, float dt) {
    return m.count > 0 && m.points[0][3] <= 0 && !c.is_trigger && !may_turn_away(bodies, c, dt);
}

} // namespace cairn
