/// \file shadow_region.h
/// The part of the world that the shadow map covers.
#pragma once

#include "viewer/render_frame.h"

namespace cairn::viewer {

/// The sphere that the shadow map covers. It depends only on the world and on coarse steps of the camera's distance, so
/// that shadow edges do not crawl.
struct ShadowRegion {
    Vec3 center{0.0f, 0.0f, 0.0f}; ///< Relative to the frame's origin, meters.
    float radius = 10.0f;          ///< Meters.
};
ShadowRegion shadow_region(const RenderFrame& frame);

} // namespace cairn::viewer
