// Machines that accelerate slowly must not fall asleep, although the momenta of their parts, which move against each
// other or rotate about a fixed point, add up to zero. The motion of a cam follower has a closed form.
#include "support.h"

#include "validation/random_starts.h"

#include <cmath>

namespace cairn_test {
namespace {

constexpr float dt = 1.0f / 60;

// Hangs two balls on a rope over two rollers; returns the left one.
BodyId hang_balls(World& world, double left_mass, double right_mass) {
    BodyDef def;
    def.position = {-0.5, 0, 0};
    def.mass = float(left_mass);
    const BodyId left = add_body(world, Sphere{0.1f}, def);
    def.position = {0.5, 0, 0};
    def.mass = float(right_mass);
    const BodyId right = add_body(world, Sphere{0.1f}, def);
    PulleyJoint pulley;
    pulley.ground_a = {-0.5, 5, 0};
    pulley.ground_b = {0.5, 5, 0};
    JointDef joint;
    joint.body_a = left;
    joint.body_b = right;
    joint.joint = pulley;
    world.create_joint(joint);
    return left;
}

// Two balls of nearly equal mass accelerate at 0.05 to 0.1 m/s^2.
TEST(SlowMachines, AnAtwoodMachineGoesOn) {
    RandomStart random(5);
    for (int i = 0; i < 24; ++i) {
        World world;
        const double mass = random.uniform(1, 50), difference = random.uniform(0.005, 0.01);
        const Body heavy = world.body(hang_balls(world, mass * (1 + difference), mass * (1 - difference)));
        run(world, dt, 180);
        EXPECT_TRUE(heavy.is_awake()) << i;
        EXPECT_NEAR(heavy.position().y / (-0.5 * difference * 9.80665 * 9), 1, 0.02) << i;
    }
}

// A flywheel with a weak motor: its rim accelerates at 0.05 to 0.1 m/s^2.
TEST(SlowMachines, AFlywheelComesUpToSpeed) {
    RandomStart random(6);
    for (int i = 0; i < 24; ++i) {
        World world;
        const double radius = random.uniform(0.2, 2), gain = random.uniform(0.05, 0.1);
        BodyDef def;
        def.mass = 10.0f;
        def.rotation = glm::angleAxis(float(pi / 2), Vec3(1, 0, 0));
        const BodyId wheel = add_body(world, Cylinder{0.1f, float(radius)}, def);
        HingeJoint hinge;
        hinge.angle.motor = JointMotor{};
        hinge.angle.motor->velocity = 10;
        hinge.angle.motor->max_force = float(0.5 * 10 * radius * gain); // I a / r, I = m r^2 / 2
        world.create_joint(world.joint_at({}, wheel, {0, 0, 0}, {0, 0, 1}, hinge));
        run(world, dt, 240);
        EXPECT_TRUE(world.body(wheel).is_awake()) << i;
        EXPECT_NEAR(double(world.body(wheel).angular_velocity().z) * radius / (4 * gain), 1, 0.02) << i;
    }
}

// A round kinematic disk rotates about a point off its center, and gravity presses a flat plate onto it. The height of
// the plate follows from the center of the disk and its radius.
TEST(SlowMachines, ACamLiftsItsFollower) {
    for (int i = 0; i < 24; ++i) {
        RandomStart start(std::uint32_t(200 + i));
        World world(with_turned_gravity(start));
        const double radius = start.uniform(0.1, 0.5), beside = radius * start.uniform(0.1, 0.5),
                     rate = std::sqrt(gravity / beside * start.uniform(0.02, 0.4)), up = radius + 0.05;
        BodyDef def;
        def.type = BodyType::kinematic;
        def.position = start.place({0, 0, 0});
        def.rotation = start.quat();
        def.angular_velocity = Vec3(start.turned({0, 0, rate}));
        const Body cam = world.body(world.create_body(def));
        ShapeDef shape;
        shape.position = {float(beside), 0, 0};
        shape.rotation = glm::angleAxis(float(pi / 2), Vec3(1, 0, 0));
        shape.material = surface(0.1f);
        world.add_shape(cam.id(), Cylinder{.half_height = 0.1f, .radius = float(radius)}, shape);
        def = {};
        def.position = start.place({0, up, 0});
        def.rotation = start.quat();
        const Body follower = world.body(add_body(world, Box{Vec3(2 * beside, 0.05, 0.1)}, def, surface(0.1f)));
        world.create_joint(
            world.joint_at({}, follower.id(), def.position, Vec3(start.turned({0, 1, 0})), SliderJoint{}));
        for (int k = 1; k <= 300; ++k) {
            world.step(dt);
            const double height = start.back(Vec3(follower.position() - start.place({0, 0, 0}))).y;
            ASSERT_NEAR(height, up + beside * std::sin(rate * k / 60), 2e-4) << i << ", step " << k;
        }
    }
}

// A machine in balance does fall asleep.
TEST(SlowMachines, BalancedOnesRest) {
    World world;
    const Body ball = world.body(hang_balls(world, 5, 5));
    run(world, dt, 120);
    EXPECT_FALSE(ball.is_awake());
}

} // namespace
} // namespace cairn_test
