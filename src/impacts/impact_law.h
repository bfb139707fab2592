// What an impact makes of the velocities of two bodies, and of what these lie on.
//
// Restitution acts at the points that approach, all at once (Newton): each of them leaves at `restitution` times the
// speed at which it came, and no impulse pulls. With the impulses p and the normal velocities v before and u after, the
// energy changes by sum p (u + v) / 2. Where p > 0, u = -e v and v < 0, so that no term is positive: energy never
// grows, and is kept where e = 1. A point with a `rebound` leaves as fast as that at least, and may gain so much.
//
// Friction stops the slip of each point within Coulomb's cone; couples stop that the bodies spin about the normal and
// roll on each other, up to the friction times `torsion_radius`, and `rolling_radius`, times the impulse. With friction
// and unequal arms Newton's law may gain energy (Kane 1984): then friction is halved until it does not, at last to 0.
#pragma once

#include "math/vec.h"
#include "state/impact_rows.h"

#include <span>

namespace cairn {

struct ImpactOutcome {
    double approach = 0;                // m/s: the greatest, before; 0: nothing approached, and nothing was changed
    bool bounces = false;               // some point leaves faster than it has to
    double impulse = 0;                 // N s: along the normals
    math::DVec3 position, normal;       // of the fastest point
    std::uint16_t surface_material = 0; // likewise
};
// Changes the velocities of bodies. `points`: of one pair after another. The outcome is that of the first pair; the
// others are what its bodies lie on, which is pushed at the same time unless energy would grow by that.
ImpactOutcome collide(std::span<ImpactBody> bodies, std::span<const ImpactPair> pairs,
                      std::span<const ImpactPoint> points, ImpactBuffer& buffer);

} // namespace cairn
