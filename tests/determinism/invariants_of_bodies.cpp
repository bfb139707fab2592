// Invariants of the scenes of boxes and balls.
#include "invariants.h"
#include "measures.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cairn_test {

using namespace cairn;
namespace {

// --- mixed_pile

double in_the_pit(const SceneRun& run) {
    return count_at_end(run, [](const BodyState& b) {
        return std::fabs(b.center.x) < 4 && std::fabs(b.center.z) < 4 && b.center.y > 0;
    });
}

double energy_left(const SceneRun& run) {
    double energy = 0;
    for_dynamic(run, golden_steps, [&](const BodyState& b, int) { energy += b.kinetic_energy; });
    return energy;
}
double mean_height(const SceneRun& run) { // center of mass of all bodies, m
    double moment = 0;
    for_dynamic(run, golden_steps, [&](const BodyState& b, int) { moment += b.mass * b.center.y; });
    return moment / total_mass(run, golden_steps);
}
// The height of the heap relative to a block of its volume (all densities are 1000 kg/m^3, the pit is 8 m x 8 m).
double bulk_of_pile(const SceneRun& run) {
    const double volume = total_mass(run, golden_steps) / 1000;
    return 2 * mean_height(run) / (volume / 64);
}

// --- pyramid: bricks are bodies 1 to 78, row by row; the ball is body 79

constexpr int before_ball = 80;

double top_brick_sinks(const SceneRun& run) { return 11.5 - body_at(run, before_ball, 78).center.y; }
double bricks_slide(const SceneRun& run) {
    double most = 0;
    for (int i = 1; i <= 78; ++i) {
        const Position d = body_at(run, before_ball, i).center - body_at(run, 0, i).center;
        most = std::max(most, std::hypot(d.x, d.z));
    }
    return most;
}
double bricks_knocked_out(const SceneRun& run) {
    double count = 0;
    for (int i = 1; i <= 78; ++i) {
        const Position d = body_at(run, golden_steps, i).center - body_at(run, before_ball, i).center;
        count += glm::length(d) > 1;
    }
    return count;
}
// The reaction of the floor may push the rebounding bodies forward.
double greatest_momentum(const SceneRun& run) { // along the flight of the ball, relative to the start
    double most = 0;
    for (const StepState& step : run.steps) most = std::max(most, step.momentum.z / run.first().momentum.z);
    return most;
}

// --- dominoes: bodies 1 to 40, in the order of the row

constexpr int after_push = 21;

int falls_at(const SceneRun& run, int domino) { // first step with an inclination of 45 degrees
    for (int step = 0; step <= golden_steps; ++step)
        if (uprightness(body_at(run, step, domino)) < 0.7071) return step;
    return golden_steps;
}
double dominoes_fallen(const SceneRun& run) {
    return count_at_end(run, [](const BodyState& b) { return uprightness(b) < 0.5; });
}
double dominoes_out_of_order(const SceneRun& run) {
    double count = 0;
    for (int i = 2; i <= 40; ++i) count += falls_at(run, i) <= falls_at(run, i - 1);
    return count;
}
double steps_per_domino(const SceneRun& run) { return (falls_at(run, 40) - falls_at(run, 1)) / 39.0; }

// --- materials

double height_above_slope(const SceneRun& run) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.1, 1, 0.05));
    double least = 1e9;
    for (int step = 0; step <= golden_steps; ++step)
        for_dynamic(run, step, [&](const BodyState& b, int) { least = std::min(least, glm::dot(normal, b.center)); });
    return least;
}
// The median, since one of the bodies passes close to the center of the field, which accelerates it far off, to another
// place in each variant.
double median_way_downhill(const SceneRun& run) {
    const glm::dvec3 downhill = glm::normalize(glm::dvec3(0.1, 0, 0.05));
    std::vector<double> ways;
    for_dynamic(run, golden_steps, [&](const BodyState& b, int i) {
        ways.push_back(glm::dot(downhill, b.center - body_at(run, 0, i).center));
    });
    std::nth_element(ways.begin(), ways.begin() + std::ptrdiff_t(ways.size() / 2), ways.end());
    return ways[ways.size() / 2];
}
double hits(const SceneRun& run) { return run.hits; }

// --- tumbler: the drum is body 0; the inside of its walls is 2.75 m from the center

double out_of_drum(const SceneRun& run) {
    double farthest = 0;
    for (int step = 0; step <= golden_steps; ++step) {
        const BodyState& drum = body_at(run, step, 0);
        for_dynamic(run, step, [&](const BodyState& b, int) {
            const Vec3 p = glm::conjugate(drum.rotation) * Vec3(b.center - drum.position);
            for (int axis = 0; axis < 3; ++axis) farthest = std::max(farthest, std::fabs(double(p[axis])));
        });
    }
    return farthest;
}
double load_below_axis(const SceneRun& run) { // m, mean over the last eight seconds
    double sum = 0, count = 0;
    for (int step = 120; step <= golden_steps; ++step)
        for_dynamic(run, step, [&](const BodyState& b, int) { sum += 4 - b.center.y, count += 1; });
    return sum / count;
}
double drum_turns(const SceneRun& run) { // rad about its axis, at its first speed
    const Quat turn = body_at(run, 40, 0).rotation * glm::conjugate(body_at(run, 0, 0).rotation);
    return 2 * std::atan2(double(turn.z), double(turn.w));
}

// --- sleep_and_wake: stacks of five, bodies 1 + 5 stack + i

double asleep_before_ball(const SceneRun& run) { return asleep_at(run, 119); }
double woken_by_ball(const SceneRun& run) {
    double count = 0;
    for (int i = 1; i <= 30; ++i) {
        bool is_woken = false;
        for (int step = 120; step < 160; ++step) is_woken |= body_at(run, step, i).is_awake;
        count += is_woken;
    }
    return count;
}
double lean_of_untouched_stacks(const SceneRun& run) {
    double most = 0;
    for (const int stack : {1, 2, 4})
        for (int i = 0; i < 5; ++i) {
            const Position d = body_at(run, golden_steps, 1 + 5 * stack + i).center - Position(4.0 * stack, 0.5 + i, 0);
            most = std::max(most, glm::length(d));
        }
    return most;
}
double drop_of_stack_without_foot(const SceneRun& run) {
    return body_at(run, 159, 30).center.y - body_at(run, golden_steps, 30).center.y;
}

// --- free_tops: they start in a crowd, and hardly collide after four seconds

constexpr int apart = 240;
constexpr double weight = 1; // downward, m/s^2

double momentum_error(const SceneRun& run) { // besides gravity, relative to its impulse
    const double given = weight * total_mass(run, 0) * golden_steps / 60;
    const glm::dvec3 d = run.last().momentum - run.first().momentum + glm::dvec3(0, given, 0);
    return glm::length(d) / given;
}
bool is_pushed(const SceneRun& run, int step, int body) { // by anything except gravity
    const Vec3 change = body_at(run, step, body).velocity - body_at(run, step - 1, body).velocity;
    return glm::length(change + Vec3(0, float(weight / 60), 0)) > 1e-4f;
}
// The last step after `apart` in which the body collided with another: in such a step few bodies are accelerated.
int last_hit(const SceneRun& run, int body) {
    for (int step = golden_steps; step > apart; --step) {
        if (!is_pushed(run, step, body)) continue;
        int pushed = 0;
        for_dynamic(run, step, [&](const BodyState&, int i) { pushed += is_pushed(run, step, i); });
        if (pushed < 8) return step;
    }
    return apart;
}
double spin_error(const SceneRun& run) { // greatest relative error of the angular momentum of a body
    double most = 0;
    for_dynamic(run, golden_steps, [&](const BodyState& b, int i) {
        const Vec3 before = body_at(run, last_hit(run, i), i).angular_momentum;
        most = std::max(most, double(glm::length(b.angular_momentum - before) / glm::length(before)));
    });
    return most;
}
double energy_of_spin_error(const SceneRun& run) {
    const auto spin_energy = [](const BodyState& b) { return 0.5 * double(glm::dot(b.spin, b.angular_momentum)); };
    double most = 0;
    for_dynamic(run, golden_steps, [&](const BodyState& b, int i) {
        const double before = spin_energy(body_at(run, last_hit(run, i), i));
        most = std::max(most, std::fabs(spin_energy(b) - before) / before);
    });
    return most;
}
double fall_error(const SceneRun& run) { // m, mean of all
    double sum = 0;
    constexpr double t = (golden_steps - apart) / 60.0;
    for_dynamic(run, golden_steps, [&](const BodyState& b, int i) {
        const BodyState& before = body_at(run, apart, i);
        sum += b.center.y - before.center.y - double(before.velocity.y) * t + 0.5 * weight * t * t;
    });
    return std::fabs(sum) / 64;
}

template <int step> double overlap(const SceneRun& run) { return overlap_from(run, step); }
template <int step> double usual_overlap(const SceneRun& run) { return usual_overlap_from(run, step); }
template <int step> double energy_gain(const SceneRun& run) { return energy_gain_from(run, step); }

constexpr Invariant table[] = {
    {"mixed_pile", "bodies between the walls", in_the_pit, 240, 240},
    {"mixed_pile", "height over that of its volume in one block", bulk_of_pile, 1, 3},
    // The greatest overlap is at a single corner: in 100 runs with slightly different gravity 2 to 12 mm, median 5 mm.
    {"mixed_pile", "deepest overlap after 5 s, m", overlap<300>, 0, 0.012},
    {"mixed_pile", "energy gained once the overlaps of the start are gone", energy_gain<60>, 0, 1e-6},
    {"mixed_pile", "kinetic energy at the end, of 450 kJ that it fell with, J", energy_left, 0, 30},
    {"pyramid", "top brick has sunk before the ball, m", top_brick_sinks, -0.001, 0.005},
    {"pyramid", "bricks have slid before the ball, m", bricks_slide, 0, 0.013},
    {"pyramid", "bricks knocked away by the ball", bricks_knocked_out, 33, 77},
    {"pyramid", "energy gained", energy_gain<0>, 0, 1e-6},
    {"pyramid", "greatest momentum along the ball's flight, part of its first", greatest_momentum, 0, 1.008},
    {"pyramid", "lowest center, m", lowest_center, 0.46, 0.5},
    {"dominoes", "dominoes fallen", dominoes_fallen, 40, 40},
    {"dominoes", "dominoes fallen no later than the one behind them", dominoes_out_of_order, 0, 1},
    {"dominoes", "steps from one fall to the next", steps_per_domino, 5, 9},
    {"dominoes", "energy gained after the push", energy_gain<after_push>, 0, 1e-6},
    {"dominoes", "bodies asleep at the end", asleep_at_end, 40, 40},
    {"materials", "least height of a center above the slope, m", height_above_slope, 0.29, 0.301},
    // In 48 runs with slightly different gravity 0.01 to 0.24 m.
    {"materials", "median way downhill, m", median_way_downhill, 0.005, 0.3},
    // The greatest overlap of all steps occurs in an impact: in 24 runs with slightly different gravity 6 to 32 mm.
    {"materials", "usual deepest overlap after 1 s, m", usual_overlap<60>, 0, 0.0012},
    {"materials", "hits", hits, 121, 484},
    {"tumbler", "farthest center from the middle of the drum, m", out_of_drum, 0, 2.75},
    {"tumbler", "load below the axis of the drum, m", load_below_axis, 1.1, 2.75},
    {"tumbler", "angle of the drum after 40 steps, rad", drum_turns, 0.599, 0.601},
    // The greatest overlap of all steps is at a single corner: in drums with 300 to 800 bodies 15 to 96 mm.
    {"tumbler", "usual deepest overlap after 1 s, m", usual_overlap<60>, 0, 0.002},
    {"tumbler", "greatest speed, m/s", fastest, 0, 13},
    {"sleep_and_wake", "bodies asleep before the ball comes", asleep_before_ball, 30, 30},
    {"sleep_and_wake", "bodies woken by ball and push", woken_by_ball, 10, 10},
    {"sleep_and_wake", "displacement in stacks that nothing touches, m", lean_of_untouched_stacks, 0, 0.0029},
    {"sleep_and_wake", "fall of the stack that loses its foot, m", drop_of_stack_without_foot, 0.99, 1.01},
    {"compounds", "lowest center, m", lowest_center, 0.12, 0.25},
    {"compounds", "energy gained", energy_gain<0>, 0, 1e-6},
    {"compounds", "deepest overlap after 6 s, m", overlap<360>, 0, 0.008},
    {"compounds", "bodies asleep at the end", asleep_at_end, 6, 36},
    {"free_tops", "momentum beside that of gravity, part of it", momentum_error, 0, 5e-5},
    {"free_tops", "change of an angular momentum in flight, relative", spin_error, 0, 1e-5},
    {"free_tops", "change of the energy of a spin in flight, relative", energy_of_spin_error, 0, 1e-5},
    {"free_tops", "error of the fall in 6 s, m", fall_error, 0, 2e-5},
};

} // namespace

std::span<const Invariant> invariants_of_bodies() { return table; }

} // namespace cairn_test
