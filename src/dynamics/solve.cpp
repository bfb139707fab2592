// One bin after the other: gather, substeps, scatter.
#include "dynamics/bodies.h"
#include "dynamics/coloring.h"
#include "dynamics/solver.h"
#include "math/rotation.h"

#include <algorithm>
#include <chrono>

namespace cairn {

namespace {

constexpr float friction_margin = 0.005f; // m: points closer than this share the friction fully
constexpr int most_bounce_passes = 32;
constexpr float pi = 3.14159265358979f;

SolverVelocity to_row(math::Vec3 v, math::Vec3 w) { return {{v.x, v.y, v.z}, 0, {w.x, w.y, w.z}, 0}; }

// Catto's soft constraint ("Soft Constraints", GDC 2011) as a spring of that frequency (Hz) and damping ratio, in a
// substep of h seconds. The frequency follows the substep, uncapped: docs/solver.md says why.
void set_softness(ContactSoftness& s, float h, float recovery_speed) {
    constexpr float damping_ratio = 10.0f;
    auto spring = [&](float frequency) {
        const float omega = 2 * pi * frequency;
        const float a1 = 2 * damping_ratio + h * omega, a2 = h * omega * a1;
        const float scale = a2 / (1 + a2);
        return ContactSoftness::Spring{scale, omega / a1, recovery_speed / scale};
    };
    s.h = h;
    s.inverse_h = 1 / h;
    const float frequency = 1 / (8 * h);
    s.on_movable = spring(frequency);
    s.on_immovable = spring(2 * frequency);
}

// Bodies of the bin's islands, then room for kinematic ones.
void gather_bodies(State& s, const Bin& bin) {
    SolverScratch& scratch = s.solver;
    scratch.row_bodies.assign(first_body_row, none);
    for (std::int32_t k = 0; k < bin.island_count; ++k) {
        const Island& island = s.islands[std::size_t(scratch.bin_islands[std::size_t(bin.first_island + k)])];
        for (std::int32_t b = island.first_body; b != none; b = s.bodies[std::size_t(b)].next_in_island) {
            if (s.bodies[std::size_t(b)].contact_count == 0) {
                scratch.free_bodies.push_back(b);
                continue;
            }
            scratch.row_of_body[std::size_t(b)] = std::int32_t(scratch.row_bodies.size());
            scratch.row_bodies.push_back(b);
        }
    }
}

// The row of a body that may be kinematic: those get theirs when first met.
std::int32_t row_of(SolverScratch& scratch, std::int32_t body) {
    if (body == none) return fixed_row;
    std::int32_t& row = scratch.row_of_body[std::size_t(body)];
    if (row == none) {
        row = std::int32_t(scratch.row_bodies.size());
        scratch.row_bodies.push_back(body);
    }
    return row;
}

void add_lane(LaneLists& lanes, std::int32_t record, std::int32_t a, std::int32_t b) {
    lanes.record.push_back(record);
    lanes.row_a.push_back(a);
    lanes.row_b.push_back(b);
}
void pad_lanes(LaneLists& lanes) {
    while (lanes.record.size() % 8 != 0) add_lane(lanes, -1, discard_row, discard_row);
}

// Lays the bin's contacts into blocks of 8 lanes; one run of blocks for each color and size.
void fill_lanes(SolverScratch& scratch, const Bin& bin) {
    scratch.one_lanes.clear();
    scratch.four_lanes.clear();
    scratch.runs.clear();
    std::int32_t k = bin.first_contact;
    const std::int32_t end = bin.first_contact + bin.contact_count;
    while (k < end) {
        const SortedContact& first = scratch.sorted[std::size_t(k)];
        const bool four = first.four_points != 0;
        LaneLists& lanes = four ? scratch.four_lanes : scratch.one_lanes;
        BlockRun run{four, std::int32_t(lanes.record.size() / 8), 0};
        for (; k < end; ++k) {
            const SortedContact& c = scratch.sorted[std::size_t(k)];
            if (c.color != first.color || c.four_points != first.four_points) break;
            add_lane(lanes, std::int32_t(c.id), row_of(scratch, c.body_a), row_of(scratch, c.body_b));
            if (c.color != overflow_color) continue;
            ++k; // alone in its run: it may share bodies with the next
            break;
        }
        pad_lanes(lanes);
        run.count = std::int32_t(lanes.record.size() / 8) - run.first;
        scratch.runs.push_back(run);
    }
    if (scratch.one_blocks.size() * 8 < scratch.one_lanes.record.size())
        scratch.one_blocks.resize(scratch.one_lanes.record.size() / 8);
    if (scratch.four_blocks.size() * 8 < scratch.four_lanes.record.size())
        scratch.four_blocks.resize(scratch.four_lanes.record.size() / 8);
}

math::Sym3 contact_inverse_inertia(const BodyMotion& motion, const BodyMass& mass) {
    const math::Vec3 d = mass.inverse_inertia;
    const float least = std::min({d.x, d.y, d.z}), most = least / least_contact_moment;
    if (mass.isotropic || !(least > 0) || std::max({d.x, d.y, d.z}) <= most) return world_inverse_inertia(motion, mass);
    BodyMass rounder = mass;
    rounder.inverse_inertia = {std::min(d.x, most), std::min(d.y, most), std::min(d.z, most)};
    return world_inverse_inertia(motion, rounder);
}

// Copies the bodies into their rows; rows that are no bodies are all zero.
void fill_rows(State& s) {
    SolverScratch& scratch = s.solver;
    while (scratch.row_bodies.size() % 8 != 0) scratch.row_bodies.push_back(none);
    const std::size_t rows = scratch.row_bodies.size();
    scratch.velocity.assign(rows, {});
    scratch.reference.assign(rows, {});
    scratch.rounding.assign(rows, {});
    scratch.pose.assign(rows, {{0, 0, 0}, 0, {0, 0, 0, 1}});
    scratch.inertia.assign(rows, {});
    for (std::size_t row = first_body_row; row < rows; ++row) {
        const std::int32_t b = scratch.row_bodies[row];
        if (b == none) continue;
        BodyMotion& motion = s.motion[std::size_t(b)];
        if (clamp_velocity(s.settings, motion.v, motion.w)) ++s.clamped_speeds;
        scratch.velocity[row] = scratch.reference[row] = to_row(motion.v, motion.w);
        const BodyMass& mass = s.mass[std::size_t(b)];
        if (!s.is_dynamic(b)) continue;
        const math::Sym3 i = contact_inverse_inertia(motion, mass);
        scratch.inertia[row] = {mass.inverse_mass, i.xx, i.xy, i.xz, i.yy, i.yz, i.zz, 0};
    }
}

const SolverKernels::ForPoints& kernels_for(const BlockRun& run) {
    return run.four_points ? kernels().solver.four_points : kernels().solver.one_point;
}
void* blocks_of(SolverScratch& scratch, const BlockRun& run) {
    if (run.four_points) return scratch.four_blocks.data() + run.first;
    return scratch.one_blocks.data() + run.first;
}
ContactLanes lanes_of(const SolverScratch& scratch, const BlockRun& run) {
    const LaneLists& lanes = run.four_points ? scratch.four_lanes : scratch.one_lanes;
    const std::size_t at = std::size_t(run.first) * 8;
    return {lanes.record.data() + at, lanes.row_a.data() + at, lanes.row_b.data() + at};
}

// Position of the discrete path behind the stored velocity, see bounce.cpp.
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

void refresh_all(State& s, const SolverBodies& bodies, float h) {
    for (const BlockRun& run : s.solver.runs)
        kernels_for(run).refresh_arms(blocks_of(s.solver, run), run.count, bodies, h);
}

void bounce_all(State& s, const SolverBodies& bodies, const BounceSettings& settings) {
    for (int pass = 0; pass < most_bounce_passes; ++pass) {
        int bounced = 0;
        for (const BlockRun& run : s.solver.runs)
            bounced += kernels_for(run).bounce(blocks_of(s.solver, run), run.count, bodies, settings);
        if (bounced == 0) {
            if (pass > 0) refresh_all(s, bodies, settings.h);
            return;
        }
    }
    refresh_all(s, bodies, settings.h);
}

void run_substeps(State& s, const Bin& bin, float dt) {
    SolverScratch& scratch = s.solver;
    const KernelTable& k = kernels();
    const float h = dt / float(bin.substeps);
    ContactSoftness softness;
    set_softness(softness, h, s.settings.recovery_speed);
    const BounceSettings bounce{h, s.settings.restitution_speed, velocity_offset(s.settings.integrator)};
    const int rows = int(scratch.velocity.size());
    SolverVelocity* velocity = scratch.velocity.data();
    const SolverBodies bodies{velocity,
                              scratch.reference.data(),
                              scratch.rounding.data(),
                              scratch.pose.data(),
                              scratch.inertia.data(),
                              scratch.drive.data(),
                              scratch.damping.empty() ? nullptr : scratch.damping.data(),
                              scratch.correction.empty() ? nullptr : scratch.correction.data()};
    for (int substep = 0; substep < bin.substeps; ++substep) {
        update_free_motion(s, bodies, h, substep == 0);
        k.solver.integrate_velocities(bodies, first_body_row, rows, substep == 0);
        if (bin.bounces) bounce_all(s, bodies, bounce);
        if (substep == 0)
            for (const BlockRun& run : scratch.runs)
                kernels_for(run).warm_start(blocks_of(scratch, run), run.count, velocity);
        for (const BlockRun& run : scratch.runs)
            kernels_for(run).solve(blocks_of(scratch, run), run.count, velocity, softness);
        velocity[discard_row] = {};
        k.solver.integrate_poses(bodies, 0, rows, h);
        turn_spinning_rows(s, h);
        for (const BlockRun& run : scratch.runs)
            kernels_for(run).relax(blocks_of(scratch, run), run.count, bodies, softness);
    }
}

// Moves a body by what its row has moved. What is not finite any more stops where it was, and is counted.
void scatter_body(State& s, std::int32_t b, std::size_t row) {
    const SolverVelocity& velocity = s.solver.velocity[row];
    const SolverPose& pose = s.solver.pose[row];
    BodyMotion& motion = s.motion[std::size_t(b)];
    const math::DVec3 dx = math::to_double(math::Vec3{pose.dx[0], pose.dx[1], pose.dx[2]});
    const math::Quat dq{pose.dq[0], pose.dq[1], pose.dq[2], pose.dq[3]};
    math::Vec3 v{velocity.v[0], velocity.v[1], velocity.v[2]}, w{velocity.w[0], velocity.w[1], velocity.w[2]};
    const math::DVec3 sum = (dx + math::to_double(v)) + math::to_double(w);
    const double sum_q = ((double(dq.x) + dq.y) + dq.z) + dq.w;
    if (0 * ((sum.x + sum.y) + (sum.z + sum_q)) != 0) {
        motion.v = motion.w = {};
        s.turned[std::size_t(b)] = {};
        ++s.clamped_speeds;
        return;
    }
    motion.x += dx;
    motion.q = math::normalized(math::to_double(dq) * motion.q);
    s.turned[std::size_t(b)] = dq;
    motion.v_rest = motion.w_rest = {};
    if (clamp_velocity(s.settings, v, w)) ++s.clamped_speeds;
    motion.v = v;
    motion.w = w;
}

void solve_bin(State& s, const Bin& bin, float dt) {
    const auto start = std::chrono::steady_clock::now();
    SolverScratch& scratch = s.solver;
    const float h = dt / float(bin.substeps);
    gather_bodies(s, bin);
    if (bin.contact_count == 0) return;
    fill_lanes(scratch, bin);
    fill_rows(s);
    prepare_free_motion(s, h, bin.bounces);
    for (const BlockRun& run : scratch.runs)
        kernels_for(run).prepare(blocks_of(scratch, run), run.count, lanes_of(scratch, run), s.records.data(),
                                 scratch.inertia.data(), friction_margin);
    s.statistics.times.prepare +=
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    run_substeps(s, bin, dt);
    finish_free_motion(s);
    for (const BlockRun& run : scratch.runs)
        kernels_for(run).store(blocks_of(scratch, run), run.count, lanes_of(scratch, run), s.records.data(),
                               scratch.reports.data());
    for (std::size_t row = first_body_row; row < scratch.row_bodies.size(); ++row) {
        const std::int32_t b = scratch.row_bodies[row];
        if (b == none) continue;
        scratch.row_of_body[std::size_t(b)] = none;
        if (s.is_dynamic(b)) scatter_body(s, b, row);
    }
}

// Kinematic bodies move by their velocity, once per step, in double.
void move_kinematics(State& s, float dt) {
    for (const std::int32_t b : s.kinematics) {
        BodyMotion& motion = s.motion[std::size_t(b)];
        if (clamp_velocity(s.settings, motion.v, motion.w)) ++s.clamped_speeds;
        const math::DQuat turn = math::from_rotation_vector(double(dt) * math::to_double(motion.w));
        motion.x += double(dt) * math::to_double(motion.v);
        motion.q = math::normalized(turn * motion.q);
        s.turned[std::size_t(b)] = math::to_float(turn);
    }
}

} // namespace

void solve_bins(State& s, float dt) {
    s.solver.free_bodies.clear();
    s.solver.reports.resize(s.records.size());
    s.solver.row_of_body.resize(s.bodies.size(), none);
    for (const Bin& bin : s.solver.bins) solve_bin(s, bin, dt);
    for (const std::int32_t b : s.solver.free_bodies) move_free_body(s, b, dt);
    move_kinematics(s, dt);
}

} // namespace cairn
