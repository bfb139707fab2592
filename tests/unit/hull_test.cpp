// Convex hulls: every property of hull_check.h over many point clouds, closed forms, invalid input, and cases found by
// fuzzing.
#include "hull_check.h"

#include <cairn/error.h>
#include <cairn/shape.h>

#include <ctime>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace cairn {
namespace {

using math::DVec3;
using math::Vec3;
using Points = std::vector<Vec3>;

// Generates the same numbers with every standard library: the standard fixes engines, but not distributions.
class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    double unit() { return double(engine_()) / 4294967296.0; }
    double sign() { return 2 * unit() - 1; }
    DVec3 in_cube() { return {sign(), sign(), sign()}; }
    DVec3 on_sphere() {
        while (true) {
            const DVec3 p = in_cube();
            if (const double square = math::dot(p, p); square < 1 && square > 0.01) return math::normalized(p);
        }
    }
    math::DQuat rotation() { return math::normalized(math::DQuat{sign(), sign(), sign(), sign() + 0.01}); }

  private:
    std::mt19937 engine_;
};

template <class Make> Points make_points(int count, Make make) {
    Points points;
    for (int i = 0; i < count; ++i) points.push_back(math::to_float(make(i)));
    return points;
}

Points box_corners(DVec3 half, DVec3 center = {}) {
    return make_points(8, [&](int i) {
        return center + DVec3{i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z};
    });
}

Points lattice(int n) {
    return make_points(n * n * n, [&](int i) { return DVec3{double(i % n), double(i / n % n), double(i / n / n)}; });
}

Points turned(const Points& points, math::DQuat q, DVec3 shift = {}) {
    Points r;
    for (const Vec3 p : points) r.push_back(math::to_float(math::rotate(q, math::to_double(p)) + shift));
    return r;
}

HullData build_checked(const Points& points) {
    HullData hull = build_hull(points);
    EXPECT_EQ(check_hull(points, hull), "");
    return hull;
}

std::string refusal(const Points& points) {
    try {
        build_hull(points);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_value);
        EXPECT_EQ(error.field(), "Hull points");
        return error.what();
    }
    return "";
}

TEST(Hull, RandomCloudsFulfillEveryProperty) {
    for (std::uint32_t seed = 0; seed < 150; ++seed) {
        Random random(seed);
        const DVec3 size{0.3 + random.unit(), 0.3 + random.unit(), 0.3 + random.unit()};
        const int count = 5 + int(seed) * 2;
        SCOPED_TRACE(seed);
        build_checked(make_points(count, [&](int) { return math::scaled(size, random.in_cube()); }));
        build_checked(make_points(count, [&](int) { return math::scaled(size, random.on_sphere()); }));
    }
}

TEST(Hull, TurnedLatticesAreBoxes) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        Random random(seed);
        const Points points = turned(lattice(2 + int(seed % 6)), random.rotation(), 10.0 * random.in_cube());
        SCOPED_TRACE(seed);
        const HullData hull = build_checked(points);
        EXPECT_EQ(hull.vertices.size(), 8u);
        EXPECT_EQ(hull.faces.size(), 6u);
    }
}

TEST(Hull, NoiseAtTheCornersOfABoxMakesNoSlivers) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        Random random(seed);
        const double noise[] = {0, 1e-8, 1e-7, 1e-6, 1e-5};
        const double e = noise[seed % 5];
        const Points corners = box_corners({1, 0.7, 0.5});
        const Points points =
            turned(make_points(
                       200, [&](int i) { return math::to_double(corners[std::size_t(i % 8)]) + e * random.in_cube(); }),
                   random.rotation());
        SCOPED_TRACE(seed);
        const HullData hull = build_checked(points);
        if (e < 1e-6) {
            EXPECT_EQ(hull.faces.size(), 6u);
        }
        EXPECT_NEAR(hull.unit_mass.mass, 8 * 0.35, 1e-4);
    }
}

TEST(Hull, FlatAndLongCloudsFulfillEveryProperty) {
    for (std::uint32_t seed = 0; seed < 80; ++seed) {
        Random random(seed);
        const double thin[] = {1e-2, 1e-3, 1e-4, 5e-5};
        const double t = thin[seed % 4];
        const DVec3 size = seed & 4 ? DVec3{1, t, t} : DVec3{1, 1, t};
        SCOPED_TRACE(seed);
        build_checked(turned(make_points(100, [&](int) { return math::scaled(size, random.in_cube()); }),
                             seed & 8 ? random.rotation() : math::DQuat{}));
    }
}

// At a sharp edge a point may be just above both adjacent faces and yet be far outside the hull.
TEST(Hull, SharpEdgesAndTipsAreKept) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        Random random(seed);
        const double t = seed & 1 ? 1e-3 : 1e-4;
        const Points lens = make_points(400, [&](int) {
            const double x = random.sign(), y = random.sign(), r = std::sqrt(x * x + y * y);
            return DVec3{x, y, r < 1 ? t * (1 - r) * random.sign() : 0};
        });
        const Points spindle = make_points(400, [&](int) {
            const double x = random.sign(), w = t * (1 - std::fabs(x));
            return DVec3{x, w * random.sign(), w * random.sign()};
        });
        SCOPED_TRACE(seed);
        build_checked(lens);
        build_checked(spindle);
    }
}

TEST(Hull, AnySizeAndPlaceFulfillsEveryProperty) {
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        Random random(seed);
        const Points cloud = make_points(150, [&](int) { return random.in_cube(); });
        SCOPED_TRACE(seed);
        for (const double size : {1e-6, 1e-3, 1e5, 1e6}) {
            Points points;
            for (const Vec3 p : cloud) points.push_back(math::to_float(size * math::to_double(p)));
            build_checked(points);
        }
        for (const double far : {1e2, 1e3, 1e4, 1e5}) build_checked(turned(cloud, {}, far * random.on_sphere()));
    }
}

TEST(Hull, SameBitsForTheSamePointsAndTheSameBodyInAnyOrder) {
    Random random(3);
    Points points = make_points(500, [&](int) { return random.in_cube(); });
    const HullData a = build_checked(points), b = build_hull(points);
    EXPECT_TRUE(a.vertices == b.vertices && a.loops == b.loops && a.core == b.core && a.inset == b.inset);
    std::reverse(points.begin(), points.end());
    const HullData c = build_checked(points);
    EXPECT_EQ(a.vertices.size(), c.vertices.size());
    EXPECT_NEAR(a.unit_mass.mass, c.unit_mass.mass, 1e-12);
}

TEST(Hull, AMillionPointsGiveTheHullOfTheirCorners) {
    Random random(29);
    Points points = make_points(1'000'000, [&](int) { return random.in_cube(); });
    float most = 0;
    for (const auto& p : points) most = std::max({most, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    const Points corners = box_corners({most, most, most});
    points.insert(points.end(), corners.begin(), corners.end());
    EXPECT_EQ(build_checked(points).vertices.size(), 8u);
}

TEST(Hull, DuplicatesChangeNothing) {
    const Points once = box_corners({1, 2, 3});
    Points often;
    for (int i = 0; i < 100; ++i) often.insert(often.end(), once.begin(), once.end());
    const HullData hull = build_checked(often);
    EXPECT_EQ(hull.vertices, build_checked(once).vertices);
}

// The hull of a small cloud by brute force: a triple of points is a face if all points are on one side of it.
TEST(Hull, VolumeAgreesWithBruteForce) {
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        Random random(seed);
        const Points points = make_points(4 + int(seed % 20), [&](int) { return random.in_cube(); });
        double volume = 0;
        const auto at = [&](std::size_t i) { return math::to_double(points[i]); };
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t j = i + 1; j < points.size(); ++j)
                for (std::size_t k = i + 1; k < points.size(); ++k) {
                    if (k == j) continue;
                    const DVec3 n = math::cross(at(j) - at(i), at(k) - at(i));
                    bool is_face = true;
                    for (std::size_t p = 0; p < points.size() && is_face; ++p)
                        is_face = p == i || p == j || p == k || math::dot(n, at(p) - at(i)) < 0;
                    if (is_face) volume += math::dot(at(i), math::cross(at(j), at(k))) / 6;
                }
        const HullData hull = build_checked(points);
        EXPECT_NEAR(hull.unit_mass.mass, volume, 1e-4 * volume + 1e-5) << seed;
    }
}

TEST(Hull, MassOfABoxIsExactFarFromTheOriginToo) {
    for (const DVec3 center : {DVec3{}, DVec3{1000, -2000, 3000}, DVec3{65536, 65536, -65536}}) {
        const HullData hull = build_checked(box_corners({1, 2, 3}, center));
        const MassSum& m = hull.unit_mass;
        EXPECT_NEAR(m.mass, 48, 1e-9);
        EXPECT_NEAR(math::length(m.center - center), 0, 1e-9);
        EXPECT_NEAR(m.inertia.xx, 48.0 / 3 * (4 + 9), 1e-8);
        EXPECT_NEAR(m.inertia.yy, 48.0 / 3 * (1 + 9), 1e-8);
        EXPECT_NEAR(m.inertia.zz, 48.0 / 3 * (1 + 4), 1e-8);
        EXPECT_NEAR(std::fabs(m.inertia.xy) + std::fabs(m.inertia.xz) + std::fabs(m.inertia.yz), 0, 1e-8);
        EXPECT_NEAR(double(hull.width), 2, 0.01);
    }
}

TEST(Hull, MassOfACornerTetrahedron) {
    const HullData hull = build_checked({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    const MassSum& m = hull.unit_mass;
    EXPECT_NEAR(m.mass, 1.0 / 6, 1e-15);
    EXPECT_NEAR(math::length(m.center - DVec3{0.25, 0.25, 0.25}), 0, 1e-15);
    EXPECT_NEAR(m.inertia.xx, 1.0 / 80, 1e-15); // integrals: x^2 gives 1/60, x y gives 1/120, minus m / 16
    EXPECT_NEAR(m.inertia.xy, 1.0 / 480, 1e-15);
}

TEST(Hull, MassOfATriangularPrism) {
    const HullData hull = build_checked({{0, 0, -1}, {2, 0, -1}, {0, 3, -1}, {0, 0, 1}, {2, 0, 1}, {0, 3, 1}});
    const MassSum& m = hull.unit_mass;
    EXPECT_EQ(hull.faces.size(), 5u);
    EXPECT_NEAR(m.mass, 6, 1e-12);
    EXPECT_NEAR(m.center.x, 2.0 / 3, 1e-12);
    EXPECT_NEAR(m.center.y, 1, 1e-12);
    // About its center a right triangle with legs a, b has second moments a^2 / 18 and b^2 / 18, and the product -a b /
    // 36.
    EXPECT_NEAR(m.inertia.zz, 6 * (4.0 / 18 + 9.0 / 18), 1e-12);
    EXPECT_NEAR(m.inertia.xx, 6 * (9.0 / 18 + 4.0 / 12), 1e-12);
    EXPECT_NEAR(m.inertia.xy, 6 * 6.0 / 36, 1e-12);
}

TEST(Hull, MassOfAFineBallConverges) {
    const double ball = 4.0 / 3 * 3.14159265358979;
    double last = 1;
    for (const int count : {100, 400, 1600, 6400}) {
        Random random(1);
        const HullData hull = build_hull(make_points(count, [&](int) { return random.on_sphere(); }));
        const double error = 1 - hull.unit_mass.mass / ball;
        EXPECT_GT(error, 0);
        EXPECT_LT(error, last / 2.5); // ideally 4: the error is proportional to the square of the spacing
        EXPECT_NEAR(hull.unit_mass.inertia.xx, 0.4 * hull.unit_mass.mass, 3 * error);
        last = error;
    }
    EXPECT_LT(last, 2.5e-3);
}

TEST(Hull, CoreOfABoxIsTheSmallerBox) {
    const HullData hull = build_checked(box_corners({1, 2, 3}));
    EXPECT_NEAR(double(hull.inset), 0.08, 1e-6);
    ASSERT_EQ(hull.core.size(), 8u);
    for (std::size_t i = 0; i < hull.core.size(); ++i) {
        const Vec3 c = hull.core[i];
        EXPECT_NEAR(double(std::fabs(c.x)), 0.92, 1e-6);
        EXPECT_NEAR(double(std::fabs(c.y)), 1.92, 1e-6);
        EXPECT_NEAR(double(std::fabs(c.z)), 2.92, 1e-6);
    }
}

// The core is exactly the inset below all faces except those that vanish as the faces move inward; large faces do not
// vanish.
TEST(Hull, CoreReachesTheInsetBelowLargeFaces) {
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        Random random(seed);
        const HullData hull = build_checked(make_points(40, [&](int) { return random.in_cube(); }));
        int met = 0;
        double largest = 0, reach_of_largest = 0;
        for (const HullFace& face : hull.faces) {
            double reach = -1e30;
            for (std::size_t i = 0; i < hull.core.size(); ++i)
                reach = std::max(reach, math::dot(math::to_double(face.normal), math::to_double(hull.core[i])));
            DVec3 area;
            const auto corner = [&](std::uint32_t i) {
                return math::to_double(hull.vertices[hull.loops[face.first + i]]);
            };
            for (std::uint32_t i = 1; i + 1 < face.count; ++i)
                area += math::cross(corner(i) - corner(0), corner(i + 1) - corner(0));
            const double gap = double(face.offset) - reach - double(hull.inset);
            met += std::fabs(gap) < 2e-3 * double(hull.inset);
            if (math::length(area) > largest) largest = math::length(area), reach_of_largest = gap;
        }
        EXPECT_NEAR(reach_of_largest, 0, 2e-3 * double(hull.inset)) << seed;
        EXPECT_GT(met, int(hull.faces.size() * 2 / 3)) << seed;
    }
}

TEST(Hull, RefusesWhatHasNoVolumeAndSaysWhatItIs) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    EXPECT_NE(refusal({}).find("4 at least, got 0"), std::string::npos);
    EXPECT_NE(refusal({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).find("4 at least, got 3"), std::string::npos);
    EXPECT_NE(refusal({{0, 0, 0}, {1, 0, 0}, {0, nan, 0}, {0, 0, 1}}).find("point 2 with y = nan"), std::string::npos);
    EXPECT_NE(refusal({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -inf}}).find("must be finite"), std::string::npos);
    EXPECT_NE(refusal({{0, 0, 0}, {1.1e6f, 0, 0}, {0, 1, 0}, {0, 0, 1}}).find("from -1e6 to 1e6"), std::string::npos);
    EXPECT_NE(refusal(Points(10, Vec3{1, 2, 3})).find("one point"), std::string::npos);
    Random random(1);
    const auto line = make_points(50, [&](int) { return random.sign() * DVec3{1, 2, 3}; });
    EXPECT_NE(refusal(line).find("one line"), std::string::npos);
    const auto plane = make_points(50, [&](int) {
        return random.sign() * DVec3{1, 2, 3} + random.sign() * DVec3{2, -1, 1};
    });
    EXPECT_NE(refusal(plane).find("one plane"), std::string::npos);
    const std::string flat = refusal(box_corners({1, 1, 0.4e-5}));
    EXPECT_NE(flat.find("one plane"), std::string::npos);
    EXPECT_NE(flat.find("a thickness of at most "), std::string::npos);
    EXPECT_NE(flat.find("e-05 m in an extent of 2 m"), std::string::npos) << flat;
    EXPECT_EQ(refusal(box_corners({1, 1, 1.5e-5})), "");
}

// Found by fuzzing: the hull is 0.04 mm thick at 1000 m from the origin, where the planes of its faces are equal in
// float precision.
TEST(Hull, RefusesWhatFloatsCannotTellApartFarFromTheOrigin) {
    const Points points{{999.960999f, -1000.00006f, -3.9e-05f},
                        {998.440979f, -1000.00006f, -3.9e-05f},
                        {999.783997f, -1000.00006f, -0.00155900011f},
                        {998.440979f, -1000, -0.00177500001f}};
    EXPECT_NE(refusal(points).find("largest coordinate"), std::string::npos);
}

// Found by fuzzing: two vertices 4e-5 apart are almost collinear with a distant one. The direction of the line through
// the two is decided on the grid; in floats it is slightly rotated.
TEST(Hull, ShortEdgesAreConvexUpToTheGrid) {
    build_checked({{-1.99997902f, 0, 0},
                   {0, 0, 0},
                   {0, 0, 2.20000002e-05f},
                   {-0.999969006f, -0.00999968965f, -0.999969006f},
                   {-0.999994993f, -0.00999994949f, -0.999994993f},
                   {-0.999994993f, -0.00999994949f, -0.999969006f},
                   {-0.999969006f, 3.99999998e-08f, 2.00000095f}});
}

TEST(Hull, PublicClassTellsItsParts) {
    const std::vector<cairn::Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1f, 0.1f, 0.1f}};
    const Hull hull(points);
    EXPECT_EQ(hull.vertices().size(), 4u);
    EXPECT_EQ(hull.vertices()[1], points[1]);
    EXPECT_EQ(hull.face_count(), 4u);
    EXPECT_EQ(hull.face(0).size(), 3u);
    EXPECT_NEAR(hull.volume(), 1.0 / 6, 1e-15);
    EXPECT_THROW(hull.face(4), Error);
}

// Processor time, as other programs may be running.
TEST(Hull, KeepsNoRoomToGrow) {
    Random random(19);
    for (int count = 4; count < 60; ++count) {
        const HullData hull = build_checked(make_points(count, [&](int) { return random.on_sphere(); }));
        EXPECT_EQ(hull.vertices.capacity(), hull.vertices.size()) << count;
        EXPECT_EQ(hull.faces.capacity(), hull.faces.size()) << count;
        EXPECT_EQ(hull.unit_factors.capacity(), hull.unit_factors.size()) << count;
        EXPECT_EQ(hull.sides.capacity(), hull.sides.size()) << count;
    }
}

TEST(Hull, TenThousandPointsTakeMilliseconds) {
    for (const bool is_sphere : {false, true}) {
        Random random(1);
        const Points points =
            make_points(10000, [&](int) { return is_sphere ? random.on_sphere() : random.in_cube(); });
        double best = 1e30;
        for (int i = 0; i < 5; ++i) {
            const std::clock_t start = std::clock();
            build_hull(points);
            best = std::min(best, 1000.0 * double(std::clock() - start) / double(CLOCKS_PER_SEC));
        }
        RecordProperty(is_sphere ? "sphere_ms" : "cube_ms", std::to_string(best));
        std::printf("10,000 points %s: %.1f ms\n", is_sphere ? "on a sphere" : "in a cube", best);
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__)
        EXPECT_LT(best, is_sphere ? 250 : 50); // on a sphere all points are vertices
#endif
    }
}

} // namespace
} // namespace cairn
