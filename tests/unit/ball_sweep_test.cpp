// Sweeps and overlaps of balls with shapes that have a closed form for the nearest point, of boxes and capsules, and of
// balls inside shapes, compared with distances by GJK and depths by EPA.
#include "cast_test_support.h"

#include <gtest/gtest.h>

namespace {

using namespace convex_test;

Solid any_with_formula(Random& random, double size) {
    const auto u = [&] { return size * random.uniform(0.05, 1); };
    const Solid solids[] = {ball(u()), box(u(), u(), u()), capsule(u(), u()), cylinder(u(), u())};
    const int kind = random.below(4);
    return kind % 2 == 1 && random.below(3) == 0 ? rounded(solids[kind], 0.2 * size) : solids[kind];
}

Cast any_cast(Random& random, int k) {
    const double size = random.below(3) == 0 ? random.uniform(2, 8) : random.uniform(0.2, 1);
    Cast c{ball(size * random.uniform(0.05, 1)),
           any_with_formula(random, size),
           {},
           {},
           random.rotation(),
           random.rotation()};
    if (k % 2 == 0) std::swap(c.moving, c.still);
    c.from = 2 * size * random.uniform(0, 2) * random.direction();
    c.way = -1.5 * c.from + random.uniform(0, 6) * size * random.direction();
    return c;
}

Cast any_cast_of_capsule(Random& random, int k) {
    const double size = random.below(3) == 0 ? random.uniform(2, 8) : random.uniform(0.2, 1);
    const auto u = [&] { return size * random.uniform(0.05, 1); };
    const Solid sharp = box(u(), u(), u());
    const bool in_line = random.below(4) == 0; // aligned, so that whole edges and faces meet at once
    Cast c{random.below(3) == 0 ? rounded(sharp, 0.2 * size) : sharp,
           capsule(u(), u()),
           {},
           {},
           in_line ? DQuat{0, 0, 0, 1} : random.rotation(),
           in_line ? DQuat{0, 0, 0, 1} : random.rotation()};
    if (k % 2 == 0) std::swap(c.moving, c.still);
    c.from = 2 * size * random.uniform(0, 2) * random.direction();
    c.way = -1.5 * c.from + random.uniform(0, 6) * size * random.direction();
    return c;
}

struct Counts {
    int hits = 0, misses = 0;
};

void expect_that_of_advancement(const Cast& cast, int k, Counts& counts) {
    const auto expected = advance(cast), hit = cast_convex(cast.a(), cast.way, cast.b());
    const double near = 4 * cast.tolerance(), length = convex_test::length(cast.way);
    if (hit.has_value() != expected.has_value()) { // only where they pass each other within this distance
        const auto least = closest_points(cast.a(hit ? hit->fraction : expected->fraction), cast.b());
        EXPECT_LT(std::fabs(dot(least.normal, cast.way)), 3e-3 * length) << k;
        EXPECT_LT(std::fabs(least.distance), near) << k;
        return;
    }
    if (!hit) {
        ++counts.misses;
        return;
    }
    ASSERT_EQ(hit->fraction == 0, expected->fraction == 0) << k;
    if (hit->fraction == 0) return;
    ++counts.hits;
    const double steep = std::min(-dot(hit->normal, cast.way), -dot(expected->normal, cast.way));
    EXPECT_GT(steep, 0) << k;
    EXPECT_NEAR(hit->fraction * steep, expected->fraction * steep, near) << k;
    EXPECT_NEAR(convex_test::length(hit->normal), 1, 1e-9) << k;
    // The shapes touch at the reported fraction, and the plane through the reported point separates them.
    const Convex met = cast.a(hit->fraction);
    EXPECT_NEAR(closest_points(met, cast.b()).distance, 0, near) << k;
    EXPECT_NEAR(dot(support(cast.b(), hit->normal) - hit->point, hit->normal), 0, near) << k;
    EXPECT_NEAR(dot(support(met, -hit->normal) - hit->point, hit->normal), 0, near) << k;
    EXPECT_FALSE(cast_convex(cast.a(), cast.way, cast.b(), 0.999 * hit->fraction)) << k;
    // The result is the same when the search begins at a fraction before which they do not meet.
    const auto later = cast_convex(cast.a(), cast.way, cast.b(), 1, {{}, 0.7 * hit->fraction});
    ASSERT_TRUE(later) << k;
    EXPECT_NEAR(later->fraction * steep, hit->fraction * steep, near) << k;
}

TEST(BallSweeps, AreThoseOfConservativeAdvancement) {
    Random random(1);
    Counts counts;
    for (int k = 0; k < 40000; ++k) expect_that_of_advancement(any_cast(random, k), k, counts);
    EXPECT_GT(counts.hits, 10000);
    EXPECT_GT(counts.misses, 5000);
}

TEST(CapsuleSweeps, OfBoxesAreThoseOfConservativeAdvancement) {
    Random random(3);
    Counts counts;
    for (int k = 0; k < 40000; ++k) expect_that_of_advancement(any_cast_of_capsule(random, k), k, counts);
    EXPECT_GT(counts.hits, 10000);
    EXPECT_GT(counts.misses, 5000);
}

TEST(BallSweeps, OverlapsFromTheStartTellTheLeastWayApart) {
    Random random(2);
    int within = 0;
    for (int k = 0; k < 20000; ++k) {
        const Cast cast = any_cast(random, k);
        const auto least = closest_points(cast.a(), cast.b());
        if (!(least.distance < -cast.tolerance())) continue;
        ++within;
        auto hit = cast_convex(cast.a(), cast.way, cast.b());
        ASSERT_TRUE(hit) << k;
        EXPECT_EQ(hit->fraction, 0) << k;
        if (hit->normal == DVec3{}) hit = overlap_hit(cast.a(), cast.b());
        const double lowest = dot(support(cast.a(), -hit->normal), hit->normal),
                     highest = dot(support(cast.b(), hit->normal), hit->normal);
        // Moving apart along any normal takes at least the penetration depth; EPA's normal is within one part in 10,000
        // of the minimum, or less exact with 64 vertices.
        EXPECT_GT(lowest - highest, least.distance - 1e-4 * std::fabs(least.distance)) << k;
        EXPECT_NEAR(dot(hit->point, hit->normal), highest, 2e-4 * std::fabs(least.distance)) << k;
        EXPECT_TRUE(contains(cast.b(), hit->point + 1e-9 * (cast.b().center - hit->point))) << k;
    }
    EXPECT_GT(within, 3000);
}

TEST(Overlaps, OfAnyTwoAreThoseOfTheDistance) {
    Random random(3);
    int met = 0, apart = 0;
    for (int k = 0; k < 60000; ++k) {
        const Solid sa = any_solid(random, 1), sb = k % 3 == 0 ? any_with_formula(random, 1) : any_solid(random, 1);
        const Convex a = sa.at(random.uniform(0, 2) * random.direction(), random.rotation()),
                     b = sb.at({}, random.rotation());
        const double distance = closest_points(a, b).distance;
        if (std::fabs(distance) < 1e-6) continue;
        ++(distance < 0 ? met : apart);
        ASSERT_EQ(overlap(a, b), distance < 0) << k << ": " << distance;
        const auto hit = cast_convex(a, {0, -1e-3, 0}, b);
        ASSERT_EQ(hit && hit->fraction == 0, distance < 0) << k << ": " << distance;
    }
    EXPECT_GT(met, 10000);
    EXPECT_GT(apart, 10000);
}

TEST(Hulls, HoldTheBallWithinThem) {
    Random random(4);
    for (int k = 0; k < 300; ++k) {
        const double size = std::pow(10, random.uniform(-3, 3));
        const Solid solids[] = {hull(tetrahedron(size)), hull(dodecahedron(size)),
                                hull(prism(3 + random.below(20), size * random.uniform(0.02, 1), size))};
        const Convex c = solids[k % 3].at({}, random.rotation());
        EXPECT_GT(c.hull->inner_radius, 0.2 * double(c.hull->width)) << k;
        for (int i = 0; i < 100; ++i)
            EXPECT_TRUE(contains(c, middle(c) + c.hull->inner_radius * random.direction())) << k;
    }
}

} // namespace
