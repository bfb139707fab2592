// Working memory of the solver. Buffers keep their capacity, so that a steady step allocates nothing.
#pragma once

#include "collision/broad_phase.h"
#include "kernels/solve/joint_data.h"
#include "kernels/solve/solver_data.h"
#include "math/bounds.h"
#include "math/vec.h"
#include "state/contact_state.h"
#include "state/direct_work.h"
#include "state/impact_work.h"
#include "state/rank_work.h"
#include "state/sweep_scratch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace cairn {

// Prefetch distance in lists of joints.
inline constexpr std::size_t joints_ahead = 4;

// Consecutive blocks of one size.
struct BlockRun {
    bool four_points;
    std::int32_t first, count;
};
// The blocks of one color in a batch.
struct ColorRun {
    BlockRun four_points, one_point;
};

// The number of sort keys of the contacts of a batch (solver/contact_order.h).
inline constexpr std::size_t keys_per_batch = 512;

// A contact to be solved.
struct SortedContact {
    std::uint32_t id;
    std::int32_t body_a, body_b; // B: none if it does not move
    std::int32_t island;
    std::uint16_t key; // color, and what work the contact needs (solver/contact_order.h)
    std::uint16_t bounces : 1, is_conveyor : 1;
    std::uint16_t begins : 1; // it has carried no load yet
};

// Islands whose new contacts get their loads from the weights above them (solver/standing_loads.h), one at a time.
struct StandingContact {
    std::uint32_t id;
    std::int32_t a, b; // bodies, later their indices in StandingLoads::bodies; B: none if forces do not move it
    bool begins;
    float last_load; // N: load in the last step
};
struct StandingLoads {
    std::vector<StandingContact> contacts;
    std::vector<std::int32_t> end_of_island; // by awake island: end of its contacts; none: it has none of these
    struct Body {
        float own, weight;           // N: weight of the body, and with the bodies that it carries
        std::int32_t depth;          // contacts between it and a body that does not move; none: not known yet
        std::uint32_t first_contact; // of the body, in contacts_of_body
    };
    struct ContactOfBody {
        std::int32_t other;    // the body on the other side: index in `bodies`, or none
        std::uint32_t contact; // index in `contacts`
    };
    std::vector<Body> bodies;                    // of one island, and an end marker
    std::vector<std::int32_t> place_of;          // by body: index in `bodies`
    std::vector<ContactOfBody> contacts_of_body; // grouped by body
    std::vector<std::int32_t> from_below;        // bodies by increasing depth
};

// One solver batch: islands that are solved together through all substeps.
struct IslandBatch {
    std::int32_t first_island = 0, island_count = 0; // in SolverScratch::batch_islands
    std::int32_t substeps = 0;
    std::int32_t body_count = 0, contact_count = 0, joint_count = 0;
    std::int32_t first_contact = 0; // in SolverScratch::of_batches and sorted
    bool bounces = false;           // any of its contacts has restitution
};

// A solver body with unequal moments of inertia that the wide kernel does not rotate, and where its free motion ends.
struct SpinningRow {
    std::int32_t row;
    bool turns = false;
    math::DQuat end;
    math::DVec3 free_w;
};

// A solver body used by one contact only: body B with the velocity of its moving surface.
struct ConveyorRow {
    std::int32_t row;
    std::uint32_t contact;
};

// Sums over the bodies of an island that give its extent in each direction: of masses, positions x, m x, weights as
// vectors, squares of positions, and the second moments of each body's mass, m^2, along its axes in which they are
// least and greatest.
struct Extent {
    double count = 0, mass = 0;
    math::DVec3 sum, moment, pull;
    math::DSym3 squares;
    double least = 0, greatest = 0;
};

// An island as a column, and its support from the sides: sums over contacts with bodies that do not move.
struct StandingColumn {
    std::int32_t island = none;
    Extent extent;
    math::DSym3 own; // m^2: mean of the second moments of its bodies
    math::DVec3 origin, up;
    double bottom = 0; // m: height of its base above the origin
    struct {
        math::DSym3 squares; // sum of z^2 n n^T
        math::DVec3 normals; // sum of z^2 n
        double weight = 0;   // sum of z^2
    } sides;
};
// Columns of islands that may be slender.
struct StandingColumns {
    std::vector<StandingColumn> all;
    std::vector<std::int32_t> of_island; // by island; none: it has no column
    std::vector<ContactNormal> sides;    // contacts that may support columns from the sides
};

// Sums over bodies: mass, kg; weight, N; m v; and m v^2.
struct MotionSum {
    double mass = 0, weight = 0, energy = 0;
    math::DVec3 momentum;
    Extent extent;
};

// The lists that a thread gathers while it moves bodies.
struct FinalizeScratch {
    std::vector<NewBounds> escaped;    // shapes that have left their fat boxes
    std::vector<std::int32_t> fast;    // bodies whose cores may have passed others (impacts/resolve_impacts.h)
    std::vector<std::int32_t> strayed; // of `fast`: bodies outside of their predicted bounds in the broad phase
};

// The lanes of a list of blocks, filled batch by batch.
struct LaneLists {
    std::vector<std::int32_t> record, row_a, row_b;
};

// The rows of joints: those of one joint are consecutive. They are solved in the order of their keys, i.e. by color,
// phase and form (joint_layout.cpp).
enum class JointRowType : std::uint8_t { point, turn, axis };
inline constexpr int joint_row_types = 3;
struct JointRow {
    std::uint32_t joint = 0;
    std::uint32_t lane = 0; // among the lanes of its type
    std::uint16_t key = 0;  // index in JointLayout::keys
    JointRowType type = JointRowType::point;
    std::uint8_t axis : 3 = 0; // index of the joint's axis
    std::uint8_t has_limits : 1 = 0, has_drive : 1 = 0, has_friction : 1 = 0;
    std::uint8_t has_soft_limits : 1 = 0;
    // Its limits are solved directly; the block only provides their Jacobian and position.
    std::uint8_t is_direct_limit : 1 = 0;
    // The same for its drive, its friction, and its soft limits or equation.
    std::uint8_t is_direct_drive : 1 = 0, is_direct_friction : 1 = 0, is_direct_range : 1 = 0;
    std::uint8_t is_direct : 1 = 0; // its joint is solved directly
    std::uint8_t idle : 1 = 0;      // has only limits, which are out of reach: the row has no lane
    float reach_by_turn = 0;        // upper bound of d position / d angle; 0: never idle (joints/idle_limits.cpp)
};
// A run of blocks that may be solved in parallel. The last block may also have lanes of later runs.
struct JointRun {
    JointRowType type;
    std::uint8_t empty_lanes; // in the last block, behind the lanes of the run
    std::uint16_t key;
    std::uint32_t first, count;
    std::uint32_t first_lane; // the first lane of its first block
    std::int32_t part;        // index in JointLayout::parts; none: the run has all lanes of its blocks
};

// The blocks of a run, as arguments for the kernels of their type.
struct JointCall {
    JointRowType type;
    std::uint32_t block_size; // bytes
    JointBlocks run;
};

// How the joints of a batch are laid out in its blocks. It is kept between steps, as little of it changes.
struct JointLayout {
    std::uint64_t valid_for = ~std::uint64_t(0); // a value of Joints::changes
    std::vector<std::int32_t> bodies;            // bodies of the batch that have contacts or joints
    std::vector<std::int32_t> kinematic_bodies;  // kinematic bodies of the joints
    std::vector<std::uint32_t> joints;           // of the batch
    std::vector<std::uint32_t> first_row;        // of each joint, and the end of the last
    std::vector<JointRow> rows;
    std::vector<std::uint16_t> keys;                        // of all rows, idle or not, ascending
    bool may_idle = false;                                  // any row may be idle
    bool only_points = true;                                // all rows are of type `point`
    std::array<std::uint32_t, joint_row_types> blocks = {}; // numbers of blocks, by JointRowType
    std::vector<JointRun> runs;
    std::vector<std::uint8_t> parts; // for runs that do not fill their last blocks: a bit mask of their lanes there
};

// Properties of a solver body that its free motion depends on, besides falling.
enum RowTrait : std::uint8_t {
    is_dynamic_row = 1,
    falls_plainly = 2, // moved by gravity alone, with gravity_scale 1
    is_damped = 4,
    spins_wide = 8, // unequal moments of inertia, rotated by the wide kernel
    spins_alone = 16,
};

// The batch that a thread works on.
struct BatchScratch {
    std::vector<std::int32_t> row_of_body;                  // none: the body has no row
    std::vector<std::int32_t> row_bodies;                   // body of each row; none for the fixed row and padding
    std::vector<std::uint64_t> row_marks;                   // sort keys of rows
    std::vector<std::uint8_t> row_traits;                   // RowTrait
    std::vector<std::int32_t> members;                      // bodies of the islands
    std::vector<std::int32_t> touching_bodies, free_bodies; // of the members: with and without contacts or joints
    std::vector<MotionSum> sums;
    std::vector<ListPart> parts; // of lists that threads write together
    std::vector<ConveyorRow> conveyor_rows;
    std::vector<SpinningRow> spinning_rows;
    std::vector<SpinBlock> spin_blocks;  // bodies that the wide kernel rotates
    std::vector<std::int32_t> spin_rows; // rows of the lanes of spin_blocks
    std::vector<math::Vec3> held_turns;  // of spin_rows, then of spinning_rows: see use_midpoint_spin
    // By row, then the discard rows: one for each block.
    std::vector<SolverVelocity> velocity, reference, rounding;
    std::vector<SolverPose> pose;
    std::vector<SolverInertia> inertia;
    std::vector<SolverTwist> drive, damping, correction, free_correction;
    std::vector<std::uint32_t> key_counts;   // by chunk of contacts, and by key
    std::vector<SortedContact> own_contacts; // of a batch that is cut between ranks
    LaneLists one_lanes, four_lanes;
    std::vector<ContactBlock<1>> one_blocks;
    std::vector<ContactBlock<4>> four_blocks;
    std::vector<ColorRun> colors;
    const JointLayout* joint_layout = nullptr;
    std::vector<std::uint32_t> joint_key_counts;
    std::vector<PointBlock> point_blocks;
    std::vector<TurnBlock> turn_blocks;
    std::vector<AxisBlock> axis_blocks;
    std::vector<PartLanes> part_lanes;  // by index in JointLayout::parts
    std::vector<JointCall> joint_calls; // for each run of the layout
    DirectWork direct;
    ImpactWork impact;
    bool drive_varies = false;    // forces depend on the position
    bool bounces = false;         // `correction` differs from `free_correction`
    RankBorder* border = nullptr; // of a batch that is cut between ranks; null: this process solves the batch alone

    FinalizeScratch finalized;             // of all batches of the thread
    std::vector<std::uint32_t> overloaded; // joints that break, of all batches of the thread
    std::uint64_t clamped_speeds = 0;
    double prepare_ms = 0, solve_ms = 0;

    std::size_t row_count() const { return row_bodies.size(); }
    // Discard rows: first those of blocks of contacts with one point, then with four, then of joints.
    std::int32_t first_discard_row() const { return std::int32_t(row_bodies.size()); }
    std::array<std::int32_t, joint_row_types> first_joint_discard_rows() const { // by JointRowType
        const std::int32_t first =
            first_discard_row() + std::int32_t((one_lanes.record.size() + four_lanes.record.size()) / 8);
        const auto& count = joint_layout->blocks;
        return {first, first + std::int32_t(count[0]), first + std::int32_t(count[0] + count[1])};
    }
    std::size_t block_count() const {
        std::size_t blocks = (one_lanes.record.size() + four_lanes.record.size()) / 8;
        for (const std::uint32_t count : joint_layout->blocks) blocks += count;
        return blocks;
    }
};

// Returns the row of a body. Dynamic bodies with contacts or joints have one, by their indices (number_rows in
// solver/batch_rows.cpp); other bodies get one when a contact or joint first names them.
inline std::int32_t row_of_body(BatchScratch& scratch, std::int32_t body) {
    std::int32_t& row = scratch.row_of_body[body];
    if (row < 0) {
        row = std::int32_t(scratch.row_bodies.size());
        scratch.row_bodies.push_back(body);
    }
    return row;
}

struct SolverScratch {
    std::vector<IslandBatch> batches;
    std::vector<std::int32_t> batch_of_island, batch_islands, open_batches;
    std::vector<std::int32_t> contacts_of_island;
    std::vector<std::uint8_t> island_bounces; // 1: one of its contacts has restitution
    std::vector<std::uint8_t> weighed_for;    // by island: bits of WeighedFor (standing_loads.h)
    StandingColumns columns;
    StandingLoads standing;
    std::vector<std::uint32_t> batch_counts;       // by chunk of contacts, and by batch
    std::vector<SortedContact> of_batches, sorted; // by batch; first in the order found, then by batch and key
    std::vector<std::uint32_t> key_ends;           // by batch and key: end of its contacts in `sorted`
    std::vector<ContactReport> reports;            // by contact, for solved contacts
    std::vector<ContactReport> own_reports;        // by place of the record, where a rank has only its own records
    std::vector<JointLayout> joint_layouts;        // by batch
    std::vector<std::int32_t> shared, alone;       // batches solved by all threads together, and by one each
    std::vector<BatchScratch> at_work;             // one per thread
    std::vector<NewBounds> escaped;
    std::vector<std::int32_t> fast;           // bodies of all threads, ascending
    std::vector<std::int32_t> strayed;        // bodies of all threads, ascending
    std::vector<std::int32_t> member_numbers; // by body: its number while its island is split
    std::vector<std::uint32_t> overloaded;    // joints that break, ascending
    SweepScratch sweep;
    RankCut cut; // with several ranks
    RankBorder border;
    std::vector<std::byte> results;
    double prepare_share = 0; // share of preparation in the time of the last solve_batches
};

} // namespace cairn
