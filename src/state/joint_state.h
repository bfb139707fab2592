// The state of joints: frames, constraint rows, and the impulses of the last substep for warm starting.
#pragma once

#include "core/slot_pool.h"
#include "kernels/solve/joint_data.h"
#include "math/vec.h"
#include "state/travel.h"

#include <cstdint>
#include <vector>

namespace cairn {

inline constexpr int max_joint_axes = 8;

// How much the point or the rotation rows of a joint lock: nothing, all directions across an axis, or all directions.
enum class JointLock : std::uint8_t { none, across, full };

// The definition of one axis row.
struct JointAxisRule {
    AxisKind kind = AxisKind::linear;
    std::uint8_t column_a = 0, column_b = 0; // columns of the frames: the axis in A and in B
    std::uint8_t is_equation = 0;            // lower = upper
    std::uint8_t has_limits = 0, has_drive = 0, rigid_limit = 1, limit_relative = 0, rigid_drive = 0,
                 drive_relative = 0;
    std::uint8_t is_lock = 0; // a part of the joint type, not a position that users request
    std::uint8_t padding = 0;
    float lower = -unlimited, upper = unlimited, limit_stiffness = 0, limit_damping = 0;
    float drive_stiffness = 0, drive_damping = 0, target_position = 0, target_velocity = 0, max_drive = 0;
    float friction = 0;
    float ratio_a = 1, ratio_b = 1;
};

struct JointAxisState {
    float drive = 0, friction = 0, lower = 0, upper = 0; // N s or N m s: impulses of the last substep
    float position = 0;
    std::uint32_t is_idle = 0; // its limits are out of reach and not solved; `position` is not valid
    // The sum of the bodies' travels until which the limits are out of reach and not solved (joints/idle_limits.cpp);
    // for limits that are solved, that sum when they were last solved.
    Travel until = 0;
};

// The locks of a joint, besides its axes.
struct JointLocks {
    JointLock point = JointLock::none, turn = JointLock::none;
    std::uint8_t point_column = 0, turn_column = 0; // the axis that is left free
    std::uint8_t axis_count = 0;
    std::uint8_t padding[3] = {};
};
struct JointRules {
    JointLocks locks;
    JointAxisRule axes[max_joint_axes];
};

// Only for joints that have axes.
struct JointAxes {
    JointAxisRule rules[max_joint_axes];
    JointAxisState states[max_joint_axes];
};

// The first cache line has what the layout of batches needs, and most of what the start and the end of a step need.
struct alignas(64) JointInfo {
    std::int32_t body_a = -1, body_b = -1;                   // none: the world
    std::int32_t next[2] = {-1, -1}, previous[2] = {-1, -1}; // joint ends in the lists of the bodies: 2 x joint + side
    JointLocks rules;
    std::uint8_t color = 255; // no_color: neither body is dynamic
    std::uint8_t enable_collision = 0, in_use = 0, solver = 0;
    float substep_time = 0; // s: the substep length of the stored impulses
    float break_force = 0, break_torque = 0;
    math::Vec3 point_impulse;          // of the last substep
    std::uint8_t enabled = 1;          // 0: not solved, and does not disable collision
    std::uint8_t line_padding[3] = {}; // snapshots contain all bytes, so none may be uninitialized

    math::DVec3 anchor_a, anchor_b; // in the bodies' frames; for the world, in world axes
    math::Vec3 force;
    float padding = 0;
    math::Vec3 torque, turn_impulse;
    math::DQuat frame_a, frame_b;
    math::DVec3 ground_a, ground_b; // of a pulley
    double tail_padding[7] = {};
};
static_assert(sizeof(JointInfo) == 320);

// All joints. Vectors are indexed by joint.
struct Joints {
    SlotPool<JointId> slots;
    std::vector<JointInfo> info;
    std::vector<JointAxes> axes;
    // Counts changes of joints, and of the masses of jointed bodies. Data that steps derive from joints are valid for
    // one value of it. Snapshots do not contain it.
    std::uint64_t changes = 0;
};

} // namespace cairn
