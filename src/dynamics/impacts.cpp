#include "dynamics/impacts.h"

#include "dynamics/block_runs.h"
#include "dynamics/joints.h"

#include <cmath>

namespace cairn {

namespace {

constexpr int most_passes = 48;
// m/s, rad/s: an island whose bodies change by less in a pass has settled.
constexpr float settled_change = 0.005f, settled_spin = 0.02f;

std::int32_t island_of_row(const State& s, const BinScratch& scratch, std::int32_t row) {
    const std::int32_t body = scratch.row_bodies[std::size_t(row)];
    return body == none ? none : s.bodies[std::size_t(body)].island;
}

// By lane, for each type of joint rows; none where there is no joint.
void find_joint_islands(const State& s, BinScratch& scratch) {
    const JointLayout& layout = *scratch.joint_layout;
    for (std::size_t type = 0; type < joint_row_types; ++type)
        scratch.impact.joint_islands[type].assign(8 * std::size_t(layout.blocks[type]), none);
    for (const JointRow& row : layout.rows) {
        const std::int32_t owner = joint_owner(s, s.joints[row.joint]);
        const std::int32_t island = owner == none ? none : s.bodies[std::size_t(owner)].island;
        scratch.impact.joint_islands[std::size_t(row.type)][row.lane] = island;
    }
}

// Calls f(blocks, impacts, count, island of a lane) for each type of blocks.
template <class F> void for_block_types(const State& s, BinScratch& scratch, F&& f) {
    ImpactWork& work = scratch.impact;
    const auto contacts = [&](const LaneLists& lanes) {
        return [&](std::size_t lane) {
            return lanes.record[lane] == none ? none : island_of_row(s, scratch, lanes.row_a[lane]);
        };
    };
    const auto joints = [&](JointRowType type) {
        return [&, type](std::size_t lane) { return work.joint_islands[std::size_t(type)][lane]; };
    };
    const auto joint_impacts = [&](JointRowType type) -> std::vector<JointImpact>& {
        return work.joint_blocks[std::size_t(type)];
    };
    const auto joint_count = [&](JointRowType type) {
        return std::size_t(scratch.joint_layout->blocks[std::size_t(type)]);
    };
    f(scratch.one_blocks, work.one_blocks, scratch.one_lanes.record.size() / 8, contacts(scratch.one_lanes));
    f(scratch.four_blocks, work.four_blocks, scratch.four_lanes.record.size() / 8, contacts(scratch.four_lanes));
    f(scratch.point_blocks, joint_impacts(JointRowType::point), joint_count(JointRowType::point),
      joints(JointRowType::point));
    f(scratch.turn_blocks, joint_impacts(JointRowType::turn), joint_count(JointRowType::turn),
      joints(JointRowType::turn));
    f(scratch.axis_blocks, joint_impacts(JointRowType::axis), joint_count(JointRowType::axis),
      joints(JointRowType::axis));
}

// Joints cannot be struck.
template <class Block> std::uint8_t* struck_lanes(Block& block) {
    if constexpr (requires { block.struck; })
        return &block.struck;
    else
        return nullptr;
}

void mark_islands(const State& s, BinScratch& scratch) {
    ImpactWork& work = scratch.impact;
    if (work.islands.size() < s.islands.size()) work.islands.resize(s.islands.size(), ImpactWork::untouched);
    work.place_of.resize(work.islands.size());
    work.marked.clear();
    for_block_types(s, scratch, [&](auto& blocks, auto&, std::size_t count, auto&& island_of) {
        for (std::size_t k = 0; k < count; ++k) {
            std::uint8_t* const lanes = struck_lanes(blocks[k]);
            if (!lanes || !*lanes) continue;
            for (std::size_t i = 0; i < 8; ++i) {
                const std::int32_t island = (*lanes >> i) & 1 ? island_of(8 * k + i) : none;
                if (island == none || work.islands[std::size_t(island)] != ImpactWork::untouched) continue;
                work.islands[std::size_t(island)] = ImpactWork::struck;
                work.place_of[std::size_t(island)] = std::int32_t(work.marked.size());
                work.marked.push_back(island);
            }
            *lanes = 0;
        }
    });
}

// The lanes of the islands that are struck take part. `begins`: their impulses are zero.
void activate_lanes(const State& s, BinScratch& scratch, bool begins) {
    ImpactWork& work = scratch.impact;
    for_block_types(s, scratch, [&](auto&, auto& impacts, std::size_t count, auto&& island_of) {
        if (impacts.size() < count) impacts.resize(count);
        for (std::size_t k = 0; k < count; ++k) {
            if (!begins && !impacts[k].active) continue;
            unsigned active = 0;
            for (std::size_t i = 0; i < 8; ++i) {
                const std::int32_t island = island_of(8 * k + i);
                if (island != none && work.islands[std::size_t(island)] == ImpactWork::struck) active |= 1u << i;
            }
            if (begins && active) impacts[k] = {};
            impacts[k].active = std::uint8_t(active);
        }
    });
}

void list_rows(const State& s, BinScratch& scratch) {
    ImpactWork& work = scratch.impact;
    work.rows.clear();
    work.places.clear();
    work.before.clear();
    for (std::size_t row = 0; row < scratch.row_count(); ++row) {
        const std::int32_t island = island_of_row(s, scratch, std::int32_t(row));
        if (island == none || work.islands[std::size_t(island)] != ImpactWork::struck) continue;
        work.rows.push_back(std::int32_t(row));
        work.places.push_back(work.place_of[std::size_t(island)]);
        work.before.push_back(scratch.velocity[row]);
    }
    work.last = work.before;
}

void strike_all(BinScratch& scratch, Crew* crew, float h) {
    ImpactWork& work = scratch.impact;
    SolverVelocity* const velocity = scratch.velocity.data();
    for_joint_runs(scratch, crew, [&](const JointRun& run) {
        JointImpact* const impacts = work.joint_blocks[std::size_t(run.type)].data() + run.first;
        with_joint_blocks(scratch, run, [&](const JointKernels::ForRows& k, void* blocks) {
            k.strike(blocks, impacts, int(run.count), velocity, 1 / h);
        });
    });
    for_blocks(scratch, crew, [&](const SolverKernels::ForPoints& k, const BlockRun& run) {
        void* const impacts = run.four_points ? static_cast<void*>(work.four_blocks.data() + run.first)
                                              : static_cast<void*>(work.one_blocks.data() + run.first);
        k.strike(blocks_of(scratch, run), impacts, run.count, velocity, 1 / h);
    });
}

// In units of what counts as settled.
float change_of(const SolverVelocity& now, const SolverVelocity& last) {
    float most = 0;
    for (int i = 0; i < 3; ++i) {
        const float v = std::fabs(now.v[i] - last.v[i]) * (1 / settled_change);
        const float w = std::fabs(now.w[i] - last.w[i]) * (1 / settled_spin);
        most = std::max({most, v, w});
    }
    return most;
}

// Islands that have settled leave, each for itself, so that none depends on others. Whether any is left.
bool settle_islands(const State& s, BinScratch& scratch) {
    ImpactWork& work = scratch.impact;
    work.changes.assign(work.marked.size(), 0.0f);
    for (std::size_t i = 0; i < work.rows.size(); ++i) {
        const SolverVelocity& now = scratch.velocity[std::size_t(work.rows[i])];
        float& change = work.changes[std::size_t(work.places[i])];
        change = std::max(change, change_of(now, work.last[i]));
        work.last[i] = now;
    }
    bool any_left = false, any_settled = false;
    for (std::size_t i = 0; i < work.marked.size(); ++i) {
        ImpactWork::Stage& stage = work.islands[std::size_t(work.marked[i])];
        if (stage != ImpactWork::struck) continue;
        const bool settles = !(work.changes[i] >= 1);
        if (settles) stage = ImpactWork::settled;
        (settles ? any_settled : any_left) = true;
    }
    if (any_left && any_settled) activate_lanes(s, scratch, false);
    return any_left;
}

// What an impact has changed goes to the reference too, and is not carried. Likewise what the rounding leaves over.
void add_to_references(BinScratch& scratch) {
    const ImpactWork& work = scratch.impact;
    const auto add = [](const float* before, const float* now, float* reference, float* rounding) {
        for (int i = 0; i < 3; ++i) {
            const double carried = (double(before[i]) - double(reference[i])) + double(rounding[i]);
            reference[i] = float(double(reference[i]) + (double(now[i]) - double(before[i])));
            rounding[i] = float(carried - (double(now[i]) - double(reference[i])));
        }
    };
    for (std::size_t i = 0; i < work.rows.size(); ++i) {
        const std::size_t row = std::size_t(work.rows[i]);
        const SolverVelocity& now = scratch.velocity[row];
        add(work.before[i].v, now.v, scratch.reference[row].v, scratch.rounding[row].v);
        add(work.before[i].w, now.w, scratch.reference[row].w, scratch.rounding[row].w);
    }
}

} // namespace

void solve_impacts(const State& s, BinScratch& scratch, Crew* crew, float h, std::atomic<int>& struck_contacts) {
    if (struck_contacts == 0) return;
    struck_contacts = 0;
    ImpactWork& work = scratch.impact;
    find_joint_islands(s, scratch);
    mark_islands(s, scratch);
    activate_lanes(s, scratch, true);
    list_rows(s, scratch);
    bool settled = false;
    for (int pass = 0; pass < most_passes && !settled; ++pass) {
        strike_all(scratch, crew, h);
        settled = !settle_islands(s, scratch);
    }
    add_to_references(scratch);
    for (const std::int32_t island : work.marked) work.islands[std::size_t(island)] = ImpactWork::untouched;
}

} // namespace cairn
