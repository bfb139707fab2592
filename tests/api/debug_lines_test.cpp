// World::debug_lines: the lines that visualize shapes, contacts and more.
#include <cairn/cairn.h>

#include <gtest/gtest.h>

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <random>
#include <vector>

namespace cairn {
namespace {

DebugLinesDef only_shapes() {
    DebugLinesDef what;
    what.contacts = what.joints = false;
    return what;
}

class Random {
  public:
    explicit Random(std::uint32_t seed) : bits_(seed) {}
    float uniform(float least, float most) { return least + (most - least) * float(bits_() % 10007) / 10007.0f; }
    Vec3 vector(float most) { return {uniform(-most, most), uniform(-most, most), uniform(-most, most)}; }
    Quat rotation() { return glm::normalize(Quat(1.1f, uniform(-1, 1), uniform(-1, 1), uniform(-1, 1))); }

  private:
    std::mt19937 bits_;
};

std::vector<Shape> solids(Random& random) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 20; ++i)
        corners.push_back(glm::normalize(random.vector(1) + Vec3(1e-3f)) * random.uniform(0.5f, 1));
    Hull rounded{corners};
    rounded.rounding = 0.1f;
    return {Sphere{0.7f},
            Box{{0.3f, 0.5f, 0.7f}},
            Box{{0.3f, 0.5f, 0.7f}, 0.2f},
            Capsule{0.5f, 0.3f},
            Capsule{0.5f, 0.6f, 0.2f},
            Capsule{0.1f, 0.2f, 0.9f}, // one end ball is inside the other
            Cylinder{0.5f, 0.4f},
            Cylinder{0.5f, 0.4f, 0.7f},
            cone(0.5f, 0.6f),
            Cylinder{0.5f, 0.6f, 0.2f, 0.1f},
            Hull(corners),
            rounded};
}

// The ends of lines are on the surface: a point a little farther out is outside the shape, one a little farther in is
// inside.
TEST(DebugLines, OfSolidsEndOnTheirSurfaces) {
    Random random(1);
    for (const Shape& shape : solids(random)) {
        World world;
        const BodyId body = world.create_body(
            {.position = {random.uniform(-99, 99), 7, random.uniform(-99, 99)}, .rotation = random.rotation()});
        ShapeDef def;
        def.position = random.vector(1);
        def.rotation = random.rotation();
        const ShapeId id = world.add_shape(body, shape, def);
        const std::vector<DebugLine> lines = world.debug_lines(only_shapes());
        EXPECT_GE(lines.size(), 8u);
        const Position middle = world.body(body).center_of_mass();
        for (const DebugLine& line : lines)
            for (const Position& end : {line.begin, line.end}) {
                const auto outside = world.closest_point(middle + 1.02 * (end - middle), 1.0);
                ASSERT_TRUE(outside && outside->shape == id);
                EXPECT_GT(outside->distance, 1e-4) << shape.index();
                const auto inside = world.closest_point(middle + 0.98 * (end - middle), 1.0);
                ASSERT_TRUE(inside);
                EXPECT_EQ(inside->distance, 0) << shape.index();
            }
    }
}

TEST(DebugLines, OfSurfacesAreTheirEdges) {
    World world;
    const BodyId body = world.create_body({.type = BodyType::static_, .position = {1, 2, 3}});
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
    const std::vector<std::uint32_t> indices{0, 2, 1, 0, 3, 2};
    world.add_shape(body, Mesh(corners, indices));
    EXPECT_EQ(world.debug_lines().size(), 5u); // the diagonal, which two triangles share, is drawn once
    world.add_shape(body, HeightField(3, 2, {1, 1}, std::vector<float>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(world.debug_lines().size(), 5u + 4 + 3 + 2);
    world.add_shape(body, Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(1, 2)});
    EXPECT_EQ(world.debug_lines().size(), 14u + 4 + 1);
    const std::size_t before = world.debug_lines().size();
    world.add_shape(body, Plane{{0, 0, 1}});
    for (const DebugLine& line : world.debug_lines())
        for (const Position& end : {line.begin, line.end}) EXPECT_TRUE(std::isfinite(end.x) && std::isfinite(end.y));
    EXPECT_EQ(world.debug_lines().size(), before + 4 + 1 + 8 + 10) << "a grid";
}

TEST(DebugLines, ShowContactsJointsBoundsAndMotion) {
    World world;
    world.add_shape(world.create_body({.type = BodyType::static_}), Plane{});
    const BodyId box = world.create_body({.position = {0, 0.5, 0}}), ball = world.create_body({.position = {0, 3, 0}});
    world.add_shape(box, Box{{0.5f, 0.5f, 0.5f}});
    world.add_shape(ball, Sphere{0.25f});
    world.create_joint(world.joint_at(box, ball, {0, 2, 0}, {0, 1, 0}, BallJoint{}));
    for (int i = 0; i < 30; ++i) world.step(1.0f / 60);
    DebugLinesDef what;
    what.shapes = what.joints = false;
    what.size = 0.5f;
    std::vector<DebugLine> lines = world.debug_lines(what);
    ASSERT_EQ(lines.size(), 4u); // the normal at each contact point
    for (const DebugLine& line : lines) {
        EXPECT_NEAR(line.begin.y, 0, 1e-3);
        EXPECT_NEAR(std::fabs(line.begin.x), 0.5, 1e-3);
        EXPECT_NEAR(glm::length(line.end - line.begin), 0.5, 1e-6);
    }
    what.impulse_scale = 1.0f;
    double sum = 0;
    for (const DebugLine& line : world.debug_lines(what)) sum += glm::length(line.end - line.begin);
    const double mass = double(world.body(box).mass()) + double(world.body(ball).mass());
    EXPECT_NEAR(sum, mass * 9.81 / 60, 0.02 * mass * 9.81 / 60);
    what = only_shapes();
    what.shapes = false;
    what.joints = true;
    lines = world.debug_lines(what);
    ASSERT_EQ(lines.size(), 3u + 3u);
    EXPECT_NEAR(glm::length(lines[0].end - Position(0, 2, 0)), 0, 1e-2);
    what.joints = false;
    what.bounds = true;
    EXPECT_EQ(world.debug_lines(what).size(), 24u) << "none of the infinite plane";
    what.bounds = false;
    what.centers = true;
    EXPECT_EQ(world.debug_lines(what).size(), 6u);
    what.centers = false;
    what.velocities = true;
    world.body(ball).set_linear_velocity({3, 0, 0});
    world.body(box).set_linear_velocity({0, 0, 0});
    lines = world.debug_lines(what);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NEAR(lines[0].end.x - lines[0].begin.x, 0.3, 1e-6);
}

TEST(DebugLines, ColorsTellWhatABodyIs) {
    World world;
    std::vector<Vec3> colors;
    const auto color_of_new = [&](const BodyDef& def, bool is_trigger) {
        World one;
        ShapeDef shape;
        shape.is_trigger = is_trigger;
        one.add_shape(one.create_body(def), Box{}, shape);
        return one.debug_lines()[0].color;
    };
    colors = {color_of_new({.type = BodyType::static_}, false), color_of_new({.type = BodyType::kinematic}, false),
              color_of_new({}, false), color_of_new({.type = BodyType::static_}, true)};
    for (std::size_t i = 0; i < colors.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) EXPECT_GT(glm::length(colors[i] - colors[k]), 0.2f) << i << " " << k;
}

TEST(DebugLines, RefuseSizesThatAreNone) {
    World world;
    for (const float size : {0.0f, -1.0f, std::nanf("")}) {
        DebugLinesDef what;
        what.size = size;
        EXPECT_THROW(world.debug_lines(what), Error);
    }
    DebugLinesDef what;
    what.impulse_scale = -1;
    EXPECT_THROW(world.debug_lines(what), Error);
}

} // namespace
} // namespace cairn
