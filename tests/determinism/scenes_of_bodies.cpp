// Scenes of boxes and balls.
#include "scene_tools.h"

#include <string>

namespace cairn_test {

using namespace cairn;

namespace {

// Spheres and boxes of many sizes between four walls: all pair kinds of these shapes.
struct MixedPile : Scene {
    void build(World& world) override {
        add_fixed(world, Plane{});
        for (int side = 0; side < 4; ++side) {
            const float sign = side % 2 == 0 ? 1.0f : -1.0f;
            const Vec3 out = side < 2 ? Vec3(sign, 0, 0) : Vec3(0, 0, sign);
            Plane wall{-out, {0, 1, 0}, glm::vec2(4, 4)};
            add_fixed(world, wall, Position(4.0f * out) + Position(0, 4, 0));
        }
        Numbers numbers(5);
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
        for (int row = 0; row < 12; ++row)
            for (int i = 0; i < 12 - row; ++i) {
                BodyDef def;
                def.position = {1.02 * i + 0.51 * row, 0.5 + 1.01 * row, 0};
                add(world, Box{}, def);
            }
        BodyDef ball; // arrives when the pyramid has settled
        ball.position = {5, 4, 60};
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
            // Along a spiral, by rational functions instead of the library's sine.
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

// Every material property at once, on rectangles, planes and boxes; damping, force fields, forces.
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
        for (int i = 0; i < 50; ++i) {
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

// A rotating hollow box with kinematic walls.
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
        for (int i = 0; i < 72; ++i) {
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

// Compound bodies: hammers and crosses.
struct Compounds : Scene {
    void build(World& world) override {
        add_fixed(world, Plane{});
        add_fixed(world, Box{{1.5f, 0.5f, 1.5f}}, {0.4, 0.5, 0.3});
        Numbers numbers(13);
        for (int i = 0; i < 36; ++i) {
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

// Free bodies with unequal moments of inertia, far from the origin, with the Runge-Kutta integrator.
struct FreeTops : Scene {
    WorldDef settings() const override {
        WorldDef def;
        def.integrator = Integrator::rk4;
        def.gravity = {0, -1, 0};
        return def;
    }
    void build(World& world) override {
        Numbers numbers(13);
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

} // namespace

Scene& mixed_pile() { return make<MixedPile>(); }
Scene& pyramid() { return make<Pyramid>(); }
Scene& dominoes() { return make<Dominoes>(); }
Scene& materials() { return make<Materials>(); }
Scene& tumbler() { return make<Tumbler>(); }
Scene& sleep_and_wake() { return make<SleepAndWake>(); }
Scene& compounds() { return make<Compounds>(); }
Scene& free_tops() { return make<FreeTops>(); }

} // namespace cairn_test
