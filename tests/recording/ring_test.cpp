// Snapshot rings: going back a few steps, repeatedly.
#include "random_changes.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <ctime>
#include <deque>
#include <utility>

namespace cairn::test {
namespace {

class Ring : public testing::TestWithParam<std::uint32_t> {};

TEST_P(Ring, GoesBackToWhatWasPushedBitForBitAndOnFromThere) {
    World world, other;
    RandomChanges changes(GetParam());
    changes.populate(world);
    SnapshotRing ring(8);
    std::deque<Snapshot> snapshots; // the same states, stored in a way that is known to be exact
    std::mt19937 random(GetParam());
    int restored = 0;
    for (int i = 0; i < 600; ++i) {
        for (std::uint32_t k = random() % 3; k > 0; --k) changes.change(world, false);
        world.step(dt);
        ring.push(world);
        snapshots.push_back(world.save());
        if (snapshots.size() > 8) snapshots.pop_front();
        ASSERT_EQ(ring.size(), snapshots.size());
        if (random() % 3 != 0) continue;
        const std::size_t back = random() % ring.size();
        snapshots.resize(snapshots.size() - back);
        ring.restore(world, back);
        other.restore(snapshots.back());
        ASSERT_EQ(ring.size(), snapshots.size());
        ASSERT_EQ(world.save().bytes, snapshots.back().bytes) << "round " << i;
        ASSERT_EQ(world.save().definitions->bytes, other.save().definitions->bytes) << "round " << i;
        for (int k = 0; k < 4; ++k) {
            world.step(dt), other.step(dt);
            ASSERT_EQ(world.state_hash(), other.state_hash()) << "round " << i << ", step " << k;
            ASSERT_EQ(world.contact_begins().size(), other.contact_begins().size());
            ASSERT_EQ(world.sleep_events().size(), other.sleep_events().size());
        }
        ring.push(world), snapshots.push_back(world.save());
        if (snapshots.size() > 8) snapshots.pop_front();
        ++restored;
    }
    EXPECT_GT(restored, 150);
}
INSTANTIATE_TEST_SUITE_P(Seeds, Ring, testing::Range(1u, 7u));

// Boxes in stacks of five; with `moves` they slide apart.
void build_stacks(World& world, int stacks, bool moves) {
    BodyDef ground;
    ground.type = BodyType::static_;
    world.add_shape(world.create_body(ground), Plane{});
    for (int i = 0; i < stacks; ++i) {
        for (int k = 0; k < 5; ++k) {
            BodyDef def;
            def.position = {2.0 * (i % 10), 0.5 + k + (moves ? 0.2 * k : 0.0), 2.0 * (i / 10)};
            if (moves) def.linear_velocity = {0.4f * float(k), 0, 0.1f}, def.angular_velocity = {0, 1, 0.2f};
            world.add_shape(world.create_body(def), Box{});
        }
    }
}

double bytes_of_a_body(bool moves, int settle) {
    World world;
    build_stacks(world, 100, moves);
    for (int i = 0; i < settle; ++i) world.step(dt);
    SnapshotRing ring(30);
    double awake = 0;
    for (int i = 0; i < 30; ++i) {
        ring.push(world);
        world.step(dt);
        awake += double(world.statistics().awake_bodies) / 30;
    }
    double bytes = 0;
    for (std::size_t back = 1; back < ring.size(); ++back) bytes += double(ring.bytes(back));
    bytes /= double(ring.size() - 1) * 500;
    std::printf("%s: %.0f bytes a body and frame, %.0f awake\n", moves ? "moving" : "resting", bytes, awake);
    return bytes;
}

TEST(RingSize, OfABodyAtRestIsNextToNothingAndOfOneThatMovesAFewHundredBytes) {
    EXPECT_LT(bytes_of_a_body(false, 25), 120); // still awake
    EXPECT_LT(bytes_of_a_body(false, 120), 2);  // asleep
    EXPECT_LT(bytes_of_a_body(true, 30), 400);
}

TEST(RingOfSnapshots, RefusesWhatItDoesNotHave) {
    EXPECT_THROW(SnapshotRing(0), Error);
    World world;
    SnapshotRing ring(2);
    EXPECT_THROW(ring.restore(world), Error);
    EXPECT_THROW(ring.bytes(0), Error);
    for (int i = 0; i < 5; ++i) ring.push(world), world.step(dt);
    EXPECT_EQ(ring.size(), 2u);
    EXPECT_EQ(ring.capacity(), 2u);
    try {
        ring.restore(world, 2);
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_value);
        EXPECT_EQ(error.value(), "2");
    }
    EXPECT_EQ(world.step_count(), 5u);
    ring.restore(world, 1);
    EXPECT_EQ(world.step_count(), 3u);
    EXPECT_EQ(ring.size(), 1u);
    World moved(std::move(world));
    EXPECT_THROW(ring.push(world), Error); // NOLINT: a moved-from world must be rejected
    EXPECT_EQ(ring.size(), 1u);
    ring.clear();
    EXPECT_EQ(ring.size(), 0u);
}

TEST(RingOfSnapshots, MakesAnotherWorldWhatTheFirstWas) {
    RandomChanges changes(3);
    World world, other;
    changes.populate(world);
    for (int i = 0; i < 50; ++i) changes.change(world);
    SnapshotRing ring(4);
    ring.push(world);
    ring.restore(other);
    EXPECT_EQ(other.state_hash(), world.state_hash());
    EXPECT_EQ(other.bodies(), world.bodies());
    world.step(dt), other.step(dt);
    EXPECT_EQ(other.state_hash(), world.state_hash());
}

TEST(RingOfSnapshots, IsToldOfLikeARestore) {
    struct Counter final : CommandListener {
        std::vector<std::string> told;
        void on_command(std::span<const std::byte> command) override { told.emplace_back(command_name(command)); }
        std::uint64_t number_of(const Shape&) override { return 0; }
        std::uint64_t number_of(const Snapshot&) override { return 0; }
    };
    World world;
    build_stacks(world, 2, false);
    SnapshotRing ring(4);
    ring.push(world);
    const std::uint64_t hash = world.state_hash();
    const auto counter = std::make_shared<Counter>();
    world.set_command_listener(counter);
    world.step(dt);
    ring.restore(world);
    EXPECT_EQ(world.state_hash(), hash);
    EXPECT_EQ(counter->told, (std::vector<std::string>{"World::restore", "World::step", "World::restore"}));
}

// The cost of going back eight frames repeatedly, besides the steps themselves.
TEST(RingOfSnapshots, CostsAboutWhatSnapshotsDoOrLess) {
    World by_ring, by_snapshots;
    build_stacks(by_ring, 100, true), build_stacks(by_snapshots, 100, true);
    SnapshotRing ring(9);
    std::deque<Snapshot> snapshots;
    double with_ring = 0, with_snapshots = 0;
    const auto measure = [](double& sum, auto&& run) { // processor time: test machines are busy
        const std::clock_t start = std::clock();
        run();
        sum += 1000.0 * double(std::clock() - start) / CLOCKS_PER_SEC;
    };
    constexpr int rounds = 40, frames = 8;
    for (int round = 0; round < rounds; ++round) {
        for (int i = 0; i < frames; ++i) {
            measure(with_ring, [&] { ring.push(by_ring); });
            measure(with_snapshots, [&] { snapshots.push_back(by_snapshots.save()); });
            by_ring.step(dt), by_snapshots.step(dt);
        }
        measure(with_ring, [&] { ring.restore(by_ring, frames - 1); });
        measure(with_snapshots, [&] { by_snapshots.restore(snapshots[snapshots.size() - frames]); });
        snapshots.clear();
        by_ring.step(dt), by_snapshots.step(dt);
        ASSERT_EQ(by_ring.state_hash(), by_snapshots.state_hash());
    }
    std::printf("a rollback of 8 frames: %.3f ms by the ring, %.3f by snapshots, beside its steps\n",
                with_ring / rounds, with_snapshots / rounds);
    EXPECT_LT(with_ring, 1.5 * with_snapshots);
}

} // namespace
} // namespace cairn::test
