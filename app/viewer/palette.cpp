#include "viewer/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cairn::viewer {

namespace {

float linear_from_srgb(float value) {
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

float srgb_from_linear(float value) {
    value = std::clamp(value, 0.0f, 1.0f);
    return value <= 0.0031308f ? value * 12.92f : 1.055f * std::pow(value, 1.0f / 2.4f) - 0.055f;
}

// Interpolates between equally spaced stops in sRGB values, where equal steps look equal.
template <std::size_t N> Vec3 ramp(const std::array<std::uint32_t, N>& stops, float fraction) {
    const float place = std::clamp(fraction, 0.0f, 1.0f) * float(N - 1);
    const std::size_t index = std::min(std::size_t(place), N - 2);
    const float t = place - float(index);
    const Vec3 mixed = srgb(linear_color(stops[index])) * (1.0f - t) + srgb(linear_color(stops[index + 1])) * t;
    return {linear_from_srgb(mixed.x), linear_from_srgb(mixed.y), linear_from_srgb(mixed.z)};
}

// ColorBrewer's RdYlBu, reversed: safe for color-blind viewers, and distinguishable by lightness alone.
constexpr std::array<std::uint32_t, 5> mass_stops{0x2c5fa8, 0x74add1, 0xf1ead2, 0xf08a54, 0xb81d2c};
// After Matplotlib's viridis, which is perceptually uniform; its dark end is lightened, so that shading remains
// visible.
constexpr std::array<std::uint32_t, 5> speed_stops{0x58358a, 0x3b528b, 0x21918c, 0x5ec962, 0xfde725};
constexpr std::array<std::uint32_t, 3> joint_stops{0x35b6ff, 0xc8f0c0, 0xffd21f};
// After Okabe and Ito (2008), desaturated.
constexpr std::array<std::uint32_t, 7> calm_colors{0xd9853b, 0x4d94b8, 0x5a9a7a, 0xc9b458,
                                                   0x3f6d94, 0xb8604a, 0x9a7ba6};

} // namespace

Vec3 linear_color(std::uint32_t srgb_hex) {
    const auto channel = [srgb_hex](int shift) { return linear_from_srgb(float((srgb_hex >> shift) & 0xff) / 255.0f); };
    return {channel(16), channel(8), channel(0)};
}

Vec3 srgb(const Vec3& linear) {
    return {srgb_from_linear(linear.x), srgb_from_linear(linear.y), srgb_from_linear(linear.z)};
}

Vec3 mass_ramp(float fraction) { return ramp(mass_stops, fraction); }

Vec3 speed_ramp(float fraction) { return ramp(speed_stops, fraction); }

Vec3 joint_ramp(float fraction) { return ramp(joint_stops, fraction); }

Vec3 joint_error_color() { return linear_color(0xff2a2a); }

Vec3 drag_color() { return linear_color(0xffd040); }
Vec3 selection_color() { return linear_color(0xfff4d0); }

float mass_fraction(float mass, float least, float greatest) {
    if (!std::isfinite(mass)) return 1.0f;
    if (!(greatest > least * 1.0001f) || !(least > 0.0f)) return 0.5f;
    return std::clamp(std::log(mass / least) / std::log(greatest / least), 0.0f, 1.0f);
}

float speed_fraction(float speed) { return std::sqrt(std::clamp(speed / fast_speed, 0.0f, 1.0f)); }

Vec3 category_color(std::uint32_t number) {
    // Hues by the golden ratio: consecutive numbers are far apart. Alternating lightness helps where few hues are
    // distinguished.
    const float hue = std::fmod(float(number % 4096u) * 0.6180340f, 1.0f) * 6.0f;
    const auto channel = [hue](float shift) {
        return std::clamp(std::abs(std::fmod(hue + shift, 6.0f) - 3.0f) - 1.0f, 0.0f, 1.0f);
    };
    const float value = number % 2 == 0 ? 0.80f : 0.50f;
    return Vec3(0.12f) + (Vec3(channel(0.0f), channel(4.0f), channel(2.0f)) * 0.75f + Vec3(0.10f)) * (value * 0.8f);
}

Vec3 default_color(std::uint32_t number) { return linear_color(calm_colors[number % calm_colors.size()]); }

Vec3 static_color() { return linear_color(0x8b8e8e); }

Vec3 sleeping_color() { return linear_color(0x6d737a); }

Vec3 ground_color() { return linear_color(0x9fa39f); }

Vec3 surface_color() { return linear_color(0xa89d89); }

Vec3 trigger_color() { return linear_color(0xe8f4ff); }

Vec3 disabled_color() { return linear_color(0x9aa0a6); }

Vec3 terrain_color() { return linear_color(0x78836a); }

Vec3 shape_color(ShapeType type) {
    switch (type) { // Okabe and Ito (2008)
    case ShapeType::sphere:
        return linear_color(0x0072b2);
    case ShapeType::box:
        return linear_color(0xe69f00);
    case ShapeType::capsule:
        return linear_color(0x009e73);
    case ShapeType::cylinder:
        return linear_color(0xcc79a7);
    case ShapeType::hull:
        return linear_color(0xd55e00);
    case ShapeType::mesh:
        return surface_color();
    case ShapeType::height_field:
        return terrain_color();
    case ShapeType::plane:
    case ShapeType::rectangle:
        break;
    }
    return static_color();
}

} // namespace cairn::viewer
