// Shape casts, closest points, and query layers, compared with closed forms.
#include "test_world.h"

#include <random>

namespace cairn::test {
namespace {

Hull tetrahedron() {
    const std::vector<Vec3> points = {{-1, -1, -1}, {1, -1, -1}, {0, -1, 1}, {0, 1, 0}};
    return Hull(points);
}
Hull rounded(Hull hull, float radius) {
    hull.rounding = radius;
    return hull;
}
Mesh square(float half) {
    const std::vector<Vec3> corners = {{-half, 0, -half}, {half, 0, -half}, {-half, 0, half}, {half, 0, half}};
    const std::vector<std::uint32_t> triangles = {0, 2, 3, 0, 3, 1};
    return Mesh(corners, triangles);
}
Transform at(const Position& position) { return {position, Quat(1.0f, 0.0f, 0.0f, 0.0f)}; }

struct Still {
    const char* name;
    Shape shape;
    double top; // height of the top above the shape's origin, m
};
std::vector<Still> still_shapes() {
    return {{"sphere", Sphere{1}, 1},
            {"box", Box{{1, 0.5f, 1}}, 0.5},
            {"plane", Plane{}, 0},
            {"rectangle", Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(2, 2)}, 0},
            {"capsule", Capsule{0.5f, 0.25f, {}}, 0.75},
            {"cylinder", Cylinder{0.5f, 0.75f, {}}, 0.5},
            {"cone", cone(0.5f, 0.5f), 0.5},
            {"hull", tetrahedron(), 1},
            {"rounded box", Box{{1, 0.25f, 1}, 0.25f}, 0.5},
            {"rounded cylinder", Cylinder{0.25f, 0.5f, {}, 0.25f}, 0.5},
            {"rounded cone", Cylinder{0.5f, 0.5f, 0.0f, 0.25f}, 0.75},
            {"rounded hull", rounded(tetrahedron(), 0.25f), 1.25},
            {"sheet", Plane{{0, 1, 0}, {1, 0, 0}, {}, true}, 0},
            {"rectangular sheet", Plane{{0, -1, 0}, {1, 0, 0}, glm::vec2(2, 2), true}, 0},
            {"strip", Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(2, infinity)}, 0},
            {"mesh", square(3), 0},
            {"height field", HeightField(3, 3, {2, 2}, std::vector<float>(9, 0.25f)), 0.25}};
}

TEST(ShapeCasts, BallThatFallsMeetsTheTopOfEveryShape) {
    for (const Still& still : still_shapes()) {
        World world;
        const BodyId body = add_body(world, body_at({100, 20, -50}, BodyType::static_), still.shape);
        const auto hit = world.cast_shape(Sphere{0.25f}, at({100, 30, -50}), {0, -20, 0});
        ASSERT_TRUE(hit) << still.name;
        EXPECT_EQ(hit->body, body) << still.name;
        EXPECT_EQ(hit->shape, world.body(body).shapes()[0]) << still.name;
        EXPECT_NEAR(hit->fraction, (10 - 0.25 - still.top) / 20, 1e-5) << still.name;
        EXPECT_NEAR(hit->point.y, 20 + still.top, 1e-4) << still.name;
        EXPECT_NEAR(hit->point.x, 100, 1e-3) << still.name;
        EXPECT_GT(hit->normal.y, 0.99f) << still.name;
        EXPECT_FALSE(world.cast_shape(Sphere{0.25f}, at({100, 30, -50}), {0, -8, 0})) << still.name << ": too short";
        EXPECT_FALSE(world.cast_shape(Sphere{0.25f}, at({100, 30, -50}), {0, 20, 0})) << still.name << ": away";
        if (std::string(still.name) != "plane" && std::string(still.name) != "sheet") {
            EXPECT_FALSE(world.cast_shape(Sphere{0.25f}, at({110, 30, -50}), {0, -20, 0})) << still.name << ": beside";
        }
    }
}

TEST(ShapeCasts, EveryConvexShapeCanBeCast) {
    const struct {
        Shape shape;
        double bottom;
    } moving[] = {{Sphere{0.5f}, 0.5},
                  {Box{{0.2f, 0.3f, 0.4f}}, 0.3},
                  {Capsule{0.5f, 0.25f, {}}, 0.75},
                  {Cylinder{0.4f, 0.3f, {}}, 0.4},
                  {cone(0.3f, 0.6f), 0.6},
                  {Box{{0.2f, 0.3f, 0.4f}, 0.1f}, 0.4},
                  {Cylinder{0.4f, 0.3f, {}, 0.1f}, 0.5},
                  {rounded(tetrahedron(), 0.1f), 1.1},
                  {tetrahedron(), 1}};
    World world;
    add_body(world, body_at({0, 0, 0}, BodyType::static_), square(5));
    for (const auto& m : moving) {
        const auto hit = world.cast_shape(m.shape, at({0.3, 5, 0.4}), {0, -10, 0});
        ASSERT_TRUE(hit) << m.shape.index();
        EXPECT_NEAR(hit->fraction, (5 - m.bottom) / 10, 1e-5) << m.shape.index();
    }
    for (const Shape& surface :
         {Shape(Plane{}), Shape(square(1)), Shape(HeightField(2, 2, {1, 1}, std::vector<float>(4, 0.0f)))})
        EXPECT_NE(refusal([&] {
                      world.cast_shape(surface, at({0, 5, 0}), {0, -1, 0});
                  }).find("convex"),
                  std::string::npos);
    EXPECT_NE(refusal([&] { world.cast_shape(Sphere{}, at({0, 5, 0}), {0, not_a_number, 0}); }), "");
    EXPECT_NE(refusal([&] { world.cast_shape(Sphere{-1}, at({0, 5, 0}), {0, -1, 0}); }), "");
}

TEST(ShapeCasts, OfTwoTheFirstIsMetAndOverlapsAreMetAtOnce) {
    World world(weightless());
    const BodyId far = add_body(world, body_at({10, 0, 0}), Box{});
    const BodyId near = add_body(world, body_at({5, 0, 0}), Sphere{});
    const auto hit = world.cast_shape(Box{}, at({0, 0, 0}), {20, 0, 0});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->body, near);
    EXPECT_NEAR(hit->fraction, 4.0 / 20, 1e-5);
    const auto inside = world.cast_shape(Box{}, at({10.2, 0, 0}), {5, 0, 0});
    ASSERT_TRUE(inside);
    EXPECT_EQ(inside->body, far);
    EXPECT_EQ(inside->fraction, 0);
}

TEST(ClosestPoints, AreOnTheSurfaceBelow) {
    for (const Still& still : still_shapes()) {
        World world;
        const BodyId body = add_body(world, body_at({1e6, 20, -50}, BodyType::static_), still.shape);
        const auto found = world.closest_point({1e6, 23, -50}, 10);
        ASSERT_TRUE(found) << still.name;
        EXPECT_EQ(found->body, body) << still.name;
        EXPECT_NEAR(found->distance, 3 - still.top, 1e-5) << still.name;
        EXPECT_NEAR(found->point.y, 20 + still.top, 1e-5) << still.name;
        EXPECT_FALSE(world.closest_point({1e6, 23, -50}, 0.9 * (3 - still.top))) << still.name;
        EXPECT_TRUE(world.closest_point({1e6, 23, -50}, 1e300)) << still.name;
    }
}

TEST(ClosestPoints, InsideIsNoDistance) {
    World world(weightless());
    add_body(world, body_at({0, 0, 0}), Box{});
    const auto found = world.closest_point({0.25, 0.1, 0}, 1);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->distance, 0);
    EXPECT_EQ(found->point.x, 0.25);
    EXPECT_NE(refusal([&] { world.closest_point({0, 0, 0}, -1); }), "");
    EXPECT_NE(refusal([&] { world.closest_point({double(not_a_number), 0, 0}, 1); }), "");
}

// A double-sided plane is hit from both sides, and no point is inside it.
TEST(Sheets, AreMetFromBothSides) {
    const Plane sheets[] = {Plane{{0, 1, 0}, {1, 0, 0}, {}, true}, Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(2, 2), true},
                            Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(2, infinity), true}};
    for (const Plane& sheet : sheets) {
        World world;
        const BodyId body = add_body(world, body_at({0, 0, 0}, BodyType::static_), sheet);
        for (const double side : {1.0, -1.0}) {
            const auto ray = world.cast_ray({0.5, 3 * side, 0.5}, {0, float(-side), 0}, 10);
            ASSERT_TRUE(ray) << side;
            EXPECT_NEAR(ray->distance, 3, 1e-6);
            EXPECT_NEAR(ray->normal.y, side, 1e-6);
            EXPECT_FALSE(world.cast_ray({0.5, 3 * side, 0.5}, {0, float(side), 0}, 10)) << "away";
            const auto cast = world.cast_shape(Box{}, at({0.5, 3 * side, 0.5}), {0, float(-10 * side), 0});
            ASSERT_TRUE(cast) << side;
            EXPECT_NEAR(cast->fraction, 0.25, 1e-5);
            EXPECT_NEAR(cast->normal.y, side, 1e-5);
            EXPECT_FALSE(world.cast_shape(Box{}, at({0.5, 3 * side, 0.5}), {0, float(10 * side), 0})) << "away";
            const auto closest = world.closest_point({0.5, 3 * side, 0.5}, 10);
            ASSERT_TRUE(closest);
            EXPECT_NEAR(closest->distance, 3, 1e-6);
            EXPECT_NEAR(closest->point.y, 0, 1e-6);
            EXPECT_TRUE(world.overlap(Sphere{0.5f}, at({0, 0.6 * side, 0})).empty());
            EXPECT_EQ(world.overlap(Sphere{0.5f}, at({0, 0.4 * side, 0})).size(), 1u);
            EXPECT_TRUE(world.overlap(Box{}, at({0, 5 * side, 0})).empty()) << "no side of it is solid";
        }
        EXPECT_EQ(world.body(body).shapes().size(), 1u);
    }
}

// Queries far from the middle of an infinitely long strip, and beside it.
TEST(Sheets, StripsAreMetAlongTheirWholeLength) {
    World world;
    add_body(world, body_at({0, 0, 0}, BodyType::static_), Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(infinity, 1)});
    for (const double x : {-1e6, 0.0, 1e4, 1e9}) {
        EXPECT_TRUE(world.cast_ray({x, 3, 0.9}, {0, -1, 0}, 10)) << x;
        EXPECT_FALSE(world.cast_ray({x, 3, 1.1}, {0, -1, 0}, 10)) << x;
        const auto cast = world.cast_shape(Sphere{0.5f}, at({x, 3, 0.9}), {0, -10, 0});
        ASSERT_TRUE(cast) << x;
        EXPECT_NEAR(cast->fraction, 0.25, 1e-5) << x;
        EXPECT_FALSE(world.cast_shape(Sphere{0.5f}, at({x, 3, 1.6}), {0, -10, 0})) << x;
        const auto closest = world.closest_point({x, 3, 5}, 10);
        ASSERT_TRUE(closest) << x;
        EXPECT_NEAR(closest->distance, 5, 1e-6) << x;
        EXPECT_NEAR(closest->point.z, 1, 1e-6) << x;
        EXPECT_NEAR(closest->point.x, x, 1e-6) << x;
        EXPECT_EQ(world.overlap(Sphere{0.5f}, at({x, 0.4, 0.9})).size(), 1u) << x;
        EXPECT_TRUE(world.overlap(Sphere{0.5f}, at({x, 0.4, 1.6})).empty()) << x;
    }
}

// Without the fix overlap queries used contacts, which are one-sided: they missed every ball whose center was below the
// surface and beyond its border.
TEST(Overlaps, BallsMeetASurfaceWhereverItsNearestPointIsWithinTheirRadius) {
    const std::vector<Shape> surfaces = {
        square(1), HeightField(3, 3, {1, 1}, std::vector<float>(9, 0.0f)), Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(1, 1)},
        Plane{{0, -1, 0}, {1, 0, 0}, glm::vec2(1, 1)}, Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(1, 1), true}};
    std::mt19937 random(31);
    std::uniform_real_distribution<double> any(-2.2, 2.2);
    const Position middle{1000, 20, -50};
    for (const Shape& surface : surfaces) {
        World world;
        const BodyId body = add_body(world, body_at(middle, BodyType::static_), surface);
        int met = 0, met_below_beside = 0;
        for (int i = 0; i < 4000; ++i) {
            const Position from{any(random), any(random), any(random)};
            const double beside = std::max({std::fabs(from.x) - 1, std::fabs(from.z) - 1, 0.0});
            const double distance = glm::length(
                Position(std::max(std::fabs(from.x) - 1, 0.0), from.y, std::max(std::fabs(from.z) - 1, 0.0)));
            if (std::fabs(distance - 1) < 1e-4) continue;
            const bool is_met = distance < 1;
            const std::size_t expected = is_met ? 1 : 0;
            ASSERT_EQ(world.overlap(Sphere{1}, at(middle + from)).size(), expected)
                << from.x << ", " << from.y << ", " << from.z << ": " << distance;
            ASSERT_EQ(world.closest_point(middle + from, 1).has_value(), is_met);
            met += is_met ? 1 : 0;
            met_below_beside += is_met && from.y < 0 && beside > 0 ? 1 : 0;
        }
        EXPECT_GT(met, 500);
        EXPECT_GT(met_below_beside, 100);
        // The reverse: the surface is the query shape, and the ball is in the world.
        world.destroy_body(body);
        add_body(world, body_at(middle, BodyType::static_), Sphere{1});
        EXPECT_EQ(world.overlap(surface, at(middle + Position(1.6, 0.5, 0))).size(), 1u);
        EXPECT_EQ(world.overlap(surface, at(middle + Position(1.6, 0.9, 0))).size(), 0u);
    }
}

TEST(Rounding, IsFeltByEveryQuery) {
    World world;
    add_body(world, body_at({0, 0, 0}, BodyType::static_), Box{{0.5f, 0.5f, 0.5f}, 0.25f});
    // Towards a corner: the corner of the core is at 0.5 on each axis, and the surface 0.25 beyond it.
    const double corner = std::sqrt(3.0) * 0.5 + 0.25, far = 4 / std::sqrt(3.0);
    const auto ray = world.cast_ray({far, far, far}, {-1, -1, -1}, 10);
    ASSERT_TRUE(ray);
    EXPECT_NEAR(ray->distance, 4 - corner, 1e-6);
    EXPECT_NEAR(ray->normal.x, std::sqrt(1.0 / 3), 1e-5);
    const auto closest = world.closest_point({far, far, far}, 10);
    ASSERT_TRUE(closest);
    EXPECT_NEAR(closest->distance, 4 - corner, 1e-6);
    const auto cast = world.cast_shape(Sphere{0.5f}, at({far, far, far}), Vec3(float(-far)));
    ASSERT_TRUE(cast);
    EXPECT_NEAR(cast->fraction * 4, 4 - corner - 0.5, 1e-5);
    EXPECT_EQ(world.overlap(Sphere{0.5f}, at({1.24, 0, 0})).size(), 1u);
    EXPECT_TRUE(world.overlap(Sphere{0.5f}, at({1.26, 0, 0})).empty());
    EXPECT_TRUE(world.overlap(Box{{0.1f, 0.1f, 0.1f}}, at({0.8, 0.8, 0.8})).empty()) << "beside the round corner";
    EXPECT_EQ(world.overlap(Box{{0.1f, 0.1f, 0.1f}}, at({0.8, 0.8, 0.8 - 0.5})).size(), 0u);
    EXPECT_EQ(world.overlap(Box{{0.1f, 0.1f, 0.1f}}, at({0.72, 0.72, 0})).size(), 1u);
    const Bounds bounds = world.shape_bounds(world.body(world.bodies()[0]).shapes()[0]);
    EXPECT_NEAR(bounds.max.x, 0.75, 1e-5);
}

TEST(Layers, QueriesSeeOnlyTheirs) {
    World world(weightless());
    ShapeDef def;
    def.filter.layers = 4;
    const BodyId body = add_body(world, body_at({0, 0, 0}), Box{}, def);
    def.is_trigger = true;
    add_body(world, body_at({0, 5, 0}), Sphere{}, def);
    for (const std::uint64_t layers : {all_layers, std::uint64_t(4), std::uint64_t(6), std::uint64_t(2)}) {
        const bool sees = layers != 2;
        const auto ray = world.cast_ray({0, 10, 0}, {0, -1, 0}, 20, {.layers = layers});
        EXPECT_EQ(bool(ray), sees);
        if (ray) {
            EXPECT_EQ(ray->body, body) << "not the trigger";
        }
        EXPECT_EQ(world.cast_ray_all({0, 10, 0}, {0, -1, 0}, 20, {.layers = layers}).size(), sees ? 1u : 0u);
        EXPECT_EQ(bool(world.cast_shape(Sphere{0.1f}, at({0, 10, 0}), {0, -20, 0}, {.layers = layers})), sees);
        EXPECT_EQ(bool(world.closest_point({0, 3, 0}, 10, {.layers = layers})), sees);
        EXPECT_EQ(world.overlap(Sphere{20}, at({0, 0, 0}), {.layers = layers}).size(), sees ? 1u : 0u);
        EXPECT_EQ(world.overlap_bounds({{-9, -9, -9}, {9, 9, 9}}, {.layers = layers}).size(), sees ? 1u : 0u);
    }
}

} // namespace
} // namespace cairn::test
