// Shapes whose geometry or kind changes while the world runs: edited ground, bodies that grow, crouch or change type.
#include "convex_shapes.h"
#include "support.h"

#include "validation/random_starts.h"

#include <cairn/error.h>
#include <cairn/snapshot.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace cairn_test {
namespace {

constexpr float dt = 1.0f / 60.0f;

WorldDef with_gravity(const Vec3& gravity) {
    WorldDef def = without_sleep();
    def.gravity = gravity;
    return def;
}

// A height field of 9 x 9 samples, spaced 1 m apart.
constexpr int grid = 9;
HeightField field_of(const std::function<float(int, int)>& height) {
    std::vector<float> heights;
    for (int r = 0; r < grid; ++r)
        for (int c = 0; c < grid; ++c) heights.push_back(height(c, r));
    return HeightField(grid, grid, {1.0f, 1.0f}, heights);
}

bool has_events(const World& world) {
    return !world.contact_begins().empty() || !world.contact_ends().empty() || !world.contact_hits().empty();
}

TEST(ChangedShapes, GroundThatIsEditedElsewhereLeavesAStackAlone) {
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        RandomStart random(seed);
        World world(with_gravity(Vec3(random.turned({0, -gravity, 0}))));
        const BodyId ground = world.create_body(
            {.type = BodyType::static_, .position = random.place({0, 0, 0}), .rotation = random.quat()});
        const ShapeId field = world.add_shape(ground, field_of([](int, int) { return 0.0f; }));
        std::vector<BodyId> boxes;
        for (int i = 0; i < 5; ++i) {
            boxes.push_back(
                world.create_body({.position = random.place({0.3, 0.2 + 0.4 * i, 0.2}), .rotation = random.quat()}));
            world.add_shape(boxes.back(), Box{{0.2f, 0.2f, 0.2f}});
        }
        run(world, dt, 60);
        std::vector<Position> before;
        for (const BodyId box : boxes) before.push_back(world.body(box).position());
        for (int i = 0; i < 120; ++i) {
            world.set_shape(field, field_of([&](int c, int r) {
                                return c < 3 || r < 3 ? float(random.uniform(-0.5, 0.5)) : 0.0f;
                            }));
            world.step(dt);
            EXPECT_FALSE(has_events(world)) << "start " << seed << ", step " << i;
        }
        for (std::size_t i = 0; i < boxes.size(); ++i)
            EXPECT_LT(glm::length(world.body(boxes[i]).position() - before[i]), 1e-4) << "start " << seed;
    }
}

TEST(ChangedShapes, GroundThatRisesCarriesWhatIsOnIt) {
    for (std::uint32_t seed = 0; seed < 24; ++seed) {
        RandomStart random(seed);
        World world(with_gravity(Vec3(random.turned({0, -gravity, 0}))));
        const BodyId ground = world.create_body(
            {.type = BodyType::static_, .position = random.place({0, 0, 0}), .rotation = random.quat()});
        const ShapeId field = world.add_shape(ground, field_of([](int, int) { return 0.0f; }));
        std::vector<BodyId> bodies;
        for (int i = 0; i < 9; ++i) {
            const glm::dvec3 place(1.5 * (i % 3) - 1.5 + random.uniform(-0.3, 0.3), 0.4,
                                   1.5 * (i / 3) - 1.5 + random.uniform(-0.3, 0.3));
            bodies.push_back(world.create_body({.position = random.place(place), .rotation = random.quat()}));
            const ShapeId shape = world.add_shape(bodies.back(), convex(i % convex_kinds, 0.3f));
            Material material;
            material.rolling_friction = 0.02f;
            world.set_material(shape, material);
        }
        run(world, dt, 120);
        const auto height = [&](BodyId body) {
            return glm::dot(random.turned({0, 1, 0}),
                            glm::dvec3(world.body(body).position() - random.place({0, 0, 0})));
        };
        std::vector<double> before;
        for (const BodyId body : bodies) before.push_back(height(body));
        const float speed = float(random.uniform(0.2, 1.0)), end = float(random.uniform(0.2, 1.0));
        for (float level = 0; level < end; level += speed * dt) {
            world.set_shape(field, field_of([&](int, int) { return level; }));
            world.step(dt);
            for (std::size_t i = 0; i < bodies.size(); ++i)
                EXPECT_GT(height(bodies[i]), before[i] + double(level) - 0.03) << "start " << seed << " body " << i;
        }
        world.set_shape(field, field_of([&](int, int) { return end; }));
        run(world, dt, 120);
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            EXPECT_NEAR(height(bodies[i]), before[i] + double(end), 0.002) << "start " << seed << " body " << i;
            EXPECT_LT(glm::length(world.body(bodies[i]).linear_velocity()), 0.01f) << "start " << seed << " body " << i;
        }
    }
}

// A body whose shape changes type in flight continues as a body that has had the new shape from the beginning.
TEST(ChangedShapes, WhatChangesInFlightLandsAsIfItHadAlwaysBeenSo) {
    std::vector<double> off;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        RandomStart random(seed);
        const Vec3 pull(random.turned({0, -gravity, 0}));
        World changed(with_gravity(pull)), fresh(with_gravity(pull));
        std::vector<BodyId> bodies, fresh_bodies;
        std::vector<ShapeId> shapes;
        BodyDef ground{.type = BodyType::static_, .position = random.place({0, 0, 0}), .rotation = random.quat()};
        for (World* world : {&changed, &fresh}) world->add_shape(world->create_body(ground), Box{{5, 0.5f, 5}});
        std::vector<Shape> next;
        for (int i = 0; i < 8; ++i) {
            BodyDef def{.position = random.place({1.4 * (i % 3) - 1.4, 3.0 + 1.4 * (i / 3), random.uniform(-0.2, 0.2)}),
                        .rotation = RandomStart(1000 + 8 * seed + std::uint32_t(i)).quat()};
            def.angular_velocity = Vec3(random.turned({random.uniform(-3, 3), 1, random.uniform(-3, 3)}));
            bodies.push_back(changed.create_body(def));
            shapes.push_back(changed.add_shape(bodies.back(), convex(int(random.uniform(0, convex_kinds)), 0.3f)));
            next.push_back(convex(int(random.uniform(0, convex_kinds)), float(random.uniform(0.2, 0.4))));
        }
        run(changed, dt, 12);
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            ShapeDef def;
            def.position = {0.05f, 0.02f, -0.03f};
            def.density = float(random.uniform(300, 3000));
            def.material = surface(float(random.uniform(0, 1)), float(random.uniform(0, 0.5)));
            changed.set_shape(shapes[i], next[i]);
            changed.set_shape_def(shapes[i], def);
            const Body body = changed.body(bodies[i]);
            BodyDef now{.position = body.position(), .rotation = body.rotation()};
            now.linear_velocity = body.linear_velocity();
            now.angular_velocity = body.angular_velocity();
            fresh_bodies.push_back(fresh.create_body(now));
            fresh.add_shape(fresh_bodies.back(), next[i], def);
            // The velocity is that of the center of mass, which the new shape has moved.
            fresh.body(fresh_bodies.back()).set_linear_velocity(body.linear_velocity());
            EXPECT_EQ(changed.body(bodies[i]).mass(), fresh.body(fresh_bodies[i]).mass());
        }
        for (int i = 0; i < 90; ++i) changed.step(dt), fresh.step(dt);
        for (std::size_t i = 0; i < bodies.size(); ++i)
            off.push_back(glm::length(changed.body(bodies[i]).position() - fresh.body(fresh_bodies[i]).position()));
    }
    // The fresh world receives rotations as floats, so a body that tumbles on its edges may take another path: the bars
    // hold for quantiles only.
    std::sort(off.begin(), off.end());
    EXPECT_LT(off[off.size() / 2], 1e-4);
    EXPECT_LT(off[off.size() * 3 / 4], 2e-3);
}

TEST(ChangedShapes, WhatGrowsInAHeapPushesTheRestAwayGently) {
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        RandomStart random(seed);
        World world(with_gravity(Vec3(random.turned({0, -gravity, 0}))));
        const BodyId room = world.create_body(
            {.type = BodyType::static_, .position = random.place({0, 0, 0}), .rotation = random.quat()});
        for (int axis = 0; axis < 3; ++axis)
            for (const float side : {-1.0f, 1.0f}) {
                ShapeDef def;
                def.position[axis] = side * 1.1f;
                Vec3 half(1.2f);
                half[axis] = 0.1f;
                world.add_shape(room, Box{half}, def);
            }
        std::vector<BodyId> bodies;
        std::vector<ShapeId> shapes;
        for (int i = 0; i < 40; ++i) {
            const glm::dvec3 place(0.4 * (i % 4) - 0.6, -0.8 + 0.35 * (i / 16), 0.4 * (i / 4 % 4) - 0.6);
            bodies.push_back(world.create_body({.position = random.place(place), .rotation = random.quat()}));
            shapes.push_back(world.add_shape(bodies.back(), convex(i % convex_kinds, 0.12f)));
        }
        run(world, dt, 60);
        float fastest = 0;
        for (int i = 1; i <= 60; ++i) {
            const float size = 0.12f + 0.28f * float(i) / 60;
            for (const std::size_t k : {0u, 13u}) // a ball and a box
                world.set_shape(shapes[k], convex(int(k) % convex_kinds, size));
            world.step(dt);
            for (const BodyId body : bodies)
                fastest = std::max(fastest, glm::length(world.body(body).linear_velocity()));
        }
        EXPECT_LT(fastest, 4.0f) << "start " << seed;
        run(world, dt, 120);
        EXPECT_LT(world.statistics().max_penetration, 0.002) << "start " << seed;
        EXPECT_NEAR(world.body(bodies[0]).mass(), 1000 * 4.18879f * 0.4f * 0.4f * 0.4f, 0.1f);
        for (const BodyId body : bodies) {
            const glm::dvec3 at = random.back(Vec3(world.body(body).position() - random.place({0, 0, 0})));
            EXPECT_LT(std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}), 1.0) << "start " << seed;
        }
    }
}

TEST(ChangedShapes, WhatStandsOnGroundThatIsTakenAwayFalls) {
    WorldDef settings; // with sleeping enabled
    World world(settings);
    const ShapeId ground = world.add_shape(world.create_body({.type = BodyType::static_}), Box{{50, 0.5f, 50}});
    const BodyId here = world.create_body({.position = {0, 1, 0}}), there = world.create_body({.position = {30, 1, 0}});
    for (const BodyId body : {here, there}) world.add_shape(body, Box{});
    run(world, dt, 120);
    ASSERT_FALSE(world.body(there).is_awake());
    world.set_shape(ground, Box{{2, 0.5f, 2}});
    run(world, dt, 60);
    EXPECT_LT(world.body(there).position().y, -3);
    EXPECT_NEAR(world.body(here).position().y, 1, 1e-3);
    // The body lands on the ground again once the ground shape covers its position.
    world.set_shape(ground, Plane{});
    world.body(there).set_position({30, 5, 0});
    run(world, dt, 180);
    EXPECT_NEAR(world.body(there).position().y, 0.5, 1e-3);
    EXPECT_NEAR(world.body(here).position().y, 0.5, 1e-3);
}

TEST(ChangedShapes, BecomeTriggersAndSolidAgain) {
    World world(without_sleep());
    const ShapeId floor = world.add_shape(world.create_body({.type = BodyType::static_}), Box{{5, 0.5f, 5}});
    const BodyId ball = world.create_body({.position = {0, 1, 0}});
    const ShapeId shape = world.add_shape(ball, Sphere{0.5f});
    run(world, dt, 30);
    ShapeDef def = world.shape_def(floor);
    def.is_trigger = true;
    world.set_shape_def(floor, def);
    world.step(dt);
    ASSERT_EQ(world.contact_ends().size(), 1u);
    ASSERT_EQ(world.trigger_events().size(), 1u);
    EXPECT_TRUE(world.trigger_events()[0].inside);
    EXPECT_EQ(world.trigger_events()[0].other, shape);
    run(world, dt, 6);
    EXPECT_LT(world.body(ball).linear_velocity().y, -0.9f);
    def.is_trigger = false;
    world.set_shape_def(floor, def);
    run(world, dt, 60);
    EXPECT_NEAR(world.body(ball).position().y, 1, 1e-3); // the floor pushes the ball out again
}

// A character passes below a beam only after it has crouched, and its feet stay at their height.
TEST(ChangedShapes, ACharacterCrouchesBelowABeam) {
    for (const bool crouches : {false, true}) {
        World world;
        world.add_shape(world.create_body({.type = BodyType::static_}), Plane{});
        const BodyId beam = world.create_body({.type = BodyType::static_, .position = {2, 1.5, 0}});
        world.add_shape(beam, Box{{0.2f, 0.2f, 3}});
        const BodyId walker = world.create_body({.type = BodyType::kinematic, .position = {0, 0, 0}});
        ShapeDef def;
        def.position = {0, 0.9f, 0};
        const ShapeId shape = world.add_shape(walker, Capsule{0.6f, 0.3f}, def);
        world.body(walker).set_character({});
        run(world, dt, 30);
        const double feet = world.body(walker).position().y;
        if (crouches) {
            def.position = {0, 0.6f, 0};
            world.set_shape(shape, Capsule{0.3f, 0.3f});
            world.set_shape_def(shape, def);
        }
        world.body(walker).set_walk_velocity({2, 0, 0});
        run(world, dt, 120);
        EXPECT_NEAR(world.body(walker).position().y, feet, 1e-3);
        if (crouches)
            EXPECT_NEAR(world.body(walker).position().x, 4, 0.1);
        else
            EXPECT_LT(world.body(walker).position().x, 1.8);
    }
}

TEST(ChangedShapes, RefusalsNameTheArgumentAndChangeNothing) {
    World world;
    const BodyId body = world.create_body();
    const ShapeId shape = world.add_shape(body, Box{});
    const ShapeId gone = world.add_shape(body, Sphere{});
    world.remove_shape(gone);
    run(world, dt, 3);
    const std::uint64_t before = world.state_hash();
    const MassProperties mass = world.body(body).mass_properties();
    const auto refused = [&](const auto& call, ErrorCode code, const char* field) {
        try {
            call();
            ADD_FAILURE() << field;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), code) << field;
            EXPECT_NE(std::string(error.what()).find(field), std::string::npos) << error.what();
        }
    };
    const auto geometry_refused = [&](const Shape& geometry, ErrorCode code, const char* field) {
        refused([&] { world.set_shape(shape, geometry); }, code, field);
    };
    const auto def_refused = [&](const ShapeDef& def, ErrorCode code, const char* field) {
        refused([&] { world.set_shape_def(shape, def); }, code, field);
    };
    const float nan = std::nanf("");
    for (const ShapeId stale : {gone, ShapeId{}}) {
        refused([&] { world.set_shape(stale, Box{}); }, ErrorCode::invalid_handle, "ShapeId");
        refused([&] { world.set_shape_def(stale, {}); }, ErrorCode::invalid_handle, "ShapeId");
    }
    geometry_refused(Plane{}, ErrorCode::wrong_state, "World::set_shape");
    geometry_refused(flat_mesh(2, 1.0f), ErrorCode::wrong_state, "World::set_shape");
    geometry_refused(Sphere{nan}, ErrorCode::invalid_value, "Sphere.radius");
    geometry_refused(Box{{1, -1, 1}}, ErrorCode::invalid_value, "Box.half_extents");
    def_refused({.position = {nan, 0, 0}}, ErrorCode::invalid_value, "ShapeDef.position");
    def_refused({.rotation = Quat(0, 0, 0, 0)}, ErrorCode::invalid_value, "ShapeDef.rotation");
    def_refused({.density = -1}, ErrorCode::invalid_value, "ShapeDef.density");
    def_refused({.density = 1e38f}, ErrorCode::invalid_value, "ShapeDef.density");
    def_refused({.surface_velocity = {1, 0, 0}}, ErrorCode::wrong_state, "ShapeDef.surface_velocity");
    EXPECT_EQ(world.state_hash(), before);
    EXPECT_EQ(world.body(body).mass(), mass.mass);
    EXPECT_TRUE(std::holds_alternative<Box>(world.shape(shape)));
}

TEST(ChangedShapes, ASnapshotBringsTheOldOneBack) {
    World world(without_sleep());
    world.add_shape(world.create_body({.type = BodyType::static_}), Plane{});
    const BodyId body = world.create_body({.position = {0, 1, 0}});
    const ShapeId shape = world.add_shape(body, Box{{0.5f, 0.5f, 0.5f}});
    run(world, dt, 60);
    const Snapshot before = world.save();
    run(world, dt, 60);
    const std::uint64_t as_it_was = world.state_hash();
    world.set_shape(shape, Sphere{0.3f});
    const Snapshot after = world.save();
    run(world, dt, 60);
    const std::uint64_t changed = world.state_hash();
    EXPECT_NEAR(world.body(body).position().y, 0.3, 1e-3);
    world.restore(before);
    run(world, dt, 60);
    EXPECT_EQ(world.state_hash(), as_it_was);
    ASSERT_TRUE(std::holds_alternative<Box>(world.shape(shape)));
    world.restore(after);
    run(world, dt, 60);
    EXPECT_EQ(world.state_hash(), changed);
    ASSERT_TRUE(std::holds_alternative<Sphere>(world.shape(shape)));
}

// The arguments of a call may refer to storage of the world that the same call reallocates.
TEST(ChangedShapes, CopiesOfWhatIsThereAreWhole) {
    World world;
    const BodyId body = world.create_body(), other = world.create_body({.position = {3, 0, 0}});
    ShapeDef def;
    def.position = {0.25f, 0.5f, 0.75f};
    const ShapeId first = world.add_shape(body, Box{{0.1f, 0.2f, 0.3f}}, def);
    JointDef joint;
    joint.body_a = body, joint.body_b = other;
    joint.frame_a.position = {1.5, 0, 0};
    joint.frame_b.position = {-1.5, 0, 0};
    joint.joint = BallJoint{};
    const JointId first_joint = world.create_joint(joint);
    const ForceFieldId first_field = world.add_force_field({.direction = {1, 2, 3}, .center = {4, 5, 6}});
    for (int i = 0; i < 100; ++i) {
        const ShapeId shape = world.add_shape(body, world.shape(first), world.shape_def(first));
        EXPECT_EQ(std::get<Box>(world.shape(shape)).half_extents, Vec3(0.1f, 0.2f, 0.3f)) << i;
        EXPECT_EQ(world.shape_def(shape).position, def.position) << i;
        const JointDef copy = world.joint_def(world.create_joint(world.joint_def(first_joint)));
        EXPECT_EQ(copy.body_a, body) << i;
        EXPECT_EQ(copy.frame_b.position, joint.frame_b.position) << i;
        const ForceField field = world.force_field(world.add_force_field(world.force_field(first_field)));
        EXPECT_EQ(field.direction, Vec3(1, 2, 3)) << i;
        EXPECT_EQ(field.center, Position(4, 5, 6)) << i;
    }
}

} // namespace
} // namespace cairn_test
