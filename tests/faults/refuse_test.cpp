// Bad arguments are refused: rows 1 to 19 of the list of faults. Each call must name the field, the value and what was
// expected, and must leave the world as it was, to the last bit of what a snapshot holds.
#include "../api/test_world.h"

#include <functional>
#include <ostream>
#include <vector>

namespace cairn::test {
namespace {

// A world in which something of every kind exists and is in motion.
struct Stage {
    World world;
    BodyId ground, crate, platform;
    ShapeId crate_shape;
    ForceFieldId wind;

    Stage() {
        ground = add_ground(world);
        crate = world.create_body(body_at({0.0, 0.5, 0.0}));
        crate_shape = world.add_shape(crate, Box{});
        platform = add_body(world, body_at({5.0, 1.0, 0.0}, BodyType::kinematic), Box{});
        add_body(world, body_at({0.1, 1.6, 0.0}), Sphere{});
        wind = world.add_force_field({});
        run(world, 10);
    }
    Body crate_body() { return world.body(crate); }
};

struct Refusal {
    int row; // of the list of faults
    const char* name;
    std::function<void(Stage&)> call;
    ErrorCode code;
    std::string field, value, expected;
};

std::ostream& operator<<(std::ostream& out, const Refusal& refusal) { return out << refusal.name; }

const double nan_double = not_a_number, infinite_double = infinity;
const std::string must_be_near = "must be finite and within 1e15 m of the origin";
const std::string must_be_finite = "must be finite";
const std::string must_not_be_zero = "must not be zero";
const std::string must_be_a_size = "must be a size in meters from 1e-6 to 1e9";
const std::string must_be_a_mass = "must be a mass in kg from 1e-32 to 1e32, or infinite";
const std::string must_be_at_least_0 = "must be finite and >= 0";
const std::string must_be_above_0 = "must be finite and > 0";
const std::string must_be_a_moment = "must be finite and >= 0 (0: does not turn about that axis)";
const std::string must_be_real = "must satisfy the triangle inequality: no moment may exceed the sum of the other two";

Refusal row(int number, const char* name, std::function<void(Stage&)> call, std::string field, std::string value,
            std::string expected) {
    return {number,
            name,
            std::move(call),
            ErrorCode::invalid_value,
            std::move(field),
            std::move(value),
            std::move(expected)};
}

template <class Member, class Value> std::function<void(Stage&)> make_body(Member BodyDef::*member, Value value) {
    return [member, value](Stage& stage) {
        BodyDef def;
        def.*member = value;
        stage.world.create_body(def);
    };
}

template <class Member, class Value> std::function<void(Stage&)> make_world(Member WorldDef::*member, Value value) {
    return [member, value](Stage&) {
        WorldDef def;
        def.*member = value;
        World world(def);
    };
}

template <class Member, class Value>
std::function<void(Stage&)> change_settings(Member WorldDef::*member, Value value) {
    return [member, value](Stage& stage) {
        WorldDef def = stage.world.settings();
        def.*member = value;
        stage.world.set_settings(def);
    };
}

template <class Member, class Value> std::function<void(Stage&)> make_shape(Member ShapeDef::*member, Value value) {
    return [member, value](Stage& stage) {
        ShapeDef def;
        def.*member = value;
        stage.world.add_shape(stage.crate, Box{}, def);
    };
}

template <class Value> std::function<void(Stage&)> make_material(float Material::*member, Value value) {
    return [member, value](Stage& stage) {
        ShapeDef def;
        def.material.*member = value;
        stage.world.add_shape(stage.crate, Box{}, def);
    };
}

template <class Value> std::function<void(Stage&)> change_material(float Material::*member, Value value) {
    return [member, value](Stage& stage) {
        Material material;
        material.*member = value;
        stage.world.set_material(stage.crate_shape, material);
    };
}

template <class Member, class Value> std::function<void(Stage&)> change_field(Member ForceField::*member, Value value) {
    return [member, value](Stage& stage) {
        ForceField field;
        field.kind = ForceField::Kind::radial;
        field.*member = value;
        stage.world.set_force_field(stage.wind, field);
    };
}

std::function<void(Stage&)> add(const Shape& shape) {
    return [shape](Stage& stage) { stage.world.add_shape(stage.crate, shape); };
}
std::function<void(Stage&)> add_to_ground(const Shape& shape) {
    return [shape](Stage& stage) { stage.world.add_shape(stage.ground, shape); };
}
std::function<void(Stage&)> overlap_with(const Shape& shape) {
    return [shape](Stage& stage) { stage.world.overlap(shape, {}); };
}
std::function<void(Stage&)> step_by(float dt) {
    return [dt](Stage& stage) { stage.world.step(dt); };
}

std::function<void(Stage&)> give_mass(float mass) {
    return [mass](Stage& stage) { stage.crate_body().set_mass_from_shapes(mass); };
}
std::function<void(Stage&)> give_inertia(const Vec3& moments) {
    return [moments](Stage& stage) {
        MassProperties properties;
        properties.inertia_diagonal = moments;
        stage.crate_body().set_mass_properties(properties);
    };
}
template <class Member, class Value>
std::function<void(Stage&)> make_with_properties(Member MassProperties::*member, Value value) {
    return [member, value](Stage& stage) {
        BodyDef def;
        def.mass_properties.emplace();
        (*def.mass_properties).*member = value;
        stage.world.create_body(def);
    };
}

std::function<void(Stage&)> on_crate(std::function<void(Body)> call) {
    return [call](Stage& stage) { call(stage.crate_body()); };
}
std::function<void(Stage&)> in_world(std::function<void(World&)> call) {
    return [call](Stage& stage) { call(stage.world); };
}
std::function<void(Stage&)> move_platform(const Transform& target, float seconds) {
    return [=](Stage& stage) { stage.world.body(stage.platform).move_to(target, seconds); };
}

const Position nan_position(0.0, nan_double, 0.0);
const Position infinite_position(infinite_double, 0.0, 0.0), far_position(0.0, 0.0, -1.1e15);
const Vec3 nan_vector(not_a_number, 0.0f, 0.0f), infinite_vector(0.0f, infinity, 0.0f);
const Quat zero_rotation(0.0f, 0.0f, 0.0f, 0.0f), nan_rotation(1.0f, 0.0f, not_a_number, 0.0f);
const Quat infinite_rotation(infinity, 0.0f, 0.0f, 0.0f);
const std::string nan_text = "(0, nan, 0)", infinite_text = "(inf, 0, 0)", far_text = "(0, 0, -1.1e+15)";
const std::string nan_vector_text = "(nan, 0, 0)", infinite_vector_text = "(0, inf, 0)";
const std::string zero_rotation_text = "(w 0, x 0, y 0, z 0)", nan_rotation_text = "(w 1, x 0, y nan, z 0)";

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

Plane plane(const Vec3& normal) {
    Plane plane;
    plane.normal = normal;
    return plane;
}
Plane rectangle(const Vec3& tangent, const glm::vec2& half_extents) {
    Plane plane;
    plane.tangent = tangent;
    plane.half_extents = half_extents;
    return plane;
}

std::vector<Refusal> shapes() {
    std::vector<Refusal> rows;
    struct BadSize {
        float size;
        std::string text;
    };
    for (const BadSize& bad : {BadSize{0.0f, "0"}, BadSize{-1.0f, "-1"}, BadSize{not_a_number, "nan"},
                               BadSize{infinity, "inf"}, BadSize{1e10f, "1e+10"}}) {
        const float s = bad.size;
        const auto add_row = [&](int number, const char* name, std::function<void(Stage&)> call, const char* field) {
            rows.push_back(row(number, name, std::move(call), field, bad.text, must_be_a_size));
        };
        add_row(10, "sphere", add(Sphere{s}), "Sphere.radius");
        add_row(10, "overlap sphere", overlap_with(Sphere{s}), "Sphere.radius");
        add_row(11, "box x", add(Box{{s, 1.0f, 1.0f}}), "Box.half_extents.x");
        add_row(11, "box y", add(Box{{1.0f, s, 1.0f}}), "Box.half_extents.y");
        add_row(11, "box z", add(Box{{1.0f, 1.0f, s}}), "Box.half_extents.z");
        add_row(11, "overlap box", overlap_with(Box{{1.0f, 1.0f, s}}), "Box.half_extents.z");
        if (std::isinf(s)) continue; // a strip
        add_row(11, "rectangle x", add_to_ground(rectangle({1.0f, 0.0f, 0.0f}, {s, 1.0f})), "Plane.half_extents.x");
        add_row(11, "rectangle y", add_to_ground(rectangle({1.0f, 0.0f, 0.0f}, {1.0f, s})), "Plane.half_extents.y");
    }
    rows.push_back(row(11, "rectangle without ends", add_to_ground(rectangle({1.0f, 0.0f, 0.0f}, {infinity, infinity})),
                       "Plane.half_extents", "(inf, inf)", "must be finite along one axis, or absent"));
    rows.push_back(row(11, "strip of negative length", add_to_ground(rectangle({1.0f, 0.0f, 0.0f}, {-infinity, 1.0f})),
                       "Plane.half_extents.x", "-inf", must_be_a_size));
    for (const BadSize& bad :
         {BadSize{-1e-3f, "-0.001"}, BadSize{not_a_number, "nan"}, BadSize{infinity, "inf"}, BadSize{2e9f, "2e+09"}}) {
        const std::string expected = "must be a radius in meters from 0 (sharp) to 1e9";
        const std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        Hull hull(corners);
        hull.rounding = bad.size;
        rows.push_back(
            row(11, "rounding of a box", add(Box{Vec3(1.0f), bad.size}), "Box.rounding", bad.text, expected));
        rows.push_back(row(11, "rounding of a cylinder", add(Cylinder{1, 1, {}, bad.size}), "Cylinder.rounding",
                           bad.text, expected));
        rows.push_back(row(11, "rounding of a hull", add(hull), "Hull.rounding", bad.text, expected));
    }
    rows.push_back(row(12, "plane of zero normal", add_to_ground(plane(Vec3(0.0f))), "Plane.normal", "(0, 0, 0)",
                       must_not_be_zero));
    rows.push_back(row(12, "plane of NaN normal", add_to_ground(plane(nan_vector)), "Plane.normal", nan_vector_text,
                       must_be_finite));
    rows.push_back(row(12, "rectangle of zero tangent", add_to_ground(rectangle(Vec3(0.0f), {1.0f, 1.0f})),
                       "Plane.tangent", "(0, 0, 0)", must_not_be_zero));
    rows.push_back(row(12, "rectangle of infinite tangent", add_to_ground(rectangle(infinite_vector, {1.0f, 1.0f})),
                       "Plane.tangent", infinite_vector_text, must_be_finite));
    return rows;
}

std::vector<Refusal> materials() {
    std::vector<Refusal> rows;
    struct BadValue {
        float value;
        std::string text;
    };
    struct Coefficient {
        float Material::*member;
        std::string name;
    };
    for (const BadValue& bad : {BadValue{-0.1f, "-0.1"}, BadValue{not_a_number, "nan"}, BadValue{infinity, "inf"}}) {
        for (const Coefficient& c : {Coefficient{&Material::static_friction, "static_friction"},
                                     Coefficient{&Material::dynamic_friction, "dynamic_friction"},
                                     Coefficient{&Material::rolling_friction, "rolling_friction"},
                                     Coefficient{&Material::torsional_friction, "torsional_friction"}}) {
            rows.push_back(row(13, "add_shape friction", make_material(c.member, bad.value),
                               "ShapeDef.material." + c.name, bad.text, must_be_at_least_0));
            rows.push_back(row(13, "set_material friction", change_material(c.member, bad.value), "Material." + c.name,
                               bad.text, must_be_at_least_0));
        }
        rows.push_back(row(15, "density", make_shape(&ShapeDef::density, bad.value), "ShapeDef.density", bad.text,
                           must_be_at_least_0));
        rows.push_back(row(15, "linear damping", make_body(&BodyDef::linear_damping, bad.value),
                           "BodyDef.linear_damping", bad.text, must_be_at_least_0));
        rows.push_back(row(15, "angular damping", make_body(&BodyDef::angular_damping, bad.value),
                           "BodyDef.angular_damping", bad.text, must_be_at_least_0));
        const float value = bad.value;
        rows.push_back(row(15, "set_damping linear", on_crate([value](Body body) { body.set_damping(value, 0.0f); }),
                           "Body::set_damping linear", bad.text, must_be_at_least_0));
        rows.push_back(row(15, "set_damping angular", on_crate([value](Body body) { body.set_damping(0.0f, value); }),
                           "Body::set_damping angular", bad.text, must_be_at_least_0));
    }
    for (const BadValue& bad :
         {BadValue{-0.1f, "-0.1"}, BadValue{1.1f, "1.1"}, BadValue{not_a_number, "nan"}, BadValue{infinity, "inf"}}) {
        rows.push_back(row(14, "add_shape restitution", make_material(&Material::restitution, bad.value),
                           "ShapeDef.material.restitution", bad.text, "must be from 0 to 1"));
        rows.push_back(row(14, "set_material restitution", change_material(&Material::restitution, bad.value),
                           "Material.restitution", bad.text, "must be from 0 to 1"));
    }
    rows.push_back(row(18, "gravity scale", make_body(&BodyDef::gravity_scale, not_a_number), "BodyDef.gravity_scale",
                       "nan", must_be_finite));
    rows.push_back(row(18, "set_gravity_scale", on_crate([](Body body) { body.set_gravity_scale(infinity); }),
                       "Body::set_gravity_scale", "inf", must_be_finite));
    rows.push_back(row(18, "field strength", change_field(&ForceField::strength, infinity), "ForceField.strength",
                       "inf", must_be_finite));
    rows.push_back(row(18, "field exponent", change_field(&ForceField::exponent, 0.5f), "ForceField.exponent", "0.5",
                       "must be -2, -1, 0 or 1"));
    return rows;
}

std::vector<Refusal> settings_and_steps() {
    std::vector<Refusal> rows;
    struct BadStep {
        float dt;
        std::string text;
    };
    for (const BadStep& bad :
         {BadStep{0.0f, "0"}, BadStep{-frame, "-0.0166667"}, BadStep{not_a_number, "nan"}, BadStep{infinity, "inf"}}) {
        rows.push_back(row(16, "step", step_by(bad.dt), "World::step dt", bad.text, must_be_above_0));
        rows.push_back(
            row(16, "move_to seconds", move_platform({}, bad.dt), "Body::move_to seconds", bad.text, must_be_above_0));
    }
    struct BadCount {
        int count;
        std::string text;
    };
    for (const BadCount& bad :
         {BadCount{0, "0"}, BadCount{-1, "-1"}, BadCount{257, "257"}, BadCount{1000000000, "1000000000"}}) {
        rows.push_back(row(17, "substeps of a new world", make_world(&WorldDef::substeps, bad.count),
                           "WorldDef.substeps", bad.text, "must be from 1 to 256"));
        rows.push_back(row(17, "set_settings substeps", change_settings(&WorldDef::substeps, bad.count),
                           "WorldDef.substeps", bad.text, "must be from 1 to 256"));
    }
    struct Setting {
        float WorldDef::*member;
        std::string name;
    };
    for (const Setting& s :
         {Setting{&WorldDef::sleep_speed, "sleep_speed"}, Setting{&WorldDef::sleep_time, "sleep_time"},
          Setting{&WorldDef::restitution_speed, "restitution_speed"}, Setting{&WorldDef::hit_speed, "hit_speed"}}) {
        rows.push_back(row(17, "set_settings speed", change_settings(s.member, -1.0f), "WorldDef." + s.name, "-1",
                           must_be_at_least_0));
        rows.push_back(row(17, "set_settings speed", change_settings(s.member, not_a_number), "WorldDef." + s.name,
                           "nan", must_be_at_least_0));
    }
    for (const Setting& s : {Setting{&WorldDef::recovery_speed, "recovery_speed"},
                             Setting{&WorldDef::max_linear_speed, "max_linear_speed"},
                             Setting{&WorldDef::max_angular_speed, "max_angular_speed"}}) {
        rows.push_back(
            row(17, "set_settings limit", change_settings(s.member, 0.0f), "WorldDef." + s.name, "0", must_be_above_0));
        rows.push_back(row(17, "set_settings limit", change_settings(s.member, not_a_number), "WorldDef." + s.name,
                           "nan", must_be_above_0));
    }
    rows.push_back(row(19, "zero ray direction",
                       in_world([](World& world) { world.cast_ray(Position(0.0), Vec3(0.0f), 1.0); }),
                       "World::cast_ray direction", "(0, 0, 0)", must_not_be_zero));
    rows.push_back(row(19, "negative ray length",
                       in_world([](World& world) { world.cast_ray(Position(0.0), Vec3(1.0f), -1.0); }),
                       "World::cast_ray max_distance", "-1", "must be >= 0"));
    rows.push_back(row(19, "NaN ray length",
                       in_world([](World& world) { world.cast_ray(Position(0.0), Vec3(1.0f), nan_double); }),
                       "World::cast_ray max_distance", "nan", "must be >= 0"));
    rows.push_back(row(1, "overlap_bounds", in_world([](World& world) {
                           world.overlap_bounds({nan_position, Position(0.0)});
                       }),
                       "World::overlap_bounds bounds", nan_text, "must not be NaN"));
    return rows;
}

// Calls that a body of another type would allow.
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

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, NamesFieldValueAndExpectationAndLeavesTheWorldAsItWas) {
    const Refusal& refusal = GetParam();
    Stage stage;
    const std::uint64_t hash = stage.world.state_hash();
    const Snapshot before = stage.world.save();
    bool thrown = false;
    try {
        refusal.call(stage);
    } catch (const Error& error) {
        thrown = true;
        EXPECT_EQ(error.code(), refusal.code);
        EXPECT_EQ(error.field(), refusal.field);
        EXPECT_EQ(error.value(), refusal.value);
        const std::string got = refusal.value.empty() ? "" : ", got " + refusal.value;
        EXPECT_EQ(std::string(error.what()), refusal.field + ": " + refusal.expected + got);
    }
    EXPECT_TRUE(thrown) << "row " << refusal.row << ", " << refusal.name << ": accepted";
    EXPECT_EQ(stage.world.state_hash(), hash);
    const Snapshot after = stage.world.save();
    EXPECT_TRUE(after.bytes == before.bytes) << "the refused call has changed something";
    EXPECT_EQ(after.definitions, before.definitions) << "the refused call has changed something";
}

// Row, running number, and what the call was, in letters that a test name may have.
std::string test_name(const testing::TestParamInfo<Refusal>& info) {
    std::string name = "Row" + std::to_string(info.param.row) + "_" + std::to_string(info.index) + "_";
    for (const char* c = info.param.name; *c; ++c) name += *c == ' ' || *c == ':' ? '_' : *c;
    return name;
}

INSTANTIATE_TEST_SUITE_P(Positions, Refused, testing::ValuesIn(positions()), test_name);
INSTANTIATE_TEST_SUITE_P(Vectors, Refused, testing::ValuesIn(velocities_and_rotations()), test_name);
INSTANTIATE_TEST_SUITE_P(Masses, Refused, testing::ValuesIn(masses()), test_name);
INSTANTIATE_TEST_SUITE_P(Shapes, Refused, testing::ValuesIn(shapes()), test_name);
INSTANTIATE_TEST_SUITE_P(Materials, Refused, testing::ValuesIn(materials()), test_name);
INSTANTIATE_TEST_SUITE_P(Settings, Refused, testing::ValuesIn(settings_and_steps()), test_name);
INSTANTIATE_TEST_SUITE_P(WrongState, Refused, testing::ValuesIn(wrong_states()), test_name);

// Row 5, second half.
TEST(Accepted, RotationsOfAnyLengthAreNormalized) {
    World world;
    for (const float scale : {1e-6f, 0.5f, 3.0f, 1e6f}) {
        BodyDef def;
        def.rotation = Quat(0.6f * scale, 0.0f, 0.8f * scale, 0.0f);
        const Quat made = world.body(world.create_body(def)).rotation();
        EXPECT_NEAR(made.w, 0.6f, 1e-6f);
        EXPECT_NEAR(made.y, 0.8f, 1e-6f);
        Body body = world.body(world.create_body());
        body.set_rotation(def.rotation);
        EXPECT_NEAR(body.rotation().w, 0.6f, 1e-6f);
    }
}

// A refusal within a world that goes on leaves no trace in what follows.
TEST(Accepted, AWorldGoesOnAsIfARefusedCallHadNotBeen) {
    Stage plain, tried;
    for (const auto& rows : {positions(), velocities_and_rotations(), masses(), shapes(), materials(),
                             settings_and_steps(), wrong_states()})
        for (const Refusal& refusal : rows) EXPECT_THROW(refusal.call(tried), Error) << refusal.name;
    // Worlds are numbered, so handles differ; what moves does not.
    run(plain.world, 60);
    run(tried.world, 60);
    EXPECT_EQ(plain.world.state_hash(), tried.world.state_hash());
}

} // namespace
} // namespace cairn::test
