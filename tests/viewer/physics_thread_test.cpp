#include "viewer/physics_thread.h"

#include "test_scene.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace {

using namespace cairn;
using namespace cairn::viewer;

// Polls until the state satisfies the condition; false after ten seconds.
template <class Condition> bool comes_true(const PhysicsThread& physics, Condition condition) {
    for (int i = 0; i < 1000; ++i) {
        if (condition(physics.latest().stage)) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

TEST(PhysicsThread, RunsByItselfAndObeysCommands) {
    PhysicsThread physics(test::load_boxes, "2");
    EXPECT_TRUE(comes_true(physics, [](const StageState& state) { return state.statistics.steps > 5; }));
    physics.post(command::Spawn{box_preset(), {0.0, 5.0, 0.0}});
    EXPECT_TRUE(comes_true(physics, [](const StageState& state) { return state.layout->bodies.size() == 4; }));
    physics.post(command::SetPaused{true});
    ASSERT_TRUE(comes_true(physics, [](const StageState& state) { return state.paused; }));
    const std::uint64_t steps = physics.latest().stage.statistics.steps;
    physics.post(command::SingleStep{});
    EXPECT_TRUE(comes_true(physics, [&](const StageState& state) { return state.statistics.steps == steps + 1; }));
}

TEST(PhysicsThread, LayoutAndMotionAlwaysMatch) {
    PhysicsThread physics(test::load_boxes, "1");
    for (int i = 0; i < 300; ++i) {
        physics.post(i % 3 == 2 ? Command(command::RemoveLast{})
                                : command::Spawn{small_sphere_preset(), {0.0, 4.0, 0.0}});
        const StageState state = physics.latest().stage;
        ASSERT_EQ(state.layout->bodies.size(), state.current->transforms.size());
        ASSERT_EQ(state.layout->bodies.size(), state.previous->transforms.size());
    }
}

TEST(PhysicsThread, ASceneThatCannotBeLoadedAtTheStartIsAnError) {
    EXPECT_THROW(PhysicsThread(test::load_boxes, "missing"), Error);
}

TEST(PhysicsThread, DrawsBetweenTheLastTwoStates) {
    StageState state;
    state.time_step = 0.5;
    state.remainder = 0.125;
    state.speed = 0.5;
    EXPECT_FLOAT_EQ(interpolation_fraction(state, 0.0), 0.25f);
    EXPECT_FLOAT_EQ(interpolation_fraction(state, 0.25), 0.5f);
    EXPECT_FLOAT_EQ(interpolation_fraction(state, 100.0), 1.0f);
    state.paused = true;
    EXPECT_FLOAT_EQ(interpolation_fraction(state, 0.0), 1.0f);
}

} // namespace
