// Capsules with ends of equal radius against each other and against spheres, 8 pairs at a time. A capsule is the set of
// points within a radius of a segment, its axis.
#include "kernels/collide/capsule.h"
#include "kernels/collide/collide.h"

namespace cairn::CAIRN_ISA {

namespace {

// Squared sine of the angle between axes below which it is rounding.
constexpr float parallel = 1e-12f;

// A direction perpendicular to a unit vector.
CAIRN_INLINE Vec3x8 any_across(Vec3x8 v) {
    const mask8 by_x = abs(v.x) < splat(0.5f);
    const Vec3x8 across = {select(by_x, zero(), v.z), select(by_x, -v.z, zero()), select(by_x, v.y, -v.x)};
    return (one() / sqrt(dot(across, across))) * across;
}

// Two axes. Points on them are given by their distance from the middle, s on the first and t on the second.
struct AxisPairx8 {
    Capsulex8 a, b;
    Vec3x8 offset, normal; // offset between the middles; cross product of the axes
    f32x8 along_a, along_b, cosine, square_sine;
    f32x8 start, end; // the part of the first axis that the projection of the second covers
    Vec3x8 between(f32x8 s, f32x8 t) const { return offset + t * b.axis - s * a.axis; }
};

CAIRN_INLINE AxisPairx8 pair_axes(const Capsulex8& a, const Capsulex8& b, Vec3x8 offset) {
    AxisPairx8 p = {
        a,      b,      offset, cross(a.axis, b.axis), dot(offset, a.axis), dot(offset, b.axis), dot(a.axis, b.axis),
        zero(), zero(), zero()};
    p.square_sine = dot(p.normal, p.normal);
    const f32x8 reach = abs(p.cosine) * b.half;
    p.start = max(-a.half, p.along_a - reach);
    p.end = min(a.half, p.along_a + reach);
    return p;
}

// The closest points of two segments (Ericson, "Real-Time Collision Detection", 2005, section 5.1.9). On their lines,
// the cross product is used: 1 - cosine^2 would lose half the digits of a small angle. The position along nearly
// parallel lines is uncertain, but the distance hardly depends on it; on parallel ones it is the middle of the part
// where they are side by side.
CAIRN_INLINE void nearest_places(const AxisPairx8& p, f32x8& s, f32x8& t) {
    const mask8 meets = p.square_sine > splat(parallel);
    const f32x8 on_line = dot(cross(p.offset, p.b.axis), p.normal) / select(meets, p.square_sine, one());
    s = clamp(select(meets, on_line, splat(0.5f) * (p.start + p.end)), -p.a.half, p.a.half);
    t = clamp(s * p.cosine - p.along_b, -p.b.half, p.b.half);
    s = clamp(t * p.cosine + p.along_a, -p.a.half, p.a.half);
}

// The direction from the first segment to the second. Where they cross, it is perpendicular to both, which is the
// shortest way to separate them.
CAIRN_INLINE Vec3x8 direction_between(const AxisPairx8& p, Vec3x8 between, f32x8& distance) {
    const f32x8 least = square(splat(crossing) * (p.a.length() + p.b.length()));
    Vec3x8 across = up();
    if (!all(dot(between, between) > least)) {
        const mask8 meets = p.square_sine > splat(parallel);
        const f32x8 sine = sqrt(select(meets, p.square_sine, one()));
        const f32x8 side = select(dot(p.normal, p.offset) < zero(), -one(), one());
        across = select(meets, (side / sine) * p.normal, any_across(p.a.axis));
    }
    return direction(between, least, across, distance);
}

// The contact point below a point of the second axis; exactly below it, as internal edges between surfaces require.
CAIRN_INLINE ContactPointx8 point_under(const AxisPairx8& p, f32x8 t, Vec3x8 normal, f32x8 separation, mask8 present,
                                        std::uint32_t feature) {
    const f32x8 depth = p.b.radius + splat(0.5f) * separation;
    return {p.offset + t * p.b.axis - depth * normal, separation, splat_bits(feature), present};
}

// A contact point of two capsules that lie side by side, at one end of the part where they do.
CAIRN_INLINE ContactPointx8 end_point(const AxisPairx8& p, f32x8 s, Vec3x8 normal, f32x8 limit, std::uint32_t feature) {
    const f32x8 t = (s - p.along_a) / select(p.square_sine < splat(side_by_side), p.cosine, one());
    const f32x8 separation = dot(p.between(s, t), normal) - (p.a.radius + p.b.radius);
    return point_under(p, t, normal, separation, separation <= limit, feature);
}

} // namespace

void sphere_capsule(CAIRN_COLLIDE_PARAMETERS) {
    for (int k = 0; k < count; k += 8) {
        const ShapePosex8 a = gather_shapes(poses, first + k), b = gather_shapes(poses, second + k);
        const Capsulex8 c = capsule_of(b);
        const Vec3x8 offset = nonzero_center_offset(a, b);
        const Vec3x8 between = offset + clamp(-dot(offset, c.axis), -c.half, c.half) * c.axis;
        const f32x8 least = square(splat(crossing) * (a.radius + c.length()));
        f32x8 distance;
        const Vec3x8 normal = direction(between, least, any_across(c.axis), distance);
        const f32x8 separation = distance - (a.radius + c.radius);
        write_sphere_manifolds(out + k, separation <= load_unaligned(margin + k), normal, a.radius, separation,
                               separation);
    }
}

void capsule_capsule(CAIRN_COLLIDE_PARAMETERS) {
    for (int k = 0; k < count; k += 8) {
        const ShapePosex8 a = gather_shapes(poses, first + k), b = gather_shapes(poses, second + k);
        const AxisPairx8 p = pair_axes(capsule_of(a), capsule_of(b), nonzero_center_offset(a, b));
        const f32x8 limit = load_unaligned(margin + k);
        f32x8 s, t, distance;
        nearest_places(p, s, t);
        const Vec3x8 normal = direction_between(p, p.between(s, t), distance);
        const f32x8 separation = distance - (p.a.radius + p.b.radius);
        const mask8 touching = separation <= limit;

        ContactPointx8 start = end_point(p, p.start, normal, limit, 1), end = end_point(p, p.end, normal, limit, 2);
        const f32x8 shortest = splat(same_point) * min(p.a.radius, p.b.radius);
        const mask8 lie_along = (p.square_sine < splat(side_by_side)) & (p.end - p.start > shortest) &
                                (start.present | end.present) & touching;
        const ContactPointx8 single = point_under(p, t, normal, separation, touching, 0);
        end.present = end.present & lie_along;
        write_two(out + k, normal, select(lie_along, start, single), end, separation);
    }
}

} // namespace cairn::CAIRN_ISA
