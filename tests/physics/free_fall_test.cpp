// Jointed bodies that fall side by side without rotating move as free ones do; once anything acts on one body, the
// joint holds.
#include "support.h"

#include <algorithm>
#include <functional>

namespace cairn_test {
namespace {

constexpr float dt = 1.0f / 60;

// A rod of two halves in free fall, whose joint is in the iterative solver and has had zero impulse for long enough to
// be skipped.
struct Flying {
    World world;
    BodyId left, right;
    JointId joint;

    explicit Flying(const Joint& kind = BallJoint{}, const WorldDef& settings = without_sleep()) : world(settings) {
        left = add_half(-0.5), right = add_half(0.5);
        JointDef def = world.joint_at(left, right, {0, 1000, 0}, {0, 0, 1}, kind);
        def.solver = JointSolver::iterative;
        joint = world.create_joint(def);
        run(world, dt, 5);
    }
    BodyId add_half(double x) {
        BodyDef def;
        def.position = {x, 1000, 0};
        return add_body(world, Box{{0.5f, 0.1f, 0.2f}}, def, surface(0.5f));
    }
    // The greatest gap of the joint within a second, m.
    float greatest_error() {
        float greatest = 0;
        for (int i = 0; i < 60; ++i) {
            world.step(dt);
            greatest = std::max(greatest, world.joint_state(joint).linear_error);
        }
        return greatest;
    }
};

TEST(JointedFall, OfJointedBodiesIsThatOfFreeOnes) {
    Flying rod;
    BodyDef def;
    def.position = {10, 1000, 0};
    const BodyId alone = add_body(rod.world, Sphere{0.5f}, def, surface(0.5f));
    rod.world.body(alone).set_position({10, rod.world.body(rod.left).position().y, 0});
    rod.world.body(alone).set_linear_velocity(rod.world.body(rod.left).linear_velocity());
    for (int i = 0; i < 10; ++i) {
        rod.world.step(dt);
        EXPECT_NEAR(rod.world.body(rod.left).linear_velocity().y, rod.world.body(alone).linear_velocity().y, 1e-5) << i;
        // The numbers of substeps differ, and with them the error of the integrator, g dt h / 2 per step.
        EXPECT_NEAR(rod.world.body(rod.left).position().y, rod.world.body(alone).position().y, 2e-3) << i;
    }
}

// Each of these actions ends the free fall within a step.
TEST(JointedFall, EndsByWhateverPulls) {
    struct Case {
        const char* what;
        std::function<void(Flying&)> change;
        float bar; // greatest gap of the joint, m
    };
    const Case cases[] = {
        {"nothing", [](Flying&) {}, 1e-5f},
        {"a push",
         [](Flying& rod) {
             rod.world.body(rod.left).add_force({0, 0, 20000});
         },
         2e-3f},
        {"a velocity",
         [](Flying& rod) {
             rod.world.body(rod.left).set_linear_velocity({0, 0, 2});
         },
         2e-3f},
        {"a turn",
         [](Flying& rod) {
             rod.world.body(rod.right).set_angular_velocity({0, 2, 0});
         },
         2e-3f},
        {"less weight", [](Flying& rod) { rod.world.body(rod.left).set_gravity_scale(0.2f); }, 1e-4f},
        {"drag", [](Flying& rod) { rod.world.body(rod.left).set_damping(3, 0); }, 1e-4f},
        {"no force any more", [](Flying& rod) { rod.world.body(rod.left).set_type(BodyType::static_); }, 2e-3f},
        {"a field",
         [](Flying& rod) {
             ForceField field;
             field.kind = ForceField::Kind::radial;
             field.center = {0, 1000, 0};
             field.strength = 20;
             field.exponent = 1;
             rod.world.add_force_field(field);
         },
         1e-4f},
        {"a post below one half",
         [](Flying& rod) {
             BodyDef def;
             def.type = BodyType::static_;
             def.position = {0.7, 998, 0};
             add_body(rod.world, Box{}, def, surface(0.5f));
         },
         5e-3f},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.what);
        Flying rod;
        c.change(rod);
        EXPECT_LT(rod.greatest_error(), c.bar);
    }
}

// In the step in which one half is stopped, the joint already transfers the impact to the other.
TEST(JointedFall, EndsWithTheFirstContact) {
    Flying rod;
    BodyDef def;
    def.type = BodyType::static_;
    def.position = {0.7, 998, 0};
    add_body(rod.world, Box{}, def, surface(0.5f));
    const float fall = 9.81f * dt; // speed gained per step, m/s
    float right = rod.world.body(rod.right).linear_velocity().y, left = right;
    bool is_stopped = false;
    for (int i = 0; i < 60 && !is_stopped; ++i) {
        rod.world.step(dt);
        const float right_now = rod.world.body(rod.right).linear_velocity().y;
        const float left_now = rod.world.body(rod.left).linear_velocity().y;
        is_stopped = right_now > right - fall + 0.5f;
        EXPECT_EQ(is_stopped, left_now > left - fall + 0.05f) << i;
        right = right_now, left = left_now;
    }
    EXPECT_TRUE(is_stopped);
}

TEST(JointedFall, EndsWhereAHalfIsPutElsewhere) {
    Flying rod;
    rod.world.body(rod.left).set_position(rod.world.body(rod.left).position() + Position(0, 0, 0.1));
    EXPECT_GT(rod.world.joint_state(rod.joint).linear_error, 0.09f);
    run(rod.world, dt, 4);
    EXPECT_LT(rod.world.joint_state(rod.joint).linear_error, 0.02f);
}

TEST(JointedFall, EndsWhereAMotorIsSwitchedOn) {
    Flying rod(HingeJoint{});
    HingeJoint driven;
    driven.angle.motor = JointMotor{};
    driven.angle.motor->velocity = 2;
    rod.world.set_joint(rod.joint, driven);
    run(rod.world, dt, 10);
    const float turn = rod.world.body(rod.right).angular_velocity().z - rod.world.body(rod.left).angular_velocity().z;
    EXPECT_NEAR(turn, 2, 0.02);
}

// A rotation as slow as rounding errors leaves the joint unsolved for a few steps only.
TEST(JointedFall, DoesNotLetAJointTwist) {
    WorldDef weightless = without_sleep();
    weightless.gravity = {0, 0, 0};
    Flying rod(FixedJoint{}, weightless);
    rod.world.body(rod.left).set_angular_velocity({1.5e-4f, 0, 0});
    run(rod.world, dt, 600);
    EXPECT_LT(rod.world.joint_state(rod.joint).angular_error, 2e-5f); // it would be 1.5e-3 if the joint were not solved
}

TEST(JointedFall, GoesOnFromASnapshotAsItWould) {
    Flying rod;
    run(rod.world, dt, 3);
    const Snapshot saved = rod.world.save();
    run(rod.world, dt, 20);
    const auto hash = rod.world.state_hash();
    rod.world.restore(saved);
    run(rod.world, dt, 20);
    EXPECT_EQ(rod.world.state_hash(), hash);
}

} // namespace
} // namespace cairn_test
