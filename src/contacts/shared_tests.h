// The narrow phase on several ranks. A pair is tested where its record is (contacts/record_owners.h), and the others
// are told what else came of it: whether its contact begins, goes on or ends, how many points it has, until when it
// stays apart. With that, all ranks do the same to islands, colors, sleep and events.
#pragma once

#include "contacts/contexts.h"

#include <span>

namespace cairn {

// Of the pairs that are to be tested, NarrowScratch::shared gets those that one rank alone tests; the lists by kind
// keep those of this rank.
void leave_pairs_to_owners(const Contacts& contacts, NarrowScratch& narrow);

// The pairs at those places, each of which one rank has tested.
void exchange_tests(const NarrowInput& in, const FollowUpContext& context, std::span<const std::uint32_t> places,
                    float dt);

// Internal edges, NarrowScratch::dropped, and what was found anew, NarrowScratch::lifted, which each rank has found
// among the contacts of its bodies.
void exchange_internal_edges(const Bodies& bodies, Contacts& contacts, NarrowScratch& narrow, Communicator& ranks);

// After the solver: NarrowScratch::touches, of the contacts that begin to touch, in the order of
// NarrowScratch::changes.
const TouchPoint* exchange_touches(const Contacts& contacts, const SolverScratch& solver, NarrowScratch& narrow,
                                   Communicator& ranks);

} // namespace cairn
