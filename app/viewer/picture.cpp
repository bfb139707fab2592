#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
#include <stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include "viewer/headless.h"

#include "files/output_file.h"

#include <cairn/error.h>

#include <string>

namespace cairn::viewer {

std::vector<std::string_view> picture_extensions() { return {".png", ".jpg", ".jpeg"}; }

void write_picture(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgb) {
    if (width < 1 || height < 1 || rgb.size() != 3u * std::size_t(width) * std::size_t(height))
        throw Error(ErrorCode::invalid_value, "write_picture", std::to_string(rgb.size()),
                    "must have 3 x width x height bytes");
    std::string file;
    const auto append = [](void* context, void* data, int size) {
        static_cast<std::string*>(context)->append(static_cast<const char*>(data), std::size_t(size));
    };
    constexpr int jpeg_quality = 92;
    const std::string extension = files::extension_of(path);
    const bool is_jpeg = extension == ".jpg" || extension == ".jpeg";
    const int encoded = is_jpeg ? stbi_write_jpg_to_func(append, &file, width, height, 3, rgb.data(), jpeg_quality)
                                : stbi_write_png_to_func(append, &file, width, height, 3, rgb.data(), 3 * width);
    if (encoded == 0) throw Error(ErrorCode::io, path.string(), {}, "cannot be encoded as a picture");
    files::write_file(path, file);
}

} // namespace cairn::viewer
