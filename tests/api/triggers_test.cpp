// Triggers, collision filters and surface velocities.
#include "test_world.h"

namespace cairn::test {
namespace {

ShapeDef trigger() {
    ShapeDef def;
    def.is_trigger = true;
    return def;
}

TEST(Triggers, BallThatFallsThroughEntersAndLeavesOnce) {
    World world;
    const BodyId zone = add_body(world, body_at({0, 0, 0}, BodyType::static_), Box{{2, 1, 2}}, trigger());
    const BodyId ball = add_body(world, body_at({0, 5, 0}), Sphere{});
    int entered = -1, left = -1;
    for (int i = 0; i < 180; ++i) {
        world.step(frame);
        for (const TriggerEvent& event : world.trigger_events()) {
            EXPECT_EQ(event.trigger_body, zone);
            EXPECT_EQ(event.other_body, ball);
            EXPECT_EQ(event.trigger, world.body(zone).shapes()[0]);
            EXPECT_EQ(event.other, world.body(ball).shapes()[0]);
            (event.inside ? entered : left) = i;
        }
        EXPECT_TRUE(world.contacts().empty());
        EXPECT_TRUE(world.contact_begins().empty());
    }
    // The ball touches the zone at y = 1.5 and leaves it at y = -1.5: t = sqrt(2 h / g).
    EXPECT_NEAR((entered + 1) * frame, std::sqrt(2 * 3.5 / 9.81), 2 * frame);
    EXPECT_NEAR((left + 1) * frame, std::sqrt(2 * 6.5 / 9.81), 2 * frame);
    EXPECT_NEAR(world.body(ball).linear_velocity().y, -9.81f * 3, 0.01f) << "nothing has slowed it";
}

TEST(Triggers, RemovingWhatIsInsideLeaves) {
    World world(weightless());
    add_body(world, body_at({0, 0, 0}, BodyType::static_), Box{{2, 1, 2}}, trigger());
    const BodyId ball = add_body(world, body_at({0, 0, 0}), Sphere{});
    world.step(frame);
    ASSERT_EQ(world.trigger_events().size(), 1u);
    EXPECT_TRUE(world.trigger_events()[0].inside);
    world.destroy_body(ball);
    world.step(frame);
    ASSERT_EQ(world.trigger_events().size(), 1u);
    EXPECT_FALSE(world.trigger_events()[0].inside);
    EXPECT_FALSE(world.is_valid(world.trigger_events()[0].other_body));
}

TEST(Triggers, EveryShapeCanBeOneAndBeSeenByOne) {
    const std::vector<Vec3> points = {{-1, -1, -1}, {1, -1, -1}, {0, 1, 0}, {0, -1, 1}};
    const std::vector<std::uint32_t> triangle = {0, 3, 1};
    const std::vector<Shape> zones = {Sphere{1},
                                      Box{{1, 1, 1}},
                                      Plane{},
                                      Capsule{1, 1, {}},
                                      Cylinder{1, 1, {}},
                                      Hull(points),
                                      Mesh(points, triangle),
                                      HeightField(2, 2, {2, 2}, std::vector<float>(4, 0.0f))};
    const std::vector<Shape> visitors = {Sphere{0.5f}, Box{}, Capsule{0.3f, 0.3f, {}}, Cylinder{0.4f, 0.3f, {}},
                                         Hull(points)};
    for (const Shape& zone : zones)
        for (const Shape& visitor : visitors) {
            World world(weightless());
            const double height = zone.index() >= 6 ? (zone.index() == 6 ? -0.95 : 0.05) : 0;
            add_body(world, body_at({0, 0, 0}, BodyType::static_), zone, trigger());
            add_body(world, body_at({0, height, 0}), visitor);
            world.step(frame);
            ASSERT_EQ(world.trigger_events().size(), 1u) << zone.index() << " and " << visitor.index();
            EXPECT_TRUE(world.trigger_events()[0].inside);
            for (int i = 0; i < 5; ++i) {
                world.step(frame);
                EXPECT_TRUE(world.trigger_events().empty());
            }
        }
}

TEST(Filters, ShapesMeetOnlyIfBothWant) {
    const auto lands = [](CollisionFilter ground, CollisionFilter ball) {
        World world;
        ShapeDef def;
        def.filter = ground;
        add_body(world, body_at({0, -1, 0}, BodyType::static_), Box{{5, 1, 5}}, def);
        def.filter = ball;
        const BodyId id = add_body(world, body_at({0, 1, 0}), Sphere{}, def);
        run(world, 120);
        return world.body(id).position().y > 0;
    };
    EXPECT_TRUE(lands({}, {}));
    EXPECT_TRUE(lands({2, 4}, {4, 2}));
    EXPECT_FALSE(lands({2, 1}, {4, 2})) << "the ground does not want layer 4";
    EXPECT_FALSE(lands({2, 4}, {4, 1})) << "the ball does not want layer 2";
    EXPECT_FALSE(lands({0, ~0ull}, {}));
    EXPECT_TRUE(lands({6, ~0ull}, {1, 4})) << "one layer in common is enough";
}

TEST(Filters, ChangingOneTakesEffectAtTheNextStep) {
    World world;
    const BodyId ground = add_body(world, body_at({0, -1, 0}, BodyType::static_), Box{{5, 1, 5}});
    const BodyId ball = add_body(world, body_at({0, 0.5, 0}), Sphere{});
    run(world, 200);
    EXPECT_FALSE(world.body(ball).is_awake());
    world.set_filter(world.body(ground).shapes()[0], {2, 2});
    run(world, 60);
    EXPECT_LT(world.body(ball).position().y, -1);
    EXPECT_EQ(world.contact_ends().size(), 0u);
}

TEST(Conveyors, BeltCarriesWhatLiesOnItAndNothingElse) {
    for (const bool is_mesh : {false, true}) {
        World world;
        ShapeDef def;
        def.surface_velocity = {2, 0, 0};
        const std::vector<Vec3> square = {{-50, 0, -6}, {50, 0, -6}, {-50, 0, 6}, {50, 0, 6}};
        const std::vector<std::uint32_t> triangles = {0, 2, 3, 0, 3, 1};
        const Shape belt = is_mesh ? Shape(Mesh(square, triangles)) : Shape(Box{{50, 1, 6}});
        const BodyId base = add_body(world, body_at({0, is_mesh ? 0.0 : -1.0, 0}, BodyType::static_), belt, def);
        const BodyId crate = add_crate(world, {0, 0.5, 0});
        run(world, 120);
        EXPECT_NEAR(world.body(crate).linear_velocity().x, 2, 0.01f);
        EXPECT_NEAR(world.body(crate).position().y, 0.5, 0.001);
        // Friction accelerates the crate with 0.6 g: after 2 s it has moved by 2 t - v^2 / (2 a).
        EXPECT_NEAR(world.body(crate).position().x, 4 - 4 / (2 * 0.6 * 9.81), 0.05);
        EXPECT_EQ(world.body(base).position().x, 0);
        world.set_surface_velocity(world.body(base).shapes()[0], {0, 0, -1});
        run(world, 120);
        EXPECT_NEAR(world.body(crate).linear_velocity().x, 0, 0.01f);
        EXPECT_NEAR(world.body(crate).linear_velocity().z, -1, 0.01f);
    }
}

TEST(Conveyors, DynamicBodiesRefuseThem) {
    World world;
    ShapeDef def;
    def.surface_velocity = {1, 0, 0};
    const BodyId crate = add_crate(world, {0, 0, 0});
    EXPECT_NE(refusal([&] { world.add_shape(crate, Box{}, def); }).find("surface_velocity"), std::string::npos);
    EXPECT_NE(refusal([&] { world.set_surface_velocity(world.body(crate).shapes()[0], {1, 0, 0}); }), "");
    def.surface_velocity = {not_a_number, 0, 0};
    const BodyId base = world.create_body(body_at({0, 0, 0}, BodyType::static_));
    EXPECT_NE(refusal([&] { world.add_shape(base, Box{}, def); }).find("surface_velocity"), std::string::npos);
}

} // namespace
} // namespace cairn::test
