#include "scene/view.h"

#include "scene/definitions.h"
#include "scene/document.h"

#include <algorithm>
#include <cmath>

namespace cairn::scene {

namespace {

constexpr double radian = 180.0 / 3.14159265358979323846; // degrees
constexpr Range angle_range{0.0, 3.2, false}, size_range{0.0, 1e9, false};

// Returns the direction of a node's z axis; nothing if it is degenerate.
std::optional<glm::dvec3> direction_of_z(const Affine& map) {
    const double length = std::sqrt(glm::dot(map.linear[2], map.linear[2]));
    if (!(length > 1e-12 && length < 1e12)) return std::nullopt;
    return map.linear[2] / length;
}

constexpr Range light_color_range{0.0, 1e6, false}, intensity_range{0.0, 1e12, false},
    cone_range{0.0, 1.5707963268, false};

// Returns nothing if the kind of light is unknown, or if its node has no direction.
std::optional<Light> read_light(const Value& document, const Value& index, const Affine& map) {
    const auto own = extension(document, "KHR_lights_punctual");
    const Value light = element(own ? own->find("lights") : std::nullopt, index, max_definitions, "lights");
    Light result;
    const std::string type = light.require("type").text();
    const auto towards = direction_of_z(map);
    if (type == "point") {
        result.kind = Light::Kind::point;
    } else if (type == "spot" && towards) {
        result.kind = Light::Kind::spot;
        result.outer_cone = 0.78539816339f;
        if (const auto spot = light.find("spot")) {
            if (const auto inner = spot->find("innerConeAngle")) result.inner_cone = inner->real(cone_range);
            if (const auto outer = spot->find("outerConeAngle")) result.outer_cone = outer->real(cone_range);
        }
    } else if (type != "directional" || !towards) {
        return std::nullopt;
    }
    if (!(glm::dot(map.translation, map.translation) < 1e18)) return std::nullopt;
    if (towards) result.towards = Vec3(*towards);
    if (result.kind != Light::Kind::directional) result.position = map.translation;
    if (const auto color = light.find("color")) result.color = color->float_vector3(light_color_range);
    if (const auto intensity = light.find("intensity")) result.intensity = intensity->real(intensity_range);
    if (const auto range = light.find("range"); range && result.kind != Light::Kind::directional)
        result.range = range->real(positive_float);
    return result;
}

std::optional<Camera> read_camera(const Value& document, const Value& index, const Affine& map) {
    const Value camera = element(document.find("cameras"), index, max_definitions, "cameras");
    const auto back = direction_of_z(map); // the camera looks along -z
    if (!back || !(glm::dot(map.translation, map.translation) < 1e18)) return std::nullopt;
    Camera result;
    result.position = map.translation;
    result.target = map.translation - *back;
    if (const auto perspective = camera.find("perspective")) {
        const double angle = perspective->require("yfov").number(angle_range);
        result.vertical_fov_degrees = static_cast<float>(std::clamp(angle * radian, 1.0, 170.0));
    } else if (const auto orthographic = camera.find("orthographic")) {
        // Placed at the distance from which the vertical angle covers the height of the orthographic view.
        const double height = orthographic->require("ymag").number(size_range);
        const double half_angle = 0.5 * static_cast<double>(result.vertical_fov_degrees) / radian;
        result.is_orthographic = true;
        result.target = map.translation;
        result.position = map.translation + *back * (height / std::tan(half_angle));
    } else {
        return std::nullopt;
    }
    return result;
}

} // namespace

bool read_view(const Value& document, const Value& node, const Affine& map, SceneInfo& info) {
    const auto lamp = extension(node, "KHR_lights_punctual");
    if (const auto index = lamp ? lamp->find("light") : std::nullopt)
        if (const auto light = read_light(document, *index, map)) info.lights.push_back(*light);
    const auto index = node.find("camera");
    if (!index || info.camera) return false;
    info.camera = read_camera(document, *index, map);
    return info.camera.has_value();
}

void aim_camera(const World& world, Camera& camera) {
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (const BodyId id : world.bodies()) {
        if (world.body(id).type() != BodyType::dynamic) continue;
        sum += glm::dvec3(world.body(id).center_of_mass());
        count += 1.0;
    }
    const glm::dvec3 view = glm::dvec3(camera.target) - glm::dvec3(camera.position), along = glm::normalize(view);
    const glm::dvec3 middle = count > 0.0 ? sum / count : glm::dvec3(0.0);
    const double distance = glm::dot(middle - glm::dvec3(camera.position), along);
    camera.target = camera.position + Position(along * std::max(distance, 1.0));
    // The view of an orthographic camera depends on its distance from the target, not on its position along the axis.
    if (camera.is_orthographic) camera.position = camera.target - Position(view);
}

} // namespace cairn::scene
