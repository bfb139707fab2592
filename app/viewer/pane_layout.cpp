#include "viewer/pane_layout.h"

#include <cmath>

namespace cairn::viewer {

PaneRect pane_rect(const PaneRect& area, std::size_t count, std::size_t index) {
    if (count <= 1) return area;
    const float gap = std::fmax(2.0f, std::round(0.003f * area.width));
    const float width = 0.5f * (area.width - gap);
    const float height = count == 2 ? area.height : 0.5f * (area.height - gap);
    return {area.left + float(index % 2) * (width + gap), area.top + float(index / 2) * (height + gap), width, height};
}

std::size_t pane_at(const PaneRect& area, std::size_t count, float x, float y) {
    for (std::size_t i = 0; i < count; ++i)
        if (pane_rect(area, count, i).contains(x, y)) return i;
    return 0;
}

} // namespace cairn::viewer
