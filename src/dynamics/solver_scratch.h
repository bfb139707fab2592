// Working memory of a step. Buffers keep their capacity, so that a steady step allocates nothing.
#pragma once

#include "collision/manifold.h"
#include "kernels/solver_data.h"
#include "math/vec.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cairn {

// Pairs of one kind, waiting for their kernel.
struct PairBatch {
    static constexpr int capacity = 256;
    std::uint32_t first[capacity], second[capacity], contact[capacity];
    float margin[capacity];
    int count = 0;
};

struct NarrowScratch {
    std::vector<PairBatch> batches; // one per PairKind
    std::vector<Manifold> manifolds;
    std::vector<std::int32_t> whirling; // bodies that turn far in a step and have unequal moments of inertia
    std::vector<std::uint32_t> skipped; // contacts of sleeping bodies with kinematic ones at rest
};

// A run of blocks of one color and one size in a bin.
struct BlockRun {
    bool four_points;
    std::int32_t first, count;
};

// A contact to be solved, sorted by bin, color and size.
struct SortedContact {
    std::uint32_t id;
    std::int32_t body_a, body_b; // B: none if it does not move at all
    std::uint8_t color, four_points;
    std::uint8_t padding[2] = {};
};

// One solver bin: islands that are solved together through all substeps.
struct Bin {
    std::int32_t first_island = 0, island_count = 0; // in SolverScratch::bin_islands
    std::int32_t substeps = 0;
    std::int32_t body_count = 0, contact_count = 0;
    std::int32_t first_contact = 0; // in SolverScratch::sorted
    bool bounces = false;           // any of its contacts has restitution
};

// A row with unequal moments of inertia that the wide kernel does not turn, and where its free motion ends.
struct SpinningRow {
    std::int32_t row;
    bool turns = false;
    math::DQuat end;
    math::DVec3 free_w;
};

// Lanes of a list of blocks, filled bin by bin.
struct LaneLists {
    std::vector<std::int32_t> record, row_a, row_b;
    void clear() { record.clear(), row_a.clear(), row_b.clear(); }
};

struct SolverScratch {
    std::vector<Bin> bins;
    std::vector<std::int32_t> bin_of_island, bin_islands, contacts_of_island, open_bins;
    std::vector<std::uint32_t> key_counts, keys; // counting sort of contacts
    std::vector<SortedContact> sorted;
    std::vector<ContactReport> reports;    // by contact, of those that were solved
    std::vector<std::int32_t> row_of_body; // in the bin at work; none: in no row
    // --- of the bin at work
    std::vector<std::int32_t> free_bodies; // of all bins: those without a contact
    std::vector<std::int32_t> row_bodies;  // body of each row; none for fixed, discard and padding
    std::vector<SpinningRow> spinning_rows;
    std::vector<SpinBlock> spin_blocks; // those that the kernel turns
    std::size_t spin_count = 0;         // lanes in them
    std::vector<SolverVelocity> velocity, reference, rounding;
    std::vector<SolverPose> pose;
    std::vector<SolverInertia> inertia;
    std::vector<SolverTwist> drive, damping, correction, free_correction;
    LaneLists one_lanes, four_lanes;
    std::vector<ContactBlock<1>> one_blocks;
    std::vector<ContactBlock<4>> four_blocks;
    std::vector<BlockRun> runs;
    bool drive_varies = false; // forces depend on the position
};

} // namespace cairn
