// 100,000 bodies in one place: row 39 of the list of faults.
#include "../api/test_world.h"
#include "../sanitized.h"
#include "measures.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <random>

namespace cairn::test {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Bodies in one place that cannot collide make no pairs, and cost no more than if they were spread out.
void crowd_without_pairs(BodyType type) {
    constexpr double max_seconds = 5; // spread out, they take a tenth of a second
    {
        World world;
        const std::size_t memory = resident_memory();
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < 100000; ++i) {
            add_body(world, body_at({1.0, 2.0, 3.0}, type), Box{});
            if (i % 1000 == 0) {
                ASSERT_LT(seconds_since(start), max_seconds) << "after " << i << " bodies of type " << int(type);
            }
        }
        run(world, 3);
        EXPECT_LT(seconds_since(start), max_seconds);
        EXPECT_EQ(world.statistics().candidate_pairs, 0u);
        if (!cairn_test::is_sanitized) {
            EXPECT_LT(resident_memory() - memory, std::size_t(1) << 28);
        }
    }
}

TEST(Row39, HundredThousandStaticBodiesInOnePlaceMakeNoPairs) { crowd_without_pairs(BodyType::static_); }
TEST(Row39, HundredThousandKinematicBodiesInOnePlaceMakeNoPairs) { crowd_without_pairs(BodyType::kinematic); }

// If all can collide with all, there are n (n - 1) / 2 pairs: the time and memory per pair must not grow with n.
TEST(Row39, BodiesInOnePlaceCostAsMuchAsTheirPairs) {
    double least = 0;
    for (const int n : {100, 200, 400}) {
        World world(weightless());
        for (int i = 0; i < n; ++i) add_body(world, body_at({1.0, 2.0, 3.0}), Sphere{});
        const std::size_t memory = resident_memory();
        const std::clock_t start = std::clock(); // processor time, whatever else runs
        ASSERT_TRUE(stays_sane(world, 1));
        const std::size_t pairs = std::size_t(n) * std::size_t(n - 1) / 2;
        EXPECT_EQ(world.statistics().contacts, pairs);
        const double each = double(std::clock() - start) / double(CLOCKS_PER_SEC) / double(pairs);
        if (!cairn_test::is_sanitized) {
            EXPECT_LT(resident_memory(), memory + 4096 * pairs) << n; // less, if earlier tests left free memory
        }
        if (least > 0) {
            EXPECT_LT(each, 4 * least) << n;
        }
        least = least > 0 ? std::min(least, each) : each;
    }
}

// The time of the narrow phase of the next step, ms.
double narrow_phase_time(World& world) {
    world.step(frame);
    return world.statistics().times.narrow_phase;
}

// The least narrow-phase times of two worlds with equal numbers of contacts, in one place and in many, stepped
// alternately, so that memory latency affects both alike. Five steps, and up to 40 as long as one world seems slower,
// since other programs run on this machine.
struct Times {
    double together = 1e9, apart = 1e9;
};
Times narrow_phase_times(World& together, World& apart) {
    Times least;
    for (int i = 0; i < 5 || (i < 40 && least.together > 3 * least.apart); ++i) {
        least.together = std::min(least.together, narrow_phase_time(together));
        least.apart = std::min(least.apart, narrow_phase_time(apart));
    }
    return least;
}

// A slab on side * side tiles.
void add_tiled_floor(World& world, glm::dvec3 middle, int side) {
    const double half = 0.5 * side;
    for (int x = 0; x < side; ++x)
        for (int z = 0; z < side; ++z)
            add_body(world, body_at(middle + glm::dvec3(x + 0.5 - half, -0.5, z + 0.5 - half), BodyType::static_),
                     Box{});
    add_body(world, body_at(middle + glm::dvec3(0, 0.25, 0)), Box{{float(half), 0.25f, float(half)}});
}

// When each contact was compared with all others of the body, 16,000 tiles took 220 times as long as 1,000.
TEST(Row39, SlabOnManyTilesCostsAsMuchAsItsTiles) {
    World together, apart;
    add_tiled_floor(together, {}, 128);
    for (int i = 0; i < 16; ++i) add_tiled_floor(apart, {100.0 * i, 0, 0}, 32);
    const Times times = narrow_phase_times(together, apart);
    ASSERT_EQ(together.statistics().contacts, std::size_t(128 * 128));
    ASSERT_EQ(apart.statistics().contacts, std::size_t(128 * 128));
    EXPECT_LT(times.together, 4 * times.apart);
}

// Static boxes in one place, with one dynamic body among them.
void add_crowd(World& world, glm::dvec3 middle, int n, const Shape& shape, bool is_turned, std::mt19937& random) {
    std::uniform_real_distribution<float> any(-1, 1);
    for (int i = 0; i < n; ++i) {
        BodyDef still = body_at(middle + glm::dvec3(0.1 * double(any(random)), 0, 0), BodyType::static_);
        if (is_turned) still.rotation = glm::normalize(Quat(any(random), any(random), any(random), 1));
        add_body(world, still, Box{});
    }
    add_body(world, body_at(middle + glm::dvec3(0.1, 0.2, 0)), shape);
}

// The same if all contacts are in one place, where 20,000 took 0.28 s: for boxes without rotation, as the tiles of game
// levels, and with random ones, which make every plane different. Compared with a world that has as many contacts in 16
// places.
TEST(Row39, OneBodyAmongManyInOnePlaceCostsAsMuchAsItsPairs) {
    std::mt19937 random(7);
    for (const bool is_turned : {false, true})
        for (const Shape& shape : {Shape(Sphere{0.5f}), Shape(Capsule{0.5f, 0.3f}), Shape(Box{})}) {
            constexpr int places = 16, each = 500;
            World together, apart;
            add_crowd(together, {}, places * each, shape, is_turned, random);
            for (int i = 0; i < places; ++i) add_crowd(apart, {100.0 * i, 0, 0}, each, shape, is_turned, random);
            const Times times = narrow_phase_times(together, apart);
            EXPECT_EQ(together.statistics().candidate_pairs, apart.statistics().candidate_pairs);
            EXPECT_LT(times.together, 4 * times.apart) << shape.index() << " turned: " << is_turned;
        }
}

} // namespace
} // namespace cairn::test
