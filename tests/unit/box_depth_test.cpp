// Penetration depth between boxes and other shapes, compared with EPA and with random directions.
#include "cast_test_support.h"
#include "shapes/box_depth.h"

#include <gtest/gtest.h>

namespace {

using namespace convex_test;

// A random shape at the origin; owns the data that the shape refers to.
struct Other {
    explicit Other(Random& random) : solid(any_solid(random, 1)), convex(solid.at({}, random.rotation())) {
        const auto corner = [&] { return random.uniform(0.3, 1.5) * random.direction(); };
        if (random.below(8) == 0) convex = cairn::make_triangle(corner(), corner(), corner());
    }
    Solid solid;
    Convex convex;
};
Convex any_box(Random& random, DVec3 at) {
    const auto u = [&] { return random.below(4) == 0 ? random.uniform(1, 4) : random.uniform(0.05, 0.6); };
    const Solid sharp = box(u(), u(), u());
    return (random.below(4) == 0 ? rounded(sharp, random.uniform(0.02, 0.3)) : sharp).at(at, random.rotation());
}
// The distance by which a shape must move along a unit vector until it is separated from another.
double way_out(const Convex& moving, const Convex& still, DVec3 normal) {
    return dot(support(still, normal) - support(moving, -normal), normal);
}

TEST(BoxDepth, IsThatOfEpaAndNoDirectionHasLess) {
    Random random(1);
    int found = 0, asked = 0, apart = 0, rough = 0;
    for (int k = 0; k < 40000; ++k) {
        const Other any(random);
        const Convex &other = any.convex, box = any_box(random, random.uniform(0, 1.2) * random.direction());
        const cairn::ClosestPoints truth = closest_points(box, other);
        const double radii = outer_radius(box) + outer_radius(other);
        const auto depth = box_depth(box, other);
        if (truth.distance + radii > 1e-9) { // the cores are separated
            if (!depth) continue;
            ++apart;
            ASSERT_EQ(other.kind, Convex::Kind::capsule) << k;
            EXPECT_NEAR(depth->depth, -(truth.distance + radii), 1e-9) << k;
            EXPECT_NEAR(length(depth->normal - truth.normal), 0, 1e-5) << k;
            continue;
        }
        if (truth.distance + radii > -1e-9) continue;
        ++asked;
        if (!depth) continue;
        ++found;
        const double whole = depth->depth + radii;
        EXPECT_NEAR(length(depth->normal), 1, 1e-9) << k;
        EXPECT_NEAR(way_out(other, box, depth->normal), whole, 1e-9) << k;
        const double least = -(truth.distance + radii);
        EXPECT_LT(depth->depth, (1 + 1e-5) * least + 1e-9) << k;
        rough += depth->depth > (1 + 1.1e-6) * least + 1e-9;
        for (int i = 0; i < 20; ++i)
            EXPECT_GT(way_out(other, box, random.direction()), (1 - 1.1e-6) * whole - 1e-9) << k;
        // The witness points of the cores coincide after the separating translation.
        EXPECT_LT(length(depth->on_other + depth->depth * depth->normal - depth->on_box), 2e-3) << k;
        const double near = 1e-3;
        EXPECT_TRUE(nearest_point(box, depth->on_box, near)) << k;
        EXPECT_TRUE(nearest_point(other, depth->on_other, near)) << k;
    }
    EXPECT_GT(asked, 10000);
    EXPECT_GT(found, asked * 7 / 10);
    EXPECT_GT(apart, 500);
    EXPECT_LE(rough, 4); // EPA results after 64 vertices are less exact
}

// Either of the two shapes is the moving one.
TEST(BoxDepth, TellsWhereWhatStartsWithinMeets) {
    Random random(2);
    int met = 0;
    for (int k = 0; k < 40000; ++k) {
        const Other any(random);
        const Convex &other = any.convex, box = any_box(random, random.uniform(0, 1.2) * random.direction());
        const Convex &moving = k % 2 == 0 ? box : other, &still = k % 2 == 0 ? other : box;
        const double least = closest_points(moving, still).distance;
        if (!(least < -1e-6)) continue;
        ++met;
        const cairn::ConvexHit hit = overlap_hit(moving, still);
        EXPECT_EQ(hit.fraction, 0);
        const double way = way_out(moving, still, hit.normal);
        EXPECT_LT(way, -least * (1 + 1.1e-4) + 1e-9) << k;
        if (!box_depth(box, other)) continue; // solved by EPA, whose witness points are less exact
        EXPECT_NEAR(dot(hit.point - support(still, hit.normal), hit.normal), 0, 2e-4 * way + 1e-9) << k;
        EXPECT_TRUE(nearest_point(still, hit.point, 1e-3)) << k;
        EXPECT_TRUE(nearest_point(moved(moving, way * hit.normal), hit.point, 1e-3)) << k;
    }
    EXPECT_GT(met, 10000);
}

// These pairs have more than one deepest point: the separating translation is minimal all the same.
TEST(BoxDepth, ShapesInLineAreMovedApartByTheLeastWay) {
    Random random(3);
    const Convex box = convex_test::box(0.5, 0.6, 0.7).at({});
    const Solid others[] = {hull(box_hull({0.3, 0.4, 0.5})), cylinder(0.5, 0.3), capsule(0.5, 0.3),
                            rounded(convex_test::box(0.2, 0.3, 0.2), 0.1), cylinder(0.5, 0.4, 0.1)};
    for (const Solid& solid : others)
        for (int k = 0; k < 200; ++k) {
            DVec3 at{random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6)};
            if (k % 4 == 0) at = {};
            const Convex other = solid.at(at);
            const double least = closest_points(other, box).distance;
            if (!(least < -1e-6)) continue;
            const cairn::ConvexHit hit = overlap_hit(other, box);
            const double way = way_out(other, box, hit.normal);
            EXPECT_LT(way, -least * (1 + 1.1e-4) + 1e-9) << k;
            EXPECT_TRUE(nearest_point(box, hit.point, 1e-4)) << k;
            EXPECT_TRUE(nearest_point(moved(other, way * hit.normal), hit.point, 1e-3)) << k;
        }
}

} // namespace
