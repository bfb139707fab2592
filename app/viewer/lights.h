/// \file lights.h
/// The lights of scenes, and their brightness in the picture.
#pragma once

#include <cairn/cairn.h>

#include <cstddef>
#include <span>
#include <vector>

namespace cairn::viewer {

/// A light of a scene, as defined by KHR_lights_punctual.
struct Light {
    enum class Kind { directional, point, spot };
    Kind kind = Kind::directional;
    Vec3 color{1.0f, 1.0f, 1.0f};      ///< Linear.
    float intensity = 1.0f;            ///< Lux for a directional light, candela for other kinds.
    Position position{0.0, 0.0, 0.0};  ///< Meters; unused for a directional light.
    Vec3 towards{0.0f, 1.0f, 0.0f};    ///< Unit vector against the direction of the light; unused for a point light.
    float range = 0.0f;                ///< Distance beyond which the light ends, meters; 0: infinite.
    float inner_cone = 0.0f;           ///< Spot light: angle from its axis up to which it has full intensity, rad,
    float outer_cone = 0.78539816339f; ///< and angle at which its intensity becomes zero.
};

/// A light without shadows, with its brightness in the picture.
struct Lamp {
    Light light;
    /// Color of a white surface that faces the lamp, at a distance of a meter unless it is directional.
    Vec3 color{0.0f, 0.0f, 0.0f};
};

inline constexpr std::size_t max_lamps = 8;

/// The lights of a picture.
struct Lighting {
    /// Direction to the sun, not necessarily unit; the sun is the only light that casts shadows.
    Vec3 to_sun{-0.60f, 0.74f, 0.30f};
    Vec3 sun{1.85f, 1.7205f, 1.517f}; ///< Color of a white surface that faces the sun.
    std::vector<Lamp> lamps{};        ///< At most `max_lamps`.
};

/// The lighting of a scene with those lights; the default lighting if `lights` is empty. The first directional light
/// becomes the sun, and the brightest of the others, as seen from `middle`, become lamps. Intensities keep their
/// ratios; the overall exposure follows the brightest light as an eye adapts: ten times the intensity is 1.4 times as
/// bright, up to a bound. Without a directional light, the default sun shines at a third of its intensity, to cast
/// shadows.
Lighting lighting_of(std::span<const Light> lights, const Position& middle);

} // namespace cairn::viewer
