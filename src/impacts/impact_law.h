// The velocities of two bodies after an impact, and those of the bodies that they rest on.
//
// Restitution acts at all approaching points at once (Newton): each point separates at `restitution` times its approach
// speed, and no impulse pulls. With the impulses p and the normal velocities v before and u after the impact, the
// energy changes by sum p (u + v) / 2. Where p > 0, u = -e v and v < 0, so that no term is positive: energy never
// grows, and is conserved where e = 1. A point with a `rebound` separates at least at that speed, and may gain the
// energy for it.
//
// Friction stops the slip of each point within Coulomb's cone. Couples resist spinning about the normal, up to
// `torsion_radius` times the friction, and rolling, up to `rolling_radius` times the normal impulse. With friction and
// unequal arms Newton's law may gain energy (Kane 1984): friction is then halved until it does not, and finally set to
// 0.
#pragma once

#include "math/vec.h"
#include "state/impact_rows.h"

#include <span>

namespace cairn {

struct ImpactOutcome {
    double approach = 0;                // m/s: greatest approach speed before; 0: nothing approached or changed
    bool bounces = false;               // some point separates because of its restitution
    double impulse = 0;                 // N s: along the normals
    math::DVec3 position, normal;       // of the fastest point
    std::uint16_t surface_material = 0; // of the fastest point
};
// Changes the velocities of `bodies`. `points`: those of one pair after another. The outcome is that of the first pair;
// the other pairs are contacts with bodies that the first two rest on, which are pushed at the same time unless that
// would increase the energy.
ImpactOutcome collide(std::span<ImpactBody> bodies, std::span<const ImpactPair> pairs,
                      std::span<const ImpactPoint> points, ImpactBuffer& buffer);

// Clamps the spin of a body that reacts to `most`, rad/s. Returns whether it was higher; if so, no impact changes it
// any further.
bool cut_spin(ImpactBody& body, double most);

} // namespace cairn
