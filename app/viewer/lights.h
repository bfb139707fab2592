/// \file lights.h
/// The lights of scenes, and how bright they are in the picture.
#pragma once

#include <cairn/cairn.h>

#include <cstddef>
#include <span>
#include <vector>

namespace cairn::viewer {

/// A light of a scene, as KHR_lights_punctual has it.
struct Light {
    enum class Kind { directional, point, spot };
    Kind kind = Kind::directional;
    Vec3 color{1.0f, 1.0f, 1.0f};      ///< Linear.
    float intensity = 1.0f;            ///< Lux of a directional light, candela of others.
    Position position{0.0, 0.0, 0.0};  ///< Meters; of no meaning for a directional one.
    Vec3 towards{0.0f, 1.0f, 0.0f};    ///< Unit, against the way it shines; of no meaning for a point.
    float range = 0.0f;                ///< Meters, beyond which it does not shine; 0: it has no end.
    float inner_cone = 0.0f;           ///< Of a spot: rad from its axis up to which it shines in full,
    float outer_cone = 0.78539816339f; ///< and where its light ends.
};

/// A light without a shadow, as bright as in the picture.
struct Lamp {
    Light light;
    Vec3 color{0.0f, 0.0f, 0.0f}; ///< Of a surface that faces it, in a distance of a meter if it has a place.
};

inline constexpr std::size_t max_lamps = 8;

/// What shines in a picture.
struct Lighting {
    Vec3 to_sun{-0.60f, 0.74f, 0.30f}; ///< Unit or not; what shines from there throws the shadows.
    Vec3 sun{1.85f, 1.7205f, 1.517f};  ///< Color of a white surface that faces it.
    std::vector<Lamp> lamps{};         ///< No more than `max_lamps`.
};

/// The light of every scene where `lights` is empty. The first directional one is the sun, and the brightest of the
/// others, as seen from `middle`, are lamps. Lights keep their proportions; all together are as bright as the brightest
/// one to an eye that adapts: ten times the intensity is 1.4 times as bright, up to a bound. Without a directional
/// light that of every scene shines at a third, for its shadows.
Lighting lighting_of(std::span<const Light> lights, const Position& middle);

} // namespace cairn::viewer
