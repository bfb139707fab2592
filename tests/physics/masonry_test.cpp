// What stands by its shape alone: arches, and planks that overhang. How thick and how far is known exactly. (Heyman,
// "The safety of masonry buildings", 1969: an arch of half a circle stands from a thickness of 0.1075 of its middle
// radius.)
#include "support.h"

#include "validation/random_starts.h"

#include <algorithm>
#include <cmath>

namespace cairn_test {
namespace {

constexpr float dt = 1.0f / 60;

// A world that is turned as a start says, with a plane as its ground.
World turned_world(const RandomStart& start, const Material& material, int substeps = 0) {
    WorldDef def;
    def.gravity = Vec3(start.turned({0, -gravity, 0}));
    def.substeps = substeps;
    World world(def);
    BodyDef ground;
    ground.type = BodyType::static_;
    ground.position = start.place({0, 0, 0});
    ground.rotation = start.quat();
    add_body(world, Plane{}, ground, material);
    return world;
}

// How far a body went from where it was made, m.
struct Placed {
    BodyId body;
    Position at;
};
double farthest(World& world, const std::vector<Placed>& all) {
    double way = 0;
    for (const Placed& p : all) way = std::max(way, glm::length(world.body(p.body).position() - p.at));
    return way;
}
Placed place(World& world, const RandomStart& start, const Shape& shape, const glm::dvec3& at,
             const Material& material) {
    BodyDef def;
    def.position = start.place(at);
    def.rotation = start.quat();
    return {add_body(world, shape, def, material), def.position};
}

struct Arch {
    double radius, depth; // m; the radius is that of the middle
    int stones;
    float friction;
};

// Half a circle of wedges that stand on each other: how far one of them goes in five seconds, by the radius.
double settling(RandomStart& start, const Arch& arch, double thickness) {
    const Material stone = surface(arch.friction);
    World world = turned_world(start, stone, 128);
    std::vector<Placed> all;
    const double angle = pi / arch.stones, half = 0.5 * thickness * arch.radius;
    for (int i = 0; i < arch.stones; ++i) {
        const double middle = (i + 0.5) * angle;
        const glm::dvec3 center = arch.radius * glm::dvec3(std::cos(middle), std::sin(middle), 0);
        std::vector<Vec3> corners;
        for (const double a : {i * angle, (i + 1) * angle})
            for (const double r : {arch.radius - half, arch.radius + half})
                for (const double z : {-0.5 * arch.depth, 0.5 * arch.depth})
                    corners.push_back(Vec3(glm::dvec3(r * std::cos(a), r * std::sin(a), z) - center));
        all.push_back(place(world, start, Hull(corners), center, stone));
    }
    run(world, dt, 300);
    return farthest(world, all) / arch.radius;
}

// The stones touch, or are a rounding apart: those that fall alike were in flight, and fell through the first step.
TEST(Masonry, AnArchStandsAsThickAsTheorySays) {
    for (int i = 0; i < 12; ++i) {
        RandomStart start(std::uint32_t(40 + i));
        const double radius = 0.2 * std::pow(50.0, start.uniform(0, 1));
        const Arch arch{radius, radius * start.uniform(0.2, 1.5), int(start.uniform(9, 29)),
                        float(start.uniform(0.6, 1.2))};
        EXPECT_LT(settling(start, arch, 0.115), 0.005) << "of " << radius << " m, " << arch.stones << " stones";
        EXPECT_GT(settling(start, arch, 0.095), 0.5) << "of " << radius << " m, " << arch.stones << " stones";
    }
}

// Each plank is put as far over the edge of what is below it as all above it allow: by 1/2, 1/4, 1/6 and so on of its
// length. `part` of that: how far one of them goes in eight seconds, by the length of half a plank.
double sinking(RandomStart& start, int planks, double half_length, double part) {
    const Material wood = surface(0.6f);
    World world = turned_world(start, wood);
    const double half_height = 0.08 * half_length, table = 1.2 * planks * half_length;
    std::vector<Placed> all;
    BodyDef def;
    def.type = BodyType::static_;
    def.position = start.place({-half_length, 0.5 * table, 0});
    def.rotation = start.quat();
    add_body(world, Box{Vec3(half_length, 0.5 * table, half_length)}, def, wood);
    double edge = 0;
    for (int k = 0; k < planks; ++k) {
        edge += part * half_length / (planks - k);
        all.push_back(place(world, start, Box{Vec3(half_length, half_height, 0.5 * half_length)},
                            {edge - half_length, table + (2 * k + 1) * half_height, 0}, wood));
    }
    run(world, dt, 480);
    return farthest(world, all) / half_length;
}
TEST(Masonry, PlanksOverhangAsFarAsTheorySays) {
    for (int i = 0; i < 12; ++i) {
        RandomStart start(std::uint32_t(70 + i));
        const double half_length = start.uniform(1, 4);
        const int planks = int(start.uniform(3, 9));
        EXPECT_LT(sinking(start, planks, half_length, 0.98), 0.02) << planks << " of " << half_length << " m";
        EXPECT_GT(sinking(start, planks, half_length, 1.02), 0.2) << planks << " of " << half_length << " m";
    }
}

// Five things, one on another, with gaps from none to half of what counts as touching.
TEST(Masonry, WhatIsMadeTouchingIsHeldFromTheFirstStep) {
    for (int i = 0; i < 60; ++i) {
        RandomStart start(std::uint32_t(90 + i));
        World world = turned_world(start, {});
        const double gap = i % 4 == 0 ? 0 : std::pow(10.0, start.uniform(-8, -4.3));
        const Shape shape = i % 3 == 0   ? Shape(Box{{0.1f, 0.1f, 0.1f}})
                            : i % 3 == 1 ? Shape(Hull(box_corners({0.1f, 0.1f, 0.1f})))
                                         : Shape(Cylinder{.half_height = 0.1f, .radius = 0.1f});
        std::vector<Placed> all;
        for (int k = 0; k < 5; ++k) all.push_back(place(world, start, shape, {0, 0.1 + gap + k * (0.2 + gap), 0}, {}));
        world.step(dt);
        for (const Placed& p : all)
            EXPECT_LT(glm::length(world.body(p.body).linear_velocity()), 0.008) << i << ", " << gap << " m apart";
    }
}

} // namespace
} // namespace cairn_test
