// Refused arguments of bodies: positions, velocities, masses, and calls that the type of the body does not allow.
#include "refusals.h"

namespace cairn::test {

std::vector<Refusal> positions() {
    std::vector<Refusal> rows;
    struct Bad {
        int row;
        Position position;
        std::string text;
    };
    for (const Bad& bad :
         {Bad{1, nan_position, nan_text}, Bad{2, infinite_position, infinite_text}, Bad{2, far_position, far_text}}) {
        const Position p = bad.position;
        const auto add_row = [&](const char* name, std::function<void(Stage&)> call, const char* field) {
            rows.push_back(row(bad.row, name, std::move(call), field, bad.text, must_be_near));
        };
        add_row("create_body position", make_body(&BodyDef::position, p), "BodyDef.position");
        add_row("set_position", on_crate([p](Body body) { body.set_position(p); }), "Body::set_position");
        add_row("set_transform", on_crate([p](Body body) { body.set_transform(p, Quat(1, 0, 0, 0)); }),
                "Body::set_transform position");
        add_row("move_to", move_platform({p, Quat(1, 0, 0, 0)}, 1.0f), "Body::move_to target.position");
        add_row("velocity_at", on_crate([p](Body body) { body.velocity_at(p); }), "Body::velocity_at point");
        add_row("add_force_at point", on_crate([p](Body body) { body.add_force_at(Vec3(1.0f), p); }),
                "Body::add_force_at point");
        add_row("apply_impulse_at point", on_crate([p](Body body) { body.apply_impulse_at(Vec3(1.0f), p); }),
                "Body::apply_impulse_at point");
        add_row("set_force_field center", change_field(&ForceField::center, p), "ForceField.center");
        add_row("cast_ray origin", in_world([p](World& world) { world.cast_ray(p, Vec3(1.0f), 1.0); }),
                "World::cast_ray origin");
        add_row("cast_ray_all origin", in_world([p](World& world) { world.cast_ray_all(p, Vec3(1.0f), 1.0); }),
                "World::cast_ray origin");
        add_row("overlap position", in_world([p](World& world) {
                    world.overlap(Sphere{}, {p, Quat(1, 0, 0, 0)});
                }),
                "World::overlap pose.position");
    }
    rows.push_back(row(1, "shape position", make_shape(&ShapeDef::position, nan_vector), "ShapeDef.position",
                       nan_vector_text, must_be_finite));
    rows.push_back(row(2, "shape position", make_shape(&ShapeDef::position, infinite_vector), "ShapeDef.position",
                       infinite_vector_text, must_be_finite));
    rows.push_back(row(1, "center of mass", make_with_properties(&MassProperties::center_of_mass, nan_vector),
                       "BodyDef.mass_properties.center_of_mass", nan_vector_text, must_be_finite));
    return rows;
}

std::vector<Refusal> velocities_and_rotations() {
    std::vector<Refusal> rows;
    struct BadVector {
        Vec3 vector;
        std::string text;
    };
    for (const BadVector& bad :
         {BadVector{nan_vector, nan_vector_text}, BadVector{infinite_vector, infinite_vector_text}}) {
        const Vec3 v = bad.vector;
        const auto add_row = [&](int number, const char* name, std::function<void(Stage&)> call, const char* field) {
            rows.push_back(row(number, name, std::move(call), field, bad.text, must_be_finite));
        };
        add_row(3, "create_body linear velocity", make_body(&BodyDef::linear_velocity, v), "BodyDef.linear_velocity");
        add_row(3, "create_body angular velocity", make_body(&BodyDef::angular_velocity, v),
                "BodyDef.angular_velocity");
        add_row(3, "set_linear_velocity", on_crate([v](Body body) { body.set_linear_velocity(v); }),
                "Body::set_linear_velocity");
        add_row(3, "set_angular_velocity", on_crate([v](Body body) { body.set_angular_velocity(v); }),
                "Body::set_angular_velocity");
        add_row(18, "gravity of a new world", make_world(&WorldDef::gravity, v), "WorldDef.gravity");
        add_row(18, "set_settings gravity", change_settings(&WorldDef::gravity, v), "WorldDef.gravity");
        add_row(18, "field direction", change_field(&ForceField::direction, v), "ForceField.direction");
        add_row(19, "add_force", on_crate([v](Body body) { body.add_force(v); }), "Body::add_force force");
        add_row(19, "add_force_at", on_crate([v](Body body) { body.add_force_at(v, Position(0.0)); }),
                "Body::add_force_at force");
        add_row(19, "add_torque", on_crate([v](Body body) { body.add_torque(v); }), "Body::add_torque torque");
        add_row(19, "apply_impulse", on_crate([v](Body body) { body.apply_impulse(v); }),
                "Body::apply_impulse impulse");
        add_row(19, "apply_impulse_at", on_crate([v](Body body) { body.apply_impulse_at(v, Position(0.0)); }),
                "Body::apply_impulse_at impulse");
        add_row(19, "apply_angular_impulse", on_crate([v](Body body) { body.apply_angular_impulse(v); }),
                "Body::apply_angular_impulse impulse");
        add_row(19, "cast_ray direction", in_world([v](World& world) { world.cast_ray(Position(0.0), v, 1.0); }),
                "World::cast_ray direction");
    }
    struct BadRotation {
        int row;
        Quat rotation;
        std::string text, expected;
    };
    for (const BadRotation& bad : {BadRotation{4, zero_rotation, zero_rotation_text, must_not_be_zero},
                                   BadRotation{5, nan_rotation, nan_rotation_text, must_be_finite},
                                   BadRotation{5, infinite_rotation, "(w inf, x 0, y 0, z 0)", must_be_finite}}) {
        const Quat q = bad.rotation;
        const auto add_row = [&](const char* name, std::function<void(Stage&)> call, const char* field) {
            rows.push_back(row(bad.row, name, std::move(call), field, bad.text, bad.expected));
        };
        add_row("create_body rotation", make_body(&BodyDef::rotation, q), "BodyDef.rotation");
        add_row("set_rotation", on_crate([q](Body body) { body.set_rotation(q); }), "Body::set_rotation");
        add_row("set_transform", on_crate([q](Body body) { body.set_transform(Position(0.0), q); }),
                "Body::set_transform rotation");
        add_row("move_to", move_platform({Position(0.0), q}, 1.0f), "Body::move_to target.rotation");
        add_row("shape rotation", make_shape(&ShapeDef::rotation, q), "ShapeDef.rotation");
        add_row("overlap rotation", in_world([q](World& world) {
                    world.overlap(Box{}, {Position(0.0), q});
                }),
                "World::overlap pose.rotation");
        add_row("inertia orientation", make_with_properties(&MassProperties::inertia_orientation, q),
                "BodyDef.mass_properties.inertia_orientation");
    }
    return rows;
}

std::vector<Refusal> masses() {
    std::vector<Refusal> rows;
    struct BadMass {
        int row;
        float mass;
        std::string text;
    };
    for (const BadMass& bad :
         {BadMass{6, 0.0f, "0"}, BadMass{6, -0.0f, "-0"}, BadMass{7, -1.0f, "-1"}, BadMass{8, not_a_number, "nan"},
          BadMass{8, -infinity, "-inf"}, BadMass{8, 1e33f, "1e+33"}, BadMass{6, 1e-33f, "1e-33"}}) {
        const auto add_row = [&](const char* name, std::function<void(Stage&)> call, const char* field) {
            rows.push_back(row(bad.row, name, std::move(call), field, bad.text, must_be_a_mass));
        };
        add_row("create_body mass", make_body(&BodyDef::mass, bad.mass), "BodyDef.mass");
        add_row("mass properties", make_with_properties(&MassProperties::mass, bad.mass),
                "BodyDef.mass_properties.mass");
        add_row("set_mass_from_shapes", give_mass(bad.mass), "Body::set_mass_from_shapes.mass");
    }
    struct BadInertia {
        Vec3 moments;
        std::string text, expected;
    };
    for (const BadInertia& bad : {BadInertia{{1.0f, -1.0f, 1.0f}, "(1, -1, 1)", must_be_a_moment},
                                  BadInertia{{1.0f, 1.0f, not_a_number}, "(1, 1, nan)", must_be_a_moment},
                                  BadInertia{{infinity, 1.0f, 1.0f}, "(inf, 1, 1)", must_be_a_moment},
                                  BadInertia{{1.0f, 1.0f, 3.0f}, "(1, 1, 3)", must_be_real},
                                  BadInertia{{5.0f, 1.0f, 2.0f}, "(5, 1, 2)", must_be_real}}) {
        rows.push_back(row(9, "set_mass_properties", give_inertia(bad.moments), "MassProperties.inertia_diagonal",
                           bad.text, bad.expected));
        rows.push_back(row(9, "create_body inertia",
                           make_with_properties(&MassProperties::inertia_diagonal, bad.moments),
                           "BodyDef.mass_properties.inertia_diagonal", bad.text, bad.expected));
    }
    return rows;
}

std::vector<Refusal> wrong_states() {
    std::vector<Refusal> rows;
    const auto add_row = [&](const char* name, std::function<void(Stage&)> call, const char* field, const char* value,
                             const char* expected) {
        rows.push_back({0, name, std::move(call), ErrorCode::wrong_state, field, value, expected});
    };
    const auto on = [](BodyId Stage::*body, std::function<void(Body)> call) {
        return [=](Stage& stage) { call(stage.world.body(stage.*body)); };
    };
    const char* dynamic = "the body must be dynamic";
    for (const auto body : {&Stage::ground, &Stage::platform}) {
        add_row("force", on(body, [](Body b) { b.add_force(Vec3(1.0f)); }), "Body::add_force", "", dynamic);
        add_row("force at", on(body, [](Body b) { b.add_force_at(Vec3(1.0f), Position(0.0)); }), "Body::add_force_at",
                "", dynamic);
        add_row("torque", on(body, [](Body b) { b.add_torque(Vec3(1.0f)); }), "Body::add_torque", "", dynamic);
        add_row("impulse", on(body, [](Body b) { b.apply_impulse(Vec3(1.0f)); }), "Body::apply_impulse", "", dynamic);
        add_row("impulse at", on(body, [](Body b) { b.apply_impulse_at(Vec3(1.0f), Position(0.0)); }),
                "Body::apply_impulse_at", "", dynamic);
        add_row("angular impulse", on(body, [](Body b) { b.apply_angular_impulse(Vec3(1.0f)); }),
                "Body::apply_angular_impulse", "", dynamic);
        add_row("mass properties", on(body, [](Body b) { b.set_mass_properties({}); }), "Body::set_mass_properties", "",
                dynamic);
        add_row("mass from shapes", on(body, [](Body b) { b.set_mass_from_shapes(2.0f); }),
                "Body::set_mass_from_shapes", "", dynamic);
    }
    const char* still = "a static body has no velocity";
    add_row("static velocity", on(&Stage::ground, [](Body b) { b.set_linear_velocity(Vec3(1.0f)); }),
            "Body::set_linear_velocity", "", still);
    add_row("static spin", on(&Stage::ground, [](Body b) { b.set_angular_velocity(Vec3(1.0f)); }),
            "Body::set_angular_velocity", "", still);
    const char* kinematic = "the body must be kinematic";
    add_row("move_to dynamic", on(&Stage::crate, [](Body b) { b.move_to({}, 1.0f); }), "Body::move_to", "", kinematic);
    add_row("move_to static", on(&Stage::ground, [](Body b) { b.move_to({}, 1.0f); }), "Body::move_to", "", kinematic);
    add_row("plane on dynamic", add(Plane{}), "World::add_shape shape", "Plane",
            "has no mass: add it to static or kinematic bodies, or its Hull to dynamic ones");
    add_row("dynamic with plane", on(&Stage::ground, [](Body b) { b.set_type(BodyType::dynamic); }), "Body::set_type",
            "dynamic", "a body with a plane, mesh or height field cannot be dynamic");
    return rows;
}

} // namespace cairn::test
