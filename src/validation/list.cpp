// The list of all cases. Their laws are those of docs/validation.md.
#include "validation/cases.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace cairn::validation {

std::span<const Case> cases() {
    static constexpr Case listed[] = {
        // --- free motion and joints
        {1, "free_fall", "Free fall with each integrator",
         "y = y0 - g t^2 / 2 -+ g h t / 2 with substeps of h: semi-implicit Euler falls ahead of the exact path, "
         "explicit Euler behind it, Runge-Kutta 4 is exact.",
         measure_free_fall},
        {2, "projectile", "Projectile, 20 m/s at 45 degrees",
         "Range v^2 sin(2 a) / g = 40.775 m, height v_y^2 / (2 g) = 10.194 m, time 2 v_y / g = 2.883 s. For the Euler "
         "integrators with v_y -+ g h / 2 in place of v_y.",
         measure_projectile},
        {3, "oscillator", "Harmonic oscillator of 1 Hz",
         "Energy: explicit Euler x (1 + w^2 h^2) in a step; semi-implicit Euler within w h / 2 for ever; Runge-Kutta "
         "4 x (1 - (w h)^6 / 72) in a step. Orders 1, 1 and 4.",
         measure_oscillator},
        {4, "pendulum", "Pendulums",
         "T = 2 pi sqrt(L / g) / agm(1, cos(a / 2)), with the arithmetic-geometric mean (Gauss), for L = 1 m from rest "
         "at the angle a. A double pendulum keeps its energy.",
         measure_pendulum},
        {5, "free_top", "Torque-free top",
         "Euler's equations for moments (1, 2, 3) and a spin of (0.01, 1, 0.01) rad/s: flips at 10.917 and 30.470 s, "
         "period 39.1057 s; angular momentum and energy stay.",
         measure_free_top},
        {6, "tumbling_box", "Thrown, tumbling box",
         "A box of 0.1 x 0.4 x 0.9 m and 10 kg, thrown with (-2, 2, 8) m/s and (0.1, 5, 0.1) rad/s: flips at 1.16596, "
         "4.19438 and 7.22280 s by Euler's equations. Gravity does not change its angular momentum.",
         measure_tumbling_box},
        {7, "gyroscope", "Gyroscope",
         "A disk of 1 kg and 0.1 m on an arm of a = 0.1 m, horizontal, precesses with m g a / (I w): 0.981 rad/s at "
         "w = 200 rad/s, 1.962 at 100.",
         measure_gyroscope},
        {17, "impulses", "Impulse on a rod's end, impact of a box's corner",
         "v = J / m and w = 6 J / (m L); J = -(1 + e) n.v / (1/m + n.((I^-1 (r x n)) x r)).", measure_impulses},
        {23, "chain_and_net", "Chain with a heavy end, net of joints",
         "Joints hold: a chain of 20 links swings with 1,000 times a link's mass at its end, and a net of 64 x 64 "
         "balls falls, stretched by less than 1 %.",
         measure_chain_and_net},
        // --- friction
        // --- collisions
        // --- structures
        // --- literature
    };
    static const std::vector<Case> by_number = [] {
        std::vector<Case> sorted(std::begin(listed), std::end(listed));
        std::sort(sorted.begin(), sorted.end(), [](const Case& a, const Case& b) { return a.number < b.number; });
        return sorted;
    }();
    return by_number;
}

} // namespace cairn::validation
