// Working memory of the direct solver: the numerical values of the sets in one batch.
#pragma once

#include "math/block.h"

#include <cstdint>
#include <vector>

namespace cairn {

// A body of a set; first the values of the step, then those of the substep.
struct DirectBody {
    std::int32_t row = 0;
    bool by_forces = false;
    double inverse_mass = 0;
    math::DVec3 moments, inverse_moments; // about the principal axes
    math::DQuat axes0;                    // rotation of the principal axes at the start of the step
    math::DVec3 center;                   // displacement of the center of mass since then, m
    math::DQuat turn;                     // rotation since then
    math::DMat3 axes;                     // the principal axes now
    math::DVec3 stiffness;                // geometric stiffness x h^2: least moments about the principal axes, kg m^2
    bool is_tense() const {               // whether these exceed the body's own
        return stiffness.x > moments.x || stiffness.y > moments.y || stiffness.z > moments.z;
    }
    math::DSym3 inverse_inertia;
    math::DVec3 v, w;             // the velocities that move the pose
    math::DVec3 dv, dw;           // the changes of v and w by impulses
    math::DVec3 held_dv, held_dw; // copies of dv and dw while other impulses are tried
    math::Vec3 kept_v, kept_w;    // the saved velocity, while poses are integrated with that of the set
};

// A drive, friction or soft limit of an axis, with a bounded impulse p per substep. A damped spring fulfills v + p / g
// = pull / g with g = h (h k + d), which is implicit in time; a motor and friction fulfill v = pull.
struct DirectDrive {
    std::uint32_t lane = 0; // its lane in the axis blocks, which have the Jacobian and the position
    double stiffness = 0, damping = 0, target_position = 0, target_velocity = 0;
    double lower = 0, upper = 0;                  // bounds of a soft limit
    double least_position = 0, most_position = 0; // bounds of the rigid limits on its axis
    double least = 0, most = 0;                   // bounds of the impulse, N s or N m s
    bool is_rigid = false, is_relative = false;
    double compliance = 0, pull = 0; // 1 / g, pull / g
    int bound = 0; // -1, 1: the impulse is at its lower or upper bound, and the row is left out of the matrix
    double impulse = 0;
    double given = 0, held_given = 0; // see DirectRow
};

// Three constraint rows: c = L (v_B - v_A) + J_B w_B + J_A w_A is to be -rate x error.
struct DirectRow {
    math::DVec3 arm_a0, arm_b0, gap0; // from the centers of mass to the anchors; from A's anchor to B's
    math::DVec3 axis_a0, axis_b0;
    math::DQuat turn0;                   // rotation of frame B relative to frame A
    double at = 0;                       // of axis rows: the position to be held
    math::Block linear;                  // L
    math::Block angular[2], response[2]; // J, and J I^-1
    math::DVec3 arm_a, arm_b;
    bool is_plain = false; // L is the identity matrix
    math::DVec3 diagonal;  // diagonal of the rows' matrix before elimination
    math::DVec3 error, impulse;
    // Impulses added to `impulse` while velocities are solved for; their copies while others are tried.
    math::DVec3 given, held_given;
    math::DVec3 total; // N s or N m s on B, world axes, summed over all substeps
    DirectDrive drive;
    math::DVec3 axis; // of `turn` rows with a drive
};

// A rigid limit of a joint in a set. Its axis block has the Jacobian and the position.
struct DirectLimit {
    std::int32_t set = 0;
    std::uint32_t joint = 0, axis = 0;
    std::uint32_t lane = 0;        // its lane in the axis blocks
    std::int32_t body[2] = {0, 0}; // in DirectSet::bodies
    double bounds[2] = {0, 0};     // lower and upper
    double impulse[2] = {0, 0};    // of one substep, at the lower and the upper bound
    double kept[2] = {0, 0};       // copies of `impulse` while poses are integrated with other velocities
};

struct DirectSolve {
    std::int32_t set = 0;
    std::size_t first_body = 0, first_row = 0, first_block = 0;
    bool is_new = false;     // the impulses of some joint in the last substep are not known
    bool is_touched = false; // contacts act on some of its bodies
    std::size_t first_limit = 0, limit_count = 0;
};

// The lane of the axis row of a drive, friction or soft limit.
struct DriveLane {
    std::uint32_t joint, axis, lane; // `lane`: in the axis blocks
};

// Contacts of bodies of the sets: lanes of one contact block.
struct DirectContacts {
    std::int32_t block = 0; // in the blocks with four points, or in those with one
    bool four_points = false;
    std::uint8_t lanes = 0; // bits
};

struct DirectWork {
    std::vector<DirectSolve> sets;
    std::vector<DirectBody> bodies;
    std::vector<DirectRow> rows;
    std::vector<math::Block> diagonal, lower; // of the factorization; by node and by block
    std::vector<math::DVec3> sought;          // right-hand side and solution, by node
    std::vector<DirectLimit> limits;          // by set
    std::vector<DriveLane> drive_lanes;       // by joint and axis
    std::vector<DirectContacts> contacts;
    std::vector<std::uint8_t> is_touched_row; // by body row: a body of a set that is touched
};

} // namespace cairn
