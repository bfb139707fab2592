/// \file other_run_window.h
/// Information about the second run, whose bodies are drawn as ghosts.
#pragma once

#include "viewer/controller.h"

namespace cairn::viewer {

/// Draws it into the top left corner of the view, whose left edge is `column`; nothing without a second run.
void draw_other_run(const StageState& state, Controller& controller, float scale, float column, float bottom);

} // namespace cairn::viewer
