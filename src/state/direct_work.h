// Working memory of the direct solver: the numbers of the sets in one batch.
#pragma once

#include "math/block.h"

#include <cstdint>
#include <vector>

namespace cairn {

// A body of a set: what is of the step, and what is of the substep.
struct DirectBody {
    std::int32_t row = 0;
    bool by_forces = false;
    double inverse_mass = 0;
    math::DVec3 moments, inverse_moments; // principal
    math::DQuat axes0;                    // principal axes at the start of the step
    math::DVec3 center;                   // how far the center of mass has moved since
    math::DQuat turn;                     // and the body turned
    math::DMat3 axes;                     // principal axes now
    math::DVec3 stiffness;                // geometric: least moments about the principal axes, kg m^2
    math::DSym3 inverse_inertia;
    math::DVec3 v, w;             // by which the pose moves
    math::DVec3 dv, dw;           // what the impulses add
    math::DVec3 held_dv, held_dw; // likewise, while other impulses are tried
    math::Vec3 kept_v, kept_w;    // the velocity while poses are integrated with another
};

// A drive, friction or a soft limit of an axis, which gives the impulse p in a substep, within bounds: a damped spring
// has v + p / g = pull / g with g = h (h k + d), so that it acts at the end of the substep; a motor and friction have
// v = pull.
struct DirectDrive {
    std::uint32_t lane = 0; // of the axis blocks, which have the Jacobian and the position
    double stiffness = 0, damping = 0, target_position = 0, target_velocity = 0;
    double lower = 0, upper = 0;                  // of a soft limit
    double least_position = 0, most_position = 0; // of the rigid limits on its axis
    double least = 0, most = 0;                   // N s or N m s
    bool is_rigid = false, is_relative = false;
    double compliance = 0, pull = 0; // 1 / g, pull / g
    int bound = 0;                   // -1, 1: it gives the least or the most that it can; the row takes no part
    double impulse = 0;
    double given = 0, held_given = 0; // as of DirectRow
};

// Three rows: c = L (v_B - v_A) + J_B w_B + J_A w_A is to be -rate x error.
struct DirectRow {
    math::DVec3 arm_a0, arm_b0, gap0; // from the centers of mass to the anchors, and from A's to B's
    math::DVec3 axis_a0, axis_b0;
    math::DQuat turn0;                   // of frame B against A
    double at = 0;                       // axis rows: the position that is held
    math::Block linear;                  // L
    math::Block angular[2], response[2]; // J, and J I^-1
    math::DVec3 arm_a, arm_b;
    bool is_plain = false; // L is the unit matrix
    math::DVec3 diagonal;  // of the rows' matrix, before the elimination
    math::DVec3 error, impulse;
    math::DVec3 given, held_given; // beside that, while velocities are sought, and while others are tried
    math::DVec3 total;             // N s or N m s on B, world axes, over all substeps
    DirectDrive drive;
    math::DVec3 axis; // of a turn that is driven
};

// A rigid limit of a joint in a set. Its axis block has Jacobian and position.
struct DirectLimit {
    std::int32_t set = 0;
    std::uint32_t joint = 0, axis = 0;
    std::uint32_t lane = 0;        // of the axis blocks
    std::int32_t body[2] = {0, 0}; // in DirectSet::bodies
    double bounds[2] = {0, 0};     // lower and upper
    double impulse[2] = {0, 0};    // of one substep, away from each
    double kept[2] = {0, 0};       // likewise, while poses are integrated with another
};

struct DirectSolve {
    std::int32_t set = 0;
    std::size_t first_body = 0, first_row = 0, first_block = 0;
    bool is_new = false;     // of some joint it is not known what it gave in the last substep
    bool is_touched = false; // contacts push some of its bodies
    std::size_t first_limit = 0, limit_count = 0;
};

// Where the axis row of one of these lies.
struct DriveLane {
    std::uint32_t joint, axis, lane; // of the axis blocks
};

struct DirectWork {
    std::vector<DirectSolve> sets;
    std::vector<DirectBody> bodies;
    std::vector<DirectRow> rows;
    std::vector<math::Block> diagonal, lower; // of the factor; by node and by block
    std::vector<math::DVec3> sought;          // by node
    std::vector<DirectLimit> limits;          // by set
    std::vector<DriveLane> drive_lanes;       // by joint and axis
};

} // namespace cairn
