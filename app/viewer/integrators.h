/// \file integrators.h
/// The integrators of a world (cairn::Integrator) on systems with a known exact solution: their effect on the energy,
/// and the order of their error. In double precision, so that the error of the method is not hidden by rounding.
#pragma once

#include "viewer/chart.h"

#include <cairn/world.h>

#include <array>
#include <cstddef>
#include <vector>

namespace cairn::viewer {

enum class LabSystem {
    spring,   ///< A mass on a spring with a period of 1 s, released 1 m from equilibrium.
    pendulum, ///< 1 m long, released at rest 2 rad from the lowest position.
    orbit,    ///< Around a fixed sun, with eccentricity 0.5, semi-major axis 1 and period 1.
    top,      ///< A spinning top, released at rest with a small tilt: its tip seen from above, in units of that tilt.
};
inline constexpr std::array lab_systems{LabSystem::spring, LabSystem::pendulum, LabSystem::orbit, LabSystem::top};
const char* name_of(LabSystem system);
const char* explanation_of(LabSystem system); ///< A sentence with the equation of motion.

/// In display order.
inline constexpr std::array lab_integrators{Integrator::explicit_euler, Integrator::semi_implicit_euler,
                                            Integrator::rk4};
const char* name_of(Integrator integrator);
std::uint32_t color_of(Integrator integrator); ///< 0xRRGGBB.
const char* formula_of(Integrator integrator); ///< The formula of a step of length h.

/// Position and velocity; for the pendulum, angle and angular velocity in x, and zero in y.
struct LabState {
    std::array<double, 2> place{}, velocity{};
};

LabState start_of(LabSystem system);
double period_of(LabSystem system); ///< s.
/// Energy in J per kg, above the lowest possible one; of the orbit relative to the escape energy, of the top to the
/// upright state.
double energy_of(LabSystem system, const LabState& state);
LabState exact(LabSystem system, double time);
/// One step of `h` seconds.
LabState step(LabSystem system, Integrator integrator, const LabState& state, double h);
/// Position at which the state is drawn: x and y in units of the system's size.
std::array<double, 2> drawn_place(LabSystem system, const LabState& state);

/// The states after 0, 1, 2 ... steps.
std::vector<LabState> trajectory(LabSystem system, Integrator integrator, double h, double seconds);
/// The greatest distance from the exact solution during `seconds`.
double greatest_error(LabSystem system, Integrator integrator, double h, double seconds);

/// Relative change of the energy since the start, %, until `seconds`.
Chart energy_chart(LabSystem system, double h, double seconds);
/// The greatest error in one period against the step length, with the slopes in the labels.
Chart error_chart(LabSystem system);

} // namespace cairn::viewer
