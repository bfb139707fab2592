/// \file integrators.h
/// The integrators that a world knows (cairn::Integrator), on systems whose exact solution is known: what they do to
/// the energy, and how their error shrinks with the step. In double precision, so that the method is seen and not the
/// rounding.
#pragma once

#include "viewer/chart.h"

#include <cairn/world.h>

#include <array>
#include <cstddef>
#include <vector>

namespace cairn::viewer {

enum class LabSystem {
    spring,   ///< A mass on a spring with a period of 1 s, let go 1 m from its middle.
    pendulum, ///< 1 m long, let go at rest 2 rad from below.
    orbit,    ///< Around a sun, with an eccentricity of 0.5, a half axis of 1 and a period of 1.
    top,      ///< A spinning top, a little aslant and let go at rest: its tip from above, in units of that tilt.
};
inline constexpr std::array lab_systems{LabSystem::spring, LabSystem::pendulum, LabSystem::orbit, LabSystem::top};
const char* name_of(LabSystem system);
const char* explanation_of(LabSystem system); ///< A sentence with the equation of motion.

/// In the order in which they are shown.
inline constexpr std::array lab_integrators{Integrator::explicit_euler, Integrator::semi_implicit_euler,
                                            Integrator::rk4};
const char* name_of(Integrator integrator);
std::uint32_t color_of(Integrator integrator); ///< 0xRRGGBB.
const char* formula_of(Integrator integrator); ///< What a step of length h does.

/// Place and velocity; of the pendulum angle and rate, and nothing in y.
struct LabState {
    std::array<double, 2> place{}, velocity{};
};

LabState start_of(LabSystem system);
double period_of(LabSystem system); ///< s.
double energy_of(LabSystem system,
                 const LabState& state); ///< J per kg, above the lowest that is possible; of the orbit its distance
                                         ///< from the escape, of the top from upright.
LabState exact(LabSystem system, double time);
/// One step of `h` seconds.
LabState step(LabSystem system, Integrator integrator, const LabState& state, double h);
/// Where it is drawn: x and y in units of the system's size.
std::array<double, 2> drawn_place(LabSystem system, const LabState& state);

/// The states after 0, 1, 2 ... steps.
std::vector<LabState> trajectory(LabSystem system, Integrator integrator, double h, double seconds);
/// The greatest distance from the exact solution during `seconds`.
double greatest_error(LabSystem system, Integrator integrator, double h, double seconds);

/// By how much of that at the start the energy has changed, %, until `seconds`.
Chart energy_chart(LabSystem system, double h, double seconds);
/// The greatest error in one period against the length of a step, with the slopes in the labels.
Chart error_chart(LabSystem system);

} // namespace cairn::viewer
