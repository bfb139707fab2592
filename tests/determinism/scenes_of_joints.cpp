// Scenes with every joint.
#include "scene_tools.h"

#include <limits>

namespace cairn_test {

using namespace cairn;

namespace {

JointControl control(float lower, float upper, float speed, float spring) {
    JointControl c;
    c.limits = JointRange{lower, upper, {}};
    c.motor = JointMotor{};
    c.motor->velocity = speed;
    c.motor->max_force = 400;
    if (spring > 0) c.motor->spring = JointSpring::from_frequency(spring, 0.5f);
    c.friction = 2;
    return c;
}

// All joints: pairs of boxes on the ground and hanging from the world, a chain, a net, a rope over pulleys and gears.
class AllJoints final : public Scene {
    static Joint joint(int kind) {
        BallJoint ball;
        ball.cone_angle = 0.7f;
        ball.twist = JointRange{-0.5f, 0.5f, JointSpring::from_frequency(4, 0.2f)};
        ball.friction = 1;
        GeneralJoint general;
        general.limits.push_back({JointAxis::linear, {true, false, true}, 0.0f, 0.4f, {}, 0});
        general.limits.push_back({JointAxis::angular, {true, true, true}, 0.0f, 0.9f, 300.0f, 10});
        general.drives.push_back({JointAxis::linear, true, 1, 500.0f, 0.2f, 0, 40, 4});
        general.drives.push_back({JointAxis::angular, false, 2, {}, 0, 2, 0, 30});
        WheelJoint wheel;
        wheel.suspension = control(-0.2f, 0.2f, 0, 3);
        wheel.steering = control(-0.4f, 0.4f, 1, 0);
        wheel.spin.motor = JointMotor{9, 0, {}, 50};
        ServoJoint servo;
        servo.position = {0.3f, 0.1f, 0.2f};
        servo.max_force = 3000;
        const Joint all[] = {FixedJoint{},
                             ball,
                             HingeJoint{control(-1, 1, 2, 0)},
                             SliderJoint{control(-0.3f, 0.5f, 0.4f, 0)},
                             CylindricalJoint{control(-0.3f, 0.5f, 0, 2), control(-9, 9, 3, 0)},
                             UniversalJoint{control(-0.6f, 0.6f, 1, 0), control(-0.5f, 0.5f, -1, 1)},
                             DistanceJoint{control(0.2f, 1.3f, 0.3f, 0)},
                             wheel,
                             servo,
                             general};
        return all[kind];
    }

  public:
    void build(World& world) override {
        add_fixed(world, Plane{});
        Numbers numbers(29);
        for (int i = 0; i < 30; ++i) {
            BodyDef def;
            def.position = Position(2.2 * (i % 10), 1.5 + 1.4 * (i / 20), 2.1 * (i / 10 % 2));
            def.rotation = numbers.rotation();
            const BodyId a = add(world, Box{{0.4f, 0.2f, 0.3f}}, def);
            def.position += Position(0.9, 0.1, 0.2);
            def.rotation = numbers.rotation();
            const BodyId b = add(world, i % 3 == 0 ? Shape(Sphere{0.3f}) : Shape(Box{{0.2f, 0.3f, 0.25f}}), def);
            const Position anchor = def.position - Position(0.45, 0.05, 0.1);
            world.create_joint(world.joint_at(i % 7 == 6 ? BodyId{} : a, b, anchor, numbers.vector(), joint(i % 10)));
        }
        build_net(world);
        build_machine(world);
    }

  private:
    static void build_net(World& world) {
        std::vector<BodyId> ids;
        for (int i = 0; i < 5 * 5; ++i) {
            BodyDef def;
            def.position = {0.6 * (i % 5) + 4, 7, 0.6 * (i / 5) + 6};
            if (i < 5) def.type = BodyType::static_;
            ids.push_back(add(world, Box{{0.2f, 0.1f, 0.2f}}, def));
            auto join = [&](std::size_t other, const Position& offset) {
                world.create_joint(
                    world.joint_at(ids[other], ids.back(), def.position + offset, {1, 0, 0}, BallJoint{}));
            };
            if (i >= 5 && i % 5 > 0) join(ids.size() - 2, {-0.3, 0, 0});
            if (i >= 5) join(ids.size() - 6, {0, 0, -0.3});
        }
    }
    static void build_machine(World& world) {
        BodyDef def;
        def.position = {0, 3, -4};
        const BodyId small = add(world, Cylinder{0.1f, 0.3f, {}}, def);
        def.position = {0.9, 3, -4};
        const BodyId large = add(world, Cylinder{0.1f, 0.6f, {}}, def);
        HingeJoint motor;
        motor.angle.motor = JointMotor{3, 0, {}, 100};
        world.create_joint(world.joint_at({}, small, {0, 3, -4}, {0, 1, 0}, motor));
        world.create_joint(world.joint_at({}, large, {0.9, 3, -4}, {0, 1, 0}, HingeJoint{}));
        world.create_joint(world.joint_at(small, large, {0.45, 3, -4}, {0, 1, 0}, GearJoint{2}));
        def.position = {1.55, 3, -4};
        const BodyId rack = add(world, Box{{0.05f, 0.1f, 1.0f}}, def);
        world.create_joint(world.joint_at({}, rack, def.position, {0, 0, 1}, SliderJoint{control(-0.8f, 0.8f, 0, 0)}));
        JointDef pinion = world.joint_at(large, rack, {0.9, 3, -4}, {0, 1, 0}, RackJoint{0.6f});
        pinion.frame_b = world.joint_at({}, rack, def.position, {0, 0, 1}, SliderJoint{}).frame_b;
        world.create_joint(pinion);
        def.position = {4, 2, -4};
        const BodyId left = add(world, Box{{0.3f, 0.3f, 0.3f}}, def);
        def.position = {6, 2, -4};
        const BodyId right = add(world, Sphere{0.3f}, def);
        JointDef rope;
        rope.body_a = left, rope.body_b = right;
        rope.joint = PulleyJoint{{4, 5, -4}, {6, 5, -4}, 1, {}};
        rope.break_force = 1e6f;
        world.create_joint(rope);
    }
};

// Chains with a weight, in the direct and in the iterative solver; a ring; a machine that is driven and reversed;
// joints that break, are destroyed and created while the world runs.
class Chains final : public Scene {
    static void hang_chain(World& world, const Position& top, JointSolver solver, float break_force) {
        BodyId last{};
        for (int i = 0; i < 9; ++i) {
            BodyDef def;
            def.position = top + Position(0.25 + 0.5 * i, 0, 0);
            const bool is_weight = i == 8;
            ShapeDef shape;
            shape.density = is_weight ? 2000.0f : 500.0f;
            const BodyId link =
                add(world, is_weight ? Shape(Sphere{0.5f}) : Shape(Capsule{0.05f, 0.08f, {}}), def, shape);
            JointDef joint = world.joint_at(last, link, top + Position(0.5 * i, 0, 0), {0, 0, 1},
                                            i % 4 == 3   ? Joint(HingeJoint{})
                                            : i % 4 == 1 ? Joint(UniversalJoint{})
                                                         : BallJoint{});
            joint.solver = solver;
            if (i == 5) joint.break_force = break_force;
            world.create_joint(joint);
            last = link;
        }
    }

  public:
    void build(World& world) override {
        add_fixed(world, Plane{});
        hang_chain(world, {0, 7, 0}, JointSolver::direct, std::numeric_limits<float>::infinity());
        hang_chain(world, {0, 7, 3}, JointSolver::iterative, std::numeric_limits<float>::infinity());
        hang_chain(world, {0, 7, 6}, JointSolver::automatic, 15000);
        std::vector<BodyId> ring; // eight boxes, each rotated against the last, the ring closed by a rope
        for (int i = 0; i < 8; ++i) {
            BodyDef def;
            def.position = {9 + 0.8 * (i % 4), 3 + 0.9 * (i / 4), 0};
            ring.push_back(add(world, Box{{0.35f, 0.1f, 0.2f}}, def));
            if (i == 0) continue;
            JointDef joint =
                world.joint_at(ring[std::size_t(i) - 1], ring.back(), def.position, {0, 0, 1}, HingeJoint{});
            joint.solver = i % 2 == 0 ? JointSolver::direct : JointSolver::automatic;
            world.create_joint(joint);
        }
        DistanceJoint rope;
        rope.distance.limits = JointRange{0, 1.5f, {}};
        world.create_joint(world.joint_at(ring.front(), ring.back(), {9, 3, 0}, {1, 0, 0}, rope));
        BodyDef crank;
        crank.position = {9, 2, 4};
        HingeJoint motor;
        motor.angle.motor = JointMotor{4, 0, {}, 500};
        JointDef driven = world.joint_at({}, add(world, Box{{0.5f, 0.1f, 0.1f}}, crank), {9, 2, 4}, {0, 0, 1}, motor);
        driven.name = "motor";
        world.create_joint(driven);
    }
    void before_step(World& world) override {
        const std::uint64_t step = world.step_count();
        if (step % 150 == 75) {
            const JointId id = *world.find_joint("motor");
            HingeJoint motor = std::get<HingeJoint>(world.joint_def(id).joint);
            motor.angle.motor->velocity = -motor.angle.motor->velocity;
            world.set_joint(id, motor);
        }
        if (step == 200) world.destroy_joint(world.joints()[5]);
        if (step == 320) {
            const std::vector<BodyId> bodies = world.bodies();
            const Body a = world.body(bodies[3]), b = world.body(bodies[20]);
            DistanceJoint spring;
            spring.distance.motor = JointMotor{0, 1, JointSpring::from_frequency(2, 0.3f), 2000};
            JointDef def = world.joint_at(a.id(), b.id(), a.position(), {1, 0, 0}, spring);
            def.frame_b = {};
            world.create_joint(def);
        }
    }
};

// Arms in the direct solver: servos of small and large force, friction, soft limits, motors, and links of 1 kg between
// others of 20 g. They fall on the ground; every 20 steps the servos get new targets.
class Robots final : public Scene {
    static HingeJoint hinge(int kind, int i) {
        HingeJoint hinge;
        if (kind == 0 || kind == 1) {
            hinge.angle.motor.emplace().spring = JointSpring{50, 2, false};
            hinge.angle.motor->max_force = kind == 0 ? 1.0f : 10.0f;
        }
        if (kind == 1 || kind == 2) hinge.angle.friction = 0.5f;
        if (kind == 2 || kind == 3) hinge.angle.limits = JointRange{-0.3f, 0.2f, JointSpring{50, 1, false}};
        if (kind == 3 && i == 2) hinge.angle.motor = JointMotor{3, 0, {}, 2};
        return hinge;
    }

  public:
    void build(World& world) override {
        add_fixed(world, Plane{});
        for (int kind = 0; kind < 4; ++kind) {
            BodyId last{};
            for (int i = 0; i < 6; ++i) {
                BodyDef def;
                def.position = {0.3 * i, 1.0 + 0.2 * i, 3.0 * kind};
                def.mass = i % 2 ? 0.02f : 1.0f;
                def.angular_velocity = {1, 0.5f * float(kind), -1};
                const BodyId link = add(world, Box{{0.12f, 0.05f, 0.08f}}, def);
                if (i > 0) {
                    const Position at = def.position - Position(0.15, 0.1, 0);
                    JointDef joint = world.joint_at(last, link, at, {0, i % 3 ? 0 : 1, 1}, hinge(kind, i));
                    joint.solver = JointSolver::direct;
                    joint.name = "servo";
                    world.create_joint(joint);
                }
                last = link;
            }
        }
    }
    void before_step(World& world) override {
        if (world.step_count() % 20 != 0) return;
        const std::vector<JointId> joints = world.joints();
        for (std::size_t i = 0; i < 10; ++i) { // joints of the first two arms
            HingeJoint hinge = std::get<HingeJoint>(world.joint_def(joints[i]).joint);
            hinge.angle.motor->position = (world.step_count() / 20 + i) % 2 ? 0.4f : -0.4f;
            world.set_joint(joints[i], hinge);
        }
    }
};

} // namespace

Scene& robots() { return make<Robots>(); }
Scene& all_joints() { return make<AllJoints>(); }
Scene& chains() { return make<Chains>(); }

} // namespace cairn_test
