// Bounds and mass properties of shapes.
#include "geometry_test_support.h"

#include <gtest/gtest.h>

namespace cairn {

namespace {

using math::DVec3;
using test::Random;
using test::sample_of;

constexpr double pi = 3.14159265358979323846;

// Bounds must contain all points, and exceed the outermost ones by no more than `slack`.
void expect_tight(const test::Sample& shape, const std::vector<DVec3>& points, double slack, Random& random) {
    for (int round = 0; round < 50; ++round) {
        const math::Quat q = round == 0 ? math::Quat{} : random.rotation();
        const DVec3 position = random.point(100);
        const DBounds b = geometry_bounds(shape.geometry, shape.data, position, math::to_matrix(q));
        DVec3 lo{1e30, 1e30, 1e30}, hi = -lo;
        for (const DVec3 p : points) {
            const DVec3 world = position + math::rotate(math::normalized(math::to_double(q)), p);
            lo = math::min(lo, world);
            hi = math::max(hi, world);
        }
        for (int i = 0; i < 3; ++i) {
            ASSERT_LE(b.lo[i], lo[i]);
            ASSERT_GE(b.hi[i], hi[i]);
            ASSERT_GT(b.lo[i], lo[i] - slack);
            ASSERT_LT(b.hi[i], hi[i] + slack);
        }
    }
}

// Points of a sphere in `count` nearly evenly spread directions (a Fibonacci spiral).
void add_ball(std::vector<DVec3>& points, double y, double radius, int count) {
    for (int i = 0; i < count; ++i) {
        const double up = 1 - (2 * i + 1.0) / count, out = std::sqrt(1 - up * up), angle = 2.399963229728653 * i;
        points.push_back({radius * out * std::cos(angle), y + radius * up, radius * out * std::sin(angle)});
    }
}

void add_circle(std::vector<DVec3>& points, double y, double radius) {
    for (int i = 0; i < 3600; ++i)
        points.push_back({radius * std::cos(i * pi / 1800), y, radius * std::sin(i * pi / 1800)});
}

TEST(Bounds, OfCapsulesHoldBothBallsAndNoMore) {
    Random random(1);
    for (const Capsule& c :
         {Capsule{0.5f, 0.25f}, Capsule{1.0f, 0.5f, 0.1f}, Capsule{0.2f, 0.1f, 0.9f}, Capsule{0.7f, 0.3f, 0.0f}}) {
        std::vector<DVec3> points;
        add_ball(points, -double(c.half_height), double(c.radius), 4000);
        add_ball(points, double(c.half_height), double(c.radius_top.value_or(c.radius)), 4000);
        expect_tight(sample_of(Shape(c)), points, 2e-3, random);
    }
}

TEST(Bounds, OfUprightCapsulesAreExact) {
    const test::Sample c = sample_of(Shape(Capsule{1.0f, 0.5f, 0.25f}));
    const DBounds b = geometry_bounds(c.geometry, c.data, {10, 20, 30}, {});
    EXPECT_NEAR(b.lo.x, 9.5, 3e-6);
    EXPECT_NEAR(b.lo.y, 18.5, 3e-6);
    EXPECT_NEAR(b.hi.y, 21.25, 3e-6);
    EXPECT_NEAR(b.hi.z, 30.5, 3e-6);
}

TEST(Bounds, OfCylindersHoldBothDiscsAndNoMore) {
    Random random(2);
    for (const Cylinder& c : {Cylinder{0.5f, 0.5f}, Cylinder{0.01f, 2.0f}, Cylinder{3.0f, 0.02f},
                              Cylinder{0.5f, 1.0f, 0.2f}, Cylinder{0.5f, 0.2f, 1.0f}, cone(0.5f, 1.0f)}) {
        std::vector<DVec3> points;
        add_circle(points, -double(c.half_height), double(c.radius));
        add_circle(points, double(c.half_height), double(c.radius_top.value_or(c.radius)));
        expect_tight(sample_of(Shape(c)), points, 1e-5, random);
    }
}

TEST(Bounds, OfHullsHoldTheirCornersAndNoMore) {
    Random random(3);
    for (const int sides : {3, 10, 100}) {
        const auto hull = test::prism(sides, {0.7, 1.5, 0.3}, 0.4);
        std::vector<DVec3> points;
        for (const math::Vec3 v : hull->vertices) points.push_back(math::to_double(v));
        expect_tight(sample_of(hull), points, 5e-6, random);
    }
}

TEST(Bounds, OfMeshesHoldTheirCornersAndNoMore) {
    Random random(4);
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const DVec3 p = scaled(random.direction(), DVec3{5, 1, 2});
        vertices.push_back({p.x + random(-0.1, 0.1), p.y, p.z});
        indices.push_back(i);
    }
    const Mesh mesh(vertices, indices);
    std::vector<DVec3> points;
    for (const Vec3& v : mesh.vertices()) points.push_back({v.x, v.y, v.z});
    expect_tight(sample_of(Shape(mesh)), points, 2e-5, random);
}

TEST(Bounds, OfFlatMeshesThatLieAlongAnAxisAreTight) {
    Random random(5);
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 300; ++i) {
        vertices.push_back({random(-1, 1), 0, random(-1, 1)});
        indices.push_back(i);
    }
    const Mesh mesh(vertices, indices);
    const test::Sample s = sample_of(Shape(mesh));
    const DBounds b = geometry_bounds(s.geometry, s.data, {}, {});
    EXPECT_NEAR(b.lo.y, 0, 2e-6);
    EXPECT_NEAR(b.hi.y, 0, 2e-6);
    EXPECT_NEAR(b.hi.x, double(mesh_of(s.data).hi.x), 3e-6);
}

TEST(Bounds, OfHeightFieldsHoldTheirCornersAndAreExactUpright) {
    Random random(6);
    std::vector<float> heights(12 * 7);
    for (float& h : heights) h = float(random(3, 5));
    const HeightField field(12, 7, {0.5f, 2.0f}, heights);
    const test::Sample s = sample_of(Shape(field));
    const HeightFieldData& data = height_field_of(s.data);
    for (int round = 0; round < 50; ++round) {
        const math::Quat q = random.rotation();
        const DBounds b = geometry_bounds(s.geometry, s.data, {7, 8, 9}, math::to_matrix(q));
        for (std::uint32_t i = 0; i < triangle_count(data); ++i) {
            const Triangle t = triangle_of(data, i);
            for (const math::Vec3 v : {t.a, t.b, t.c}) {
                const DVec3 p = DVec3{7, 8, 9} + math::rotate(math::normalized(math::to_double(q)), math::to_double(v));
                for (int k = 0; k < 3; ++k) ASSERT_TRUE(b.lo[k] <= p[k] && p[k] <= b.hi[k]);
            }
        }
    }
    const DBounds b = geometry_bounds(s.geometry, s.data, {}, {});
    EXPECT_NEAR(b.lo.x, -2.75, 1e-5);
    EXPECT_NEAR(b.hi.z, 6, 1e-5);
    EXPECT_NEAR(b.lo.y, double(data.least), 1e-5);
    EXPECT_NEAR(b.hi.y, double(data.greatest), 1e-5);
}

// Mass properties as sums over slices; `square` gives the squared radius at height y.
template <class Square> MassSum sliced(double lo, double hi, Square&& square) {
    constexpr int slices = 40000;
    const double thickness = (hi - lo) / slices;
    double volume = 0, first = 0, second = 0, axial = 0;
    for (int i = 0; i < slices; ++i) {
        const double y = lo + (i + 0.5) * thickness, r2 = std::max(0.0, square(y)), v = pi * r2 * thickness;
        volume += v;
        first += v * y;
        second += v * y * y;
        axial += v * r2 / 2;
    }
    MassSum m;
    m.mass = volume;
    m.center = {0, first / volume, 0};
    const double across = axial / 2 + second - first * first / volume;
    m.inertia = {across, 0, 0, axial, 0, across};
    return m;
}

void expect_near(const MassSum& a, const MassSum& b, double relative) {
    const double size = std::sqrt((b.inertia.xx + b.inertia.yy + b.inertia.zz) / b.mass);
    EXPECT_NEAR(a.mass, b.mass, relative * b.mass);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a.center[i], b.center[i], relative * size);
    const double scale = relative * b.mass * size * size;
    EXPECT_NEAR(a.inertia.xx, b.inertia.xx, scale);
    EXPECT_NEAR(a.inertia.yy, b.inertia.yy, scale);
    EXPECT_NEAR(a.inertia.zz, b.inertia.zz, scale);
    EXPECT_NEAR(a.inertia.xy, b.inertia.xy, scale);
    EXPECT_NEAR(a.inertia.xz, b.inertia.xz, scale);
    EXPECT_NEAR(a.inertia.yz, b.inertia.yz, scale);
}

MassSum mass_of(const Shape& shape, float density = 1, const Transform& pose = {}) {
    return geometry_mass(make_geometry(shape, pose), make_shape_data(shape), density);
}

// The capsule is the union of all balls between its two ends: those at (2 l - 1) h with radius a + (b - a) l, for l
// from 0 to 1. Its squared radius at height y is the maximum of a quadratic in l.
MassSum sliced_capsule(const Capsule& c) {
    const double h = double(c.half_height), a = double(c.radius), b = double(c.radius_top.value_or(c.radius));
    auto square = [&](double y) {
        auto of_ball = [&](double l) {
            const double r = a + (b - a) * l, d = y - (2 * l - 1) * h;
            return r * r - d * d;
        };
        double best = std::max(of_ball(0), of_ball(1));
        const double curvature = (b - a) * (b - a) - 4 * h * h;
        if (curvature < 0) {
            const double l = -(a * (b - a) + 2 * h * (y + h)) / curvature;
            if (l > 0 && l < 1) best = std::max(best, of_ball(l));
        }
        return best;
    };
    return sliced(std::min(-h - a, h - b), std::max(h + b, -h + a), square);
}

TEST(Mass, OfCapsulesIsThatOfTheirSlices) {
    for (const Capsule& c : {Capsule{0.5f, 0.25f}, Capsule{2.0f, 0.1f}, Capsule{0.01f, 1.0f}, Capsule{1.0f, 0.5f, 0.2f},
                             Capsule{1.0f, 0.2f, 0.5f}, Capsule{0.5f, 0.9f, 0.0f}, Capsule{0.5f, 0.1f, 1.05f},
                             Capsule{0.5f, 0.1f, 1.09f}}) {
        SCOPED_TRACE(testing::Message() << c.half_height << " " << c.radius << " " << c.radius_top.value_or(-1));
        expect_near(mass_of(c), sliced_capsule(c), 1e-6);
    }
}

TEST(Mass, OfACapsuleWhoseOneBallHoldsTheOtherIsThatOfTheBall) {
    for (const bool upper : {false, true}) {
        const Capsule c = upper ? Capsule{0.25f, 0.5f, 1.5f} : Capsule{0.25f, 1.5f, 0.5f};
        MassSum ball = mass_of(Sphere{1.5f});
        ball.center.y = upper ? 0.25 : -0.25;
        expect_near(mass_of(c), ball, 1e-12);
        expect_near(mass_of(c), sliced_capsule(c), 1e-6);
    }
}

TEST(Mass, OfAFlatCapsuleIsThatOfABall) {
    expect_near(mass_of(Capsule{1e-6f, 1.0f}), mass_of(Sphere{1.0f}), 3e-6);
    expect_near(mass_of(Capsule{1e-6f, 1.0f, 1.0f + 1e-6f}), mass_of(Sphere{1.0f}), 5e-6);
}

TEST(Mass, OfATaperedCapsuleOfEqualRadiiIsThatOfAPlainOne) {
    expect_near(mass_of(Capsule{0.5f, 0.25f, 0.25f}), mass_of(Capsule{0.5f, 0.25f}), 1e-14);
    expect_near(mass_of(Capsule{0.5f, 0.25f, 0.25f + 3e-8f}), mass_of(Capsule{0.5f, 0.25f}), 1e-6);
}

TEST(Mass, OfCylindersAndConesIsThatOfTheirSlices) {
    for (const Cylinder& c : {Cylinder{0.5f, 0.5f}, Cylinder{0.01f, 2.0f}, Cylinder{3.0f, 0.02f},
                              Cylinder{0.5f, 1.0f, 0.2f}, Cylinder{0.5f, 0.2f, 1.0f}, cone(0.5f, 1.0f)}) {
        const double h = double(c.half_height), a = double(c.radius), b = double(c.radius_top.value_or(c.radius));
        const MassSum slices = sliced(-h, h, [&](double y) {
            const double r = a + (b - a) * (y + h) / (2 * h);
            return r * r;
        });
        expect_near(mass_of(c), slices, 1e-6);
    }
}

TEST(Mass, OfAConeIsThatOfTheTextbook) {
    const MassSum m = mass_of(cone(2.0f, 1.5f), 10);
    const double mass = 10 * pi * 4 * 3 / 3;
    EXPECT_NEAR(m.mass, mass, 1e-12 * mass);
    EXPECT_NEAR(m.center.y, -0.75, 1e-12); // the centroid of a cone is at a quarter of its height above the base
    EXPECT_NEAR(m.inertia.yy, 0.3 * mass * 4, 1e-10);
    EXPECT_NEAR(m.inertia.xx, mass * (3.0 / 20 * 4 + 3.0 / 80 * 9), 1e-10);
}

TEST(Mass, OfARoundedBoxIsThatOfSteinersFormula) {
    const double a = 0.5, b = 0.25, c = 1.5, r = 0.125;
    const MassSum m = mass_of(Box{{float(a), float(b), float(c)}, float(r)});
    // The integral of the mean curvature.
    const double area = 8 * (a * b + b * c + c * a), mean_curvature = 2 * pi * (a + b + c);
    EXPECT_NEAR(m.mass, 8 * a * b * c + area * r + mean_curvature * r * r + 4.0 / 3 * pi * r * r * r, 1e-12);
}

// Mass properties as a sum over cubes of space; a cube at the surface counts by the share of it that is inside.
// `distance`: signed distance to the surface.
template <class Distance> MassSum cubes(Distance&& distance, double reach) {
    constexpr int n = 120;
    const double h = 2 * reach / n;
    double volume = 0;
    DVec3 first;
    math::DSym3 s;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k) {
                const DVec3 p{(i + 0.5) * h - reach, (j + 0.5) * h - reach, (k + 0.5) * h - reach};
                const double v = h * h * h * std::clamp(0.5 - distance(p) / h, 0.0, 1.0);
                volume += v;
                first += v * p;
                s = s + math::DSym3{v * p.x * p.x, v * p.x * p.y, v * p.x * p.z,
                                    v * p.y * p.y, v * p.y * p.z, v * p.z * p.z};
            }
    MassSum m;
    m.mass = volume;
    m.center = (1 / volume) * first;
    const DVec3 c = m.center;
    s = s + math::DSym3{-volume * c.x * c.x, -volume * c.x * c.y, -volume * c.x * c.z,
                        -volume * c.y * c.y, -volume * c.y * c.z, -volume * c.z * c.z};
    m.inertia = {s.yy + s.zz, -s.xy, -s.xz, s.xx + s.zz, -s.yz, s.xx + s.yy};
    return m;
}

TEST(Mass, OfARoundedBoxIsThatOfCubesOfSpace) {
    for (const float r : {0.1f, 0.4f}) {
        const DVec3 half{0.5, 0.3, 0.7};
        const MassSum oracle = cubes(
            [&](DVec3 p) {
                const DVec3 q = math::abs(p) - half;
                return math::length(math::max(q, DVec3{})) + std::min(0.0, std::max({q.x, q.y, q.z})) - double(r);
            },
            1.2);
        expect_near(mass_of(Box{{0.5f, 0.3f, 0.7f}, r}), oracle, 5e-4);
    }
}

TEST(Mass, OfRoundedCylindersIsThatOfTheirSlices) {
    for (const Cylinder& c :
         {Cylinder{0.5f, 0.5f, {}, 0.2f}, Cylinder{0.5f, 1.0f, 0.2f, 0.05f}, Cylinder{0.5f, 0.2f, 1.0f, 0.3f},
          Cylinder{0.4f, 0.5f, 0.0f, 0.1f}, Cylinder{0.01f, 1.0f, {}, 0.2f}, Cylinder{0.1f, 0.1f, 3.0f, 1.0f}}) {
        SCOPED_TRACE(testing::Message() << c.half_height << " " << c.radius << " " << c.rounding);
        const double h = double(c.half_height), a = double(c.radius), b = double(c.radius_top.value_or(c.radius));
        const double r = double(c.rounding);
        // The rounded solid is the union of balls around every point of the outline.
        const MassSum slices = sliced(-h - r, h + r, [&](double y) {
            const auto reach = [&](double t) {
                const double up = y - (2 * t - 1) * h, square = r * r - up * up;
                return square >= 0 ? a + (b - a) * t + std::sqrt(square) : 0;
            };
            // This function of t is concave where it is not zero.
            double lo = std::max(0.0, (y - r + h) / (2 * h)), hi = std::min(1.0, (y + r + h) / (2 * h));
            for (int i = 0; i < 60; ++i) {
                const double p = lo + (hi - lo) / 3, q = hi - (hi - lo) / 3;
                (reach(p) < reach(q) ? lo : hi) = reach(p) < reach(q) ? p : q;
            }
            const double most = std::max(reach(lo), reach(hi));
            return most * most;
        });
        expect_near(mass_of(c), slices, 1e-5);
    }
}

Hull box_as_hull(const Vec3& half, float rounding) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back({i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z});
    Hull hull(corners);
    hull.rounding = rounding;
    return hull;
}

TEST(Mass, OfARoundedHullOfABoxIsThatOfTheRoundedBox) {
    for (const float r : {1e-3f, 0.25f, 4.0f})
        expect_near(mass_of(box_as_hull({0.5f, 0.25f, 0.75f}, r)), mass_of(Box{{0.5f, 0.25f, 0.75f}, r}), 1e-6);
}

TEST(Mass, OfARoundedTetrahedronIsThatOfCubesOfSpace) {
    const DVec3 c[4] = {{0.6, -0.4, -0.5}, {-0.7, -0.3, -0.2}, {0.1, 0.7, -0.3}, {0.2, 0.1, 0.6}};
    std::vector<Vec3> points;
    for (const DVec3& p : c) points.push_back({p.x, p.y, p.z});
    Hull hull(points);
    hull.rounding = 0.3f;
    // Alternating projections on barycentric weights are slow; testing each face, edge and vertex is not.
    const int faces[4][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}};
    const auto distance = [&](DVec3 p) {
        double inside = -1e30, least = 1e30;
        for (const auto& f : faces) {
            const DVec3 a = c[f[0]], b = c[f[1]], d = c[f[2]];
            DVec3 n = math::normalized(math::cross(b - a, d - a));
            if (math::dot(n, c[f[3]] - a) > 0) n = -n;
            const double height = math::dot(n, p - a);
            inside = std::max(inside, height);
            const DVec3 corners[3] = {a, b, d};
            bool over = true;
            for (int i = 0; i < 3; ++i) {
                const DVec3 from = corners[i], along = corners[(i + 1) % 3] - from, third = corners[(i + 2) % 3] - from;
                const DVec3 inward = third - (math::dot(third, along) / math::dot(along, along)) * along;
                over = over && math::dot(inward, p - from) >= 0;
                const double t = std::clamp(math::dot(p - from, along) / math::dot(along, along), 0.0, 1.0);
                least = std::min(least, math::length(p - (from + t * along)));
            }
            if (over) least = std::min(least, std::fabs(height));
        }
        return (inside > 0 ? least : inside) - double(hull.rounding);
    };
    expect_near(mass_of(hull), cubes(distance, 1.1), 5e-4);
}

TEST(Bounds, OfRoundedShapesAreThoseOfTheSharpOnesGrownByTheRounding) {
    Random random(7);
    const auto check = [&](Shape sharp, Shape round, double r) {
        const test::Sample a = sample_of(sharp), b = sample_of(round);
        EXPECT_NEAR(double(b.geometry.bounding_radius), double(a.geometry.bounding_radius) + r, 1e-6);
        for (int i = 0; i < 50; ++i) {
            const math::Mat3 m = math::to_matrix(random.rotation());
            const DVec3 position = random.point(10);
            const DBounds p = geometry_bounds(a.geometry, a.data, position, m);
            const DBounds q = geometry_bounds(b.geometry, b.data, position, m);
            for (int k = 0; k < 3; ++k) {
                ASSERT_NEAR(q.lo[k], p.lo[k] - r, 2e-6);
                ASSERT_NEAR(q.hi[k], p.hi[k] + r, 2e-6);
            }
        }
    };
    check(Box{{0.5f, 0.3f, 0.7f}}, Box{{0.5f, 0.3f, 0.7f}, 0.25f}, 0.25);
    check(Cylinder{0.5f, 0.3f, 0.7f}, Cylinder{0.5f, 0.3f, 0.7f, 0.25f}, 0.25);
    check(box_as_hull({0.5f, 0.3f, 0.7f}, 0), box_as_hull({0.5f, 0.3f, 0.7f}, 0.25f), 0.25);
}

TEST(Mass, OfATurnedShapeTurnsWithIt) {
    // A quarter turn about z maps y to -x.
    const Transform pose{{1, 2, 3}, {std::sqrt(0.5f), 0, 0, std::sqrt(0.5f)}};
    const MassSum upright = mass_of(cone(0.5f, 1.0f), 3), turned = mass_of(cone(0.5f, 1.0f), 3, pose);
    EXPECT_NEAR(turned.mass, upright.mass, 1e-12);
    EXPECT_NEAR(turned.center.x, 1 - upright.center.y, 1e-6);
    EXPECT_NEAR(turned.center.y, 2, 1e-6);
    EXPECT_NEAR(turned.center.z, 3, 1e-6);
    EXPECT_NEAR(turned.inertia.xx, upright.inertia.yy, 1e-6);
    EXPECT_NEAR(turned.inertia.yy, upright.inertia.xx, 1e-6);
    EXPECT_NEAR(turned.inertia.xy, 0, 1e-6);
}

TEST(Mass, OfAHullIsItsUnitMassTimesItsDensityTurned) {
    HullData data = *test::prism(4, {1, 1, 1}, 0);
    data.unit_mass = {2, {0.1, 0.2, 0.3}, {3, 0.5, 0.25, 4, 0.125, 5}};
    const Hull hull(std::make_shared<const HullData>(data));
    const Quat q = glm::normalize(Quat(0.3f, 0.5f, -0.4f, 0.7f));
    const MassSum m = mass_of(hull, 7, {{1, 2, 3}, q});
    EXPECT_NEAR(m.mass, 14, 1e-12);
    // The same by rotating the inertia tensor: I v = R (I0 (R^T v)).
    const math::DQuat r = math::normalized(math::DQuat{double(q.x), double(q.y), double(q.z), double(q.w)});
    const DVec3 center = DVec3{1, 2, 3} + math::rotate(r, data.unit_mass.center);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(m.center[i], center[i], 1e-12);
    for (const DVec3 v : {DVec3{1, 0, 0}, DVec3{0, 1, 0}, DVec3{0, 0, 1}}) {
        const DVec3 expected = 7.0 * math::rotate(r, data.unit_mass.inertia * math::rotate_back(r, v));
        const DVec3 got = m.inertia * v;
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(got[i], expected[i], 1e-12);
    }
}

TEST(Mass, OfSurfacesIsNone) {
    const Mesh mesh(std::vector<Vec3>{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}, std::vector<std::uint32_t>{0, 1, 2});
    EXPECT_EQ(mass_of(mesh, 1000).mass, 0);
    EXPECT_EQ(mass_of(HeightField(2, 2, {1, 1}, std::vector<float>(4)), 1000).mass, 0);
}

} // namespace

} // namespace cairn
