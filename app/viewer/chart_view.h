/// \file chart_view.h
/// Charts in the window, made with Dear ImGui.
#pragma once

#include "viewer/chart.h"

#include <cstdint>
#include <optional>

namespace cairn::viewer {

/// A color as ImGui takes it, from 0xRRGGBB.
unsigned int chart_ink(std::uint32_t rgb, int alpha = 255);
/// The same for words, which need more contrast than lines: nearer to the color of other words.
unsigned int word_ink(std::uint32_t rgb);

/// Draws a chart of that size (ImGui's units) at the cursor, with a legend above it. Hovered, it tells the values
/// there. `cursor`: an x that is marked, such as the present time. Returns the x that was clicked, if one was.
std::optional<double> draw_chart(const char* id, const Chart& chart, float width, float height,
                                 std::optional<double> cursor = std::nullopt);

} // namespace cairn::viewer
