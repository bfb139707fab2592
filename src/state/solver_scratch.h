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

inline constexpr std::size_t joints_ahead = 4; // so many before one is looked at, the cache is asked for it

// Blocks of one size, side by side.
struct BlockRun {
    bool four_points;
    std::int32_t first, count;
};
// The blocks of one color in a batch.
struct ColorRun {
    BlockRun four_points, one_point;
};

// Contacts by their keys (solver/contact_order.h).
inline constexpr std::size_t keys_per_batch = 256;

// A contact to be solved.
struct SortedContact {
    std::uint32_t id;
    std::int32_t body_a, body_b; // B: none if it does not move at all
    std::int32_t island;
    std::uint8_t key; // color, whether it bore anything in the last step, one point or four (solver/contact_order.h)
    std::uint8_t bounces, is_conveyor;
    std::uint8_t begins; // it has borne nothing yet
};

// Islands of which the loads are told by the weights (solver/standing_loads.h), one after the other.
struct StandingContact {
    std::uint32_t id;
    std::int32_t a, b; // bodies; B: none if it does not move by forces
    bool begins;
    float bore; // N: in the last step
};
struct StandingLoads {
    std::vector<StandingContact> contacts;
    std::vector<std::int32_t> end_of_island; // in `contacts`, of awake islands; none: it is no such island
    struct Body {
        float own, weight;           // N: its weight, and with what stands on it
        std::int32_t depth;          // contacts between it and what does not move; none: not known yet
        std::uint32_t first_contact; // of it, in contacts_of_body
    };
    std::vector<Body> bodies;                    // of one island, and one more
    std::vector<std::int32_t> place_of;          // by body: its place among those
    std::vector<std::uint32_t> contacts_of_body; // their places, those of a body side by side
    std::vector<std::int32_t> from_below;        // bodies in the order of their depths
};

// One solver batch: islands that are solved together through all substeps.
struct IslandBatch {
    std::int32_t first_island = 0, island_count = 0; // in SolverScratch::batch_islands
    std::int32_t substeps = 0;
    std::int32_t body_count = 0, contact_count = 0, joint_count = 0;
    std::int32_t first_contact = 0; // in SolverScratch::of_batches and sorted
    bool bounces = false;           // any of its contacts has restitution
};

// A row with unequal moments of inertia that the wide kernel does not turn, and where its free motion ends.
struct SpinningRow {
    std::int32_t row;
    bool turns = false;
    math::DQuat end;
    math::DVec3 free_w;
};

// A row of one contact alone: B as its moving surface has it.
struct ConveyorRow {
    std::int32_t row;
    std::uint32_t contact;
};

// How far bodies reach in each direction, by sums over them: of masses, places x, m x, weights as vectors, squares of
// places, and the second moments of their mass, m^2, along the axes of each in which they are least and greatest.
struct Extent {
    double count = 0, mass = 0;
    math::DVec3 sum, moment, pull;
    math::DSym3 squares;
    double least = 0, greatest = 0;
};

// An island as a column, and what holds it from its sides: sums over contacts with what does not move.
struct StandingColumn {
    std::int32_t island = none;
    Extent extent;
    math::DSym3 own; // m^2: second moments of its bodies, in the mean
    math::DVec3 origin, up;
    double bottom = 0; // m: from the origin, upward
    struct {
        math::DSym3 squares; // of z n
        math::DVec3 normals; // z^2 n
        double weight = 0;   // z^2
    } sides;
};
// Of islands that may be slender.
struct StandingColumns {
    std::vector<StandingColumn> all;
    std::vector<std::int32_t> of_island; // none: it has none
    std::vector<ContactNormal> sides;    // contacts that may hold them
};

// The mass of bodies, kg, their weight, N, the sum of m v and that of m v^2.
struct MotionSum {
    double mass = 0, weight = 0, energy = 0;
    math::DVec3 momentum;
    Extent extent;
};

// What a thread gathers from bodies that have moved.
struct FinalizeScratch {
    std::vector<NewBounds> escaped;    // shapes that have left their fat boxes
    std::vector<std::int32_t> fast;    // bodies that moved farther than their cores may (impacts/resolve_impacts.h)
    std::vector<std::int32_t> strayed; // of these, bodies that are not where the broad phase expected them
};

// Lanes of a list of blocks, filled batch by batch.
struct LaneLists {
    std::vector<std::int32_t> record, row_a, row_b;
};

// Rows of joints, those of one joint side by side. They are solved by color, phase and form, their key
// (joint_layout.cpp).
enum class JointRowType : std::uint8_t { point, turn, axis };
inline constexpr int joint_row_types = 3;
struct JointRow {
    std::uint32_t joint = 0;
    std::uint32_t lane = 0; // among those of its type
    std::uint16_t key = 0;  // its number in JointLayout::keys
    JointRowType type = JointRowType::point;
    std::uint8_t axis : 3 = 0; // which of the joint's
    std::uint8_t has_limits : 1 = 0, has_drive : 1 = 0, has_friction : 1 = 0;
    std::uint8_t has_soft_limits : 1 = 0;
    std::uint8_t is_direct_limit : 1 = 0; // its limits are solved directly, the block has only where they are
    // Likewise its drive, its friction, and its soft limits or equation.
    std::uint8_t is_direct_drive : 1 = 0, is_direct_friction : 1 = 0, is_direct_range : 1 = 0;
    std::uint8_t is_direct : 1 = 0; // its joint is solved directly
    std::uint8_t idle : 1 = 0;      // mere limits, now out of reach: the row has no lane
    float reach_by_turn = 0;        // 0: never idle (joints/idle_limits.cpp)
};
// Blocks that may be solved side by side. The last one may hold lanes of runs that come later, too.
struct JointRun {
    JointRowType type;
    std::uint8_t empty_lanes; // of the last block, behind its own
    std::uint16_t key;
    std::uint32_t first, count;
    std::uint32_t first_lane; // of its first block
    std::int32_t part;        // its place among JointLayout::parts; none: it has all lanes of its blocks
};

// The blocks of a run, as the kernels of their type take them.
struct JointCall {
    JointRowType type;
    std::uint32_t block_size; // bytes
    JointBlocks run;
};

// How the joints of a batch lie in its blocks. It is kept from step to step: mostly nothing of it changes.
struct JointLayout {
    std::uint64_t valid_for = ~std::uint64_t(0); // Joints::changes
    std::vector<std::int32_t> bodies;            // of the batch, those that are touched
    std::vector<std::int32_t> kinematic_bodies;  // that joints name
    std::vector<std::uint32_t> joints;           // of the batch
    std::vector<std::uint32_t> first_row;        // of each of them, and one more: the end
    std::vector<JointRow> rows;
    std::vector<std::uint16_t> keys;                        // of all rows, idle or not: ascending
    bool may_idle = false;                                  // any of them
    bool only_points = true;                                // all are
    std::array<std::uint32_t, joint_row_types> blocks = {}; // how many, by JointRowType
    std::vector<JointRun> runs;
    std::vector<std::uint8_t> parts; // of runs that do not fill their last blocks: their lanes there, as bits
};

// What the free motion of a row's body asks for, besides falling.
enum RowTrait : std::uint8_t {
    is_dynamic_row = 1,
    falls_plainly = 2, // gravity alone, to its full extent
    is_damped = 4,
    spins_wide = 8, // unequal moments, turned by the kernel
    spins_alone = 16,
};

// The batch that a thread has at work.
struct BatchScratch {
    std::vector<std::int32_t> row_of_body;                  // none: in no row
    std::vector<std::int32_t> row_bodies;                   // body of each row; none for fixed and padding
    std::vector<std::uint64_t> row_marks;                   // to sort them
    std::vector<std::uint8_t> row_traits;                   // RowTrait
    std::vector<std::int32_t> members;                      // of the islands
    std::vector<std::int32_t> touching_bodies, free_bodies; // of these: with and without a contact
    std::vector<MotionSum> sums;
    std::vector<ListPart> parts; // of lists that threads write together
    std::vector<ConveyorRow> conveyor_rows;
    std::vector<SpinningRow> spinning_rows;
    std::vector<SpinBlock> spin_blocks;  // those that the kernel turns
    std::vector<std::int32_t> spin_rows; // of their lanes
    std::vector<math::Vec3> held_turns;  // of spin_rows, then of spinning_rows: see hold_what_turns
    // Rows, then the discard rows: one for each block.
    std::vector<SolverVelocity> velocity, reference, rounding;
    std::vector<SolverPose> pose;
    std::vector<SolverInertia> inertia;
    std::vector<SolverTwist> drive, damping, correction, free_correction;
    std::vector<std::uint32_t> key_counts;   // by chunk of contacts and key
    std::vector<SortedContact> own_contacts; // of a batch that is cut
    LaneLists one_lanes, four_lanes;
    std::vector<ContactBlock<1>> one_blocks;
    std::vector<ContactBlock<4>> four_blocks;
    std::vector<ColorRun> colors;
    const JointLayout* joint_layout = nullptr;
    std::vector<std::uint32_t> joint_key_counts;
    std::vector<PointBlock> point_blocks;
    std::vector<TurnBlock> turn_blocks;
    std::vector<AxisBlock> axis_blocks;
    std::vector<PartLanes> part_lanes;  // as JointLayout::parts
    std::vector<JointCall> joint_calls; // for each run of the layout
    DirectWork direct;
    ImpactWork impact;
    bool drive_varies = false;    // forces depend on the position
    bool bounces = false;         // `correction` is another than `free_correction`
    RankBorder* border = nullptr; // of a batch that is cut; null: the batch is solved here alone

    FinalizeScratch finalized;             // of all batches of the thread
    std::vector<std::uint32_t> overloaded; // likewise: joints that break
    std::uint64_t clamped_speeds = 0;
    double prepare_ms = 0, solve_ms = 0;

    std::size_t row_count() const { return row_bodies.size(); }
    // Discard rows: of blocks of contacts with one point, with four, then of joints.
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

// The row of a body. Bodies get theirs when a contact or joint first names them, so that contacts side by side have
// rows side by side.
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
    std::vector<std::uint8_t> island_bounces; // 1: one of its contacts does
    std::vector<std::uint8_t> weighed_for;    // by island, bits: see standing_loads.h
    StandingColumns columns;
    StandingLoads standing;
    std::vector<std::uint32_t> batch_counts;       // by chunk of contacts and batch
    std::vector<SortedContact> of_batches, sorted; // by batch; as found, then by batch and key
    std::vector<std::uint32_t> key_ends;           // by batch and key: where its contacts end among the sorted
    std::vector<ContactReport> reports;            // by contact, of those that were solved
    std::vector<ContactReport> own_reports;        // by place of the record, where a rank has some records alone
    std::vector<JointLayout> joint_layouts;        // by batch
    std::vector<std::int32_t> shared, alone;       // batches that all threads solve together, and those that one does
    std::vector<BatchScratch> at_work;             // one per thread
    std::vector<NewBounds> escaped;
    std::vector<std::int32_t> fast;           // of all threads, in ascending order
    std::vector<std::int32_t> strayed;        // likewise
    std::vector<std::int32_t> member_numbers; // by body, while an island is split
    std::vector<std::uint32_t> overloaded;    // joints that break, in ascending order
    SweepScratch sweep;
    RankCut cut; // where there are several ranks
    RankBorder border;
    std::vector<std::byte> results;
    double prepare_share = 0; // of the last solve_batches' time
};

} // namespace cairn
