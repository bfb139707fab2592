// Measures shared by the invariants of several scenes.
#pragma once

#include "scene_run.h"

namespace cairn_test {

// Calls f(body, index) for each dynamic body after step number `step`.
template <class F> void for_dynamic(const SceneRun& run, int step, const F& f) {
    const std::vector<BodyState>& bodies = run.steps[std::size_t(step)].bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (bodies[i].is_dynamic()) f(bodies[i], int(i));
}
inline const BodyState& body_at(const SceneRun& run, int step, int index) {
    return run.steps[std::size_t(step)].bodies[std::size_t(index)];
}

// The number of dynamic bodies that satisfy the predicate after the last step.
template <class F> double count_at_end(const SceneRun& run, const F& is_so) {
    int count = 0;
    for_dynamic(run, golden_steps, [&](const BodyState& body, int) { count += is_so(body); });
    return count;
}

double asleep_at(const SceneRun& run, int step);
double asleep_at_end(const SceneRun& run);
double lowest_center(const SceneRun& run);                // m, of dynamic bodies over all steps
double fastest(const SceneRun& run);                      // m/s, over all steps
double overlap_from(const SceneRun& run, int step);       // m, greatest from that step on
double usual_overlap_from(const SceneRun& run, int step); // m, median over these steps of the greatest in each
double energy_gain_from(const SceneRun& run,
                        int step);                // greatest increase above that step, relative to the maximum
double total_mass(const SceneRun& run, int step); // kg, of dynamic bodies

// The cosine between the y axis of a body and that of the world.
double uprightness(const BodyState& body);

} // namespace cairn_test
