/// \file screen_pixels.h
/// What the window shows, as pixels.
#pragma once

#include <cstdint>
#include <vector>

namespace cairn::viewer {

/// 8-bit RGB, top row first, of what is drawn now in the lower left corner of the window.
std::vector<std::uint8_t> read_screen(int width, int height);

} // namespace cairn::viewer
