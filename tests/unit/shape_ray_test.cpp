// Rays against capsules, cylinders and hulls, compared with the zeros of convex functions that are negative inside.
#include "geometry_test_support.h"

#include <functional>
#include <gtest/gtest.h>

namespace cairn {

namespace {

using math::DVec3;
using test::Random;
using test::sample_of;

// A convex function, negative inside, that increases by one per meter along the outward normal.
using Inside = std::function<double(DVec3)>;

// The minimum of a convex function of one variable, by golden-section search.
template <class F> double minimize(F&& f, double lo, double hi) {
    const double ratio = (std::sqrt(5.0) - 1) / 2;
    double a = hi - ratio * (hi - lo), b = lo + ratio * (hi - lo), fa = f(a), fb = f(b);
    for (int i = 0; i < 90; ++i) {
        if (fa < fb) {
            hi = b, b = a, fb = fa;
            a = hi - ratio * (hi - lo), fa = f(a);
        } else {
            lo = a, a = b, fa = fb;
            b = lo + ratio * (hi - lo), fb = f(b);
        }
    }
    return (lo + hi) / 2;
}

Inside inside_of(const Capsule& c) {
    const double h = double(c.half_height), a = double(c.radius), b = double(c.radius_top.value_or(c.radius));
    return [=](DVec3 p) { // the nearest of the balls between the two ends
        auto distance = [&](double l) { return math::length(p - DVec3{0, (2 * l - 1) * h, 0}) - (a + (b - a) * l); };
        const double l = minimize(distance, 0, 1);
        return std::min(std::min(distance(0), distance(1)), distance(l));
    };
}
Inside inside_of(const Cylinder& c) {
    const double h = double(c.half_height), a = double(c.radius), b = double(c.radius_top.value_or(c.radius));
    const double cosine = 2 * h / std::sqrt(4 * h * h + (a - b) * (a - b));
    return [=](DVec3 p) {
        const double radius = a + (b - a) * (p.y + h) / (2 * h);
        return std::max(std::fabs(p.y) - h, cosine * (std::sqrt(p.x * p.x + p.z * p.z) - radius));
    };
}
Inside inside_of(std::shared_ptr<const HullData> hull) {
    return [=](DVec3 p) {
        double most = -1e30;
        for (const HullFace& face : hull->faces)
            most = std::max(most, math::dot(math::to_double(face.normal), p) - double(face.offset));
        return most;
    };
}

// The shape rounded by a ball; outside, `sharp` must be the exact distance.
Inside rounded(const Inside& sharp, double radius) {
    return [=](DVec3 p) { return sharp(p) - radius; };
}
// Distances to sharp solids.
Inside distance_to(const Box& box) {
    const DVec3 half{box.half_extents.x, box.half_extents.y, box.half_extents.z};
    return [=](DVec3 p) {
        const DVec3 q = math::abs(p) - half;
        return math::length(math::max(q, DVec3{})) + std::min(0.0, std::max({q.x, q.y, q.z}));
    };
}
// In the half plane of the axis and the point: the distance to the three sides of a trapezoid.
Inside distance_to(const Cylinder& c) {
    const double h = double(c.half_height), a = double(c.radius), b = double(c.radius_top.value_or(c.radius));
    const Inside inside = inside_of(c);
    return [=](DVec3 p) {
        const double depth = inside(p);
        if (depth <= 0) return depth;
        const DVec3 flat{std::sqrt(p.x * p.x + p.z * p.z), p.y, 0};
        const DVec3 corners[4] = {{0, -h, 0}, {a, -h, 0}, {b, h, 0}, {0, h, 0}};
        double least = 1e30;
        for (int i = 0; i < 3; ++i) {
            const DVec3 from = corners[i], along = corners[i + 1] - from;
            const double square = math::dot(along, along);
            const double t = square > 0 ? std::clamp(math::dot(flat - from, along) / square, 0.0, 1.0) : 0;
            least = std::min(least, math::length(flat - (from + t * along)));
        }
        return least;
    };
}

struct RayCheck {
    test::Sample shape;
    Inside inside;
    double reach; // size of the shape
    int hits = 0, misses = 0;

    // The ray starts `away` from the plane through the point it is aimed at, well outside the shape.
    void check(Random& random, DVec3 aim, DVec3 d, double away, double tolerance) {
        const math::Quat q = random.rotation();
        const math::DQuat r = math::normalized(math::to_double(q));
        const DVec3 position = random.point(10);
        const DVec3 origin = aim - away * d;
        const auto hit = cast_ray(shape.geometry, shape.data, position, q, position + math::rotate(r, origin),
                                  math::rotate(r, d), 1e9);
        auto at = [&](double t) { return inside(aim + t * d); }; // 0 at the point it is aimed at
        const double deepest = minimize(at, -3 * reach, 3 * reach);
        if (std::fabs(at(deepest)) < 2e-6 * reach) return; // a grazing ray
        if (at(deepest) > 0) {
            ASSERT_FALSE(hit);
            ++misses;
            return;
        }
        double out = -4 * reach, in = deepest;
        for (int i = 0; i < 100; ++i) (at((out + in) / 2) > 0 ? out : in) = (out + in) / 2;
        ASSERT_TRUE(hit);
        ++hits;
        // Where the ray grazes a rounded side, a position error is amplified by this factor along the ray.
        const double slope = std::sqrt(reach / std::max(-at(deepest), 1e-12));
        ASSERT_NEAR(hit->distance - away, in, tolerance * reach * slope);
        const DVec3 n = math::rotate_back(r, hit->normal), p = aim + (hit->distance - away) * d;
        ASSERT_NEAR(math::length(n), 1, 1e-12);
        ASSERT_LT(math::dot(n, d), 1e-9);
        const double step = 1e-3 * reach;
        ASSERT_NEAR(inside(p + step * n), step, 2e-5 * step + tolerance * reach * slope);
    }
};

template <class S>
void expect_rays_meet(const S& shape, const test::Sample& sample, double reach, int rounds, std::uint64_t seed) {
    Random random(seed);
    RayCheck check{sample, inside_of(shape), reach};
    for (int i = 0; i < rounds; ++i) {
        check.check(random, random.point(reach), random.direction(), 5 * reach, 1e-10);
        check.check(random, random.point(reach), random.direction(), 1e6, 1e-8);
        // Along the coordinate axes, and slightly off them.
        DVec3 d;
        d[int(random.below(3))] = random(-1, 1) < 0 ? -1 : 1;
        check.check(random, random.point(reach), d, 5 * reach, 1e-10);
        d = math::normalized(d + 1e-7 * random.direction());
        check.check(random, random.point(reach), d, 5 * reach, 1e-10);
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(check.hits, rounds / 5);
    EXPECT_GT(check.misses, rounds / 5);
}

TEST(ShapeRay, MeetsCapsules) {
    std::uint64_t seed = 10;
    for (const Capsule& c : {Capsule{0.5f, 0.25f}, Capsule{1.0f, 0.5f, 0.2f}, Capsule{0.5f, 0.2f, 0.9f},
                             Capsule{0.5f, 0.4f, 0.0f}, Capsule{0.2f, 0.3f, 1.0f}}) {
        SCOPED_TRACE(testing::Message() << c.half_height << " " << c.radius << " " << c.radius_top.value_or(-1));
        expect_rays_meet(c, sample_of(Shape(c)), 1.5, 300, ++seed);
    }
}

TEST(ShapeRay, MeetsCylindersAndCones) {
    std::uint64_t seed = 20;
    for (const Cylinder& c : {Cylinder{0.5f, 0.5f}, Cylinder{1.0f, 0.5f, 0.2f}, Cylinder{0.5f, 0.2f, 0.9f},
                              cone(0.8f, 0.6f), Cylinder{0.05f, 1.0f}}) {
        SCOPED_TRACE(testing::Message() << c.half_height << " " << c.radius << " " << c.radius_top.value_or(-1));
        expect_rays_meet(c, sample_of(Shape(c)), 1.5, 3000, ++seed);
    }
}

TEST(ShapeRay, MeetsHulls) {
    for (const int sides : {3, 4, 10}) {
        const auto hull = test::prism(sides, {0.7, 0.8, 0.9}, 0.3);
        expect_rays_meet(hull, sample_of(hull), 1.5, 3000, std::uint64_t(30 + sides));
    }
}

// Conservative advancement stops within one billionth of the size.
template <class S> void expect_rays_meet_rounded(S shape, float radius, double reach, std::uint64_t seed) {
    SCOPED_TRACE(testing::Message() << radius);
    const Inside inside = rounded(distance_to(shape), double(radius));
    shape.rounding = radius;
    Random random(seed);
    RayCheck check{sample_of(Shape(shape)), inside, reach};
    for (int i = 0; i < 300; ++i) {
        check.check(random, random.point(reach), random.direction(), 5 * reach, 1e-8);
        check.check(random, random.point(reach), random.direction(), 1e6, 2e-8);
        DVec3 d;
        d[int(random.below(3))] = random(-1, 1) < 0 ? -1 : 1;
        check.check(random, random.point(reach), d, 5 * reach, 1e-8);
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(check.hits, 60);
    EXPECT_GT(check.misses, 60);
}

TEST(ShapeRay, MeetsRoundedShapes) {
    std::uint64_t seed = 50;
    for (const float radius : {0.01f, 0.1f, 0.4f}) {
        expect_rays_meet_rounded(Box{{0.5f, 0.3f, 0.8f}}, radius, 1.6, ++seed);
        expect_rays_meet_rounded(Cylinder{0.5f, 0.5f}, radius, 1.4, ++seed);
        expect_rays_meet_rounded(Cylinder{0.5f, 0.8f, 0.3f}, radius, 1.4, ++seed);
        expect_rays_meet_rounded(cone(0.6f, 0.6f), radius, 1.4, ++seed);
    }
}

TEST(ShapeRay, ARoundedHullOfABoxIsARoundedBox) {
    Random random(80);
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) corners.push_back({i & 1 ? 0.5f : -0.5f, i & 2 ? 0.3f : -0.3f, i & 4 ? 0.8f : -0.8f});
    Hull hull(corners);
    hull.rounding = 0.2f;
    const test::Sample a = sample_of(Shape(hull)), b = sample_of(Shape(Box{{0.5f, 0.3f, 0.8f}, 0.2f}));
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const DVec3 origin = 3.0 * random.direction(), d = math::normalized(random.point(1) - origin);
        const auto first = cast_ray(a.geometry, a.data, {}, {}, origin, d, 10);
        const auto second = cast_ray(b.geometry, b.data, {}, {}, origin, d, 10);
        ASSERT_EQ(first.has_value(), second.has_value());
        if (!first) continue;
        ++hits;
        ASSERT_NEAR(first->distance, second->distance, 1e-6);
    }
    EXPECT_GT(hits, 500);
}

TEST(ShapeRay, FromWithinARoundedShapeMeetsNothing) {
    Random random(81);
    const test::Sample s = sample_of(Shape(Box{{0.5f, 0.3f, 0.8f}, 0.2f}));
    // In the core, in a slab beside a face, at a corner.
    for (const DVec3 origin : {DVec3{}, DVec3{0.69, 0, 0}, DVec3{0.6, 0.4, 0.9}})
        for (int i = 0; i < 100; ++i)
            ASSERT_FALSE(cast_ray(s.geometry, s.data, {}, {}, origin, random.direction(), 10));
    const DVec3 inward = math::normalized(DVec3{-1, -1, -1});
    EXPECT_TRUE(cast_ray(s.geometry, s.data, {}, {}, {0.65, 0.45, 0.95}, inward, 10)) << "beside the round corner";
}

// Rays aimed from all directions at edges, where sides meet: none passes through to the other side.
TEST(ShapeRay, PassesNowhereBetweenTheSidesOfACylinder) {
    Random random(41);
    for (const Cylinder& c : {Cylinder{0.5f, 0.5f}, Cylinder{0.5f, 1.0f, 0.25f}, cone(0.5f, 1.0f)}) {
        const test::Sample s = sample_of(Shape(c));
        for (int i = 0; i < 100000; ++i) {
            const double angle = random(0, 7), radius = double(c.radius), h = double(c.half_height);
            const DVec3 rim{radius * std::cos(angle), -h, radius * std::sin(angle)};
            const DVec3 within{random(-0.1, 0.1), random(-0.8, 0.3) * h, random(-0.1, 0.1)};
            const DVec3 d = math::normalized(within - rim);
            const auto hit = cast_ray(s.geometry, s.data, {}, {}, rim - 3.0 * d, d, 100);
            ASSERT_TRUE(hit);
            ASSERT_NEAR(hit->distance, 3, 1e-9);
        }
    }
}

TEST(ShapeRay, DoesNotMeetVolumesFromWithin) {
    Random random(42);
    const auto hull = test::prism(6, {1, 1, 1}, 0);
    const test::Sample samples[] = {sample_of(Shape(Capsule{0.5f, 0.5f, 0.4f})), sample_of(Shape(Cylinder{0.5f, 0.5f})),
                                    sample_of(Shape(cone(1.0f, 1.0f))), sample_of(hull)};
    for (const test::Sample& s : samples)
        for (int i = 0; i < 1000; ++i)
            ASSERT_FALSE(cast_ray(s.geometry, s.data, {}, {}, random.point(0.15), random.direction(), 100));
}

TEST(ShapeRay, EndsAtItsLengthAndDoesNotLookBack) {
    for (const Shape& shape : {Shape(Capsule{0.5f, 0.5f}), Shape(Cylinder{1.0f, 0.5f})}) {
        const test::Sample s = sample_of(shape); // extends from -1 m to 1 m in y
        EXPECT_FALSE(cast_ray(s.geometry, s.data, {}, {}, {0.1, 3, 0}, {0, -1, 0}, 1.99));
        EXPECT_TRUE(cast_ray(s.geometry, s.data, {}, {}, {0.1, 3, 0}, {0, -1, 0}, 2.02));
        EXPECT_FALSE(cast_ray(s.geometry, s.data, {}, {}, {0.1, 3, 0}, {0, 1, 0}, 100));
    }
}

// Thin and long: the ray's distance from the axis must not be lost in rounding by the length of the cylinder.
TEST(ShapeRay, MeetsALongThinCylinderWithinItsOwnPrecision) {
    const test::Sample s = sample_of(Shape(Cylinder{1e4f, 1e-3f}));
    const DVec3 d = math::normalized(DVec3{1, 0.5, 0});
    const double radius = double(1e-3f);
    for (const double z : {0.0, 0.5e-3, 0.99e-3}) {
        const DVec3 aim{0, 7000, z};
        const auto hit = cast_ray(s.geometry, s.data, {}, {}, aim - 5000.0 * d, d, 1e6);
        ASSERT_TRUE(hit);
        EXPECT_NEAR((5000 - hit->distance) * d.x, std::sqrt(radius * radius - z * z), 1e-10);
        EXPECT_NEAR(hit->normal.z, z / radius, 1e-7);
    }
    EXPECT_FALSE(cast_ray(s.geometry, s.data, {}, {}, DVec3{0, 7000, 1.01e-3} - 5000.0 * d, d, 1e6));
}

} // namespace

} // namespace cairn
