// Limits of joints in the direct solver: a light body between a heavy one and its limit must not degrade the result.
#include "support.h"

#include <algorithm>
#include <random>

namespace cairn_test {
namespace {

constexpr float quarter = 0.70710678f;

JointId add_hinge(World& world, BodyId a, BodyId b, const Position& at, const Quat& frame, const JointRange& range) {
    HingeJoint hinge;
    hinge.angle.limits = range;
    JointDef def;
    def.joint = hinge;
    def.body_a = a;
    def.body_b = b;
    for (const auto& [body, transform] : {std::pair(a, &def.frame_a), std::pair(b, &def.frame_b)}) {
        const Position origin = body.is_null() ? Position(0) : world.body(body).position();
        transform->position = at - origin;
        transform->rotation = frame;
    }
    return world.create_joint(def);
}

BodyId add_solid(World& world, const Position& at, float mass, const Vec3& center, const Vec3& moments) {
    BodyDef def;
    def.position = at;
    def.mass_properties = MassProperties{};
    def.mass_properties->mass = mass;
    def.mass_properties->center_of_mass = center;
    def.mass_properties->inertia_diagonal = moments;
    return world.create_body(def);
}

double energy_of(const World& world) { return world.kinetic_energy() + world.potential_energy(); }

// The head of a public robot model (romeo): 2 kg on a ring of 0.16 kg, with a pitch joint about z and a roll joint
// about x.
struct Head {
    World world;
    BodyId ring, head;
    JointId nod, roll;

    Head() : world(without_sleep()) {
        ring = add_solid(world, {0, 0, 0}, 0.1584f, {0.0014f, -0.00462f, 0}, {2.6e-5f, 7.0e-5f, 7.4e-5f});
        head = add_solid(world, {0, 0, 0}, 2.07f, {0.01263f, 0.07498f, 0}, {0.0093f, 0.0092f, 0.011f});
        nod = add_hinge(world, {}, ring, {0, 0, 0}, Quat(quarter, 0, -quarter, 0), {-0.2571f, 0.2971f, {}});
        roll = add_hinge(world, ring, head, {0, 0, 0}, Quat(1, 0, 0, 0), {-0.4887f, 0.4887f, {}});
    }
};

// When the limit stopped the ring alone, the head gained 600 J in 5 s at 60 Hz, and 9e4 J at 240 Hz.
TEST(DirectLimits, AHeadOnALightRingStopsAtThem) {
    for (const int hertz : {60, 240, 960}) {
        Head robot;
        double least = energy_of(robot.world), gain = 0;
        for (int i = 0; i < 2 * hertz; ++i) { // later the head falls over sideways
            robot.world.step(1.0f / float(hertz));
            least = std::min(least, energy_of(robot.world));
            gain = std::max(gain, energy_of(robot.world) - least);
        }
        EXPECT_LT(gain, 1e-6) << hertz;
        EXPECT_LT(robot.world.kinetic_energy(), 1e-9) << hertz;
        EXPECT_NEAR(double(robot.world.joint_state(robot.nod).positions[0]), -0.2571, 1e-4) << hertz;
    }
}

TEST(DirectLimits, GiveTheTorqueOfWhatTheyBear) {
    Head robot;
    run(robot.world, 1.0f / 60, 120);
    double moment = 0; // torque of the weights about z, N m
    for (const BodyId body : {robot.ring, robot.head}) {
        moment +=
            double(robot.world.body(body).mass_properties().mass) * gravity * robot.world.body(body).center_of_mass().x;
    }
    EXPECT_NEAR(double(robot.world.joint_state(robot.nod).torque.z), moment, 0.001 * moment);
}

// Arms of six links with mass ratios of up to 1,000 that swing between their limits. When limits acted on one body
// alone, such arms gained up to 4e8 times their energy.
TEST(DirectLimits, ArmsThatAreThrownAgainstThemGainNothing) {
    std::mt19937 dice(5);
    const auto random = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(dice); };
    double worst = 0;
    for (int arm = 0; arm < 24; ++arm) {
        WorldDef settings = without_sleep();
        settings.gravity = {0, 0, 0};
        World world(settings);
        BodyId last;
        for (int i = 0; i < 6; ++i) {
            const float mass = float(std::pow(10.0, random(-1.5, 1.5))), across = mass * 0.04f / 12;
            const Position at{0.2 * i + 0.1, 0, 0};
            const BodyId link = add_solid(world, at, mass, {0, 0, 0}, {0.1f * across, across, across});
            const float angle = float(random(0, 3));
            const Quat frame = glm::normalize(Quat(std::cos(angle), 0, -std::sin(angle), 0.3f));
            add_hinge(world, last, link, {0.2 * i, 0, 0}, frame,
                      {float(-random(0.1, 0.8)), float(random(0.1, 0.8)), {}});
            last = link;
        }
        world.body(last).set_linear_velocity({0, float(random(-3, 3)), float(random(-3, 3))});
        world.step(1.0f / 60);
        double least = energy_of(world);
        const double start = least;
        for (int i = 0; i < 300; ++i) {
            world.step(1.0f / 60);
            worst = std::max(worst, (energy_of(world) - least) / start);
            least = std::min(least, energy_of(world));
        }
    }
    EXPECT_LT(worst, 0.005);
}

TEST(DirectLimits, SameBitsFromSnapshots) {
    Head robot;
    run(robot.world, 1.0f / 60, 25); // by now a limit is active
    const Snapshot snapshot = robot.world.save();
    run(robot.world, 1.0f / 60, 60);
    const std::uint64_t hash = robot.world.state_hash();
    World again(without_sleep());
    again.restore(snapshot);
    run(again, 1.0f / 60, 60);
    EXPECT_EQ(again.state_hash(), hash);
}

} // namespace
} // namespace cairn_test
