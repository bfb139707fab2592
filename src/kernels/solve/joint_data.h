// What the joint kernels work on. Plain data, no functions. A joint is made of rows of three kinds: a point (three
// linear directions, or the two across an axis), a turn (three angular ones, or the two across an axis), and axes (one
// direction each, with limits, drive and friction). docs/joints.md derives them. The members of blocks are listed in
// block_fields.h, which fails to compile when one is missing.
#pragma once

#include "kernels/solve/solver_data.h"

namespace cairn {

// Softness of rigid rows for a substep of h seconds.
struct JointSoftness {
    float h, inverse_h;
    float scale; // of the rigid impulse
    float rate;  // 1/s: speed at which an error is taken back, before that scale
};

// The bodies of 8 rows: row offsets in bytes, and what they weigh. Blocks are read in every substep, in large islands
// from the third-level cache: what all of them use comes first.
struct JointEnds {
    std::uint32_t a[8], b[8];
    alignas(32) float mass_a[8];
    float mass_b[8], isotropic_a[8],
        isotropic_b[8]; // inverse; isotropic_*: moments of inertia, where all tensors are multiples of 1
};
// Where velocities go where that is not the row they came from: what does not move by forces has the discard row of the
// block. And tensors that are not multiples of 1, gathered anew in each substep.
struct JointEndsRest {
    std::uint32_t write_a[8], write_b[8];
    alignas(32) float inertia_a[6][8];
    float inertia_b[6][8];
};

// Anchors: arm_a and arm_b from the centers of mass, gap from that of A to that of B. *0: at the start of the step.
struct alignas(64) PointBlock : JointEnds {
    float arm_a[3][8], arm_b[3][8], gap[3][8];
    float impulse[3][8];              // on B
    float response[6][8];             // impulse per velocity: inverse of J M^-1 J^T, between the masks
    float left_a[3][8], left_b[3][8]; // angular velocity left for the next solve
    std::uint8_t free_axis, isotropic, redirects;
    std::uint8_t leaves;   // whether left_* hold anything
    std::uint8_t has_turn; // whether the joints have a turn as well
    // Used by relax only.
    alignas(64) float arm_a0[3][8], arm_b0[3][8], gap0[3][8];
    float total[3][8]; // impulse of all substeps
    // Used where tensors are anisotropic, or an axis is left free.
    JointEndsRest rest;
    float by_turn[9][8];     // has_turn: D of joint_locks.h
    float left_linear[3][8]; // free_axis: left for the next solve, change of the impulse
    float axis0[3][8];       // free_axis: the direction that is left free, turns with A
    float turn_axis0[3][8];  // has_turn: the axis about which the joint may turn, turns with A; 0: none
};

struct alignas(64) TurnBlock : JointEnds {
    float error[3][8]; // rotation vector that B has turned too far, across the free axis if there is one
    float response[6][8];
    float impulse[3][8];
    float left_a[3][8], left_b[3][8];   // angular velocity left for the next solve
    float turn0[4][8];                  // of B's frame against A's, in world axes: x y z w
    float axis_a0[3][8], axis_b0[3][8]; // free_axis: as each body holds it
    float total[3][8];
    std::uint8_t free_axis, isotropic, redirects;
    std::uint8_t leaves; // whether left_* hold anything
    JointEndsRest rest;
};

// What the position of an axis row is.
enum class AxisKind : std::uint8_t {
    linear,        // m along A's axis
    radial,        // m from A's axis
    distance,      // m between the anchors
    twist,         // rad about A's axis
    swing,         // rad between A's axis and B's
    turn,          // rad of the whole rotation of B against A
    rotation,      // rad: the part about A's axis of the rotation vector
    perpendicular, // cosine of the angle between A's axis and B's
    cross_a,       // rad about A's axis, where B's axis is at a right angle to it: of a cross joint
    cross_b,       // rad about B's axis, likewise
    gear,          // ratio_a x angle of A + ratio_b x angle of B, each about its own axis
    rack,          // ratio_a x angle of A + ratio_b x way of B along its axis
    pulley,        // ratio_a x length at A + ratio_b x length at B
};

inline constexpr float unlimited = 1e20f;

struct alignas(64) AxisBlock : JointEnds {
    // The Jacobian.
    float linear_a[3][8], linear_b[3][8], angular_a[3][8], angular_b[3][8];
    float left[4][3][8]; // of v_A, w_A, v_B, w_B, for the next solve
    float mass[8];       // 1 / (J M^-1 J^T); 0 where nothing gives
    float moved_mass[8]; // the mass that the joint moves along the row, with what it holds
    float position[8];
    float before[8]; // the position before the poses of this substep

    // Limits. `rigid_limit` is 1 where they are rigid: softness is that of all joints; else a damped spring of
    // limit_stiffness and limit_damping. An equation has lower = upper and `equation` 1.
    float lower[8], upper[8], equation[8], rigid_limit[8], limit_stiffness[8], limit_damping[8], limit_relative[8];
    float lower_impulse[8], upper_impulse[8];

    // The drive: a spring towards target_position and target_velocity, or where `rigid_drive` is 1 a motor that holds
    // target_velocity; within max_drive (N s a substep). *_relative is 1 where stiffness and damping are per unit of
    // the row's mass.
    float drive_stiffness[8], drive_damping[8], target_position[8], target_velocity[8], rigid_drive[8],
        drive_relative[8], max_drive[8], drive_impulse[8];
    float drive_pull[8]; // N s: stiffness and damping times the errors at the start of the substep

    float max_friction[8], friction_impulse[8]; // N s a substep
    float total[8];

    float arm_a0[3][8], arm_b0[3][8], gap0[3][8], turn0[4][8], axis_a0[3][8], axis_b0[3][8];
    float ratio_a[8], ratio_b[8], position0[8];
    float point_axis0[3][8], turn_axis0[3][8]; // the axes that the joint's point and turn leave free; 0: none
    std::uint8_t points, turns;                // lanes, as bits: whose joints have a point, a turn
    std::uint8_t plain_locks;                  // whether none of them has a turn, and none of their points a free axis
    std::uint8_t direct;                       // lanes of joints that are solved directly: J is that of the row alone
    AxisKind kind;
    std::uint8_t isotropic, redirects, leaves, has_limits, has_soft_limits, has_drive, has_friction;
    JointEndsRest rest;
};

// What an impact gives to the limits of an axis block; of the others, which lanes take part.
struct alignas(64) JointImpact {
    float lower[8], upper[8];
    std::uint8_t active; // lanes, as bits
};

// Blocks that are solved side by side: PointBlock, TurnBlock or AxisBlock. Rows of one form that are solved one after
// the other may lie in one block, as what is found from the poses alone is found for all of its lanes at once: when the
// first of them is solved.
struct PartLanes {
    std::uint8_t lanes;             // as bits: those to be solved
    std::uint32_t to_a[8], to_b[8]; // offsets of where velocities go; of other lanes to the discard row of the block
};
struct JointBlocks {
    void* blocks;
    int count;
    const PartLanes* part; // of the last block; null: all of its lanes are to be solved
};

struct JointKernels {
    struct ForRows {
        // At the start of a step, after the free motion of its first substep: Jacobians, and the impulses of the last
        // step.
        void (*warm_start)(const JointBlocks& run, const SolverBodies& bodies, const JointSoftness& softness);
        void (*solve)(const JointBlocks& run, SolverVelocity* velocity, const JointSoftness& softness);
        void (*relax)(const JointBlocks& run, const SolverBodies& bodies, const JointSoftness& softness);
        // One pass of an impact; the blocks argument is an array of one of the types.
        void (*strike)(void* blocks, JointImpact* impacts, int count, SolverVelocity* velocity, float inverse_h);
    } point, turn, axis;
};

} // namespace cairn
