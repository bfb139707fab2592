// States of a run, compressed as differences from each other: removing or changing others never changes a state.
#include "viewer/kept_states.h"

#include "test_scene.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;

// Balls that never stop rolling.
LoadedScene rolling_balls() {
    LoadedScene scene = test::boxes_on_plane(0);
    for (int i = 0; i < 20; ++i) {
        BodyDef def = test::body_at({2.0 * i, 1.0 + 0.1 * i, 0.0});
        def.linear_velocity = {0.0f, 0.0f, 1.0f + float(i)};
        scene.world.add_shape(scene.world.create_body(def), Sphere{});
    }
    return scene;
}

void expect_all(const KeptStates& states, const std::map<std::uint64_t, std::vector<std::byte>>& saved) {
    for (std::uint64_t step = states.first();; ++step) {
        step = std::max(step, states.before(step));
        if (const StateDigest* digest = states.digest(step)) {
            const Snapshot state = states.state(step);
            ASSERT_EQ(state.bytes, saved.at(step)) << step;
            World world;
            world.restore(state);
            ASSERT_EQ(world.state_digest(), *digest) << step;
        }
        if (step >= states.last()) return;
    }
}

// Applies random operations; returns the result of `bytes` after each of them.
std::vector<std::size_t> do_at_random(World& world, unsigned seed) {
    std::mt19937 random(seed);
    std::map<std::uint64_t, std::vector<std::byte>> saved;
    std::vector<std::size_t> bytes;
    KeptStates states;
    std::uint64_t step = 0;
    const auto keep = [&] {
        saved[step] = world.save().bytes;
        states.keep(world, step);
    };
    keep();
    for (int i = 0; i < 120; ++i) {
        const unsigned chance = random() % 16;
        if (chance == 0 && states.count() > 4) {
            states.thin_out();
        } else if (chance == 1 && states.count() > 2) {
            states.drop_oldest();
        } else if (chance == 2) { // branches off
            step = states.before(states.first() + random() % (states.last() - states.first() + 1));
            world.restore(states.state(step));
            states.drop_after(step);
            world.body(world.bodies().back()).set_linear_velocity({0.0f, float(i), 0.0f});
        } else if (chance == 3) {
            KeptStates copy = states; // the copy continues differently
            world.step(1.0f / 60.0f);
            copy.keep(world, ++step);
            copy.drop_after(copy.first());
        } else {
            world.step(1.0f / 60.0f);
            ++step;
            keep();
        }
        if (i % 10 == 0) expect_all(states, saved);
        bytes.push_back(states.bytes());
    }
    expect_all(states, saved);
    return bytes;
}

TEST(KeptStates, AreWhatTheyWereWhateverBecomesOfTheOthers) {
    for (unsigned seed = 0; seed < 8; ++seed) {
        LoadedScene scene = rolling_balls();
        do_at_random(scene.world, seed);
    }
}

// Uses a single world, because states contain the number of their world.
TEST(KeptStates, TakeTheSameBytesHoweverFastTheirThreadIs) {
    LoadedScene scene = rolling_balls();
    World& world = scene.world;
    const Snapshot start = world.save();
    const std::vector<std::size_t> once = do_at_random(world, 3);
    world.restore(start);
    EXPECT_EQ(do_at_random(world, 3), once);
}

TEST(KeptStates, EndWhileADifferenceIsSought) {
    LoadedScene scene = rolling_balls();
    for (int i = 0; i < 50; ++i) {
        KeptStates states;
        states.keep(scene.world, 0);
        KeptStates copy = states;
        if (i % 2 == 0) copy.keep(scene.world, 1);
    }
}

TEST(KeptStates, OfAWorldAtRestTakeLittleBesideTheFirst) {
    LoadedScene scene = test::boxes_on_plane(50);
    for (int i = 0; i < 300; ++i) scene.world.step(1.0f / 60.0f);
    KeptStates states;
    states.keep(scene.world, 0);
    for (std::uint64_t step = 1; step < 64; ++step) {
        scene.world.step(1.0f / 60.0f);
        states.keep(scene.world, step);
    }
    states.settle();
    // The first state, and up to seven on the path to the last one, are stored completely.
    EXPECT_LT(states.bytes(), 12 * states.last_size());
}

} // namespace
