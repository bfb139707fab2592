// The data that functions of the narrow phase read, and the data that they change.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

#include <cairn/communicator.h>

namespace cairn {

// The input of pair tests besides the contact at hand. It does not change before all tests are done, so threads that
// test other pairs can share it.
struct NarrowInput {
    const WorldDef& settings;
    const Bodies& bodies;
    const Shapes& shapes;
    const Islands& islands;
    const Joints& joints;
    const ForceFields& fields;
    int substeps; // of the step, for islands that need no more
};

// The data that change once the tests have determined which contacts begin, continue and end: island lists, graph
// colors, sleep, events, and the list of contacts to solve. One thread changes them, contact by contact.
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
    Communicator* ranks; // the ranks that step this world together; null: this process alone
};

} // namespace cairn
