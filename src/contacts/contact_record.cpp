#include "contacts/contact_record.h"

#include "contacts/contact_update.h"
#include "contacts/prefetch.h"
#include "contacts/round_touch.h"
#include "state/state.h"

#include <algorithm>
#include <cstring>

namespace cairn {

using math::put;
using math::to_vec;

namespace {

constexpr float unused = 1e30f;

// Four floats side by side: a contact point and its separation.
using Float4 = float __attribute__((vector_size(16)));
Float4 load4(const float* p) {
    Float4 v;
    std::memcpy(&v, p, sizeof(v));
    return v;
}
void store4(float* p, Float4 v) { std::memcpy(p, &v, sizeof(v)); }

float sum3(Float4 v) { return v[0] + v[1] + v[2]; }

// The data of a contact's last step that warm starting needs. The arms of unused points are far away.
struct OldPoints {
    int count;
    math::Vec3 normal, friction;
    Float4 x, y, z; // of the arms
    float impulse[4], torsion;
};

// Gives new contact points the impulses of the old points at the same places in A's frame. The impulses of old points
// without a successor are shared among the new points without a predecessor: otherwise the load of a contact that
// changes from four points to one drops for a substep, and a heap never comes to rest.
void match_points(const OldPoints& old, float tolerance, int count, ContactRecord& r) {
    const float limit = tolerance * tolerance;
    unsigned taken = 0, unmatched = 0;
    for (int i = 0; i < count; ++i) {
        const float* p = point_of(r, i);
        const Float4 dx = p[0] - old.x, dy = p[1] - old.y, dz = p[2] - old.z;
        float square[4];
        store4(square, dx * dx + dy * dy + dz * dz);
        int match = -1;
        // Usually the order of the points stays as well.
        if (i < old.count && !(taken & (1u << i)) && square[i] < 0.0625f * limit) {
            match = i;
        } else {
            float nearest = limit;
            for (int k = 0; k < old.count; ++k) {
                const bool is_nearer = (square[k] < nearest) & !(taken >> k & 1);
                nearest = is_nearer ? square[k] : nearest;
                match = is_nearer ? k : match;
            }
        }
        if (match < 0) {
            unmatched |= 1u << i;
            continue;
        }
        taken |= 1u << match;
        r.impulses[i] = old.impulse[match];
    }
    if (unmatched != 0 && math::dot(old.normal, to_vec(r.normal)) > 0.7f) {
        float left = 0;
        for (int k = 0; k < old.count; ++k)
            if (!(taken & (1u << k))) left += old.impulse[k];
        left /= float(__builtin_popcount(unmatched));
        for (int i = 0; i < count; ++i)
            if (unmatched & (1u << i)) r.impulses[i] = left;
        taken |= 1;
    }
    if (taken == 0) return;
    put(r.friction_impulse, old.friction);
    r.torsion_impulse = old.torsion;
}

OldPoints old_points(const ContactRecord& r, int count) {
    OldPoints old;
    old.count = count;
    old.normal = to_vec(r.normal);
    old.friction = to_vec(r.friction_impulse);
    old.torsion = r.torsion_impulse;
    const Float4 far_away{unused, unused, unused, unused};
    Float4 p[4];
    for (int k = 0; k < 4; ++k) p[k] = k < count ? load4(point_of(r, k)) : far_away, old.impulse[k] = r.impulses[k];
    // Transpose: from four points to four values each of x, y and z.
    const Float4 xy01 = __builtin_shufflevector(p[0], p[1], 0, 4, 1, 5),
                 z01 = __builtin_shufflevector(p[0], p[1], 2, 6, 3, 7);
    const Float4 xy23 = __builtin_shufflevector(p[2], p[3], 0, 4, 1, 5),
                 z23 = __builtin_shufflevector(p[2], p[3], 2, 6, 3, 7);
    old.x = __builtin_shufflevector(xy01, xy23, 0, 1, 4, 5);
    old.y = __builtin_shufflevector(xy01, xy23, 2, 3, 6, 7);
    old.z = __builtin_shufflevector(z01, z23, 0, 1, 4, 5);
    return old;
}

// Whether each point is at the old place of the point with its number: then all impulses stay as they are. This is a
// shortcut for the common case.
bool points_stay(const ContactRecord& r, const Float4* points, int count, float tolerance) {
    const float limit = 0.0625f * tolerance * tolerance;
    float greatest = 0;
    for (int i = 0; i < count; ++i) {
        const Float4 difference = points[i] - load4(point_of(r, i));
        greatest = std::max(greatest, sum3(difference * difference));
    }
    return greatest < limit;
}

std::uint32_t packed_features(const Manifold& m) {
    std::uint32_t packed = no_features;
    for (int i = m.count - 1; i >= 0; --i) packed = packed << 8 | (m.features[i] & 255u);
    return packed;
}

// The slope of a tapered cylinder: the decrease of its radius per length along its axis.
float narrowing_of(const Geometry& g) { return (g.size.x - g.size.z) / (2 * g.size.y); }

// The sine of the angle between the normal and the axis. A surface that touches at a circle of radius R about the axis
// rolls with the radius R / sine (Meusnier): a cone on its side, or a wheel on its rim. A shape that stands on its end
// does not roll: the lower bound keeps the radius finite there.
float sine_with_axis(const ShapePose& pose, math::Vec3 normal) {
    return std::max(math::length(math::cross(axis_of(pose, 1), normal)), 0.1f);
}

// Writes the axis and the radius of the rim by which a shape touches a face in a single point: the rim of an end, or a
// corner, which is a rim of radius 0. Rounded shapes touch by a sphere about that point of the rim. Returns the radius
// of this sphere, up to the middle between the surfaces.
float find_rim(const Geometry& g, const ShapePose& pose, math::Vec3 outwards, float separation, float* rim) {
    const float cosine = math::dot(axis_of(pose, 1), outwards);
    const float sine = g.type == ShapeType::cylinder ? std::sqrt(std::max(1 - cosine * cosine, 0.0f)) : 1.0f;
    const bool is_top = 2 * g.size.y * cosine + (g.size.z - g.size.x) * sine > 0; // the end farther along the normal
    const float radius = is_top ? g.size.z : g.size.x;
    std::fill_n(rim, 4, 0.0f);
    if (g.type == ShapeType::cylinder) put(rim, axis_of(pose, 1)), rim[3] = radius;
    if (g.type == ShapeType::capsule) return radius + 0.5f * separation;
    if (g.type == ShapeType::cylinder) return g.rounding > 0 ? g.rounding + 0.5f * separation : 0.0f;
    return contact_radius(g, pose, outwards, separation);
}

// For a cone that touches along its side with two points: the direction from the first to the second, scaled by the
// growth of the radius of curvature per length along it.
math::Vec3 taper_of(const Geometry& g, const ShapePose& pose, const ContactRecord& r) {
    if (g.type != ShapeType::cylinder || g.size.x == g.size.z) return {};
    const math::Vec3 way = to_vec(point_of(r, 1)) - to_vec(point_of(r, 0));
    const float square = math::dot(way, way);
    if (!(square > 0)) return {};
    const float growth = -narrowing_of(g) * math::dot(way, axis_of(pose, 1)) / sine_with_axis(pose, to_vec(r.normal));
    return (growth / square) * way;
}

// Determines how the surfaces are round where they touch (a side that is treated as a plane counts as flat), and how
// contact points move over them: a single point, or those of a round shape on a face.
void find_roundness(const Shapes& shapes, const ContactInfo& c, const Manifold& m, math::Vec3 normal, const Moment& at,
                    ContactRecord& r) {
    const Geometry &a = shapes.geometry[c.shape_a], &b = shapes.geometry[c.shape_b];
    r.radius_a = contact_radius(a, *at.pose_a, normal, m.points[0][3]);
    r.radius_b = contact_radius(b, *at.pose_b, -normal, m.points[0][3]);
    if (m.features[0] & on_flat_side) r.radius_b = 0;
    const TouchingFace touching = touching_face(shapes, c, m, normal, *at.pose_a, *at.pose_b);
    const bool on_a = touching == TouchingFace::of_a;
    if (touching == TouchingFace::none) {
        if (m.count > 1) return;
        if (r.radius_a == 0 && r.radius_b == 0 && !(has_corners(a) && has_corners(b))) r.radius_a = rolls_somehow;
        const RoundPair round = round_pair(a, *at.pose_a, b, *at.pose_b, normal);
        put(r.more_points[0], round.axis);
        r.more_points[0][3] = round.about;
        return;
    }
    float &face = on_a ? r.radius_a : r.radius_b, &other = on_a ? r.radius_b : r.radius_a;
    const Geometry& g = on_a ? b : a;
    if (m.count > 1) {
        if (!(other > 0)) return; // two faces
        face = on_face;           // a line, or a face with rounded corners
        if (m.count == 2) put(r.more_points[2], taper_of(g, on_a ? *at.pose_b : *at.pose_a, r));
        return;
    }
    face = on_face;
    other = find_rim(g, on_a ? *at.pose_b : *at.pose_a, on_a ? -normal : normal, m.points[0][3], r.more_points[0]);
}

} // namespace

float contact_radius(const Geometry& g, const ShapePose& pose, math::Vec3 outwards, float separation) {
    if (g.type == ShapeType::sphere) return g.size.x + 0.5f * separation;
    const float around = g.rounding > 0 ? g.rounding + 0.5f * separation : 0.0f;
    if (g.type != ShapeType::capsule && g.type != ShapeType::cylinder) return around;
    const float mean = 0.5f * (g.size.x + g.size.z);
    if (g.type == ShapeType::capsule) return mean + 0.5f * separation;
    const float slope = narrowing_of(g), slant = std::sqrt(1 + slope * slope);
    const float along = math::dot(outwards, axis_of(pose, 1)) - slope / slant;
    // Cosine of the angle between the normal and the axis, less that of the side's normal: beyond it, a cylinder stands
    // on its rim rather than rolls.
    constexpr float steepest = 0.7f;
    return std::fabs(along) < steepest ? mean / sine_with_axis(pose, outwards) + g.rounding + 0.5f * separation
                                       : around;
}

void forget_impulses(ContactRecord& r, int count) {
    for (int i = 0; i < 4; ++i) r.impulses[i] = 0;
    r.first_total = 0;
    if (count > 1) put(r.more_totals, {});
    put(r.friction_impulse, {});
    put(r.total_friction, {});
    r.torsion_impulse = 0;
}

float min_separation(const ContactInfo& c, const ContactRecord& r) {
    float least = r.first_point[3];
    for (int i = 1; i < c.point_count; ++i) least = std::min(least, point_of(r, i)[3]);
    return least;
}

void write_record(const Shapes& shapes, ContactInfo& c, ContactRecord& r, const Manifold& m, const Moment& at) {
    const math::Vec3 normal = c.flipped ? -to_vec(m.normal) : to_vec(m.normal);
    const math::Vec3 offset = c.flipped ? at.arm - at.x_a_from_b : at.arm;
    Float4 points[4];
    const int kept = m.count == 1 ? 1 : 4;
    for (int i = 0; i < kept; ++i)
        points[i] = i < m.count ? load4(m.points[i]) + Float4{offset.x, offset.y, offset.z} : Float4{0, 0, 0, unused};
    const bool stay = m.count == c.point_count && points_stay(r, points, m.count, c.match_tolerance);
    OldPoints old;
    if (!stay) old = old_points(r, c.point_count);
    put(r.normal, normal);
    put(r.center_offset, at.x_a_from_b);
    for (int i = 0; i < kept; ++i) store4(point_of(r, i), points[i]);
    if (may_be_round(c.kind)) find_roundness(shapes, c, m, normal, at, r);
    c.is_round_touch = m.count == 1 && is_round_touch(r);
    c.point_count = std::uint8_t(m.count);
    r.touch_time = at.time;
    r.features = packed_features(m);
    if (stay) return;
    forget_impulses(r, m.count);
    if (old.count > 0) match_points(old, c.match_tolerance, m.count, r);
}

} // namespace cairn
