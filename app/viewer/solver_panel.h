/// \file solver_panel.h
/// The part of the panel that selects which solver data is drawn, and explains it.
#pragma once

#include "viewer/controller.h"

namespace cairn::viewer {

/// To be called inside the panel's window.
void draw_solver_section(const StageState& state, Controller& controller);

} // namespace cairn::viewer
