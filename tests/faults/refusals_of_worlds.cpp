// Refused arguments of shapes, materials, settings, force fields and steps.
#include "refusals.h"

namespace cairn::test {
namespace {

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

} // namespace

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
    rows.push_back(row(18, "field half_extents", change_field(&ForceField::half_extents, Vec3(1, 0, 1)),
                       "ForceField.half_extents", "0", "must be > 0"));
    rows.push_back(row(18, "field density", change_field(&ForceField::density, -1.0f), "ForceField.density", "-1",
                       "must be finite and >= 0"));
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
    for (const BadCount& bad : {BadCount{-1, "-1"}, BadCount{257, "257"}, BadCount{1000000000, "1000000000"}}) {
        rows.push_back(row(17, "substeps of a new world", make_world(&WorldDef::substeps, bad.count),
                           "WorldDef.substeps", bad.text,
                           "must be from 1 to 256, or 0 to choose by the length of the step"));
        rows.push_back(row(17, "set_settings substeps", change_settings(&WorldDef::substeps, bad.count),
                           "WorldDef.substeps", bad.text,
                           "must be from 1 to 256, or 0 to choose by the length of the step"));
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

} // namespace cairn::test
