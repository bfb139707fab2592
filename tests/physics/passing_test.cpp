// A body that slides on the ground past an obstacle, with a gap of 0.5 mm to 5 cm, is not disturbed. Contacts between
// the closest points, whose planes are infinite, deflected crates by 49 degrees, and bodies on a mesh, past another
// part of that mesh, by up to 73 degrees.
#include "starts.h"
#include "support.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <utility>

namespace cairn_test {
namespace {

constexpr float half = 0.2f; // m

enum class Obstacle { box, same_mesh, hull, cylinder, ball, free_box };
enum class Slider { ball, box, capsule, cylinder, hull, cone };

// The half width of a square along `side`, m, when rotated by `yaw`.
double reach_of_square(double yaw, const glm::dvec3& side) {
    return double(half) * (std::abs(side.x * std::cos(yaw) - side.z * std::sin(yaw)) +
                           std::abs(side.x * std::sin(yaw) + side.z * std::cos(yaw)));
}

struct Passing {
    std::mt19937 random;
    std::size_t turned = 0, missed = 0, passes = 0, hits = 0;
    double worst = 0;

    explicit Passing(std::uint32_t seed) : random(seed) {}
    double between(double low, double high) { return low + (high - low) * double(random()) / 4294967296.0; }

    // A floor of triangles with a pillar in the middle, as one mesh.
    static Mesh floor_with_pillar(double yaw) {
        std::vector<Vec3> vertices;
        std::vector<std::uint32_t> indices;
        const auto quad = [&](const std::array<Vec3, 4>& around) {
            const auto first = std::uint32_t(vertices.size());
            vertices.insert(vertices.end(), around.begin(), around.end());
            for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + i);
        };
        constexpr float tile = 3;
        for (int a = -15; a < 15; ++a)
            for (int b = -15; b < 15; ++b) {
                const float x = tile * float(a), z = tile * float(b);
                quad({Vec3{x, 0, z}, Vec3{x, 0, z + tile}, Vec3{x + tile, 0, z + tile}, Vec3{x + tile, 0, z}});
            }
        const Quat turn = glm::angleAxis(float(yaw), Vec3(0, 1, 0));
        for (int side = 0; side < 4; ++side) {
            const Quat to_side = turn * glm::angleAxis(1.57079633f * float(side), Vec3(0, 1, 0));
            quad({to_side * Vec3{-half, 0, half}, to_side * Vec3{half, 0, half}, to_side * Vec3{half, 2, half},
                  to_side * Vec3{-half, 2, half}});
        }
        return Mesh(vertices, indices);
    }

    void add_obstacle(World& world, Obstacle kind, double yaw) {
        const Material smooth = surface(0.0f);
        if (kind == Obstacle::same_mesh) {
            world.add_shape(world.create_body({.type = BodyType::static_}), floor_with_pillar(yaw),
                            ShapeDef{.material = smooth});
            return;
        }
        add_ground(world, smooth);
        BodyDef def;
        def.type = kind == Obstacle::free_box ? BodyType::dynamic : BodyType::static_;
        def.position.y = kind == Obstacle::free_box ? double(half) : 1.0;
        def.rotation = glm::angleAxis(float(yaw), Vec3(0, 1, 0));
        if (kind == Obstacle::ball) def.position.y = double(half);
        Shape shape = Box{{half, 1, half}};
        if (kind == Obstacle::hull) shape = Hull(box_corners({half, 1, half}));
        if (kind == Obstacle::cylinder) shape = Cylinder{1, half, {}};
        if (kind == Obstacle::ball) shape = Sphere{half};
        if (kind == Obstacle::free_box) shape = Box{{half, half, half}};
        add_body(world, shape, def, smooth);
    }

    // Slides a body in a random direction at 0.3 to 30 m/s past the obstacle, or, if `hits_it`, against it.
    void slide(Obstacle obstacle, Slider kind, bool hits_it) {
        const double yaw = between(0, 6.28), heading = between(0, 6.28), own_yaw = between(0, 6.28);
        const double speed = std::pow(10.0, between(-0.5, 1.5));
        const double air = hits_it ? -between(0.02, 0.1) : std::pow(10.0, between(-3.3, -1.3));
        const glm::dvec3 ahead(std::cos(heading), 0, std::sin(heading)), side(-ahead.z, 0, ahead.x);
        World world;
        add_obstacle(world, obstacle, yaw);
        const bool is_round = obstacle == Obstacle::cylinder || obstacle == Obstacle::ball;
        double reach = is_round ? double(half) : reach_of_square(yaw, side);
        BodyDef def;
        def.rotation = glm::angleAxis(float(own_yaw), Vec3(0, 1, 0));
        Shape shape = Sphere{half};
        double own_reach = double(half);
        if (kind == Slider::box) shape = Box{{half, half, half}};
        if (kind == Slider::hull) shape = Hull(box_corners({half, half, half}));
        if (kind == Slider::cylinder) shape = Cylinder{half, half, {}};
        if (kind == Slider::cone) shape = Cylinder{half, half, 0.05f};
        if (kind == Slider::box || kind == Slider::hull) own_reach = reach_of_square(own_yaw, side);
        if (kind == Slider::capsule) {
            shape = Capsule{half, half, {}};
            def.rotation = def.rotation * glm::angleAxis(1.57079633f, Vec3(0, 0, 1));
            own_reach += double(half) * std::abs(side.x * std::cos(own_yaw) - side.z * std::sin(own_yaw));
        }
        const double way = 1.0 + speed / 60 * between(0, 1);
        def.position = -way * ahead + (reach + own_reach + air) * side + glm::dvec3(0, half, 0);
        def.linear_velocity = Vec3(speed * ahead);
        const BodyId body = add_body(world, shape, def, surface(0.0f));
        run(world, 1.0f / 60, int((way + 1.5) / speed * 60) + 2);
        const glm::dvec3 velocity(world.body(body).linear_velocity());
        const double along = glm::dot(velocity, ahead), aside = glm::length(velocity - along * ahead);
        const bool is_changed = aside > 0.001 * speed || std::abs(along - speed) > 0.002 * speed;
        ++(hits_it ? hits : passes);
        if (hits_it) {
            missed += !is_changed;
            return;
        }
        turned += is_changed;
        worst = std::max(worst, std::atan2(aside, along) * 57.3);
    }
};

class PastAnObstacle : public testing::TestWithParam<Obstacle> {};

TEST_P(PastAnObstacle, WhatSlidesGoesStraightOnAndWhatHitsHits) {
    Passing passing(std::uint32_t(GetParam()) + 1);
    for (const Slider slider :
         {Slider::ball, Slider::box, Slider::capsule, Slider::cylinder, Slider::hull, Slider::cone})
        for (int i = 0; i < 120; ++i) passing.slide(GetParam(), slider, i % 4 == 3);
    std::printf("turned away %zu of %zu, at most by %.2f degrees; missed %zu of %zu\n", passing.turned, passing.passes,
                passing.worst, passing.missed, passing.hits);
    EXPECT_LE(passing.turned, 6u); // round past sharp ones: distances of their cores are approximate
    EXPECT_LT(passing.worst, 4.0);
    if (GetParam() != Obstacle::ball) { // over which lower or rounder bodies may pass
        EXPECT_EQ(passing.missed, 0u);
    }
}

INSTANTIATE_TEST_SUITE_P(Obstacles, PastAnObstacle,
                         testing::Values(Obstacle::box, Obstacle::same_mesh, Obstacle::hull, Obstacle::cylinder,
                                         Obstacle::ball, Obstacle::free_box));

// Passages between obstacles on both sides and below a roof, with a gap of 0.5 to 15 mm on each side.
enum class Slot { walls_and_roof, mesh, free_boxes, crate_that_comes };

struct SlotTrial {
    double heading, speed, air;
    Quat turn;
    World world;
    std::vector<BodyId> others;

    explicit SlotTrial(Passing& random)
        : heading(random.between(0, 6.28)), speed(std::pow(10.0, random.between(-0.3, 1.4))),
          air(std::pow(10.0, random.between(-3.3, -1.8))), turn(glm::angleAxis(float(heading), Vec3(0, 1, 0))) {}

    Position at(double x, double y, double z) const { return glm::dquat(turn) * Position(x, y, z); }
    BodyId add(const Shape& shape, const Position& place, BodyType type, double velocity = 0) {
        BodyDef def;
        def.type = type;
        def.position = place;
        def.rotation = turn;
        def.linear_velocity = Vec3(at(velocity, 0, 0));
        return add_body(world, shape, def, surface(0.0f));
    }
    // A tunnel 2 m long that begins at the origin.
    Mesh tunnel() const {
        std::vector<Vec3> vertices;
        std::vector<std::uint32_t> indices;
        const auto quad = [&](const std::array<Position, 4>& around) {
            const auto first = std::uint32_t(vertices.size());
            for (const Position& p : around) vertices.emplace_back(at(p.x, p.y, p.z));
            for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + i);
        };
        constexpr double tile = 3;
        for (int a = -2; a < 10; ++a)
            for (int b = -1; b < 1; ++b) {
                const double x = tile * a, z = tile * b;
                quad({Position{x, 0, z}, Position{x, 0, z + tile}, Position{x + tile, 0, z + tile},
                      Position{x + tile, 0, z}});
            }
        const double e = double(half) + air, roof = 2 * double(half) + air;
        for (int part = 0; part < 4; ++part) {
            const double x = 0.5 * part, end = x + 0.5;
            quad({Position{x, 0, e}, Position{x, 1, e}, Position{end, 1, e}, Position{end, 0, e}});
            quad({Position{end, 0, -e}, Position{end, 1, -e}, Position{x, 1, -e}, Position{x, 0, -e}});
            quad({Position{x, roof, -e}, Position{end, roof, -e}, Position{end, roof, e}, Position{x, roof, e}});
        }
        return Mesh(vertices, indices);
    }
    void build(Slot slot, const Shape& mover) {
        if (slot == Slot::mesh) {
            world.add_shape(world.create_body({.type = BodyType::static_}), tunnel(), {.material = surface(0.0f)});
            return;
        }
        add_ground(world, surface(0.0f));
        const double e = double(half) + air, roof = 2 * double(half) + air;
        if (slot == Slot::walls_and_roof) {
            for (const double side : {-1.0, 1.0})
                add(Box{{1, 0.5f, 0.1f}}, at(1, 0.5, side * (e + 0.1)), BodyType::static_);
            add(Box{{1, 0.1f, half}}, at(1, roof + 0.1, 0), BodyType::static_);
        }
        if (slot == Slot::free_boxes)
            for (int i = 0; i < 3; ++i)
                for (const double side : {-1.0, 1.0})
                    others.push_back(
                        add(Box{{half, half, half}}, at(0.41 * i, half, side * (e + double(half))), BodyType::dynamic));
        if (slot == Slot::crate_that_comes) add(mover, at(2, half, 2 * double(half) + air), BodyType::dynamic, -speed);
    }
    bool goes_straight_on(Slot slot, const Shape& mover, double start) {
        build(slot, mover);
        const double way = 1 + speed / 60 * start;
        const BodyId body = add(mover, at(-way, half, 0), BodyType::dynamic, speed);
        run(world, 1.0f / 60, int((way + 3) / speed * 60) + 2);
        bool is_changed = glm::length(glm::dvec3(world.body(body).linear_velocity()) - at(speed, 0, 0)) > 0.003 * speed;
        for (const BodyId other : others) {
            const Vec3 v = world.body(other).linear_velocity();
            is_changed = is_changed || std::hypot(v.x, v.z) > 0.003f * float(speed);
        }
        return !is_changed;
    }
};

// Of 160 bodies that reached a tunnel of boxes, 67 were stopped or thrown back at its mouth, and 143 at one of a mesh;
// 67 between free boxes, and 51 beside an oncoming crate.
TEST(Passing, WhatFitsIntoASlotSlidesIntoIt) {
    const Shape movers[] = {Sphere{half}, Box{{half, half, half}}, Cylinder{half, half, {}},
                            Hull(box_corners({half, half, half}))};
    for (const Slot slot : {Slot::walls_and_roof, Slot::mesh, Slot::free_boxes, Slot::crate_that_comes}) {
        Passing random(std::uint32_t(slot) + 1);
        int changed = 0;
        for (const Shape& mover : movers)
            for (int i = 0; i < 40; ++i)
                changed += !SlotTrial(random).goes_straight_on(slot, mover, random.between(0, 1));
        std::printf("changed %d of 160\n", changed);
        EXPECT_LE(changed, 1) << int(slot);
    }
}

// A car on four hinged wheels, whose motion the joints determine, passes a pillar, a post or a part of the mesh of the
// ground. Returns the angle of its deflection, degrees.
double angle_of_car(Obstacle obstacle, double speed, double air, double start) {
    constexpr double half_car = 0.8, wheel = 0.3; // m
    World world;
    Passing setting(1);
    setting.add_obstacle(world, obstacle, 0);
    const double z = -(double(half) + air + half_car), x = -2 - 0.2 * speed - speed / 60 * start;
    BodyDef def;
    def.position = {x, 0.65, z};
    def.linear_velocity = {float(speed), 0, 0};
    const BodyId chassis = add_body(world, Box{{1.0f, 0.25f, 0.7f}}, def, surface(0.6f));
    def.angular_velocity = {0, 0, -float(speed / wheel)};
    for (int i = 0; i < 4; ++i) {
        def.position = {x + (i & 1 ? 0.7 : -0.7), wheel, z + (i & 2 ? 0.5 : -0.5)};
        const BodyId body = add_body(world, Sphere{float(wheel)}, def, surface(0.6f));
        world.create_joint(world.joint_at(chassis, body, def.position, {0, 0, 1}, HingeJoint{}));
    }
    run(world, 1.0f / 60, int((2 - x) / speed * 60) + 2);
    const glm::dvec3 velocity(world.body(chassis).linear_velocity());
    return std::atan2(std::abs(velocity.z), velocity.x) * 57.3;
}

// At 10 and 30 m/s, with gaps of up to 3 cm, the pillar, separate or in the mesh, deflected every car, by up to 54
// degrees.
TEST(Passing, ACarGoesStraightOnPastAPillar) {
    for (const Obstacle obstacle : {Obstacle::box, Obstacle::ball, Obstacle::cylinder, Obstacle::same_mesh})
        for (const double speed : {3.0, 10.0, 30.0})
            for (const double air : {0.002, 0.01, 0.03, 0.1})
                for (int start = 0; start < 4; ++start)
                    EXPECT_LT(angle_of_car(obstacle, speed, air, 0.27 * start), 0.3)
                        << int(obstacle) << " " << speed << " " << air << " " << start;
}

// A door of 0.9 m x 2 m x 4 cm on a hinge swings through its frame without touching it. Returns the fraction of its
// angular velocity that it loses. `jamb`: on the side where the door opens, passed with the gap `air`.
double slowed_by_frame(const Shape& jamb, double half_jamb, double air, double speed, double angle, double heading) {
    constexpr double width = 0.9, height = 2, thickness = 0.04; // m
    const glm::dquat turn = glm::angleAxis(heading, glm::dvec3(0, 1, 0));
    World world;
    const auto add_wall = [&](const Shape& shape, glm::dvec3 position) {
        BodyDef def;
        def.type = BodyType::static_;
        def.position = turn * position;
        def.rotation = Quat(turn);
        return add_body(world, shape, def, surface(0.5f));
    };
    const BodyId floor = add_wall(Box{{3, 0.5f, 3}}, {0, -0.5 - air, 0});
    add_wall(Box{{float(width), 0.1f, 0.1f}}, {width / 2, height + air + 0.1, 0});
    add_wall(jamb, {std::hypot(width, thickness / 2) + air + half_jamb, height / 2, 0});
    BodyDef def;
    def.position = turn * glm::dvec3(width / 2 * std::cos(angle), height / 2, -width / 2 * std::sin(angle));
    def.rotation = glm::angleAxis(float(heading + angle), Vec3(0, 1, 0));
    def.angular_velocity = {0, -float(speed), 0};
    def.linear_velocity = Vec3(glm::cross(glm::dvec3(0, -speed, 0), glm::dvec3(def.position)));
    const BodyId door =
        add_body(world, Box{{float(width / 2), float(height / 2), float(thickness / 2)}}, def, surface(0.5f));
    world.create_joint(world.joint_at(floor, door, {0, 1, 0}, {0, 1, 0}, HingeJoint{}));
    run(world, 1.0f / 60, int((angle + 1.2) / speed * 60));
    return std::abs(-double(world.body(door).angular_velocity().y) - speed) / speed;
}

// At 5 rad/s and more, 21 of 90 doors were stopped when the center of a door was predicted to move along a straight
// line, which took its edge into the jamb. 4 of 600 were stopped when a jamb that the door did not touch was held by
// contact points that slide over the face of the door as if it were infinite.
TEST(Passing, ADoorSwingsThroughItsFrame) {
    Starts random(3);
    int slowed = 0;
    for (const auto& [jamb, half_jamb] : {std::pair<Shape, double>{Box{{0.05f, 1, 0.1f}}, 0.05},
                                          {Box{{0.05f, 1, 0.02f}}, 0.05},
                                          {Cylinder{1, 0.05f}, 0.05},
                                          {Sphere{0.05f}, 0.05}})
        for (int i = 0; i < 60; ++i) {
            const double air = std::pow(10, random.between(-3, -2)), speed = std::pow(10, random.between(-0.5, 1.2));
            const double angle = random.between(0.8, 1.5), heading = random.between(0, 6.28);
            slowed += slowed_by_frame(jamb, half_jamb, air, speed, angle, heading) > 0.01;
        }
    std::printf("slowed %d of 240\n", slowed);
    EXPECT_LE(slowed, 2);
}

} // namespace
} // namespace cairn_test
