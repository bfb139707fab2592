// Resolves impacts within a step, at the time and place at which they happen (docs/decisions/impacts_in_flight.md).
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// State that impacts read and modify: motion of bodies, contacts that begin to touch, waking bodies, events,
// statistics.
struct ImpactContext {
    const WorldDef& settings;
    const Joints& joints;
    const ForceFields& fields;
    Bodies& bodies;
    Shapes& shapes;
    Contacts& contacts;
    Islands& islands;
    BroadPhase& broad_phase;
    StepEvents& events;
    Statistics& statistics;
    std::uint64_t& clamped_speeds;
    Communicator* ranks; // ranks that step this world together; null: this process alone
};

// Called after the solver has moved all bodies. Considers bodies in free flight, and bodies that have moved so far that
// their core may have passed another. The earliest meeting changes the velocities of both bodies, which continue from
// there; the times of their pairs are recomputed, and so on until the end of the step. Jointed bodies go on straight,
// as a whole, until joints act again (docs/decisions/going_straight.md). What joints hold to the ground, and bodies
// with too many impacts, stop where they meet: the poses at the start were valid, so that stopping cannot fail. No core
// passes another. Until the end, the broad phase has the boxes of the step's start, which contain all expected paths;
// then it gets the new ones.
void resolve_impacts(const ImpactContext& context, StepScratch& step, float dt);

} // namespace cairn
