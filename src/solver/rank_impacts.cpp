#include "solver/rank_impacts.h"

#include "solver/impact_blocks.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <type_traits>

namespace cairn {

namespace {

using Bytes = std::vector<std::byte>;

// Gathers the data of all ranks on all ranks, indexed by rank.
std::vector<Bytes> gather(Communicator& ranks, Bytes own) {
    std::vector<Bytes> all(std::size_t(ranks.size()));
    for (int root = 0; root < ranks.size(); ++root) {
        Bytes& bytes = all[std::size_t(root)];
        if (root == ranks.rank()) bytes.swap(own);
        std::uint64_t size = bytes.size();
        ranks.broadcast(root, std::as_writable_bytes(std::span(&size, 1)));
        bytes.resize(size);
        if (size > 0) ranks.broadcast(root, bytes);
    }
    return all;
}

template <class T> void append(Bytes& bytes, const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::size_t end = bytes.size();
    bytes.resize(end + sizeof(T));
    std::memcpy(bytes.data() + end, &value, sizeof(T));
}
template <class T> void take(const std::byte*& from, T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::memcpy(&value, from, sizeof(T));
    from += sizeof(T);
}

template <class T> void share(Communicator& ranks, std::vector<T>& values) {
    Bytes own(values.size() * sizeof(T));
    if (!own.empty()) std::memcpy(own.data(), values.data(), own.size());
    values.clear();
    for (const Bytes& bytes : gather(ranks, std::move(own))) {
        const std::byte* from = bytes.data();
        while (from != bytes.data() + bytes.size()) take(from, values.emplace_back());
    }
}

// Data sent along with a block, whose row numbers are valid on this rank only.
struct SharedLanes {
    int type;                          // of the block's run
    std::uint32_t listed;              // index of the run in ImpactWork::listed_runs
    std::int32_t body_a[8], body_b[8]; // none: forces do not move the body, or the lane is empty
    std::uint32_t source[8];
    SolverVelocity velocity_a[8], velocity_b[8];
    std::uint8_t active;
};

template <class Block, class Impact>
void append_block(const BatchScratch& scratch, const ImpactRun& run, std::size_t block,
                  const ImpactBlocks<Block, Impact>& in_impact, Bytes& bytes) {
    const Block& b = in_impact.blocks[block];
    SharedLanes lanes = {};
    lanes.type = run.type, lanes.listed = run.listed;
    lanes.active = in_impact.impacts[block].active;
    for (std::size_t i = 0; i < 8; ++i) {
        lanes.body_a[i] = lanes.body_b[i] = none;
        if ((lanes.active >> i & 1) == 0) continue;
        const std::size_t row_a = b.a[i] / row_bytes, row_b = b.b[i] / row_bytes;
        lanes.body_a[i] = scratch.row_bodies[row_a];
        if (scratch.impact.component[row_b] != fixed_row) lanes.body_b[i] = scratch.row_bodies[row_b];
        lanes.source[i] = in_impact.lanes[8 * block + i].source;
        lanes.velocity_a[i] = scratch.velocity[row_a];
        lanes.velocity_b[i] = scratch.velocity[row_b];
    }
    append(bytes, lanes);
    append(bytes, b);
}

// A block of any rank with its lane data; sorted by run.
struct SharedBlock {
    SharedLanes lanes;
    const std::byte* bytes; // the block itself
    bool is_own;
};

std::size_t size_of_block(int type) {
    return type == four_points_type ? sizeof(ContactBlock<4>) : sizeof(ContactBlock<1>);
}

std::vector<SharedBlock> read_blocks(const std::vector<Bytes>& all, int rank) {
    std::vector<SharedBlock> blocks;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const std::byte* from = all[k].data();
        while (from != all[k].data() + all[k].size()) {
            SharedBlock& block = blocks.emplace_back();
            take(from, block.lanes);
            block.bytes = from;
            block.is_own = int(k) == rank;
            from += size_of_block(block.lanes.type);
        }
    }
    std::stable_sort(blocks.begin(), blocks.end(),
                     [](const SharedBlock& a, const SharedBlock& b) { return a.lanes.listed < b.lanes.listed; });
    return blocks;
}

void number_bodies(const std::vector<SharedBlock>& blocks, ImpactWork::Shared& shared) {
    shared.bodies.clear();
    for (const SharedBlock& block : blocks)
        for (const auto& bodies : {block.lanes.body_a, block.lanes.body_b})
            shared.bodies.insert(shared.bodies.end(), bodies, bodies + 8);
    std::sort(shared.bodies.begin(), shared.bodies.end());
    shared.bodies.erase(std::unique(shared.bodies.begin(), shared.bodies.end()), shared.bodies.end());
    std::erase(shared.bodies, none);
    shared.velocity.assign(shared.bodies.size(), {});
}

// Sets for each lane the rows of both bodies, the row that B's velocity is written to, and the group of both bodies.
template <class Block, class Impact>
void take_block(const SharedBlock& from, ImpactWork& work, ImpactBlocks<Block, Impact>& to) {
    ImpactWork::Shared& shared = work.shared;
    const auto new_row = [&](const SolverVelocity& velocity) {
        shared.velocity.push_back(velocity);
        return std::uint32_t(shared.velocity.size() - 1);
    };
    Block& b = to.blocks.emplace_back();
    std::memcpy(static_cast<void*>(&b), from.bytes, sizeof(Block));
    to.impacts.push_back({});
    to.impacts.back().active = from.lanes.active;
    const std::uint32_t discard = new_row({});
    for (std::size_t i = 0; i < 8; ++i) {
        to.lanes.push_back({from.lanes.source[i], none, from.is_own});
        std::uint32_t a = discard, other = discard, write_b = discard;
        if ((from.lanes.active >> i & 1) != 0) {
            a = std::uint32_t(row_of_shared(shared, from.lanes.body_a[i]));
            shared.velocity[a] = from.lanes.velocity_a[i];
            to.lanes.back().group = std::int32_t(a); // for now, a row of the group
            if (from.lanes.body_b[i] == none) {
                other = new_row(from.lanes.velocity_b[i]);
            } else {
                write_b = other = std::uint32_t(row_of_shared(shared, from.lanes.body_b[i]));
                shared.velocity[other] = from.lanes.velocity_b[i];
            }
        }
        b.a[i] = a * row_bytes, b.b[i] = other * row_bytes, b.write_b[i] = write_b * row_bytes;
    }
}

template <class F> void for_contact_types(ImpactWork& work, F&& f) {
    f(std::get<one_point_type>(work.blocks));
    f(std::get<four_points_type>(work.blocks));
}

void find_shared_groups(ImpactWork& work) {
    const std::size_t count = work.shared.bodies.size();
    std::vector<std::int32_t> parent(count);
    std::vector<std::int32_t>& place = work.shared.groups;
    place.assign(count, none);
    std::iota(parent.begin(), parent.end(), 0);
    for_contact_types(work, [&](auto& in_impact) {
        for (std::size_t i = 0; i < in_impact.lanes.size(); ++i) {
            const std::size_t b = in_impact.blocks[i / 8].write_b[i % 8] / row_bytes;
            if (in_impact.lanes[i].group != none && b < count) unite(parent, in_impact.lanes[i].group, std::int32_t(b));
        }
    });
    work.rows.resize(count);
    std::iota(work.rows.begin(), work.rows.end(), 0);
    work.groups.clear();
    for (const std::int32_t row : work.rows) {
        const std::int32_t root = root_of(parent, row);
        if (place[root] == none) {
            place[root] = std::int32_t(work.groups.size());
            work.groups.push_back({0, 0, false, false});
        }
        place[row] = place[root];
    }
    group_by_part(work.groups, work.rows, work.sorted_rows, [&](std::int32_t row) { return place[row]; });
    for_contact_types(work, [&](auto& in_impact) {
        for (auto& lane : in_impact.lanes)
            if (lane.group != none) lane.group = place[lane.group];
    });
    work.before.clear();
    for (const std::int32_t row : work.rows) work.before.push_back(work.shared.velocity[std::size_t(row)]);
    work.last = work.before;
}

} // namespace

void share_hits(Communicator& ranks, std::vector<ImpactWork::Hit>& hits) { share(ranks, hits); }
void share_bodies(Communicator& ranks, std::vector<std::int32_t>& bodies) { share(ranks, bodies); }

void share_impact(BatchScratch& scratch, Communicator& ranks) {
    ImpactWork& work = scratch.impact;
    Bytes own;
    for (const ImpactRun& run : work.runs)
        for (std::size_t k = run.first; k < run.first + run.count; ++k)
            if (run.type == four_points_type)
                append_block(scratch, run, k, std::get<four_points_type>(work.blocks), own);
            else
                append_block(scratch, run, k, std::get<one_point_type>(work.blocks), own);
    const std::vector<Bytes> all = gather(ranks, std::move(own));
    const std::vector<SharedBlock> blocks = read_blocks(all, ranks.rank());
    for (const std::int32_t row : work.rows) work.group[row] = none;
    work.runs.clear();
    for_contact_types(work, [](auto& in_impact) { in_impact.clear(); });
    number_bodies(blocks, work.shared);
    for (const SharedBlock& block : blocks) {
        const auto take_one = [&](auto& to) {
            const std::uint32_t place = std::uint32_t(to.blocks.size());
            take_block(block, work, to);
            if (work.runs.empty() || work.runs.back().listed != block.lanes.listed)
                work.runs.push_back({block.lanes.type, block.lanes.listed, place, 0});
            ++work.runs.back().count;
        };
        if (block.lanes.type == four_points_type)
            take_one(std::get<four_points_type>(work.blocks));
        else
            take_one(std::get<one_point_type>(work.blocks));
    }
    find_shared_groups(work);
    const auto is_needed = [&](std::int32_t row) {
        return scratch.row_of_body[work.shared.bodies[std::size_t(row)]] != none;
    };
    for (ImpactWork::Group& group : work.groups) {
        const auto begin = work.rows.begin();
        group.is_settled =
            std::none_of(begin + std::ptrdiff_t(group.begin), begin + std::ptrdiff_t(group.end), is_needed);
    }
}

void return_shared_velocities(BatchScratch& scratch) {
    ImpactWork& work = scratch.impact;
    const ImpactWork::Shared& shared = work.shared;
    std::size_t kept = 0;
    for (ImpactWork::Group& group : work.groups) {
        const std::size_t begin = kept;
        for (std::size_t i = group.begin; i < group.end; ++i) {
            const std::int32_t row = scratch.row_of_body[shared.bodies[std::size_t(work.rows[i])]];
            if (row == none) continue; // the body is not needed on this rank
            scratch.velocity[std::size_t(row)] = shared.velocity[std::size_t(work.rows[i])];
            work.place_of[row] = std::int32_t(&group - work.groups.data());
            work.before[kept] = work.before[i];
            work.rows[kept++] = row;
        }
        group.begin = begin, group.end = kept;
    }
    work.rows.resize(kept);
    work.before.resize(kept);
}

} // namespace cairn
