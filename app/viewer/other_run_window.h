/// \file other_run_window.h
/// What there is to say of the run whose bodies are seen as ghosts.
#pragma once

#include "viewer/controller.h"

namespace cairn::viewer {

/// Draws it into the top left corner of the picture, which begins at `column`; nothing without another run.
void draw_other_run(const StageState& state, Controller& controller, float scale, float column, float bottom);

} // namespace cairn::viewer
