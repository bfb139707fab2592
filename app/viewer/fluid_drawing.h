/// \file fluid_drawing.h
/// The surfaces of fluids.
#pragma once

#include "viewer/render_frame.h"

namespace cairn::viewer {

/// Copies the fluids of a world.
std::vector<FluidLayout> read_fluids(const World& world);

/// Adds the surfaces of the fluids of `motion` to the frame. Infinite surfaces are drawn up to a kilometer away.
void draw_fluids(RenderFrame& frame, const WorldMotion& motion);

} // namespace cairn::viewer
