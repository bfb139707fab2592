#include "scene/world_settings.h"

#include "scene/json_number.h"
#include "scene/spelling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cairn::scene {

namespace {

constexpr std::size_t max_force_fields = 1000;

struct NamedIntegrator {
    const char* name;
    Integrator integrator;
};
constexpr std::array<NamedIntegrator, 3> integrators{{
    {"semi_implicit_euler", Integrator::semi_implicit_euler},
    {"explicit_euler", Integrator::explicit_euler},
    {"rk4", Integrator::rk4},
}};

Integrator read_integrator(const Value& value) {
    const std::string name = value.text();
    for (const NamedIntegrator& known : integrators) {
        if (name == known.name) return known.integrator;
    }
    value.fail("must be \"semi_implicit_euler\", \"explicit_euler\" or \"rk4\"");
}

std::string integrator_name(Integrator integrator) {
    const auto found = std::find_if(integrators.begin(), integrators.end(),
                                    [&](const NamedIntegrator& known) { return known.integrator == integrator; });
    return found->name;
}

Camera read_camera(const Value& value) {
    Camera camera;
    camera.position = value.require("position").vector3();
    const Value target = value.require("target");
    camera.target = target.vector3();
    if (camera.target == camera.position) target.fail("must not be the camera's own position");
    if (const auto angle = value.find("vertical_fov_degrees")) {
        camera.vertical_fov_degrees = angle->real({1.0, 170.0, false});
    }
    if (const auto orthographic = value.find("orthographic")) camera.is_orthographic = orthographic->boolean();
    return camera;
}

// Reads half extents; null stands for infinite.
Vec3 read_half_extents(const Value& value) {
    if (!value.is_array() || value.size(3, "numbers") != 3) value.fail("must be an array of 3 numbers > 0 or null");
    Vec3 half(std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < 3; ++i)
        if (!value[i].is_null()) half[static_cast<int>(i)] = value[i].real(positive_float);
    return half;
}

void read_fluid(const Value& value, ForceField& field) {
    field.kind = ForceField::Kind::fluid;
    field.center = value.require("center").vector3();
    if (const auto flow = value.find("direction")) field.direction = flow->float_vector3();
    if (const auto half = value.find("half_extents")) field.half_extents = read_half_extents(*half);
    if (const auto density = value.find("density")) field.density = density->real(nonnegative_float);
    if (const auto drag = value.find("drag")) field.drag = drag->real(nonnegative_float);
    if (const auto friction = value.find("skin_friction")) field.skin_friction = friction->real(nonnegative_float);
    if (const auto mass = value.find("added_mass")) field.added_mass = mass->real(nonnegative_float);
    if (const auto damping = value.find("wave_damping")) field.wave_damping = damping->real(nonnegative_float);
}

nlohmann::ordered_json write_fluid(const ForceField& field) {
    nlohmann::ordered_json json;
    json["kind"] = "fluid";
    json["center"] = number_array(field.center);
    if (field.direction != Vec3(0.0f)) json["direction"] = number_array(field.direction);
    bool is_endless = true;
    nlohmann::ordered_json half = nlohmann::ordered_json::array();
    for (int i = 0; i < 3; ++i) {
        const bool is_finite = std::isfinite(field.half_extents[i]);
        is_endless = is_endless && !is_finite;
        half.push_back(is_finite ? nlohmann::ordered_json(shortest(field.half_extents[i])) : nlohmann::ordered_json());
    }
    if (!is_endless) json["half_extents"] = half;
    json["density"] = shortest(field.density);
    json["drag"] = shortest(field.drag);
    json["skin_friction"] = shortest(field.skin_friction);
    json["added_mass"] = shortest(field.added_mass);
    json["wave_damping"] = shortest(field.wave_damping);
    return json;
}

ForceField read_force_field(const Value& value) {
    ForceField field;
    const Value kind = value.require("kind");
    const std::string name = kind.text();
    if (name == "uniform") {
        field.kind = ForceField::Kind::uniform;
        field.direction = value.require("direction").float_vector3();
    } else if (name == "radial") {
        field.kind = ForceField::Kind::radial;
        field.center = value.require("center").vector3();
        field.strength = value.require("strength").real();
        if (const auto exponent = value.find("exponent")) {
            field.exponent = static_cast<float>(exponent->integer(-2, 1));
        }
    } else if (name == "fluid") {
        read_fluid(value, field);
    } else {
        kind.fail("must be \"uniform\", \"radial\" or \"fluid\"");
    }
    if (const auto is_force = value.find("is_force")) field.is_force = is_force->boolean();
    return field;
}

nlohmann::ordered_json write_force_field(const ForceField& field) {
    if (field.kind == ForceField::Kind::fluid) return write_fluid(field);
    nlohmann::ordered_json json;
    if (field.kind == ForceField::Kind::uniform) {
        json["kind"] = "uniform";
        json["direction"] = number_array(field.direction);
    } else {
        json["kind"] = "radial";
        json["center"] = number_array(field.center);
        json["strength"] = shortest(field.strength);
        json["exponent"] = static_cast<int>(field.exponent);
    }
    if (field.is_force) json["is_force"] = true;
    return json;
}

void read_scalars(const Value& settings, WorldDef& world, SceneInfo& info) {
    if (const auto v = settings.find("time_step")) info.time_step = v->real({0.0001, 1.0, false});
    if (const auto v = settings.find("gravity")) world.gravity = v->float_vector3();
    if (const auto v = settings.find("substeps")) world.substeps = v->integer(0, 256);
    if (const auto v = settings.find("adaptive_substeps")) world.adaptive_substeps = v->boolean();
    if (const auto v = settings.find("integrator")) world.integrator = read_integrator(*v);
    if (const auto v = settings.find("sleep")) world.enable_sleep = v->boolean();
    if (const auto v = settings.find("sleep_speed")) world.sleep_speed = v->real(nonnegative_float);
    if (const auto v = settings.find("sleep_time")) world.sleep_time = v->real(nonnegative_float);
    if (const auto v = settings.find("restitution_speed")) world.restitution_speed = v->real(nonnegative_float);
    if (const auto v = settings.find("hit_speed")) world.hit_speed = v->real(nonnegative_float);
    if (const auto v = settings.find("recovery_speed")) world.recovery_speed = v->real(positive_float);
    if (const auto v = settings.find("max_linear_speed")) world.max_linear_speed = v->real(positive_float);
    if (const auto v = settings.find("max_angular_speed")) world.max_angular_speed = v->real(positive_float);
}

} // namespace

void read_title(const Value& settings, SceneInfo& info) {
    if (const auto title = settings.find("title")) info.title = title->text();
    if (const auto hint = settings.find("hint")) info.hint = hint->text();
}

WorldSettings read_world_settings(const Value& settings, std::vector<std::string>& warnings) {
    WorldSettings result;
    read_title(settings, result.info);
    read_scalars(settings, result.world, result.info);
    if (const auto camera = settings.find("camera")) {
        result.info.camera = read_camera(*camera);
        warn_of_unknown_members(*camera, {"position", "target", "vertical_fov_degrees", "orthographic"}, warnings);
    }
    if (const auto fields = settings.find("force_fields")) {
        const std::size_t count = fields->size(max_force_fields, "force fields");
        for (std::size_t i = 0; i < count; ++i) {
            result.info.force_fields.push_back(read_force_field((*fields)[i]));
            warn_of_unknown_members((*fields)[i],
                                    {"kind", "direction", "center", "strength", "exponent", "is_force", "half_extents",
                                     "density", "drag", "skin_friction", "added_mass", "wave_damping"},
                                    warnings);
        }
    }
    static const std::vector<std::string> known{"title",
                                                "hint",
                                                "time_step",
                                                "gravity",
                                                "substeps",
                                                "adaptive_substeps",
                                                "integrator",
                                                "sleep",
                                                "sleep_speed",
                                                "sleep_time",
                                                "restitution_speed",
                                                "hit_speed",
                                                "recovery_speed",
                                                "max_linear_speed",
                                                "max_angular_speed",
                                                "camera",
                                                "force_fields"};
    warn_of_unknown_members(settings, known, warnings);
    return result;
}

nlohmann::ordered_json write_world_settings(const WorldDef& world, const SceneInfo& info) {
    nlohmann::ordered_json json;
    json["title"] = info.title;
    json["hint"] = info.hint;
    json["time_step"] = shortest(info.time_step);
    json["gravity"] = number_array(world.gravity);
    json["substeps"] = world.substeps;
    json["adaptive_substeps"] = world.adaptive_substeps;
    json["integrator"] = integrator_name(world.integrator);
    json["sleep"] = world.enable_sleep;
    json["sleep_speed"] = shortest(world.sleep_speed);
    json["sleep_time"] = shortest(world.sleep_time);
    json["restitution_speed"] = shortest(world.restitution_speed);
    json["hit_speed"] = shortest(world.hit_speed);
    json["recovery_speed"] = shortest(world.recovery_speed);
    json["max_linear_speed"] = shortest(world.max_linear_speed);
    json["max_angular_speed"] = shortest(world.max_angular_speed);
    if (info.camera) {
        json["camera"] = {{"position", number_array(info.camera->position)},
                          {"target", number_array(info.camera->target)},
                          {"vertical_fov_degrees", shortest(info.camera->vertical_fov_degrees)}};
        if (info.camera->is_orthographic) json["camera"]["orthographic"] = true;
    }
    if (!info.force_fields.empty()) {
        for (const ForceField& field : info.force_fields) json["force_fields"].push_back(write_force_field(field));
    }
    return json;
}

} // namespace cairn::scene
