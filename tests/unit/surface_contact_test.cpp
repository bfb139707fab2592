// Convex shapes against planes, and against the front side of rectangles and triangles.
#include "collision/convex_contact.h"
#include "convex_test_support.h"

#include <gtest/gtest.h>

namespace {

using namespace convex_test;
using cairn::collide_plane;
using cairn::collide_surface;
using cairn::Manifold;
using cairn::SurfaceContact;
using Part = SurfaceContact::Part;

constexpr DVec3 up{0, 1, 0};

TEST(PlaneContact, TheDeepestPointIsTheLowestOfTheShape) {
    Random random(1);
    for (int k = 0; k < 20000; ++k) {
        const Solid s = any_solid(random, 1);
        const Convex a = s.at({}, random.rotation());
        const DVec3 n = random.direction();
        const double height = random.uniform(-0.2, 1.2), margin = 0.05;
        const double lowest = height + dot(support(a, -n), n);
        Manifold m;
        collide_plane(a, n, height, margin, m);
        ASSERT_EQ(m.count > 0, float(lowest) <= float(margin)) << k;
        if (m.count == 0) continue;
        EXPECT_NEAR(deepest(m), lowest, 1e-6) << k;
        for (int i = 0; i < m.count; ++i) {
            const DVec3 p{m.points[i][0], m.points[i][1], m.points[i][2]};
            EXPECT_NEAR(dot(p, n) + height, 0.5 * m.points[i][3], 1e-6) << k; // midway between the surfaces
            EXPECT_LE(m.points[i][3], float(margin));
        }
    }
}

TEST(PlaneContact, ShapesAtRestHaveAllTheirPoints) {
    struct Rest {
        Solid solid;
        double half;
        DQuat q;
        int count;
    };
    const Rest rests[] = {{box(0.5, 0.4, 0.3), 0.4, {}, 4},         {hull(prism(6, 0.5, 0.25)), 0.25, {}, 4},
                          {cylinder(0.5, 0.25), 0.5, {}, 4},        {cylinder(0.5, 0.25, 0), 0.5, {}, 4},
                          {cylinder(0.5, 0.25), 0.25, lying, 2},    {capsule(0.5, 0.25), 0.25, lying, 2},
                          {capsule(0.5, 0.25), 0.75, {}, 1},        {ball(0.25), 0.25, {}, 1},
                          {cylinder(0.5, 0.25, 0.125), 0.5, {}, 4}, {capsule(0.5, 0.25, 0.25), 0.25, lying, 2}};
    for (const Rest& r : rests)
        for (double lean : {0.0, 1e-7, 1e-5}) {
            Manifold m;
            collide_plane(r.solid.at({}, about({1, 0, 0}, lean) * r.q), up, r.half, 0.02, m);
            EXPECT_EQ(m.count, r.count) << int(r.solid.geometry.type) << " lean " << lean;
            EXPECT_EQ(m.normal[1], -1);
            for (int i = 0; i < m.count; ++i) EXPECT_NEAR(m.points[i][3], 0, 1e-6 + lean);
        }
}

TEST(PlaneContact, ARollingCylinderTouchesAtItsTwoEndsAlike) {
    for (int k = 0; k < 100; ++k) {
        Manifold m;
        collide_plane(cylinder(0.5, 0.25).at({}, lying * about(up, 0.1 * k)), up, 0.25, 0.02, m);
        ASSERT_EQ(m.count, 2);
        EXPECT_FLOAT_EQ(m.points[0][0], -m.points[1][0]);
        EXPECT_NEAR(std::fabs(m.points[0][0]), 0.5, 1e-6);
        for (int i = 0; i < 2; ++i) {
            EXPECT_NEAR(m.points[i][2], 0, 1e-7);
            EXPECT_NEAR(m.points[i][3], 0, 1e-7);
        }
    }
}

TEST(PlaneContact, ATaperedCylinderLiesOnItsSide) {
    // The side descends by 0.25 over a length of 1: the axis leans by the same slope.
    const double angle = std::atan(0.25);
    const DQuat q = about({0, 0, 1}, 1.5707963267948966 + angle);
    const Convex a = cylinder(0.5, 0.5, 0.25).at({}, q);
    const double lowest = dot(support(a, -up), up);
    Manifold m;
    collide_plane(a, up, -lowest, 0.02, m);
    ASSERT_EQ(m.count, 2);
    EXPECT_NEAR(m.points[0][3], 0, 1e-6);
    EXPECT_NEAR(m.points[1][3], 0, 1e-6);
}

const Convex triangle = cairn::make_triangle({-1, 0, 1}, {1, 0, 1}, {0, 0, -1});

struct Touch {
    Manifold m;
    SurfaceContact c;
};
Touch touch(const Solid& s, DVec3 position, DQuat q = {}, const Convex& surface = triangle, double margin = 0.02) {
    Touch r;
    Convex moved = surface;
    for (DVec3& corner : moved.corners) corner = corner - position;
    moved.center = moved.center - position;
    r.c = collide_surface(s.at({}, q), moved, margin, {}, r.m);
    return r;
}

TEST(TriangleContact, SaysWhichPartOfTheTriangleIsTouched) {
    Touch t = touch(ball(0.5), {0, 0.49, 0});
    EXPECT_EQ(t.c.part, Part::face);
    EXPECT_NEAR(t.c.cosine, 1, 1e-6);
    EXPECT_NEAR(deepest(t.m), -0.01, 1e-6);
    t = touch(ball(0.5), {0.2, 0.3, 1.39});
    EXPECT_EQ(t.c.part, Part::edge);
    EXPECT_EQ(t.c.index, 0);
    EXPECT_NEAR(t.c.cosine, 0.3 / std::hypot(0.3, 0.39), 1e-6);
    t = touch(ball(0.5), {0, 0.3, -1.39});
    EXPECT_EQ(t.c.part, Part::corner);
    EXPECT_EQ(t.c.index, 2);
    t = touch(box(0.3, 0.3, 0.3), {0, 0.299, 0});
    EXPECT_EQ(t.c.part, Part::face);
    EXPECT_EQ(t.m.count, 4);
    EXPECT_EQ(t.m.normal[1], -1);
    EXPECT_NEAR(deepest(t.m), -0.001, 1e-6);
}

TEST(TriangleContact, IsSolidOnOneSide) {
    EXPECT_EQ(touch(ball(0.5), {0, -0.4, 0}).m.normal[1], -1); // below the surface: pushed up
    EXPECT_NEAR(deepest(touch(ball(0.5), {0, -0.4, 0}).m), -0.9, 1e-6);
    EXPECT_EQ(touch(ball(0.5), {0, -1.1, 0}).m.count, 0);   // deeper than its size
    EXPECT_EQ(touch(ball(0.5), {0, -0.1, 1.2}).m.count, 0); // not above the triangle
    EXPECT_EQ(touch(cylinder(0.5, 0.3), {0, -0.2, 0}, lying).m.normal[1], -1);
    Random random(3);
    for (int k = 0; k < 20000; ++k) {
        const Solid s = any_solid(random, random.below(2) ? 1 : 0.2);
        const Touch t = touch(s, 1.5 * random.uniform(0, 1) * random.direction(), random.rotation());
        ASSERT_TRUE(t.m.count >= 0 && t.m.count <= 4);
        if (t.m.count == 0) continue;
        EXPECT_LE(t.m.normal[1], 1e-3f) << k;
        EXPECT_NEAR(length(normal_of(t.m)), 1, 1e-6);
        EXPECT_NEAR(t.c.cosine, -t.m.normal[1], 1e-6);
        for (int i = 0; i < t.m.count; ++i)
            for (float v : t.m.points[i]) EXPECT_TRUE(std::isfinite(v));
    }
}

TEST(TriangleContact, ConvexShapesAboveAreNeverMissed) {
    Random random(4);
    const Convex wide = cairn::make_triangle({-4, 0, 4}, {4, 0, 4}, {0, 0, -4});
    for (int k = 0; k < 10000; ++k) {
        const Solid s = any_solid(random, 0.3);
        const DQuat q = random.rotation();
        const Convex at_origin = s.at({}, q);
        const double half = -dot(support(at_origin, -up), up);
        const double center = dot(middle(at_origin), up);
        if (half + center < 0.002) continue; // the center must be above
        const DVec3 place{random.uniform(-0.2, 0.2), half - 0.001, random.uniform(-0.2, 0.2)};
        const Touch t = touch(s, place, q, wide);
        ASSERT_GE(t.m.count, 1) << k;
        EXPECT_NEAR(t.m.normal[1], -1, 1e-5) << k;
        EXPECT_NEAR(deepest(t.m), -0.001, 2e-5) << k;
    }
}

TEST(TriangleContact, NeedlesAndSplintersGiveSoundManifolds) {
    Random random(5);
    for (int k = 0; k < 20000; ++k) {
        const double thin = std::array{1e-2, 1e-4, 1e-6, 1e-9}[std::size_t(random.below(4))];
        const DVec3 from = random.direction(), d = random.direction();
        const double t = random.uniform(-0.5, 1.5);
        const Convex needle = cairn::make_triangle(from, from + d, from + t * d + thin * random.direction());
        const Touch r =
            touch(any_solid(random, 1), random.uniform(0, 1) * random.direction(), random.rotation(), needle);
        ASSERT_TRUE(r.m.count >= 0 && r.m.count <= 4);
        if (r.m.count == 0) continue;
        EXPECT_NEAR(length(normal_of(r.m)), 1, 1e-5) << k;
        for (int i = 0; i < r.m.count; ++i)
            for (float v : r.m.points[i]) ASSERT_TRUE(std::isfinite(v)) << k;
    }
}

Convex rectangle(double x, double z) {
    cairn::Geometry g;
    g.type = cairn::ShapeType::rectangle;
    g.size = {float(x), 0, float(z)};
    return make_convex(g, {}, {}, {});
}

TEST(RectangleContact, HoldsShapesAboveAndLiftsWhatHasSunk) {
    const Convex r = rectangle(2, 1);
    Touch t = touch(cylinder(0.5, 0.25), {0.3, 0.499, 0.2}, {}, r);
    EXPECT_EQ(t.m.count, 4);
    EXPECT_EQ(t.m.normal[1], -1);
    EXPECT_NEAR(deepest(t.m), -0.001, 1e-6);
    t = touch(capsule(0.5, 0.25), {0.3, 0.249, 0.2}, lying, r);
    EXPECT_EQ(t.m.count, 2);
    t = touch(capsule(0.5, 0.25), {0.3, -0.24, 0.2}, lying, r);
    EXPECT_EQ(t.m.normal[1], -1);
    EXPECT_EQ(touch(capsule(0.5, 0.25), {0.3, -0.26, 0.2}, lying, r).m.count, 0);
    EXPECT_EQ(touch(ball(0.5), {2.6, 0.1, 0}, {}, r).m.count, 0);
    EXPECT_NEAR(touch(ball(0.5), {2.3, 0.3, 0}, {}, r).m.normal[0], -std::sqrt(0.5), 1e-6);
}

} // namespace
