/// \file impact.h
/// One impact of a run with the numbers of the textbook's formula for it: the impulse of two rigid bodies that meet at
/// a point without friction, beside what the engine gave.
#pragma once

#include <cairn/world.h>

#include <cstdint>
#include <optional>
#include <string>

namespace cairn::viewer {

/// An impact that happened, and how many steps were made then.
struct KnownHit {
    std::uint64_t step = 0;
    ContactHit hit;
};

/// One of the two bodies, all in world axes.
struct ImpactSide {
    BodyId body;
    std::string name;
    double inverse_mass = 0.0;       ///< 1/kg; 0: it cannot be pushed.
    Vec3 arm{0.0f, 0.0f, 0.0f};      ///< r: from the center of mass to the point, m.
    Vec3 velocity{0.0f, 0.0f, 0.0f}; ///< v before, m/s.
    Vec3 turning{0.0f, 0.0f, 0.0f};  ///< w before, rad/s.
    Vec3 at_point{0.0f, 0.0f, 0.0f}; ///< v + w x r, m/s.
    double turn_term = 0.0;          ///< sN ((I^-1 (r x sN)) x r), 1/kg.
    Vec3 velocity_then{0.0f, 0.0f, 0.0f}, turning_then{0.0f, 0.0f, 0.0f};   ///< After, by the formula.
    Vec3 velocity_after{0.0f, 0.0f, 0.0f}, turning_after{0.0f, 0.0f, 0.0f}; ///< After the step, in the run.
};

struct Impact {
    std::uint64_t step = 0;        ///< Steps made when its step was over.
    double time = 0.0;             ///< s, from the beginning of that step.
    Position point{0.0, 0.0, 0.0}; ///< m
    Vec3 normal{0.0f, 1.0f, 0.0f}; ///< sN: unit, from the second body to the first.
    double restitution = 0.0;      ///< e
    double relative_speed = 0.0;   ///< vr: along the normal before the step, m/s; < 0, as they approach.
    double denominator = 0.0;      ///< 1/kg
    double impulse = 0.0;          ///< j, N s.
    double given = 0.0;            ///< N s: the first body's change of momentum along the normal, less gravity's.
    ImpactSide first, second;
};

/// The ratio of rebound to approach speed between two surfaces.
double restitution_between(const Material& a, const Material& b);

/// Takes the step of an impact: `world` stands before it. Where the first body of the hit cannot be pushed, the two
/// change places.
Impact explain_impact(World& world, const KnownHit& known, float step_length);

} // namespace cairn::viewer
