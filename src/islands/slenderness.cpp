#include "islands/slenderness.h"

#include "bodies/bodies.h"

#include <algorithm>
#include <cmath>

namespace cairn {

namespace {

using math::DSym3;
using math::DVec3;

constexpr double slow_fall = 2;  // s: a tilt may grow by a factor of e in this time
constexpr double safety = 1.3;   // factor: exactly at the limit, a tilted column does not return
constexpr double of_outline = 3; // second moment of a box's outline / that of its inside

DSym3 scaled(double s, const DSym3& m) { return {s * m.xx, s * m.xy, s * m.xz, s * m.yy, s * m.yz, s * m.zz}; }
DSym3 diagonal(double d) { return {d, 0, 0, d, 0, d}; }
double along(const DSym3& m, DVec3 u) { return math::dot(u, m * u); }

// The second moments of a body's mass about its center, m^2.
DSym3 own_moments(const BodyMass& mass, const BodyMotion& motion) {
    if (mass.isotropic) return diagonal(0.5 * double(mass.inertia.x) / double(mass.mass));
    const DSym3 i = world_inertia(motion, mass);
    return scaled(1 / double(mass.mass), diagonal(0.5 * (i.xx + i.yy + i.zz)) + scaled(-1, i));
}

// The lesser principal value of a symmetric matrix in the plane perpendicular to a direction.
double least_across(const DSym3& m, DVec3 direction) {
    const DVec3 some = std::fabs(direction.x) < 0.6 ? DVec3{1, 0, 0} : DVec3{0, 1, 0};
    const DVec3 e = math::normalized(math::cross(direction, some)), f = math::cross(direction, e);
    const double ee = along(m, e), ff = along(m, f), ef = math::dot(e, m * f);
    return 0.5 * (ee + ff) - std::sqrt(0.25 * (ee - ff) * (ee - ff) + ef * ef);
}

DVec3 up_of(const Extent& extent) { return (-1 / math::length(extent.pull)) * extent.pull; }

// The extent of an island along the pull of gravity. `upward`: the mean second moments of its bodies about their
// centers.
struct Height {
    DVec3 middle;
    DSym3 places; // second moments of the positions of its bodies
    double all;
};
Height height_of(const Extent& extent, const DSym3& upward, DVec3 up) {
    Height h{(1 / extent.count) * extent.sum, {}, 0};
    h.places = scaled(1 / extent.count, extent.squares) + scaled(-1, squared(h.middle));
    h.all = std::sqrt(12 * along(h.places + upward, up));
    return h;
}

// How far contacts may sink, m. `own`, `upward`: mean second moments of the bodies about their centers; `own` gives
// their width and the distance of contacts, `upward` the height. `held`: the support by contacts from the sides, m^2.
float sinking_of(const Extent& extent, const DSym3& own, const DSym3& upward, const DSym3& held) {
    const double pull = math::length(extent.pull);
    if (!(pull > 0)) return nothing_can_buckle;
    const DVec3 up = up_of(extent);
    const Height height = height_of(extent, upward, up);
    const double center = math::dot(up, (1 / extent.mass) * extent.moment - height.middle) + 0.5 * height.all;
    // The tilt of a rod that stands on one end grows by a factor of e in sqrt(2 H / 3 g).
    const double fall = height.all * extent.mass / (1.5 * pull), needed = 1 - fall / (slow_fall * slow_fall);
    if (!(height.all > 0 && center > 0 && needed > 0)) return nothing_can_buckle;
    constexpr double euler = 3.14159265358979 * 3.14159265358979 / 4, greenhill = 3.92;
    const double top_heavy = std::clamp(2 * center / height.all - 1, 0.0, 1.0);
    const double distance = std::sqrt(12 * along(own, up));
    const double of_column = (greenhill + top_heavy * (euler - greenhill)) * distance / height.all;
    const double least = least_across(scaled(of_column, height.places + scaled(of_outline, own)) + held, up);
    return least > 0 ? float(least / (center * needed * safety)) : nothing_can_buckle;
}

} // namespace

void add_to_extent(Extent& extent, const Extent& more) {
    extent.count += more.count;
    extent.mass += more.mass;
    extent.sum += more.sum;
    extent.moment += more.moment;
    extent.pull += more.pull;
    extent.squares = extent.squares + more.squares;
    extent.least += more.least;
    extent.greatest += more.greatest;
}

float min_buckling_penetration(const Extent& extent) {
    return sinking_of(extent, diagonal(std::max(extent.least / extent.count, 0.0)),
                      diagonal(extent.greatest / extent.count), {});
}

float pull_by_width(const Extent& extent) {
    const double width = std::sqrt(12 * std::max(extent.least, 0.0) / extent.count);
    return extent.count > 1 && width > 0 ? float(math::length(extent.pull) / (extent.mass * width)) : 0;
}

StandingColumn column_of(const Bodies& bodies, const Island& island, const BodyWeights& weights) {
    StandingColumn column;
    column.origin = bodies.motion[island.first_body].x;
    for (std::int32_t b = island.first_body; b != none; b = bodies.links[b].next_in_island) {
        if (!(bodies.mass[b].inverse_mass > 0)) continue;
        add_to_extent(column.extent, bodies.mass[b], bodies.motion[b], column.origin, weights.pull(b));
        column.own = column.own + own_moments(bodies.mass[b], bodies.motion[b]);
    }
    if (!(math::length(column.extent.pull) > 0)) return column; // also if there is no body
    column.own = scaled(1 / column.extent.count, column.own);
    column.up = up_of(column.extent);
    const Height height = height_of(column.extent, column.own, column.up);
    column.bottom = math::dot(column.up, height.middle) - 0.5 * height.all;
    return column;
}

void add_side_support(StandingColumn& column, DVec3 at, math::Vec3 normal) {
    const DVec3 n = math::to_double(normal);
    const double z = std::max(math::dot(column.up, at - column.origin) - column.bottom, 0.0);
    column.sides.squares = column.sides.squares + squared(z * n);
    column.sides.normals += (z * z) * n;
    column.sides.weight += z * z;
}

float stable_sinking(const StandingColumn& column) {
    DSym3 held = column.sides.squares;
    if (column.sides.weight > 0) held = held + scaled(-1 / column.sides.weight, squared(column.sides.normals));
    return sinking_of(column.extent, column.own, column.own, held);
}

} // namespace cairn
