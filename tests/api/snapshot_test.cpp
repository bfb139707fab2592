// Saving and restoring a world, and rejecting damaged snapshots.
#include "test_world.h"

#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace cairn::test {
namespace {

// A world with one of everything: piles, sleeping bodies, a moving platform, force fields, removed bodies and shapes.
void fill(World& world) {
    add_ground(world);
    for (int i = 0; i < 30; ++i) {
        const Position p(0.7 * (i % 3), 0.6 + 0.7 * (i / 9), 0.7 * (i / 3 % 3));
        BodyDef def = body_at(p);
        def.name = "body " + std::to_string(i);
        def.user_data = std::uint64_t(i) << 40;
        if (i % 2)
            add_body(world, def, Sphere{0.3f});
        else
            add_body(world, def, Box{{0.25f, 0.3f, 0.35f}});
    }
    add_crate(world, {50.0, 0.5, 0.0});
    const BodyId platform = add_body(world, body_at({-10.0, 1.0, 0.0}, BodyType::kinematic), Box{{2.0f, 0.2f, 2.0f}});
    world.body(platform).set_linear_velocity({0.3f, 0.0f, 0.1f});
    add_crate(world, {-10.0, 1.7, 0.0});
    ForceField wind;
    wind.direction = {0.1f, 0.0f, 0.2f};
    world.add_force_field(wind);
    world.destroy_body(world.bodies()[5]);
}

std::uint64_t hash_after(World& world, int steps) {
    run(world, steps);
    return world.state_hash();
}

TEST(Snapshot, ContinuesBitForBitFromAnyMoment) {
    World straight;
    fill(straight);
    for (const int moment : {0, 1, 7, 40, 60, 150}) {
        World copy;
        copy.restore(straight.save());
        EXPECT_EQ(copy.state_hash(), straight.state_hash());
        EXPECT_EQ(copy.step_count(), straight.step_count());
        EXPECT_EQ(copy.time(), straight.time());
        for (int i = 0; i < 60; ++i) {
            straight.step(frame);
            copy.step(frame);
            ASSERT_EQ(copy.state_hash(), straight.state_hash())
                << "saved after " << straight.step_count() - i - 1 << ", step " << i;
            ASSERT_EQ(copy.contact_begins().size(), straight.contact_begins().size());
            ASSERT_EQ(copy.contact_ends().size(), straight.contact_ends().size());
            ASSERT_EQ(copy.sleep_events().size(), straight.sleep_events().size());
            ASSERT_EQ(copy.statistics().contact_points, straight.statistics().contact_points);
        }
        run(straight, moment);
    }
}

TEST(Snapshot, ContinuesBitForBitAfterChangesSinceTheLastStep) {
    World straight;
    fill(straight);
    run(straight, 100);
    const auto ids = straight.bodies();
    straight.destroy_body(ids[3]);
    straight.body(ids[4]).set_type(BodyType::kinematic);
    straight.body(ids[6]).set_type(BodyType::static_);
    straight.body(ids[7]).add_force({100.0f, 0.0f, 0.0f});
    straight.body(ids[8]).set_position({0.0, 8.0, 0.0});
    straight.remove_shape(straight.body(ids[9]).shapes()[0]);
    add_crate(straight, {0.5, 6.0, 0.0});
    World copy;
    copy.restore(straight.save());
    for (int i = 0; i < 120; ++i) {
        straight.step(frame);
        copy.step(frame);
        ASSERT_EQ(copy.state_hash(), straight.state_hash()) << "step " << i;
        ASSERT_EQ(copy.contact_ends().size(), straight.contact_ends().size()) << "step " << i;
    }
}

TEST(Snapshot, RewindsAndReplays) {
    World world;
    fill(world);
    run(world, 30);
    const Snapshot moment = world.save();
    const std::uint64_t end = hash_after(world, 90);
    for (int i = 0; i < 3; ++i) {
        world.restore(moment);
        EXPECT_EQ(hash_after(world, 90), end);
    }
}

TEST(Snapshot, KeepsHandlesNamesAndDefinitions) {
    World world;
    fill(world);
    run(world, 20);
    const auto ids = world.bodies();
    const BodyId later = ids[7];
    const Snapshot moment = world.save();
    world.destroy_body(later);
    run(world, 10);
    EXPECT_FALSE(world.is_valid(later));
    world.restore(moment);
    EXPECT_EQ(world.bodies(), ids);
    EXPECT_EQ(world.body(later).name(), "body 7");
    EXPECT_EQ(world.body(later).user_data(), std::uint64_t(7) << 40);
    EXPECT_EQ(world.find_body("body 9"), ids[9]);
    const ShapeId shape = world.body(later).shapes()[0];
    EXPECT_EQ(std::get<Sphere>(world.shape(shape)).radius, 0.3f);
    EXPECT_EQ(world.shape_def(shape).density, 1000.0f);
    EXPECT_EQ(world.settings().substeps, WorldDef{}.substeps);
}

TEST(Snapshot, SavedTwiceIsTheSameBytesAndChangesNothing) {
    World world;
    fill(world);
    run(world, 20);
    const std::uint64_t hash = world.state_hash();
    const Snapshot first = world.save(), second = world.save();
    EXPECT_TRUE(first.bytes == second.bytes);
    EXPECT_EQ(world.state_hash(), hash);
    World copy;
    copy.restore(first);
    EXPECT_TRUE(copy.save().bytes == first.bytes);
    EXPECT_LT(first.bytes.size(), std::size_t(1) << 20);
}

TEST(Snapshot, SharesWhatStepsDoNotChangeUntilItIsChanged) {
    World world;
    fill(world);
    run(world, 20);
    const Snapshot first = world.save();
    run(world, 20);
    world.body(world.bodies()[3]).set_linear_velocity({0, 1, 0});
    Snapshot last = world.save();
    EXPECT_EQ(first.definitions, last.definitions);
    EXPECT_FALSE(first.bytes == last.bytes);
    World copy;
    copy.restore(first);
    EXPECT_EQ(copy.save().definitions, first.definitions);
    // Each call makes exactly one change to the definitions.
    const auto changes = [&](auto&& change) {
        change();
        const Snapshot now = world.save();
        EXPECT_NE(now.definitions, last.definitions);
        EXPECT_EQ(world.save().definitions, now.definitions);
        last = now;
    };
    const BodyId body = world.bodies()[2];
    changes([&] { world.body(body).set_name("other"); });
    changes([&] { world.body(body).set_gravity_scale(2); });
    changes([&] { world.set_material(world.body(body).shapes()[0], Material{.restitution = 0.5f}); });
    changes([&] { world.add_shape(body, Sphere{0.1f}); });
    changes([&] { world.add_force_field({}); });
    changes([&] { world.create_joint(world.joint_at({}, body, {0, 5, 0}, {1, 0, 0}, BallJoint{})); });
    changes([&] { world.destroy_body(world.bodies()[9]); });
    changes([&] {
        WorldDef settings = world.settings();
        settings.substeps = 9;
        world.set_settings(settings);
    });
    copy.restore(first);
    EXPECT_EQ(copy.body(body).name(), "body 1");
    EXPECT_EQ(copy.body(body).shapes().size(), 1u);
    EXPECT_EQ(copy.settings().substeps, WorldDef{}.substeps);
}

// The same slot with the same generation, and two hulls of equal size and mass that differ otherwise.
TEST(Snapshot, KnowsAnotherHullInTheSamePlace) {
    const std::vector<Vec3> points = {{-1, -1, -1}, {1, -1, -1}, {0, 1, 0}, {0, -1, 1}};
    World world;
    const BodyId body = world.create_body({});
    const Snapshot before = world.save();
    world.add_shape(body, Hull(points));
    const Snapshot first = world.save();
    world.restore(before);
    world.add_shape(body, Hull(points));
    const Snapshot second = world.save();
    EXPECT_NE(first.definitions, second.definitions);
    EXPECT_TRUE(first.definitions->bytes == second.definitions->bytes);
}

// Without the fix the padding bytes of a struct were saved as whatever the caller's memory held.
TEST(Snapshot, DoesNotKnowWhatLiesBetweenTheFieldsOfADefinition) {
    World world;
    const Snapshot empty = world.save();
    const auto saved = [&](std::uint8_t garbage) {
        alignas(WorldDef) std::byte settings[sizeof(WorldDef)];
        alignas(ShapeDef) std::byte shape[sizeof(ShapeDef)];
        alignas(ForceField) std::byte field[sizeof(ForceField)];
        std::memset(settings, garbage, sizeof settings);
        std::memset(shape, garbage, sizeof shape);
        std::memset(field, garbage, sizeof field);
        world.restore(empty);
        world.set_settings(*new (settings) WorldDef);
        world.add_shape(world.create_body({}), Box{}, *new (shape) ShapeDef);
        world.add_force_field(*new (field) ForceField);
        return world.save().definitions->bytes;
    };
    EXPECT_TRUE(saved(0) == saved(0xff));
}

// A heap of 500 balls and boxes, with about six pairs per body.
struct Heap : testing::Test {
    World world;
    void SetUp() override {
        add_ground(world);
        for (int i = 0; i < 500; ++i) {
            BodyDef def = body_at(
                {0.8 * (i % 6) - 2 + 0.1 * (i % 7), 0.6 + 0.8 * (i / 36), 0.8 * (i / 6 % 6) - 2 + 0.1 * (i % 5)});
            def.rotation = Quat(1, 0.1f * float(i % 3), 0.2f * float(i % 4), 0.1f * float(i % 5));
            add_body(world, def, i % 2 ? Shape(Box{{0.3f, 0.3f, 0.3f}}) : Shape(Sphere{0.35f}));
        }
    }
};

TEST_F(Heap, TakesAtMost300BytesForTheStateOfABody) {
    for (int i = 0; i < 8; ++i) {
        run(world, 60);
        const Statistics now = world.statistics();
        const Snapshot snapshot = world.save();
        const SnapshotSizes sizes = snapshot.sizes();
        const auto per = [](std::size_t bytes, std::size_t count) { return double(bytes) / double(count); };
        std::printf(
            "after %3d steps, %zu awake, %zu contacts, %zu pairs: bodies %.0f, contacts %.0f, broad phase %.0f, "
            "all %.0f bytes per body; contacts %.0f bytes per pair; definitions %.0f\n",
            60 * (i + 1), now.awake_bodies, now.contacts, now.candidate_pairs, per(sizes.bodies, 500),
            per(sizes.contacts, 500), per(sizes.broad_phase, 500), per(snapshot.bytes.size(), 500),
            per(sizes.contacts, now.candidate_pairs), per(sizes.definitions, 500));
        EXPECT_LE(per(sizes.bodies, now.bodies), 300.0);
        EXPECT_LE(per(sizes.broad_phase, now.bodies), 300.0);
        EXPECT_LE(per(sizes.contacts, now.candidate_pairs), 300.0);
        EXPECT_EQ(sizes.joints, 16u); // two empty lists
        EXPECT_LE(sizes.other, 2000u);
        EXPECT_EQ(sizes.bodies + sizes.contacts + sizes.joints + sizes.broad_phase + sizes.other,
                  snapshot.bytes.size());
    }
}

// Without the fix snapshots of such bodies were rejected, because a mass had to be finite.
TEST(Snapshot, BodiesOfInfiniteMassComeBack) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    World world;
    add_ground(world);
    BodyDef def = body_at({0.0, 2.0, 0.0});
    def.mass = infinity;
    add_body(world, def, Box{});
    world.body(add_crate(world, {5.0, 2.0, 0.0})).set_mass_from_shapes(infinity);
    MassProperties properties;
    properties.mass = infinity;
    world.body(add_crate(world, {10.0, 2.0, 0.0})).set_mass_properties(properties);
    add_crate(world, {0.0, 4.0, 0.0});
    run(world, 20);
    World other;
    other.restore(world.save());
    EXPECT_EQ(other.state_hash(), world.state_hash());
    EXPECT_EQ(hash_after(other, 100), hash_after(world, 100));
}

TEST(Snapshot, EmptyWorldAndWorldWithoutShapes) {
    World empty, copy;
    add_crate(copy, {});
    copy.restore(empty.save());
    EXPECT_TRUE(copy.bodies().empty());
    EXPECT_TRUE(stays_sane(copy, 5));
    empty.create_body(body_at({1.0, 2.0, 3.0}));
    copy.restore(empty.save());
    EXPECT_EQ(hash_after(copy, 60), hash_after(empty, 60));
}

// --- damage

// Checks that the snapshot is rejected as a malformed file, and that the world stays as it was.
testing::AssertionResult is_refused(World& world, const Snapshot& damaged, std::uint64_t hash) {
    try {
        world.restore(damaged);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::invalid_file && error.code() != ErrorCode::unsupported)
            return testing::AssertionFailure() << "wrong code: " << error.what();
        if (error.field() != "Snapshot" && error.field() != "Snapshot.definitions")
            return testing::AssertionFailure() << "wrong field: " << error.field();
        if (world.state_hash() != hash) return testing::AssertionFailure() << "the world has changed";
        return testing::AssertionSuccess();
    }
    return testing::AssertionFailure() << "accepted";
}

struct Damage : testing::Test {
    World source, target;
    Snapshot good;
    std::uint64_t hash = 0;
    void SetUp() override {
        add_ground(source);
        for (int i = 0; i < 4; ++i) add_crate(source, {0.2 * i, 0.5 + 1.1 * i, 0.0});
        run(source, 30);
        good = source.save();
        add_ground(target);
        add_crate(target, {1.0, 2.0, 3.0});
        run(target, 5);
        hash = target.state_hash();
    }
};

TEST_F(Damage, CutOffAtEveryByteIsRefused) {
    for (std::size_t size = 0; size < good.bytes.size(); ++size) {
        const Snapshot cut{{good.bytes.begin(), good.bytes.begin() + std::ptrdiff_t(size)}, good.definitions};
        ASSERT_TRUE(is_refused(target, cut, hash)) << "cut to " << size << " of " << good.bytes.size();
    }
}

TEST_F(Damage, AnyFlippedBitIsRefused) {
    std::mt19937 random(1);
    Snapshot damaged = good;
    // All bits of the header, and a random sample of the others.
    std::vector<std::size_t> bits;
    for (std::size_t bit = 0; bit < 8 * 64; ++bit) bits.push_back(bit);
    std::uniform_int_distribution<std::size_t> any(0, 8 * good.bytes.size() - 1);
    for (int i = 0; i < 5000; ++i) bits.push_back(any(random));
    for (const std::size_t bit : bits) {
        const std::byte mask = std::byte(1u << (bit % 8));
        damaged.bytes[bit / 8] ^= mask;
        ASSERT_TRUE(is_refused(target, damaged, hash)) << "bit " << bit;
        damaged.bytes[bit / 8] ^= mask;
    }
    target.restore(damaged);
    EXPECT_EQ(target.state_hash(), source.state_hash());
}

TEST_F(Damage, AnyFlippedBitOfTheDefinitionsIsRefused) {
    const auto damaged = std::make_shared<SnapshotDefinitions>(*good.definitions);
    for (std::size_t bit = 0; bit < 8 * damaged->bytes.size(); ++bit) {
        const std::byte mask = std::byte(1u << (bit % 8));
        damaged->bytes[bit / 8] ^= mask;
        ASSERT_TRUE(is_refused(target, Snapshot{good.bytes, damaged}, hash)) << "bit " << bit;
        damaged->bytes[bit / 8] ^= mask;
    }
    target.restore(Snapshot{good.bytes, damaged});
    EXPECT_EQ(target.state_hash(), source.state_hash());
}

TEST_F(Damage, WhatIsAddedOrForeignIsRefused) {
    Snapshot longer = good;
    longer.bytes.push_back(std::byte{0});
    EXPECT_TRUE(is_refused(target, longer, hash));
    EXPECT_TRUE(is_refused(target, Snapshot{}, hash));
    EXPECT_TRUE(is_refused(target, Snapshot{std::vector<std::byte>(1000, std::byte{0}), {}}, hash));
    EXPECT_EQ(refusal([&] {
                  target.restore(Snapshot{std::vector<std::byte>(1000, std::byte{7}), {}});
              }),
              "invalid_file | Snapshot | Snapshot: does not begin like a snapshot");
    Snapshot other_build = good;
    other_build.bytes[8] ^= std::byte{1};
    EXPECT_EQ(refusal([&] { target.restore(other_build); }),
              "unsupported | Snapshot | Snapshot: was saved by another build of this library");
    Snapshot without = good;
    without.definitions = nullptr;
    EXPECT_EQ(refusal([&] { target.restore(without); }),
              "invalid_file | Snapshot.definitions | Snapshot.definitions: do not match its bytes");
    auto other_shapes = std::make_shared<SnapshotDefinitions>(*good.definitions);
    other_shapes->shapes.clear();
    EXPECT_EQ(refusal([&] {
                  target.restore(Snapshot{good.bytes, other_shapes});
              }),
              "invalid_file | Snapshot.definitions | Snapshot.definitions: has other shapes than its bytes state");
    other_shapes = std::make_shared<SnapshotDefinitions>(*good.definitions);
    for (Shape& shape : other_shapes->shapes) shape = Capsule{};
    EXPECT_TRUE(is_refused(target, Snapshot{good.bytes, other_shapes}, hash));
    EXPECT_TRUE(is_refused(target, Snapshot{good.bytes, target.save().definitions}, hash));
    EXPECT_THROW((void)Snapshot{}.sizes(), Error);
    EXPECT_TRUE(stays_sane(target, 30));
}

// Hulls, meshes and height fields are restored with the world that had them, also into another world.
TEST(Snapshots, SharedShapesComeBack) {
    const std::vector<Vec3> points = {{-1, -1, -1}, {1, -1, -1}, {0, 1, 0}, {0, -1, 1}};
    const std::vector<Vec3> square = {{-9, 0, -9}, {9, 0, -9}, {-9, 0, 9}, {9, 0, 9}};
    const std::vector<std::uint32_t> triangles = {0, 2, 3, 0, 3, 1};
    World world;
    add_body(world, body_at({0, 0, 0}, BodyType::static_), Mesh(square, triangles));
    add_body(world, body_at({30, 0, 0}, BodyType::static_), HeightField(3, 3, {5, 5}, std::vector<float>(9, 0.0f)));
    for (const double x : {0.0, 30.0}) {
        add_body(world, body_at({x, 3, 0}), Hull(points));
        add_body(world, body_at({x + 2, 3, 0}), cone(0.5f, 0.5f));
    }
    run(world, 45);
    const Snapshot snapshot = world.save();
    World other;
    other.restore(snapshot);
    run(world, 120);
    run(other, 120);
    EXPECT_EQ(world.state_hash(), other.state_hash());
    EXPECT_GT(other.contacts().size(), 3u);
    EXPECT_TRUE(stays_sane(other, 30));
}

} // namespace
} // namespace cairn::test
