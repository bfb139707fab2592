/// \file report.h
/// The viewer's state as JSON, for tests and tools.
#pragma once

#include "viewer/controller.h"
#include "viewer/pane_layout.h"

#include <string>
#include <vector>

namespace cairn::viewer {

/// What only the window knows.
struct WindowFacts {
    int left = 0;                 ///< Pixels of the window beside the picture, where the panel is.
    int width = 0, height = 0;    ///< Of the picture (of several, the first), pixels.
    std::vector<PaneRect> panes;  ///< In the window's units; one, if there is one picture.
    int scene_lines = 0;          ///< Lines that the panel's list of scenes has room for.
    bool scene_is_listed = false; ///< The line of the present scene is in view.
    std::uint64_t frames = 0;
    double frames_per_second = 0.0;
    float bar_left = 0.0f, bar_right = 0.0f, bar_middle = 0.0f; ///< The track of the timeline in the window, pixels.
    std::string notice;                                         ///< The line that is shown at the bottom.
};

/// One JSON object: `scene`, `body_count`, `bodies` (index, name, type, position, speed, awake, and `screen`, the
/// pixel where the middle appears, from the top left), `selected`, `dragging`, `joints`
/// (index, name, kind, positions, force, torque, errors, `screen`), `selected_joint`, `paused`, `speed`, `camera`,
/// `frames` ...
std::string report_json(const StageState& state, const Controller& controller, const WindowFacts& facts);

} // namespace cairn::viewer
