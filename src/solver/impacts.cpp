#include "solver/impacts.h"

#include "joints/direct_joints.h"
#include "solver/block_runs.h"
#include "solver/impact_blocks.h"
#include "solver/rank_impacts.h"

#include <algorithm>
#include <bit>
#include <tuple>
#include <type_traits>
#include <utility>

namespace cairn {

namespace {

constexpr int max_passes = 48; // of one round of an impact, and rounds of one impact
// m/s, rad/s: a group has settled when a pass changes the velocities of its bodies by less.
constexpr SettledChange settled = {0.01f, 0.04f};
// The same bound for bounces, which is lower: the rebound speed is known, and the errors that passes leave add up from
// bounce to bounce. With a bound ten times as high, Newton's cradle of two balls changes its energy by 0.03 % per
// bounce.
constexpr SettledChange bounced = {0.00002f, 0.00008f};

// --- passes

SolverVelocity* velocities(BatchScratch& scratch) {
    return scratch.border ? scratch.impact.shared.velocity.data() : scratch.velocity.data();
}

void solve_impact_run(BatchScratch& scratch, int type, std::size_t first, int count, float h) {
    SolverVelocity* const velocity = velocities(scratch);
    with_type(scratch, type, [&](auto&, auto& in_impact) {
        auto* const blocks = in_impact.blocks.data() + first;
        auto* const impacts = in_impact.impacts.data() + first;
        if constexpr (std::is_same_v<std::remove_pointer_t<decltype(impacts)>, JointImpact>) {
            const JointKernels& k = kernels().joints;
            const JointKernels::ForRows* const rows[] = {&k.point, &k.turn, &k.axis};
            rows[std::size_t(type)]->impact_pass(blocks, impacts, count, velocity, 1 / h);
        } else {
            const SolverKernels& k = kernels().solver;
            const std::size_t points = type == four_points_type ? 4 : 1;
            const float* const speed =
                in_impact.rebound_speeds.empty() ? nullptr : in_impact.rebound_speeds[points * first].value;
            (type == four_points_type ? k.four_points : k.one_point)
                .impact_pass(blocks, impacts, speed, count, velocity, 1 / h);
        }
    });
}

void solve_impact_pass(BatchScratch& scratch, ThreadPool* thread_pool, float h) {
    for (const ImpactRun& run : scratch.impact.runs)
        for_chunks(thread_pool, int(run.count), blocks_per_chunk(thread_pool, int(run.count)),
                   [&](int begin, int end, int) {
                       solve_impact_run(scratch, run.type, run.first + std::size_t(begin), end - begin, h);
                   });
}

// Calls f(kernels, struck blocks, points per block) for both types of contact blocks.
template <class F> void for_impact_contacts(BatchScratch& scratch, F&& f) {
    f(kernels().solver.one_point, std::get<one_point_type>(scratch.impact.blocks), std::size_t(1));
    f(kernels().solver.four_points, std::get<four_points_type>(scratch.impact.blocks), std::size_t(4));
}

void find_rebounds(BatchScratch& scratch, const SolverBodies& bodies, const BounceSettings& settings) {
    for_impact_contacts(scratch, [&](const SolverKernels::ForPoints& k, auto& in_impact, std::size_t points) {
        if (in_impact.blocks.empty()) return;
        in_impact.rebound_speeds.resize(points * in_impact.blocks.size()),
            in_impact.arrivals.resize(in_impact.rebound_speeds.size());
        k.find_rebounds(in_impact.blocks.data(), in_impact.impacts.data(),
                        {in_impact.rebound_speeds[0].value, in_impact.arrivals[0].value}, int(in_impact.blocks.size()),
                        bodies, settings);
    });
}

// Directly solved joints count as one constraint row of a pass: all bodies that they connect get velocities that
// satisfy them.
void join_sets(const Joints& joints, const DirectSets& direct, BatchScratch& scratch, float h) {
    const ImpactWork& work = scratch.impact;
    for (const std::int32_t set : work.sets) {
        const DirectSolve& solve = scratch.direct.sets[std::size_t(set)];
        const std::int32_t row = scratch.direct.bodies[solve.first_body + 1].row;
        if (!work.groups[std::size_t(work.place_of[std::size_t(row)])].is_settled)
            join_velocities(joints, direct, scratch, std::size_t(set), h);
    }
}

// Deactivates the lanes of settled groups.
void retire_lanes(BatchScratch& scratch) {
    const std::vector<ImpactWork::Group>& groups = scratch.impact.groups;
    for_types(scratch, [&](auto&, auto& in_impact) {
        for (std::size_t k = 0; k < in_impact.impacts.size(); ++k)
            for (unsigned left = in_impact.impacts[k].active; left != 0; left &= left - 1) {
                const unsigned i = unsigned(std::countr_zero(left));
                if (!groups[in_impact.lanes[8 * k + i].group].is_settled) continue;
                in_impact.impacts[k].active = std::uint8_t(in_impact.impacts[k].active & ~(1u << i));
            }
    });
}

// Marks the groups that have settled, and deactivates their lanes. Returns whether any group has not settled.
bool settle_groups(BatchScratch& scratch, SettledChange least) {
    ImpactWork& work = scratch.impact;
    bool any_left = false, any_settled = false;
    for (ImpactWork::Group& group : work.groups) {
        if (group.is_settled) continue;
        const float change =
            kernels().solver.change_since(velocities(scratch), work.rows.data() + group.begin,
                                          int(group.end - group.begin), work.last.data() + group.begin, least);
        group.is_settled = !(change >= 1);
        (group.is_settled ? any_settled : any_left) = true;
    }
    if (any_left && any_settled) retire_lanes(scratch);
    return any_left;
}

// --- results of the passes

// Adds the velocity changes of an impact to the reference velocities too, so that they are not carried over to later
// substeps; `rounding` keeps the rounding errors of these additions.
void add_to_references(BatchScratch& scratch) {
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

// Corrects poses because, until the impact, bodies move with their velocities from before it. The contacts of a group
// that bounce are assumed to do so at their mean time, weighted by impulse.
void correct_poses(BatchScratch& scratch, const SolverBodies& bodies) {
    ImpactWork& work = scratch.impact;
    for (ImpactWork::Group& group : work.groups) group.impulse = group.moment = 0;
    for_impact_contacts(scratch, [&](const SolverKernels::ForPoints&, const auto& in_impact, std::size_t points) {
        for (std::size_t i = 0; i < in_impact.lanes.size(); ++i) {
            if (in_impact.lanes[i].group == none) continue;
            ImpactWork::Group& group = work.groups[std::size_t(in_impact.lanes[i].group)];
            for (std::size_t k = 0; k < points; ++k) {
                const std::size_t place = i / 8 * points + k;
                if (in_impact.rebound_speeds[place].value[i % 8] == does_not_arrive) continue;
                const double impulse = double(in_impact.impacts[i / 8].impulse[k][i % 8]);
                group.impulse += impulse;
                group.moment += impulse * double(in_impact.arrivals[place].value[i % 8]);
            }
        }
    });
    for (const ImpactWork::Group& group : work.groups) {
        if (!(group.impulse > 0)) continue;
        const auto time = float(group.moment / group.impulse);
        for (std::size_t i = group.begin; i < group.end; ++i) {
            const std::size_t row = std::size_t(work.rows[i]);
            const SolverVelocity &now = bodies.velocity[row], &before = work.before[i];
            SolverTwist& correction = bodies.velocity_correction[row];
            for (int k = 0; k < 3; ++k) {
                correction.v[k] -= time * (now.v[k] - before.v[k]);
                correction.w[k] -= time * (now.w[k] - before.w[k]);
            }
        }
    }
}

} // namespace

bool solve_impacts(const Bodies& bodies, const Joints& joints, const DirectSets& direct, BatchScratch& scratch,
                   ThreadPool* thread_pool, Communicator* ranks, const ContactSoftness& softness,
                   const Bouncing* bounce, std::atomic<int>& impact_contacts) {
    const auto in_impact = std::uint64_t(impact_contacts.exchange(0));
    if ((scratch.border ? ranks->sum(in_impact) : in_impact) == 0) return false;
    begin_impact_lists(bodies, joints, direct, scratch, ranks, softness);
    const bool any_hits = !scratch.impact.hits.empty(); // bodies pushed out by penetration hit nothing
    for (int round = 0; round < max_passes; ++round) {
        list_impact(scratch, softness.h);
        copy_listed(scratch);
        if (scratch.border) {
            share_impact(scratch, *ranks);
            retire_lanes(scratch); // of groups without a body that this rank needs
        }
        if (bounce) find_rebounds(scratch, bounce->bodies, bounce->settings);
        for (int pass = 0; pass < max_passes; ++pass) {
            solve_impact_pass(scratch, thread_pool, softness.h);
            join_sets(joints, direct, scratch, softness.h);
            if (!settle_groups(scratch, bounce ? bounced : settled)) break;
        }
        if (scratch.border) return_shared_velocities(scratch);
        add_to_references(scratch);
        add_totals(scratch);
        if (bounce) correct_poses(scratch, bounce->bodies);
        if (bounce || !spread_impact(scratch, ranks, softness)) break;
    }
    end_impact_lists(scratch.impact);
    return any_hits;
}

} // namespace cairn
