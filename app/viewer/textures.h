/// \file textures.h
/// Textures of a scene's meshes.
#pragma once

#include <cairn/math.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cairn::viewer {

/// Wrapping, filtering and alpha test of a texture.
struct TextureStyle {
    enum class Wrap { repeat, mirror, clamp };
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
    bool is_smooth = true;     ///< Linear filtering; else nearest texel.
    float alpha_cutoff = 0.0f; ///< Texels with less alpha, 0 to 1, are not drawn.
    bool is_data = false;      ///< Texels are numeric data, not sRGB colors.
};

/// A decoded texture. It is immutable, and shared by meshes.
struct TexturePicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> texels; ///< Red, green, blue and alpha, rows from the top; colors are sRGB.
    TextureStyle style;
    std::shared_ptr<const std::string> file; ///< The file that it was read from.
};

/// Material of a surface, besides its color. Its textures use the texture coordinates of the color; null: none.
struct Finish {
    float roughness = 1.0f; ///< 0 (a mirror) to 1.
    float metalness = 0.0f; ///< 0, or 1 for a metal, which reflects in its own color and has no diffuse color.
    std::shared_ptr<const TexturePicture> rough{}; ///< Green multiplies `roughness`, blue `metalness`.
    /// Normal map: 0 to 1 encodes -1 to 1; red to the right in the texture, green up, blue outward.
    std::shared_ptr<const TexturePicture> normals{};
    float normal_scale = 1.0f;                     ///< Multiplies red and green of `normals`.
    Vec3 glow{0.0f, 0.0f, 0.0f};                   ///< Emitted light, linear, 0 to 1 each,
    float glow_strength = 1.0f;                    ///< times this, >= 0.
    std::shared_ptr<const TexturePicture> glows{}; ///< Its colors multiply `glow`.
};

/// Greatest edge of a texture in texels; larger ones are repeatedly halved.
inline constexpr int longest_texture_edge = 4096;
/// Greatest number of texels of a texture; larger ones are rejected.
inline constexpr std::uint64_t max_texture_pixels = std::uint64_t{1} << 26;

/// Reads a PNG or JPEG file. Throws `Error` (invalid_file, unsupported) if it is neither, is damaged, or is too large.
TexturePicture read_texture(std::shared_ptr<const std::string> file, const TextureStyle& style);

} // namespace cairn::viewer
