// The narrow phase on several ranks. A pair is tested by the rank that has its record (contacts/record_owners.h). That
// rank sends the rest of the result to the others: whether the contact begins, continues or ends, its number of points,
// and up to which travel it stays separated. With that, all ranks change islands, graph colors, sleep and events in the
// same way.
#pragma once

#include "contacts/contexts.h"

#include <span>

namespace cairn {

// Lists in NarrowScratch::shared the pairs to test that a single rank tests; the lists by kind keep the pairs of this
// rank.
void leave_pairs_to_owners(const Contacts& contacts, NarrowScratch& narrow);

// Exchanges the results of the pairs at those places, each of which one rank has tested.
void exchange_tests(const NarrowInput& in, const FollowUpContext& context, std::span<const std::uint32_t> places,
                    float dt);

// Exchanges NarrowScratch::dropped (internal edges) and NarrowScratch::lifted (contacts found anew), which each rank
// has found among the contacts of its bodies.
void exchange_internal_edges(const Bodies& bodies, Contacts& contacts, NarrowScratch& narrow, Communicator& ranks);

// After the solver: exchanges NarrowScratch::touches, for the contacts that begin to touch, in the order of
// NarrowScratch::changes.
const TouchPoint* exchange_touches(const Contacts& contacts, const SolverScratch& solver, NarrowScratch& narrow,
                                   Communicator& ranks);

} // namespace cairn
