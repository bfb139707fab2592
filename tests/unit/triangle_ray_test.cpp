// Rays against meshes and height fields, compared with all triangles one by one; and at shared edges.
#include "mesh_test_support.h"

#include <gtest/gtest.h>
#include <limits>

namespace cairn {

namespace {

using math::DVec3;
using test::Random;
using test::sample_of;

// Distance to a triangle from outside by volumes of tetrahedra, in long double (T. Moeller, B. Trumbore: Fast, minimum
// storage ray/triangle intersection, 1997). `clearance` is the distance of the ray from the nearest edge, relative to
// the triangle; near 0 rounding decides.
struct Exact {
    double distance = std::numeric_limits<double>::infinity(), clearance = 1;
    DVec3 normal;
};
using LVec = math::TVec3<long double>;
LVec wide(DVec3 v) { return {v.x, v.y, v.z}; }

void offer(Exact& best, const Triangle& t, DVec3 origin, DVec3 direction) {
    const LVec a = wide(math::to_double(t.a)), e = wide(math::to_double(t.b)) - a, f = wide(math::to_double(t.c)) - a;
    const LVec d = wide(direction), s = wide(origin) - a, n = math::cross(e, f);
    const long double volume = -math::dot(n, d);
    const long double steepness = volume / (math::length(n) * math::length(d));
    if (!(steepness > 1e-6L)) {
        // From behind, or parallel to the triangle: a parallel ray may clip its rim.
        if (steepness > 0) best.clearance = 0;
        return;
    }
    const long double v = math::dot(math::cross(f, s), d) / volume, w = math::dot(math::cross(s, e), d) / volume;
    const long double least = std::min(std::min(v, w), 1 - v - w);
    if (std::fabs(double(least)) < 1e-7) best.clearance = 0;
    if (least < 0) return;
    const double distance = double(math::dot(n, s) / volume);
    if (distance < 0 || distance >= best.distance) return;
    best.distance = distance;
    const LVec unit = math::normalized(n);
    best.normal = {double(unit.x), double(unit.y), double(unit.z)};
}

template <class Data>
void expect_as_one_by_one(const Data& data, const test::Sample& shape, double reach, DVec3 aim_box, Random& random,
                          double away, double tolerance, int rounds) {
    int hits = 0, misses = 0;
    for (int i = 0; i < rounds; ++i) {
        const math::Quat q = random.rotation();
        const math::DQuat r = math::normalized(math::to_double(q));
        const DVec3 position = random.point(10);
        DVec3 d = random.direction();
        if (i % 4 == 0) d = math::normalized(scaled(d, DVec3{1, 0.02, 1})); // nearly horizontal
        const DVec3 origin = scaled(random.point(1), aim_box) - away * d;
        Exact exact;
        for (std::uint32_t t = 0; t < triangle_count(data); ++t) offer(exact, triangle_of(data, t), origin, d);
        if (exact.clearance == 0) continue;
        const auto hit = cast_ray(shape.geometry, shape.data, position, q, position + math::rotate(r, origin),
                                  math::rotate(r, d), 1e9);
        ASSERT_EQ(hit.has_value(), std::isfinite(exact.distance));
        if (!hit) {
            ++misses;
            continue;
        }
        ++hits;
        ASSERT_NEAR(hit->distance, exact.distance, tolerance * reach);
        const DVec3 n = math::rotate_back(r, hit->normal);
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(n[k], exact.normal[k], 1e-12);
        ASSERT_LT(math::dot(n, d), 0);
        // A ray that ends before the hit misses.
        ASSERT_FALSE(cast_ray(shape.geometry, shape.data, position, q, position + math::rotate(r, origin),
                              math::rotate(r, d), hit->distance - 1e-6 * reach - 1e-9)
                         .has_value());
    }
    EXPECT_GT(hits, rounds / 50);
    EXPECT_GT(misses, rounds / 50);
}

std::shared_ptr<const MeshData> shared_mesh(const test::Soup& soup) {
    return std::make_shared<const MeshData>(build_mesh(soup.vertices, soup.indices));
}

TEST(MeshRay, MeetsWhatTrianglesOneByOneDo) {
    Random random(1);
    for (const std::size_t count : {2u, 9u, 100u, 600u}) {
        const auto mesh = shared_mesh(test::random_soup(random, count, 2));
        const test::Sample shape = sample_of(Shape(Mesh(mesh)));
        const double spread = count < 10 ? 1 : 2;
        // Aimed anywhere, or at a triangle's surroundings if there are few triangles.
        const DVec3 box = spread * DVec3{1, 1, 1};
        int rounds = count < 10 ? 20000 : 2000;
        if (count < 100) {
            for (int i = 0; i < rounds; ++i) {
                const Triangle t = triangle_of(*mesh, std::uint32_t(random.below(triangle_count(*mesh))));
                const DVec3 d = random.direction(), aim = math::to_double(t.a) + random.point(0.2);
                Exact exact;
                for (std::uint32_t k = 0; k < triangle_count(*mesh); ++k)
                    offer(exact, triangle_of(*mesh, k), aim - 3.0 * d, d);
                if (exact.clearance == 0) continue;
                const auto hit = cast_ray(shape.geometry, shape.data, {}, {}, aim - 3.0 * d, d, 1e9);
                ASSERT_EQ(hit.has_value(), std::isfinite(exact.distance));
                if (hit) {
                    ASSERT_NEAR(hit->distance, exact.distance, 1e-9);
                }
            }
            continue;
        }
        expect_as_one_by_one(*mesh, shape, 2, box, random, 0, 1e-9, rounds);
        expect_as_one_by_one(*mesh, shape, 2, box, random, 5, 1e-9, rounds);
    }
}

TEST(MeshRay, MeetsFromAMillionMetersAway) {
    Random random(2);
    const auto mesh = shared_mesh(test::ball_soup(20, 20, 2));
    expect_as_one_by_one(*mesh, sample_of(Shape(Mesh(mesh))), 2, {2.5, 2.5, 2.5}, random, 1e6, 1e-7, 2000);
}

TEST(MeshRay, DoesNotMeetTrianglesFromBehind) {
    Random random(3);
    const auto mesh = shared_mesh(test::ball_soup(20, 20, 2));
    const test::Sample shape = sample_of(Shape(Mesh(mesh)));
    for (int i = 0; i < 5000; ++i)
        ASSERT_FALSE(cast_ray(shape.geometry, shape.data, {}, {}, random.point(1), random.direction(), 100));
}

// Rays aimed at vertices, at points of edges and just beside them: a ray that slips between triangles of a closed mesh
// would hit nothing at all, as triangles are not hit from behind.
TEST(MeshRay, PassesNowhereBetweenTrianglesOfAClosedMesh) {
    Random random(4);
    const auto mesh = shared_mesh(test::ball_soup(40, 40, 2));
    const test::Sample shape = sample_of(Shape(Mesh(mesh)));
    for (int i = 0; i < 300000; ++i) {
        const Triangle t = triangle_of(*mesh, std::uint32_t(random.below(triangle_count(*mesh))));
        const DVec3 a = math::to_double(t.a), b = math::to_double(t.b);
        const double part = i % 3 == 0 ? 0 : i % 3 == 1 ? 0.5 : random(0, 1);
        DVec3 aim = a + part * (b - a);
        if (i % 5 == 0) aim += 1e-15 * random.direction();
        const DVec3 within = random.point(1); // inside the ball
        DVec3 d = math::normalized(within - aim);
        const double away = i % 7 == 0 ? 1e6 : i % 7 == 1 ? 1e3 : random(0.1, 10);
        const auto hit = cast_ray(shape.geometry, shape.data, {}, {}, aim - away * d, d, 2e6);
        ASSERT_TRUE(hit) << i;
        ASSERT_NEAR(hit->distance, away, 1e-8);
    }
    // Along the axes, from directly above vertices.
    for (const math::Vec3 v : mesh->vertices)
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0}) {
                DVec3 d, origin = math::to_double(v), sideways = origin;
                sideways[axis] = 0;
                if (math::length(sideways) > 1.9) continue; // at the silhouette as seen along the axis
                d[axis] = side;
                origin[axis] = -3 * side;
                ASSERT_TRUE(cast_ray(shape.geometry, shape.data, {}, {}, origin, d, 10));
            }
}

TEST(MeshRay, StartsOnATriangleAndMeetsIt) {
    const std::vector<math::Vec3> vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    const auto mesh = shared_mesh({vertices, {0, 1, 2}});
    const test::Sample shape = sample_of(Shape(Mesh(mesh)));
    const auto hit = cast_ray(shape.geometry, shape.data, {}, {}, {0.25, 0, 0.25}, {0, -1, 0}, 1);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->distance, 0);
    EXPECT_EQ(hit->normal.y, 1);
    EXPECT_FALSE(cast_ray(shape.geometry, shape.data, {}, {}, {0.25, -0.1, 0.25}, {0, -1, 0}, 1));
    EXPECT_FALSE(cast_ray(shape.geometry, shape.data, {}, {}, {0.25, -0.1, 0.25}, {0, 1, 0}, 1));
    EXPECT_TRUE(cast_ray(shape.geometry, shape.data, {}, {}, {0.25, 1, 0.25}, {0, -1, 0},
                         std::numeric_limits<double>::infinity()));
}

std::shared_ptr<const HeightFieldData> shared_field(Random& random, int columns, int rows, float x, float z) {
    return std::make_shared<const HeightFieldData>(test::random_field(random, columns, rows, x, z));
}

TEST(HeightFieldRay, MeetsWhatTrianglesOneByOneDo) {
    Random random(5);
    for (const auto& [columns, rows, x, z] :
         {std::tuple(2, 2, 1.0f, 1.0f), std::tuple(20, 15, 0.3f, 0.7f), std::tuple(2, 30, 1.0f, 0.1f),
          std::tuple(30, 2, 0.1f, 3.0f), std::tuple(12, 13, 5.0f, 0.01f)}) {
        const auto field = shared_field(random, columns, rows, x, z);
        const test::Sample shape = sample_of(Shape(HeightField(field)));
        const DVec3 box{0.7 * columns * double(x), 1.2, 0.7 * rows * double(z)};
        const double reach = std::max(1.0, math::length(box));
        SCOPED_TRACE(testing::Message() << columns << " x " << rows);
        expect_as_one_by_one(*field, shape, reach, box, random, 0, 1e-9, 3000);
        expect_as_one_by_one(*field, shape, reach, box, random, 2 * reach, 1e-9, 3000);
        expect_as_one_by_one(*field, shape, reach, box, random, 1e6, 1e-7, 1000);
    }
}

TEST(HeightFieldRay, PassesNowhereBetweenTriangles) {
    Random random(6);
    const auto field = shared_field(random, 40, 30, 0.1f, 0.7f);
    const test::Sample shape = sample_of(Shape(HeightField(field)));
    for (int i = 0; i < 200000; ++i) {
        // A cell that is not at the border.
        const int column = 1 + int(random.below(37)), row = 1 + int(random.below(27));
        const Triangle t = triangle_of(*field, std::uint32_t(2 * (row * 39 + column) + i % 2));
        const math::Vec3 corners[4] = {t.a, t.b, t.c, t.a};
        const int edge = int(random.below(3));
        const DVec3 a = math::to_double(corners[edge]), b = math::to_double(corners[edge + 1]);
        const DVec3 aim = a + (i % 3 == 0 ? 0 : i % 3 == 1 ? 0.5 : random(0, 1)) * (b - a);
        DVec3 d = {random(-0.03, 0.03), -1,
                   random(-0.03, 0.03)}; // steeper than the field, so that it hits no other cell before
        if (i % 4 == 0) d.x = 0;
        if (i % 8 < 2) d.z = 0;
        d = math::normalized(d);
        const double away = i % 7 == 0 ? 1e6 : random(0.5, 10);
        const auto hit = cast_ray(shape.geometry, shape.data, {}, {}, aim - away * d, d, 2e6);
        ASSERT_TRUE(hit) << i;
        ASSERT_LT(hit->distance, away + 1e-8);
    }
}

// Horizontal rays along grid lines and diagonals, towards a ridge that blocks them.
TEST(HeightFieldRay, PassesNowhereAlongTheGrid) {
    std::vector<float> heights(21 * 21, 0.0f);
    for (int i = 0; i < 21; ++i) heights[std::size_t(10 * 21 + i)] = heights[std::size_t(i * 21 + 10)] = 1;
    const HeightField field(21, 21, {0.1f, 0.1f}, heights);
    const test::Sample shape = sample_of(Shape(field));
    const HeightFieldData& data = height_field_of(shape.data);
    for (int i = 1; i < 20; ++i) {
        const double line = double(grid_line(21, 0.1f, i));
        for (const double side : {-1.0, 1.0}) {
            if (i != 10) { // along the ridge itself nothing blocks the ray
                EXPECT_TRUE(cast_ray(shape.geometry, shape.data, {}, {}, {-5 * side, 0.5, line}, {side, 0, 0}, 100));
                EXPECT_TRUE(cast_ray(shape.geometry, shape.data, {}, {}, {line, 0.5, -5 * side}, {0, 0, side}, 100));
            }
            EXPECT_TRUE(cast_ray(shape.geometry, shape.data, {}, {}, {line, 5, double(data.spacing_z)}, {0, -1, 0}, 9));
        }
    }
    const DVec3 d = math::normalized(DVec3{1, 0, 1});
    for (int i = -8; i <= 8; ++i)
        if (i != 0) {
            const DVec3 origin{-1 + 0.1 * i, 0.5, -1};
            EXPECT_TRUE(cast_ray(shape.geometry, shape.data, {}, {}, origin, d, 100)) << i;
        }
}

TEST(HeightFieldRay, IsNotMetFromBelow) {
    Random random(7);
    const auto field = shared_field(random, 20, 20, 1, 1);
    const test::Sample shape = sample_of(Shape(HeightField(field)));
    for (int i = 0; i < 1000; ++i)
        ASSERT_FALSE(cast_ray(shape.geometry, shape.data, {}, {}, {random(-9, 9), -2, random(-9, 9)}, {0, 1, 0}, 100));
}

} // namespace

} // namespace cairn
