// Sweeps of vertices and cylinders past each other, compared with conservative advancement by distances alone.
#include "cast_test_support.h"
#include "shapes/gjk.h"

#include <gtest/gtest.h>

namespace {

using namespace convex_test;

Solid any_polytope(Random& random, double size) {
    switch (random.below(5)) {
    case 0:
        return hull(tetrahedron(size));
    case 1:
        return hull(dodecahedron(0.6 * size));
    case 2:
        return hull(prism(3 + random.below(9), size * random.uniform(0.1, 1), size * random.uniform(0.1, 1)));
    default:
        return box(size * random.uniform(0.05, 1), size * random.uniform(0.05, 1), size * random.uniform(0.05, 1));
    }
}
// A straight or tapered cylinder, or a cone.
Solid any_cylinder(Random& random, double size) {
    const double half = size * random.uniform(0.05, 1), radius = size * random.uniform(0.05, 1);
    const int kind = random.below(6);
    if (kind == 0) return cylinder(half, radius, 0);
    if (kind == 1) return cylinder(half, radius, size * random.uniform(0.05, 1));
    return cylinder(half, radius);
}

Cast any_cast_of_cylinder(Random& random, int k) {
    const double size = random.below(3) == 0 ? random.uniform(2, 8) : random.uniform(0.2, 1);
    Cast c{any_polytope(random, size), any_cylinder(random, random.uniform(0.2, 1)), {}, {}, any_turn(random, k % 3),
           any_turn(random, k / 3 % 3)};
    if (k % 2 == 0) std::swap(c.moving, c.still);
    c.from = (size + 1) * random.uniform(0, 2) * random.direction();
    c.way = -1.5 * c.from + random.uniform(0, 3) * (size + 1) * random.direction();
    return c;
}

TEST(CylinderSweeps, AreThoseOfConservativeAdvancement) {
    Random random(1);
    int hits = 0, misses = 0, at_once = 0;
    for (int k = 0; k < 40000; ++k) {
        const Cast cast = any_cast_of_cylinder(random, k);
        const auto expected = advance(cast), hit = cast_convex(cast.a(), cast.way, cast.b());
        const double near = 4 * cast.tolerance(), length = convex_test::length(cast.way);
        if (hit.has_value() != expected.has_value()) { // only where they pass each other within this distance
            const auto least = closest_points(cast.a(hit ? hit->fraction : expected->fraction), cast.b());
            EXPECT_LT(std::fabs(dot(least.normal, cast.way)), 1e-3 * length) << k;
            EXPECT_LT(std::fabs(least.distance), near) << k;
            continue;
        }
        if (!hit) {
            ++misses;
            continue;
        }
        if (expected->fraction == 0) {
            ++at_once;
            EXPECT_EQ(hit->fraction, 0) << k;
            continue;
        }
        ++hits;
        // The error of the fraction depends on how steeply the shapes meet.
        const double steep = std::min(-dot(hit->normal, cast.way), -dot(expected->normal, cast.way));
        EXPECT_NEAR(hit->fraction * steep, expected->fraction * steep, near) << k;
        EXPECT_NEAR(convex_test::length(hit->normal), 1, 1e-9) << k;
        EXPECT_GT(steep, 0) << k;
        const Convex met = cast.a(hit->fraction);
        EXPECT_TRUE(nearest_point(cast.b(), hit->point, near)) << k;
        EXPECT_TRUE(nearest_point(met, hit->point, near)) << k;
        // The plane through the point separates the shapes.
        EXPECT_LT(dot(support(cast.b(), hit->normal) - hit->point, hit->normal), near) << k;
        EXPECT_GT(dot(support(met, -hit->normal) - hit->point, hit->normal), -near) << k;
    }
    EXPECT_GT(hits, 10000);
    EXPECT_GT(misses, 5000);
    EXPECT_GT(at_once, 2000);
}

TEST(CylinderSweeps, LimitsCount) {
    Random random(2);
    int hits = 0;
    for (int k = 0; k < 10000; ++k) {
        const Cast cast = any_cast_of_cylinder(random, k);
        const auto hit = cast_convex(cast.a(), cast.way, cast.b());
        if (!hit || hit->fraction < 1e-3) continue;
        ++hits;
        EXPECT_FALSE(cast_convex(cast.a(), cast.way, cast.b(), 0.999 * hit->fraction)) << k;
        EXPECT_TRUE(cast_convex(cast.a(), cast.way, cast.b(), 1.001 * hit->fraction)) << k;
        EXPECT_FALSE(cast_convex(cast.a(), -cast.way, cast.b())) << k;
    }
    EXPECT_GT(hits, 3000);
}

} // namespace
