// Joints: what each holds and what it leaves free, limits from both sides, motors, springs, friction, breaking, and the
// life of handles.
#include "test_world.h"

#include <cmath>
#include <functional>

namespace cairn::test {
namespace {

constexpr float pi = 3.14159265f;

// A fixed base at the origin and a dynamic box of unequal sides beside it, joined at the base's origin. Weightless:
// only what the test does moves it.
struct Rig {
    World world;
    BodyId base, body;
    JointId joint;

    explicit Rig(const Joint& type, const Vec3& axis = {1, 0, 0}, const WorldDef& def = weightless()) : world(def) {
        base = world.create_body(body_at({0, 0, 0}, BodyType::static_));
        body = add_body(world, body_at({0, 0, 0}), Box{{0.3f, 0.2f, 0.1f}});
        joint = world.create_joint(world.joint_at(base, body, {0, 0, 0}, axis, type));
    }
    void run(
        float seconds, const std::function<void(Body)>& push = [](Body) {}) {
        for (int i = 0; i < int(seconds / frame + 0.5f); ++i) {
            push(world.body(body));
            world.step(frame);
        }
    }
    float position(int i = 0) const { return world.joint_state(joint).positions[std::size_t(i)]; }
    JointState state() const { return world.joint_state(joint); }
    float mass() { return world.body(body).mass(); }
};

JointControl limited(float lower, float upper) { return {JointRange{lower, upper, {}}, {}, 0}; }
JointControl driven(float velocity, float cap = std::numeric_limits<float>::infinity()) {
    JointMotor motor;
    motor.velocity = velocity;
    motor.max_force = cap;
    return {{}, motor, 0};
}

// --- degrees of freedom

// A joint, its axis along x, and which of six ways of a push move the body: along and about x, y, z.
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

GeneralJoint locked(std::array<bool, 3> linear, std::array<bool, 3> angular) {
    GeneralJoint joint;
    if (linear[0] || linear[1] || linear[2]) joint.limits.push_back({JointAxis::linear, linear, 0.0f, 0.0f, {}, 0});
    if (angular[0] || angular[1] || angular[2])
        joint.limits.push_back({JointAxis::angular, angular, 0.0f, 0.0f, {}, 0});
    return joint;
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

// The same, with the axis across the box's own axes and the anchor away from its center.
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
    // By gravity it hangs g / (2 pi f)^2 lower.
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

// --- the life of joints

TEST(Joints, BreakUnderTheirLoadAndSaySo) {
    World world;
    const BodyId ball = add_body(world, body_at({0, 0, 0}), Sphere{});
    JointDef def;
    def.body_b = ball;
    def.joint = BallJoint{};
    def.frame_b.position = {0, 0.5, 0};
    def.frame_a.position = {0, 0.5, 0};
    const float weight = 9.81f * world.body(ball).mass();
    def.break_force = 1.1f * weight;
    def.user_data = 77;
    const JointId joint = world.create_joint(def);
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        ASSERT_TRUE(world.joint_events().empty());
    }
    world.set_joint_strength(joint, 0.9f * weight, 1);
    world.step(frame);
    ASSERT_EQ(world.joint_events().size(), 1u);
    const JointEvent& event = world.joint_events()[0];
    EXPECT_TRUE(event.broke);
    EXPECT_EQ(event.joint, joint);
    EXPECT_EQ(event.body_b, ball);
    EXPECT_EQ(event.user_data, 77u);
    EXPECT_NEAR(event.force, weight, 0.02f * weight);
    EXPECT_FALSE(world.is_valid(joint));
    for (int i = 0; i < 60; ++i) world.step(frame);
    EXPECT_LT(world.body(ball).position().y, -4) << "it falls";
}

TEST(Joints, GoWithTheirBodiesAndSaySo) {
    Rig rig(HingeJoint{});
    EXPECT_EQ(rig.world.joints(), std::vector<JointId>{rig.joint});
    EXPECT_EQ(rig.world.joints(rig.body), std::vector<JointId>{rig.joint});
    rig.world.destroy_body(rig.base);
    rig.world.step(frame);
    ASSERT_EQ(rig.world.joint_events().size(), 1u);
    EXPECT_FALSE(rig.world.joint_events()[0].broke);
    EXPECT_EQ(rig.world.joint_events()[0].joint, rig.joint);
    EXPECT_FALSE(rig.world.is_valid(rig.joint));
    EXPECT_TRUE(rig.world.joints().empty());
    EXPECT_TRUE(rig.world.joints(rig.body).empty());
    EXPECT_THROW(rig.world.joint_state(rig.joint), Error);
    rig.world.step(frame);
    EXPECT_TRUE(rig.world.joint_events().empty());
}

TEST(Joints, HandlesAreNeverMistakenForNewerOnes) {
    Rig rig(BallJoint{});
    rig.world.destroy_joint(rig.joint);
    EXPECT_THROW(rig.world.destroy_joint(rig.joint), Error);
    const JointId next =
        rig.world.create_joint(rig.world.joint_at(rig.base, rig.body, {0, 0, 0}, {1, 0, 0}, FixedJoint{}));
    EXPECT_EQ(next.index(), rig.joint.index());
    EXPECT_NE(next, rig.joint);
    EXPECT_THROW(rig.world.set_joint(rig.joint, HingeJoint{}), Error);
    EXPECT_NO_THROW(rig.world.set_joint(next, HingeJoint{}));
}

TEST(Joints, JoinedBodiesCollideOnlyIfAsked) {
    for (const bool collide : {false, true}) {
        World world(weightless());
        const BodyId a = add_body(world, body_at({0, 0, 0}), Box{});
        const BodyId b = add_body(world, body_at({0.9, 0, 0}), Box{});
        JointDef def = world.joint_at(a, b, {0.45, 0, 0}, {1, 0, 0}, SliderJoint{});
        def.enable_collision = collide;
        const JointId joint = world.create_joint(def);
        for (int i = 0; i < 30; ++i) world.step(frame);
        EXPECT_EQ(world.contacts().size(), collide ? 1u : 0u);
        if (collide) continue;
        world.destroy_joint(joint);
        for (int i = 0; i < 3; ++i) world.step(frame);
        EXPECT_EQ(world.contacts().size(), 1u) << "without the joint they do";
    }
}

TEST(Joints, JoinedBodiesSleepAndWakeTogether) {
    World world;
    add_body(world, body_at({0, -1, 0}, BodyType::static_), Box{{20, 1, 20}});
    const BodyId a = add_body(world, body_at({0, 0.5, 0}), Box{});
    const BodyId b = add_body(world, body_at({3, 0.5, 0}), Box{});
    world.create_joint(world.joint_at(a, b, {1.5, 0.5, 0}, {1, 0, 0}, FixedJoint{}));
    for (int i = 0; i < 180; ++i) world.step(frame);
    EXPECT_FALSE(world.body(a).is_awake());
    EXPECT_FALSE(world.body(b).is_awake());
    world.body(b).apply_impulse({0, 1, 0});
    world.step(frame);
    EXPECT_TRUE(world.body(a).is_awake());
}

TEST(Joints, KinematicBodiesPullWhatSleeps) {
    World world(weightless());
    const BodyId hand = add_body(world, body_at({0, 0, 0}, BodyType::kinematic), Sphere{0.1f});
    const BodyId ball = add_body(world, body_at({1, 0, 0}), Sphere{0.1f});
    const JointId joint = world.create_joint(world.joint_at(hand, ball, {0.5, 0, 0}, {1, 0, 0}, BallJoint{}));
    for (int i = 0; i < 90; ++i) world.step(frame);
    ASSERT_FALSE(world.body(ball).is_awake());
    world.body(hand).set_linear_velocity({-1, 0, 0});
    for (int i = 0; i < 60; ++i) world.step(frame);
    EXPECT_NEAR(world.body(ball).position().x, 0, 0.02);
    EXPECT_LT(world.joint_state(joint).linear_error, 1e-3f);
}

TEST(Joints, SurviveAChangeOfType) {
    World world;
    const BodyId a = add_body(world, body_at({0, 0, 0}, BodyType::static_), Sphere{});
    const BodyId b = add_body(world, body_at({1, 0, 0}), Sphere{});
    const JointId joint = world.create_joint(world.joint_at(a, b, {0.5, 0, 0}, {1, 0, 0}, FixedJoint{}));
    world.body(b).set_type(BodyType::static_);
    for (int i = 0; i < 10; ++i) world.step(frame);
    EXPECT_TRUE(world.is_valid(joint));
    world.body(b).set_type(BodyType::dynamic);
    world.body(a).set_type(BodyType::dynamic);
    for (int i = 0; i < 60; ++i) world.step(frame);
    EXPECT_LT(world.body(a).position().y, -4) << "both fall";
    EXPECT_LT(world.joint_state(joint).linear_error, 1e-3f);
}

TEST(Joints, SnapshotsHoldThem) {
    World world;
    const BodyId base = world.create_body(body_at({0, 0, 0}, BodyType::static_));
    std::vector<BodyId> links = {base};
    for (int i = 0; i < 8; ++i) {
        links.push_back(add_body(world, body_at({0.5 + i, 0, 0}), Box{{0.4f, 0.1f, 0.1f}}));
        const Joint type = i % 2 ? Joint(HingeJoint{limited(-1, 1)}) : Joint(BallJoint{});
        world.create_joint(world.joint_at(links[std::size_t(i)], links.back(), {double(i), 0, 0}, {0, 0, 1}, type));
    }
    GeneralJoint general = locked({true, true, true}, {false, false, false});
    general.drives.push_back({JointAxis::angular, false, 1, 5.0f, 0.3f, 0, 10, 1});
    JointDef last = world.joint_at(links[8], {}, {8.5, 0, 0}, {1, 0, 0}, general);
    last.name = "last";
    world.create_joint(last);
    for (int i = 0; i < 40; ++i) world.step(frame);
    const Snapshot snapshot = world.save();
    World copy;
    copy.restore(snapshot);
    for (int i = 0; i < 60; ++i) world.step(frame), copy.step(frame);
    EXPECT_EQ(world.state_hash(), copy.state_hash());
    ASSERT_TRUE(copy.find_joint("last"));
    const JointDef& def = copy.joint_def(*copy.find_joint("last"));
    ASSERT_TRUE(std::holds_alternative<GeneralJoint>(def.joint));
    EXPECT_EQ(std::get<GeneralJoint>(def.joint).drives[0].stiffness, 10);
}

// How joints lie in the solver's blocks is kept from step to step. A world that was just restored has nothing kept.
TEST(Joints, ChangesCountAtOnceAsInAWorldJustRestored) {
    World world;
    std::vector<BodyId> balls;
    std::vector<JointId> joints;
    for (int i = 0; i < 40; ++i) {
        const int column = i % 10, row = i / 10;
        balls.push_back(add_body(world, body_at({double(column), 0, double(row)}), Sphere{0.2f}));
        const auto join = [&](std::size_t other, const Joint& type) {
            const Position middle = 0.5 * (world.body(balls[other]).position() + world.body(balls.back()).position());
            joints.push_back(world.create_joint(world.joint_at(balls[other], balls.back(), middle, {1, 0, 0}, type)));
        };
        const std::size_t last = balls.size() - 1;
        if (column > 0) join(last - 1, i % 4 == 1 ? Joint(HingeJoint{limited(-1, 1)}) : Joint(BallJoint{}));
        if (row > 0) join(last - 10, BallJoint{});
    }
    const std::function<void()> changes[] = {
        [&] { world.body(balls[0]).set_type(BodyType::kinematic); },
        [&] {
            world.body(balls[0]).set_linear_velocity({0, 1, 0});
        },
        [&] { world.body(balls[9]).set_type(BodyType::static_); },
        [&] { world.destroy_joint(joints[20]); },
        [&] { world.set_joint(joints[5], HingeJoint{driven(2, 50)}); },
        [&] {
            world.create_joint(world.joint_at(balls[39], {}, {9, 0, 3}, {0, 1, 0}, BallJoint{}));
        },
        [&] { world.body(balls[0]).set_type(BodyType::static_); },
        [&] { world.destroy_body(balls[15]); },
        [&] { world.body(balls[9]).set_type(BodyType::dynamic); },
    };
    for (const auto& change : changes) {
        for (int i = 0; i < 5; ++i) world.step(frame);
        change();
        World copy;
        copy.restore(world.save());
        for (int i = 0; i < 5; ++i) world.step(frame), copy.step(frame);
        ASSERT_EQ(world.state_hash(), copy.state_hash()) << "change " << &change - changes;
    }
}

// --- refusals

TEST(Joints, RefuseBadArgumentsAndLeaveTheWorldAsItWas) {
    World world;
    const BodyId a = add_body(world, body_at({0, 0, 0}), Sphere{}), b = add_body(world, body_at({2, 0, 0}), Sphere{});
    const BodyId wall = world.create_body(body_at({0, 0, 0}, BodyType::static_));
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    auto with = [&](const Joint& joint) {
        JointDef def;
        def.body_a = a, def.body_b = b, def.joint = joint;
        return def;
    };
    auto changed = [&](const std::function<void(JointDef&)>& change) {
        JointDef def = with(FixedJoint{});
        change(def);
        return def;
    };
    JointMotor bad_motor;
    bad_motor.max_force = -1;
    JointMotor bad_spring;
    bad_spring.spring = JointSpring{-1, 0, false};
    GeneralJoint no_axes, many;
    no_axes.limits.push_back({});
    for (int i = 0; i < 9; ++i) many.drives.push_back({JointAxis::linear, false, 0, {}, 0, 0, 1, 0});
    GeneralJoint bad_axis;
    bad_axis.drives.push_back({JointAxis::linear, false, 3, {}, 0, 0, 1, 0});
    const std::vector<JointDef> bad = {changed([&](JointDef& d) { d.body_b = d.body_a; }),
                                       changed([&](JointDef& d) { d.body_a = d.body_b = {}; }),
                                       changed([&](JointDef& d) { d.body_a = wall, d.body_b = {}; }),
                                       changed([&](JointDef& d) { d.frame_a.position.x = double(nan); }),
                                       changed([&](JointDef& d) { d.frame_b.rotation = Quat(0, 0, 0, 0); }),
                                       changed([&](JointDef& d) { d.break_force = 0; }),
                                       changed([&](JointDef& d) { d.break_torque = nan; }),
                                       with(HingeJoint{limited(1, -1)}),
                                       with(HingeJoint{limited(nan, 1)}),
                                       with(HingeJoint{limited(infinity, infinity)}),
                                       with(HingeJoint{driven(nan)}),
                                       with(SliderJoint{{{}, bad_motor, 0}}),
                                       with(SliderJoint{{{}, bad_spring, 0}}),
                                       with(SliderJoint{{{}, {}, -1}}),
                                       with(BallJoint{-0.1f, {}, 0}),
                                       with(BallJoint{4.0f, {}, 0}),
                                       with(DistanceJoint{limited(-2, -1)}),
                                       with(GearJoint{0}),
                                       with(RackJoint{nan}),
                                       with(PulleyJoint{{}, {}, 0, {}}),
                                       with(PulleyJoint{{}, {}, 1, -1.0f}),
                                       with(no_axes),
                                       with(many),
                                       with(bad_axis)};
    const std::uint64_t before = world.state_hash();
    for (std::size_t i = 0; i < bad.size(); ++i) EXPECT_THROW(world.create_joint(bad[i]), Error) << i;
    EXPECT_TRUE(world.joints().empty());
    EXPECT_EQ(world.state_hash(), before);
    EXPECT_THROW(world.joint_at(a, b, {0, 0, 0}, {0, 0, 0}, FixedJoint{}), Error);
    const JointId good = world.create_joint(with(HingeJoint{}));
    EXPECT_THROW(world.set_joint(good, HingeJoint{limited(1, 0)}), Error);
    EXPECT_THROW(world.set_joint_strength(good, -1, 1), Error);
    EXPECT_FALSE(std::get<HingeJoint>(world.joint_def(good).joint).angle.limits);
}

} // namespace
} // namespace cairn::test
