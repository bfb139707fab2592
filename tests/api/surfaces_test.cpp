// Materials: combining two of them, sliding, rolling, spinning, bouncing.
#include "test_world.h"

#include <vector>

namespace cairn::test {
namespace {

Material with_friction(float coefficient, CombineRule rule = CombineRule::average) {
    Material material;
    material.static_friction = material.dynamic_friction = coefficient;
    material.friction_combine = rule;
    return material;
}
Material with_restitution(float restitution, CombineRule rule = CombineRule::average) {
    Material material;
    material.restitution = restitution;
    material.restitution_combine = rule;
    return material;
}

// The distance that a box of one material slides on ground of the other, from 4 m/s.
double sliding_distance(const Material& ground, const Material& box) {
    World world;
    add_ground(world, ground);
    const BodyId crate = add_body(world, body_at({0.0, 0.25, 0.0}), Box{{1.0f, 0.25f, 1.0f}}, with_material(box));
    run(world, 20);
    const double start = world.body(crate).position().x;
    world.body(crate).set_linear_velocity({4.0f, 0.0f, 0.0f});
    run(world, 600);
    return world.body(crate).position().x - start;
}
double closed_form_distance(double friction) { return 4.0 * 4.0 / (2 * friction * 9.81); }

TEST(Friction, StopsABoxAtTheClosedFormDistance) {
    for (const float friction : {0.2f, 0.5f, 1.0f}) {
        const double expected = closed_form_distance(friction);
        EXPECT_NEAR(sliding_distance(with_friction(friction), with_friction(friction)), expected, 0.03 * expected)
            << friction;
    }
}

TEST(Friction, CombinesByTheStrongerRule) {
    struct Case {
        CombineRule ground, box;
        double expected; // for coefficients of 0.2 and 0.8
    };
    for (const Case& c :
         {Case{CombineRule::average, CombineRule::average, 0.5}, Case{CombineRule::minimum, CombineRule::minimum, 0.2},
          Case{CombineRule::maximum, CombineRule::maximum, 0.8},
          Case{CombineRule::multiply, CombineRule::multiply, 0.16},
          Case{CombineRule::average, CombineRule::multiply, 0.5}, Case{CombineRule::maximum, CombineRule::minimum, 0.2},
          Case{CombineRule::multiply, CombineRule::maximum, 0.8}}) {
        const double expected = closed_form_distance(c.expected);
        EXPECT_NEAR(sliding_distance(with_friction(0.2f, c.ground), with_friction(0.8f, c.box)), expected,
                    0.03 * expected)
            << "rules " << int(c.ground) << " and " << int(c.box);
    }
}

TEST(Friction, HoldsABoxOnASlopeUpToItsAngle) {
    for (const float share : {0.95f, 1.05f}) {
        World world;
        const float friction = 0.5f, slope = std::atan(friction) * share;
        const Quat turn = glm::angleAxis(slope, Vec3(0.0f, 0.0f, 1.0f));
        BodyDef ground = body_at({0.0, 0.0, 0.0}, BodyType::static_);
        ground.rotation = turn;
        add_body(world, ground, Plane{}, with_material(with_friction(friction)));
        BodyDef def = body_at(Position(turn * Vec3(0.0f, 0.25f, 0.0f)));
        def.rotation = turn;
        const BodyId box = add_body(world, def, Box{{1.0f, 0.25f, 1.0f}}, with_material(with_friction(friction)));
        run(world, 300);
        const double slid = glm::length(world.body(box).position() - def.position);
        if (share < 1) {
            EXPECT_LT(slid, 0.02);
        } else {
            EXPECT_GT(slid, 0.5);
        }
    }
}

TEST(Friction, StaticCoefficientHoldsMoreThanTheDynamicOne) {
    Material material = with_friction(0.3f);
    material.static_friction = 0.6f;
    const auto pushed = [&](float share) {
        World world;
        add_ground(world, material);
        Body crate =
            world.body(add_body(world, body_at({0.0, 0.25, 0.0}), Box{{1.0f, 0.25f, 1.0f}}, with_material(material)));
        run(world, 20);
        for (int i = 0; i < 120; ++i) {
            crate.add_force({share * crate.mass() * 9.81f, 0.0f, 0.0f});
            world.step(frame);
        }
        return crate.position().x;
    };
    EXPECT_LT(pushed(0.5f), 0.02) << "between the two: it sticks";
    EXPECT_NEAR(pushed(0.7f), 0.5 * 0.4 * 9.81 * 4, 0.5) << "above both: it slides against the dynamic one";
}

TEST(Friction, ChangedMaterialTakesEffectAtOnce) {
    World world;
    const BodyId ground = add_ground(world, with_friction(0.0f));
    const BodyId crate =
        add_body(world, body_at({0.0, 0.25, 0.0}), Box{{1.0f, 0.25f, 1.0f}}, with_material(with_friction(0.0f)));
    run(world, 10);
    world.body(crate).set_linear_velocity({4.0f, 0.0f, 0.0f});
    run(world, 60);
    EXPECT_NEAR(world.body(crate).linear_velocity().x, 4.0f, 1e-3f) << "without friction it goes on";
    world.set_material(world.body(ground).shapes()[0], with_friction(1.0f));
    world.set_material(world.body(crate).shapes()[0], with_friction(1.0f));
    run(world, 60);
    EXPECT_NEAR(world.body(crate).linear_velocity().x, 0.0f, 1e-3f);
}

// --- rolling and spinning

TEST(Rolling, BallThrownWithoutSpinRollsAtFiveSevenths) {
    World world;
    add_ground(world, with_friction(0.3f));
    const BodyId ball = add_body(world, body_at({0.0, 0.5, 0.0}), Sphere{}, with_material(with_friction(0.3f)));
    run(world, 10);
    world.body(ball).set_linear_velocity({7.0f, 0.0f, 0.0f});
    run(world, 120);
    EXPECT_NEAR(world.body(ball).linear_velocity().x, 5.0f, 0.05f);
    EXPECT_NEAR(world.body(ball).angular_velocity().z, -10.0f, 0.1f);
    run(world, 300);
    EXPECT_NEAR(world.body(ball).linear_velocity().x, 5.0f, 0.1f) << "without rolling friction it rolls on";
}

TEST(Rolling, RollingFrictionStopsABall) {
    // Rolling friction has the torque N x lever, which decelerates a rolling ball by 5/7 g lever / r.
    Material material = with_friction(0.8f);
    material.rolling_friction = 0.02f;
    World world;
    add_ground(world, material);
    BodyDef def = body_at({0.0, 0.5, 0.0});
    def.linear_velocity = {2.0f, 0.0f, 0.0f};
    def.angular_velocity = {0.0f, 0.0f, -4.0f};
    const BodyId ball = add_body(world, def, Sphere{}, with_material(material));
    const double deceleration = 5.0 / 7 * 9.81 * 0.02 / 0.5;
    run(world, 120);
    EXPECT_NEAR(world.body(ball).linear_velocity().x, 2.0 - 2 * deceleration, 0.1);
    run(world, 480);
    EXPECT_NEAR(world.body(ball).linear_velocity().x, 0.0f, 1e-3f);
    EXPECT_NEAR(world.body(ball).position().x, 2.0 * 2.0 / (2 * deceleration), 0.3);
}

TEST(Rolling, TorsionalFrictionStopsASpinningBall) {
    for (const float radius : {0.0f, 0.05f}) {
        Material material = with_friction(0.5f);
        material.torsional_friction = radius;
        World world;
        add_ground(world, material);
        BodyDef def = body_at({0.0, 0.5, 0.0});
        def.angular_velocity = {0.0f, 10.0f, 0.0f};
        const BodyId ball = add_body(world, def, Sphere{}, with_material(material));
        // Spinning friction has the torque friction x N x radius; the moment of inertia is 2/5 m r^2.
        const double deceleration = 0.5 * 9.81 * double(radius) / (0.4 * 0.25);
        run(world, 120);
        EXPECT_NEAR(world.body(ball).angular_velocity().y, 10.0 - 2 * deceleration, 0.05 + 0.1 * deceleration);
        run(world, 480);
        EXPECT_NEAR(world.body(ball).angular_velocity().y, radius > 0 ? 0.0f : 10.0f, 0.1f);
        EXPECT_NEAR(world.body(ball).position().x, 0.0, 0.01) << "it stays in place";
    }
}

// --- restitution

// Rebound speed over approach speed of a ball that falls from the given height.
double measured_restitution(const Material& ground, const Material& ball_material, double height = 2.0) {
    World world;
    add_ground(world, ground);
    const Body ball =
        world.body(add_body(world, body_at({0.0, 0.5 + height, 0.0}), Sphere{}, with_material(ball_material)));
    double highest = 0;
    bool touched = false;
    for (int i = 0; i < 240; ++i) {
        const bool was_falling = ball.linear_velocity().y < 0;
        world.step(frame);
        touched |= was_falling && ball.linear_velocity().y >= 0;
        if (touched) highest = std::max(highest, ball.position().y - 0.5);
    }
    return std::sqrt(highest / height);
}

TEST(Restitution, ReboundIsTheGivenShareOfTheApproach) {
    for (const float restitution : {0.0f, 0.3f, 0.7f, 1.0f})
        EXPECT_NEAR(measured_restitution(with_restitution(restitution), with_restitution(restitution)), restitution,
                    0.02)
            << restitution;
}

TEST(Restitution, CombinesByTheStrongerRule) {
    struct Case {
        CombineRule ground, ball;
        double expected; // for coefficients of 0.4 and 0.8
    };
    for (const Case& c :
         {Case{CombineRule::average, CombineRule::average, 0.6}, Case{CombineRule::minimum, CombineRule::multiply, 0.4},
          Case{CombineRule::maximum, CombineRule::maximum, 0.8},
          Case{CombineRule::multiply, CombineRule::multiply, 0.32}})
        EXPECT_NEAR(measured_restitution(with_restitution(0.4f, c.ground), with_restitution(0.8f, c.ball)), c.expected,
                    0.02);
}

TEST(Restitution, SlowImpactsDoNotBounce) {
    WorldDef def;
    def.restitution_speed = 1.0f;
    World world(def);
    const Material rubber = with_restitution(1.0f);
    add_ground(world, rubber);
    const Body ball =
        world.body(add_body(world, body_at({0.0, 0.53, 0.0}), Sphere{}, with_material(rubber))); // 0.77 m/s
    run(world, 60);
    EXPECT_NEAR(ball.position().y, 0.5, 0.005);
    EXPECT_NEAR(ball.linear_velocity().y, 0.0f, 0.01f);
}

TEST(Restitution, EqualBallsExchangeTheirVelocities) {
    World world(weightless());
    const Material steel = with_restitution(1.0f);
    BodyDef def = body_at({-3.0, 0.0, 0.0});
    def.linear_velocity = {4.0f, 0.0f, 0.0f};
    const Body first = world.body(add_body(world, def, Sphere{}, with_material(steel)));
    const Body second = world.body(add_body(world, {}, Sphere{}, with_material(steel)));
    run(world, 120);
    EXPECT_NEAR(first.linear_velocity().x, 0.0f, 0.02f);
    EXPECT_NEAR(second.linear_velocity().x, 4.0f, 0.02f);
}

} // namespace
} // namespace cairn::test
