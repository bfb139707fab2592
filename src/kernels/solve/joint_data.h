// Data of the joint kernels. Plain data, no functions. A joint consists of constraint rows of three kinds: a point
// (three linear directions, or the two perpendicular to an axis), a turn (three angular directions, or the two
// perpendicular to an axis), and axes (one direction each, with limits, drive and friction). docs/joints.md derives
// them. The members of blocks are listed in block_fields.h, which fails to compile when one is missing.
#pragma once

#include "kernels/solve/solver_data.h"

namespace cairn {

// Softness of rigid rows for a substep of h seconds.
struct JointSoftness {
    float h, inverse_h;
    float scale; // factor on the rigid impulse
    float rate;  // 1/s: correction speed per unit of error, before `scale`
};

// The bodies of 8 joints: byte offsets of their rows, and inverse masses. Blocks are read in every substep, in large
// islands from the third-level cache: the data that all blocks use comes first.
struct JointEnds {
    std::uint32_t a[8], b[8];
    alignas(32) float mass_a[8];
    float mass_b[8], isotropic_a[8],
        isotropic_b[8]; // inverse masses; isotropic_*: inverse moments of inertia, where all tensors are multiples of 1
};
// Rows that velocities are written to, if they differ from those that they are read from: a body that forces do not
// move has the discard row of the block. And inverse inertia tensors that are not multiples of 1, gathered again in
// each substep.
struct JointEndsRest {
    std::uint32_t write_a[8], write_b[8];
    alignas(32) float inertia_a[6][8];
    float inertia_b[6][8];
};

// Anchors: arm_a and arm_b are measured from the centers of mass, gap from A's anchor to B's. *0: at the start of the
// step.
struct alignas(64) PointBlock : JointEnds {
    float arm_a[3][8], arm_b[3][8], gap[3][8];
    float impulse[3][8];              // on B
    float response[6][8];             // impulse per velocity: inverse of J M^-1 J^T, zero along a free axis
    float left_a[3][8], left_b[3][8]; // changes of w_A and w_B, left for the next solve
    std::uint8_t free_axis, isotropic, redirects;
    std::uint8_t leaves;   // whether left_* are set
    std::uint8_t has_turn; // whether the joints also have a turn
    // Used by relax only.
    alignas(64) float arm_a0[3][8], arm_b0[3][8], gap0[3][8];
    float total[3][8]; // sum of the impulses of all substeps
    // Used where tensors are anisotropic, or an axis is left free.
    JointEndsRest rest;
    float by_turn[9][8];     // has_turn: D of joint_locks.h
    float left_linear[3][8]; // free_axis: change of the impulse, left for the next solve
    float axis0[3][8];       // free_axis: the free direction, which turns with A
    float turn_axis0[3][8];  // has_turn: the axis about which the joint is free to rotate, which turns with A; 0: none
};

struct alignas(64) TurnBlock : JointEnds {
    float error[3][8]; // excess rotation of B as a rotation vector, perpendicular to the free axis if there is one
    float response[6][8];
    float impulse[3][8];
    float left_a[3][8], left_b[3][8];   // changes of w_A and w_B, left for the next solve
    float turn0[4][8];                  // rotation of B's frame relative to A's, in world axes: x y z w
    float axis_a0[3][8], axis_b0[3][8]; // free_axis: the axis, as fixed in each body
    float total[3][8];
    std::uint8_t free_axis, isotropic, redirects;
    std::uint8_t leaves; // whether left_* are set
    JointEndsRest rest;
};

// The meaning and unit of the position of an axis row.
enum class AxisKind : std::uint8_t {
    linear,        // m along A's axis
    radial,        // m from A's axis
    distance,      // m between the anchors
    twist,         // rad about A's axis
    swing,         // rad between A's axis and B's
    turn,          // rad: angle of the whole rotation of B relative to A
    rotation,      // rad: component of the rotation vector along A's axis
    perpendicular, // cosine of the angle between A's axis and B's
    cross_a,       // rad about A's axis of a cross joint, whose axes are perpendicular
    cross_b,       // rad about B's axis of a cross joint
    gear,          // ratio_a x angle of A + ratio_b x angle of B, each about its own axis
    rack,          // ratio_a x angle of A + ratio_b x displacement of B along its axis
    pulley,        // ratio_a x length at A + ratio_b x length at B
};

inline constexpr float unlimited = 1e20f;

struct alignas(64) AxisBlock : JointEnds {
    // The Jacobian.
    float linear_a[3][8], linear_b[3][8], angular_a[3][8], angular_b[3][8];
    float left[4][3][8]; // changes of v_A, w_A, v_B, w_B, left for the next solve
    float mass[8];       // effective mass, 1 / (J M^-1 J^T); 0 where no body can move along the row
    float moved_mass[8]; // the effective mass along the row while the joint's point and turn hold
    float position[8];
    float before[8]; // the position before this substep's poses were integrated

    // Limits. `rigid_limit` is 1 where they are rigid, with the softness of all joints; else they are damped springs
    // with limit_stiffness and limit_damping. An equation has lower = upper and `equation` 1.
    float lower[8], upper[8], equation[8], rigid_limit[8], limit_stiffness[8], limit_damping[8], limit_relative[8];
    float lower_impulse[8], upper_impulse[8];

    // The drive: a spring toward target_position and target_velocity, or where `rigid_drive` is 1 a motor that keeps
    // target_velocity; limited to max_drive (N s per substep). *_relative is 1 where stiffness and damping are per unit
    // of the row's effective mass.
    float drive_stiffness[8], drive_damping[8], target_position[8], target_velocity[8], rigid_drive[8],
        drive_relative[8], max_drive[8], drive_impulse[8];
    float drive_pull[8]; // N s: h times (stiffness and damping times the errors at the start of the substep)

    float max_friction[8], friction_impulse[8]; // N s per substep
    float total[8];

    float arm_a0[3][8], arm_b0[3][8], gap0[3][8], turn0[4][8], axis_a0[3][8], axis_b0[3][8];
    float ratio_a[8], ratio_b[8], position0[8];
    float point_axis0[3][8], turn_axis0[3][8]; // the free axes of the joint's point and turn; 0: none
    std::uint8_t points, turns;                // lane bits: joints that have a point, a turn
    std::uint8_t plain_locks;                  // whether no joint of the block has a turn, and no point a free axis
    std::uint8_t direct;                       // lane bits: joints solved by the direct solver; their J is that of the
                                               // row alone
    AxisKind kind;
    std::uint8_t isotropic, redirects, leaves, has_limits, has_soft_limits, has_drive, has_friction;
    JointEndsRest rest;
};

// Impulses of an impact on the limits of an axis block; for other blocks only `active` is used.
struct alignas(64) JointImpact {
    float lower[8], upper[8];
    std::uint8_t active; // lane bits: joints that take part
};

// A run of blocks to be solved: PointBlock, TurnBlock or AxisBlock. Rows of one form that are solved one after the
// other may share its last block, so that quantities that depend on poses alone are computed for all lanes at once,
// when the first of them is solved.
struct PartLanes {
    std::uint8_t lanes;             // lane bits: lanes to be solved
    std::uint32_t to_a[8], to_b[8]; // byte offsets of the rows that velocities are written to; for other lanes that of
                                    // the block's discard row
};
struct JointBlocks {
    void* blocks;
    int count;
    const PartLanes* part; // lanes of the last block; null: all of its lanes are solved
};

struct JointKernels {
    struct ForRows {
        // At the start of a step, after the free motion of its first substep: computes Jacobians and applies the
        // impulses of the last step.
        void (*warm_start)(const JointBlocks& run, const SolverBodies& bodies, const JointSoftness& softness);
        void (*solve)(const JointBlocks& run, SolverVelocity* velocity, const JointSoftness& softness);
        void (*relax)(const JointBlocks& run, const SolverBodies& bodies, const JointSoftness& softness);
        // One pass of an impact. `blocks`: an array of the block type of these rows.
        void (*impact_pass)(void* blocks, JointImpact* impacts, int count, SolverVelocity* velocity, float inverse_h);
    } point, turn, axis;
};

} // namespace cairn
