#include "viewer/lights.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace cairn::viewer {

namespace {

constexpr float full = 1.85f; // brightness of a light of intensity 1
constexpr float adaption = 0.15f, dimmest = 0.4f, brightest = 1.6f;
constexpr double nearest = 0.5; // m
constexpr float dimmed_sun = 1.0f / 3.0f;

// Illuminance in lux of a surface at `middle` that faces the light.
float illuminance(const Light& light, const Position& middle) {
    const float strength = light.intensity * std::max({light.color.x, light.color.y, light.color.z});
    if (light.kind == Light::Kind::directional) return strength;
    const double distance = std::max(glm::length(glm::dvec3(middle - light.position)), nearest);
    return float(double(strength) / (distance * distance));
}

} // namespace

Lighting lighting_of(std::span<const Light> lights, const Position& middle) {
    Lighting result;
    if (lights.empty()) return result;
    float greatest = 0.0f;
    for (const Light& light : lights) greatest = std::max(greatest, illuminance(light, middle));
    const float shown = full * std::clamp(std::pow(greatest, adaption), dimmest, brightest);
    const float scale = greatest > 0.0f ? shown / greatest : 0.0f;
    bool has_sun = false;
    for (const Light& light : lights) {
        const Vec3 color = light.color * (light.intensity * scale);
        if (light.kind == Light::Kind::directional && !has_sun) {
            has_sun = true;
            result.to_sun = light.towards;
            result.sun = color;
        } else {
            result.lamps.push_back({light, color});
        }
    }
    if (!has_sun) result.sun *= dimmed_sun;
    std::stable_sort(result.lamps.begin(), result.lamps.end(), [&](const Lamp& a, const Lamp& b) {
        return illuminance(a.light, middle) > illuminance(b.light, middle);
    });
    if (result.lamps.size() > max_lamps) result.lamps.resize(max_lamps);
    return result;
}

} // namespace cairn::viewer
