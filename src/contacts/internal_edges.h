// Edges between surfaces that lie side by side.
#pragma once

#include "contacts/contexts.h"
#include "state/state.h"
#include "state/step_scratch.h"

#include <cairn/communicator.h>

namespace cairn {

// A body that slides over several surfaces side by side must not bump into the edges between them: takes out of
// StepScratch::solved what is an edge of one in the plane of another.
void drop_internal_edges(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow,
                         std::vector<std::uint32_t>& solved, ThreadPool& thread_pool, Communicator* ranks, float dt);
// The contact, or the group that it is a patch of, is to be tested in the next step, however little moves.
void test_again(const Bodies& bodies, Contacts& contacts, std::uint32_t contact);
// The contact is such an edge.
void drop_internal_edge(const Bodies& bodies, Contacts& contacts, NarrowScratch& narrow, std::uint32_t contact);

} // namespace cairn
