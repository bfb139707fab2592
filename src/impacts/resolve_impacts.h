// Impacts within a step, when and where they happen (docs/decisions/impacts_in_flight.md).
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// What impacts read, and what they change: ways of bodies, contacts that begin to touch, what wakes, events, counts.
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
    Communicator* ranks; // that step this world together; null: none but this one
};

// After the solver has moved all bodies by what holds or touches them. Of what flies, and of what moved so far that its
// core may have passed another, the earliest meeting changes the velocities of both, which go on from there; their
// pairs are asked again, and so on until the end of the step. Where the solver knew the contact, or nothing approaches,
// both stop: poses at the start were valid, so that stopping cannot fail. No core passes another. The
// broad phase has the boxes of the step's start until then, which hold all ways that were expected; then it is told.
void resolve_impacts(const ImpactContext& context, StepScratch& step, float dt);

} // namespace cairn
