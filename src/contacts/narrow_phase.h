#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

#include <cairn/communicator.h>

namespace cairn {

// The narrow phase: tests all pairs whose bodies may have moved, writes their contact records, begins and ends contacts
// in islands and graph colors, wakes bodies that are hit, and lists in StepScratch::solved the contacts to solve.
// Returns the number of tested pairs. `ranks`: those that step this world together; null: this process alone.
std::size_t update_contacts(Bodies& bodies, const Shapes& shapes, Contacts& contacts, Islands& islands,
                            const Joints& joints, const ForceFields& fields, const BroadPhase& broad_phase,
                            StepEvents& events, const WorldDef& settings, StepScratch& step, Communicator* ranks,
                            float dt);

} // namespace cairn
