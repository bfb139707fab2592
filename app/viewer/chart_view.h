/// \file chart_view.h
/// Charts in the window, made with Dear ImGui.
#pragma once

#include "viewer/chart.h"

#include <cstdint>
#include <optional>

namespace cairn::viewer {

/// Converts 0xRRGGBB to ImGui's color format.
unsigned int chart_ink(std::uint32_t rgb, int alpha = 255);
/// The same for text, which needs more contrast than lines: closer to the text color.
unsigned int word_ink(std::uint32_t rgb);

/// Draws a chart of that size (ImGui's units) at the cursor, with a legend above it, and shows the values under the
/// mouse. `cursor`: a marked x, such as the present time. Returns the clicked x, if any.
std::optional<double> draw_chart(const char* id, const Chart& chart, float width, float height,
                                 std::optional<double> cursor = std::nullopt);

} // namespace cairn::viewer
