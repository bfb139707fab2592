/// \file help_window.h
/// The help window with the key map.
#pragma once

#include "viewer/controller.h"

namespace cairn::viewer {

/// Draws the help window, scaled so that all of it fits the window.
void draw_help(Controller& controller, float scale);

} // namespace cairn::viewer
