// Configurations that break physics engines: rows 33 to 40 of the list of faults.
#include "../api/test_world.h"
#include "../unit/allocation_count.h"
#include "measures.h"

#include <algorithm>
#include <ostream>
#include <vector>

namespace cairn::test {
namespace {

float fastest(const World& world) {
    float most = 0;
    for (const BodyId body : world.bodies()) most = std::max(most, speed_of(world, body));
    return most;
}

// A separation speed above `min_explosion` times the recovery speed, which limits the push-out, is an explosion.
constexpr float min_explosion = 2.0f;

TEST(Row33, TwoSpheresAtOneCenterPartWithoutExploding) {
    World world(weightless());
    const BodyId a = add_body(world, body_at({1.0, 2.0, 3.0}), Sphere{}),
                 b = add_body(world, body_at({1.0, 2.0, 3.0}), Sphere{});
    for (int i = 0; i < 240; ++i) {
        ASSERT_TRUE(stays_sane(world, 1));
        ASSERT_LE(fastest(world), min_explosion * world.settings().recovery_speed) << "step " << i;
    }
    EXPECT_GT(glm::length(world.body(b).position() - world.body(a).position()), 0.98);
}

TEST(Row34, HundredBoxesInOnePoseSurvive) {
    World world(weightless());
    for (int i = 0; i < 100; ++i) add_crate(world, {0.0, 0.0, 0.0});
    for (int i = 0; i < 240; ++i) {
        ASSERT_TRUE(stays_sane(world, 1));
        // Each of the hundred may be pushed by its neighbor at the recovery speed; an explosion is much faster.
        ASSERT_LE(fastest(world), 100 * world.settings().recovery_speed) << "step " << i;
    }
    const glm::dvec3 momentum = world.linear_momentum();
    EXPECT_LT(glm::length(momentum), 1e-3 * 100 * 1000.0 * world.settings().recovery_speed)
        << "momentum comes from nowhere";
}

TEST(Row34, HundredBoxesInOnePoseOnTheGroundComeApart) {
    World world;
    add_ground(world);
    for (int i = 0; i < 100; ++i) add_crate(world, {0.0, 0.5, 0.0});
    EXPECT_TRUE(stays_sane(world, 600));
    for (const BodyId body : world.bodies()) EXPECT_GT(world.body(body).position().y, -0.1);
    EXPECT_LT(world.statistics().max_penetration, 0.1);
}

TEST(Row35, SphereWithItsCenterInsideABoxGetsOut) {
    for (const bool fixed : {false, true})
        for (const Position& offset : {Position(0.0, 0.0, 0.0), Position(0.1, 0.2, 0.4), Position(-0.45, 0.0, 0.0)}) {
            World world(weightless());
            const BodyId box =
                add_body(world, body_at({0.0, 0.0, 0.0}, fixed ? BodyType::static_ : BodyType::dynamic), Box{});
            const BodyId ball = add_body(world, body_at(offset), Sphere{0.3f});
            for (int i = 0; i < 240; ++i) {
                ASSERT_TRUE(stays_sane(world, 1));
                ASSERT_LE(fastest(world), min_explosion * world.settings().recovery_speed) << "step " << i;
            }
            const Quat q = world.body(box).rotation();
            const Vec3 apart = glm::conjugate(q) * Vec3(world.body(ball).position() - world.body(box).position());
            const Vec3 outside = glm::max(glm::abs(apart) - Vec3(0.5f), Vec3(0.0f));
            EXPECT_GT(glm::length(outside), 0.28f) << "offset " << offset.x << " " << offset.y << " " << offset.z;
        }
}

// --- row 36

struct Overlap {
    const char* name;
    Shape first, second;
    bool first_fixed;
    Position apart; // position of second relative to first, with deep penetration
    Position way;   // direction in which they separate
};
std::ostream& operator<<(std::ostream& out, const Overlap& overlap) { return out << overlap.name; }

class Row36 : public testing::TestWithParam<std::tuple<Overlap, float>> {};

TEST_P(Row36, DeepOverlapPartsNoFasterThanTheCap) {
    const auto& [overlap, cap] = GetParam();
    WorldDef def = weightless();
    def.recovery_speed = cap;
    World world(def);
    const BodyId first = add_body(
        world, body_at({0.0, 0.0, 0.0}, overlap.first_fixed ? BodyType::static_ : BodyType::dynamic), overlap.first);
    const BodyId second = add_body(world, body_at(overlap.apart), overlap.second);
    const Position way = overlap.way;
    const auto distance = [&] { return glm::dot(world.body(second).position() - world.body(first).position(), way); };
    const double start = distance();
    double last = start;
    for (int i = 0; i < 120; ++i) {
        ASSERT_TRUE(stays_sane(world, 1));
        const double now = distance();
        // The sweeps over the contact points overshoot by some percent.
        ASSERT_LE(now - last, 1.05 * double(cap) * double(frame)) << "step " << i;
        last = now;
    }
    EXPECT_GT(last, start + 0.1) << "must come apart";
    // The speed of the push-out is not kept.
    const glm::vec3 parting = world.body(second).linear_velocity() - world.body(first).linear_velocity();
    EXPECT_LT(glm::length(parting), 0.1f * cap);
}

const Overlap overlaps[] = {
    {"spheres", Sphere{0.5f}, Sphere{0.5f}, false, {0.3, 0.0, 0.0}, {1.0, 0.0, 0.0}},
    {"boxes", Box{}, Box{}, false, {0.5, 0.1, 0.05}, {1.0, 0.0, 0.0}},
    {"sphere_in_box", Box{}, Sphere{0.3f}, false, {0.35, 0.0, 0.0}, {1.0, 0.0, 0.0}},
    {"box_in_fixed_box", Box{}, Box{}, true, {0.0, 0.4, 0.0}, {0.0, 1.0, 0.0}},
    {"sphere_in_fixed_box", Box{}, Sphere{0.3f}, true, {0.0, 0.3, 0.0}, {0.0, 1.0, 0.0}},
    {"sphere_in_plane", Plane{}, Sphere{0.5f}, true, {0.0, -0.4, 0.0}, {0.0, 1.0, 0.0}},
    {"box_in_plane", Plane{}, Box{}, true, {0.0, -0.4, 0.0}, {0.0, 1.0, 0.0}},
};
INSTANTIATE_TEST_SUITE_P(Pairs, Row36,
                         testing::Combine(testing::ValuesIn(overlaps), testing::Values(0.5f, 3.0f, 10.0f)),
                         [](const auto& info) {
                             return std::string(std::get<0>(info.param).name) + "_cap_" +
                                    std::to_string(int(10 * std::get<1>(info.param)));
                         });

// --- rows 37 and 38

TEST(Row37, FallingForEverCostsNoMemory) {
    World world;
    const BodyId ball = add_body(world, {}, Sphere{}), crate = add_crate(world, {3.0, 0.0, 0.0});
    run(world, 1000);
    const std::size_t memory = resident_memory(), allocations = allocation_count();
    for (int i = 0; i < 50000; ++i) world.step(frame);
    EXPECT_EQ(allocation_count() - allocations, 0u);
    EXPECT_LT(resident_memory(), memory + (1u << 20));
    EXPECT_TRUE(is_sane(world));
    for (const BodyId body : {ball, crate}) {
        EXPECT_NEAR(speed_of(world, body), world.settings().max_linear_speed, 0.01f);
        EXPECT_LT(world.body(body).position().y, -1e6);
        EXPECT_TRUE(world.body(body).is_awake());
    }
}

TEST(Row37, FallingOutOfAllBoundsStaysFinite) {
    WorldDef def;
    def.max_linear_speed = 1e12f;
    World world(def);
    add_body(world, body_at({0.0, -1e15, 0.0}), Sphere{});
    world.body(world.bodies()[0]).set_linear_velocity({0.0f, -1e12f, 0.0f});
    EXPECT_TRUE(stays_sane(world, 2000, 10.0f));
    EXPECT_NO_THROW(world.restore(world.save()));
}

TEST(Row38, StackOfMassRatioAHundredThousandSurvives) {
    World world;
    add_ground(world);
    BodyDef light = body_at({0.0, 0.5, 0.0}), heavy = body_at({0.0, 1.5, 0.0});
    light.mass = 1.0f;
    heavy.mass = 1e5f;
    const BodyId below = add_body(world, light, Box{}), above = add_body(world, heavy, Box{});
    const double energy = mechanical_energy(world) * (1 + 1e-6);
    for (int i = 0; i < 600; ++i) {
        ASSERT_TRUE(stays_sane(world, 1));
        // The light body may be squeezed out sideways, but its energy must not exceed that lost by the sinking heavy
        // body.
        ASSERT_LE(mechanical_energy(world), energy) << "step " << i;
        ASSERT_GT(world.body(above).position().y, 0.4);
        ASSERT_GT(world.body(below).position().y, -0.1);
    }
}

TEST(Row38, SteepTowerOfGrowingMassesSurvives) {
    World world;
    add_ground(world);
    for (int i = 0; i < 6; ++i) {
        BodyDef def = body_at({0.0, 0.5 + i, 0.0});
        def.mass = std::pow(10.0f, float(i));
        add_body(world, def, Box{});
    }
    EXPECT_TRUE(stays_sane(world, 600));
    EXPECT_LT(fastest(world), 20.0f);
    for (const BodyId body : world.bodies()) EXPECT_GT(world.body(body).position().y, -0.5);
}

// --- row 40

TEST(Row40, WhatCannotMoveMakesNoContacts) {
    World world;
    std::vector<BodyId> bodies;
    for (const BodyType type : {BodyType::static_, BodyType::static_, BodyType::kinematic, BodyType::kinematic}) {
        bodies.push_back(add_body(world, body_at({0.0, 0.0, 0.0}, type), Box{}));
        add_body(world, body_at({0.1, 0.0, 0.0}, type), Sphere{});
        add_body(world, body_at({0.0, 0.1, 0.0}, type), Plane{});
    }
    world.body(bodies[3]).set_linear_velocity({0.0f, 1.0f, 0.0f});
    for (int i = 0; i < 60; ++i) {
        ASSERT_TRUE(stays_sane(world, 1));
        ASSERT_TRUE(world.contacts().empty());
        ASSERT_TRUE(world.contact_begins().empty() && world.contact_hits().empty());
    }
    EXPECT_NEAR(world.body(bodies[3]).position().y, 1.0, 1e-5) << "a kinematic body goes through others";
    EXPECT_EQ(world.body(bodies[2]).position(), Position(0.0));
    EXPECT_EQ(world.body(bodies[0]).position(), Position(0.0));
}

} // namespace
} // namespace cairn::test
