// When the cores of two shapes first meet along the ways that their bodies take in a step.
//
// The core of a shape is what lies deeper than max(1 mm, 2 % of its smallest half width); of a surface, the surface
// itself. What is as deep as that already, as contacts are soft, goes deeper by a part of its depth at most without a
// look, and no deeper than half of the smallest half width.
#pragma once

#include "math/rotation.h"
#include "shapes/geometry.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace cairn {

// The way of a body from one pose to the next: its center of mass moves straight at one speed, and it turns about one
// axis by not more than half a turn. Times go from 0 to 1. The rotation is the normalized line between its ends, whose
// rate is largest in the middle: there it is 4 tan(angle / 4), hardly more than the angle.
inline constexpr float half_turn = 3.1f; // rad: of what turns farther, its two poses do not tell how
struct RigidPath {
    math::DVec3 start;       // of the center of mass, at time 0; of a path that begins later, where it would have been
    math::DVec3 translation; // in the time from 0 to 1
    math::DQuat rotation;    // at the beginning
    math::DQuat by;          // the whole turn
    math::DVec3 turn;        // its axis, times the largest rate
    double begin = 0, until = 1; // the path leads from there to there

    static RigidPath between(math::DVec3 x0, math::DQuat q0, math::DVec3 x1, math::DQuat q1, double begin = 0,
                             double until = 1);

    struct Pose {
        math::DVec3 x; // of the center of mass
        math::DQuat q;
    };
    Pose at(double time) const;
    Pose first() const { return {start + begin * translation, rotation}; }
    Pose end() const { return {start + until * translation, by * rotation}; }
    // How far what is so far from the center of mass is at any time from where it were on a straight line, m, at most:
    // an eighth of its acceleration. Across the way that is the square of the rate, along it at most a quarter of its
    // cube.
    double sagitta(double reach) const {
        const double rate = math::length(turn);
        return 0.125 * rate * rate * (1 + 0.25 * rate) * reach;
    }
};

// How far the core is inside a shape, m, by its smallest half width.
inline double core_depth_of(double half_width) { return std::max(1e-3, 0.02 * half_width); }

// What touches counts as deeper than it was when it is deeper by twice this, as part of a core's depth.
inline constexpr double sinking_part = 0.02;

struct SweptShape {
    const Geometry& geometry;
    const ShapeData& data;
    math::DVec3 offset; // of the shape's origin from the center of mass, in the body's frame
    const RigidPath& path;
    double until = 1; // the body stands still from then on
};

// The first time at which the cores meet, or somewhat before: the cores are apart at any time up to there. More than 1
// if they do not. If they overlap from the start, it is when a ball in the middle of `a` meets the other core;
// `is_known`: that which lies as deep as the solver may press it. `from`: up to then they are known to be apart. `a` is
// no surface. Conservative advancement (Mirtich 1996; Zhang and others, "Interactive continuous collision detection for
// non-convex polyhedra", 2006) with a bound on how fast any point of either can come nearer along the normal.
inline constexpr double never = 2;
// As far as that, as part of the smaller half width, shapes may move against each other without a look: no core passes.
inline constexpr double free_share = 0.5;
// `axis`, of all of these: a direction from `a` to `b` along which they may be apart, with which the search begins, or
// 0; then, where they were looked at, that in which they were nearest last.
double time_of_meeting(const SweptShape& a, const SweptShape& b, bool is_known, double from, math::DVec3& axis);

// What keeps two that touch from going deeper, beside their meetings. A contact in the solver that an impact has struck
// since has been as deep as cores.
enum class Held { by_nothing, perhaps, by_contact, by_struck_contact };

// All of these look no farther than to the end of the path that ends first.
//
// The first time from `from` on at which the shapes themselves touch and come nearer, by the speed of the nearest
// points; or, as that misses touches of what turns, and what overlaps from the start has none, at which the cores meet;
// or `never`. What touches at `from` and parts, or stays as it is, is asked for the next touch.
double time_of_impact(const SweptShape& a, const SweptShape& b, Held held, double from, math::DVec3& axis);

// When two that touch, or overlap, are deeper in each other than they may be: than faces that touch, by the distance of
// what is twice as deep as cores (of corners that is a little inside), or than where cores meet if the solver has the
// contact (`by_contact`), which is soft. What is deeper already is asked again when it is deeper by a quarter of that
// (if `by_nothing`: at all) and a twenty-fifth of what a core is inside; if `by_contact`, or if it is nearly as deep as
// inner cores are, when it is as deep as half of the smallest half width, as the solver pushes the two apart; if
// `by_struck_contact`, by a quarter, too. What goes deeper and comes back may be missed; then it is when the cores
// meet, if they do.
double time_of_sinking(const SweptShape& a, const SweptShape& b, Held held, double from, math::DVec3& axis);

// How near shapes are, m, that count as touching, by the smaller of their smallest half widths: a hundredth of it, 0.1
// mm at most.
inline double touch_tolerance(double half_width) { return std::min(1e-4, 0.01 * half_width); }
// How near they are where an impact is, m: of what they come nearer by less than that in the rest of a step, none is.
inline double impact_tolerance(double half_width) { return 0.01 * touch_tolerance(half_width); }

// When the shapes themselves touch, or are nearest to each other, and how far apart they are then: 0 where they touch
// or overlap from the start, m; infinite if that is more than `within`, m.
struct Nearness {
    double time, distance;
    math::DVec3 normal; // the direction to the other; where they touch, nearly
    math::DVec3 on_a;   // if they do not touch: the nearest point of `a`
};
Nearness nearness_of(const SweptShape& a, const SweptShape& b, double within, math::DVec3 axis);
// The same with some triangles of `b`, a mesh or height field. Where they touch, `normal` is 0.
Nearness nearness_of(const SweptShape& a, const SweptShape& b, std::span<const std::uint32_t> triangles, double within);

} // namespace cairn
