/// \file palette.h
/// Colors. The ramps suit the common kinds of color blindness: their lightness varies too, and they never rely on red
/// against green. All results are linear; `srgb` converts them for the user interface.
#pragma once

#include <cairn/math.h>
#include <cairn/shape.h>

#include <cstdint>

namespace cairn::viewer {

/// Converts 0xRRGGBB in sRGB to linear.
Vec3 linear_color(std::uint32_t srgb_hex);
/// Converts linear to sRGB, 0..1.
Vec3 srgb(const Vec3& linear);

/// Blue (0, light) over a pale middle to red (1, heavy).
Vec3 mass_ramp(float fraction);
/// Dark violet (0, slow) over green to yellow (1, fast).
Vec3 speed_ramp(float fraction);
/// Position of a mass between the least and the greatest, on a logarithmic scale, 0 to 1; 1 for an infinite mass.
float mass_fraction(float mass, float least, float greatest);
/// Position of a speed between 0 and `fast_speed`, on a scale that resolves slow speeds better, 0 to 1.
float speed_fraction(float speed);
inline constexpr float fast_speed = 10.0f; // m/s, end of the speed color scale

/// A category color that differs between consecutive numbers.
Vec3 category_color(std::uint32_t number);
/// A muted color for bodies without one from the scene.
Vec3 default_color(std::uint32_t number);

/// Blue (0, unloaded) over white-green to yellow (1, about to break): for joints, visible over any body.
Vec3 joint_ramp(float fraction);
Vec3 joint_error_color();
/// Color of the line from a dragged body to the cursor.
Vec3 drag_color();
/// Color of the marks around the selected body.
Vec3 selection_color();

Vec3 static_color();
Vec3 sleeping_color();
Vec3 ground_color();
Vec3 surface_color();  ///< Color of triangle meshes.
Vec3 trigger_color();  ///< Color of the outlines of triggers.
Vec3 disabled_color(); ///< Color of the outlines of disabled bodies, and of disabled joints.
Vec3 terrain_color();  ///< Color of the level parts of height fields.

/// A color for every kind of shape; planes have that of static bodies.
Vec3 shape_color(ShapeType type);

} // namespace cairn::viewer
