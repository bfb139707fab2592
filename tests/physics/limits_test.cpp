// Joint limits are omitted from the solver while they are out of reach. They must hold all the same, whatever brings
// the bodies to them.
#include "support.h"

#include <algorithm>

namespace cairn_test {
namespace {

constexpr float cone = 0.8f, lower = -0.6f, upper = 0.7f; // rad

// A rod that hangs on a post from its upper end, at rest for long enough that its limits are out of reach.
struct Hanging {
    World world;
    BodyId post, rod;
    JointId joint;

    static WorldDef settings() {
        WorldDef def = without_sleep();
        def.gravity = {0, 0, 0};
        return def;
    }
    explicit Hanging(const Joint& kind, BodyType post_type = BodyType::kinematic) : world(settings()) {
        BodyDef def;
        def.type = post_type;
        post = add_body(world, Sphere{0.05f}, def, surface(0.5f));
        def.type = BodyType::dynamic;
        def.position = {0, -0.5, 0};
        rod = add_body(world, Box{{0.05f, 0.45f, 0.08f}}, def, surface(0.5f));
        // The joint axis lies along the rod for the swing and twist of a ball joint, and across it for a hinge.
        const bool is_ball = std::holds_alternative<BallJoint>(kind);
        joint =
            world.create_joint(world.joint_at(post, rod, {0, 0, 0}, is_ball ? Vec3{0, -1, 0} : Vec3{0, 0, 1}, kind));
        for (int i = 0; i < 10; ++i) world.step(1.0f / 60);
    }

    // The angle beyond the most exceeded limit, rad; negative within the limits.
    double excess() const {
        const JointState state = world.joint_state(joint);
        if (const auto* ball = std::get_if<BallJoint>(&world.joint_def(joint).joint))
            return std::max({state.positions[0] - *ball->cone_angle, ball->twist->lower - state.positions[1],
                             state.positions[1] - ball->twist->upper});
        const auto& limits = std::get<HingeJoint>(world.joint_def(joint).joint).angle.limits;
        return std::max(limits->lower - state.positions[0], state.positions[0] - limits->upper);
    }
    // Makes the rod rotate about the anchor.
    void turn(Vec3 w) {
        world.body(rod).set_angular_velocity(w);
        world.body(rod).set_linear_velocity(glm::cross(w, Vec3(0, -0.5f, 0)));
    }
    // The greatest excess within a second, rad.
    double greatest_excess() {
        double greatest = -10;
        for (int i = 0; i < 60; ++i) {
            world.step(1.0f / 60);
            greatest = std::max(greatest, excess());
        }
        return greatest;
    }
};

Joint hinge(float from = lower, float to = upper) {
    HingeJoint joint;
    joint.angle.limits = JointRange{from, to, {}};
    return joint;
}
Joint ball(float swing = cone, float from = lower, float to = upper) {
    BallJoint joint;
    joint.cone_angle = swing;
    joint.twist = JointRange{from, to, {}};
    return joint;
}

TEST(Limits, OutOfReachHoldWhatTurnsAtThem) {
    for (const Vec3 axis : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0),
                            Vec3(0.6f, 0.8f, 0), Vec3(0, 0.8f, -0.6f)})
        for (const float speed : {1.0f, 5.0f, 30.0f}) {
            SCOPED_TRACE(testing::Message() << axis.x << " " << axis.y << " " << axis.z << " at " << speed);
            const double bar = speed < 10 ? 0.01 : 0.05;
            Hanging by_ball(ball());
            by_ball.turn(speed * axis);
            const double excess = by_ball.greatest_excess();
            EXPECT_GT(excess, -0.1) << "it has come there";
            EXPECT_LT(excess, bar);
            if (std::fabs(axis.z) < 1) continue;
            Hanging by_hinge(hinge());
            by_hinge.turn(speed * axis);
            const double of_hinge = by_hinge.greatest_excess();
            EXPECT_GT(of_hinge, -0.1) << "it has come there";
            EXPECT_LT(of_hinge, bar);
        }
}

// The rod's own velocity is not enough to predict the limit: the post, an impact, gravity or another body may rotate
// it.
TEST(Limits, OutOfReachHoldWhatIsTurnedOtherwise) {
    for (const Joint& kind : {hinge(), ball()}) {
        SCOPED_TRACE(kind.index());
        Hanging turned(kind);
        turned.world.body(turned.post).set_angular_velocity({0, 0, 4});
        EXPECT_LT(turned.greatest_excess(), 0.05);
        EXPECT_GT(turned.world.body(turned.rod).angular_velocity().z, 2);

        Hanging hit(kind);
        Body rod = hit.world.body(hit.rod);
        rod.apply_impulse_at(0.3f * rod.mass() * Vec3(12, 0, 0), {0, -0.9, 0});
        EXPECT_LT(hit.greatest_excess(), 0.05);

        Hanging pulled(kind);
        WorldDef settings = pulled.world.settings();
        settings.gravity = {20, 0, 0};
        pulled.world.set_settings(settings);
        const double excess = pulled.greatest_excess();
        EXPECT_LT(excess, 0.01);
        EXPECT_GT(excess, -0.01);
    }
}

TEST(Limits, OutOfReachBringBackWhatIsPutBeyondThem) {
    for (const Joint& kind : {hinge(), ball()}) {
        SCOPED_TRACE(kind.index());
        Hanging put(kind);
        const Quat q = glm::angleAxis(1.2f, Vec3(0, 0, 1));
        put.world.body(put.rod).set_transform(Position(q * Vec3(0, -0.5f, 0)), q);
        EXPECT_GT(put.excess(), 0.35);
        put.greatest_excess();
        EXPECT_LT(put.excess(), 0.01);

        Hanging post_put(kind);
        post_put.world.body(post_put.post).set_rotation(glm::angleAxis(-1.2f, Vec3(0, 0, 1)));
        EXPECT_GT(post_put.excess(), 0.35);
        post_put.greatest_excess();
        EXPECT_LT(post_put.excess(), 0.01);
    }
    Hanging narrower(hinge());
    narrower.world.set_joint(narrower.joint, hinge(0.2f, 0.5f));
    EXPECT_NEAR(narrower.excess(), 0.2, 1e-3);
    narrower.greatest_excess();
    EXPECT_LT(narrower.excess(), 0.01);
    Hanging twisted(ball());
    twisted.world.set_joint(twisted.joint, ball(cone, 0.2f, 0.5f));
    twisted.greatest_excess();
    EXPECT_LT(twisted.excess(), 0.01);
}

// A hinge whose limits span more than a turn counts whole turns; the angle at which its limits were last solved may be
// several turns ago.
TEST(Limits, OutOfReachAreCountedOverWholeTurns) {
    Hanging wound(hinge(-4, 20));
    wound.turn({0, 0, 6});
    double angle = 0;
    for (int i = 0; i < 240; ++i) {
        wound.world.step(1.0f / 60);
        angle = std::max(angle, double(wound.world.joint_state(wound.joint).positions[0]));
    }
    EXPECT_GT(angle, 19.9);
    EXPECT_LT(angle, 20.01);
}

} // namespace
} // namespace cairn_test
