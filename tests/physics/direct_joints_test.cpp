// Joints in the direct solver: loads on chains, bridges and machines. Unless a test says otherwise, the engine chooses
// the solver of each joint. docs/decisions/direct_joints.md has the rule and the numbers.
#include "starts.h"
#include "support.h"
#include "validation/joined_worlds.h"

#include <algorithm>
#include <limits>

using namespace cairn;
using namespace cairn_test;

namespace {

constexpr float dt = 1.0f / 60;

double peak_gap(World& world, double seconds) {
    double peak = 0;
    for (int i = 0; i < int(seconds / double(dt)) && std::isfinite(peak); ++i) {
        world.step(dt);
        const double gap = greatest_gap(world);
        peak = std::isfinite(gap) ? std::max(peak, gap) : gap;
    }
    return peak;
}

class HeavyChain : public testing::TestWithParam<float> {};

// Measured gaps of the joints: 0.066 mm with 1,000 kg, 0.006 mm with 100,000 kg.
TEST_P(HeavyChain, SwingsWithoutStretching) {
    World world(without_sleep());
    const Chain chain = add_chain(world, 20, GetParam());
    world.body(chain.ball).set_linear_velocity({5, 0, 0});
    const double energy = world.kinetic_energy() + world.potential_energy();
    const double swing = world.kinetic_energy();
    EXPECT_LT(peak_gap(world, 40), 0.001);
    const double change = world.kinetic_energy() + world.potential_energy() - energy;
    EXPECT_LT(change, 0); // measured: -0.4 and -3.0 %
    EXPECT_GT(change, -0.05 * swing);
}
INSTANTIATE_TEST_SUITE_P(Physics, HeavyChain, testing::Values(1000.0f, 100000.0f));

// Measured sag: 0.0000 mm; in the iterative solver the same cantilever sags by 30 cm.
TEST(DirectJoints, CantileverOfFixedJointsDoesNotSag) {
    World world(without_sleep());
    BodyId last;
    JointId first;
    for (int i = 0; i < 10; ++i) {
        const BodyId box = add_dynamic(world, Box{{0.5f, 0.5f, 0.5f}}, {i + 0.5, 0, 0}, 1000);
        const JointId joint = hold(world, last, box, {double(i), 0, 0}, FixedJoint{});
        if (i == 0) first = joint;
        last = box;
    }
    double sag = 0;
    for (int i = 0; i < 600; ++i) {
        world.step(dt);
        sag = std::max(sag, std::fabs(world.body(last).position().y));
    }
    EXPECT_LT(sag, 0.001);
    const double weight = 10 * 1000 * gravity;
    EXPECT_NEAR(double(world.joint_state(first).force.y), weight, 1e-3 * weight);
    EXPECT_NEAR(double(world.joint_state(first).torque.z), 5 * weight, 1e-3 * weight);
}

// 24 bodies in two columns, which close 11 loops. Measured gaps: 0.002 mm, and 0.07 mm with 100 kg at the lower ends.
TEST(DirectJoints, LadderHoldsTogether) {
    for (const float end_mass : {1.0f, 100.0f}) {
        World world(without_sleep());
        BodyId columns[2];
        for (int i = 0; i < 12; ++i) {
            BodyId rung[2];
            for (int side = 0; side < 2; ++side) {
                rung[side] = add_dynamic(world, Sphere{0.4f}, {double(side), -(i + 1.0), 0}, i == 11 ? end_mass : 1.0f);
                hold(world, columns[side], rung[side], {double(side), -i - 0.5, 0}, BallJoint{});
                columns[side] = rung[side];
            }
            hold(world, rung[0], rung[1], {0.5, -(i + 1.0), 0}, BallJoint{});
        }
        for (const BodyId body : columns) world.body(body).set_linear_velocity({2, 0, 1});
        EXPECT_LT(peak_gap(world, 20), 0.001) << end_mass;
    }
}

// A bridge of 50 planks of 10 kg along a circular arc between two fixed points; `middle` is the point for a load.
struct Bridge {
    std::vector<BodyId> planks;
    Position middle;
};
Bridge add_bridge(World& world) {
    constexpr int count = 50;
    constexpr double plank = 0.5, half_turn = 0.426; // sin(half_turn) / half_turn = 0.97
    const double radius = count * plank / (2 * half_turn);
    auto point = [&](int i) {
        const double angle = half_turn * (2.0 * i / count - 1);
        return Position(radius * std::sin(angle), -radius * (std::cos(angle) - std::cos(half_turn)), 0);
    };
    Bridge bridge;
    BodyId last;
    for (int i = 0; i < count; ++i) {
        const Position a = point(i), b = point(i + 1);
        bridge.planks.push_back(
            add_dynamic(world, Box{{0.24f, 0.05f, 1}}, 0.5 * (a + b), 10, float(std::atan2(b.y - a.y, b.x - a.x))));
        hold(world, last, bridge.planks.back(), a, HingeJoint{});
        last = bridge.planks.back();
    }
    hold(world, last, BodyId{}, point(count), HingeJoint{});
    bridge.middle = point(count / 2);
    return bridge;
}

TEST(DirectJoints, BridgeCarriesAHundredPlanks) {
    World world(without_sleep());
    const Bridge bridge = add_bridge(world);
    const BodyId load = add_dynamic(world, Sphere{0.5f}, bridge.middle - Position(0, 1, 0), 1000);
    hold(world, bridge.planks[25], load, bridge.middle, BallJoint{});
    EXPECT_LT(peak_gap(world, 20), 0.005);
}

// A ball of 1,000 kg lies somewhere on the bridge. When contacts and joints used different inertias for the planks, the
// joints opened by 8 to 17 mm.
TEST(DirectJoints, BridgeCarriesAHeavyBall) {
    Starts random(1);
    for (int start = 0; start < 12; ++start) {
        World world(without_sleep());
        const Bridge bridge = add_bridge(world);
        const Position at = bridge.middle + Position(random.between(-2, 2), 0.56, 0);
        const BodyId ball = add_dynamic(world, Sphere{0.5f}, at, 1000);
        EXPECT_LT(peak_gap(world, 5), 0.001);               // measured: 0.13 mm
        EXPECT_GT(world.body(ball).position().y, at.y - 1); // it rolls to and fro, and stays on the bridge
    }
}

// A box or a ball falls half a meter onto a taut rope of 16 links of half a kilogram. When contacts and joints used
// different inertias for the links, and tension acted on them half a substep late, 123 of 200 boxes of 10 kg gained
// energy, up to 1e7 J, and joints opened by up to 900 m.
class TautRope : public testing::TestWithParam<float> {};

TEST_P(TautRope, IsNoSlingshot) {
    constexpr int links = 16, starts = 24;
    constexpr double length = 0.3, slope = 0.1; // m, rad: of the first link
    Starts random(1);
    int gains = 0;
    double widest = 0;
    for (int start = 0; start < starts; ++start) {
        World world;
        Position end{};
        BodyId last;
        for (int i = 0; i < links; ++i) {
            const double angle = slope * ((2 * i + 1.0) / links - 1);
            const Position next = end + length * Position(std::cos(angle), std::sin(angle), 0);
            const BodyId link = add_dynamic(world, Capsule{0.13f, 0.02f, {}}, 0.5 * (end + next), 0.5f,
                                            float(angle) - glm::half_pi<float>());
            hold(world, last, link, end, BallJoint{});
            last = link, end = next;
        }
        hold(world, last, BodyId{}, end, BallJoint{});
        const Position at(0.5 * end.x + random.between(-0.1, 0.1), 0.5, random.between(-0.02, 0.02));
        if (start % 2 == 0)
            add_dynamic(world, Box{{0.15f, 0.15f, 0.15f}}, at, GetParam());
        else
            add_dynamic(world, Sphere{0.2f}, at, GetParam());
        const double energy = world.kinetic_energy() + world.potential_energy();
        double most = energy;
        for (int i = 0; i < 240; ++i) {
            world.step(dt);
            most = std::max(most, world.kinetic_energy() + world.potential_energy());
            widest = std::max(widest, greatest_gap(world));
        }
        gains += most > energy + 0.02 * double(GetParam()) * gravity;
    }
    EXPECT_LE(gains, 1);
    EXPECT_LT(widest, 0.3);
}
INSTANTIATE_TEST_SUITE_P(DirectJoints, TautRope, testing::Values(10.0f, 30.0f));

// Three links in a straight line between fixed points, one of which spins about it. With lever arms of the start of a
// substep, which the spin has left half a substep later, all of these gained energy from 100 rad/s on.
TEST(DirectJoints, TautChainsBearALinkThatSpins) {
    Starts random(1);
    for (const double spin : {30.0, 100.0, 300.0, 900.0})
        for (int start = 0; start < 12; ++start) {
            World world(without_sleep());
            const glm::dquat turn = glm::angleAxis(random.between(-0.2, 0.2), glm::dvec3(1, 0, 0)) *
                                    glm::angleAxis(random.between(-0.2, 0.2), glm::dvec3(0, 0, 1));
            const Position down = turn * glm::dvec3(0, -1, 0);
            BodyId last;
            for (int i = 0; i < 3; ++i) {
                BodyDef def;
                def.position = (0.4 * i + 0.2) * down;
                def.rotation = Quat(turn);
                if (i == start % 3) def.angular_velocity = Vec3(spin * down);
                const BodyId link = world.create_body(def);
                world.add_shape(link, start % 2 == 0 ? Shape(Capsule{0.17f, 0.03f, {}}) : Box{{0.03f, 0.19f, 0.06f}});
                hold(world, last, link, (0.4 * i) * down, BallJoint{}, JointSolver::direct);
                last = link;
            }
            hold(world, last, BodyId{}, 1.2 * down, BallJoint{}, JointSolver::direct);
            const double energy = world.kinetic_energy() + world.potential_energy();
            EXPECT_LT(peak_gap(world, 5), 1e-4) << spin;
            const double change = world.kinetic_energy() + world.potential_energy() - energy;
            EXPECT_LT(std::fabs(change), 0.01 * world.kinetic_energy()) << spin;
        }
}

// A rotating kinematic hub of 1 m swings a chain around. With the hub's arm of the start of a substep the joints opened
// by 2.1 to 2.5 mm.
TEST(DirectJoints, ChainsOnARotatingHubHold) {
    constexpr double speed = 30, length = 0.3; // rad/s, m
    for (const int links : {1, 6}) {
        World world(without_sleep());
        BodyDef hub;
        hub.type = BodyType::kinematic;
        hub.angular_velocity = {0, float(speed), 0};
        BodyId last = world.create_body(hub);
        const auto add_link = [&](const Shape& shape, double at, double joint, float mass) {
            const BodyId link = add_dynamic(world, shape, {at, 0, 0}, mass, glm::half_pi<float>());
            world.body(link).set_linear_velocity({0, 0, float(-speed * at)});
            world.body(link).set_angular_velocity({0, float(speed), 0});
            hold(world, last, link, {joint, 0, 0}, BallJoint{}, JointSolver::direct);
            last = link;
        };
        for (int i = 0; i < links; ++i)
            add_link(Capsule{0.12f, 0.02f, {}}, 1 + (i + 0.5) * length, 1 + i * length, 0.5f);
        add_link(Sphere{0.1f}, 1.1 + links * length, 1 + links * length, 5);
        EXPECT_LT(peak_gap(world, 5), 1e-3) << links; // measured: 0.4 to 0.7 mm
    }
}

class BothSolvers : public testing::TestWithParam<JointSolver> {};

// The force that a joint reports equals the weight that hangs on it.
TEST_P(BothSolvers, ForceIsTheWeight) {
    World world(without_sleep());
    const Chain chain = add_chain(world, 3, 7, {}, 0, GetParam());
    run(world, dt, 120);
    const std::vector<JointId> joints = world.joints();
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const JointState state = world.joint_state(joints[i]);
        const double weight = (3.0 - double(i) + 7) * gravity;
        EXPECT_NEAR(double(state.force.y), weight, 1e-3 * weight);
        EXPECT_LT(glm::length(state.torque), 1e-3);
    }
}
TEST_P(BothSolvers, BreaksBeyondItsStrength) {
    World world(without_sleep());
    const Chain chain = add_chain(world, 2, 7, {}, 0, GetParam());
    run(world, dt, 60);
    const JointId top = world.joints()[0];
    world.set_joint_strength(top, float(1.1 * 9 * gravity), std::numeric_limits<float>::infinity());
    run(world, dt, 60);
    ASSERT_TRUE(world.is_valid(top));
    world.set_joint_strength(top, float(0.9 * 9 * gravity), std::numeric_limits<float>::infinity());
    run(world, dt, 2);
    EXPECT_FALSE(world.is_valid(top));
}

// A motor, which stays in the iterative solver, rotates the first of two arms against gravity, and a limit stops the
// second.
TEST_P(BothSolvers, MotorsAndLimitsWorkBesides) {
    World world(without_sleep());
    const BodyId upper = add_dynamic(world, Box{{0.5f, 0.1f, 0.1f}}, {0.5, 0, 0}, 1);
    const BodyId lower = add_dynamic(world, Box{{0.5f, 0.1f, 0.1f}}, {1.5, 0, 0}, 1);
    HingeJoint driven, limited;
    driven.angle.motor = JointMotor{};
    driven.angle.motor->velocity = 0.5f;
    limited.angle.limits = JointRange{-0.25f, 0.25f, {}};
    const JointId motor = hold(world, BodyId{}, upper, {0, 0, 0}, driven, GetParam());
    const JointId limit = hold(world, upper, lower, {1, 0, 0}, limited, GetParam());
    run(world, dt, 120);
    EXPECT_NEAR(double(world.joint_state(motor).positions[0]), 1.0, 0.03);
    EXPECT_NEAR(double(world.joint_state(limit).positions[0]), -0.25, 0.01);
    EXPECT_LT(greatest_gap(world), 0.002);
}

std::string solver_name(const testing::TestParamInfo<JointSolver>& info) {
    return info.param == JointSolver::direct ? "Direct" : "Iterative";
}
INSTANTIATE_TEST_SUITE_P(Physics, BothSolvers, testing::Values(JointSolver::iterative, JointSolver::direct),
                         solver_name);

// Joints with every kind of locked row in one chain behind a kinematic body, all in the direct solver: none of them
// gives way.
TEST(DirectJoints, EveryKindOfLockHolds) {
    World world(without_sleep());
    const Joint kinds[] = {HingeJoint{}, UniversalJoint{}, SliderJoint{},
                           FixedJoint{}, BallJoint{},      CylindricalJoint{}};
    DistanceJoint rod;
    rod.distance.limits = JointRange{1, 1, {}};
    BodyDef carrier;
    carrier.type = BodyType::kinematic;
    carrier.linear_velocity = {0.3f, 0, 0};
    BodyId last = world.create_body(carrier);
    double x = 0;
    for (const Joint& kind : kinds) {
        const BodyId body = add_dynamic(world, Box{{0.5f, 0.2f, 0.2f}}, {x + 0.5, 0, 0}, 3);
        JointDef def = world.joint_at(last, body, {x, 0, 0}, {0, 1, 0}, kind);
        def.solver = JointSolver::direct;
        world.create_joint(def);
        last = body;
        x += 1;
    }
    const BodyId bob = add_dynamic(world, Sphere{0.2f}, {x + 1, 0, 0}, 5);
    JointDef def = world.joint_at(last, bob, {x, 0, 0}, {0, 1, 0}, rod);
    def.frame_b.position = {0, 0, 0};
    def.solver = JointSolver::direct;
    world.create_joint(def);
    for (int i = 0; i < 300; ++i) {
        world.step(dt);
        for (const JointId joint : world.joints()) {
            EXPECT_LT(world.joint_state(joint).linear_error, 0.002f);
            EXPECT_LT(world.joint_state(joint).angular_error, 0.002f);
        }
        EXPECT_NEAR(double(world.joint_state(world.joints().back()).positions[0]), 1, 0.002);
    }
}

// The energy, J, that a table of 2 kg at rest gains in 4 s. It stands on four legs of two links each, with all joints
// locked.
double gain_of_table(float upper, float lower, JointSolver solver) {
    World world(without_sleep());
    add_ground(world, surface(0.6f));
    const auto body = [&](const Vec3& place, float mass, const Vec3& moments) {
        BodyDef def;
        def.position = place;
        def.mass_properties = MassProperties{};
        def.mass_properties->mass = mass;
        def.mass_properties->inertia_diagonal = moments;
        return world.create_body(def);
    };
    const float height = 0.345f, half = 0.08f; // height of the table; half length of a link
    const BodyId table = body({0, height, 0}, 2, {0.027f, 0.033f, 0.007f});
    const auto lock = [&](BodyId a, const Vec3& at_a, BodyId b) {
        JointDef def;
        def.joint = FixedJoint{};
        def.solver = solver;
        def.body_a = a;
        def.body_b = b;
        def.frame_a.position = at_a;
        def.frame_b.position = {0, half, 0};
        world.create_joint(def);
    };
    for (int i = 0; i < 4; ++i) {
        const float x = i % 2 ? 0.1f : -0.1f, z = i / 2 ? 0.2f : -0.2f;
        const auto link = [&](float y, float mass) {
            const float across = mass * half * half / 3; // moment of inertia of a rod
            return body({x, y, z}, mass, {across, 1e-5f, across});
        };
        const BodyId thigh = link(height - half, upper), shank = link(height - 3 * half, lower);
        ShapeDef foot;
        foot.position = {0, -half, 0};
        world.add_shape(shank, Sphere{0.025f}, foot);
        lock(table, {x, 0, z}, thigh);
        lock(thigh, {0, -half, 0}, shank);
    }
    const double before = world.kinetic_energy() + world.potential_energy();
    for (int i = 0; i < 240; ++i) world.step(1.0f / 60.0f);
    return world.kinetic_energy() + world.potential_energy() - before;
}

// The table hopped ever higher, by 6 J in 4 s, when the feet moved for a substep by the velocities that their contacts
// alone gave them, and the joints corrected the errors in the next one.
TEST(DirectJoints, ATableOnLegsOfLightLinksStands) {
    for (const float foot : {0.5f, 0.1f, 0.03f, 0.005f})
        EXPECT_LT(gain_of_table(std::max(foot, 0.16f), foot, JointSolver::direct), 0.01) << foot;
}

// A ball of 1,000 kg on a chain of 20 links swings into boxes, with and without a wall behind them.
TEST(DirectJoints, WreckingBallHitsBoxes) {
    for (const bool wall : {false, true}) {
        World world(without_sleep());
        BodyDef fixed;
        fixed.type = BodyType::static_;
        fixed.position = {0, -0.5, 0};
        add_body(world, Box{{50, 0.5f, 50}}, fixed);
        fixed.position = {2, 3, 0};
        if (wall) add_body(world, Box{{0.5f, 3, 3}}, fixed);
        const Chain chain = add_chain(world, 20, 1000, {0, 11.3, 0}, -1);
        for (int i = 0; i < 2; ++i)
            for (int k = 0; k < 4; ++k)
                add_dynamic(world, Box{{0.25f, 0.25f, 0.25f}}, {0.5 + 0.51 * i, 0.25 + 0.5 * k, 0}, 10);
        const double energy = world.kinetic_energy() + world.potential_energy();
        EXPECT_LT(peak_gap(world, 15), 0.04) << wall;
        EXPECT_LT(world.kinetic_energy() + world.potential_energy(), energy) << wall;
    }
}

// When joints are destroyed, the remaining joints of the chain are not disturbed; snapshots and any number of threads
// give the same bits.
TEST(DirectJoints, SameBitsFromSnapshotsAndThreads) {
    World world, threaded;
    threaded.set_threads(4);
    std::vector<Chain> chains[2];
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 12; ++i) {
            World& w = k == 0 ? world : threaded;
            chains[k].push_back(add_chain(w, 10 + i, 500, {3.0 * i, 0, 0}, 0.3));
        }
    for (int i = 0; i < 90; ++i) {
        if (i == 30)
            for (World* w : {&world, &threaded}) w->destroy_joint(w->joints()[5]);
        if (i == 60) // by now the handles of both worlds are equal
            for (World* w : {&world, &threaded}) w->body(chains[0][3].ball).set_mass_from_shapes(50.0f);
        world.step(dt);
        threaded.step(dt);
        ASSERT_EQ(world.state_hash(), threaded.state_hash()) << i;
        if (i % 25 == 0) threaded.restore(world.save());
    }
}

// --- which joints the engine assigns to the direct solver itself: such runs have the same bits as with that solver
// requested

using Build = void (*)(World&, JointSolver);

std::uint64_t hash_after(Build build, JointSolver solver) {
    World world(without_sleep());
    build(world, solver);
    run(world, dt, 30);
    return world.state_hash();
}
void expect_choice(Build build, JointSolver expected) {
    const JointSolver other = expected == JointSolver::direct ? JointSolver::iterative : JointSolver::direct;
    const std::uint64_t chosen = hash_after(build, JointSolver::automatic);
    EXPECT_EQ(chosen, hash_after(build, expected));
    EXPECT_NE(chosen, hash_after(build, other)); // otherwise the comparison above proves nothing
}

TEST(JointSolverChoice, DirectForHeavyEnds) {
    expect_choice([](World& w, JointSolver s) { add_chain(w, 3, 50, {}, 0.5, s); }, JointSolver::direct);
}
TEST(JointSolverChoice, DirectForLongChains) {
    expect_choice([](World& w, JointSolver s) { add_chain(w, 12, 1, {}, 0.5, s); }, JointSolver::direct);
}
TEST(JointSolverChoice, IterativeForShortChainsOfEquals) {
    expect_choice([](World& w, JointSolver s) { add_chain(w, 4, 1, {}, 0.5, s); }, JointSolver::iterative);
}
TEST(JointSolverChoice, DirectForFixedJointsInSeries) {
    expect_choice(
        [](World& w, JointSolver s) {
            const BodyId a = add_dynamic(w, Box{}, {0.5, 0, 0}, 1), b = add_dynamic(w, Box{}, {1.5, 0, 0}, 1);
            hold(w, {}, a, {0, 0, 0}, FixedJoint{}, s);
            hold(w, a, b, {1, 0, 0}, FixedJoint{}, s);
        },
        JointSolver::direct);
}
TEST(JointSolverChoice, DirectForHingesInALoop) {
    expect_choice(
        [](World& w, JointSolver s) { // a four-bar linkage
            const BodyId a = add_dynamic(w, Box{{0.1f, 0.5f, 0.1f}}, {0, 0.5, 0}, 1),
                         b = add_dynamic(w, Box{{0.5f, 0.1f, 0.1f}}, {0.5, 1, 0}, 1),
                         c = add_dynamic(w, Box{{0.1f, 0.5f, 0.1f}}, {1, 0.5, 0}, 1);
            w.body(a).set_angular_velocity({0, 0, 1});
            hold(w, {}, a, {0, 0, 0}, HingeJoint{}, s);
            hold(w, a, b, {0, 1, 0}, HingeJoint{}, s);
            hold(w, b, c, {1, 1, 0}, HingeJoint{}, s);
            hold(w, c, {}, {1, 0, 0}, HingeJoint{}, s);
        },
        JointSolver::direct);
}
TEST(JointSolverChoice, IterativeForNets) {
    expect_choice([](World& w, JointSolver s) { add_net(w, 16, {0, 0, 1}, s); }, JointSolver::iterative);
}

// A ball of 1,000 times the mass of a link swings so high that the chain goes slack, and is then caught by the chain.
// The impact opens the joints for a moment.
TEST(DirectJoints, SlackChainCatchesItsBall) {
    World world(without_sleep());
    const Chain chain = add_chain(world, 20, 1000);
    std::vector<BodyId> bodies = chain.links; // collisions are off, because the ball would crush the links
    bodies.push_back(chain.ball);
    for (const BodyId body : bodies)
        for (const ShapeId shape : world.body(body).shapes()) world.set_filter(shape, CollisionFilter{1, 0});
    world.body(chain.ball).set_linear_velocity({21, 0, 0});
    const double energy = world.kinetic_energy() + world.potential_energy();
    EXPECT_LT(peak_gap(world, 20), 0.25);
    EXPECT_LT(greatest_gap(world), 0.005);
    EXPECT_LT(world.kinetic_energy() + world.potential_energy(), energy);
}

} // namespace
