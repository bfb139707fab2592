// Scenes of unusual settings, of fast spin, and of changes that users make while a world runs.
#include "scene_tools.h"

#include <string>

namespace cairn_test {

using namespace cairn;

namespace {

// Balls and bricks in a spring field and in a wind, with the explicit Euler method: free motion gains energy.
struct ExplicitEuler : Scene {
    WorldDef settings() const override {
        WorldDef def;
        def.integrator = Integrator::explicit_euler;
        def.enable_sleep = false;
        def.substeps = 4;
        return def;
    }
    void build(World& world) override {
        add_fixed(world, Plane{});
        ForceField spring;
        spring.kind = ForceField::Kind::radial;
        spring.center = {0, 3, 0};
        spring.strength = 3;
        spring.exponent = 1;
        world.add_force_field(spring);
        ForceField wind;
        wind.direction = {900, 0, 300};
        wind.is_force = true;
        world.add_force_field(wind);
        Numbers numbers(32);
        for (int i = 0; i < 24; ++i) {
            BodyDef def;
            def.position = {1.1 * (i % 4) - 2, 1 + 1.1 * (i / 8), 1.1 * (i / 4 % 2)};
            def.rotation = numbers.rotation();
            def.angular_velocity = 3.0f * numbers.vector();
            def.angular_damping = 0.1f;
            if (i % 3 == 0)
                add(world, Sphere{0.4f}, def);
            else
                add(world, Box{{0.5f, 0.2f, 0.3f}}, def);
        }
    }
};

// Bodies that spin fast in contact, and a heavy box on light ones, which needs more substeps.
struct Whirl : Scene {
    void build(World& world) override {
        add_fixed(world, Plane{});
        const Vec3 spins[] = {{0, 90, 0}, {2, 40, 1}, {60, 5, 0}, {0, 15, 25}};
        for (int i = 0; i < 8; ++i) {
            BodyDef def;
            def.position = {2.5 * (i % 4), 1.2, 3.0 * (i / 4)};
            def.angular_velocity = spins[i % 4];
            const Shape shapes[] = {cone(0.5f, 0.4f), Cylinder{0.1f, 0.6f, {}}, Box{{0.6f, 0.15f, 0.3f}},
                                    Capsule{0.5f, 0.2f, {}}};
            if (i == 0) def.rotation = Quat(0, 1, 0, 0); // on its tip
            add(world, shapes[(i + i / 4) % 4], def);
        }
        for (int i = 0; i < 4; ++i) {
            BodyDef def;
            def.position = {-4, 0.5 + 1.001 * i, 0};
            ShapeDef shape;
            shape.density = i == 3 ? 100000.0f : 300.0f;
            add(world, Box{}, def, shape);
        }
    }
};

// All changes that a user may make while a world runs.
class Changes final : public Scene {
    static Body named(World& world, const std::string& name) { return world.body(*world.find_body(name)); }

    static void change(World& world, Body body, std::uint64_t number) {
        Numbers numbers(std::uint32_t(number) + 41);
        switch (number) {
        case 0:
            body.set_type(BodyType::kinematic);
            body.set_angular_velocity({0, 1, 0});
            break;
        case 1: {
            ShapeDef part;
            part.position = {0.7f, 0, 0};
            world.add_shape(body.id(), Capsule{0.3f, 0.2f, {}}, part);
            break;
        }
        case 2:
            world.remove_shape(body.shapes()[0]);
            break;
        case 3:
            world.set_material(body.shapes()[0], Material{0.05f, 0.05f, 0.8f, 0, 0});
            world.set_filter(body.shapes()[0], CollisionFilter{2, 1});
            break;
        case 4: {
            WorldDef def = world.settings();
            def.gravity = {3, -8, 0};
            def.substeps = 8;
            world.set_settings(def);
            break;
        }
        case 5:
            body.set_transform({2, 6, 1}, numbers.rotation());
            break;
        case 6: {
            MassProperties mass;
            mass.mass = 300;
            mass.center_of_mass = {0.1f, -0.2f, 0};
            mass.inertia_diagonal = {20, 30, 40};
            mass.inertia_orientation = numbers.rotation();
            body.set_mass_properties(mass);
            break;
        }
        case 7:
            world.destroy_body(body.id());
            for (int i = 0; i < 3; ++i) {
                BodyDef def;
                def.position = {0.3 * i, 5 + 1.2 * i, 0.5};
                def.rotation = numbers.rotation();
                add(world, Box{{0.3f, 0.6f, 0.2f}}, def);
            }
            break;
        default:
            body.set_type(BodyType::static_);
            break;
        }
    }

  public:
    void build(World& world) override {
        add_fixed(world, Plane{});
        Numbers numbers(37);
        for (int i = 0; i < 24; ++i) {
            BodyDef def;
            def.position = {1.2 * (i % 4), 0.6 + 1.05 * (i / 8), 1.2 * (i / 4 % 2)};
            def.name = "body " + std::to_string(i);
            const Shape shapes[] = {Box{}, Sphere{}, Cylinder{0.4f, 0.4f, {}}, rock(numbers, 12)};
            add(world, shapes[i % 4], def);
        }
        BodyDef lift;
        lift.type = BodyType::kinematic;
        lift.name = "lift";
        lift.position = {-3, 0.3, 0};
        add(world, Box{{1, 0.2f, 1}}, lift);
        BodyDef rider;
        rider.position = {-3, 1.1, 0};
        add(world, Box{}, rider);
    }
    void before_step(World& world) override {
        const std::uint64_t step = world.step_count();
        if (step % 120 == 10) {
            const double height = step % 240 == 10 ? 2 : 0.3;
            named(world, "lift").move_to({{-3, height, 0}, {1, 0, 0, 0}}, 1);
        }
        if (step % 120 == 70) named(world, "lift").set_linear_velocity({0, 0, 0.2f});
        if (step % 60 == 30) change(world, named(world, "body " + std::to_string(step / 60)), step / 60);
    }
};

} // namespace

Scene& explicit_euler() { return make<ExplicitEuler>(); }
Scene& whirl() { return make<Whirl>(); }
Scene& changes() { return make<Changes>(); }

} // namespace cairn_test
