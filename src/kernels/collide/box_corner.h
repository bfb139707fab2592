// Boxes that touch corner to corner, with nearly parallel edges: the contact normal, and the points.
#pragma once

#include "kernels/collide/box_pair.h"

namespace cairn::CAIRN_ISA {

// Upper limit, for nearly parallel edges, of the sine of the angle between them, and of the cosine of their angles to
// the normal.
constexpr float side_by_side_edges = 0.01f;

// The support edge of a box in a direction; of its three edge directions, the one most perpendicular to it.
struct SupportEdgex8 {
    Vec3x8 middle, direction; // middle: from the center of the box; direction: unit
    f32x8 half, axis;         // half its length; the number of its axis
    mask8 is_across;
};
CAIRN_INLINE SupportEdgex8 support_edge(const Vec3x8 (&axes)[3], const f32x8 (&h)[3], Vec3x8 n) {
    f32x8 along[3];
    for (int i = 0; i < 3; ++i) along[i] = dot(n, axes[i]);
    const f32x8 a0 = abs(along[0]), a1 = abs(along[1]), a2 = abs(along[2]);
    SupportEdgex8 e;
    e.axis = select((a0 <= a1) & (a0 <= a2), zero(), select(a1 <= a2, one(), splat(2.0f)));
    e.direction = choose(e.axis, axes[0], axes[1], axes[2]);
    e.half = choose(e.axis, h[0], h[1], h[2]);
    e.is_across = min(min(a0, a1), a2) < splat(side_by_side_edges);
    e.middle = zero3();
    for (int i = 0; i < 3; ++i) {
        const f32x8 way = select(e.axis == splat(static_cast<float>(i)), zero(), h[i]);
        e.middle = e.middle + select(along[i] < zero(), -way, way) * axes[i];
    }
    return e;
}
// The part of the first edge beside which the second one lies, from `low` to `high` along the first, from its middle.
struct EdgePairx8 {
    Vec3x8 between; // from the middle of the first to that of the second
    f32x8 along, cosine, low, high;
};
CAIRN_INLINE EdgePairx8 pair_edges(const SupportEdgex8& a, const SupportEdgex8& b, Vec3x8 offset) {
    EdgePairx8 p;
    p.between = (offset + b.middle) - a.middle;
    p.along = dot(a.direction, p.between), p.cosine = dot(a.direction, b.direction);
    const f32x8 reach = b.half * abs(p.cosine);
    p.low = max(-a.half, p.along - reach), p.high = min(a.half, p.along + reach);
    return p;
}
CAIRN_INLINE mask8 are_side_by_side(const SupportEdgex8& a, const SupportEdgex8& b, Vec3x8 offset) {
    const Vec3x8 product = cross(a.direction, b.direction);
    const EdgePairx8 p = pair_edges(a, b, offset);
    return a.is_across & b.is_across & (dot(product, product) < splat(side_by_side_edges * side_by_side_edges)) &
           (p.low < p.high);
}

// Where corners meet, any direction between the normals of their faces separates the boxes, and the slightest
// displacement changes which face has the greatest separation. The normal is the mean of the normals of those faces
// whose separation is nearly the greatest, weighted by how near it is: two cards that lean on each other press along
// the line between them. Boxes that are still apart have not met at a corner: there the normal is the direction of the
// gap, to which each separating face contributes its component. Otherwise a box that slides past a corner a millimeter
// beside it would be deflected as by a chamfer.
struct CornerNormalx8 {
    Vec3x8 normal;
    mask8 holds; // whether corners meet, and the separation along the normal is nearly the greatest of the faces
};
CAIRN_INLINE CornerNormalx8 corner_normal(const BoxPairx8& p, const RelativeBoxx8& q, const f32x8 (&separation)[6],
                                          f32x8 greatest) {
    // Limits of the ratio of the squared sum of normals to the squared sum of their lengths: the faces are more than
    // some 16 degrees from parallel, and do not oppose each other.
    constexpr float parallel = 0.98f, opposite = 0.25f;
    const f32x8 tolerance = splat(edge_tolerance) * p.smallest;
    const mask8 is_apart = greatest > zero();
    f32x8 share[6], sum = zero(), square = zero(), along = zero(), radius = zero();
    for (int i = 0; i < 6; ++i) {
        const f32x8 t = i < 3 ? q.ta[i] : q.tb[i - 3];
        const f32x8 size = max(select(is_apart, separation[i], tolerance + separation[i] - greatest), zero());
        share[i] = select(t < zero(), -size, size);
        sum += size;
        along += size * abs(t);
    }
    CornerNormalx8 r = {zero3(), zero() > zero()};
    for (int i = 0; i < 3; ++i) {
        const f32x8 on_a = share[i] + ((share[3] * q.r[i][0] + share[4] * q.r[i][1]) + share[5] * q.r[i][2]);
        const f32x8 on_b = share[3 + i] + ((share[0] * q.r[0][i] + share[1] * q.r[1][i]) + share[2] * q.r[2][i]);
        square += on_a * on_a;
        radius += p.ha[i] * abs(on_a) + p.hb[i] * abs(on_b);
        r.normal = r.normal + on_a * p.a[i];
    }
    const f32x8 length = sqrt(square);
    const mask8 meets = (square < splat(parallel) * (sum * sum)) & (square > splat(opposite) * (sum * sum)) &
                        (greatest >= splat(-0.5f) * p.smallest) &
                        (along - radius >= length * (greatest - tolerance - p.error));
    if (!any(meets)) return r;
    r.normal = (one() / select(meets, length, one())) * r.normal;
    r.holds = meets & are_side_by_side(support_edge(p.a, p.ha, r.normal), support_edge(p.b, p.hb, -r.normal), p.offset);
    return r;
}

inline void append_corners(BoxContactList& corners, int base, int lanes, f32x8 separation, const Vec3x8& normal) {
    alignas(32) float s[8], x[8], y[8], z[8];
    store(s, separation), store(x, normal.x), store(y, normal.y), store(z, normal.z);
    for (int i = 0; i < 8; ++i)
        if ((lanes >> i & 1) != 0)
            corners.contacts[corners.count++] = {
                static_cast<std::uint32_t>(base + i), 0, 0, s[i], false, {x[i], y[i], z[i]}};
}

// Computes the manifolds of the corner list: the points are the ends of the part where the edges lie side by side.
inline void corner_manifolds(const BoxBatch& batch, const BoxContactList& corners) {
    constexpr float first_feature = 144.0f; // features of edges are smaller
    for (int k = 0; k < corners.count; k += 8) {
        const ListedPairs listed = gather_listed(batch, corners, k);
        const BoxPairx8 p = gather_boxes<false>(batch.poses, listed.first, listed.second);
        alignas(32) float x[3][8];
        for (int i = 0; i < 8; ++i)
            for (int axis = 0; axis < 3; ++axis) x[axis][i] = listed_at(corners, k + i).normal[axis];
        const Vec3x8 normal = {load(x[0]), load(x[1]), load(x[2])};
        const f32x8 margin = load(listed.margin), least = load(listed.separation);
        const SupportEdgex8 a = support_edge(p.a, p.ha, normal), b = support_edge(p.b, p.hb, -normal);
        const EdgePairx8 e = pair_edges(a, b, p.offset);
        const mask8 none = zero() > zero(), always = zero() <= zero();
        ContactPointx8 points[4] = {{zero3(), zero(), zero(), none},
                                    {zero3(), zero(), zero(), none},
                                    {zero3(), zero(), zero(), none},
                                    {zero3(), zero(), zero(), none}};
        const auto gap_at = [&](f32x8 s) {
            return (e.between + clamp((s - e.along) / e.cosine, -b.half, b.half) * b.direction) - s * a.direction;
        };
        // The point with the smaller separation first: the other may be beyond the margin.
        const Vec3x8 gap_low = gap_at(e.low), gap_high = gap_at(e.high);
        const mask8 turned = dot(normal, gap_high) < dot(normal, gap_low);
        for (int i = 0; i < 2; ++i) {
            const mask8 is_high = i == 0 ? turned : and_not(always, turned);
            const Vec3x8 gap = select(is_high, gap_high, gap_low),
                         on_a = a.middle + select(is_high, e.high, e.low) * a.direction;
            const f32x8 separation = max(dot(normal, gap), least);
            const f32x8 feature =
                splat(first_feature + 16.0f * static_cast<float>(i)) + (splat(3.0f) * a.axis + b.axis);
            const mask8 present = separation <= margin;
            points[i] = {on_a + splat(0.5f) * gap, separation, feature_number(feature), present};
        }
        write_manifolds(listed.out, normal, points);
    }
}

} // namespace cairn::CAIRN_ISA
