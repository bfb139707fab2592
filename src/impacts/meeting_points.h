// Where two shapes touch at given poses of their bodies.
#pragma once

#include "collision/surface_contact.h"
#include "impacts/impact_law.h"
#include "impacts/movers.h"

#include <vector>

namespace cairn {

struct MeetingScratch {
    SurfaceScratch surface;
    std::vector<Manifold> hits;
};

// All points in which the shapes touch, or are not more than a hundredth of the smaller half width (0.1 mm at most)
// apart: those are struck at once.
void find_meeting_points(const State& state, std::uint32_t shape_a, const MovingState& a, std::uint32_t shape_b,
                         const MovingState& b, MeetingScratch& scratch, std::vector<ImpactPoint>& points);

} // namespace cairn
