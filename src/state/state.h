// Everything that a simulation consists of. Bodies, shapes, contacts and islands live in arrays at stable
// indices; stages (one file each) are functions on this state, and on the working memory of a step
// (state/step_scratch.h). Handles, names and events live above, in world/.
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

    // The number by which handles tell worlds apart.
    void set_world(std::uint32_t world) {
        bodies.slots.set_world(world), shapes.slots.set_world(world), joints.slots.set_world(world);
        fields.slots.set_world(world);
    }
};

} // namespace cairn
