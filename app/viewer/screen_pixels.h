/// \file screen_pixels.h
/// Reading back the pixels of the window.
#pragma once

#include <cstdint>
#include <vector>

namespace cairn::viewer {

/// The lower left part of the window as drawn at present: 8-bit RGB, top row first.
std::vector<std::uint8_t> read_screen(int width, int height);

} // namespace cairn::viewer
