// One-way shapes, which hold bodies from one side only: platforms that characters jump onto from below.
#include "convex_shapes.h"
#include "support.h"

#include "validation/random_starts.h"

#include <cairn/error.h>

#include <cmath>
#include <string>
#include <vector>

namespace cairn_test {
namespace {

constexpr float dt = 1.0f / 60.0f;

// A platform of 20 m x 20 m with its upper side at height 0, in the frame of a random start.
constexpr int platform_kinds = 4;
BodyId add_platform(World& world, const RandomStart& random, int kind, BodyType type = BodyType::static_,
                    bool is_one_way = true) {
    const BodyId body =
        world.create_body({.type = type, .position = random.place({0, 0, 0}), .rotation = random.quat()});
    ShapeDef def;
    if (is_one_way) def.one_way = kind == 2 ? Vec3(1, 0, 0) : Vec3(0, 3, 0);
    def.material = surface(0.6f, 0);
    def.material.rolling_friction = 0.05f;
    const Plane upright{{0, 1, 0}, {1, 0, 0}, glm::vec2(10, 10)};
    switch (kind) {
    case 0:
        world.add_shape(body, upright, def);
        break;
    case 1:
        def.position = {0, -0.1f, 0};
        world.add_shape(body, Box{{10, 0.1f, 10}}, def);
        break;
    case 2: // a plane whose normal is x, rotated
        def.rotation = glm::angleAxis(float(pi / 2), Vec3(0, 0, 1));
        world.add_shape(body, Plane{{1, 0, 0}, {0, 1, 0}, glm::vec2(10, 10)}, def);
        break;
    default:
        def.position = {0, -0.2f, 0};
        world.add_shape(body, Cylinder{0.2f, 10.0f}, def);
        break;
    }
    return body;
}

WorldDef pulled_down(const RandomStart& random) {
    WorldDef def = without_sleep();
    def.gravity = Vec3(random.turned({0, -gravity, 0}));
    return def;
}

struct Thrown {
    World world;
    BodyId body;
};
Thrown thrown(const RandomStart& random, std::uint32_t seed, int platform, const Shape& shape, const glm::dvec3& from,
              const glm::dvec3& velocity, float spin, bool is_one_way = true) {
    Thrown result{World(pulled_down(random)), {}};
    if (platform >= 0) add_platform(result.world, random, platform, BodyType::static_, is_one_way);
    BodyDef def{.position = random.place(from), .rotation = RandomStart(seed + 5000).quat()};
    def.linear_velocity = Vec3(random.turned(velocity));
    def.angular_velocity = Vec3(random.turned({double(spin), 0.5 * double(spin), -double(spin)}));
    result.body = result.world.create_body(def);
    result.world.add_shape(result.body, shape);
    return result;
}

TEST(OneWay, WhatIsThrownUpFromBelowGoesThroughAndLandsOnIt) {
    for (std::uint32_t seed = 0; seed < 240; ++seed) {
        RandomStart random(seed);
        const int platform = int(seed) % platform_kinds;
        const float size = float(random.uniform(0.05, 0.3));
        const Shape shape = convex(int(seed / platform_kinds) % convex_kinds, size);
        const glm::dvec3 from(random.uniform(-0.5, 0.5), -random.uniform(0.8, 2), random.uniform(-0.5, 0.5));
        const glm::dvec3 velocity(random.uniform(-0.3, 0.3), random.uniform(8, 10), random.uniform(-0.3, 0.3));
        const float spin = float(random.uniform(0, 5));
        Thrown with = thrown(random, seed, platform, shape, from, velocity, spin);
        Thrown without = thrown(random, seed, -1, shape, from, velocity, spin);
        const int rising = int(velocity.y / gravity / double(dt));
        for (int i = 0; i < rising; ++i) with.world.step(dt), without.world.step(dt);
        EXPECT_LT(glm::length(with.world.body(with.body).position() - without.world.body(without.body).position()),
                  1e-5)
            << "start " << seed;
        run(with.world, dt, 240);
        const glm::dvec3 at = random.back(Vec3(with.world.body(with.body).position() - random.place({0, 0, 0})));
        EXPECT_GT(at.y, 0.2 * double(size)) << "start " << seed;
        EXPECT_LT(at.y, 1.7 * double(size)) << "start " << seed;
        EXPECT_LT(with.world.statistics().max_penetration, 1e-3) << "start " << seed;
    }
}

TEST(OneWay, WhatDoesNotGetWhollyThroughFallsBack) {
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        RandomStart random(seed);
        const int platform = int(seed) % platform_kinds;
        const float size = float(random.uniform(0.1, 0.3));
        const Shape shape = convex(int(seed / platform_kinds) % convex_kinds, size);
        const double start = -random.uniform(1, 2), top = -random.uniform(0.3, 1) * double(size); // of its center
        const glm::dvec3 from(0, start, 0), velocity(0, std::sqrt(2 * gravity * (top - start)), 0);
        Thrown with = thrown(random, seed, platform, shape, from, velocity, 3);
        Thrown without = thrown(random, seed, -1, shape, from, velocity, 3);
        run(with.world, dt, 100), run(without.world, dt, 100);
        EXPECT_LT(glm::length(with.world.body(with.body).position() - without.world.body(without.body).position()),
                  1e-5)
            << "start " << seed;
    }
}

TEST(OneWay, WhatComesFromTheSideAtItsHeightGoesOn) {
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        RandomStart random(seed);
        const int platform = int(seed) % platform_kinds;
        const Shape shape = convex(int(seed / platform_kinds) % convex_kinds, 0.3f);
        const glm::dvec3 from(-11, random.uniform(-0.25, -0.05), random.uniform(-1, 1)),
            velocity(random.uniform(3, 30), 0, 0);
        Thrown with = thrown(random, seed, platform, shape, from, velocity, 2);
        Thrown without = thrown(random, seed, -1, shape, from, velocity, 2);
        run(with.world, dt, 60), run(without.world, dt, 60);
        EXPECT_LT(glm::length(with.world.body(with.body).position() - without.world.body(without.body).position()),
                  1e-5)
            << "start " << seed;
    }
}

// At any speed the platform holds bodies from above and lets them through from below.
TEST(OneWay, FastThingsAreHeldFromAboveAndLetThroughFromBelow) {
    for (std::uint32_t seed = 0; seed < 240; ++seed) {
        RandomStart random(seed);
        const int platform = int(seed) % platform_kinds;
        const Shape shape = convex(int(seed / platform_kinds) % convex_kinds, float(random.uniform(0.02, 0.2)));
        const double speed = std::pow(10, random.uniform(1, 3));
        const glm::dvec3 from(random.uniform(-1, 1), 1 + random.uniform(0, 2), random.uniform(-1, 1));
        Thrown above = thrown(random, seed, platform, shape, from, {0, -speed, 0}, 5);
        Thrown solid = thrown(random, seed, platform, shape, from, {0, -speed, 0}, 5, false);
        run(above.world, dt, 30), run(solid.world, dt, 30);
        EXPECT_LT(glm::length(above.world.body(above.body).position() - solid.world.body(solid.body).position()), 1e-5)
            << "start " << seed << ", " << speed << " m/s";
        Thrown below = thrown(random, seed, platform, shape, -from, {0, speed, 0}, 5);
        Thrown without = thrown(random, seed, -1, shape, -from, {0, speed, 0}, 5);
        run(below.world, dt, 30), run(without.world, dt, 30);
        EXPECT_LT(glm::length(below.world.body(below.body).position() - without.world.body(without.body).position()),
                  1e-5)
            << "start " << seed << ", " << speed << " m/s";
    }
}

TEST(OneWay, APlatformThatRisesCarriesAStackAndLetsOthersThrough) {
    for (std::uint32_t seed = 0; seed < 24; ++seed) {
        RandomStart random(seed);
        World world(pulled_down(random));
        const BodyId platform = add_platform(world, random, int(seed) % platform_kinds, BodyType::kinematic);
        std::vector<BodyId> stack;
        for (int i = 0; i < 5; ++i) {
            stack.push_back(
                world.create_body({.position = random.place({0, 0.2 + 0.4 * i, 0}), .rotation = random.quat()}));
            ShapeDef def;
            def.density = i == 4 ? 20000.0f : 1000.0f;
            world.add_shape(stack.back(), Box{{0.2f, 0.2f, 0.2f}}, def);
        }
        const BodyId ball = world.create_body({.position = random.place({1, -3, 0})});
        world.add_shape(ball, Sphere{0.2f});
        world.body(ball).set_linear_velocity(Vec3(random.turned({0, 12, 0})));
        world.body(platform).set_linear_velocity(Vec3(random.turned({0, 1, 0})));
        run(world, dt, 180);
        const auto height = [&](BodyId body) {
            return glm::dot(random.turned({0, 1, 0}),
                            glm::dvec3(world.body(body).position() - random.place({0, 0, 0})));
        };
        for (std::size_t i = 0; i < stack.size(); ++i)
            EXPECT_NEAR(height(stack[i]), 3 + 0.2 + 0.4 * double(i), 0.005) << "start " << seed << " box " << i;
        EXPECT_NEAR(height(ball), 3.2, 0.01) << "start " << seed;
    }
}

TEST(OneWay, ACharacterJumpsOntoIt) {
    for (int kind = 0; kind < platform_kinds; ++kind) {
        World world;
        ShapeDef def;
        def.one_way = {0, 1, 0};
        world.add_shape(world.create_body({.type = BodyType::static_, .position = {0, -1.5, 0}}), Plane{});
        const BodyId platform = world.create_body({.type = BodyType::static_});
        if (kind == 0)
            world.add_shape(platform, Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(2, 2)}, def);
        else
            world.add_shape(platform, kind == 1 ? Shape(Box{{2, 0.1f, 2}}) : Shape(Cylinder{0.1f * float(kind), 2.0f}),
                            def);
        const BodyId walker = world.create_body({.type = BodyType::kinematic, .position = {-3, -0.7, 0}});
        world.add_shape(walker, Capsule{0.5f, 0.3f});
        world.body(walker).set_character({});
        world.body(walker).set_walk_velocity({1.5f, 0, 0}); // blocked by nobody: its head is above the platform
        run(world, dt, 120);
        EXPECT_NEAR(world.body(walker).position().x, 0, 0.1) << kind;
        world.body(walker).set_walk_velocity({0, 0, 0});
        run(world, dt, 30);
        world.body(walker).jump(7);
        run(world, dt, 180);
        EXPECT_EQ(world.body(walker).character_state().ground_body, platform) << kind;
        EXPECT_GT(world.body(walker).position().y, 0.8) << kind;
    }
}

TEST(OneWay, IsRefusedWhereThereIsNoOtherSide) {
    World world;
    const BodyId fixed = world.create_body({.type = BodyType::static_}), free = world.create_body();
    ShapeDef def;
    def.one_way = {0, 1, 0};
    const auto refused = [&](const auto& call, ErrorCode code) {
        try {
            call();
            ADD_FAILURE();
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), code) << error.what();
            EXPECT_NE(std::string(error.what()).find("one_way"), std::string::npos) << error.what();
        }
    };
    refused([&] { world.add_shape(free, Box{}, def); }, ErrorCode::wrong_state);
    refused([&] { world.add_shape(fixed, Plane{}, def); }, ErrorCode::wrong_state);
    refused([&] { world.add_shape(fixed, flat_mesh(2, 1.0f), def); }, ErrorCode::wrong_state);
    const ShapeId box = world.add_shape(fixed, Box{}, def);
    refused([&] { world.set_shape(box, flat_mesh(2, 1.0f)); }, ErrorCode::wrong_state);
    def.one_way = {0, std::nanf(""), 0};
    refused([&] { world.set_shape_def(box, def); }, ErrorCode::invalid_value);
    EXPECT_THROW(world.body(fixed).set_type(BodyType::dynamic), Error);
    EXPECT_EQ(world.shape_def(box).one_way, Vec3(0, 1, 0));
}

} // namespace
} // namespace cairn_test
