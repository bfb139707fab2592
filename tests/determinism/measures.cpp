#include "measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cairn_test {

double asleep_at(const SceneRun& run, int step) {
    int count = 0;
    for_dynamic(run, step, [&](const BodyState& body, int) { count += !body.is_awake; });
    return count;
}

double asleep_at_end(const SceneRun& run) { return asleep_at(run, golden_steps); }

double lowest_center(const SceneRun& run) {
    double lowest = std::numeric_limits<double>::infinity();
    for (int step = 0; step <= golden_steps; ++step)
        for_dynamic(run, step, [&](const BodyState& body, int) { lowest = std::min(lowest, body.center.y); });
    return lowest;
}

double fastest(const SceneRun& run) {
    double speed = 0;
    for (int step = 0; step <= golden_steps; ++step)
        for_dynamic(run, step,
                    [&](const BodyState& body, int) { speed = std::max(speed, double(glm::length(body.velocity))); });
    return speed;
}

double overlap_from(const SceneRun& run, int step) {
    double deepest = 0;
    for (std::size_t i = std::size_t(step); i < run.steps.size(); ++i)
        deepest = std::max(deepest, run.steps[i].overlap);
    return deepest;
}

double usual_overlap_from(const SceneRun& run, int step) {
    std::vector<double> overlaps;
    for (std::size_t i = std::size_t(step); i < run.steps.size(); ++i) overlaps.push_back(run.steps[i].overlap);
    const auto middle = overlaps.begin() + std::ptrdiff_t(overlaps.size() / 2);
    std::nth_element(overlaps.begin(), middle, overlaps.end());
    return *middle;
}

double energy_gain_from(const SceneRun& run, int step) {
    const double start = run.steps[std::size_t(step)].energy;
    double most = start;
    for (std::size_t i = std::size_t(step); i < run.steps.size(); ++i) most = std::max(most, run.steps[i].energy);
    return (most - start) / std::max(std::fabs(start), std::fabs(most));
}

double total_mass(const SceneRun& run, int step) {
    double mass = 0;
    for_dynamic(run, step, [&](const BodyState& body, int) { mass += body.mass; });
    return mass;
}

double uprightness(const BodyState& body) { return double((body.rotation * cairn::Vec3(0, 1, 0)).y); }

} // namespace cairn_test
