// The integrators that some cases compare.
#pragma once

#include <cairn/world.h>

namespace cairn::validation {

struct NamedIntegrator {
    Integrator kind;
    const char* name;
    // Under constant acceleration the discrete path leads the exact one by this times g h t, with substeps of length h.
    double offset;
};

inline constexpr NamedIntegrator integrators[] = {{Integrator::semi_implicit_euler, "semi-implicit Euler", -0.5},
                                                  {Integrator::explicit_euler, "explicit Euler", 0.5},
                                                  {Integrator::rk4, "Runge-Kutta 4", 0.0}};

// The time steps at which errors are plotted, s.
inline constexpr double sweep[] = {1.0 / 30, 1.0 / 60, 1.0 / 120, 1.0 / 240, 1.0 / 480, 1.0 / 1000};

} // namespace cairn::validation
