// What an impact makes of the velocities of two bodies.
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

#include <vector>

namespace cairn {

// A body at the moment of an impact; with an inverse mass and inertia of 0 it does not react.
struct ImpactBody {
    math::DVec3 x; // center of mass
    math::DVec3 v, w;
    double inverse_mass = 0;
    math::DSym3 inverse_inertia; // world axes
};

struct ImpactMaterial {
    double restitution, friction;
    double torsion_radius, rolling_radius; // m
    double restitution_speed;              // m/s: slower approaches do not bounce
};

struct ImpactOutcome {
    double approach = 0;          // m/s: the greatest, before; 0: nothing approached, and nothing was changed
    bool bounces = false;         // some point leaves faster than it has to
    double impulse = 0;           // N s: along the normals
    math::DVec3 position, normal; // of the fastest point
};
// Changes the velocities of both. The buffer is working memory.
ImpactOutcome collide(ImpactBody& a, ImpactBody& b, const std::vector<ImpactPoint>& points,
                      const ImpactMaterial& material, std::vector<ImpactRow>& buffer);

} // namespace cairn
