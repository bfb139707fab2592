// A restored world continues, bit for bit, like the world that was saved.
#include "scenes.h"

#include <gtest/gtest.h>

namespace cairn_test {
namespace {

using namespace cairn;

class SnapshotOfScene : public testing::TestWithParam<NamedScene> {
  protected:
    static constexpr int save_at = 97, steps_after = 150;

    // The state hash after each further step.
    static std::vector<std::uint64_t> go_on(Scene& scene, World& world) {
        std::vector<std::uint64_t> hashes{world.state_hash()};
        for (int i = 0; i < steps_after; ++i) {
            scene.step(world);
            hashes.push_back(world.state_hash());
        }
        return hashes;
    }
};
INSTANTIATE_TEST_SUITE_P(Scenes, SnapshotOfScene, testing::ValuesIn(scenes().begin(), scenes().end()),
                         [](const testing::TestParamInfo<NamedScene>& info) { return std::string(info.param.name); });

TEST_P(SnapshotOfScene, ContinuesInTheSameWorldAndInAFreshOne) {
    Scene& scene = GetParam().make();
    World world{scene.settings()};
    scene.build(world);
    for (int i = 0; i < save_at; ++i) scene.step(world);
    const Snapshot snapshot = world.save();
    const std::vector<std::uint64_t> expected = go_on(scene, world);
    ASSERT_NE(expected.front(), expected.back());
    world.restore(snapshot);
    EXPECT_EQ(go_on(scene, world), expected) << "in the same world";
    World fresh;
    fresh.restore(snapshot);
    EXPECT_EQ(fresh.step_count(), std::uint64_t(save_at));
    EXPECT_EQ(go_on(scene, fresh), expected) << "in a fresh world";
}

TEST_P(SnapshotOfScene, SavingChangesNothing) {
    Scene& scene = GetParam().make();
    World saved{scene.settings()}, plain{scene.settings()};
    scene.build(saved);
    scene.build(plain);
    for (int i = 0; i < 120; ++i) {
        if (i % 10 == 3) (void)saved.save();
        scene.step(saved);
        scene.step(plain);
    }
    EXPECT_EQ(saved.state_hash(), plain.state_hash());
    EXPECT_EQ(saved.save().bytes.size(), plain.save().bytes.size());
}

// The stacks of the scene sleep from the end of their fall to step 120, when a ball arrives.
TEST(SnapshotWhileAsleep, ContinuesAndWakesAlike) {
    Scene& scene = find_scene("sleep_and_wake")->make();
    World world{scene.settings()};
    scene.build(world);
    while (world.statistics().awake_bodies > 0 || world.step_count() == 0) {
        ASSERT_LT(world.step_count(), 119u);
        scene.step(world);
    }
    const Snapshot snapshot = world.save();
    World fresh;
    fresh.restore(snapshot);
    EXPECT_EQ(fresh.statistics().awake_bodies, 0u);
    bool awake = false;
    while (world.step_count() < 400) {
        scene.step(world);
        scene.step(fresh);
        ASSERT_EQ(world.state_hash(), fresh.state_hash()) << "step " << world.step_count();
        ASSERT_EQ(world.sleep_events().size(), fresh.sleep_events().size());
        ASSERT_EQ(world.contact_begins().size(), fresh.contact_begins().size());
        awake |= world.statistics().awake_bodies > 0;
    }
    EXPECT_TRUE(awake);
}

// At the save, half of the quiet time before sleep has passed.
TEST(SnapshotWhileFallingAsleep, FallsAsleepInTheSameStep) {
    Scene& scene = find_scene("sleep_and_wake")->make();
    World world{scene.settings()};
    scene.build(world);
    int steps = 0;
    while (world.sleep_events().empty()) {
        ASSERT_LT(++steps, 119);
        scene.step(world);
    }
    World again{scene.settings()};
    scene.build(again);
    for (int i = 0; i < steps - 10; ++i) scene.step(again);
    World fresh;
    fresh.restore(again.save());
    for (int i = 0; i < 10; ++i) {
        EXPECT_TRUE(fresh.sleep_events().empty());
        scene.step(fresh);
    }
    EXPECT_EQ(fresh.sleep_events().size(), world.sleep_events().size());
    EXPECT_EQ(fresh.state_hash(), world.state_hash());
}

} // namespace
} // namespace cairn_test
