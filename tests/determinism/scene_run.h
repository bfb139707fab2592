// A scene run for the steps of its golden hash, with all that was seen of it; and the same with a fault put in.
#pragma once

#include "scenes.h"

#include <string>
#include <vector>

namespace cairn_test {

// A body after a step. Vectors as of cairn::Body.
struct BodyState {
    bool exists = false;
    cairn::BodyType type{};
    bool is_awake = false;
    double mass = 0, kinetic_energy = 0;
    cairn::Position position{}, center{};
    cairn::Quat rotation{1, 0, 0, 0};
    cairn::Vec3 velocity{}, spin{}, angular_momentum{};

    bool is_dynamic() const { return exists && type == cairn::BodyType::dynamic; }
};

// A world after a step.
struct StepState {
    std::vector<BodyState> bodies; // by index of their slots
    double energy = 0;             // J, kinetic and potential
    double overlap = 0;            // m, the deepest
    double gap = 0, twist = 0;     // m and rad, of the joint that has come apart farthest
    glm::dvec3 momentum{0.0};      // N s
};

struct SceneRun {
    cairn::World world;                              // after the last step
    std::vector<StepState> steps;                    // the first: before any step
    int entered = 0, left = 0, broken = 0, hits = 0; // events: of triggers, joints and contacts
    int in_triggers = 0;    // shapes in triggers, by a query before the last step, which is when its events are found
    float broken_force = 0; // N, at which the last joint broke

    const StepState& first() const { return steps.front(); }
    const StepState& last() const { return steps.back(); }
};

// What is done to the world to see which invariants notice.
enum class Fault {
    none,
    half_gravity,
    no_friction,
    bouncy,      // restitution 1
    no_contacts, // nothing meets anything
    no_sleep,
    coarse,        // one substep
    slow_clock,    // steps of 1/80 s
    deaf_triggers, // that meet nothing
    weak_joints,   // every second one breaks at 1 kN
    kick,          // in the middle, every dynamic body by up to 30 m/s along each axis
};
inline constexpr Fault all_faults[] = {Fault::half_gravity, Fault::no_friction, Fault::bouncy,     Fault::no_contacts,
                                       Fault::no_sleep,     Fault::coarse,      Fault::slow_clock, Fault::deaf_triggers,
                                       Fault::weak_joints,  Fault::kick};
const char* name_of(Fault fault);

SceneRun run_scene(Scene& scene, Fault fault = Fault::none);

} // namespace cairn_test
