// The recorded run of a scene over the steps of its golden hash, optionally with an injected fault.
#pragma once

#include "scenes.h"

#include <string>
#include <vector>

namespace cairn_test {

// The state of a body after a step. Vectors have the meaning of those of cairn::Body.
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

// The state of a world after a step.
struct StepState {
    std::vector<BodyState> bodies; // by slot index
    double energy = 0;             // kinetic and potential, J
    double overlap = 0;            // greatest, m
    double gap = 0, twist = 0;     // greatest error of a joint, m and rad
    glm::dvec3 momentum{0.0};      // N s
};

struct SceneRun {
    cairn::World world;                              // after the last step
    std::vector<StepState> steps;                    // the first: before any step
    int entered = 0, left = 0, broken = 0, hits = 0; // events of triggers, joints, contacts
    int in_triggers = 0;    // shapes in triggers, queried before the last step, which is when events are found
    float broken_force = 0; // N, when the last joint broke

    const StepState& first() const { return steps.front(); }
    const StepState& last() const { return steps.back(); }
};

// Faults injected into a world, to see which invariants detect them.
enum class Fault {
    none,
    half_gravity,
    no_friction,
    bouncy,      // restitution 1
    no_contacts, // no collisions
    no_sleep,
    coarse,        // one substep
    slow_clock,    // steps of 1/80 s
    deaf_triggers, // triggers without collisions
    weak_joints,   // every second joint breaks at 1 kN
    kick,          // halfway, every dynamic body by up to 30 m/s along each axis
};
inline constexpr Fault all_faults[] = {Fault::half_gravity, Fault::no_friction, Fault::bouncy,     Fault::no_contacts,
                                       Fault::no_sleep,     Fault::coarse,      Fault::slow_clock, Fault::deaf_triggers,
                                       Fault::weak_joints,  Fault::kick};
const char* name_of(Fault fault);

SceneRun run_scene(Scene& scene, Fault fault = Fault::none);

} // namespace cairn_test
