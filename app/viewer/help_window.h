/// \file help_window.h
/// The key map on the screen.
#pragma once

#include "viewer/controller.h"

namespace cairn::viewer {

/// All of it is in the window, whatever its size.
void draw_help(Controller& controller, float scale);

} // namespace cairn::viewer
