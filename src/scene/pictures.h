// Pictures in the files that a model names, and procedural pictures.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace cairn::scene {

// Whether the file is a PNG or JPEG file, by its first bytes.
bool is_picture(std::string_view file);

// Picture files, each read once.
class Pictures {
  public:
    // `shown` is the name of the file in the model, at `place` in it. Throws Error: unsupported if it is neither PNG
    // nor JPEG.
    std::shared_ptr<const std::string> read(const std::filesystem::path& file, const std::string& place,
                                            const std::string& shown);

  private:
    std::map<std::filesystem::path, std::shared_ptr<const std::string>> read_;
};

// Returns a PNG file of `width` times `height` pixels in rows from the top left corner. Pixels are indices into up to
// 256 colors in sRGB.
std::string png_file(std::size_t width, std::size_t height, std::span<const std::uint8_t> pixels,
                     std::span<const std::array<std::uint8_t, 3>> colors);

} // namespace cairn::scene
