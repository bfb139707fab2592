// Sharp boxes against capsules with ends of equal radius, 8 pairs at a time: the axis of the capsule, a segment, is
// tested in the frame of the box.
#include "kernels/collide/capsule.h"
#include "kernels/collide/collide.h"

namespace cairn::CAIRN_ISA {

namespace {

// A face gives two points and a steady normal: it is preferred where its separation is smaller than the best by no more
// than this fraction of the smaller half width, as in collision/convex_contact.cpp.
constexpr float face_preference = 2e-3f;
// The error of a length, as a fraction of the sum of all sizes.
constexpr float length_error = 5e-7f;
// A normal is perpendicular to an edge within this cosine, as in collision/contact_features.cpp.
constexpr float across_tolerance = 1e-2f;
// The deeper of two points comes first where it is deeper by this fraction of the smaller half width: the rolling
// radius of a round surface is that at the first point. Bodies that rock by less keep the order of their points.
constexpr float deeper = 1e-2f;
// A direction whose component along a box axis is less than this is parallel to the faces perpendicular to it.
constexpr float parallel = 1e-10f;
// Squared sine of the angle between axis and edge below which their cross product is rounding.
constexpr float no_crossing = 1e-10f;

struct AxisAtBoxx8 {
    f32x8 h[3];                // half extents of the box
    f32x8 c[3], u[3];          // middle and direction of the axis
    f32x8 inverse[3];          // reciprocals of u, always finite
    f32x8 half, radius;        // of the capsule
    f32x8 size, error, extent; // sum of both shapes' sizes; error of lengths; the smaller half width
    f32x8 at(int i, f32x8 s) const { return c[i] + s * u[i]; }
};

CAIRN_INLINE AxisAtBoxx8 axis_at_box(const ShapePosex8& box, const ShapePosex8& capsule) {
    const Capsulex8 shape = capsule_of(capsule);
    const Vec3x8 c = rotate_back(box.q, nonzero_center_offset(box, capsule)), u = rotate_back(box.q, shape.axis);
    AxisAtBoxx8 p = {{box.size.x, box.size.y, box.size.z},
                     {c.x, c.y, c.z},
                     {u.x, u.y, u.z},
                     {zero(), zero(), zero()},
                     shape.half,
                     shape.radius,
                     ((box.size.x + box.size.y) + (box.size.z + shape.half)) + shape.radius,
                     zero(),
                     min(min(shape.radius, box.size.x), min(box.size.y, box.size.z))};
    for (int i = 0; i < 3; ++i) p.inverse[i] = one() / select(abs(p.u[i]) > splat(parallel), p.u[i], splat(parallel));
    p.error = splat(length_error) * p.size;
    return p;
}

// Component i of the vector from the box to a point of the axis; zero where the point is between the faces.
CAIRN_INLINE f32x8 outward(const AxisAtBoxx8& p, int i, f32x8 s) {
    const f32x8 x = p.at(i, s);
    return x - clamp(x, -p.h[i], p.h[i]);
}

// The point of the axis that is closest to the box; of a part that is equally close, its middle. Half the derivative of
// the squared distance never decreases along the axis, and is linear between the points where the axis crosses the
// planes of the faces: its zero is between the last of these (and of the ends) where it is not positive and the first
// where it is not negative. That is exact, and needs no separate cases for faces, edges, corners or axes inside the
// box.
CAIRN_INLINE f32x8 nearest_place(const AxisAtBoxx8& p) {
    f32x8 low = -p.half, high = p.half, slope_low = zero(), slope_high = zero();
    const auto offer = [&](f32x8 s) {
        f32x8 slope = zero();
        for (int i = 0; i < 3; ++i) slope = slope + p.u[i] * outward(p, i, s);
        const mask8 is_low = (slope <= zero()) & (s >= low), is_high = (slope >= zero()) & (s <= high);
        low = select(is_low, s, low);
        slope_low = select(is_low, slope, slope_low);
        high = select(is_high, s, high);
        slope_high = select(is_high, slope, slope_high);
    };
    offer(-p.half);
    offer(p.half);
    for (int i = 0; i < 3; ++i) {
        offer(clamp((-p.h[i] - p.c[i]) * p.inverse[i], -p.half, p.half));
        offer(clamp((p.h[i] - p.c[i]) * p.inverse[i], -p.half, p.half));
    }
    const f32x8 rise = slope_high - slope_low;
    const mask8 rises = rise > zero();
    const f32x8 part = select(rises, -slope_low / select(rises, rise, one()), splat(0.5f));
    return low + part * (high - low);
}

// A direction out of the box, the distance of the axis along it, and the point of the axis that has that distance.
struct Directionx8 {
    f32x8 n[3], distance, place;
};

CAIRN_INLINE Directionx8 select(mask8 m, const Directionx8& a, const Directionx8& b) {
    return {{select(m, a.n[0], b.n[0]), select(m, a.n[1], b.n[1]), select(m, a.n[2], b.n[2])},
            select(m, a.distance, b.distance),
            select(m, a.place, b.place)};
}

CAIRN_INLINE Directionx8 nearest_direction(const AxisAtBoxx8& p) {
    Directionx8 d;
    d.place = nearest_place(p);
    for (int i = 0; i < 3; ++i) d.n[i] = outward(p, i, d.place);
    d.distance = sqrt((square(d.n[0]) + square(d.n[1])) + square(d.n[2]));
    const f32x8 inverse = one() / select(d.distance > zero(), d.distance, one());
    for (auto& n : d.n) n = inverse * n;
    return d;
}

// The face with the greatest separation from the axis.
CAIRN_INLINE Directionx8 face_direction(const AxisAtBoxx8& p) {
    Directionx8 d = {{zero(), zero(), zero()}, splat(-unused_separation), zero()};
    for (int i = 0; i < 3; ++i) {
        const f32x8 distance = abs(p.c[i]) - (p.h[i] + abs(p.u[i]) * p.half);
        const mask8 better = distance > d.distance, below = p.c[i] < zero();
        d.distance = select(better, distance, d.distance);
        for (int k = 0; k < 3; ++k) d.n[k] = select(better, k == i ? select(below, -one(), one()) : zero(), d.n[k]);
        // The deeper end.
        d.place = select(better, select((p.u[i] < zero()) ^ below, p.half, -p.half), d.place);
    }
    return d;
}

// Where the axis intersects the box: the direction perpendicular to the axis and an edge of the box, if it separates
// them by a shorter displacement than the face does.
CAIRN_INLINE Directionx8 min_way_out(const AxisAtBoxx8& p, const Directionx8& face, f32x8 preference) {
    Directionx8 d = face;
    f32x8 bar = face.distance + preference;
    for (int j = 0; j < 3; ++j) {
        const int i = (j + 1) % 3, k = (j + 2) % 3;
        const f32x8 squared = square(p.u[i]) + square(p.u[k]);
        const mask8 crosses = squared > splat(no_crossing);
        const f32x8 length = sqrt(select(crosses, squared, one())), inverse = one() / length;
        const f32x8 projected = p.c[i] * p.u[k] - p.c[k] * p.u[i];
        const f32x8 reach = p.h[i] * abs(p.u[k]) + p.h[k] * abs(p.u[i]);
        const f32x8 distance = (abs(projected) - reach) * inverse;
        // The direction of a cross product is the less certain the shorter it is.
        const f32x8 at_least = select(crosses, distance - p.error * inverse, face.distance);
        const mask8 better = at_least > bar;
        const f32x8 scale = select(projected < zero(), -inverse, inverse);
        const f32x8 ni = scale * p.u[k], nk = -scale * p.u[i];
        // The point of the axis that is closest to the edge, as projected along it.
        const f32x8 wi = select(ni < zero(), -p.h[i], p.h[i]) - p.c[i];
        const f32x8 wk = select(nk < zero(), -p.h[k], p.h[k]) - p.c[k];
        const f32x8 place = clamp((wi * p.u[i] + wk * p.u[k]) * square(inverse), -p.half, p.half);
        bar = max(bar, at_least);
        d.distance = select(better, distance, max(d.distance, at_least));
        d.place = select(better, place, d.place);
        d.n[i] = select(better, ni, d.n[i]);
        d.n[j] = select(better, zero(), d.n[j]);
        d.n[k] = select(better, nk, d.n[k]);
    }
    return d;
}

// One contact point, where the axis is closest; contact points are computed in the frame of the box.
CAIRN_INLINE ContactPointx8 single_point(const AxisAtBoxx8& p, const Directionx8& d, f32x8 separation, f32x8 limit) {
    const f32x8 depth = p.radius + splat(0.5f) * separation;
    const Vec3x8 middle = {p.at(0, d.place) - depth * d.n[0], p.at(1, d.place) - depth * d.n[1],
                           p.at(2, d.place) - depth * d.n[2]};
    return {middle, separation, splat_bits(0), separation <= limit};
}

// The ends of the part of the axis that is over the face or beside the edge in a direction. The deeper one comes first
// where it is clearly deeper, and is the only one where both coincide.
struct EndPointsx8 {
    ContactPointx8 first, second;
    f32x8 reached;  // the least separation
    mask8 is_there; // whether there is such a part within the margin
    mask8 is_along; // whether the axis is parallel to the edge over more than a point
};

CAIRN_INLINE EndPointsx8 select(mask8 m, const EndPointsx8& a, const EndPointsx8& b) {
    return {select(m, a.first, b.first), select(m, a.second, b.second), select(m, a.reached, b.reached),
            (m & a.is_there) | and_not(b.is_there, m), (m & a.is_along) | and_not(b.is_along, m)};
}

// `wider`: the face is widened by this fraction of its size.
CAIRN_INLINE EndPointsx8 end_points(const AxisAtBoxx8& p, const Directionx8& d, f32x8 separation, f32x8 limit,
                                    float wider) {
    f32x8 start = -p.half, end = p.half;
    f32x8 along = zero(), across = zero();    // squared components of the axis direction along the face or edge and
                                              // perpendicular to it
    f32x8 slope = zero(), height = -p.radius; // separation over the face or edge: slope along the axis, and at its
                                              // middle
    mask8 holds[3];
    for (int i = 0; i < 3; ++i) {
        // Beyond the end of an edge that is nearly parallel to the axis, the direction leans toward that end.
        const mask8 leans = (abs(d.n[i]) < splat(across_tolerance)) & (square(p.u[i]) > splat(1 - side_by_side));
        holds[i] = (d.n[i] == zero()) | leans;
        const f32x8 w = p.h[i] + splat(wider) * p.h[i];
        const f32x8 s = (-w - p.c[i]) * p.inverse[i], t = (w - p.c[i]) * p.inverse[i];
        start = select(holds[i], max(start, min(s, t)), start);
        end = select(holds[i], min(end, max(s, t)), end);
        along = along + select(holds[i], square(p.u[i]), zero());
        across = across + select(holds[i], zero(), square(p.u[i]));
        slope = slope + select(holds[i], zero(), d.n[i] * p.u[i]);
        height = height + select(holds[i], zero(), d.n[i] * p.c[i] - abs(d.n[i]) * p.h[i]);
    }
    // A point exactly on the face or edge, which the axis may cross at a small angle: internal edges between boxes
    // require that.
    const auto point = [&](f32x8 s, std::uint32_t feature) {
        ContactPointx8 r = {zero3(), max(height + s * slope, separation), splat_bits(feature), zero() > zero()};
        f32x8 x[3];
        for (int i = 0; i < 3; ++i)
            x[i] = select(holds[i], p.at(i, s), select(d.n[i] < zero(), -p.h[i], p.h[i])) +
                   (splat(0.5f) * r.separation) * d.n[i];
        r.position = {x[0], x[1], x[2]};
        r.present = r.separation <= limit;
        return r;
    };
    const ContactPointx8 first = point(start, 1), second = point(end, 2);
    const mask8 is_one_point = square(end - start) * along < square(splat(same_point) * p.extent);
    const f32x8 slack = select(is_one_point, zero(), splat(deeper) * p.extent);
    const mask8 swaps = second.separation < first.separation - slack;
    EndPointsx8 r = {select(swaps, second, first), select(swaps, first, second), zero(), zero() > zero(),
                     zero() > zero()};
    r.reached = min(first.separation, second.separation);
    r.is_there = (start <= end) & (r.reached <= limit);
    r.is_along = and_not(r.is_there & (across < splat(side_by_side)), is_one_point);
    r.second.present = and_not(r.second.present, is_one_point);
    return r;
}

// A capsule with two ends over a face, or beside an edge, has two contact points; else there is one, where the axis is
// closest.
CAIRN_INLINE void write_contacts(const AxisAtBoxx8& p, Quatx8 q, const Directionx8& face, Directionx8 d,
                                 f32x8 separation, f32x8 limit, f32x8 preference, Manifold* out) {
    EndPointsx8 ends = end_points(p, face, separation, limit, face_tolerance);
    const mask8 by_face =
        (face.distance >= d.distance - preference) & ends.is_there & (ends.reached <= separation + preference);
    mask8 has_ends = by_face;
    if (any(and_not(separation <= limit, by_face))) {
        const EndPointsx8 beside = end_points(p, d, separation, limit, 0);
        has_ends = by_face | beside.is_along;
        ends = select(by_face, ends, beside);
        d = select(by_face, face, d);
    } else {
        d = face;
    }
    ContactPointx8 first = select(has_ends, ends.first, single_point(p, d, separation, limit));
    ContactPointx8 second = ends.second;
    second.present = second.present & has_ends;
    first.position = rotate(q, first.position);
    second.position = rotate(q, second.position);
    write_two(out, rotate(q, {d.n[0], d.n[1], d.n[2]}), first, second, separation);
}

} // namespace

void box_capsule(CAIRN_COLLIDE_PARAMETERS) {
    for (int k = 0; k < count; k += 8) {
        const ShapePosex8 a = gather_shapes(poses, first + k), b = gather_shapes(poses, second + k);
        const AxisAtBoxx8 p = axis_at_box(a, b);
        const f32x8 limit = load_unaligned(margin + k), preference = splat(face_preference) * p.extent + p.error;
        const Directionx8 face = face_direction(p);
        Directionx8 d = nearest_direction(p);
        const mask8 meets = d.distance <= splat(crossing) * p.size;
        if (any(meets)) d = select(meets, min_way_out(p, face, preference), d);
        const f32x8 separation = max(d.distance, face.distance) - p.radius;
        if (any(separation <= limit))
            write_contacts(p, a.q, face, d, separation, limit, preference, out + k);
        else
            clear_manifolds(out + k, zero() > zero(), separation);
    }
}

} // namespace cairn::CAIRN_ISA
