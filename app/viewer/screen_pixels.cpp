#include "viewer/screen_pixels.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>

namespace cairn::viewer {

std::vector<std::uint8_t> read_screen(int width, int height) {
    const std::size_t row = 3u * std::size_t(width);
    std::vector<std::uint8_t> bottom_up(row * std::size_t(height)), pixels(bottom_up.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, bottom_up.data());
    for (std::size_t y = 0; y < std::size_t(height); ++y)
        std::copy_n(bottom_up.begin() + std::ptrdiff_t(y * row), row, pixels.end() - std::ptrdiff_t((y + 1) * row));
    return pixels;
}

} // namespace cairn::viewer
