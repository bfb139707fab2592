// A body that passes another at a distance has no contact with it, and a body that will collide has one in time.
#include "support.h"

#include <random>

namespace cairn_test {
namespace {

WorldDef weightless() {
    WorldDef settings = without_sleep();
    settings.gravity = {0, 0, 0};
    return settings;
}

// Expects a contact within `steps` steps, and no great penetration.
void expect_to_meet(World& world, int steps) {
    std::size_t contacts = 0;
    for (int i = 0; i < steps; ++i) {
        world.step(1.0f / 60);
        contacts = std::max(contacts, world.statistics().contacts);
        EXPECT_LT(world.statistics().max_penetration, 0.07) << i;
    }
    EXPECT_GT(contacts, 0u);
}

// Random directions, rotations, speeds and phases of the step. One body is at rest; the other passes it with the gap
// `air` between their bounding spheres, or hits it head-on.
TEST(NearMiss, WhatPassesByIsNotDeflectedAndWhatHitsIs) {
    const Shape shapes[] = {Sphere{0.2f}, Box{{0.2f, 0.1f, 0.15f}}, Capsule{0.15f, 0.1f}, Cylinder{0.15f, 0.1f}};
    const double reach[] = {0.2, 0.27, 0.25, 0.19};
    std::mt19937 random(1);
    const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    const auto direction = [&] { return glm::normalize(glm::dvec3(between(-1, 1), between(-1, 1), between(0.1, 1))); };
    for (int i = 0; i < 400; ++i) {
        const std::size_t kind = std::size_t(i) % 4;
        const bool hits = i % 8 >= 4;
        const double speed = 10 * std::pow(30, between(0, 1)), air = 0.02;
        const glm::dvec3 along = direction(), across = glm::normalize(glm::cross(along, direction()));
        const double start = 4 * reach[kind] + speed / 60 * between(1, 2);
        World world(weightless());
        BodyDef def;
        def.type = BodyType::static_;
        def.rotation = glm::angleAxis(float(between(0, 3)), Vec3(direction()));
        add_body(world, shapes[kind], def, surface(0.5f));
        def.type = BodyType::dynamic;
        def.rotation = glm::angleAxis(float(between(0, 3)), Vec3(direction()));
        def.position = (hits ? 0 : 2 * reach[kind] + air) * across - start * along;
        def.linear_velocity = Vec3(speed * along);
        const BodyId id = add_body(world, shapes[kind], def, surface(0.5f));
        run(world, 1.0f / 60, 2 + int((start + 4 * reach[kind]) / speed * 60));
        const double change = glm::length(world.body(id).linear_velocity() - def.linear_velocity) / speed;
        if (hits)
            EXPECT_GT(change, 0.3) << "kind " << kind << ", " << speed << " m/s";
        else
            EXPECT_LT(change, 1e-4) << "kind " << kind << ", " << speed << " m/s";
    }
}

// When the search for bodies ahead only began after the first step, the bodies penetrated by 5 cm in that step.
TEST(NearMiss, WhatIsThrownMeetsWhatIsThereInItsFirstStep) {
    for (int how = 0; how < 3; ++how) {
        World world(weightless());
        BodyDef def;
        def.type = BodyType::static_;
        add_body(world, Sphere{0.5f}, def, surface(0.5f));
        def.type = BodyType::dynamic;
        def.position = {0, 1.15, 0};
        if (how == 0) def.linear_velocity = {0, -12, 0};
        Body ball = world.body(add_body(world, Sphere{0.5f}, def, surface(0.5f)));
        if (how == 1) ball.set_linear_velocity({0, -12, 0});
        if (how == 2) ball.apply_impulse(ball.mass() * Vec3(0, -12, 0));
        for (int i = 0; i < 3; ++i) {
            world.step(1.0f / 60);
            EXPECT_LT(world.statistics().max_penetration, 1e-4) << how;
            EXPECT_GT(ball.position().y, 0.9999) << how;
        }
        EXPECT_LT(glm::length(ball.linear_velocity()), 1e-3) << how;
    }
}

TEST(NearMiss, WhatTurnsIntoSomethingIsSeen) {
    // A rod above a box: its end swings down at 15 m/s while its center moves up.
    World world(weightless());
    BodyDef def;
    def.type = BodyType::static_;
    def.position = {0, -1, 0};
    add_body(world, Box{{50, 1, 50}}, def, surface(0.5f));
    def.type = BodyType::dynamic;
    def.position = {0, 1.1, 0};
    def.rotation = glm::angleAxis(float(pi / 2), Vec3(0, 0, 1));
    def.linear_velocity = {0, 1, 0};
    def.angular_velocity = {0, 0, 15};
    const Body rod = world.body(add_body(world, Capsule{1.0f, 0.1f}, def, surface(0.5f)));
    double lowest = 10;
    for (int i = 0; i < 120; ++i) {
        world.step(1.0f / 60);
        const double end = std::fabs((rod.rotation() * Vec3(0, 1, 0)).y);
        lowest = std::min(lowest, rod.position().y - end - 0.1);
    }
    EXPECT_GT(lowest, -0.02);
    EXPECT_LT(lowest, 0.3);
}

// A rod rotates at 10 rad/s with its end 5 cm above a floor; the end covers 8 cm in a step. The search for contacts
// must include the region that bodies reach by rotation, not by translation alone.
TEST(NearMiss, WhatTurnsAtSomethingMeetsItInTheFirstStep) {
    for (const bool by_hand : {false, true}) {
        World world(weightless());
        BodyDef def;
        def.type = BodyType::static_;
        add_body(world, Box{{2, 0.5f, 2}}, def, surface(0.5f));
        def.type = BodyType::dynamic;
        def.position = {0, 0.6, 0};
        if (!by_hand) def.angular_velocity = {0, 0, 10};
        Body rod = world.body(add_body(world, Box{{0.5f, 0.05f, 0.05f}}, def, surface(0.5f)));
        if (by_hand) rod.set_angular_velocity({0, 0, 10});
        for (int i = 0; i < 3; ++i) {
            world.step(1.0f / 60);
            EXPECT_LT(world.statistics().max_penetration, 2e-3) << by_hand;
        }
        EXPECT_GT(rod.linear_velocity().y, 0.1f) << by_hand; // the floor has pushed it away
    }
}

// The separation of a pair is stored, and the pair is not tested again before it can have closed, whatever moves the
// bodies. Two rods lie side by side, 0.5 m apart and slanted, so that their bounds overlap from the beginning.
TEST(NearMiss, WhatWasFarApartIsMetHoweverItComesNear) {
    struct Approach {
        const char* name;
        BodyType type; // of the first rod; the second is dynamic
        void (*come_near)(World& world, Body first, Body other);
    };
    const Approach approaches[] = {
        {"put near", BodyType::static_,
         [](World&, Body, Body other) {
             other.set_position({0.06, 0.06, 0});
         }},
        {"static put near", BodyType::static_,
         [](World&, Body first, Body) {
             first.set_position({0.32, 0.32, 0});
         }},
        {"kinematic put near", BodyType::kinematic,
         [](World&, Body first, Body) {
             first.set_position({0.32, 0.32, 0});
         }},
        {"turned", BodyType::static_,
         [](World&, Body, Body other) { other.set_rotation(glm::angleAxis(float(3 * pi / 4), Vec3(0, 0, 1))); }},
        {"driven", BodyType::kinematic,
         [](World&, Body first, Body) {
             first.set_linear_velocity({5, 5, 0});
         }},
        {"thrown", BodyType::dynamic,
         [](World&, Body first, Body) {
             first.set_linear_velocity({5, 5, 0});
         }},
        {"hit", BodyType::dynamic,
         [](World&, Body, Body other) { other.apply_impulse(other.mass() * Vec3(-5, -5, 0)); }},
        {"turning", BodyType::static_,
         [](World&, Body, Body other) {
             other.set_angular_velocity({0, 0, 20});
         }},
        {"falling", BodyType::static_,
         [](World& world, Body, Body) {
             WorldDef settings = world.settings();
             settings.gravity = {-200, -200, 0};
             world.set_settings(settings);
         }},
    };
    const Shape shapes[] = {Capsule{0.5f, 0.05f}, Box{{0.05f, 0.5f, 0.05f}}, Cylinder{0.5f, 0.05f}};
    for (const Shape& shape : shapes)
        for (const Approach& approach : approaches) {
            SCOPED_TRACE(testing::Message() << approach.name << " " << shape.index());
            World world(weightless());
            BodyDef def;
            def.rotation = glm::angleAxis(float(pi / 4), Vec3(0, 0, 1));
            def.type = approach.type;
            const BodyId first = add_body(world, shape, def, surface(0.5f));
            def.type = BodyType::dynamic;
            def.position = {0.38, 0.38, 0};
            const BodyId other = add_body(world, shape, def, surface(0.5f));
            for (int i = 0; i < 5; ++i) world.step(1.0f / 60);
            EXPECT_EQ(world.statistics().contacts, 0u);
            EXPECT_EQ(world.statistics().candidate_pairs, 1u);
            EXPECT_EQ(world.statistics().tested_pairs, 0u);
            approach.come_near(world, world.body(first), world.body(other));
            expect_to_meet(world, 8);
        }
}

// A box moves along a valley, within its bounds, at 0.2 m per step, until something turns it toward one of the walls.
// Triangles are searched within the distance that the box covers in some steps, and not again before it has covered it.
TEST(NearMiss, WhatFliesOverAMeshIsLeftAloneUntilItCanMeetIt) {
    using Turn = void (*)(World & world, Body box, Body valley);
    const Turn turns[] = {
        [](World&, Body box, Body) {
            box.set_linear_velocity({-12, 0, 0});
        },
        [](World&, Body box, Body) {
            box.set_position({-5.55, 6, 0});
        },
        [](World&, Body, Body valley) {
            valley.set_position({5.55, 0, 0});
        },
        [](World& world, Body, Body) {
            WorldDef settings = world.settings();
            settings.gravity = {0, -200, 0};
            world.set_settings(settings);
        },
    };
    for (const Turn turn : turns) {
        World world(weightless());
        const Vec3 corners[] = {{-10, 10, -50}, {-10, 10, 50}, {0, 0, -50}, {0, 0, 50}, {10, 10, -50}, {10, 10, 50}};
        const std::uint32_t triangles[] = {0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4};
        BodyDef def;
        def.type = BodyType::static_;
        const BodyId valley = add_body(world, Mesh(corners, triangles), def, surface(0.5f));
        def.type = BodyType::dynamic;
        def.position = {0, 6, -20};
        def.linear_velocity = {0, 0, 12};
        const BodyId box = add_body(world, Box{{0.25f, 0.25f, 0.25f}}, def, surface(0.5f));
        std::size_t tested = 0;
        for (int i = 0; i < 100; ++i) {
            world.step(1.0f / 60);
            EXPECT_EQ(world.statistics().candidate_pairs, 1u);
            EXPECT_EQ(world.statistics().contacts, 0u);
            tested += world.statistics().tested_pairs;
        }
        EXPECT_LE(tested, 34u);
        turn(world, world.body(box), world.body(valley));
        expect_to_meet(world, 60);
    }
}

} // namespace
} // namespace cairn_test
