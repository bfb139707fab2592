// Continuous collision detection: when the cores of two shapes first meet on the paths of their bodies in a step.
//
// The core of a shape is the part deeper than max(1 mm, 2 % of its smallest half width); of a surface, the surface
// itself. Shapes that overlap more than that from the start (contacts are soft) may sink farther without being stopped
// only by a part of their depth, and no deeper than half of the smallest half width.
#pragma once

#include "math/rotation.h"
#include "shapes/geometry.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace cairn {

// The greatest rotation of a path, rad: two poses do not determine a larger one.
inline constexpr float half_turn = 3.1f;
// The path of a body from one pose to the next: its center of mass moves straight at constant speed, and it rotates
// about a constant axis by at most half a turn. Times are from 0 to 1. The rotation is the normalized linear
// interpolation of the quaternions (nlerp), whose rate is largest in the middle: there it is 4 tan(angle / 4), hardly
// more than the angle.
struct RigidPath {
    math::DVec3 start;           // of the center of mass, at time 0; extrapolated if the path begins later
    math::DVec3 translation;     // of the center of mass from time 0 to 1
    math::DQuat rotation;        // at the beginning
    math::DQuat by;              // the whole rotation
    math::DVec3 turn;            // its axis, times the largest rate
    double begin = 0, until = 1; // the times at which the path begins and ends

    static RigidPath between(math::DVec3 x0, math::DQuat q0, math::DVec3 x1, math::DQuat q1, double begin = 0,
                             double until = 1);

    struct Pose {
        math::DVec3 x; // of the center of mass
        math::DQuat q;
    };
    Pose at(double time) const;
    Pose first() const { return {start + begin * translation, rotation}; }
    Pose end() const { return {start + until * translation, by * rotation}; }
    // The greatest distance, m, of a point that is `reach` from the center of mass from uniform straight motion between
    // its end positions: an eighth of its acceleration. Perpendicular to the path, this is the square of the rate times
    // `reach`, along the path at most a quarter of the cube.
    double sagitta(double reach) const {
        const double rate = math::length(turn);
        return 0.125 * rate * rate * (1 + 0.25 * rate) * reach;
    }
};

// The depth of a core below the surface of a shape, m, given its smallest half width.
inline double core_depth_of(double half_width) { return std::max(1e-3, 0.02 * half_width); }

// Share of a core's depth: touching shapes count as deeper than before when they are deeper by twice this.
inline constexpr double sinking_part = 0.02;

struct SweptShape {
    const Geometry& geometry;
    const ShapeData& data;
    math::DVec3 offset; // of the shape's origin from the center of mass, in the body's frame
    const RigidPath& path;
    double until = 1; // the body stands still from this time on
};

// The first time at which the cores meet, or slightly earlier: they are separated at any time before. More than 1 if
// they do not meet. If they overlap from the start, it is the time when a ball in the middle of `a` meets the other
// core. `is_known`: the solver has the contact, so that the cores are as deep as it may press the shapes. `from`: a
// time up to which they are known to be separated. `a` is not a surface. Conservative advancement (Mirtich 1996; Zhang
// and others, "Interactive continuous collision detection for non-convex polyhedra", 2006) with a bound on the approach
// speed of any two points along the normal.
inline constexpr double never = 2;
// What is known about the separation of two shapes.
struct Separation {
    // A direction from `a` to `b` along which they may be separated, as the start of a search, or 0. A search that
    // tests them replaces it by the direction in which they were last nearest.
    math::DVec3 axis{};
    // If not 0: how much nearer along the axis, a unit vector then, the shapes may end, m, if this adds a linear motion
    // to their paths, and a search would still not find them. Every search sets it.
    double slack = 0;
};
// Share of the smaller half width: by less than this, shapes may move relative to each other without a sweep, as no
// core can pass through.
inline constexpr double free_share = 0.5;
double core_time_of_impact(const SweptShape& a, const SweptShape& b, bool is_known, double from, Separation& known);

// The means that keep two touching shapes from sinking deeper, beside continuous collision. by_struck_contact: a
// contact in the solver that has been as deep as cores, and has had an impact since.
enum class Held { by_nothing, perhaps, by_contact, by_struck_contact };

// None of these functions searches beyond the end of the path that ends first.
//
// The first time from `from` on at which the shapes touch while approaching, found by the speed of the nearest points.
// This misses some touches of rotating shapes, and shapes that overlap from the start have none: for these it is the
// time at which the cores meet, or `never`. For shapes that touch at `from` and separate, or stay in contact, it is the
// next touch.
double time_of_impact(const SweptShape& a, const SweptShape& b, Held held, double from, Separation& known);

// The time at which two shapes that touch or overlap have sunk deeper into each other than they may. The limit is the
// distance that their inner cores (twice as deep as cores) have when faces touch (for vertices this is slightly
// inside), or, if the solver has the contact (`by_contact`), which is soft, the depth at which the cores meet. Shapes
// that are deeper already are stopped when they have sunk by another 1/25 of the core depth plus a quarter of the
// excess (`by_nothing`: plus nothing). With `by_contact`, or if they are nearly as deep as inner cores, they are
// stopped only at half of the smallest half width, as the solver pushes them apart; with `by_struck_contact`, the
// quarter applies. Shapes that sink deeper and return may be missed; then it is the time when the cores meet, if they
// do.
double time_of_sinking(const SweptShape& a, const SweptShape& b, Held held, double from, Separation& known);

// The separation up to which shapes count as touching, m, given the smaller of their smallest half widths: a hundredth
// of it, 0.1 mm at most.
inline double touch_tolerance(double half_width) { return std::min(1e-4, 0.01 * half_width); }
// The separation at which an impact is, m: an approach by less than this in the rest of a step is no impact.
inline double impact_tolerance(double half_width) { return 0.01 * touch_tolerance(half_width); }

// The time when the shapes touch or are nearest to each other, and their distance then: 0 if they touch or overlap from
// the start, m; infinite if it is more than `within`, m.
struct Nearness {
    double time, distance;
    math::DVec3 normal; // the direction to the other shape; approximate if they touch
    math::DVec3 on_a;   // the nearest point of `a`, if they do not touch
};
Nearness nearness_of(const SweptShape& a, const SweptShape& b, double within, math::DVec3 axis);
// The same for some triangles of `b`, a mesh or height field. If they touch, `normal` is 0.
Nearness nearness_of(const SweptShape& a, const SweptShape& b, std::span<const std::uint32_t> triangles, double within);

} // namespace cairn
