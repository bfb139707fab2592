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

#include "viewer/file_output.h"
#include "viewer/headless.h"

#include <cairn/error.h>

#include <string>

namespace cairn::viewer {

void write_png(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgb) {
    if (width < 1 || height < 1 || rgb.size() != 3u * std::size_t(width) * std::size_t(height))
        throw Error(ErrorCode::invalid_value, "write_png", std::to_string(rgb.size()),
                    "must have 3 x width x height bytes");
    std::string file;
    const auto append = [](void* context, void* data, int size) {
        static_cast<std::string*>(context)->append(static_cast<const char*>(data), std::size_t(size));
    };
    if (!stbi_write_png_to_func(append, &file, width, height, 3, rgb.data(), 3 * width))
        throw Error(ErrorCode::io, path.string(), "", "cannot be encoded as PNG");
    write_file(path, file);
}

} // namespace cairn::viewer
