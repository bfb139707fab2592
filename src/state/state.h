// The complete state of a simulation. Bodies, shapes, contacts and islands are stored in arrays at stable indices; the
// stages of a step (one file each) are functions of this state and of a step's working memory (state/step_scratch.h).
// Handles, names and events belong to the layer above, in world/.
#pragma once

#include "collision/broad_phase.h"
#include "core/slot_pool.h"
#include "kernels/kernels.h"
#include "state/body_state.h"
#include "state/character_state.h"
#include "state/contact_state.h"
#include "state/events.h"
#include "state/island_state.h"
#include "state/joint_state.h"
#include "state/shape_state.h"

#include <cairn/world.h>

#include <cstdint>
#include <vector>

namespace cairn {

struct ForceFields {
    SlotPool<ForceFieldId> slots;
    std::vector<ForceField> all;
};

struct State {
    WorldDef settings;
    std::uint64_t steps = 0;
    double time = 0;

    Bodies bodies;
    Shapes shapes;
    Contacts contacts;
    Islands islands;
    Joints joints;
    ForceFields fields;
    Characters characters;
    BroadPhase broad_phase{kernels().broad};

    StepEvents events;
    std::uint64_t clamped_speeds = 0;
    Statistics statistics;

    // Sets the number by which handles of different worlds are told apart.
    void set_world(std::uint32_t world) {
        bodies.slots.set_world(world), shapes.slots.set_world(world), joints.slots.set_world(world);
        fields.slots.set_world(world);
    }
};

} // namespace cairn
