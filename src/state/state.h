// Everything that a simulation consists of. Bodies, shapes, contacts and islands live in arrays at stable
// indices; stages (one file each) are functions on this state. Handles, names and events live above, in world/.
#pragma once

#include "collision/broad_phase.h"
#include "collision/shape_pose.h"
#include "core/slot_pool.h"
#include "jobs/thread_pool.h"
#include "kernels/kernels.h"
#include "kernels/solve/solver_data.h"
#include "math/vec.h"
#include "shapes/geometry.h"
#include "state/body_state.h"
#include "state/contact_state.h"
#include "state/direct_sets.h"
#include "state/events.h"
#include "state/island_state.h"
#include "state/joint_state.h"
#include "state/narrow_scratch.h"
#include "state/shape_state.h"
#include "state/solver_scratch.h"
#include "state/travel.h"

#include <cairn/world.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace cairn {

struct State {
    WorldDef settings;
    std::uint64_t steps = 0;
    std::uint64_t passes = 0;     // a step is one pass, or several (world/step.cpp)
    int split = 1;                // passes of the step under way
    std::uint64_t first_pass = 0; // of the step under way: `passes` at its start
    double time = 0;

    SlotPool body_slots;
    std::vector<BodyMotion> motion;
    std::vector<BodyMass> mass;
    std::vector<BodySettings> body_settings;
    std::vector<BodyForces> forces;
    std::vector<std::int32_t> pushed; // bodies with any
    std::vector<BodyLinks> bodies;
    std::vector<Travel> travel;           // by body: how far any point of it has moved, at most
    std::vector<CountedPose> counted;     // up to there
    std::vector<Travel> ahead;            // how far a body will have moved after this pass, at most
    std::vector<Travel> boxes_until;      // the travel up to which its fat boxes serve; only saves time
    std::vector<std::int32_t> kinematics; // kinematic bodies, in order of creation

    SlotPool shape_slots;
    std::vector<Geometry> geometry;
    std::vector<ShapeData> shape_data;
    std::vector<ShapePose> shape_poses;
    std::vector<ShapeLinks> shapes;
    std::vector<Material> materials;
    std::vector<ShapeTraits> shape_traits;

    std::vector<ContactRecord> records;
    std::vector<ContactInfo> contacts;
    std::vector<PairAnswer> answers; // by contact
    std::vector<std::uint32_t> free_contacts;

    std::vector<Island> islands;
    std::vector<std::int32_t> free_islands;
    std::vector<std::int32_t> awake_islands;
    std::vector<std::int32_t> falling_asleep; // islands that the broad phase still holds as awake
    std::vector<std::int32_t> waking;         // keys that it still holds as sleeping

    SlotPool joint_slots;
    std::vector<JointInfo> joints;
    std::vector<JointAxes> joint_axes; // by joint

    SlotPool field_slots;
    std::vector<ForceField> fields;
    std::vector<std::uint32_t> dead_bodies, dead_shapes; // recycled after the broad phase's update

    BroadPhase broad_phase{kernels().broad};

    StepEvents events;
    std::vector<std::uint32_t> overloaded_joints; // of the last step, in ascending order
    std::uint64_t clamped_speeds = 0;
    Statistics statistics;

    // --- working memory of a step, not state
    NarrowScratch narrow;
    std::vector<std::uint32_t> solved; // contacts to solve in this step
    SolverScratch solver;
    DirectSets direct;
    std::uint64_t joint_changes = 0; // of joints, and of the masses of what is jointed
    std::unique_ptr<ThreadPool> thread_pool = std::make_unique<ThreadPool>(1);

    BodyId body_id(std::int32_t body) const {
        return BodyId::make(std::uint32_t(body), body_slots.generation(std::uint32_t(body)), world_id);
    }
    ShapeId shape_id(std::uint32_t shape) const {
        return ShapeId::make(shape, shape_slots.generation(shape), world_id);
    }
    JointId joint_id(std::uint32_t joint) const {
        return JointId::make(joint, joint_slots.generation(joint), world_id);
    }
    // Of the given number in a step, how many a pass takes.
    int in_pass(int substeps) const { return (substeps + split - 1) / split; }
    bool is_pushed(std::int32_t body) const { return !pushed.empty() && forces[body].any; }
    bool is_dynamic(std::int32_t body) const { return body_settings[body].type == BodyType::dynamic; }
    bool is_awake(std::int32_t body) const {
        const std::int32_t island = bodies[body].island;
        return island != none && islands[island].position != none;
    }
    std::uint32_t world_id = 0;
};

} // namespace cairn
