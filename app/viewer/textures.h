/// \file textures.h
/// Pictures that cover the meshes of a scene.
#pragma once

#include <cairn/math.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cairn::viewer {

/// How a picture goes on beyond its edges, how it looks from nearby, and where it is not drawn.
struct TextureStyle {
    enum class Wrap { repeat, mirror, clamp };
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
    bool is_smooth = true;     ///< Colors go over into each other; else each texel is flat.
    float alpha_cutoff = 0.0f; ///< What has less alpha, 0 to 1, is not drawn.
    bool is_data = false;      ///< Its texels are numbers, not colors in sRGB.
};

/// A picture, ready to be drawn with. It never changes: meshes share it.
struct TexturePicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> texels; ///< Red, green, blue and alpha, rows from the top; colors are sRGB.
    TextureStyle style;
    std::shared_ptr<const std::string> file; ///< What it was read from.
};

/// How a surface meets the light, beside its color. Its pictures lie where that of the color lies; null ones are none.
struct Finish {
    float roughness = 1.0f; ///< 0, a mirror, to 1.
    float metalness = 0.0f; ///< 0, or 1: a metal, which mirrors in its own color and has no other.
    std::shared_ptr<const TexturePicture> rough{}; ///< Green multiplies `roughness`, blue `metalness`.
    /// Normals as colors, 0 to 1 for -1 to 1: red to the right in the picture, green up, blue outward.
    std::shared_ptr<const TexturePicture> normals{};
    float normal_scale = 1.0f;                     ///< Multiplies red and green of `normals`.
    Vec3 glow{0.0f, 0.0f, 0.0f};                   ///< Light of the surface itself, linear, 0 to 1 each,
    float glow_strength = 1.0f;                    ///< times this, >= 0.
    std::shared_ptr<const TexturePicture> glows{}; ///< Its colors are multiplied with `glow`.
};

/// Pictures with a longer edge are made smaller, by halves.
inline constexpr int longest_texture_edge = 4096;
/// Pictures of more pixels are refused.
inline constexpr std::uint64_t max_texture_pixels = std::uint64_t{1} << 26;

/// Reads a PNG or JPEG file. Throws `Error` (invalid_file, unsupported) if it is none, is damaged, or is too large.
TexturePicture read_texture(std::shared_ptr<const std::string> file, const TextureStyle& style);

} // namespace cairn::viewer
