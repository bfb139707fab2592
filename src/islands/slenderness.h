// The stiffness of contacts that keeps a structure on them from buckling.
//
// A column of height H with its center of mass at height z is stable while its load compresses it by less than the
// fraction c r^2 / (H z), where r is the radius of gyration of its cross section. For a load at the top, z = H, c is
// pi^2 / 4 (Euler 1744); under its own weight, z = H / 2, c is 3.92 (Greenhill 1881); for a wedge, such as a pyramid of
// one row, it is 4.3. With contacts at distances h, each may sink by that fraction of h. All lengths are derived from
// the bodies, whatever structure they form: H^2 / 12 is the mean square of the distances from the middle along the pull
// of gravity, and r^2 the mean square perpendicular to it, in the direction in which that is least; each body counts by
// its outline, where contacts press, not by its inside. So walls and pyramids are as slender as they are thin, and
// heaps are not slender at all.
//
// Bodies that fill a shaft are supported by its walls. Contacts of stiffness k with immovable bodies, at heights z and
// with normals n, resist tilting in the direction e by k sum z^2 (n.e)^2, if they press from both sides. That this must
// exceed the weight times z adds sum z^2 (n.e)^2 / z to how far contacts may sink. It does not matter which walls
// press: subtracting the mean of the normals leaves nothing if all contacts press from one side.
#pragma once

#include "bodies/integrators.h"
#include "state/solver_scratch.h"
#include "state/state.h"

#include <algorithm>
#include <limits>

namespace cairn {

inline math::DSym3 squared(math::DVec3 v) { return {v.x * v.x, v.x * v.y, v.x * v.z, v.y * v.y, v.y * v.z, v.z * v.z}; }

// Adds a body; positions are relative to `origin`, which avoids cancellation. `pull`, m/s^2: of gravity and fields.
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
// Adds the support by a contact that carries a load, at the position of its body.
inline bool may_hold_from_side(const ContactInfo& c) { return !c.b_moves && c.force > 0; }
void add_side_support(StandingColumn& column, math::DVec3 at, math::Vec3 normal);

// The pull of gravity and fields on several bodies divided by their rms width, 1/s^2. A single body carries only
// itself: 0.
float pull_by_width(const Extent& extent);

// How far contacts may sink under a structure, m, so that it does not buckle, or a tilt takes `slow_fall` to grow by a
// factor of e. The exact value, and a lower bound for any rotations of the bodies and any support from the sides.
float stable_sinking(const StandingColumn& column);
float min_buckling_penetration(const Extent& extent);
inline constexpr float nothing_can_buckle = std::numeric_limits<float>::infinity();

} // namespace cairn
