// More everyday situations with known outcomes: ladders, steps, pins, cradles, cars, books, wheelbarrows.
#include "starts.h"
#include "support.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace cairn_test {
namespace {

constexpr double gravity = double(9.81f);
const glm::dvec3 x_axis(1, 0, 0), y_axis(0, 1, 0), z_axis(0, 0, 1);

glm::dquat heading_of(Starts& starts) { return glm::angleAxis(starts.between(0, 2 * pi), y_axis); }

double upright(const World& world, BodyId body) { return (glm::dquat(world.body(body).rotation()) * y_axis).y; }

// A material whose friction applies even if the other material has a higher one (combined by the minimum).
Material at_most(double friction) {
    Material material = surface(float(friction));
    material.friction_combine = CombineRule::minimum;
    return material;
}

BodyId add_plane(World& world, const glm::dvec3& normal, const Material& material) {
    BodyDef def;
    def.type = BodyType::static_;
    return add_body(world, Plane{Vec3(normal), {1, 0, 0}, {}}, def, material);
}

BodyId add_fixed(World& world, const Shape& shape, const glm::dvec3& position, const glm::dquat& rotation,
                 const Material& material) {
    BodyDef def;
    def.type = BodyType::static_;
    def.position = position, def.rotation = Quat(rotation);
    return add_body(world, shape, def, material);
}

// With friction m on the ground and w at the wall, a ladder stands as long as tan(angle) >= (1 - m w) / (2 m).
TEST(EverydayMore, ALadderSlipsWhereFrictionDoesNotHoldIt) {
    Starts starts(21);
    for (int i = 0; i < 48; ++i) {
        World world;
        const glm::dquat yaw = heading_of(starts);
        const double below = starts.between(0.2, 0.8), behind = i % 3 == 0 ? 0 : starts.between(0.1, 0.5);
        const bool is_too_flat = i % 2 == 0;
        const double angle = std::atan((1 - below * behind) / (2 * below) * (is_too_flat ? 0.95 : 1.05));
        add_plane(world, y_axis, at_most(below));
        add_plane(world, yaw * -x_axis, at_most(behind));
        const double half = starts.between(1, 3), r = 0.01, c = std::cos(angle), s = std::sin(angle);
        const bool is_round = i % 4 < 2; // a box, in contrast, touches with its edges
        BodyDef def;
        def.position = yaw * glm::dvec3(-half * c - r * (is_round ? 1 : s), half * s + r * (is_round ? 1 : c), 0);
        def.rotation = Quat(yaw * glm::angleAxis(angle - pi / 2, z_axis));
        const Shape shape =
            is_round ? Shape(Capsule{float(half), float(r)}) : Shape(Box{{float(r), float(half), 0.2f}});
        const Body ladder = world.body(add_body(world, shape, def, at_most(5)));
        run(world, 1.0f / 60, 120);
        const double moved = glm::length(ladder.center_of_mass() - def.position);
        if (is_too_flat)
            EXPECT_GT(moved, 0.1) << i;
        else
            EXPECT_LT(moved, 0.004) << i;
    }
}

// A stick that slides down a wall without friction leaves the wall where the sine of its angle is 2/3 of its initial
// value, and keeps the horizontal speed that it has there.
TEST(EverydayMore, AStickThatSlidesDownLeavesTheWall) {
    Starts starts(22);
    for (const int hertz : {60, 240})
        for (int i = 0; i < 24; ++i) {
            World world;
            const glm::dquat yaw = heading_of(starts);
            const double angle = starts.between(0.8, 1.4), half = starts.between(0.3, 1.5), r = 0.005;
            add_plane(world, y_axis, surface(0));
            add_plane(world, yaw * -x_axis, surface(0));
            BodyDef def;
            def.position = yaw * glm::dvec3(-half * std::cos(angle) - r, half * std::sin(angle) + r, 0);
            def.rotation = Quat(yaw * glm::angleAxis(angle - pi / 2, z_axis));
            const Body stick = world.body(add_body(world, Capsule{float(half), float(r)}, def, surface(0)));
            const double square_radius = double(stick.mass_properties().inertia_diagonal.x) / double(stick.mass());
            const double sine = 2 * std::sin(angle) / 3;
            const double rate =
                std::sqrt(2 * gravity * half * (std::sin(angle) - sine) / (half * half + square_radius));
            const auto height = [&] { return std::abs((glm::dquat(stick.rotation()) * y_axis).y); };
            for (int k = 0; k < 5 * hertz && height() > 0.4; ++k) world.step(1.0f / float(hertz));
            const double speed = -glm::dot(glm::dvec3(stick.linear_velocity()), yaw * x_axis);
            EXPECT_NEAR(speed / (half * rate * sine), 1, hertz == 60 ? 0.009 : 0.0006) << i;
        }
}

// A body that rolls against a step conserves its angular momentum about the edge, and climbs the step if the remaining
// energy suffices.
TEST(EverydayMore, WhatRollsIntoAStepClimbsItFromTheRightSpeedOn) {
    Starts starts(23);
    for (int i = 0; i < 96; ++i) {
        World world;
        const bool is_ball = i % 4 < 2, climbs = i % 2 == 1;
        const glm::dquat yaw = heading_of(starts);
        const double r = starts.between(0.1, 0.5), height = r * starts.between(0.1, 0.4), k = is_ball ? 0.4 : 0.5;
        const double kept = (1 + k - height / r) / (1 + k);
        const double speed = (climbs ? 1.04 : 0.96) * std::sqrt(2 * gravity * height / (1 + k)) / kept;
        add_ground(world, surface(3));
        add_fixed(world, Box{{2, float(height / 2), 3}}, yaw * glm::dvec3(2, height / 2, 0), yaw, surface(3));
        BodyDef def;
        const double edge = -std::sqrt(r * r - (r - height) * (r - height));
        def.position = yaw * glm::dvec3(edge - starts.between(0.3, 0.6), r, 0);
        def.rotation = Quat(is_ball ? yaw : yaw * glm::angleAxis(pi / 2, x_axis));
        def.linear_velocity = Vec3(yaw * glm::dvec3(speed, 0, 0));
        def.angular_velocity = Vec3(yaw * glm::dvec3(0, 0, -speed / r));
        const Shape shape =
            is_ball ? Shape(Sphere{float(r)}) : Shape(Cylinder{float(starts.between(0.05, 0.3)), float(r)});
        const Body body = world.body(add_body(world, shape, def, surface(3)));
        double farthest = -10;
        for (int n = 0; n < 240 && farthest < 0.2 * r; ++n) {
            world.step(1.0f / 60);
            farthest = std::max(farthest, glm::dot(body.position(), yaw * x_axis));
        }
        EXPECT_EQ(farthest >= 0.2 * r, climbs) << i;
    }
}

// Pins that nothing has touched stay where they are, whatever moves beside them.
TEST(EverydayMore, PinsThatAreNotHitStandStill) {
    Starts starts(24);
    int untouched = 0;
    for (int i = 0; i < 24; ++i) {
        World world;
        const glm::dquat yaw = heading_of(starts);
        add_ground(world, surface(0.2f));
        std::vector<BodyId> pins;
        BodyDef def;
        for (int row = 0; row < 4; ++row)
            for (int k = 0; k <= row; ++k) {
                def.mass = 1.55f;
                def.position = yaw * glm::dvec3(row * 0.264, 0.19, (k - row * 0.5) * 0.305);
                pins.push_back(add_body(world, Cylinder{0.19f, 0.028f}, def, surface(0.3f, 0.5f)));
            }
        run(world, 1.0f / 60, 18);
        std::vector<Position> before;
        for (const BodyId pin : pins) before.push_back(world.body(pin).position());
        const double speed = starts.between(4, 9);
        def.mass = 6.5f;
        def.position = yaw * glm::dvec3(-1 - starts.between(0, 0.2), 0.108, starts.between(-0.3, 0.3));
        def.linear_velocity = Vec3(yaw * glm::dvec3(speed, 0, 0));
        def.angular_velocity = Vec3(yaw * glm::dvec3(0, 0, -speed / 0.108));
        add_body(world, Sphere{0.108f}, def, surface(0.1f, 0.3f));
        std::vector<bool> is_hit(pins.size());
        for (int k = 0; k < 180; ++k) {
            world.step(1.0f / 60);
            for (const Contact& contact : world.contacts())
                for (std::size_t n = 0; n < pins.size(); ++n) {
                    const bool is_a = contact.body_a == pins[n];
                    if (!is_a && contact.body_b != pins[n]) continue;
                    if (world.body(is_a ? contact.body_b : contact.body_a).type() == BodyType::dynamic)
                        is_hit[n] = true;
                }
        }
        for (std::size_t n = 0; n < pins.size(); ++n) {
            if (is_hit[n]) continue;
            ++untouched;
            EXPECT_LT(glm::length(world.body(pins[n]).position() - before[n]), 5e-4) << i;
            EXPECT_GT(upright(world, pins[n]), 0.9999) << i;
        }
    }
    EXPECT_GT(untouched, 60);
}

// Newton's cradle of five balls, each on two strings: the last ball rises to the height from which the first was
// released, the others stay at rest, and the motion continues.
TEST(EverydayMore, ACradleOnStringsSwings) {
    Starts starts(25);
    for (int i = 0; i < 24; ++i) {
        World world;
        const glm::dquat yaw = heading_of(starts);
        const double length = starts.between(0.4, 0.8), angle = starts.between(0.2, 0.7), r = 0.05;
        const double apart = 2 * r + (i % 2 == 0 ? 1e-4 : 0), drop = length * (1 - std::cos(angle));
        std::vector<BodyId> balls;
        for (int k = 0; k < 5; ++k) {
            const glm::dvec3 low((k - 2) * apart, 0, 0);
            BodyDef def;
            def.mass = 0.5f;
            def.position = yaw * (k > 0 ? low : low + glm::dvec3(-length * std::sin(angle), drop, 0));
            balls.push_back(add_body(world, Sphere{float(r)}, def, surface(0, 1)));
            for (const double side : {-0.3, 0.3}) {
                JointDef string;
                string.body_b = balls.back();
                string.frame_a.position = yaw * (low + glm::dvec3(0, length, side));
                DistanceJoint distance;
                distance.distance.limits = JointRange{0, float(std::hypot(length, side))};
                string.joint = distance;
                world.create_joint(string);
            }
        }
        const double period = 2 * pi * std::sqrt(length / gravity) * (1 + angle * angle / 16);
        const double before = world.kinetic_energy() + world.potential_energy();
        run(world, 1.0f / 60, int(std::lround(30 * period)));
        EXPECT_NEAR(world.body(balls[4]).position().y / drop, 1, 0.003) << i;
        for (int k = 0; k < 4; ++k)
            EXPECT_LT(glm::length(world.body(balls[std::size_t(k)]).linear_velocity()), 0.004f) << i;
        run(world, 1.0f / 60, int(std::lround(120 * period)));
        EXPECT_NEAR((world.kinetic_energy() + world.potential_energy()) / before, 1, 0.005) << i;
    }
}

enum class Road { mesh, field };

// Adds a flat road of triangles with the given spacing, m.
void add_road(World& world, Road road, double spacing, const glm::dquat& yaw) {
    const int columns = int(240 / spacing), rows = int(30 / spacing) + 2;
    const std::vector<float> heights(std::size_t(columns) * std::size_t(rows));
    if (road == Road::field) {
        const HeightField field(columns, rows, {float(spacing), float(spacing)}, heights);
        add_fixed(world, field, {0, 0, 0}, yaw, surface(1));
        return;
    }
    std::vector<Vec3> corners;
    std::vector<std::uint32_t> indices;
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c)
            corners.push_back({float((c - 0.5 * columns) * spacing), 0, float((r - 0.5 * rows) * spacing)});
    for (int r = 0; r + 1 < rows; ++r)
        for (int c = 0; c + 1 < columns; ++c)
            for (const int k : {0, columns, columns + 1, 0, columns + 1, 1})
                indices.push_back(std::uint32_t(r * columns + c + k));
    add_fixed(world, Mesh(corners, indices), {0, 0, 0}, yaw, surface(1));
}

// A car with driven wheels at 10 to 30 m/s is not disturbed by the triangles of a flat road: it neither hops nor yaws.
TEST(EverydayMore, ACarDoesNotHopOnAFlatRoadOfTriangles) {
    Starts starts(26);
    for (int i = 0; i < 24; ++i) {
        World world;
        const glm::dquat yaw = heading_of(starts);
        add_road(world, i % 2 == 0 ? Road::mesh : Road::field, starts.between(0.8, 3),
                 yaw * glm::angleAxis(starts.between(-0.05, 0.05), y_axis));
        const double speed = starts.between(10, 30), r = 0.33;
        BodyDef def;
        def.mass = 1000;
        def.position = yaw * glm::dvec3(0, 0.9, 0);
        def.rotation = Quat(yaw);
        def.linear_velocity = Vec3(yaw * glm::dvec3(speed, 0, 0));
        const BodyId car = add_body(world, Box{{2, 0.4f, 0.8f}}, def, surface(0.5f));
        for (const double x : {-1.3, 1.3})
            for (const double z : {-0.9, 0.9}) {
                def.mass = 20;
                def.position = yaw * glm::dvec3(x, r, z);
                def.rotation = Quat(yaw * glm::angleAxis(pi / 2, x_axis));
                def.angular_velocity = Vec3(yaw * glm::dvec3(0, 0, -speed / r));
                const Shape shape = i % 3 == 0 ? Shape(Sphere{float(r)}) : Shape(Cylinder{0.1f, float(r)});
                const BodyId wheel = add_body(world, shape, def, surface(1));
                HingeJoint hinge;
                hinge.angle.motor = JointMotor{};
                hinge.angle.motor->velocity = float(-speed / r);
                hinge.angle.motor->max_force = 300;
                world.create_joint(world.joint_at(car, wheel, def.position, Vec3(yaw * z_axis), hinge));
            }
        run(world, 1.0f / 60, 18);
        const Body body = world.body(car);
        const double height = body.position().y;
        double hop = 0;
        for (int k = 0; k < int(60 * 60 / speed); ++k) {
            world.step(1.0f / 60);
            hop = std::max(hop, std::abs(body.position().y - height));
        }
        EXPECT_LT(hop, 0.002) << i;
        EXPECT_NEAR(glm::dot(glm::dvec3(body.linear_velocity()), yaw * x_axis) / speed, 1, 5e-4) << i;
        EXPECT_LT(std::abs(glm::dot(body.position(), yaw * z_axis)), 0.1) << i;
    }
}

// A book in a pile of six, when pulled, moves together with all books above it once the pull exceeds the friction below
// it.
TEST(EverydayMore, ABookThatIsPulledTakesThoseAboveAlong) {
    Starts starts(27);
    for (int i = 0; i < 48; ++i) {
        World world;
        const double friction = starts.between(0.2, 0.5);
        const glm::dquat yaw = heading_of(starts);
        add_ground(world, surface(float(friction)));
        std::vector<BodyId> books;
        BodyDef def;
        def.mass = float(starts.between(0.3, 2));
        for (int k = 0; k < 6; ++k) {
            def.position = {0, 0.015 + 0.03 * k, 0};
            def.rotation = Quat(yaw * glm::angleAxis(starts.between(-0.1, 0.1), y_axis));
            books.push_back(add_body(world, Box{{0.12f, 0.015f, 0.09f}}, def, surface(float(friction))));
        }
        run(world, 1.0f / 60, 30);
        const int pulled = int(starts.between(0, 5.99));
        const bool is_enough = i % 2 == 1;
        Body book = world.body(books[std::size_t(pulled)]);
        const Position before = book.position();
        const double force = (is_enough ? 1.03 : 0.97) * friction * gravity * double(*def.mass) * (6 - pulled);
        for (int k = 0; k < 60; ++k) {
            book.add_force(Vec3(force * (yaw * x_axis)));
            world.step(1.0f / 60);
        }
        const double moved = glm::length(book.position() - before);
        EXPECT_EQ(moved > 0.005, is_enough) << i << ": " << moved;
    }
}

// A plank with a wheel at one end and a foot near the other is lifted at its handle from the force on that the lever
// law gives.
TEST(EverydayMore, AWheelbarrowIsLiftedByTheForceOfTheLever) {
    Starts starts(28);
    for (int i = 0; i < 48; ++i) {
        World world;
        const glm::dquat yaw = heading_of(starts);
        add_ground(world, surface(0.8f));
        const BodyId barrow = [&] {
            BodyDef def;
            def.rotation = Quat(yaw);
            return world.create_body(def);
        }();
        const auto add_part = [&](const Vec3& middle, const Vec3& half) {
            ShapeDef part;
            part.position = middle, part.density = 300, part.material = surface(0.6f);
            world.add_shape(barrow, Box{half}, part);
        };
        add_part({0.8f, 0.45f, 0}, {0.9f, 0.03f, 0.3f});
        add_part({1.1f, 0.21f, 0}, {0.03f, 0.21f, 0.25f});
        BodyDef def;
        def.mass = 4;
        def.position = yaw * glm::dvec3(0, 0.2, 0);
        def.rotation = Quat(yaw * glm::angleAxis(pi / 2, x_axis));
        const BodyId wheel = add_body(world, Cylinder{0.05f, 0.2f}, def, surface(0.8f));
        world.create_joint(world.joint_at(barrow, wheel, def.position, Vec3(yaw * z_axis), HingeJoint{}));
        def.mass = float(starts.between(20, 100));
        def.position = yaw * glm::dvec3(starts.between(0.4, 0.8), 0.58, 0);
        def.rotation = Quat(yaw);
        const BodyId load = add_body(world, Box{{0.2f, 0.1f, 0.2f}}, def, surface(0.6f));
        run(world, 1.0f / 60, 60);
        const auto moment = [&](BodyId id) {
            const glm::dvec3 arm = world.body(id).center_of_mass() - world.body(wheel).center_of_mass();
            return double(world.body(id).mass()) * gravity * glm::dot(arm, yaw * x_axis);
        };
        const bool is_enough = i % 2 == 1;
        const double force = (is_enough ? 1.05 : 0.95) * (moment(barrow) + moment(load)) / 1.7;
        Body body = world.body(barrow);
        for (int k = 0; k < 30; ++k) {
            const glm::dvec3 handle = glm::dquat(body.rotation()) * glm::dvec3(1.7, 0.45, 0);
            body.add_force_at(Vec3(force * y_axis), body.position() + handle);
            world.step(1.0f / 60);
        }
        EXPECT_EQ((glm::dquat(body.rotation()) * x_axis).y > 0.01, is_enough) << i;
    }
}

} // namespace
} // namespace cairn_test
