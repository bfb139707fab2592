// Moves characters at the beginning of a step (docs/decisions/characters.md).
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// The inputs of moving characters, and the data that it changes: the velocities of their bodies, with which the step
// then moves them, and forces on dynamic bodies.
struct CharacterContext {
    const WorldDef& settings;
    const ForceFields& fields;
    Bodies& bodies;
    Shapes& shapes;
    Islands& islands;
    BroadPhase& broad_phase;
    StepEvents& events;
    Characters& characters;
};

void move_characters(const CharacterContext& context, CharacterScratch& scratch, float dt);

} // namespace cairn
