/// \file shadow_region.h
/// Which part of the world the shadow map covers.
#pragma once

#include "viewer/render_frame.h"

namespace cairn::viewer {

/// The place on which the shadow map lies. Only depends on the world and on coarse steps of the camera's distance,
/// so shadows do not swim.
struct ShadowRegion {
    Vec3 center{0.0f, 0.0f, 0.0f}; ///< Relative to the frame's origin, meters.
    float radius = 10.0f;          ///< Meters.
};
ShadowRegion shadow_region(const RenderFrame& frame);

} // namespace cairn::viewer
