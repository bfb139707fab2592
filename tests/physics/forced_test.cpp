// A body that a force or joint accelerates within a step beyond the speed limit of the world is still stopped by
// obstacles.
#include "support.h"

#include "validation/random_starts.h"

#include <cmath>

namespace cairn_test {
namespace {

enum class By { force_in_the_air, force_on_the_floor, servo };

// Expects a wall of 10 cm, 2 to 25 m ahead in a random direction, to stop a body.
void expect_stopped(By by) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        RandomStart random(seed);
        WorldDef def = without_sleep();
        def.gravity = by == By::force_on_the_floor ? Vec3(random.turned({0, -9.81, 0})) : Vec3{};
        World world(def);
        const auto at = [&](const glm::dvec3& place, BodyType type) {
            BodyDef body;
            body.type = type, body.position = random.place(place), body.rotation = random.quat();
            return body;
        };
        const double distance = random.uniform(2, 25);
        add_body(world, Box{Vec3(0.05f, 50, 50)}, at({distance, 0, 0}, BodyType::static_), surface(0.5f));
        if (by == By::force_on_the_floor)
            add_body(world, Box{Vec3(50, 0.5f, 50)}, at({0, -0.75, 0}, BodyType::static_), surface(0.5f));
        const BodyId box = add_body(world, Box{Vec3(0.25f)}, at({0, 0, 0}, BodyType::dynamic), surface(0.5f));
        for (int i = 0; i < 3; ++i) world.step(1.0f / 60);
        const double mass = double(world.body(box).mass());
        if (by == By::servo) {
            JointDef joint;
            joint.body_b = box;
            joint.frame_a.position = random.place({0, 0, 0}), joint.frame_a.rotation = random.quat();
            ServoJoint servo;
            servo.linear = JointSpring::from_frequency(float(random.uniform(10, 20)), 1);
            servo.max_torque = 0;
            servo.position = {float(random.uniform(90, 200)), 0, 0};
            joint.joint = servo;
            world.create_joint(joint);
        } else {
            const double speed = std::exp(random.uniform(std::log(1500), std::log(1e6))); // m/s, without the wall
            world.body(box).add_force(Vec3(random.turned({mass * speed * 60, 0, 0})));
        }
        world.step(1.0f / 60);
        const Position now = world.body(box).position() - random.place({0, 0, 0});
        EXPECT_LT(glm::dot(now, random.turned({1, 0, 0})), distance - 0.05 - 0.24) << seed;
    }
}

TEST(Forced, AForceInTheAirLeadsThroughNoWall) { expect_stopped(By::force_in_the_air); }
TEST(Forced, AForceOnTheFloorLeadsThroughNoWall) { expect_stopped(By::force_on_the_floor); }
TEST(Forced, AServoLeadsThroughNoWall) { expect_stopped(By::servo); }

} // namespace
} // namespace cairn_test
