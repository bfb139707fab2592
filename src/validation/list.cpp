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
         "Energy: explicit Euler multiplies it by 1 + w^2 h^2 per step; semi-implicit Euler keeps it within w h / 2; "
         "Runge-Kutta 4 multiplies it by 1 - (w h)^6 / 72 per step. Orders of the error: 1, 1 and 4.",
         measure_oscillator},
        {4, "pendulum", "Pendulums",
         "T = 2 pi sqrt(L / g) / agm(1, cos(a / 2)), with the arithmetic-geometric mean (Gauss), for L = 1 m, released "
         "at rest at the angle a. The energy of a double pendulum is constant.",
         measure_pendulum},
        {5, "free_top", "Torque-free top",
         "Euler's equations for moments of inertia (1, 2, 3) and an angular velocity of (0.01, 1, 0.01) rad/s: flips "
         "at 10.917 and 30.470 s, period 39.1057 s; angular momentum and energy are constant.",
         measure_free_top},
        {6, "tumbling_box", "Thrown, tumbling box",
         "A box of 0.1 x 0.4 x 0.9 m and 10 kg, thrown with (-2, 2, 8) m/s and (0.1, 5, 0.1) rad/s: flips at 1.16596, "
         "4.19438 and 7.22280 s by Euler's equations. Gravity does not change its angular momentum.",
         measure_tumbling_box},
        {7, "gyroscope", "Gyroscope",
         "A disk of 1 kg and 0.1 m on a horizontal arm of a = 0.1 m precesses at m g a / (I w): 0.981 rad/s at w = 200 "
         "rad/s, 1.962 at 100.",
         measure_gyroscope},
        {17, "impulses", "Impulse on a rod's end, impact of a box's corner",
         "v = J / m and w = 6 J / (m L); J = -(1 + e) n.v / (1/m + n.((I^-1 (r x n)) x r)).", measure_impulses},
        {23, "chain_and_net", "Chain with a heavy end, net of joints",
         "Joints do not stretch: a chain of 20 links swings with 1,000 times a link's mass at its end, and a net of 64 "
         "x 64 balls falls, with gaps below 1 %.",
         measure_chain_and_net},
        // --- friction
        {8, "rolling_down", "Rolling down a slope without slipping",
         "a = g sin(angle) / (1 + I / (m r^2)): 5/7 of g sin(angle) for a ball, 2/3 for a cylinder (Newton and Euler, "
         "with the condition v = r w).",
         measure_rolling_down},
        {9, "roll_or_slip", "The least friction to roll",
         "mu = tan(angle) / (1 + m r^2 / I): 2/7 of tan(angle) for a ball, 1/3 for a cylinder (Coulomb's bound on the "
         "friction that rolling requires).",
         measure_roll_or_slip},
        {10, "slope", "A box that sticks to a slope, or slides down",
         "Sticks where tan(angle) <= mu; else a = g (sin(angle) - mu cos(angle)) (Coulomb).", measure_slope},
        {11, "tipping", "A cube that tips over",
         "Tips where the vertical through its center leaves its base: tan(angle) > width / height.", measure_tipping},
        {12, "sliding_stop", "Sliding to a stop, for every heading", "Distance = v^2 / (2 mu g) (Coulomb).",
         measure_sliding_stop},
        {16, "slide_to_roll", "A sliding ball that starts to roll",
         "t = 2 v / (7 mu g), distance = 12 v^2 / (49 mu g), then the speed is 5/7 v (G. Coriolis, Theorie "
         "mathematique des effets du jeu de billard, 1835).",
         measure_slide_to_roll},
        {24, "spinning_box", "A box that slides and spins",
         "Coulomb's law at each of its four corners, which carry a quarter of the weight each; integrated in steps of "
         "0.1 ms.",
         measure_spinning_box},
        // --- collisions
        {13, "bounces", "A ball that bounces to rest",
         "Height of bounce n: e^2n; time until rest: sqrt(2 h / g) (1 + e) / (1 - e) (Newton's law of restitution); "
         "with e = 1 the energy is constant; the worst of 20 random heights, positions and directions.",
         measure_bounces},
        {14, "head_on", "Head-on impacts of balls",
         "v1 = (m1 - e m2) v / (m1 + m2), v2 = (1 + e) m1 v / (m1 + m2) (momentum and Newton's law of restitution); "
         "the worst of 20 random positions, directions and times.",
         measure_head_on},
        {15, "oblique", "An oblique impact of balls without friction",
         "The second ball leaves along the line of centers, 30 degrees off, with v cos 30; the first ball leaves at a "
         "right angle to it with v sin 30 (momentum and energy).",
         measure_oblique},
        {18, "cradle", "Newton's cradle",
         "As many balls leave as came in, at the same speed (momentum and energy, one impact after the other); the "
         "worst of 20 random positions, directions and times.",
         measure_cradle},
        {19, "closed_pile", "Conservation in a closed pile",
         "Momentum and angular momentum are constant for any restitution and friction; with e = 1 and mu = 0 so is the "
         "energy.",
         measure_closed_pile},
        // --- structures
        {20, "stack_forces", "Forces in a stack", "Under k boxes: k m g (balance of forces).", measure_stack_forces},
        {21, "moved_worlds", "The same run, shifted or rotated",
         "The laws of motion do not depend on position and orientation: if the initial state is moved by p -> R p + s, "
         "so are all later states.",
         measure_moved_worlds},
        {22, "towers", "Structures that must stand",
         "Statics: equilibrium with friction 0.6, so nothing moves; each structure is run with and without sleeping, "
         "and the worse result counts.",
         measure_towers},
        {31, "turntable", "A turntable: a box rides on it, a ball rolls on it",
         "Friction holds a box that rides up to w^2 r = mu g. A solid ball that rolls moves in a circle at 2/7 of the "
         "table's rate W: m dv/dt = F and 2/5 m r^2 dw/dt = moment of F give dv/dt = 2/7 W x v.",
         measure_turntable},
        {32, "masonry", "Arches and overhanging planks",
         "An arch of rigid stones stands if a line of thrust fits into it (J. Heyman, The stone skeleton, 1966): a "
         "semicircle of many stones needs a thickness of 0.1075 of its radius. Planks may overhang until the center of "
         "mass of all planks above an edge is over that edge: by 1/2 + 1/4 + 1/6 + ... of their length.",
         measure_masonry},
        {33, "bicycle", "A riderless bicycle",
         "Four bodies on three hinges, rolling without slipping. After a push the bicycle follows the linearized "
         "equations of J. P. Meijaard, J. M. Papadopoulos, A. Ruina and A. L. Schwab (Proc. R. Soc. A 463, 2007), with "
         "the parameters of their benchmark. From 4.29 to 6.02 m/s it rights itself.",
         measure_bicycle},
        {34, "wheelset", "Conical wheels on rails",
         "An axle with two conical wheels that rolls without slip oscillates across its rails, with the wavelength 2 "
         "pi sqrt(r b / slope) for wheels of radius r and rails 2 b apart (J. Klingel, 1883).",
         measure_wheelset},
        {35, "capstan", "A rope around a drum",
         "Friction holds a load of up to exp(mu times the angle) times the smaller load (L. Euler, 1762; J. A. "
         "Eytelwein, 1808): a rope of 52 links, half around the drum.",
         measure_capstan},
        {36, "silo", "Grains in a silo",
         "Walls with friction carry most of the grains: of the poured mass m, the floor carries M (1 - exp(-m / M)), "
         "with a fitted mass M (H. A. Janssen, 1895). Without friction it carries all.",
         measure_silo},
        {37, "rollers", "A plank on two rollers that spin toward each other",
         "Each roller pulls the plank inward by friction in proportion to its load, and the roller nearer to the "
         "center of mass carries more: the plank oscillates with w^2 = mu g / (a - mu c), for rollers 2 a apart and a "
         "plank 2 c high, at any speed of the rollers (S. Timoshenko, Vibration problems in engineering, 1928).",
         measure_rollers},
        // --- impacts
        {29, "billiards", "A billiard break, impact by impact",
         "Equal elastic balls exchange their velocities along the line of centers (momentum and energy); the expected "
         "motion is computed from impact to impact in double precision, for 60 positions, directions and times.",
         measure_billiards},
        {30, "shots", "Bodies shot at thin targets",
         "Solids do not pass through each other: none comes out behind a target, for any position, direction and time.",
         measure_shots},
        // --- literature
        {25, "rolling_benchmark", "SimBenchmark: balls roll on a pushed box",
         "(F - mu (M + 25 m) g) = M a_box + 25 m a_ball with a_box = 7/2 a_ball, for every heading of the force "
         "(Coulomb; D. Kang and J. Hwangbo, SimBenchmark, 2018).",
         measure_rolling_benchmark},
        {26, "bouncing_benchmark", "SimBenchmark: elastic balls",
         "The energy is constant: 49 balls of 10 kg, dropped from 5 m, for 20 s (SimBenchmark, 2018).",
         measure_bouncing_benchmark},
        {27, "pile_benchmark", "SimBenchmark: 666, a pile of balls",
         "Nothing overlaps: 216 balls without friction and restitution, 10 s (SimBenchmark, 2018).",
         measure_pile_benchmark},
        {28, "kapla_benchmark", "SimBenchmark: a Kapla tower",
         "Statics: the tower stands, 60,000 steps of 0.01 s (SimBenchmark, 2018).", measure_kapla_benchmark},
    };
    static const std::vector<Case> by_number = [] {
        std::vector<Case> sorted(std::begin(listed), std::end(listed));
        std::sort(sorted.begin(), sorted.end(), [](const Case& a, const Case& b) { return a.number < b.number; });
        return sorted;
    }();
    return by_number;
}

} // namespace cairn::validation
