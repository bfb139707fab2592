/// \file report.h
/// The viewer's state as JSON, for tests and tools.
#pragma once

#include "viewer/controller.h"

#include <string>

namespace cairn::viewer {

/// What only the window knows.
struct WindowFacts {
    int width = 0, height = 0; ///< Of the picture, pixels.
    std::uint64_t frames = 0;
    double frames_per_second = 0.0;
    std::string notice; ///< The line that is shown at the bottom.
};

/// One JSON object: `scene`, `body_count`, `bodies` (index, name, type, position, speed, awake, and `screen`, the
/// pixel where the middle appears, from the top left), `selected`, `dragging`, `joints`
/// (index, name, kind, positions, force, torque, errors, `screen`), `selected_joint`, `paused`, `speed`, `camera`,
/// `frames` ...
std::string report_json(const StageState& state, const Controller& controller, const WindowFacts& facts);

} // namespace cairn::viewer
