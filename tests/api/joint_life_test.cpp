// Life of joints: breaking, removal together with their bodies, handles, sleep, changes, snapshots, and invalid calls.
#include "joint_rig.h"

namespace cairn::test {
namespace {

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
        const double overlap = 1 - (world.body(b).position().x - world.body(a).position().x);
        EXPECT_NEAR(overlap, collide ? 0 : 0.1, collide ? 0.01 : 1e-6);
        if (collide) continue;
        EXPECT_EQ(world.contacts().size(), 0u);
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

// The solver caches the arrangement of joints in blocks from step to step. A world that was just restored has no cache.
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
