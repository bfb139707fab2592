// Internal edges: edges between surfaces that lie side by side.
#pragma once

#include "contacts/contexts.h"
#include "state/state.h"
#include "state/step_scratch.h"

#include <cairn/communicator.h>

namespace cairn {

// A body that slides over several surfaces side by side must not bump into the edges between them: removes from
// StepScratch::solved the contacts with an edge of one surface in the plane of another.
void drop_internal_edges(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow,
                         std::vector<std::uint32_t>& solved, ThreadPool& thread_pool, Communicator* ranks, float dt);
// Lets the contact, or the mesh contact that it is a patch of, be tested in the next step even if its bodies hardly
// move.
void test_again(const Bodies& bodies, Contacts& contacts, std::uint32_t contact);
// Marks a contact as one with an internal edge.
void drop_internal_edge(const Bodies& bodies, Contacts& contacts, NarrowScratch& narrow, std::uint32_t contact);

} // namespace cairn
