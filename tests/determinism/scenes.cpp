#include "scenes.h"

#include "golden_hashes.h"

#include <limits>
#include <string>

namespace cairn_test {

using namespace cairn;

namespace {

// Plain integer arithmetic, so that the scenes are the same with every standard library.
class Numbers {
  public:
    explicit Numbers(std::uint32_t seed) : state_(seed) {}
    float next() { // -1 to 1
        state_ = state_ * 1664525u + 1013904223u;
        return float(std::int32_t(state_ >> 8) - (1 << 23)) / float(1 << 23);
    }
    Vec3 vector() {
        const float x = next(), y = next(), z = next();
        return {x, y, z};
    }
    Quat rotation() {
        const float x = next(), y = next(), z = next();
        return {1.1f, x, y, z}; // the world normalizes it
    }

  private:
    std::uint32_t state_;
};

BodyId add(World& world, const Shape& shape, const BodyDef& def, const ShapeDef& shape_def = {}) {
    const BodyId body = world.create_body(def);
    world.add_shape(body, shape, shape_def);
    return body;
}

BodyId add_fixed(World& world, const Shape& shape, const Position& position = {0, 0, 0},
                 const ShapeDef& shape_def = {}) {
    BodyDef def;
    def.type = BodyType::static_;
    def.position = position;
    return add(world, shape, def, shape_def);
}

// Spheres and boxes of many sizes between four walls: each pair of shapes.
struct MixedPile : Scene {
    void build(World& world) override {
        add_fixed(world, Plane{});
        for (int side = 0; side < 4; ++side) {
            const float sign = side % 2 == 0 ? 1.0f : -1.0f;
            const Vec3 out = side < 2 ? Vec3(sign, 0, 0) : Vec3(0, 0, sign);
            Plane wall{-out, {0, 1, 0}, glm::vec2(4, 4)};
            add_fixed(world, wall, Position(4.0f * out) + Position(0, 4, 0));
        }
        Numbers numbers(1);
        for (int i = 0; i < 240; ++i) {
            BodyDef def;
            def.position = {1.2 * (i % 6) - 3, 1 + 0.8 * (i / 36), 1.2 * (i / 6 % 6) - 3};
            def.rotation = numbers.rotation();
            def.linear_velocity = numbers.vector();
            def.angular_velocity = numbers.vector();
            const float size = 0.4f + 0.15f * numbers.next();
            if (i % 2 == 0)
                add(world, Sphere{size}, def);
            else
                add(world, Box{{size, 0.7f * size, 0.5f * size}}, def);
        }
    }
};

struct Pyramid : Scene {
    void build(World& world) override {
        add_fixed(world, Plane{});
        for (int row = 0; row < 20; ++row)
            for (int i = 0; i < 20 - row; ++i) {
                BodyDef def;
                def.position = {1.02 * i + 0.51 * row, 0.5 + 1.01 * row, 0};
                add(world, Box{}, def);
            }
        BodyDef ball; // comes when the pyramid has settled
        ball.position = {9, 6, 60};
        ball.linear_velocity = {0, 7, -40};
        ShapeDef heavy;
        heavy.density = 4000;
        add(world, Sphere{1.2f}, ball, heavy);
    }
};

struct Dominoes : Scene {
    void build(World& world) override {
        add_fixed(world, Box{{20, 1, 20}}, {0, -1, 0});
        for (int i = 0; i < 40; ++i) {
            const double angle = 0.12 * i;
            BodyDef def;
            // Along a spiral, by rational arithmetic instead of the library's sine.
            const double c = (1 - angle * angle / 16) / (1 + angle * angle / 16),
                         s = (angle / 2) / (1 + angle * angle / 16);
            def.position = {8 * c, 0.5, 8 * s};
            def.rotation = Quat(1, 0, float(-angle / 4), 0);
            if (i == 0) def.name = "first";
            add(world, Box{{0.3f, 0.5f, 0.05f}}, def);
        }
    }
    void before_step(World& world) override {
        if (world.step_count() != 20) return;
        Body pushed = world.body(*world.find_body("first"));
        pushed.apply_impulse_at(pushed.rotation() * Vec3(0, 0, 1.5f * pushed.mass()),
                                pushed.position() + Position(0, 0.4, 0));
    }
};

// Every material property at once, on rectangles, planes and boxes; damping, fields, forces.
struct Materials : Scene {
    void build(World& world) override {
        ShapeDef ground;
        ground.material.restitution = 0.7f;
        add_fixed(world, Plane{{0.1f, 1, 0.05f}, {1, 0, 0}, {}}, {0, 0, 0}, ground);
        add_fixed(world, Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(3, 3)}, {0, 2, 0}, ground);
        ForceField field;
        field.kind = ForceField::Kind::radial;
        field.center = {0, 3, 0};
        field.strength = 2;
        field.exponent = -1;
        world.add_force_field(field);
        Numbers numbers(5);
        for (int i = 0; i < 120; ++i) {
            BodyDef def;
            def.position = {0.9 * (i % 5) - 2, 3 + 1.1 * (i / 25), 0.9 * (i / 5 % 5) - 2};
            def.rotation = numbers.rotation();
            def.linear_damping = i % 3 == 0 ? 0.2f : 0;
            def.angular_damping = i % 4 == 0 ? 0.5f : 0;
            def.gravity_scale = 1 + 0.2f * numbers.next();
            ShapeDef shape;
            shape.density = i % 7 == 0 ? 8000.0f : 600.0f;
            shape.material.static_friction = 0.5f + 0.5f * numbers.next();
            shape.material.dynamic_friction = 0.8f * shape.material.static_friction;
            shape.material.restitution = 0.5f + 0.5f * numbers.next();
            shape.material.rolling_friction = i % 2 == 0 ? 0.02f : 0;
            shape.material.torsional_friction = i % 5 == 0 ? 0.05f : 0;
            shape.material.friction_combine = CombineRule(i % 4);
            shape.material.restitution_combine = CombineRule(i / 4 % 4);
            if (i % 2 == 0)
                add(world, Sphere{0.35f}, def, shape);
            else
                add(world, Box{{0.3f, 0.4f, 0.35f}}, def, shape);
        }
    }
    void before_step(World& world) override {
        const std::vector<BodyId> bodies = world.bodies();
        const std::size_t k = std::size_t(world.step_count() * 7 % bodies.size());
        Body pushed = world.body(bodies[k]);
        if (pushed.type() != BodyType::dynamic) return;
        pushed.add_force_at(100.0f * pushed.mass() * Vec3(0.1f, 0.2f, -0.1f),
                            pushed.center_of_mass() + Position(0.1, 0, 0));
    }
};

// A hollow box of kinematic walls that turns.
struct Tumbler : Scene {
    void build(World& world) override {
        BodyDef drum;
        drum.type = BodyType::kinematic;
        drum.name = "drum";
        drum.position = {0, 4, 0};
        drum.angular_velocity = {0, 0, 0.9f};
        const BodyId body = world.create_body(drum);
        for (int side = 0; side < 6; ++side) {
            ShapeDef wall;
            Vec3 half(3);
            half[side / 2] = 0.25f;
            wall.position[side / 2] = side % 2 == 0 ? -3.0f : 3.0f;
            world.add_shape(body, Box{half}, wall);
        }
        Numbers numbers(9);
        for (int i = 0; i < 150; ++i) {
            BodyDef def;
            def.position = {0.8 * (i % 6) - 2, 2.2 + 0.8 * (i / 36), 0.8 * (i / 6 % 6) - 2};
            if (i % 3 == 0)
                add(world, Sphere{0.3f + 0.05f * numbers.next()}, def);
            else
                add(world, Box{{0.3f, 0.2f + 0.05f * numbers.next(), 0.25f}}, def);
        }
    }
    void before_step(World& world) override {
        if (world.step_count() % 100 == 50)
            world.body(*world.find_body("drum"))
                .set_angular_velocity({0.1f, 0, world.step_count() % 200 == 50 ? -0.9f : 0.9f});
    }
};

// Stacks that fall asleep and are woken by a ball, a push and the loss of their support.
struct SleepAndWake : Scene {
    void build(World& world) override {
        add_fixed(world, Plane{});
        for (int stack = 0; stack < 6; ++stack)
            for (int i = 0; i < 5; ++i) {
                BodyDef def;
                def.position = {4.0 * stack, 0.5 + i, 0};
                if (i == 0) def.name = "foot " + std::to_string(stack);
                add(world, Box{}, def);
            }
    }
    void before_step(World& world) override {
        switch (world.step_count()) {
        case 120: {
            BodyDef ball;
            ball.position = {-8, 2, 0};
            ball.linear_velocity = {12, 2, 0};
            add(world, Sphere{0.6f}, ball);
            break;
        }
        case 150:
            world.body(*world.find_body("foot 3")).apply_impulse({3000, 0, 500});
            break;
        case 160:
            world.destroy_body(*world.find_body("foot 5"));
            break;
        default:
            break;
        }
    }
};

// Bodies of several shapes: hammers and crosses.
struct Compounds : Scene {
    void build(World& world) override {
        add_fixed(world, Plane{});
        add_fixed(world, Box{{1.5f, 0.5f, 1.5f}}, {0.4, 0.5, 0.3});
        Numbers numbers(13);
        for (int i = 0; i < 60; ++i) {
            BodyDef def;
            def.position = {1.8 * (i % 3) - 1.8, 2.5 + 1.6 * (i / 9), 1.8 * (i / 3 % 3) - 1.8};
            def.rotation = numbers.rotation();
            const BodyId body = world.create_body(def);
            world.add_shape(body, Box{{0.7f, 0.12f, 0.12f}});
            ShapeDef part;
            part.position = {i % 2 == 0 ? 0.6f : 0.0f, 0, 0};
            part.rotation = numbers.rotation();
            part.density = 3000;
            world.add_shape(body, Box{{0.15f, 0.5f, 0.2f}}, part);
            part.position = {-0.7f, 0, 0};
            world.add_shape(body, Sphere{0.25f}, part);
        }
    }
};

// Free bodies of unequal inertia, far from the origin, with the Runge-Kutta integrator.
struct FreeTops : Scene {
    WorldDef settings() const override {
        WorldDef def;
        def.integrator = Integrator::rk4;
        def.gravity = {0, -1, 0};
        return def;
    }
    void build(World& world) override {
        Numbers numbers(17);
        for (int i = 0; i < 64; ++i) {
            BodyDef def;
            def.position = Position(1e6, 2e6, -3e6) + Position(1.1 * (i % 4), 1.1 * (i / 16), 1.1 * (i / 4 % 4));
            def.rotation = numbers.rotation();
            def.linear_velocity = numbers.vector();
            def.angular_velocity = 8.0f * numbers.vector();
            ShapeDef shape;
            shape.material.restitution = 0.9f;
            add(world, Box{{0.6f, 0.3f, 0.1f}}, def, shape);
        }
    }
};

Hull rock(Numbers& numbers, int points) {
    std::vector<Vec3> cloud;
    for (int i = 0; i < points; ++i) cloud.push_back(0.5f * numbers.vector());
    return Hull(cloud);
}

// All shapes on a height field and a mesh, one beside the other, with a conveyor, a trigger and two layers.
struct AllShapes : Scene {
    void build(World& world) override {
        Numbers numbers(23);
        std::vector<float> heights;
        for (int i = 0; i < 17 * 17; ++i) heights.push_back(0.25f * numbers.next());
        add_fixed(world, HeightField(17, 17, {1, 1}, heights));
        std::vector<Vec3> vertices;
        std::vector<std::uint32_t> indices;
        for (std::uint32_t r = 0; r < 9; ++r)
            for (std::uint32_t c = 0; c < 9; ++c)
                vertices.emplace_back(2.0f * float(c), 0.3f * numbers.next(), 2.0f * float(r));
        for (std::uint32_t r = 0; r < 8; ++r)
            for (std::uint32_t c = 0; c < 8; ++c) {
                const std::uint32_t a = 9 * r + c, b = a + 1, d = a + 9, e = d + 1;
                indices.insert(indices.end(), {a, d, e, a, e, b});
            }
        add_fixed(world, Mesh(vertices, indices), {8, 0.1, -8});
        ShapeDef belt;
        belt.surface_velocity = {1, 0, 0.5f};
        add_fixed(world, Box{{2, 0.2f, 8}}, {0, 0.3, 0}, belt);
        ShapeDef zone;
        zone.is_trigger = true;
        add_fixed(world, Box{{4, 1, 4}}, {8, 1, 0}, zone);
        const Hull rocks[] = {rock(numbers, 8), rock(numbers, 14), rock(numbers, 40)};
        for (int i = 0; i < 200; ++i) {
            BodyDef def;
            def.position = Position(1.3 * (i % 10), 1 + 1.1 * (i / 40), 1.6 * (i / 10 % 4) - 2.4);
            def.rotation = numbers.rotation();
            const float size = 0.35f + 0.1f * numbers.next();
            const Shape shapes[] = {Sphere{size},     Box{{size, 0.3f, size}},   Capsule{size, 0.2f, {}},
                                    rocks[i % 3],     Cylinder{size, 0.3f, {}},  Capsule{size, 0.3f, 0.15f},
                                    cone(0.4f, size), Cylinder{size, 0.3f, 0.2f}};
            ShapeDef shape;
            if (i % 16 == 5) shape.filter = {2, 1}; // they do not meet each other
            add(world, shapes[i % 8], def, shape);
        }
    }
};

// Rounded shapes on hills and on a sheet, and between walls that are strips.
class RoundedShapes final : public Scene {
    void build(World& world) override {
        Numbers numbers(23);
        add_fixed(world, Plane{{0, 1, 0}, {1, 0, 0}, {}, true});
        constexpr float endless = std::numeric_limits<float>::infinity();
        add_fixed(world, Plane{{0, 0, 1}, {1, 0, 0}, glm::vec2(endless, 3), true}, {0, 0, -4});
        add_fixed(world, Plane{{0, 0, -1}, {1, 0, 0}, glm::vec2(endless, 3)}, {0, 0, 4});
        std::vector<float> heights(17 * 17);
        for (float& height : heights) height = 0.3f * numbers.next();
        add_fixed(world, HeightField(17, 17, {0.5f, 0.5f}, heights));
        add_fixed(world, Box{{2, 0.1f, 2}, 0.1f}, {6, 0.4, 0});
        Hull pebble = rock(numbers, 20);
        pebble.rounding = 0.1f;
        for (int i = 0; i < 120; ++i) {
            BodyDef def;
            def.position = Position(1.1 * (i % 8) - 2, 1 + 1.2 * (i / 40), 1.3 * (i / 8 % 5) - 2.6);
            def.rotation = numbers.rotation();
            const float size = 0.25f + 0.1f * numbers.next(), r = 0.08f;
            const Shape shapes[] = {Box{{size, 0.2f, size}, r},    Cylinder{size, 0.2f, {}, r}, pebble,
                                    Cylinder{size, 0.3f, 0.0f, r}, Box{{size, 0.2f, size}},     Sphere{size}};
            add(world, shapes[i % 6], def);
        }
    }
};

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
        for (int i = 0; i < 60; ++i) {
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
        for (int i = 0; i < 8 * 8; ++i) {
            BodyDef def;
            def.position = {0.6 * (i % 8) + 4, 7, 0.6 * (i / 8) + 6};
            if (i < 8) def.type = BodyType::static_;
            ids.push_back(add(world, Box{{0.2f, 0.1f, 0.2f}}, def));
            auto join = [&](std::size_t other, const Position& offset) {
                world.create_joint(
                    world.joint_at(ids[other], ids.back(), def.position + offset, {1, 0, 0}, BallJoint{}));
            };
            if (i >= 8 && i % 8 > 0) join(ids.size() - 2, {-0.3, 0, 0});
            if (i >= 8) join(ids.size() - 9, {0, 0, -0.3});
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

template <class T> Scene& make() {
    static T scene;
    return scene;
}

constexpr NamedScene all_scenes[] = {
    {"mixed_pile", make<MixedPile>, golden::mixed_pile},
    {"pyramid", make<Pyramid>, golden::pyramid},
    {"dominoes", make<Dominoes>, golden::dominoes},
    {"materials", make<Materials>, golden::materials},
    {"tumbler", make<Tumbler>, golden::tumbler},
    {"sleep_and_wake", make<SleepAndWake>, golden::sleep_and_wake},
    {"compounds", make<Compounds>, golden::compounds},
    {"free_tops", make<FreeTops>, golden::free_tops},
    {"all_shapes", make<AllShapes>, golden::all_shapes},
    {"rounded_shapes", make<RoundedShapes>, golden::rounded_shapes},
    {"all_joints", make<AllJoints>, golden::all_joints},
};

} // namespace

std::span<const NamedScene> scenes() { return all_scenes; }

const NamedScene* find_scene(std::string_view name) {
    for (const NamedScene& scene : all_scenes)
        if (name == scene.name) return &scene;
    return nullptr;
}

std::uint64_t hash_after(Scene& scene, int steps, int threads) {
    World world{scene.settings()};
    world.set_threads(threads);
    scene.build(world);
    for (int i = 0; i < steps; ++i) scene.step(world);
    return world.state_hash();
}

} // namespace cairn_test
