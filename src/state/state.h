// Everything that a simulation consists of. Bodies, shapes, contacts and islands live in arrays at stable
// indices; stages (one file each) are functions on this state, and on the working memory of a step
// (state/step_scratch.h). Handles, names and events live above, in world/.
#pragma once

#include "collision/broad_phase.h"
#include "core/slot_pool.h"
#include "kernels/kernels.h"
#include "state/body_state.h"
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
    SlotPool slots;
    std::vector<ForceField> all;
};

struct State {
    std::uint32_t world_id = 0;
    WorldDef settings;
    std::uint64_t steps = 0;
    std::uint64_t passes = 0; // a step is one pass, or several (world/step.cpp)
    double time = 0;

    Bodies bodies;
    Shapes shapes;
    Contacts contacts;
    Islands islands;
    Joints joints;
    ForceFields fields;
    BroadPhase broad_phase{kernels().broad};

    StepEvents events;
    std::uint64_t clamped_speeds = 0;
    Statistics statistics;

    BodyId body_id(std::int32_t body) const {
        return BodyId::make(std::uint32_t(body), bodies.slots.generation(std::uint32_t(body)), world_id);
    }
    ShapeId shape_id(std::uint32_t shape) const {
        return ShapeId::make(shape, shapes.slots.generation(shape), world_id);
    }
    JointId joint_id(std::uint32_t joint) const {
        return JointId::make(joint, joints.slots.generation(joint), world_id);
    }
    bool is_awake(std::int32_t body) const {
        const std::int32_t island = bodies.links[body].island;
        return island != none && islands.all[island].position != none;
    }
};

} // namespace cairn
