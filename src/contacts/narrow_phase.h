// The narrow phase: from pairs of bounds to contact records.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

#include <cairn/communicator.h>

namespace cairn {

// The narrow phase: tests all pairs that may have moved, writes their records, begins and ends contacts in the
// islands and colors, wakes what is hit, and lists in StepScratch::solved what the solver has to do.
// Returns how many pairs it has tested. `ranks`: those that step this world together; null: this process alone.
std::size_t update_contacts(Bodies& bodies, const Shapes& shapes, Contacts& contacts, Islands& islands,
                            const Joints& joints, const ForceFields& fields, const BroadPhase& broad_phase,
                            StepEvents& events, const WorldDef& settings, StepScratch& step, Communicator* ranks,
                            float dt);

} // namespace cairn
