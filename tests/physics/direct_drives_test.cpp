// Servos, motors, friction, soft limits and impacts of joints in the direct solver: light bodies between heavy ones
// must not degrade the result.
#include "support.h"
#include "validation/random_starts.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cairn_test {
namespace {

// A serial arm of 4 to 10 links of 20 cm, connected by hinges about random axes. The first link has 10 kg, the others
// down to 10 kg / `mass_ratio`.
struct Arm {
    World world;
    std::vector<BodyId> links;
    std::vector<JointId> joints;

    template <class MakeHinge>
    Arm(RandomStart& start, double mass_ratio, bool lands, double spin, double fall, MakeHinge&& make_hinge)
        : world(lands ? without_sleep() : without_gravity()) {
        if (lands) add_ground(world);
        const int count = 4 + int(start.uniform(0, 7));
        const Quat lean = glm::angleAxis(float(start.uniform(0, 1.5)),
                                         glm::normalize(Vec3(start.uniform(-1, 1), 0.01, start.uniform(-1, 1))));
        const auto place = [&](double along) {
            return Position(0, 1 + 0.15 * count, 0) + Position(lean * Vec3(0, 0.3 * along, 0));
        };
        for (int i = 0; i < count; ++i) {
            BodyDef def;
            def.position = place(i);
            def.rotation = lean;
            def.mass = float(i == 0 ? 10 : 10 / std::pow(mass_ratio, start.uniform(0, 1)));
            def.linear_velocity = Vec3(0, -fall, 0);
            def.angular_velocity =
                Vec3(start.uniform(-spin, spin), start.uniform(-spin, spin), start.uniform(-spin, spin));
            links.push_back(add_body(world, Capsule{0.1f, 0.05f, {}}, def));
            if (i == 0) continue;
            const Vec3 axis(start.uniform(-1, 1), start.uniform(-1, 1), start.uniform(-1, 1.01));
            joints.push_back(world.create_joint(world.joint_at(links[std::size_t(i) - 1], links.back(), place(i - 0.5),
                                                               glm::normalize(axis), make_hinge())));
        }
    }

    // `stored` (angle): the energy in the spring of a joint, J.
    template <class Stored> double energy(Stored&& stored) const {
        double sum = world.kinetic_energy() + world.potential_energy();
        for (const JointId joint : joints) sum += stored(double(world.joint_state(joint).positions[0]));
        return sum;
    }
    // The greatest increase of the energy within 3 s, as a fraction of the initial energy above the ground.
    template <class Stored> double gain(Stored&& stored) {
        double least = energy(stored), most = 0;
        const double all = least;
        for (int i = 0; i < 180; ++i) {
            world.step(1.0f / 60);
            const double now = energy(stored);
            least = std::min(least, now);
            most = std::max(most, (now - least) / all);
        }
        return most;
    }
};

// `hinge_of` (spring): makes the hinge. `stretch` (angle): the deflection of its spring, rad.
template <class HingeOf, class Stretch> void expect_no_gains(HingeOf&& hinge_of, Stretch&& stretch, double bar) {
    for (const double stiffness : {1e2, 1e3, 1e4, 1e5})
        for (const double mass_ratio : {3.0, 30.0, 300.0})
            for (const bool lands : {false, true}) {
                double worst = 0;
                for (std::uint32_t seed = 0; seed < 8; ++seed) {
                    RandomStart start(seed);
                    const double damping = stiffness * start.uniform(0.01, 0.1);
                    Arm arm(start, mass_ratio, lands, lands ? 0 : 5, lands ? start.uniform(0, 4) : 0, [&] {
                        return hinge_of(JointSpring{float(stiffness), float(damping), false});
                    });
                    worst = std::max(worst, arm.gain([&](double angle) {
                        return 0.5 * stiffness * stretch(angle) * stretch(angle);
                    }));
                }
                EXPECT_LT(worst, bar) << stiffness << " N m/rad, masses 1 : " << mass_ratio << (lands ? ", lands" : "");
            }
}

// With each servo as a constraint row of its own, which acts on its two bodies alone and rotates the light link next to
// it by far too much, such arms gained up to 1e8 times their energy.
TEST(DirectDrives, ArmsOfServosGainNothing) {
    const auto servo = [](const JointSpring& spring) {
        HingeJoint hinge;
        hinge.angle.motor.emplace().spring = spring;
        return hinge;
    };
    expect_no_gains(
        servo, [](double angle) { return angle; }, 0.01);
}

// With each soft limit as a constraint row of its own, such arms gained up to 1e8 times their energy.
TEST(DirectDrives, ArmsOfSoftLimitsGainNothing) {
    const auto limited = [](const JointSpring& spring) {
        HingeJoint hinge;
        hinge.angle.limits = JointRange{-0.2f, 0.2f, spring};
        return hinge;
    };
    expect_no_gains(
        limited, [](double angle) { return std::max(std::fabs(angle) - 0.2, 0.0); }, 0.15);
}

JointLimit locked(JointAxis kind, std::array<bool, 3> axes) {
    JointLimit limit;
    limit.kind = kind;
    limit.axes = axes;
    limit.min = limit.max = 0.0f;
    return limit;
}
JointDrive spring_about(int axis, float stiffness, float damping) {
    JointDrive drive;
    drive.kind = JointAxis::angular;
    drive.axis = axis;
    drive.stiffness = stiffness;
    drive.damping = damping;
    return drive;
}

// Like the hips and shoulders of robots in USD files: one rotation of the joint is locked, servos act about one or both
// of the others. With the lock as a constraint row of its own, a third of the starts gained up to 2e7 times their
// energy.
TEST(DirectDrives, ServosBesideALockGainNothing) {
    for (int lock = 0; lock < 3; ++lock)
        for (int drives = 1; drives < 3; ++drives)
            for (std::uint32_t seed = 0; seed < 8; ++seed) {
                RandomStart start(seed);
                const auto some = [&](double most) { return float(start.uniform(-most, most)); };
                World world(without_gravity());
                BodyId last;
                for (int i = 0; i < 4; ++i) {
                    BodyDef def;
                    def.position = {0.3 * i, 0, 0};
                    def.mass = float(start.uniform(1, 5));
                    def.angular_velocity = Vec3(some(0.1), some(0.1), some(0.1));
                    const BodyId link = add_body(world, Box{{0.14f, 0.05f, 0.07f}}, def);
                    if (i > 0) {
                        GeneralJoint general;
                        general.limits = {locked(JointAxis::linear, {true, true, true}),
                                          locked(JointAxis::angular, {lock == 0, lock == 1, lock == 2})};
                        for (int axis = 0; axis < 3 && int(general.drives.size()) < drives; ++axis)
                            if (axis != lock) general.drives.push_back(spring_about(axis, 570, 280));
                        JointDef joint =
                            world.joint_at(last, link, {0.3 * i - 0.15, 0, 0},
                                           glm::normalize(Vec3(some(1), some(1), 1.01f + some(1))), general);
                        joint.solver = JointSolver::direct;
                        world.create_joint(joint);
                    }
                    last = link;
                }
                const double all = world.kinetic_energy();
                double least = all, gain = 0;
                for (int i = 0; i < 300; ++i) {
                    world.step(1.0f / 60);
                    least = std::min(least, world.kinetic_energy());
                    gain = std::max(gain, world.kinetic_energy() - least);
                }
                EXPECT_LT(gain, 1e-3 * all) << "lock " << lock << ", " << drives << " drives, start " << seed;
            }
}

// A ball on torsion springs about one to three axes of its joint, rotated by up to half a turn. With spring torques
// along the axes themselves, energy grew by a factor of up to 8.6, at any step length.
TEST(GeneralSprings, AboutAnyAxesKeepTheEnergy) {
    for (const JointSolver solver : {JointSolver::iterative, JointSolver::direct})
        for (int drives = 1; drives <= 3; ++drives)
            for (std::uint32_t seed = 0; seed < 12; ++seed) {
                RandomStart start(seed);
                World world(without_gravity());
                BodyDef fixed;
                fixed.type = BodyType::static_;
                BodyDef def;
                def.mass = 2.0f;
                def.angular_velocity = Vec3(start.uniform(-2, 2), start.uniform(-2, 2), start.uniform(-2, 2));
                GeneralJoint general;
                general.limits = {locked(JointAxis::linear, {true, true, true})};
                for (int axis = 0; axis < drives; ++axis) general.drives.push_back(spring_about(axis, 0.1f, 0));
                JointDef joint = world.joint_at(world.create_body(fixed), add_body(world, Sphere{0.3f}, def), {0, 0, 0},
                                                {1, 0, 0}, general);
                joint.solver = solver;
                const JointId id = world.create_joint(joint);
                const double all = world.kinetic_energy();
                for (int i = 0; i < 600; ++i) {
                    world.step(1.0f / 60);
                    double now = world.kinetic_energy();
                    for (int axis = 0; axis < drives; ++axis) {
                        const double angle = double(world.joint_state(id).positions[std::size_t(axis)]);
                        now += 0.05 * angle * angle;
                    }
                    ASSERT_NEAR(now, all, 0.04 * all) << drives << " drives, start " << seed << ", step " << i;
                }
            }
}

// A horizontal arm of three links of 40 cm on a wall; the last link has 10 kg, the others `light` kg.
struct Shelf {
    World world{without_sleep()};
    std::vector<BodyId> links;
    std::vector<JointId> joints;

    // `make_hinge` (static load torque of the hinge, N m)
    template <class MakeHinge> Shelf(double light, JointSolver solver, MakeHinge&& make_hinge) {
        BodyDef wall;
        wall.type = BodyType::static_;
        BodyId last = world.create_body(wall);
        for (int i = 0; i < 3; ++i) {
            BodyDef def;
            def.position = {0.2 + 0.4 * i, 0, 0};
            def.mass = i == 2 ? 10.0f : float(light);
            links.push_back(add_body(world, Box{{0.2f, 0.02f, 0.02f}}, def));
            double load = 0;
            for (int k = i; k < 3; ++k) load += gravity * (k == 2 ? 10 : light) * (0.2 + 0.4 * (k - i));
            JointDef joint = world.joint_at(last, links.back(), {0.4 * i, 0, 0}, {0, 0, 1}, make_hinge(load));
            joint.solver = solver;
            joints.push_back(world.create_joint(joint));
            last = links.back();
        }
    }
    double angle(std::size_t i) const { return double(world.joint_state(joints[i]).positions[0]); }
};

// With friction as a constraint row of its own, the arm flailed by up to 4 rad.
TEST(DirectDrives, FrictionHoldsWhatHangsOnALightLink) {
    for (const double light : {10.0, 1.0, 0.1, 0.01})
        for (const double part : {1.02, 1.5}) {
            Shelf shelf(light, JointSolver::direct, [&](double load) {
                HingeJoint hinge;
                hinge.angle.friction = float(part * load);
                return hinge;
            });
            for (int i = 0; i < 120; ++i) shelf.world.step(1.0f / 60);
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_LT(std::fabs(shelf.angle(i)), 1e-4) << light << " kg, " << part << " of the load, joint " << i;
        }
}

// A bob of 10 kg at r = 1 m that a motor or joint friction of at most T N m cannot hold. Falling from horizontal
// through the angle a, it has the kinetic energy m g r sin(a) - T a.
TEST(DirectDrives, GiveNoMoreThanTheyMay) {
    for (const bool is_friction : {false, true})
        for (const double light : {1.0, 0.05})
            for (const double part : {0.2, 0.6}) {
                World world(without_sleep());
                BodyDef wall;
                wall.type = BodyType::static_;
                const BodyId base = world.create_body(wall);
                BodyDef def;
                def.position = {0.25, 0, 0};
                def.mass = float(light);
                const BodyId link = add_body(world, Box{{0.2f, 0.02f, 0.02f}}, def);
                def.position = {1, 0, 0};
                def.mass = 10.0f;
                const BodyId bob = add_body(world, Sphere{0.1f}, def);
                const double most = part * gravity * 10;
                HingeJoint hinge;
                if (is_friction) {
                    hinge.angle.friction = float(most);
                } else {
                    hinge.angle.motor.emplace().spring = JointSpring{1e5f, 1e4f, false};
                    hinge.angle.motor->max_force = float(most);
                }
                JointDef joint = world.joint_at(base, link, {0, 0, 0}, {0, 0, 1}, hinge);
                joint.solver = JointSolver::direct;
                const JointId at_wall = world.create_joint(joint);
                joint = world.joint_at(link, bob, {0.5, 0, 0}, {0, 0, 1}, FixedJoint{});
                joint.solver = JointSolver::direct;
                world.create_joint(joint);
                const double start = world.kinetic_energy() + world.potential_energy();
                for (int i = 0; i < 24; ++i) {
                    world.step(1.0f / 60);
                    EXPECT_NEAR(std::fabs(double(world.joint_state(at_wall).torque.z)), most, 1e-3 * most);
                }
                const double angle = std::fabs(double(world.joint_state(at_wall).positions[0]));
                const double now = world.kinetic_energy() + world.potential_energy();
                EXPECT_NEAR(start - now, most * angle, 0.02 * most * angle) << light << " kg, " << part;
                EXPECT_GT(angle, 0.2);
            }
}

// The greatest upward speed of the mean of ten capsules, m/s: an upright chain that is dropped 2 m onto one end.
double rise_of_chain(JointSolver solver) {
    World world(without_sleep());
    add_ground(world);
    std::vector<BodyId> links;
    for (int i = 0; i < 10; ++i) {
        BodyDef def;
        def.position = {0, 2.26 + 0.5 * i, 0};
        links.push_back(add_body(world, Capsule{0.15f, 0.1f, {}}, def));
        if (i == 0) continue;
        JointDef joint =
            world.joint_at(links[links.size() - 2], links.back(), {0, 2.01 + 0.5 * i, 0}, {0, 0, 1}, BallJoint{});
        joint.solver = solver;
        world.create_joint(joint);
    }
    double rise = 0;
    for (int i = 0; i < 90; ++i) {
        world.step(1.0f / 60);
        double speed = 0;
        for (const BodyId link : links) speed += double(world.body(link).linear_velocity().y) / 10;
        rise = std::max(rise, speed);
    }
    return rise;
}

// When the passes of an impact did not include the direct solver, the chain rebounded at 3.4 to 6 m/s.
TEST(DirectImpacts, AChainThatIsDroppedLengthwiseStops) {
    EXPECT_LT(rise_of_chain(JointSolver::iterative), 0.11);
    EXPECT_LT(rise_of_chain(JointSolver::direct), 0.05);
}

// The greatest upward speed of the lowest of five upright links, m/s, which servos hold straight, after a landing at
// 2.6 m/s.
double rise_of_straight_leg(float mass_of_every_other, float dt) {
    World world(without_sleep());
    add_ground(world);
    std::vector<BodyId> links;
    for (int i = 0; i < 5; ++i) {
        BodyDef def;
        def.position = {0, 0.5 + 0.3 * i, 0};
        def.mass = i % 2 ? mass_of_every_other : 1.0f;
        links.push_back(add_body(world, Capsule{0.1f, 0.05f, {}}, def));
        if (i == 0) continue;
        HingeJoint hinge;
        hinge.angle.motor.emplace().spring = JointSpring{2000, 50, false};
        world.create_joint(
            world.joint_at(links[std::size_t(i) - 1], links.back(), {0, 0.35 + 0.3 * i, 0}, {0, 0, 1}, hinge));
    }
    double rise = 0;
    for (int i = 0; i < int(0.8f / dt); ++i) {
        world.step(dt);
        rise = std::max(rise, double(world.body(links[0]).linear_velocity().y));
    }
    return rise;
}

// With light links the lowest one rebounded at 0.6 m/s, as the leg of a humanoid from an MJCF file did.
TEST(DirectImpacts, ALegWithLightLinksStaysWhereItLands) {
    for (const float dt : {1.0f / 60, 0.005f, 0.001f})
        for (const float mass : {1.0f, 0.3f, 0.05f, 0.01f})
            EXPECT_LT(rise_of_straight_leg(mass, dt), 0.2) << mass << " kg, " << dt << " s";
}

// Arms of links with limits that land at 1 to 8 m/s. At 500 Hz, 23 of 60 gained more than 2 % of their energy.
TEST(DirectImpacts, WhatLandsGainsNothing) {
    for (std::uint32_t seed = 0; seed < 24; ++seed) {
        RandomStart start(seed);
        Arm robot(start, 30, true, 0, start.uniform(1, 8), [&] {
            HingeJoint hinge;
            hinge.angle.limits = JointRange{float(-start.uniform(0, 0.5)), float(start.uniform(0, 0.5)), {}};
            return hinge;
        });
        const double all = robot.energy([](double) { return 0.0; });
        double least = all, gain = 0;
        for (int i = 0; i < 1000; ++i) {
            robot.world.step(0.002f);
            const double now = robot.energy([](double) { return 0.0; });
            least = std::min(least, now);
            gain = std::max(gain, now - least);
        }
        EXPECT_LT(gain, 0.02 * all) << seed;
    }
}

} // namespace
} // namespace cairn_test
