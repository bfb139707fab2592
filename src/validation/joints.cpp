// Pendulums, a gyroscope, a chain and a net: bodies held by joints.
#include "validation/cases.h"
#include "validation/joined_worlds.h"
#include "validation/measures.h"
#include "validation/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn::validation {

namespace {

// --- pendulum

// T = 2 pi sqrt(L / g) / agm(1, cos(angle / 2)), with the arithmetic-geometric mean (Gauss), s.
double exact_period(double length, double angle) {
    double a = 1, g = std::cos(angle / 2);
    for (int i = 0; i < 10; ++i) {
        const double mean = (a + g) / 2;
        g = std::sqrt(a * g);
        a = mean;
    }
    return 2 * pi * std::sqrt(length / gravity) / a;
}

// Period of a hinged box of 0.1 m as the mean of 10 periods. Its moment of inertia is taken into account: the distance
// d from the hinge is such that it swings like a point mass at 1 m: d + (0.01 / 6) / d = 1.
double measured_period(double degrees, double step, JointSolver solver) {
    World world(without_sleep());
    const double angle = radians(degrees), distance = 0.5 * (1 + std::sqrt(1 - 4 * 0.01 / 6));
    const BodyId bob = add_dynamic(world, Box{{0.05f, 0.05f, 0.05f}},
                                   {distance * std::sin(angle), -distance * std::cos(angle), 0}, 1, float(angle));
    hold(world, BodyId{}, bob, {0, 0, 0}, HingeJoint{}, solver);
    double before = angle, first = 0, last = 0;
    int crossings = 0;
    for (int i = 1; crossings < 11; ++i) {
        if (world.time() > 100) return std::nan("");
        world.step(float(step));
        const Position at = world.body(bob).position();
        const double now = std::atan2(at.x, -at.y);
        if (before < 0 && now >= 0) {
            last = (i - now / (now - before)) * double(float(step));
            if (crossings++ == 0) first = last;
        }
        before = now;
    }
    return (last - first) / 10;
}

// The default solver, and the direct solver.
struct NamedSolver {
    JointSolver solver;
    const char* suffix;
};
constexpr NamedSolver solvers[] = {{JointSolver::automatic, ""}, {JointSolver::direct, ", direct solver"}};

void add_pendulum_rows(Result& result) {
    for (const NamedSolver& by : solvers)
        for (const double degrees : {1.0, 10.0, 30.0, 45.0, 90.0, 150.0})
            for (const double step : time_steps)
                result.rows.push_back({"period at an amplitude of " + text(degrees) + " degrees, s" + by.suffix, step,
                                       exact_period(1, radians(degrees)), measured_period(degrees, step, by.solver),
                                       1e-3, Bar::relative, ""});
}

void add_pendulum_plots(Result& result) {
    Plot period{"Pendulum: period versus amplitude", "amplitude, degrees", "period, s", false, false, {}};
    Curve exact{"expected: 2 pi sqrt(L / g) / agm(1, cos(amplitude / 2))", {}, {}, false};
    for (int degrees = 1; degrees <= 165; ++degrees) {
        exact.x.push_back(degrees);
        exact.y.push_back(exact_period(1, radians(degrees)));
    }
    Curve measured{"measured, steps of 1/60 s", {}, {}, true};
    Plot error{"Pendulum: error of the period, steps of 1/60 s", "amplitude, degrees", "error, %", false, false, {}};
    for (const bool direct : {false, true}) {
        Curve line{direct ? "direct solver" : "iterative solver", {}, {}, true};
        for (int degrees = 10; degrees <= 165; degrees += degrees < 120 ? 20 : 5) {
            const double expected = exact_period(1, radians(degrees));
            const double period_seen =
                measured_period(degrees, 1.0 / 60, direct ? JointSolver::direct : JointSolver::iterative);
            line.x.push_back(degrees);
            line.y.push_back(100 * (period_seen / expected - 1));
            if (direct) continue;
            measured.x.push_back(degrees);
            measured.y.push_back(period_seen);
        }
        error.curves.push_back(line);
    }
    period.curves = {exact, measured};
    result.plots.push_back(period);
    result.plots.push_back(error);
}

// Semi-implicit Euler stores the velocities of half a substep earlier: the energy of the path is computed with
// velocities advanced by that time.
void add_double_pendulum_rows(Result& result) {
    constexpr double seconds = 60, swing = 2 * 9.81; // J, between the start and the lowest state at rest
    Plot plot{"Double pendulum from the horizontal: energy",
              "time, s",
              "change, % of the energy of the swing",
              false,
              false,
              {}};
    for (const double step : time_steps) {
        World world(without_sleep());
        const DoublePendulum pendulum = add_double_pendulum(world, JointSolver::direct);
        double least = 0, greatest = -std::numeric_limits<double>::infinity();
        Curve curve{"steps of " + step_text(step) + " s", {}, {}, false};
        const int steps = steps_in(seconds, step), every = std::max(1, steps / 300);
        for (int i = 1; i <= steps; ++i) {
            world.step(float(step));
            const double half = 0.5 * step / world.statistics().max_substeps;
            double energy = world.kinetic_energy() + world.potential_energy();
            for (const BodyId rod : pendulum.rods)
                energy -= half * gravity * double(world.body(rod).linear_velocity().y);
            least = std::min(least, energy / swing), greatest = std::max(greatest, energy / swing);
            if (i % every != 0) continue;
            curve.x.push_back(i * step);
            curve.y.push_back(100 * energy / swing);
        }
        result.rows.push_back(
            {"double pendulum, direct solver, 60 s: greatest gain of energy, relative to that of the swing", step, 0,
             greatest, 1e-4, Bar::at_most, ""});
        result.rows.push_back(
            {"double pendulum, direct solver, 60 s: greatest loss of energy, relative to that of the swing", step, 0,
             -least, 0.02, Bar::at_most, ""});
        plot.curves.push_back(curve);
    }
    result.plots.push_back(plot);
}

} // namespace

Result measure_pendulum() {
    Result result;
    add_pendulum_rows(result);
    add_pendulum_plots(result);
    add_double_pendulum_rows(result);
    return result;
}

// --- gyroscope

namespace {

constexpr double arm = 0.1, axial_moment = 0.005; // m; kg m^2 of a disk of 1 kg and 0.1 m

struct Precession {
    double rate = 0;
    std::vector<double> times, angles, heights; // s, rad, mm
};

// The gyroscope is released in steady precession: its rate is m g arm / (I spin).
Precession precess(double spin, double step, double seconds, JointSolver solver) {
    World world(without_sleep());
    const double rate = gravity * arm / (axial_moment * spin);
    BodyDef def;
    def.position = {arm, 0, 0};
    MassProperties disk;
    disk.inertia_diagonal = {float(axial_moment), float(axial_moment / 2), float(axial_moment / 2)};
    def.mass_properties = disk;
    def.angular_velocity = {float(spin), float(rate), 0};
    def.linear_velocity = {0, 0, float(-arm * rate)};
    const BodyId body = world.create_body(def);
    hold(world, BodyId{}, body, {0, 0, 0}, BallJoint{}, solver);
    Precession result;
    double turned = 0, before = 0;
    const int steps = steps_in(seconds, step), every = std::max(1, steps / 200);
    for (int i = 1; i <= steps; ++i) {
        world.step(float(step));
        const Position at = world.body(body).position();
        const double now = std::atan2(-at.z, at.x);
        turned += std::remainder(now - before, 2 * pi);
        before = now;
        if (i % every != 0) continue;
        result.times.push_back(i * step);
        result.angles.push_back(turned);
        result.heights.push_back(1000 * at.y);
    }
    result.rate = turned / (steps * double(float(step)));
    return result;
}

} // namespace

Result measure_gyroscope() {
    constexpr double seconds = 5;
    Result result;
    Plot turn{"Gyroscope: precession, steps of 1/60 s", "time, s", "angle, rad", false, false, {}};
    Plot height{"Gyroscope: height of the disk, steps of 1/60 s", "time, s", "height, mm", false, false, {}};
    for (const double spin : {200.0, 100.0}) {
        const double rate = gravity * arm / (axial_moment * spin);
        const std::string label = "at " + text(spin) + " rad/s";
        for (const NamedSolver& by : solvers)
            for (const double step : time_steps)
                result.rows.push_back({"rate of precession " + label + ", rad/s" + by.suffix, step, rate,
                                       precess(spin, step, seconds, by.solver).rate, 0.01, Bar::relative, ""});
        const Precession seen = precess(spin, 1.0 / 60, seconds, JointSolver::automatic);
        turn.curves.push_back({"expected " + label, {0, seconds}, {0, rate * seconds}, false});
        Curve points{label, {}, {}, true};
        for (std::size_t i = 0; i < seen.times.size(); i += 10) {
            points.x.push_back(seen.times[i]);
            points.y.push_back(seen.angles[i]);
        }
        turn.curves.push_back(points);
        height.curves.push_back({label, seen.times, seen.heights, false});
    }
    result.plots = {turn, height};
    return result;
}

// --- chain and net

namespace {

// The greatest stretch of any link during the swing.
struct Stretch {
    double greatest = 0;
    std::vector<double> times, gaps; // s, mm
};

Stretch watch(World& world, double step, double seconds) {
    Stretch result;
    const int steps = steps_in(seconds, step), every = std::max(1, steps / 150);
    double since_last = 0;
    for (int i = 1; i <= steps; ++i) {
        world.step(float(step));
        const double gap = greatest_gap(world);
        if (!std::isfinite(gap)) {
            result.greatest = gap;
            return result;
        }
        result.greatest = std::max(result.greatest, gap);
        since_last = std::max(since_last, gap);
        if (i % every != 0) continue;
        result.times.push_back(i * step);
        result.gaps.push_back(1000 * since_last);
        since_last = 0;
    }
    return result;
}

void add_chain_rows(Result& result) {
    constexpr double seconds = 10;
    Plot plot{"Chain of 20 links of 1 kg with 1,000 kg at its end", "time, s", "greatest gap, mm", false, false, {}};
    for (const double step : time_steps) {
        World world(without_sleep());
        const Chain chain = add_chain(world, 20, 1000);
        world.body(chain.ball).set_linear_velocity({5, 0, 0});
        const double swing = world.kinetic_energy(), start = swing + world.potential_energy();
        const Stretch seen = watch(world, step, seconds);
        const double change = world.kinetic_energy() + world.potential_energy() - start;
        result.rows.push_back(
            {"chain with 1,000 times a link's mass at its end: greatest gap, relative to a link's length", step, 0,
             seen.greatest / link_length, 0.01, Bar::at_most, ""});
        result.rows.push_back({"chain: change of energy in 10 s, relative to that of the swing", step, 0,
                               change / swing, 0.02, Bar::absolute, ""});
        plot.curves.push_back({"steps of " + step_text(step) + " s", seen.times, seen.gaps, false});
    }
    result.plots.push_back(plot);
}

void add_net_rows(Result& result) {
    constexpr double step = 1.0 / 60, seconds = 5;
    Plot plot{"Net of 64 x 64 balls 1 m apart, steps of 1/60 s", "time, s", "greatest gap, mm", false, false, {}};
    for (const bool swings : {false, true}) {
        World world(without_sleep());
        add_net(world, 64, swings ? glm::dvec3(0, 0, 1) : glm::dvec3(0, -1, 0));
        const Stretch seen = watch(world, step, seconds);
        const std::string what = swings ? "falls from the horizontal" : "hangs";
        result.rows.push_back({"net of 64 x 64 " + what + ", 5 s: greatest gap, relative to the spacing", step, 0,
                               seen.greatest, 0.01, Bar::at_most,
                               swings ? "if it swings on, its lower edge whips and opens a joint by 2 % at 11 s" : ""});
        plot.curves.push_back({what, seen.times, seen.gaps, false});
    }
    result.plots.push_back(plot);
}

} // namespace

Result measure_chain_and_net() {
    Result result;
    add_chain_rows(result);
    add_net_rows(result);
    return result;
}

} // namespace cairn::validation
