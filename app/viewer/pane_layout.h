/// \file pane_layout.h
/// Arrangement of several views in a window.
#pragma once

#include <cstddef>

namespace cairn::viewer {

/// A rectangle in arbitrary units; `top` is measured downward.
struct PaneRect {
    float left = 0.0f, top = 0.0f, width = 0.0f, height = 0.0f;
    bool contains(float x, float y) const { return x >= left && x < left + width && y >= top && y < top + height; }
};

/// The rectangle of one of `count` panes, 1 to 4, in an area: two side by side, more in two rows.
PaneRect pane_rect(const PaneRect& area, std::size_t count, std::size_t index);
/// The pane at a point; the first pane if there is none.
std::size_t pane_at(const PaneRect& area, std::size_t count, float x, float y);

} // namespace cairn::viewer
