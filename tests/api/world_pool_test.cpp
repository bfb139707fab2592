// Worlds of a pool evolve exactly as each of them would alone.
#include "test_world.h"

#include <algorithm>
#include <random>
#include <vector>

namespace cairn::test {
namespace {

// Bodies of several shapes that fall, roll and spin, some of them jointed. Each world has a different number of them,
// so that the scratch memory of steps changes between small and large worlds.
Snapshot random_start(std::mt19937& random) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    World world;
    add_ground(world);
    const int count = int(between(1, 24));
    std::vector<BodyId> bodies;
    for (int i = 0; i < count; ++i) {
        BodyDef def = body_at({between(-2, 2), between(0.5, 4), between(-2, 2)});
        def.rotation = Quat(float(between(-1, 1)), float(between(-1, 1)), float(between(-1, 1)), 1.1f);
        def.linear_velocity = {float(between(-3, 3)), float(between(-20, 3)), float(between(-3, 3))};
        const float spin = i % 5 == 0 ? 60.0f : 3.0f;
        def.angular_velocity = {float(between(-spin, spin)), float(between(-spin, spin)), float(between(-spin, spin))};
        const float size = float(between(0.1, 0.5));
        switch (i % 4) {
        case 0:
            bodies.push_back(add_body(world, def, Box{{size, 0.3f, 0.2f}}));
            break;
        case 1:
            bodies.push_back(add_body(world, def, Sphere{size}));
            break;
        case 2:
            bodies.push_back(add_body(world, def, Capsule{size, 0.2f}));
            break;
        default:
            bodies.push_back(add_body(world, def, Cylinder{size, 0.3f}));
            break;
        }
        if (i % 3 != 1) continue;
        const Position middle = 0.5 * (world.body(bodies[i - 1]).position() + world.body(bodies[i]).position());
        HingeJoint hinge;
        hinge.angle.limits = JointRange{-0.5f, 0.7f, {}};
        const Joint joint = i % 2 == 0 ? Joint(BallJoint{}) : Joint(hinge);
        world.create_joint(world.joint_at(bodies[i - 1], bodies[i], middle, {1.0f, 0.2f, 0.0f}, joint));
    }
    return world.save();
}

TEST(WorldPool, WorldsOfEverySizeGoOnAsTheyWouldAlone) {
    std::mt19937 random(7);
    std::vector<Snapshot> starts;
    for (int i = 0; i < 40; ++i) starts.push_back(random_start(random));
    std::vector<std::uint64_t> alone;
    for (const Snapshot& start : starts) {
        World world;
        world.restore(start);
        run(world, 90);
        alone.push_back(world.state_hash());
    }
    for (const int threads : {1, 2, 3}) {
        WorldPool pool(starts[0], starts.size(), threads);
        for (std::size_t i = 0; i < starts.size(); ++i) pool.world(i).restore(starts[i]);
        for (int k = 0; k < 30; ++k) pool.step(frame); // step by step, then many steps in one call
        pool.step(frame, 60);
        for (std::size_t i = 0; i < starts.size(); ++i) {
            EXPECT_EQ(pool.world(i).state_hash(), alone[i]) << "world " << i << ", " << threads << " threads";
        }
    }
}

TEST(WorldPool, AWorldThatIsRestoredTakesNothingOfItsPastAlong) {
    std::mt19937 random(8);
    const Snapshot first = random_start(random);
    World world;
    for (int i = 0; i < 30; ++i) {
        const Snapshot other = random_start(random);
        world.restore(other);
        run(world, 20);
        World fresh;
        fresh.restore(first);
        run(fresh, 60);
        world.restore(first);
        run(world, 60);
        ASSERT_EQ(world.state_hash(), fresh.state_hash()) << i;
    }
}

TEST(WorldPool, ForEachVisitsEveryWorldOnceAndMayBeginItAnew) {
    std::mt19937 random(9);
    const Snapshot start = random_start(random);
    WorldPool pool(start, 50, 2);
    std::vector<int> visits(pool.size());
    std::vector<std::uint64_t> hashes(pool.size());
    for (int round = 0; round < 3; ++round) {
        pool.for_each([&](World& world, std::size_t index) {
            ++visits[index];
            world.restore(start);
            world.set_settings([&] {
                WorldDef def = world.settings();
                def.gravity.y = -1.0f - float(index);
                return def;
            }());
            for (int i = 0; i < 30; ++i) world.step(frame);
            hashes[index] = world.state_hash();
        });
    }
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 3), 50);
    for (std::size_t i = 0; i < pool.size(); ++i) {
        World world;
        world.restore(start);
        WorldDef def = world.settings();
        def.gravity.y = -1.0f - float(i);
        world.set_settings(def);
        run(world, 30);
        EXPECT_EQ(hashes[i], world.state_hash()) << i;
    }
}

TEST(WorldPool, TheErrorOfTheFirstWorldArrivesAndTheOthersAreVisited) {
    World start;
    add_crate(start, {0, 3, 0});
    for (const int threads : {1, 3}) {
        WorldPool pool(start.save(), 20, threads);
        try {
            pool.for_each([&](World& world, std::size_t index) {
                world.step(frame);
                if (index % 7 == 3) throw Error(ErrorCode::invalid_value, std::to_string(index), {}, "is odd");
            });
            FAIL() << "nothing was thrown";
        } catch (const Error& error) {
            EXPECT_EQ(error.field(), "3");
        }
        for (std::size_t i = 0; i < pool.size(); ++i) EXPECT_EQ(pool.world(i).step_count(), 1u);
        pool.step(frame);
        EXPECT_EQ(pool.world(3).step_count(), 2u);
    }
}

TEST(WorldPool, RefusesWhatMakesNoSense) {
    World start;
    add_crate(start, {0, 3, 0});
    const Snapshot snapshot = start.save();
    EXPECT_THROW(WorldPool(snapshot, 1, 0), Error);
    EXPECT_THROW(WorldPool(snapshot, 1, 257), Error);
    EXPECT_THROW(WorldPool(Snapshot{}, 1), Error);
    WorldPool pool(snapshot, 2);
    EXPECT_THROW(pool.world(2), Error);
    EXPECT_THROW(pool.step(0.0f), Error);
    EXPECT_THROW(pool.step(not_a_number), Error);
    EXPECT_THROW(pool.step(frame, -1), Error);
    EXPECT_THROW(pool.for_each({}), Error);
    EXPECT_EQ(pool.world(0).step_count(), 0u);
    WorldPool other = std::move(pool);
    EXPECT_EQ(pool.size(), 0u);
    EXPECT_THROW(pool.step(frame), Error);
    other.step(frame);
    EXPECT_EQ(other.world(1).step_count(), 1u);
    EXPECT_EQ(WorldPool(snapshot, 0).size(), 0u);
}

} // namespace
} // namespace cairn::test
