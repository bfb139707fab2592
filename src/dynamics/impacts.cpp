#include "dynamics/impacts.h"

#include "dynamics/block_runs.h"
#include "dynamics/joints.h"

#include <cmath>
#include <cstring>
#include <numeric>

namespace cairn {

namespace {

constexpr int most_passes = 48;
// m/s, rad/s: an island whose bodies change by less in a pass has settled.
constexpr float settled_change = 0.02f, settled_spin = 0.08f;

// The types of blocks, as in ImpactWork::blocks: first those of joints, by JointRowType.
constexpr int one_point_type = joint_row_types, four_points_type = joint_row_types + 1;

// Calls f(its blocks in the bin, its struck blocks) for one type of blocks.
template <class F> void with_type(BinScratch& scratch, int type, F&& f) {
    auto& blocks = scratch.impact.blocks;
    switch (type) {
    case int(JointRowType::point):
        return f(scratch.point_blocks, std::get<0>(blocks));
    case int(JointRowType::turn):
        return f(scratch.turn_blocks, std::get<1>(blocks));
    case int(JointRowType::axis):
        return f(scratch.axis_blocks, std::get<2>(blocks));
    case one_point_type:
        return f(scratch.one_blocks, std::get<one_point_type>(blocks));
    default:
        return f(scratch.four_blocks, std::get<four_points_type>(blocks));
    }
}
template <class F> void for_types(BinScratch& scratch, F&& f) {
    for (int type = 0; type <= four_points_type; ++type) with_type(scratch, type, f);
}

// --- which bodies and rows take part

std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t row) {
    while (parent[std::size_t(row)] != row) {
        parent[std::size_t(row)] = parent[std::size_t(parent[std::size_t(row)])];
        row = parent[std::size_t(row)];
    }
    return row;
}

void find_components(const State& s, BinScratch& scratch) {
    ImpactWork& work = scratch.impact;
    const JointLayout& layout = *scratch.joint_layout;
    std::vector<std::int32_t>& component = work.component;
    component.resize(scratch.row_count());
    std::iota(component.begin(), component.end(), 0);
    const auto row_of = [&](std::int32_t body) {
        return body != none && s.is_dynamic(body) ? scratch.row_of_body[std::size_t(body)] : none;
    };
    for (const std::uint32_t joint : layout.joints) {
        const std::int32_t a = row_of(s.joints[joint].body_a), b = row_of(s.joints[joint].body_b);
        if (a == none || b == none) continue;
        const std::int32_t root_a = root_of(component, a), root_b = root_of(component, b);
        component[std::size_t(std::max(root_a, root_b))] = std::min(root_a, root_b);
    }
    for (std::size_t row = 0; row < component.size(); ++row) component[row] = root_of(component, std::int32_t(row));
    for (std::size_t type = 0; type < joint_row_types; ++type)
        work.joint_component[type].assign(8 * std::size_t(layout.blocks[type]), none);
    for (const JointRow& joint_row : layout.rows) {
        if (joint_row.idle) continue;
        const std::int32_t row = row_of(joint_owner(s, s.joints[joint_row.joint]));
        work.joint_component[std::size_t(joint_row.type)][joint_row.lane] =
            row == none ? none : component[std::size_t(row)];
    }
    work.has_components = true;
}

// Of the two bodies of a contact, none where a row is no body that moves by forces.
struct ContactComponents {
    std::int32_t a, b;
};
ContactComponents components_of(const State& s, const BinScratch& scratch, const LaneLists& lanes, std::size_t lane) {
    const auto of = [&](std::int32_t row) {
        const std::int32_t body = scratch.row_bodies[std::size_t(row)];
        return body != none && s.is_dynamic(body) ? scratch.impact.component[std::size_t(row)] : none;
    };
    return {of(lanes.row_a[lane]), of(lanes.row_b[lane])};
}

// Both bodies of a struck contact, and all that joints hold to them.
template <class Block>
void mark_struck(const State& s, BinScratch& scratch, const LaneLists& lanes, std::vector<Block>& blocks) {
    for (std::size_t k = 0; k < lanes.record.size() / 8; ++k) {
        const unsigned struck = blocks[k].struck;
        blocks[k].struck = 0;
        for (std::size_t i = 0; struck >> i; ++i) {
            if (!((struck >> i) & 1) || lanes.record[8 * k + i] == none) continue;
            const ContactComponents of = components_of(s, scratch, lanes, 8 * k + i);
            for (const std::int32_t component : {of.a, of.b})
                if (component != none) scratch.impact.is_struck[std::size_t(component)] = 1;
        }
    }
}

void list_row(const State& s, BinScratch& scratch, std::int32_t row) {
    ImpactWork& work = scratch.impact;
    const std::int32_t body = scratch.row_bodies[std::size_t(row)];
    if (body == none || !s.is_dynamic(body) || work.is_listed[std::size_t(row)]) return;
    work.is_listed[std::size_t(row)] = 1;
    const std::int32_t island = s.bodies[std::size_t(body)].island;
    std::int32_t& place = work.place_of[std::size_t(island)];
    if (place == none) {
        place = std::int32_t(work.islands.size());
        work.islands.push_back({island, false, 0});
    }
    work.rows.push_back(row);
    work.places.push_back(place);
    work.before.push_back(scratch.velocity[std::size_t(row)]);
}

// --- blocks of their own

// Whether lanes of both may lie in one block.
bool are_alike(const PointBlock& a, const PointBlock& b) {
    return a.even == b.even && a.free_axis == b.free_axis && a.redirects == b.redirects;
}
bool are_alike(const TurnBlock& a, const TurnBlock& b) {
    return a.even == b.even && a.free_axis == b.free_axis && a.redirects == b.redirects;
}
bool are_alike(const AxisBlock& a, const AxisBlock& b) {
    return a.even == b.even && a.redirects == b.redirects && a.has_limits == b.has_limits;
}
template <int N> bool are_alike(const ContactBlock<N>& a, const ContactBlock<N>& b) { return a.even == b.even; }

// Where a body's velocity goes that does not move by forces: none of its own business, but that of the block.
template <class Block> void redirect(Block& b, std::size_t lane, std::uint32_t first_discard, std::uint32_t discard) {
    const auto move = [&](std::uint32_t& row) {
        if (row >= first_discard) row = discard;
    };
    if constexpr (requires { b.write_b; })
        move(b.write_b[lane]);
    else if (b.redirects)
        move(b.rest.write_a[lane]), move(b.rest.write_b[lane]);
}
template <class Block> void empty_lanes(Block& b, std::uint32_t discard) {
    for (std::size_t lane = 0; lane < 8; ++lane) {
        b.a[lane] = b.b[lane] = discard;
        if constexpr (requires { b.write_b; })
            b.write_b[lane] = discard;
        else
            b.rest.write_a[lane] = b.rest.write_b[lane] = discard;
    }
}

// All of a block but its flags is rows of eight numbers, one for each lane.
template <class Block> void copy_lane(Block& to, std::size_t lane, const Block& from, std::size_t from_lane) {
    constexpr std::size_t number = 4, row = 8 * number;
    static_assert(sizeof(Block) % row == 0);
    char* const target = reinterpret_cast<char*>(&to);
    const char* const source = reinterpret_cast<const char*>(&from);
    const std::size_t flags = std::size_t(reinterpret_cast<const char*>(&from.even) - source) / row * row;
    for (std::size_t at = 0; at < sizeof(Block); at += row)
        if (at != flags) std::memcpy(target + at + number * lane, source + at + number * from_lane, number);
}

// Copies lanes of one run of the bin's blocks, which begins at `first`.
template <class Block, class Impact> class RunCopy {
  public:
    RunCopy(BinScratch& scratch, std::vector<Block>& from, StruckBlocks<Block, Impact>& to, std::size_t first,
            std::int32_t first_discard_row)
        : from_(from), to_(to), first_(first), begin_(to.blocks.size()),
          first_discard_(std::uint32_t(scratch.row_count()) * row_bytes),
          own_discard_((std::uint32_t(first_discard_row) + std::uint32_t(first)) * row_bytes) {}

    // There are never more blocks than in the bin, so that each has a discard row there.
    void add(std::size_t source, std::int32_t island) {
        const Block& block = from_[source / 8];
        if (to_.blocks.size() == begin_ || used_ == 8 || !are_alike(block, to_.blocks.back())) open(block);
        Block& target = to_.blocks.back();
        copy_lane(target, used_, block, source % 8);
        redirect(target, used_, first_discard_, discard());
        to_.lanes[8 * (to_.blocks.size() - 1) + used_] = {std::uint32_t(source), island};
        to_.impacts.back().active = std::uint8_t(to_.impacts.back().active | 1u << used_);
        ++used_;
    }
    void end(int type, std::vector<StruckRun>& runs) {
        const std::size_t count = to_.blocks.size() - begin_;
        if (count > 0) runs.push_back({type, std::uint32_t(begin_), std::uint32_t(count)});
    }

  private:
    void open(const Block& like) {
        to_.blocks.push_back(like);
        to_.impacts.push_back({});
        to_.lanes.insert(to_.lanes.end(), 8, {0, none});
        used_ = 0;
        empty_lanes(to_.blocks.back(), discard());
    }
    std::uint32_t discard() const { return own_discard_ + std::uint32_t(to_.blocks.size() - 1 - begin_) * row_bytes; }

    std::vector<Block>& from_;
    StruckBlocks<Block, Impact>& to_;
    std::size_t first_, begin_, used_ = 0;
    std::uint32_t first_discard_, own_discard_;
};

// What joints hold to what was struck, and all contacts of that.
void copy_joints(const State& s, BinScratch& scratch) {
    ImpactWork& work = scratch.impact;
    const auto discards = scratch.first_joint_discard_rows();
    for (const JointRun& run : scratch.joint_layout->runs) {
        const std::vector<std::int32_t>& components = work.joint_component[std::size_t(run.type)];
        const std::int32_t discard = discards[std::size_t(run.type)];
        with_type(scratch, int(run.type), [&](auto& from, auto& to) {
            RunCopy copy(scratch, from, to, run.first, discard);
            for (std::size_t lane = 8 * run.first; lane < 8 * (std::size_t(run.first) + run.count); ++lane) {
                const std::int32_t component = components[lane];
                if (component == none || !work.is_struck[std::size_t(component)]) continue;
                const std::int32_t body = scratch.row_bodies[std::size_t(component)];
                copy.add(lane, work.place_of[std::size_t(s.bodies[std::size_t(body)].island)]);
            }
            copy.end(int(run.type), work.runs);
        });
    }
}

template <class Block, class Impact>
void copy_contacts(const State& s, BinScratch& scratch, const BlockRun& run, const LaneLists& lanes,
                   std::int32_t first_discard, std::vector<Block>& from, StruckBlocks<Block, Impact>& to) {
    ImpactWork& work = scratch.impact;
    RunCopy copy(scratch, from, to, std::size_t(run.first), first_discard);
    for (std::size_t lane = 8 * std::size_t(run.first); lane < 8 * std::size_t(run.first + run.count); ++lane) {
        if (lanes.record[lane] == none) continue;
        const ContactComponents of = components_of(s, scratch, lanes, lane);
        const auto is_struck = [&](std::int32_t c) { return c != none && work.is_struck[std::size_t(c)]; };
        if (!is_struck(of.a) && !is_struck(of.b)) continue;
        list_row(s, scratch, lanes.row_a[lane]);
        list_row(s, scratch, lanes.row_b[lane]);
        const std::int32_t body = scratch.row_bodies[std::size_t(lanes.row_a[lane])];
        copy.add(lane, work.place_of[std::size_t(s.bodies[std::size_t(body)].island)]);
    }
    copy.end(run.four_points ? four_points_type : one_point_type, work.runs);
}

void begin_impact(const State& s, BinScratch& scratch) {
    ImpactWork& work = scratch.impact;
    if (!work.has_components) find_components(s, scratch);
    for_types(scratch, [](auto&, auto& struck) { struck.clear(); });
    work.runs.clear(), work.islands.clear(), work.rows.clear(), work.places.clear(), work.before.clear();
    work.is_struck.assign(scratch.row_count(), 0);
    work.is_listed.assign(scratch.row_count(), 0);
    if (work.place_of.size() < s.islands.size()) work.place_of.resize(s.islands.size(), none);
    mark_struck(s, scratch, scratch.one_lanes, scratch.one_blocks);
    mark_struck(s, scratch, scratch.four_lanes, scratch.four_blocks);
    for (std::size_t row = 0; row < scratch.row_count(); ++row)
        if (work.is_struck[std::size_t(work.component[row])]) list_row(s, scratch, std::int32_t(row));
    copy_joints(s, scratch);
    const std::int32_t discard = scratch.first_discard_row();
    const std::int32_t fours = discard + std::int32_t(scratch.one_lanes.record.size() / 8);
    for (const ColorRun& color : scratch.colors) {
        copy_contacts(s, scratch, color.four_points, scratch.four_lanes, fours, scratch.four_blocks,
                      std::get<four_points_type>(work.blocks));
        copy_contacts(s, scratch, color.one_point, scratch.one_lanes, discard, scratch.one_blocks,
                      std::get<one_point_type>(work.blocks));
    }
    work.last = work.before;
}

// --- passes

void strike_run(BinScratch& scratch, int type, std::size_t first, int count, float h) {
    SolverVelocity* const velocity = scratch.velocity.data();
    with_type(scratch, type, [&](auto&, auto& struck) {
        auto* const blocks = struck.blocks.data() + first;
        auto* const impacts = struck.impacts.data() + first;
        if constexpr (std::is_same_v<std::remove_pointer_t<decltype(impacts)>, JointImpact>) {
            const JointKernels& k = kernels().joints;
            const JointKernels::ForRows* const rows[] = {&k.point, &k.turn, &k.axis};
            rows[type]->strike(blocks, impacts, count, velocity, 1 / h);
        } else {
            const SolverKernels& k = kernels().solver;
            (type == four_points_type ? k.four_points : k.one_point).strike(blocks, impacts, count, velocity, 1 / h);
        }
    });
}

void strike_all(BinScratch& scratch, Crew* crew, float h) {
    for (const StruckRun& run : scratch.impact.runs)
        for_chunks(crew, int(run.count), blocks_per_chunk(crew, int(run.count)), [&](int begin, int end, int) {
            strike_run(scratch, run.type, run.first + std::size_t(begin), end - begin, h);
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

// Lanes of islands that have settled take part no longer.
void retire_lanes(BinScratch& scratch) {
    const std::vector<ImpactWork::StruckIsland>& islands = scratch.impact.islands;
    for_types(scratch, [&](auto&, auto& struck) {
        for (std::size_t k = 0; k < struck.impacts.size(); ++k)
            for (std::size_t i = 0; i < 8; ++i) {
                const std::int32_t place = struck.lanes[8 * k + i].island;
                if (place == none || !islands[std::size_t(place)].is_settled) continue;
                struck.impacts[k].active = std::uint8_t(struck.impacts[k].active & ~(1u << i));
            }
    });
}

// Islands that have settled leave, each for itself, so that none depends on others. Whether any is left.
bool settle_islands(BinScratch& scratch) {
    ImpactWork& work = scratch.impact;
    for (ImpactWork::StruckIsland& island : work.islands) island.change = 0;
    for (std::size_t i = 0; i < work.rows.size(); ++i) {
        const SolverVelocity& now = scratch.velocity[std::size_t(work.rows[i])];
        float& change = work.islands[std::size_t(work.places[i])].change;
        change = std::max(change, change_of(now, work.last[i]));
        work.last[i] = now;
    }
    bool any_left = false, any_settled = false;
    for (ImpactWork::StruckIsland& island : work.islands) {
        if (island.is_settled) continue;
        island.is_settled = !(island.change >= 1);
        (island.is_settled ? any_settled : any_left) = true;
    }
    if (any_left && any_settled) retire_lanes(scratch);
    return any_left;
}

// --- and back

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

template <std::size_t N>
void take_rows(float (&to)[N][8], std::size_t lane, const float (&from)[N][8], std::size_t from_lane) {
    for (std::size_t i = 0; i < N; ++i) to[i][lane] = from[i][from_lane];
}
template <int N>
void take_totals(ContactBlock<N>& to, std::size_t lane, const ContactBlock<N>& from, std::size_t from_lane) {
    take_rows(to.total_impulse, lane, from.total_impulse, from_lane);
    take_rows(to.total_tangent, lane, from.total_tangent, from_lane);
}
template <class Block> void take_totals(Block& to, std::size_t lane, const Block& from, std::size_t from_lane) {
    take_rows(to.total, lane, from.total, from_lane);
}
void take_totals(AxisBlock& to, std::size_t lane, const AxisBlock& from, std::size_t from_lane) {
    to.total[lane] = from.total[from_lane];
}

void take_all_totals(BinScratch& scratch) {
    for_types(scratch, [](auto& blocks, auto& struck) {
        for (std::size_t i = 0; i < struck.lanes.size(); ++i) {
            const std::size_t source = struck.lanes[i].source;
            if (struck.lanes[i].island != none)
                take_totals(blocks[source / 8], source % 8, struck.blocks[i / 8], i % 8);
        }
    });
}

} // namespace

void solve_impacts(const State& s, BinScratch& scratch, Crew* crew, float h, std::atomic<int>& struck_contacts) {
    if (struck_contacts == 0) return;
    struck_contacts = 0;
    begin_impact(s, scratch);
    bool settled = false;
    for (int pass = 0; pass < most_passes && !settled; ++pass) {
        strike_all(scratch, crew, h);
        settled = !settle_islands(scratch);
    }
    add_to_references(scratch);
    take_all_totals(scratch);
    for (const ImpactWork::StruckIsland& island : scratch.impact.islands)
        scratch.impact.place_of[std::size_t(island.island)] = none;
}

} // namespace cairn
