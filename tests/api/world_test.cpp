// The world as a whole: statistics, settings, adding and removing shapes, several worlds at a time.
#include "test_world.h"

#include <set>
#include <string>
#include <thread>
#include <vector>

namespace cairn::test {
namespace {

void add_pile(World& world, int bodies) {
    add_ground(world);
    for (int i = 0; i < bodies; ++i) {
        const Position p(0.7 * (i % 3), 0.6 + 0.7 * (i / 9), 0.7 * (i / 3 % 3));
        if (i % 2)
            add_body(world, body_at(p), Sphere{0.3f});
        else
            add_body(world, body_at(p), Box{{0.25f, 0.3f, 0.35f}});
    }
}

// --- statistics

TEST(Statistics, CountWhatThereIs) {
    World world;
    const Statistics empty = world.statistics();
    EXPECT_EQ(empty.bodies + empty.shapes + empty.contacts + empty.islands + empty.steps, 0u);
    add_ground(world);
    add_crate(world, {0.0, 0.5, 0.0});
    add_crate(world, {0.0, 1.5, 0.0});
    add_crate(world, {9.0, 5.0, 0.0});
    add_body(world, body_at({0.0, 50.0, 0.0}, BodyType::kinematic), Box{});
    run(world, 20);
    const Statistics s = world.statistics();
    EXPECT_EQ(s.steps, 20u);
    EXPECT_NEAR(s.time, 20 / 60.0, 1e-6);
    EXPECT_EQ(world.step_count(), 20u);
    EXPECT_EQ(world.time(), s.time);
    EXPECT_EQ(s.bodies, 5u);
    EXPECT_EQ(s.dynamic_bodies, 3u);
    EXPECT_EQ(s.awake_bodies, 3u);
    EXPECT_EQ(s.shapes, 5u);
    EXPECT_EQ(s.islands, 2u);
    EXPECT_EQ(s.contacts, 2u);
    EXPECT_EQ(s.contact_points, 8u);
    EXPECT_GE(s.candidate_pairs, 2u);
    EXPECT_EQ(s.overflow_contacts, 0u);
    EXPECT_EQ(s.clamped_speeds, 0u);
    EXPECT_GE(s.colors, 1u);
    EXPECT_GE(s.max_substeps, WorldDef{}.substeps);
    EXPECT_LT(s.max_penetration, 0.01);
    EXPECT_GT(s.times.total, 0.0);
    EXPECT_LE(s.times.broad_phase + s.times.narrow_phase + s.times.solve + s.times.finalize, s.times.total * 1.01);
}

TEST(Statistics, TellThePenetration) {
    World world(weightless());
    add_ground(world);
    add_body(world, body_at({0.0, 0.3, 0.0}), Sphere{});
    world.step(frame);
    EXPECT_NEAR(world.statistics().max_penetration, 0.2, 0.06);
}

TEST(InstructionSet, HasAName) {
    const std::set<std::string> known{"avx512", "avx2", "sse2", "neon", "scalar"};
    EXPECT_TRUE(known.contains(std::string(instruction_set()))) << instruction_set();
}

// --- settings

TEST(Settings, AreReadAsSetAndTakeEffect) {
    WorldDef def;
    def.gravity = {1.0f, 0.0f, 0.0f};
    def.substeps = 3;
    World world(def);
    const Body ball = world.body(add_body(world, {}, Sphere{}));
    EXPECT_EQ(world.settings().gravity, def.gravity);
    EXPECT_EQ(world.settings().substeps, 3);
    run(world, 60);
    EXPECT_NEAR(ball.linear_velocity().x, 1.0f, 1e-4f);
    def.gravity = {0.0f, 0.0f, 2.0f};
    def.max_linear_speed = 1.5f;
    world.set_settings(def);
    run(world, 120);
    EXPECT_LE(glm::length(ball.linear_velocity()), 1.5f * 1.00001f);
    EXPECT_GT(ball.linear_velocity().z, 1.0f);
}

TEST(Settings, UnchangedSettingsChangeNothing) {
    World plain, reset;
    add_pile(plain, 20);
    add_pile(reset, 20);
    for (int i = 0; i < 200; ++i) {
        reset.set_settings(WorldDef(reset.settings()));
        plain.step(frame);
        reset.step(frame);
        ASSERT_EQ(plain.state_hash(), reset.state_hash()) << "step " << i;
    }
}

TEST(Settings, StepMayChangeItsLength) {
    World world;
    add_pile(world, 20);
    const double energy = mechanical_energy(world);
    for (int i = 0; i < 300; ++i) {
        ASSERT_TRUE(stays_sane(world, 1, i % 3 == 0 ? 1.0f / 30 : i % 3 == 1 ? 1.0f / 240 : frame));
        ASSERT_LE(mechanical_energy(world), 1.01 * energy) << "step " << i;
    }
    for (const BodyId body : world.bodies()) EXPECT_GT(world.body(body).position().y, -0.05);
}

// --- shapes that come and go

TEST(Shapes, AddedWhileSteppingCollide) {
    World world;
    add_ground(world);
    const BodyId body = world.create_body(body_at({0.0, 3.0, 0.0}));
    run(world, 10);
    world.add_shape(body, Sphere{0.5f});
    run(world, 240);
    EXPECT_NEAR(world.body(body).position().y, 0.5, 0.01);
    world.add_shape(body, Sphere{0.5f}, shape_at({0.0f, -0.4f, 0.0f}));
    run(world, 240);
    EXPECT_TRUE(is_sane(world));
    EXPECT_GT(world.shape_bounds(world.body(body).shapes()[1]).min.y, -0.05)
        << "the new one is pushed out of the ground";
}

TEST(Shapes, RemovedShapesCollideNoLonger) {
    World world;
    add_ground(world);
    const BodyId crate = add_crate(world, {0.0, 0.5, 0.0});
    run(world, 200);
    world.remove_shape(world.body(crate).shapes()[0]);
    run(world, 60);
    EXPECT_LT(world.body(crate).position().y, -3.0) << "without shapes it falls through the ground";
    EXPECT_TRUE(is_sane(world));
}

TEST(Shapes, OfStaticBodiesComeAndGoUnderAPile) {
    World world;
    const BodyId ground = add_ground(world);
    add_pile(world, 18);
    run(world, 120);
    for (int i = 0; i < 60; ++i) {
        const ShapeId bump =
            world.add_shape(ground, Box{{0.2f, 0.1f, 0.2f}}, shape_at({0.05f * float(i % 20), 0.0f, 0.5f}));
        ASSERT_TRUE(stays_sane(world, 3));
        world.remove_shape(bump);
        ASSERT_TRUE(stays_sane(world, 2));
    }
    EXPECT_EQ(world.statistics().shapes, 20u);
}

TEST(StaticBodies, MovedAreWhereTheyAre) {
    World world;
    const BodyId shelf = add_body(world, body_at({0.0, 0.0, 0.0}, BodyType::static_), Box{{2.0f, 0.5f, 2.0f}});
    world.body(shelf).set_position({0.0, 3.0, 0.0});
    const BodyId crate = add_crate(world, {0.0, 6.0, 0.0});
    run(world, 240);
    EXPECT_NEAR(world.body(crate).position().y, 4.0, 0.01);
    world.body(shelf).set_rotation(glm::angleAxis(0.9f, Vec3(0.0f, 0.0f, 1.0f)));
    run(world, 240);
    EXPECT_LT(world.body(crate).position().y, 0.0) << "it slides off";
}

// --- side by side

TEST(Worlds, SideBySideDoNotInfluenceEachOther) {
    World alone;
    add_pile(alone, 30);
    std::vector<std::uint64_t> expected;
    for (int i = 0; i < 120; ++i) {
        alone.step(frame);
        expected.push_back(alone.state_hash());
    }
    World first, second;
    add_pile(first, 30);
    add_pile(second, 30);
    for (int i = 0; i < 120; ++i) {
        first.step(frame);
        World brief;
        add_pile(brief, 5);
        brief.step(frame);
        second.step(frame);
        ASSERT_EQ(first.state_hash(), expected[std::size_t(i)]) << "step " << i;
        ASSERT_EQ(second.state_hash(), expected[std::size_t(i)]) << "step " << i;
    }
}

TEST(Worlds, InThreadsOfTheirOwnDoNotInfluenceEachOther) {
    const auto run_one = [] {
        World world;
        add_pile(world, 30);
        run(world, 120);
        return world.state_hash();
    };
    const std::uint64_t expected = run_one();
    std::vector<std::uint64_t> hashes(6, 0);
    std::vector<std::thread> threads;
    for (std::uint64_t& hash : hashes) threads.emplace_back([&] { hash = run_one(); });
    for (std::thread& thread : threads) thread.join();
    for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, expected);
}

TEST(Worlds, QueriesChangeNothing) {
    World asked, left_alone;
    add_pile(asked, 20);
    add_pile(left_alone, 20);
    for (int i = 0; i < 120; ++i) {
        asked.cast_ray({0.0, 9.0, 0.0}, {0.1f, -1.0f, 0.1f}, 20.0);
        asked.overlap(Sphere{1.0f}, {{0.5, 1.0, 0.5}, Quat(1, 0, 0, 0)});
        (void)asked.contacts();
        (void)asked.statistics();
        (void)asked.save();
        asked.step(frame);
        left_alone.step(frame);
        ASSERT_EQ(asked.state_hash(), left_alone.state_hash()) << "step " << i;
    }
}

TEST(World, ForceFieldsAreListedAsTheyAre) {
    World world;
    EXPECT_TRUE(world.force_fields().empty());
    ForceField wind, planet;
    wind.direction = Vec3(1.0f, 2.0f, 3.0f);
    planet.kind = ForceField::Kind::radial;
    planet.strength = 4.0f;
    const ForceFieldId first = world.add_force_field(wind), second = world.add_force_field(planet);
    EXPECT_EQ(world.force_fields(), (std::vector{first, second}));
    EXPECT_EQ(world.force_field(first).direction, wind.direction);
    EXPECT_EQ(world.force_field(second).strength, 4.0f);
    wind.direction = Vec3(0.0f);
    world.set_force_field(first, wind);
    EXPECT_EQ(world.force_field(first).direction, Vec3(0.0f));
    const Snapshot before = world.save();
    world.remove_force_field(first);
    EXPECT_EQ(world.force_fields(), std::vector{second});
    EXPECT_NE(refusal([&] { world.force_field(first); }), "");
    world.restore(before);
    EXPECT_EQ(world.force_fields(), (std::vector{first, second}));
}

} // namespace
} // namespace cairn::test
