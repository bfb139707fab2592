// The list of all cases. Their laws are those of docs/validation.md.
#include "validation/cases.h"

namespace cairn::validation {

std::span<const Case> cases() {
    static constexpr Case all[] = {
        // --- free motion and joints
        // --- friction
        {8, "rolling_down", "Rolling down a slope without slipping",
         "a = g sin(angle) / (1 + I / (m r^2)): 5/7 of g sin(angle) for a ball, 2/3 for a cylinder (Newton and Euler, "
         "with the condition v = r w)",
         measure_rolling_down},
        {9, "roll_or_slip", "The least friction to roll",
         "mu = tan(angle) / (1 + m r^2 / I): 2/7 of tan(angle) for a ball, 1/3 for a cylinder (Coulomb's bound on the "
         "friction that rolling asks for)",
         measure_roll_or_slip},
        {10, "slope", "A box that sticks to a slope, or slides down",
         "sticks where tan(angle) <= mu; else a = g (sin(angle) - mu cos(angle)) (Coulomb)", measure_slope},
        {11, "tipping", "A cube that tips over",
         "tips where the vertical through its center leaves its base: tan(angle) > width / height", measure_tipping},
        {12, "sliding_stop", "Sliding to a stop, for every heading", "way = v^2 / (2 mu g) (Coulomb)",
         measure_sliding_stop},
        {16, "slide_to_roll", "A sliding ball that comes to roll",
         "t = 2 v / (7 mu g), way = 12 v^2 / (49 mu g), then 5/7 v (G. Coriolis, Theorie mathematique des effets du "
         "jeu de billard, 1835)",
         measure_slide_to_roll},
        {24, "spinning_box", "A box that slides and spins",
         "Coulomb's law at each of its four corners, which carry a quarter of the weight each; integrated in steps of "
         "0.1 ms",
         measure_spinning_box},
        // --- collisions
        {13, "bounces", "A ball that bounces to rest",
         "height of bounce n: e^2n; time until rest: sqrt(2 h / g) (1 + e) / (1 - e) (Newton's law of restitution); "
         "with e = 1 the energy stays",
         measure_bounces},
        {14, "head_on", "Head-on impacts of balls",
         "v1 = (m1 - e m2) v / (m1 + m2), v2 = (1 + e) m1 v / (m1 + m2) (momentum and Newton's law of restitution)",
         measure_head_on},
        {15, "oblique", "An oblique impact of balls without friction",
         "the second leaves along the line of centers, 30 degrees off, with v cos 30; the first at a right angle to it "
         "with v sin 30 (momentum and energy)",
         measure_oblique},
        {18, "cradle", "Newton's cradle",
         "as many balls leave, as fast, as came in (momentum and energy, impact after impact)", measure_cradle},
        {19, "closed_pile", "What a closed pile keeps",
         "momentum and angular momentum stay, whatever restitution and friction are; with e = 1 and mu = 0 the energy "
         "does",
         measure_closed_pile},
        // --- structures
        {20, "stack_forces", "Forces in a stack", "under k boxes: k m g (balance of forces)", measure_stack_forces},
        {21, "moved_worlds", "The same run elsewhere, or turned",
         "the laws do not depend on place and heading: what is at p is at R p + s when all began so",
         measure_moved_worlds},
        {22, "towers", "What must stand",
         "statics: balance with friction 0.6, so nothing moves; each run with and without sleeping, the worse counts",
         measure_towers},
        // --- literature
        {25, "rolling_benchmark", "SimBenchmark: balls roll on a box that is pushed",
         "(F - mu (M + 25 m) g) = M a_box + 25 m a_ball with a_box = 7/2 a_ball, for every heading of the force "
         "(Coulomb; D. Kang and J. Hwangbo, SimBenchmark, 2018)",
         measure_rolling_benchmark},
        {26, "bouncing_benchmark", "SimBenchmark: elastic balls",
         "the energy stays: 49 balls of 10 kg, dropped from 5 m, for 20 s (SimBenchmark, 2018)",
         measure_bouncing_benchmark},
        {27, "pile_benchmark", "SimBenchmark: 666, a pile of balls",
         "nothing overlaps: 216 balls without friction and restitution, 10 s (SimBenchmark, 2018)",
         measure_pile_benchmark},
        {28, "kapla_benchmark", "SimBenchmark: a Kapla tower",
         "statics: the tower stands, 60,000 steps of 0.01 s (SimBenchmark, 2018)", measure_kapla_benchmark},
    };
    return all;
}

} // namespace cairn::validation
