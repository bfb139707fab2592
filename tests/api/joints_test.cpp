// Joints: which degrees of freedom each type constrains, limits in both directions, motors, springs and friction.
#include "joint_rig.h"

#include <cmath>

namespace cairn::test {
namespace {

constexpr float pi = 3.14159265f;

// --- degrees of freedom

// A joint type, its axis along x, and which of six degrees of freedom are free: translation along and rotation about x,
// y, z.
struct Freedom {
    const char* name;
    Joint joint;
    std::array<bool, 6> free;
};
class EveryJoint : public ::testing::TestWithParam<Freedom> {};

TEST_P(EveryJoint, MovesWhereItIsFreeAndHoldsElsewhere) {
    for (std::size_t way = 0; way < 6; ++way) {
        Rig rig(GetParam().joint);
        const Vec3 along = {float(way % 3 == 0), float(way % 3 == 1), float(way % 3 == 2)};
        const float strength = way < 3 ? rig.mass() : 0.02f * rig.mass();
        rig.run(0.5f,
                [&](Body body) { way < 3 ? body.add_force(strength * along) : body.add_torque(strength * along); });
        const Body body = rig.world.body(rig.body);
        const float moved = glm::length(Vec3(body.position())),
                    turned = 2 * glm::length(Vec3{body.rotation().x, body.rotation().y, body.rotation().z});
        const bool is_free = GetParam().free[way];
        if (is_free)
            EXPECT_GT(way < 3 ? moved : turned, 0.04f) << "way " << way;
        else
            EXPECT_LT(moved + turned, 2e-3f) << "way " << way << " is held";
        EXPECT_LT(rig.state().linear_error, 1e-3f);
        EXPECT_LT(rig.state().angular_error, 1e-3f);
    }
}

constexpr bool yes = true, no = false;

INSTANTIATE_TEST_SUITE_P(
    Joints, EveryJoint,
    ::testing::Values(Freedom{"fixed", FixedJoint{}, {no, no, no, no, no, no}},
                      Freedom{"ball", BallJoint{}, {no, no, no, yes, yes, yes}},
                      Freedom{"hinge", HingeJoint{}, {no, no, no, yes, no, no}},
                      Freedom{"slider", SliderJoint{}, {yes, no, no, no, no, no}},
                      Freedom{"cylindrical", CylindricalJoint{}, {yes, no, no, yes, no, no}},
                      Freedom{"universal", UniversalJoint{}, {no, no, no, yes, yes, no}},
                      Freedom{"wheel", WheelJoint{}, {yes, no, no, no, yes, no}},
                      Freedom{"steered_wheel", WheelJoint{{}, JointControl{}, {}}, {yes, no, no, yes, yes, no}},
                      Freedom{"free", GeneralJoint{}, {yes, yes, yes, yes, yes, yes}},
                      Freedom{"planar", locked({no, yes, no}, {yes, no, yes}), {yes, no, yes, no, yes, no}},
                      Freedom{"general_line", locked({no, yes, yes}, {yes, yes, yes}), {yes, no, no, no, no, no}},
                      Freedom{"general_hinge_z", locked({yes, yes, yes}, {yes, yes, no}), {no, no, no, no, no, yes}}),
    [](const auto& info) { return info.param.name; });

// As above, with the axis oblique to the box's own axes and the anchor away from its center.
TEST(Joints, HoldWhereverTheirAxisAndAnchorAre) {
    const std::vector<Joint> joints = {FixedJoint{},       BallJoint{},      HingeJoint{}, SliderJoint{},
                                       CylindricalJoint{}, UniversalJoint{}, WheelJoint{}};
    for (const Joint& type : joints) {
        World world(weightless());
        const BodyId a = add_body(world, body_at({0, 0, 0}), Box{{0.3f, 0.2f, 0.1f}});
        const BodyId b = add_body(world, body_at({1, 0.3, 0.2}), Box{{0.1f, 0.4f, 0.2f}});
        const JointId joint = world.create_joint(world.joint_at(a, b, {0.5, 0.2, -0.1}, {1, 2, -1}, type));
        const glm::dvec3 momentum = world.linear_momentum(), turning = world.angular_momentum();
        world.body(b).apply_impulse({20, 30, -10});
        world.body(b).apply_angular_impulse({1, 2, 1});
        const glm::dvec3 given = world.linear_momentum() - momentum, twist = world.angular_momentum() - turning;
        for (int i = 0; i < 120; ++i) {
            world.step(frame);
            ASSERT_LT(world.joint_state(joint).linear_error, 4e-3f) << type.index() << " step " << i;
            ASSERT_LT(world.joint_state(joint).angular_error, 8e-3f) << type.index() << " step " << i;
        }
        EXPECT_LT(glm::length(world.linear_momentum() - given), 2e-3 * glm::length(given));
        EXPECT_LT(glm::length(world.angular_momentum() - twist), 2e-2 * glm::length(twist)) << type.index();
    }
}

// --- limits, motors, springs, friction

TEST(Joints, HingeLimitsHoldFromBothSides) {
    for (const float sign : {1.0f, -1.0f}) {
        Rig rig(HingeJoint{limited(-0.5f, 0.25f)});
        const float bound = sign > 0 ? 0.25f : -0.5f;
        rig.run(2, [&](Body body) { body.add_torque({sign * 0.2f * rig.mass(), 0, 0}); });
        EXPECT_NEAR(rig.position(), bound, 2e-3f);
        EXPECT_NEAR(rig.state().torque.x, -sign * 0.2f * rig.mass(), 0.02f * rig.mass()) << "what holds it";
    }
}

TEST(Joints, SliderLimitsHoldFromBothSides) {
    for (const float sign : {1.0f, -1.0f}) {
        Rig rig(SliderJoint{limited(-0.5f, 0.25f)});
        rig.run(2, [&](Body body) { body.add_force({sign * 5 * rig.mass(), 0, 0}); });
        EXPECT_NEAR(rig.position(), sign > 0 ? 0.25f : -0.5f, 1e-3f);
        EXPECT_NEAR(rig.state().force.x, -sign * 5 * rig.mass(), 0.05f * rig.mass());
    }
}

TEST(Joints, MotorsReachTheirSpeedAndCountTurns) {
    Rig rig(HingeJoint{driven(3)});
    rig.run(5);
    EXPECT_NEAR(rig.world.body(rig.body).angular_velocity().x, 3, 1e-4f);
    EXPECT_NEAR(rig.position(), 15, 0.01f) << "more than two turns";
    rig.world.set_joint(rig.joint, HingeJoint{driven(-3)});
    rig.run(5);
    EXPECT_NEAR(rig.position(), 0, 0.02f);

    Rig slider(SliderJoint{driven(0.7f)});
    slider.run(1);
    EXPECT_NEAR(slider.position(), 0.7f, 1e-3f);
}

TEST(Joints, MotorsRespectTheirCap) {
    Rig rig(HingeJoint{driven(100, 0.5f)});
    rig.run(1);
    const float moment = rig.world.body(rig.body).world_inertia()[0][0];
    EXPECT_NEAR(rig.world.body(rig.body).angular_velocity().x, 0.5f / moment, 0.01f * 0.5f / moment);
    EXPECT_NEAR(rig.state().torque.x, 0.5f, 0.005f);
}

TEST(Joints, SpringsSwingAtTheirFrequency) {
    JointMotor motor;
    motor.spring = JointSpring::from_frequency(1, 0);
    Rig rig(SliderJoint{{{}, motor, 0}});
    rig.world.body(rig.body).set_linear_velocity({1, 0, 0});
    float last = 0;
    std::vector<float> crossings;
    for (int i = 0; i < 600; ++i) {
        rig.world.step(frame);
        const float x = rig.position();
        if (last > 0 && x <= 0) crossings.push_back(float(i) * frame + frame * last / (last - x));
        last = x;
    }
    ASSERT_GE(crossings.size(), 5u);
    EXPECT_NEAR((crossings.back() - crossings.front()) / float(crossings.size() - 1), 1, 0.01f);
}

TEST(Joints, SpringsHoldByTheirStiffness) {
    JointMotor motor;
    motor.spring = JointSpring{400, 200, false};
    motor.position = 0.1f;
    Rig rig(SliderJoint{{{}, motor, 0}});
    rig.run(10, [](Body body) { body.add_force({20, 0, 0}); });
    EXPECT_NEAR(rig.position(), 0.1f + 20.0f / 400, 1e-3f);
}

TEST(Joints, FrictionHoldsUntilItIsOvercome) {
    JointControl control;
    control.friction = 10;
    Rig rig(SliderJoint{control});
    rig.run(1, [](Body body) { body.add_force({9.9f, 0, 0}); });
    EXPECT_NEAR(rig.position(), 0, 1e-4f);
    rig.run(1, [](Body body) { body.add_force({30, 0, 0}); });
    EXPECT_NEAR(rig.world.body(rig.body).linear_velocity().x, 20 / rig.mass(), 0.02f * 20 / rig.mass());
}

TEST(Joints, ConeAndTwistBoundABall) {
    BallJoint ball;
    ball.cone_angle = 0.6f;
    ball.twist = JointRange{-0.3f, 0.4f, {}};
    Rig rig(ball);
    rig.run(2, [&](Body body) { body.add_torque({0, 0.05f * rig.mass(), 0.03f * rig.mass()}); });
    EXPECT_NEAR(rig.position(0), 0.6f, 5e-3f);
    rig.run(3, [&](Body body) { body.add_torque({0.05f * rig.mass(), 0, 0}); });
    EXPECT_NEAR(rig.position(1), 0.4f, 0.02f);
    EXPECT_LT(rig.position(0), 0.61f);
}

TEST(Joints, RopeIsSlackUntilItIsTaut) {
    World world;
    const BodyId ball = add_body(world, body_at({0, 0, 0}), Sphere{});
    JointDef def;
    def.body_b = ball;
    def.frame_a.position = {0, 1, 0};
    def.joint = DistanceJoint{{JointRange{0, 2, {}}, {}, 0}};
    const JointId rope = world.create_joint(def);
    world.step(frame);
    EXPECT_EQ(world.joint_state(rope).force, Vec3(0));
    for (int i = 0; i < 120; ++i) world.step(frame);
    EXPECT_NEAR(world.joint_state(rope).positions[0], 2, 1e-3f);
    EXPECT_NEAR(world.joint_state(rope).force.y, 9.81f * world.body(ball).mass(), 0.01f * world.body(ball).mass());
}

TEST(Joints, GearsTurnAgainstEachOtherInTheirRatio) {
    World world(weightless());
    const BodyId frame_body = world.create_body(body_at({0, 0, 0}, BodyType::static_));
    const BodyId small = add_body(world, body_at({0, 0, 0}), Cylinder{0.1f, 0.5f, {}});
    const BodyId large = add_body(world, body_at({1.5, 0, 0}), Cylinder{0.1f, 1.0f, {}});
    JointControl motor = driven(2);
    world.create_joint(world.joint_at(frame_body, small, {0, 0, 0}, {0, 1, 0}, HingeJoint{motor}));
    const JointId second = world.create_joint(world.joint_at(frame_body, large, {1.5, 0, 0}, {0, 1, 0}, HingeJoint{}));
    JointDef gear = world.joint_at(small, large, {0, 0, 0}, {0, 1, 0}, GearJoint{2});
    gear.frame_b.position = {0, 0, 0};
    const JointId mesh = world.create_joint(gear);
    for (int i = 0; i < 600; ++i) world.step(frame);
    EXPECT_NEAR(world.body(small).angular_velocity().y, 2, 1e-3f);
    EXPECT_NEAR(world.body(large).angular_velocity().y, -1, 1e-3f);
    EXPECT_LT(world.joint_state(mesh).angular_error, 1e-3f) << "no tooth is skipped";
    EXPECT_TRUE(world.is_valid(second));
}

TEST(Joints, RackMovesWithItsPinion) {
    World world(weightless());
    const BodyId pinion = add_body(world, body_at({0, 0, 0}), Cylinder{0.1f, 0.25f, {}});
    const BodyId rack = add_body(world, body_at({0, 0, 0.35}), Box{{1, 0.1f, 0.1f}});
    world.create_joint(world.joint_at({}, pinion, {0, 0, 0}, {0, 1, 0}, HingeJoint{driven(2)}));
    world.create_joint(world.joint_at({}, rack, {0, 0, 0.35}, {1, 0, 0}, SliderJoint{}));
    JointDef def = world.joint_at(pinion, rack, {0, 0, 0}, {0, 1, 0}, RackJoint{0.25f});
    def.frame_b.rotation = {1, 0, 0, 0};
    world.create_joint(def);
    for (int i = 0; i < 120; ++i) world.step(frame);
    EXPECT_NEAR(world.body(rack).position().x, 2 * 2 * 0.25, 2e-3);
}

TEST(Joints, PulleyLiftsTheLighterSide) {
    World world;
    const BodyId heavy = add_body(world, body_at({-1, 0, 0}), Box{{0.2f, 0.2f, 0.2f}});
    const BodyId light = add_body(world, body_at({1, 0, 0}), Box{{0.1f, 0.1f, 0.1f}});
    JointDef def;
    def.body_a = heavy, def.body_b = light;
    def.joint = PulleyJoint{{-1, 3, 0}, {1, 3, 0}, 1, {}};
    world.create_joint(def);
    for (int i = 0; i < 30; ++i) world.step(frame);
    const float m = world.body(heavy).mass(), n = world.body(light).mass(), a = 9.81f * (m - n) / (m + n);
    EXPECT_NEAR(world.body(heavy).linear_velocity().y, -0.5f * a, 0.01f * a) << "Atwood's machine";
    EXPECT_NEAR(world.body(light).linear_velocity().y, 0.5f * a, 0.01f * a);
}

TEST(Joints, ServoBringsABodyToItsPose) {
    ServoJoint servo;
    servo.position = {0.5f, 0.25f, 0};
    servo.rotation = glm::angleAxis(1.0f, glm::normalize(Vec3{1, 1, 0}));
    Rig rig(servo, {1, 0, 0}, WorldDef{});
    rig.run(3);
    const Body body = rig.world.body(rig.body);
    // Under gravity the servo sags by g / (2 pi f)^2.
    EXPECT_NEAR(glm::length(Vec3(body.position()) - Vec3{0.5f, 0.25f - 9.81f / (10 * pi * 10 * pi), 0}), 0, 2e-3f);
    EXPECT_GT(std::fabs(glm::dot(body.rotation(), servo.rotation)), 0.9999f);
}

TEST(Joints, WheelSpringsSteersAndSpins) {
    WheelJoint wheel;
    wheel.suspension.motor = JointMotor{0, 0.05f, JointSpring::from_frequency(3, 1), 1e9f};
    wheel.steering = JointControl{};
    wheel.steering->motor = JointMotor{0, 0.4f, JointSpring::from_frequency(8, 1), 1e9f};
    wheel.spin = driven(40);
    Rig rig(wheel, {0, 1, 0});
    rig.run(4);
    EXPECT_NEAR(rig.position(0), 0.05f, 5e-3f);
    EXPECT_NEAR(rig.position(1), 0.4f, 0.02f);
    EXPECT_NEAR(rig.position(2), 160, 3.0f);
    EXPECT_LT(rig.state().angular_error, 0.02f);
}

} // namespace
} // namespace cairn::test
