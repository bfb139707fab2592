/// \file impact.h
/// One impact of a run, with the numbers of the textbook formula for it: the impulse between two rigid bodies that
/// collide frictionlessly at one point, beside the impulse that the engine applied.
#pragma once

#include <cairn/world.h>

#include <cstdint>
#include <optional>
#include <string>

namespace cairn::viewer {

/// An impact, and the step number after it.
struct KnownHit {
    std::uint64_t step = 0;
    ContactHit hit;
};

/// One of the two bodies; vectors in world axes.
struct ImpactSide {
    BodyId body;
    std::string name;
    double inverse_mass = 0.0;               ///< 1/kg; 0: impulses cannot move it.
    Vec3 arm{0.0f, 0.0f, 0.0f};              ///< r: from the center of mass to the contact point, m.
    Vec3 velocity{0.0f, 0.0f, 0.0f};         ///< v before, m/s.
    Vec3 angular_velocity{0.0f, 0.0f, 0.0f}; ///< w before, rad/s.
    Vec3 at_point{0.0f, 0.0f, 0.0f};         ///< Velocity of the contact point: v + w x r, m/s.
    double turn_term = 0.0;                  ///< sN ((I^-1 (r x sN)) x r), 1/kg.
    Vec3 velocity_then{0.0f, 0.0f, 0.0f}, turning_then{0.0f, 0.0f, 0.0f};   ///< After, by the formula.
    Vec3 velocity_after{0.0f, 0.0f, 0.0f}, turning_after{0.0f, 0.0f, 0.0f}; ///< After the step, in the run.
};

struct Impact {
    std::uint64_t step = 0;        ///< Step number after the step of the impact.
    double time = 0.0;             ///< Time from the beginning of that step, s.
    Position point{0.0, 0.0, 0.0}; ///< m
    Vec3 normal{0.0f, 1.0f, 0.0f}; ///< sN: unit, from the second body to the first.
    double restitution = 0.0;      ///< e
    double relative_speed = 0.0; ///< vr: normal relative velocity before the step, m/s; < 0, since the bodies approach.
    double denominator = 0.0;    ///< 1/kg
    double impulse = 0.0;        ///< j, N s.
    double given = 0.0;          ///< N s: the first body's change of momentum along the normal, minus that by gravity.
    ImpactSide first, second;
};

/// The coefficient of restitution between two surfaces: separation speed over approach speed.
double restitution_between(const Material& a, const Material& b);

/// Explains an impact by taking its step: `world` must be in the state before it. If impulses cannot move the first
/// body of the hit, the two bodies are swapped.
Impact explain_impact(World& world, const KnownHit& known, float step_length);

} // namespace cairn::viewer
