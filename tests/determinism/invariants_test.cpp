// A hash cannot show whether a change alters the last bits only. Each scene must keep its physical invariants over the
// steps of its golden hash, and each invariant must detect at least one fault that is injected into the engine's input.
#include "invariants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

namespace cairn_test {

namespace {

std::vector<Invariant> invariants_of(std::string_view scene) {
    std::vector<Invariant> found;
    for (const auto& table : {invariants_of_bodies(), invariants_of_others()})
        for (const Invariant& invariant : table)
            if (invariant.scene == scene) found.push_back(invariant);
    return found;
}

class SceneInvariants : public testing::TestWithParam<NamedScene> {};
INSTANTIATE_TEST_SUITE_P(Scenes, SceneInvariants, testing::ValuesIn(scenes().begin(), scenes().end()),
                         [](const testing::TestParamInfo<NamedScene>& info) { return std::string(info.param.name); });

// The first step after which a value is not finite or a rotation not normalized; -1 if none.
int first_step_not_finite(const SceneRun& run) {
    const auto is_finite = [](const auto& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
    for (std::size_t step = 0; step < run.steps.size(); ++step)
        for (const BodyState& body : run.steps[step].bodies)
            if (!is_finite(body.center) || !is_finite(body.velocity) || !is_finite(body.spin) ||
                !(std::fabs(glm::length(body.rotation) - 1) < 1e-5f))
                return int(step);
    return -1;
}

TEST_P(SceneInvariants, Hold) {
    const SceneRun run = run_scene(GetParam().make());
    EXPECT_EQ(first_step_not_finite(run), -1);
    EXPECT_EQ(run.world.statistics().clamped_speeds, 0u) << "speeds cut to the world's greatest";
    const std::vector<Invariant> invariants = invariants_of(GetParam().name);
    EXPECT_GE(invariants.size(), 3u);
    for (const Invariant& invariant : invariants) {
        const double value = invariant.measure(run);
        std::printf("%s: %s: %.6g (%g to %g)\n", invariant.scene, invariant.what, value, invariant.lowest,
                    invariant.highest);
        EXPECT_TRUE(invariant.holds(value))
            << invariant.what << ": " << value << ", must be from " << invariant.lowest << " to " << invariant.highest;
    }
}

// Each invariant can fail: with half the gravity, without friction, contacts or sleep, and so on.
TEST_P(SceneInvariants, EachNoticesAFault) {
    const std::vector<Invariant> invariants = invariants_of(GetParam().name);
    std::vector<std::string> noticed(invariants.size());
    for (const Fault fault : all_faults) {
        const SceneRun run = run_scene(GetParam().make(), fault);
        for (std::size_t i = 0; i < invariants.size(); ++i)
            if (!invariants[i].holds(invariants[i].measure(run))) noticed[i] += std::string(" ") + name_of(fault);
    }
    for (std::size_t i = 0; i < invariants.size(); ++i) {
        std::printf("%s: %s:%s\n", invariants[i].scene, invariants[i].what, noticed[i].c_str());
        EXPECT_FALSE(noticed[i].empty()) << invariants[i].what << " notices nothing";
    }
}

} // namespace
} // namespace cairn_test
