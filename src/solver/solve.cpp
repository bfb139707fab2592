// Solves batches: gather, substeps, scatter. A large batch is solved by all threads together, color by color; each of
// the others by one thread.
#include "solver/solve.h"

#include "bodies/bodies.h"
#include "bodies/finalize.h"
#include "bodies/integrators.h"
#include "core/room.h"
#include "islands/substep_policy.h"
#include "joints/direct_joints.h"
#include "joints/direct_sets.h"
#include "joints/joint_rows.h"
#include "math/rotation.h"
#include "solver/batch_lanes.h"
#include "solver/batch_rows.h"
#include "solver/block_runs.h"
#include "solver/direct_contacts.h"
#include "solver/impacts.h"
#include "solver/rank_border.h"
#include "solver/rank_results.h"
#include "solver/row_motion.h"
#include "solver/softness.h"
#include "state/state.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>

namespace cairn {

namespace {

constexpr int max_bounce_passes = 32;
// Minimum number of contacts and joints for a batch to be worth solving with all threads together.
constexpr std::int32_t min_shared_contacts = 512;
constexpr int rows_per_chunk = 512; // for threads

ContactLanes lanes_of(const BatchScratch& scratch, const BlockRun& run) {
    const LaneLists& lanes = run.four_points ? scratch.four_lanes : scratch.one_lanes;
    const std::size_t at = std::size_t(run.first) * 8;
    // Discard rows of blocks with one contact point come first.
    const std::size_t before = run.four_points ? scratch.one_lanes.record.size() / 8 : 0;
    return {lanes.record.data() + at, lanes.row_a.data() + at, lanes.row_b.data() + at,
            scratch.first_discard_row() + std::int32_t(before) + run.first};
}

// Stored velocity minus that of the discrete path at the start of the substep, in units of h a; see bounce.cpp.
float velocity_offset(Integrator integrator) {
    switch (integrator) {
    case Integrator::semi_implicit_euler:
        return 0.5f;
    case Integrator::rk4:
        return 1.0f;
    case Integrator::explicit_euler:
        return 1.5f;
    }
    return 0;
}

void refresh_all(BatchScratch& scratch, ThreadPool* thread_pool, const SolverBodies& bodies, float h) {
    for_blocks(scratch, thread_pool, [&](const SolverKernels::ForPoints& k, const BlockRun& run) {
        k.refresh_arms(blocks_of(scratch, run), run.count, bodies, scratch.free_correction.data(), h);
    });
}

// for_blocks for kernels that change rows of these arrays: for a batch that is cut, ranks exchange border rows after
// each color.
template <class F>
void sweep_colors(BatchScratch& scratch, ThreadPool* thread_pool, Communicator* ranks, std::span<void* const> arrays,
                  F&& kernel) {
    for_colors(scratch, thread_pool, kernel, [&](std::size_t color) {
        if (scratch.border) exchange_border(*scratch.border, *ranks, color, arrays);
    });
}

// `in_impact`: set to the number of blocks in which a contact with jointed bodies is left to the impact passes.
void bounce_all(BatchScratch& scratch, ThreadPool* thread_pool, Communicator* ranks, const SolverBodies& bodies,
                const BounceSettings& settings, std::atomic<int>& in_impact) {
    void* const changed[] = {bodies.velocity, bodies.reference, bodies.velocity_correction};
    for (int pass = 0; pass < max_bounce_passes; ++pass) {
        std::atomic<int> bounced = 0;
        in_impact = 0;
        sweep_colors(scratch, thread_pool, ranks, changed, [&](const SolverKernels::ForPoints& k, const BlockRun& run) {
            const BounceCount count = k.bounce(blocks_of(scratch, run), run.count, bodies, settings);
            if (count.bounced > 0) bounced += count.bounced;
            if (count.in_impact > 0) in_impact += count.in_impact;
        });
        if ((scratch.border ? ranks->sum(std::uint64_t(bounced)) : std::uint64_t(bounced)) == 0) {
            if (pass > 0) refresh_all(scratch, thread_pool, bodies, settings.h);
            return;
        }
    }
    refresh_all(scratch, thread_pool, bodies, settings.h);
}

// Marks the contacts of bodies with joints: an impact on such a body acts on all bodies that joints connect to it.
void mark_joined(const Bodies& bodies, BatchScratch& scratch) {
    const auto is_joined = [&](std::int32_t row) {
        const std::int32_t body = scratch.row_bodies[std::size_t(row)];
        return body != none && bodies.links[body].joint_count > 0;
    };
    const auto mark = [&](const LaneLists& lanes, auto& blocks) {
        for_lanes_of(lanes, is_joined, [&](std::size_t block, std::uint8_t bits) { blocks[block].joined = bits; });
    };
    mark(scratch.one_lanes, scratch.one_blocks);
    mark(scratch.four_lanes, scratch.four_blocks);
}

SolverBodies bodies_of(BatchScratch& scratch) {
    SolverTwist* const free = scratch.free_correction.empty() ? nullptr : scratch.free_correction.data();
    SolverTwist* const correction = scratch.bounces ? scratch.correction.data() : free;
    return {scratch.velocity.data(),
            scratch.reference.data(),
            scratch.rounding.data(),
            scratch.pose.data(),
            scratch.inertia.data(),
            scratch.drive.data(),
            scratch.damping.empty() ? nullptr : scratch.damping.data(),
            correction};
}

void run_substeps(const Bodies& bodies, const Joints& joints, const ForceFields& fields, const WorldDef& settings,
                  const DirectSets& direct, const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool,
                  Communicator* ranks, float dt) {
    using ForPoints = SolverKernels::ForPoints;
    using ForRows = JointKernels::ForRows;
    const SolverKernels& k = kernels().solver;
    const float h = dt / float(batch.substeps);
    ContactSoftness softness = contact_softness(dt, batch.substeps, settings.recovery_speed);
    const BounceSettings bounce{h, settings.restitution_speed, velocity_offset(settings.integrator)};
    const JointSoftness joint_soft = joint_softness(dt, batch.substeps);
    // Disabled where kinematic bodies drive joints, as the impact passes would stop the driven bodies.
    const bool stops_impacts = scratch.joint_layout->kinematic_bodies.empty();
    softness.impact_speed = stops_impacts ? impact_speed : no_impact_speed;
    const int rows = int(scratch.row_count());
    SolverVelocity* velocity = scratch.velocity.data();
    void* const changed[] = {velocity};
    const auto sweep = [&](auto&& kernel) { sweep_colors(scratch, thread_pool, ranks, changed, kernel); };
    std::atomic<int> in_impact = 0;
    scratch.impact.has_components = false;
    if (batch.bounces && batch.joint_count > 0 && stops_impacts) mark_joined(bodies, scratch);
    for (int substep = 0; substep < batch.substeps; ++substep) {
        const bool first = substep == 0;
        softness.inverse_elapsed = 1 / (float(substep + 1) * h);
        softness.middle = (float(substep) + 0.5f) * h;
        const SolverBodies solver_bodies = bodies_of(scratch);
        update_free_motion(bodies, fields, settings, scratch, thread_pool, solver_bodies, h, first);
        for_chunks(thread_pool, rows, rows_per_chunk, [&](int begin, int end, int) {
            k.integrate_velocities(solver_bodies, std::max(begin, int(first_body_row)), end, first);
        });
        if (first)
            for_joint_blocks(scratch, thread_pool, [&](const ForRows& rows_of, const JointBlocks& blocks) {
                rows_of.warm_start(blocks, solver_bodies, joint_soft);
            });
        begin_direct_substep(joints, direct, scratch, thread_pool, h, first);
        share_inertia(direct, scratch);
        renew_direct_contacts(scratch, thread_pool);
        for (int pass = 0; batch.bounces && pass < max_bounce_passes; ++pass) {
            bounce_all(scratch, thread_pool, ranks, solver_bodies, bounce, in_impact);
            const Bouncing bouncing{solver_bodies, bounce};
            if (!solve_impacts(bodies, joints, direct, scratch, thread_pool, ranks, softness, &bouncing, in_impact))
                break;
            refresh_all(scratch, thread_pool, solver_bodies, h);
        }
        if (first) {
            sweep([&](const ForPoints& points, const BlockRun& run) {
                points.warm_start(blocks_of(scratch, run), run.count, velocity);
            });
        }
        use_midpoint_spin(scratch, thread_pool);
        begin_direct_limits(direct, scratch, thread_pool);
        for_joint_blocks(scratch, thread_pool, [&](const ForRows& rows_of, const JointBlocks& blocks) {
            rows_of.solve(blocks, velocity, joint_soft);
        });
        solve_direct_rows(joints, direct, scratch, thread_pool, h);
        sweep([&](const ForPoints& points, const BlockRun& run) {
            const int count = points.solve(blocks_of(scratch, run), run.count, velocity, softness);
            if (count > 0) in_impact += count;
        });
        solve_impacts(bodies, joints, direct, scratch, thread_pool, ranks, softness, nullptr, in_impact);
        hold_direct_bodies(joints, direct, scratch, thread_pool, h);
        for_chunks(thread_pool, rows, rows_per_chunk,
                   [&](int begin, int end, int) { k.integrate_poses(solver_bodies, begin, end, h); });
        turn_spinning_rows(bodies, scratch, h);
        release_direct_bodies(direct, scratch, thread_pool);
        restore_end_spin(scratch, thread_pool);
        renew_inertia(bodies, scratch, thread_pool);
        share_inertia(direct, scratch);
        use_midpoint_spin(scratch, thread_pool);
        for_joint_blocks(scratch, thread_pool, [&](const ForRows& rows_of, const JointBlocks& blocks) {
            rows_of.relax(blocks, solver_bodies, joint_soft);
        });
        sweep([&](const ForPoints& points, const BlockRun& run) {
            const int count = points.relax(blocks_of(scratch, run), run.count, solver_bodies, softness);
            if (count > 0) in_impact += count;
        });
        restore_end_spin(scratch, thread_pool);
        solve_impacts(bodies, joints, direct, scratch, thread_pool, ranks, softness, nullptr, in_impact);
    }
}

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// The state that solving one batch reads and partly modifies while other threads may be working on other batches;
// solve.h lists the parts that may be modified.
struct BatchContext {
    const WorldDef& settings;
    const ForceFields& fields;
    const BroadPhase& broad_phase;
    Bodies& bodies;
    Shapes& shapes;
    Contacts& contacts;
    Islands& islands;
    Joints& joints;
    const DirectSets& direct;
    SolverScratch& solver;
    Communicator* ranks; // null: this process alone
};

// Kernels index records and reports by the same number. On a rank that does not hold all records, this is the place of
// the record, so that reports go to `own_reports`.
ContactReport* reports_by_place(const BatchContext& s) {
    return (s.contacts.records.is_whole() ? s.solver.reports : s.solver.own_reports).data();
}
void number_places(const Contacts& contacts, BatchScratch& scratch) {
    for (LaneLists* const lanes : {&scratch.one_lanes, &scratch.four_lanes})
        for (std::int32_t& record : lanes->record)
            if (record >= 0) record = std::int32_t(contacts.records.place_of(std::size_t(record)));
}
void return_reports(const Contacts& contacts, SolverScratch& solver, const IslandBatch& batch) {
    const SortedContact* contact = solver.of_batches.data() + batch.first_contact;
    for (const SortedContact* const end = contact + batch.contact_count; contact != end; ++contact)
        if (contacts.records.has(contact->id))
            solver.reports[contact->id] = solver.own_reports[contacts.records.place_of(contact->id)];
}

void solve_batch(const BatchContext& s, const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool,
                 float dt) {
    const auto start = std::chrono::steady_clock::now();
    const float h = dt / float(batch.substeps);
    gather_batch(s.bodies, s.shapes, s.contacts, s.islands, s.joints, s.fields, s.settings, s.solver, s.direct, batch,
                 scratch, thread_pool, h);
    if (scratch.row_count() > 0) {
        if (!s.contacts.records.is_whole()) number_places(s.contacts, scratch);
        fill_joint_blocks(s.bodies, s.joints, s.direct, scratch, thread_pool, h);
        list_direct_contacts(s.direct, scratch);
        prepare_free_motion(s.bodies, s.fields, s.settings, scratch, thread_pool, h, batch.bounces);
        for_blocks(scratch, thread_pool, [&](const SolverKernels::ForPoints& k, const BlockRun& run) {
            k.prepare(blocks_of(scratch, run), run.count, lanes_of(scratch, run), s.contacts.records.data(),
                      scratch.inertia.data(), scratch.velocity.data(), 0.5f * dt, h);
        });
        const double prepare_ms = milliseconds_since(start);
        scratch.prepare_ms += prepare_ms;
        run_substeps(s.bodies, s.joints, s.fields, s.settings, s.direct, batch, scratch, thread_pool, s.ranks, dt);
        finish_free_motion(scratch);
        leave_belts_in_place(s.bodies, s.shapes, s.contacts, scratch, dt);
        for_blocks(scratch, thread_pool, [&](const SolverKernels::ForPoints& k, const BlockRun& run) {
            k.store(blocks_of(scratch, run), run.count, lanes_of(scratch, run), scratch.pose.data(),
                    s.contacts.records.data(), reports_by_place(s), dt);
        });
        if (!s.contacts.records.is_whole()) return_reports(s.contacts, s.solver, batch);
        store_joints(s.joints, s.settings, s.direct, scratch, dt);
        scratch.solve_ms += milliseconds_since(start) - prepare_ms;
    }
    scatter_batch(s.bodies, s.shapes, s.broad_phase, s.fields, s.settings, s.solver, scratch, thread_pool, dt);
}

// Among the batches that one rank or every rank solves as a whole, finds those so large that one thread alone would
// keep the others waiting; these are shared by all threads.
void share_out_batches(SolverScratch& scratch, int threads, std::int32_t owner) {
    const auto is_meant = [&](std::size_t i) {
        return scratch.cut.owner_of_batch.empty() || scratch.cut.owner_of_batch[i] == owner;
    };
    std::int32_t contacts = 0;
    for (const IslandBatch& batch : scratch.batches) contacts += batch.contact_count + batch.joint_count;
    const std::int32_t limit = std::max(min_shared_contacts, contacts / threads);
    scratch.shared.clear();
    scratch.alone.clear();
    for (std::size_t i = 0; i < scratch.batches.size(); ++i)
        if (is_meant(i))
            (scratch.batches[i].contact_count + scratch.batches[i].joint_count > limit ? scratch.shared : scratch.alone)
                .push_back(std::int32_t(i));
}

void solve_alone(const BatchContext& s, ThreadPool& thread_pool, std::int32_t owner, float dt) {
    SolverScratch& scratch = s.solver;
    share_out_batches(scratch, thread_pool.threads(), owner);
    const auto sort_and_solve = [&](std::int32_t i, BatchScratch& own, ThreadPool* threads) {
        sort_contacts(scratch, scratch.batches[i], own, threads);
        solve_batch(s, scratch.batches[i], own, threads, dt);
    };
    for (const std::int32_t i : scratch.shared) sort_and_solve(i, scratch.at_work[0], &thread_pool);
    thread_pool.for_chunks(int(scratch.alone.size()), 1, [&](int begin, int end, int thread) {
        for (int k = begin; k < end; ++k) sort_and_solve(scratch.alone[k], scratch.at_work[thread], nullptr);
    });
}

// Solves the batches that are distributed among the ranks. Returns how many times a speed was clamped in them.
std::uint64_t solve_parts(const BatchContext& s, ThreadPool& thread_pool, float dt) {
    SolverScratch& scratch = s.solver;
    cut_batches(s.bodies, s.contacts, s.islands, s.fields, s.settings, *s.ranks, scratch);
    set_size_anew(scratch.own_reports, s.contacts.records.is_whole() ? 0 : s.contacts.records.places());
    for (std::size_t i = 0; i < scratch.batches.size(); ++i) {
        if (scratch.cut.owner_of_batch[i] != cut_by_body) continue;
        sort_contacts(scratch, scratch.batches[i], scratch.at_work[0], &thread_pool);
        find_border(s.bodies, scratch.batches[i], scratch, scratch.border);
        scratch.at_work[0].border = &scratch.border;
        solve_batch(s, scratch.batches[i], scratch.at_work[0], &thread_pool, dt);
        scratch.at_work[0].border = nullptr;
    }
    solve_alone(s, thread_pool, scratch.cut.rank, dt);
    std::uint64_t clamped_speeds = 0;
    for (BatchScratch& own : scratch.at_work) clamped_speeds += std::exchange(own.clamped_speeds, 0);
    clamped_speeds = s.ranks->sum(clamped_speeds);
    exchange_results(*s.ranks, s.bodies, s.shapes, s.broad_phase, s.settings, scratch, thread_pool, dt);
    // Every rank moves all free bodies: sending the results would take longer.
    move_free_bodies(s.bodies, s.shapes, s.broad_phase, s.fields, s.settings, scratch, scratch.cut.free_bodies,
                     scratch.at_work[0], &thread_pool, dt);
    return clamped_speeds;
}

// Kinematic bodies move by their velocity, once per step, in double.
void move_kinematics(Bodies& bodies, float dt) {
    for (const std::int32_t b : bodies.kinematics) {
        BodyMotion& motion = bodies.motion[b];
        const math::DQuat turn = math::from_rotation_vector(double(dt) * math::to_double(motion.w));
        const math::DVec3 x = motion.x + double(dt) * math::to_double(motion.v);
        if (is_place(x))
            motion.x = x;
        else
            motion.v = {};
        motion.q = math::normalized(turn * motion.q);
        motion.turned = math::to_float(turn);
    }
}

// Concatenates the threads' results, in an order that does not depend on the threads. Returns how many times a speed
// was clamped.
std::uint64_t collect(SolverScratch& scratch) {
    scratch.escaped.clear();
    scratch.fast.clear();
    scratch.strayed.clear();
    scratch.overloaded.clear();
    std::uint64_t clamped_speeds = 0;
    double prepare_ms = 0, solve_ms = 0;
    for (BatchScratch& own : scratch.at_work) {
        const FinalizeScratch& moved = own.finalized;
        scratch.escaped.insert(scratch.escaped.end(), moved.escaped.begin(), moved.escaped.end());
        scratch.fast.insert(scratch.fast.end(), moved.fast.begin(), moved.fast.end());
        scratch.strayed.insert(scratch.strayed.end(), moved.strayed.begin(), moved.strayed.end());
        scratch.overloaded.insert(scratch.overloaded.end(), own.overloaded.begin(), own.overloaded.end());
        clamped_speeds += own.clamped_speeds;
        prepare_ms += own.prepare_ms;
        solve_ms += own.solve_ms;
    }
    std::sort(scratch.fast.begin(), scratch.fast.end());
    std::sort(scratch.strayed.begin(), scratch.strayed.end());
    std::sort(scratch.overloaded.begin(), scratch.overloaded.end());
    scratch.prepare_share = prepare_ms / std::max(prepare_ms + solve_ms, 1e-9);
    return clamped_speeds;
}

} // namespace

std::uint64_t solve_batches(Bodies& bodies, Shapes& shapes, Contacts& contacts, Islands& islands, Joints& joints,
                            const ForceFields& fields, BroadPhase& broad_phase, const WorldDef& settings,
                            StepScratch& step, Communicator* ranks, float dt) {
    SolverScratch& scratch = step.solver;
    ThreadPool* const thread_pool = step.thread_pool.get();
    set_size(scratch.reports, contacts.info.size());
    scratch.at_work.resize(std::size_t(thread_pool->threads()));
    if (scratch.joint_layouts.size() < scratch.batches.size()) scratch.joint_layouts.resize(scratch.batches.size());
    for (BatchScratch& own : scratch.at_work) {
        own.finalized.escaped.clear();
        own.finalized.fast.clear();
        own.finalized.strayed.clear();
        own.overloaded.clear();
        own.clamped_speeds = 0;
        own.prepare_ms = own.solve_ms = 0;
    }
    std::uint64_t clamped_speeds = 0;
    for (const std::int32_t b : bodies.kinematics)
        if (BodyMotion& motion = bodies.motion[b]; clamp_velocity(settings, motion.v, motion.w)) ++clamped_speeds;
    const BatchContext context{settings, fields, broad_phase, bodies,  shapes, contacts,
                               islands,  joints, step.direct, scratch, ranks};
    if (ranks)
        clamped_speeds += solve_parts(context, *thread_pool, dt);
    else
        scratch.cut.owner_of_batch.clear();
    solve_alone(context, *thread_pool, every_rank, dt);
    clamped_speeds += collect(scratch);
    move_kinematics(bodies, dt);
    return clamped_speeds;
}

} // namespace cairn
