// Queries over the whole world find what a test of each shape alone finds, for random positions, directions and
// lengths.
#include "chance.h"
#include "test_world.h"

#include <algorithm>
#include <optional>
#include <variant>
#include <vector>

namespace cairn::test {
namespace {

Hull any_hull(Chance& chance) {
    std::vector<Vec3> points;
    for (int i = 0; i < 12; ++i) points.push_back(chance.in_box(0.6f));
    return Hull(points);
}
Shape any_solid(Chance& chance) {
    const float a = chance.between(0.1f, 0.8f), b = chance.between(0.1f, 0.8f);
    switch (chance.below(7)) {
    case 0:
        return Sphere{a};
    case 1:
        return Box{{a, b, chance.between(0.1f, 0.8f)}};
    case 2:
        return Capsule{a, b, {}};
    case 3:
        return Capsule{a, b, 0.5f * b};
    case 4:
        return Cylinder{a, b, {}};
    case 5:
        return Box{{a, b, 0.2f}, 0.1f};
    default:
        return any_hull(chance);
    }
}
Shape any_surface(Chance& chance, unsigned kind) {
    std::vector<float> heights(81);
    for (float& h : heights) h = chance.between(-0.6f, 0.6f);
    if (kind == 0) return HeightField(9, 9, {1, 1}, heights);
    if (kind == 1) return Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(3, 2)};
    if (kind == 2) return Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(3, infinity), true};
    if (kind == 3) return Plane{{0, 1, 0}, {1, 0, 0}, {}, true};
    std::vector<Vec3> corners;
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t i = 0; i < 81; ++i) corners.push_back({float(i % 9) - 4, heights[i], float(i / 9) - 4});
    for (std::uint32_t i = 0; i < 80 - 9; ++i)
        if (i % 9 < 8) triangles.insert(triangles.end(), {i, i + 9, i + 10, i, i + 10, i + 1});
    return Mesh(corners, triangles);
}

constexpr unsigned layer_count = 60;
constexpr Position center{2000, -300, 40};

// Overlapping solids and surfaces, each in its own layer; some static, some awake, some asleep.
void build(World& world, Chance& chance) {
    for (unsigned i = 0; i < layer_count; ++i) {
        BodyDef body = body_at(center + Position(chance.in_box(4)), i % 3 == 0 ? BodyType::static_ : BodyType::dynamic);
        body.rotation = chance.rotation();
        ShapeDef def;
        def.filter.layers = std::uint64_t(1) << i;
        def.filter.collides_with = 0;
        if (i < 10) body.type = BodyType::static_;
        const BodyId id = add_body(world, body, i < 10 ? any_surface(chance, i % 5) : any_solid(chance), def);
        if (i >= 10 && i % 3 == 1) world.body(id).set_linear_velocity({0.2f, 0, 0});
    }
    run(world, 60);
    ASSERT_GT(world.statistics().sleeping_islands, 5u);
    ASSERT_GT(world.statistics().awake_bodies, 5u);
}

bool is_solid(const World& world, ShapeId id) {
    const Shape& shape = world.shape(id);
    return !std::holds_alternative<Plane>(shape) && !std::holds_alternative<Mesh>(shape) &&
           !std::holds_alternative<HeightField>(shape);
}

TEST(QuerySearch, CastsMeetTheFirstOfAllThatEachAloneMeets) {
    int met = 0, missed = 0, at_once = 0;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        Chance chance(seed);
        World world(weightless());
        build(world, chance);
        for (int k = 0; k < 250; ++k) {
            const Shape shape = any_solid(chance);
            const Transform start{center + Position(chance.in_box(10)), chance.rotation()};
            const Vec3 way = k % 10 == 0 ? Vec3(0.0f) : chance.in_box(chance.between(0.1f, 20));
            std::optional<ShapeCastHit> first;
            for (unsigned i = 0; i < layer_count; ++i) {
                const auto alone = world.cast_shape(shape, start, way, {.layers = std::uint64_t(1) << i});
                if (alone && (!first || alone->fraction < first->fraction)) first = alone;
            }
            const auto hit = world.cast_shape(shape, start, way);
            ASSERT_EQ(hit.has_value(), first.has_value()) << seed << ' ' << k;
            if (!hit) {
                ++missed;
                continue;
            }
            ++(hit->fraction > 0 ? met : at_once);
            const double way_length = double(glm::length(way));
            ASSERT_NEAR(hit->fraction * way_length, first->fraction * way_length, 2e-6) << seed << ' ' << k;
            if (hit->shape == first->shape) {
                EXPECT_LT(glm::length(hit->point - first->point), 2e-3);
            }
            EXPECT_NEAR(glm::length(hit->normal), 1, 1e-5);
            if (hit->fraction == 0) continue;
            EXPECT_LT(glm::dot(hit->normal, way), 1e-6f);
            // The shapes touch at the reported fraction, and not before. (Surfaces may be crossed from behind before
            // they are hit.)
            const auto overlaps = [&](float off) {
                const Position at = start.position + hit->fraction * Position(way) + Position(off * hit->normal);
                return !world
                            .overlap(shape, {at, start.rotation}, {.layers = world.shape_def(hit->shape).filter.layers})
                            .empty();
            };
            EXPECT_TRUE(overlaps(-1e-5f)) << seed << ' ' << k;
            if (is_solid(world, hit->shape)) {
                EXPECT_FALSE(overlaps(1e-5f)) << seed << ' ' << k;
            }
        }
    }
    EXPECT_GT(met, 200);
    EXPECT_GT(missed, 50);
    EXPECT_GT(at_once, 50);
}

TEST(QuerySearch, ClosestPointsAreThoseOfTheNearestAlone) {
    int found = 0;
    for (unsigned seed = 11; seed <= 14; ++seed) {
        Chance chance(seed);
        World world(weightless());
        build(world, chance);
        for (int k = 0; k < 250; ++k) {
            const Position from = center + Position(chance.in_box(12));
            const double most = double(chance.between(0, 8));
            std::optional<ClosestPoint> nearest;
            for (unsigned i = 0; i < layer_count; ++i) {
                const auto alone = world.closest_point(from, most, {.layers = std::uint64_t(1) << i});
                if (alone && (!nearest || alone->distance < nearest->distance)) nearest = alone;
            }
            const auto hit = world.closest_point(from, most);
            ASSERT_EQ(hit.has_value(), nearest.has_value()) << seed << ' ' << k;
            if (!hit) continue;
            ++found;
            EXPECT_NEAR(hit->distance, nearest->distance, 1e-9) << seed << ' ' << k;
            EXPECT_NEAR(glm::length(hit->point - from), hit->distance, 1e-6) << seed << ' ' << k;
            // A ball whose radius is slightly larger than the distance overlaps the shape, a slightly smaller one does
            // not.
            const auto layer = world.shape_def(hit->shape).filter.layers;
            if (!(hit->distance > 1e-3)) continue;
            const auto overlaps = [&](double radius) {
                return !world.overlap(Sphere{float(radius)}, {from, Quat(1, 0, 0, 0)}, {.layers = layer}).empty();
            };
            EXPECT_TRUE(overlaps(hit->distance + 1e-5)) << seed << ' ' << k;
            EXPECT_FALSE(overlaps(hit->distance - 1e-5)) << seed << ' ' << k;
        }
    }
    EXPECT_GT(found, 500);
}

TEST(QuerySearch, OverlapsAreThoseOfEachAlone) {
    std::size_t found = 0;
    for (unsigned seed = 21; seed <= 24; ++seed) {
        Chance chance(seed);
        World world(weightless());
        build(world, chance);
        for (int k = 0; k < 250; ++k) {
            const Shape shape = k % 10 == 0 ? any_surface(chance, chance.below(5)) : any_solid(chance);
            const Transform pose{center + Position(chance.in_box(6)), chance.rotation()};
            std::vector<ShapeId> alone;
            for (unsigned i = 0; i < layer_count; ++i)
                for (const ShapeId id : world.overlap(shape, pose, {.layers = std::uint64_t(1) << i}))
                    alone.push_back(id);
            std::sort(alone.begin(), alone.end(), [](ShapeId a, ShapeId b) { return a.index() < b.index(); });
            ASSERT_EQ(world.overlap(shape, pose), alone) << seed << ' ' << k;
            found += alone.size();
        }
    }
    EXPECT_GT(found, 500u);
}

// Long shape casts over, and closest points far from, surfaces of many triangles.
TEST(QuerySearch, SurfacesAreSearchedAlongTheWay) {
    Chance chance(31);
    std::vector<float> heights(200 * 200);
    for (float& h : heights) h = chance.between(0, 0.5f);
    World world;
    add_body(world, body_at({0, 0, 0}, BodyType::static_), HeightField(200, 200, {1, 1}, heights));
    for (int k = 0; k < 100; ++k) {
        const Position from(chance.between(-90, 90), chance.between(1, 30), chance.between(-90, 90));
        const Position to(chance.between(-90, 90), 0, chance.between(-90, 90));
        const auto hit = world.cast_shape(Sphere{0.2f}, {from, Quat(1, 0, 0, 0)}, Vec3(3.0 * (to - from)));
        ASSERT_TRUE(hit) << k;
        // No surface is nearer than the radius anywhere on the path up to the hit.
        for (int i = 0; i < 50; ++i) {
            const Position at = from + (hit->fraction * i / 50) * 3.0 * (to - from);
            EXPECT_FALSE(world.closest_point(at, 0.2 - 1e-5)) << k;
        }
        const Position touch = from + hit->fraction * 3.0 * (to - from);
        const auto nearest = world.closest_point(touch, 1000);
        ASSERT_TRUE(nearest);
        EXPECT_NEAR(nearest->distance, 0.2, 1e-5) << k;
        EXPECT_LT(glm::length(nearest->point - hit->point), 1e-3) << k;
    }
}

} // namespace
} // namespace cairn::test
