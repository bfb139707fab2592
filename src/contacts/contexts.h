// What the functions of the narrow phase read, and what they change.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

#include <cairn/communicator.h>

namespace cairn {

// What tests of pairs read beside the contact at hand. Threads that test other pairs read the same: nothing of it
// changes before all are done.
struct NarrowInput {
    const WorldDef& settings;
    const Bodies& bodies;
    const Shapes& shapes;
    const Islands& islands;
    const Joints& joints;
    const ForceFields& fields;
    int substeps; // of the step, where no island asks for more
};

// What changes once the tests have said which contacts begin, go on and end: lists of islands, colors, sleep, events,
// and what is to be solved. One thread does so, contact by contact.
struct FollowUpContext {
    const WorldDef& settings;
    const ForceFields& fields;
    const Shapes& shapes;
    Bodies& bodies;
    Contacts& contacts;
    Islands& islands;
    StepEvents& events;
    NarrowScratch& narrow;
    std::vector<std::uint32_t>& solved;
    Communicator* ranks; // that step this world together; null: none but this one
};

} // namespace cairn
