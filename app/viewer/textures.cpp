#include "viewer/textures.h"

#include <cairn/error.h>

#include <png.h>
#include <turbojpeg.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace cairn::viewer {

namespace {

constexpr std::size_t channels = 4;

void require_size(std::uint64_t width, std::uint64_t height) {
    if (width == 0 || height == 0 || width > max_texture_pixels / height)
        throw Error(ErrorCode::unsupported, "texture", std::to_string(width) + " x " + std::to_string(height),
                    "must have 1 to " + std::to_string(max_texture_pixels) + " pixels");
}

[[noreturn]] void fail(const char* what, const std::string& why) {
    throw Error(ErrorCode::invalid_file, "texture", {}, std::string("cannot be read as a ") + what + ": " + why);
}

void make_room(TexturePicture& picture, std::uint64_t width, std::uint64_t height) {
    require_size(width, height);
    picture.width = int(width), picture.height = int(height);
    picture.texels.resize(channels * width * height);
}

void read_png(const std::string& file, TexturePicture& picture) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    struct Free {
        png_image& image;
        ~Free() { png_image_free(&image); }
    } const free{image};
    if (!png_image_begin_read_from_memory(&image, file.data(), file.size())) fail("PNG picture", image.message);
    make_room(picture, image.width, image.height);
    image.format = PNG_FORMAT_RGBA;
    if (!png_image_finish_read(&image, nullptr, picture.texels.data(), 0, nullptr)) fail("PNG picture", image.message);
}

void read_jpeg(const std::string& file, TexturePicture& picture) {
    const std::unique_ptr<void, int (*)(tjhandle)> reader(tjInitDecompress(), tjDestroy);
    if (!reader) fail("JPEG picture", tjGetErrorStr2(nullptr));
    const auto* bytes = reinterpret_cast<const unsigned char*>(file.data()); // characters as bytes
    const auto size = static_cast<unsigned long>(file.size());
    int width = 0, height = 0, sampling = 0, colors = 0;
    if (tjDecompressHeader3(reader.get(), bytes, size, &width, &height, &sampling, &colors) != 0)
        fail("JPEG picture", tjGetErrorStr2(reader.get()));
    make_room(picture, std::uint64_t(width), std::uint64_t(height));
    if (tjDecompress2(reader.get(), bytes, size, picture.texels.data(), width, 0, height, TJPF_RGBA, 0) != 0 &&
        tjGetErrorCode(reader.get()) != TJERR_WARNING)
        fail("JPEG picture", tjGetErrorStr2(reader.get()));
}

// Halves the resolution; each texel is the mean of up to four.
void halve(TexturePicture& picture) {
    const int width = std::max(picture.width / 2, 1), height = std::max(picture.height / 2, 1);
    std::vector<std::uint8_t> texels(channels * std::size_t(width) * std::size_t(height));
    const auto at = [&](int x, int y, std::size_t channel) {
        const int column = std::min(x, picture.width - 1), row = std::min(y, picture.height - 1);
        return unsigned(
            picture.texels[channels * (std::size_t(row) * std::size_t(picture.width) + std::size_t(column)) + channel]);
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (std::size_t c = 0; c < channels; ++c) {
                const unsigned sum = at(2 * x, 2 * y, c) + at(2 * x + 1, 2 * y, c) + at(2 * x, 2 * y + 1, c) +
                                     at(2 * x + 1, 2 * y + 1, c);
                texels[channels * (std::size_t(y) * std::size_t(width) + std::size_t(x)) + c] =
                    std::uint8_t((sum + 2) / 4);
            }
    picture.width = width, picture.height = height;
    picture.texels = std::move(texels);
}

} // namespace

TexturePicture read_texture(std::shared_ptr<const std::string> file, const TextureStyle& style) {
    TexturePicture picture;
    picture.style = style;
    if (file && std::string_view(*file).substr(0, 4) == "\x89PNG")
        read_png(*file, picture);
    else if (file && std::string_view(*file).substr(0, 2) == "\xFF\xD8")
        read_jpeg(*file, picture);
    else
        fail("picture", "it is neither PNG nor JPEG");
    while (std::max(picture.width, picture.height) > longest_texture_edge) halve(picture);
    picture.file = std::move(file);
    return picture;
}

} // namespace cairn::viewer
