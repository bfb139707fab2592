// How stiff what stands must be so as not to buckle.
//
// A column of height H with its center of mass at the height z is stable while its load compresses it by less than
// c r^2 / (H z), with r the radius of gyration of what presses across. With all of the load at the top, z = H, c is
// pi^2 / 4 (Euler 1744), and of its own weight, z = H / 2, 3.92 (Greenhill 1881); a wedge, as a pyramid of one row is,
// has 4.3. Of contacts that are h apart each may sink by that part of h. All lengths are read off the bodies, whatever
// they make up: H^2 / 12 is the mean square of distances from the middle along the pull of gravity, and r^2 that
// across, in the direction in which it is least, where each body counts with its outline, on which contacts press, and
// not with its inside. So walls and pyramids are as slender as they are thick, and heaps are not slender at all.
//
// What fills a shaft is held by its walls. Contacts of the stiffness k at the heights z, with normals n, on what does
// not move, hold it against tilting by k sum z^2 (n.e)^2 in the direction e, where they press from both sides; that it
// is to be more than its weight times z adds sum z^2 (n.e)^2 / z to how far contacts may sink. It does not matter which
// walls: where all press from one side the mean of the normals is taken out, and nothing is left.
#pragma once

#include "bodies/integrators.h"
#include "state/solver_scratch.h"
#include "state/state.h"

#include <algorithm>
#include <limits>

namespace cairn {

inline math::DSym3 squared(math::DVec3 v) { return {v.x * v.x, v.x * v.y, v.x * v.z, v.y * v.y, v.y * v.z, v.z * v.z}; }

// Adds a body; positions are taken from `origin`, so that little cancels. `pull`, m/s^2: of gravity and fields.
inline void add_to_extent(Extent& extent, const BodyMass& mass, const BodyMotion& motion, math::DVec3 origin,
                          math::DVec3 pull) {
    const math::DVec3 x = motion.x - origin;
    const double m = double(mass.mass);
    const math::Vec3 i = mass.inertia;
    const float half = 0.5f * (i.x + i.y + i.z);
    extent.count += 1;
    extent.mass += m;
    extent.sum += x;
    extent.moment += m * x;
    extent.pull += m * pull;
    extent.squares = extent.squares + squared(x);
    extent.least += double((half - std::max({i.x, i.y, i.z})) * mass.inverse_mass);
    extent.greatest += double((half - std::min({i.x, i.y, i.z})) * mass.inverse_mass);
}
void add_to_extent(Extent& extent, const Extent& more);

StandingColumn column_of(const Bodies& bodies, const Island& island, const BodyWeights& weights);
// By a contact that is pressed, at the place of its body.
inline bool may_hold_from_side(const ContactInfo& c) { return !c.b_moves && c.force > 0; }
void hold_from_side(StandingColumn& column, math::DVec3 at, math::Vec3 normal);

// 1/s^2: what pulls at several bodies, over their width, the root of its mean square. A single one bears nothing but
// itself: 0.
float pull_by_width(const Extent& extent);

// m: how far contacts may sink under what stands, so that it does not buckle, or takes `slow_fall` for a factor of e.
// Exactly; and what it is at least, however its bodies are turned and held.
float stable_sinking(const StandingColumn& column);
float least_stable_sinking(const Extent& extent);
inline constexpr float nothing_can_buckle = std::numeric_limits<float>::infinity();

} // namespace cairn
