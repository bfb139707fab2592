// Shape casts, closest points, and which layers a query sees; against closed forms.
#include "test_world.h"

namespace cairn::test {
namespace {

Hull tetrahedron() {
    const std::vector<Vec3> points = {{-1, -1, -1}, {1, -1, -1}, {0, -1, 1}, {0, 1, 0}};
    return Hull(points);
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
    double top; // above its origin
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
        if (std::string(still.name) != "plane") {
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

TEST(Layers, QueriesSeeOnlyTheirs) {
    World world(weightless());
    ShapeDef def;
    def.filter.layers = 4;
    const BodyId body = add_body(world, body_at({0, 0, 0}), Box{}, def);
    def.is_trigger = true;
    add_body(world, body_at({0, 5, 0}), Sphere{}, def);
    for (const std::uint64_t layers : {all_layers, std::uint64_t(4), std::uint64_t(6), std::uint64_t(2)}) {
        const bool sees = layers != 2;
        const auto ray = world.cast_ray({0, 10, 0}, {0, -1, 0}, 20, layers);
        EXPECT_EQ(bool(ray), sees);
        if (ray) {
            EXPECT_EQ(ray->body, body) << "not the trigger";
        }
        EXPECT_EQ(world.cast_ray_all({0, 10, 0}, {0, -1, 0}, 20, layers).size(), sees ? 1u : 0u);
        EXPECT_EQ(bool(world.cast_shape(Sphere{0.1f}, at({0, 10, 0}), {0, -20, 0}, layers)), sees);
        EXPECT_EQ(bool(world.closest_point({0, 3, 0}, 10, layers)), sees);
        EXPECT_EQ(world.overlap(Sphere{20}, at({0, 0, 0}), layers).size(), sees ? 1u : 0u);
        EXPECT_EQ(world.overlap_bounds({{-9, -9, -9}, {9, 9, 9}}, layers).size(), sees ? 1u : 0u);
    }
}

} // namespace
} // namespace cairn::test
