// Working memory of bodies/fluids.cpp.
#pragma once

#include "shapes/solid_surface.h"
#include "state/body_state.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace cairn {

struct FluidScratch {
    struct AtWork {
        std::vector<SurfaceTriangle> surface;
        std::vector<std::pair<std::int32_t, BodyMass>> laden; // bodies with added mass, and their own masses
    };
    std::vector<std::int32_t> reached; // bodies that may be in a fluid
    std::vector<AtWork> at_work;       // per thread
};

} // namespace cairn
