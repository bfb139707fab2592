// The sphere kernels of every backend, compared with scalar formulas in double precision.
#include "collide_test_support.h"

#include <algorithm>
#include <string>

using namespace collide_test;

namespace {

constexpr double margin = 0.02;

// The expected manifold of a sphere: the other surface is `separation` away along `normal`.
struct Expected {
    bool touching;
    double separation;
    Vec normal;
    bool clear; // the normal is unique, so that it can be compared
};

void compare(const char* name, const cairn::KernelTable* table, cairn::CollideKernel kernel, const Pairs& pairs,
             Expected (*oracle)(const Frame&, const Frame&, double), int min_touching) {
    const std::vector<Manifold> manifolds = run(kernel, pairs);
    int touching = 0, apart = 0;
    for (int i = 0; i < pairs.count(); ++i) {
        const Manifold& m = manifolds[static_cast<std::size_t>(i)];
        const Frame a = frame_of(pairs.first(i)), b = frame_of(pairs.second(i));
        const Expected e = oracle(a, b, pairs.margin(i));
        ASSERT_EQ(flaw(m, pairs.margin(i)), "") << name << ", " << table->name << ", pair " << i;
        touching += m.count;
        if (reported_distance(m) > 0) ++apart;
        const double tolerance = 1e-6 * (1.0 + length(b.center - a.center) + length(b.half) + a.half[0]);
        ASSERT_LE(reported_distance(m), e.separation + tolerance) << name << ", " << table->name << ", pair " << i;
        if (std::fabs(e.separation - pairs.margin(i)) < tolerance || !e.clear) continue;
        ASSERT_EQ(m.count, e.touching ? 1 : 0)
            << name << ", " << table->name << ", pair " << i << ", separation " << e.separation;
        if (m.count == 0) continue;
        ASSERT_NEAR(separation_of(m, 0), e.separation, tolerance) << name << ", " << table->name << ", pair " << i;
        ASSERT_GT(dot(normal_of(m), e.normal), 1 - 1e-5) << name << ", " << table->name << ", pair " << i;
        const Vec middle = (a.half[0] + 0.5 * e.separation) * e.normal;
        ASSERT_LT(length(point_of(m, 0) - middle), 10 * tolerance + 2e-5 * length(middle))
            << name << ", " << table->name << ", pair " << i;
    }
    EXPECT_GE(touching, min_touching) << name << ", " << table->name;
    EXPECT_GT(apart, 500) << name << ", " << table->name << ": the distance is known";
}

Expected expect_sphere_sphere(const Frame& a, const Frame& b, double limit) {
    const Vec d = b.center - a.center;
    const double distance = length(d), separation = distance - a.half[0] - b.half[0];
    return {separation <= limit, separation, (1 / distance) * d, distance > 1e-3};
}

// The closest point of the box by clamping; for a center inside the box, the nearest face.
Expected expect_sphere_box(const Frame& a, const Frame& b, double limit) {
    const Vec p = b.to_local(a.center);
    Vec closest = p;
    for (std::size_t i = 0; i < 3; ++i) closest[i] = std::clamp(p[i], -b.half[i], b.half[i]);
    const double distance = length(p - closest);
    if (distance > 0) {
        const Vec normal = (1 / distance) * (b.to_world(closest) - a.center);
        return {distance - a.half[0] <= limit, distance - a.half[0], normal, distance > 0.02};
    }
    Vec gaps;
    for (std::size_t i = 0; i < 3; ++i) gaps[i] = b.half[i] - std::fabs(p[i]);
    const std::size_t k = static_cast<std::size_t>(std::min_element(gaps.begin(), gaps.end()) - gaps.begin());
    Vec sorted = gaps;
    std::sort(sorted.begin(), sorted.end());
    return {true, -gaps[k] - a.half[0], (p[k] > 0 ? -1.0 : 1.0) * b.axis[k],
            sorted[1] - sorted[0] > 1e-4 && sorted[0] > 1e-4};
}

Expected expect_sphere_plane(const Frame& a, const Frame& b, double limit) {
    const double separation = dot(b.axis[1], a.center - b.center) - a.half[0];
    return {separation <= limit, separation, -1.0 * b.axis[1], true};
}

Expected expect_sphere_rectangle(const Frame& a, const Frame& b, double limit) {
    const Vec p = b.to_local(a.center);
    const double over_x = b.half[0] - std::fabs(p[0]), over_z = b.half[2] - std::fabs(p[2]);
    if (p[1] >= 0) {
        const Vec closest = {std::clamp(p[0], -b.half[0], b.half[0]), 0, std::clamp(p[2], -b.half[2], b.half[2])};
        const double distance = length(p - closest);
        return {distance - a.half[0] <= limit, distance - a.half[0], (1 / distance) * (b.to_world(closest) - a.center),
                p[1] > 0.02};
    }
    const bool lifted = over_x > 0 && over_z > 0 && -p[1] < a.half[0];
    const bool clear =
        p[1] < -1e-4 && std::fabs(over_x) > 1e-4 && std::fabs(over_z) > 1e-4 && std::fabs(p[1] + a.half[0]) > 1e-4;
    return {lifted && p[1] - a.half[0] <= limit, p[1] - a.half[0], -1.0 * b.axis[1], clear};
}

Vec somewhere(Random& random) { return {random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-20, 20)}; }

} // namespace

TEST(CollideSphere, SphereSphereAgreesWithTheFormula) {
    Random random(1);
    Pairs pairs;
    for (int i = 0; i < 5000; ++i) {
        const Vec center = somewhere(random);
        const double ra = random.uniform(0.05, 1), rb = random.uniform(0.05, 1);
        const Vec offset = random.uniform(0.02, 1.2 * (ra + rb)) * random.direction();
        pairs.add(sphere(center, ra, random.rotation()), sphere(center + offset, rb), static_cast<float>(margin));
    }
    for (const cairn::KernelTable* table : backends())
        compare("sphere-sphere", table, table->sphere_sphere, pairs, expect_sphere_sphere, 3000);
}

TEST(CollideSphere, ConcentricSpheresGiveAUnitNormal) {
    for (const cairn::KernelTable* table : backends()) {
        const Manifold m = run_one(table->sphere_sphere, sphere({1, 2, 3}, 0.5), sphere({1, 2, 3}, 0.25), 0.0f);
        ASSERT_EQ(flaw(m, 0.0), "");
        EXPECT_EQ(m.count, 1);
        EXPECT_FLOAT_EQ(m.points[0][3], -0.75f);
    }
}

TEST(CollideSphere, SphereBoxAgreesWithTheFormula) {
    Random random(2);
    Pairs pairs;
    for (int i = 0; i < 10000; ++i) {
        const Vec center = somewhere(random);
        const Vec half = {random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)};
        const double radius = random.uniform(0.05, 0.8);
        const Vec offset = random.uniform(0, 1.2 * (radius + length(half))) * random.direction();
        pairs.add(sphere(center, radius), box(center + offset, random.rotation(), half), static_cast<float>(margin));
    }
    for (const cairn::KernelTable* table : backends())
        compare("sphere-box", table, table->sphere_box, pairs, expect_sphere_box, 4000);
}

TEST(CollideSphere, CenterInsideABoxLeavesThroughTheNearestFace) {
    for (const cairn::KernelTable* table : backends()) {
        const ShapePose crate = box({0, 0, 0}, no_rotation, {1, 2, 3});
        const Manifold high = run_one(table->sphere_box, sphere({0.1, 1.75, 0.2}, 0.5), crate, 0.0f);
        EXPECT_FLOAT_EQ(high.normal[1], -1.0f);
        EXPECT_FLOAT_EQ(high.points[0][3], -0.75f);
        const Manifold middle = run_one(table->sphere_box, sphere({0, 0, 0}, 0.5), crate, 0.0f);
        EXPECT_FLOAT_EQ(middle.normal[0], -1.0f);
        EXPECT_FLOAT_EQ(middle.points[0][3], -1.5f);
        const Manifold on_face = run_one(table->sphere_box, sphere({0, -2, 0}, 0.5), crate, 0.0f);
        ASSERT_EQ(flaw(on_face, 0.0), "");
        EXPECT_FLOAT_EQ(on_face.normal[1], 1.0f);
        EXPECT_FLOAT_EQ(on_face.points[0][3], -0.5f);
    }
}

TEST(CollideSphere, SpherePlaneAgreesWithTheFormula) {
    Random random(3);
    Pairs pairs;
    for (int i = 0; i < 5000; ++i) {
        const ShapePose ground = plane(somewhere(random), random.rotation());
        const Frame f = frame_of(ground);
        const double radius = random.uniform(0.05, 1);
        const Vec local = {random.uniform(-5, 5), random.uniform(-2, 2), random.uniform(-5, 5)};
        pairs.add(sphere(f.to_world(local), radius), ground, static_cast<float>(margin));
    }
    for (const cairn::KernelTable* table : backends())
        compare("sphere-plane", table, table->sphere_plane, pairs, expect_sphere_plane, 2500);
}

TEST(CollideSphere, SphereRectangleAgreesWithTheRule) {
    Random random(4);
    Pairs pairs;
    for (int i = 0; i < 20000; ++i) {
        const double hx = random.uniform(0.2, 2), hz = random.uniform(0.2, 2);
        const ShapePose floor = rectangle(somewhere(random), random.rotation(), hx, hz);
        const Frame f = frame_of(floor);
        const Vec local = {random.uniform(-1.5, 1.5) * hx, random.uniform(-1, 1), random.uniform(-1.5, 1.5) * hz};
        pairs.add(sphere(f.to_world(local), random.uniform(0.05, 1)), floor, static_cast<float>(margin));
    }
    for (const cairn::KernelTable* table : backends())
        compare("sphere-rectangle", table, table->sphere_rectangle, pairs, expect_sphere_rectangle, 6000);
}

TEST(CollideSphere, RectangleIsOneSided) {
    const ShapePose floor = rectangle({0, 0, 0}, no_rotation, 2, 1);
    struct Case {
        Vec center;
        int count;
        double up, sideways; // components of the normal impulse's direction on the sphere
    };
    const Case cases[] = {{{0, 0.4, 0}, 1, 1, 0},       {{0, -0.4, 0}, 1, 1, 0},   {{0, -0.6, 0}, 0, 0, 0},
                          {{2.3, 0.4, 0}, 1, 0.8, 0.6}, {{2.3, -0.1, 0}, 0, 0, 0}, {{0, 0, 0}, 1, 1, 0},
                          {{0, 0.6, 0}, 0, 0, 0}};
    for (const cairn::KernelTable* table : backends())
        for (const Case& c : cases) {
            const Manifold m = run_one(table->sphere_rectangle, sphere(c.center, 0.5), floor, 0.01f);
            ASSERT_EQ(flaw(m, 0.01), "");
            ASSERT_EQ(m.count, c.count) << c.center[0] << " " << c.center[1];
            EXPECT_NEAR(-m.normal[1], c.up, 1e-6);
            EXPECT_NEAR(-m.normal[0], c.sideways, 1e-6);
        }
}
