// Face against face, 8 lanes at a time: the vertices of the polygon where a parallelogram overlaps a rectangle, and the
// choice of four contact points that represent it.
#pragma once

#include "kernels/collide/collide_common.h"

namespace cairn::CAIRN_ISA {

// Points in the frame of the reference face: x and y along the face, z along its outward normal from its
// plane, so that z is the separation.
template <int N> struct CandidatePoints {
    f32x8 x[N], y[N], z[N];
    mask8 valid[N];
};

// The chosen points; `index` is the number of the candidate.
struct ReducedPoints {
    f32x8 x[4], y[4], z[4], index[4];
    mask8 present[4];
};

// Points of a manifold are at least this fraction of the smallest half extent apart.
constexpr float same_point = 1e-3f;
// Depths that differ by less than this fraction of the smallest half extent are equal.
constexpr float flat_contact = 1e-4f;
// Candidates that tie within this relative amount are taken in their fixed order, so that rounding does not
// change the choice from step to step.
constexpr float tie = 1.0f + 2e-4f;
// A third or fourth point must be farther from the line through others than this fraction of the longest distance.
constexpr float thinnest = 1e-3f;

template <int N> CAIRN_INLINE void take(ReducedPoints& r, int slot, mask8 m, const CandidatePoints<N>& c, int i) {
    r.x[slot] = select(m, c.x[i], r.x[slot]);
    r.y[slot] = select(m, c.y[i], r.y[slot]);
    r.z[slot] = select(m, c.z[i], r.z[slot]);
    r.index[slot] = select(m, splat(static_cast<float>(i)), r.index[slot]);
    r.present[slot] = r.present[slot] | m;
}

// Moves slot 3 to slot 2 where only slot 3 is filled.
CAIRN_INLINE mask8 close_gap(ReducedPoints& r) {
    const mask8 gap = and_not(r.present[3], r.present[2]);
    r.x[2] = select(gap, r.x[3], r.x[2]);
    r.y[2] = select(gap, r.y[3], r.y[2]);
    r.z[2] = select(gap, r.z[3], r.z[2]);
    r.index[2] = select(gap, r.index[3], r.index[2]);
    r.present[2] = r.present[2] | gap;
    r.present[3] = and_not(r.present[3], gap);
    return gap;
}

// Chooses the deepest point; the point farthest from it; and on either side of the line through both the point that
// spans the largest triangle. Where that line is an edge of the polygon, so that one side is empty, the fourth is the
// point farthest outside the triangle of the other three (without this, one four-point manifold in nine loses a point).
// Points closer than `nearest` are one point, and depths closer than `flat` are equal: of equally deep points the
// outermost counts as the deepest, so that it is a corner where an edge lies flat.
template <int N> CAIRN_INLINE ReducedPoints reduce(const CandidatePoints<N>& c, f32x8 nearest, f32x8 flat) {
    const mask8 none = zero() > zero();
    ReducedPoints r;
    for (int k = 0; k < 4; ++k) {
        r.x[k] = r.y[k] = r.index[k] = zero();
        r.z[k] = splat(unused_separation);
        r.present[k] = none;
    }
    f32x8 lowest = splat(unused_separation), outermost = -one();
    for (int i = 0; i < N; ++i) lowest = min(lowest, select(c.valid[i], c.z[i], lowest));
    for (int i = 0; i < N; ++i) {
        const f32x8 d = c.x[i] * c.x[i] + c.y[i] * c.y[i];
        const mask8 m = c.valid[i] & (c.z[i] <= lowest + flat) & (d > outermost * splat(tie));
        outermost = select(m, d, outermost);
        take(r, 0, m, c, i);
    }

    f32x8 farthest = nearest * nearest;
    for (int i = 0; i < N; ++i) {
        const f32x8 dx = c.x[i] - r.x[0], dy = c.y[i] - r.y[0], d = dx * dx + dy * dy;
        const mask8 m = c.valid[i] & (d > farthest * splat(tie));
        farthest = select(m, d, farthest);
        take(r, 1, m, c, i);
    }

    // Twice the signed area of a triangle over the line from point 0 to point 1.
    const f32x8 least = splat(thinnest) * farthest;
    const f32x8 ex = select(r.present[1], r.x[1] - r.x[0], zero()), ey = select(r.present[1], r.y[1] - r.y[0], zero());
    f32x8 left = least, right = least;
    for (int i = 0; i < N; ++i) {
        const f32x8 area = ex * (c.y[i] - r.y[0]) - ey * (c.x[i] - r.x[0]);
        const mask8 to_left = c.valid[i] & (area > left * splat(tie)),
                    to_right = c.valid[i] & (-area > right * splat(tie));
        left = select(to_left, area, left);
        right = select(to_right, -area, right);
        take(r, 2, to_left, c, i);
        take(r, 3, to_right, c, i);
    }
    const mask8 turned = close_gap(r);

    const mask8 incomplete = and_not(r.present[2], r.present[3]);
    if (any(incomplete)) {
        const f32x8 ax = r.x[2] - r.x[1], ay = r.y[2] - r.y[1], bx = r.x[0] - r.x[2], by = r.y[0] - r.y[2];
        f32x8 widest = least;
        for (int i = 0; i < N; ++i) {
            const f32x8 a = ay * (c.x[i] - r.x[1]) - ax * (c.y[i] - r.y[1]);
            const f32x8 b = by * (c.x[i] - r.x[2]) - bx * (c.y[i] - r.y[2]);
            const f32x8 outside = max(select(turned, -a, a), select(turned, -b, b));
            const mask8 m = incomplete & c.valid[i] & (outside > widest * splat(tie));
            widest = select(m, outside, widest);
            take(r, 3, m, c, i);
        }
    }
    return r;
}

// The points of the last step are kept only while no candidate is deeper by this fraction of the smallest half extent.
constexpr float kept_depth = 1e-2f;
// The points of the last step are kept only while their area is at least this fraction of that of the best choice.
constexpr float kept_area = 0.7f;

// Twice the area that four points span.
CAIRN_INLINE f32x8 spanned(const ReducedPoints& r) {
    f32x8 x[4], y[4]; // from the first
    for (int k = 1; k < 4; ++k) {
        x[k] = select(r.present[k], r.x[k] - r.x[0], zero());
        y[k] = select(r.present[k], r.y[k] - r.y[0], zero());
    }
    // The maximum over the three ways to pair the points as diagonals.
    const auto area = [&](int k, int i, int j) { return abs(x[k] * (y[j] - y[i]) - y[k] * (x[j] - x[i])); };
    return max(max(area(1, 2, 3), area(2, 1, 3)), area(3, 1, 2));
}

// Replaces a fresh choice by that of the last step where that is still good enough. The fresh choice follows every
// tremor: where eight corners of two faces touch, the best four change from step to step, and a body on such contacts
// does not come to rest. `kept`: the indices of the last step's candidates; other values: none.
template <int N>
CAIRN_INLINE void prefer(const f32x8 (&kept)[4], const CandidatePoints<N>& c, f32x8 depth, f32x8 flat,
                         ReducedPoints& fresh) {
    f32x8 z[N], lowest = splat(unused_separation);
    for (int i = 0; i < N; ++i) {
        z[i] = select(c.valid[i], c.z[i], splat(unused_separation));
        lowest = min(lowest, z[i]);
    }
    ReducedPoints r;
    f32x8 kept_lowest = splat(unused_separation);
    mask8 gone = zero() > zero();
    for (int k = 0; k < 4; ++k) {
        r.index[k] = kept[k];
        r.x[k] = r.y[k] = zero();
        r.z[k] = splat(unused_separation);
        for (int i = 0; i < N; ++i) {
            const mask8 m = r.index[k] == splat(static_cast<float>(i));
            r.x[k] = select(m, c.x[i], r.x[k]);
            r.y[k] = select(m, c.y[i], r.y[k]);
            r.z[k] = select(m, z[i], r.z[k]);
        }
        r.present[k] = r.z[k] < splat(unused_separation);
        gone = gone | and_not(r.index[k] < splat(static_cast<float>(N)), r.present[k]);
        kept_lowest = min(kept_lowest, r.z[k]);
    }
    const mask8 enough =
        r.present[2] & (kept_lowest <= lowest + depth) & (spanned(r) >= splat(kept_area) * spanned(fresh));
    // Equal sets of points are put in the fresh order, the deepest first, where the first is not the deepest any more:
    // the points are solved one after the other, and a fixed order makes a tower of 40 drift.
    mask8 same = fresh.present[2] & (r.z[0] > lowest + flat);
    for (int k = 0; k < 4; ++k) {
        mask8 found = r.index[0] == fresh.index[k];
        for (int i = 1; i < 4; ++i) found = found | (r.index[i] == fresh.index[k]);
        same = and_not(same, and_not(fresh.present[k], found));
    }
    same = and_not(same, r.present[3] ^ fresh.present[3]);
    const mask8 serves = and_not(and_not(enough, gone), same);
    for (int k = 0; k < 4; ++k) {
        fresh.x[k] = select(serves, r.x[k], fresh.x[k]);
        fresh.y[k] = select(serves, r.y[k], fresh.y[k]);
        fresh.z[k] = select(serves, r.z[k], fresh.z[k]);
        fresh.index[k] = select(serves, r.index[k], fresh.index[k]);
        fresh.present[k] = and_not(fresh.present[k], serves) | (serves & r.present[k]);
    }
}

// A rectangle |x| <= hx, |y| <= hy in the plane z = 0, and the parallelogram center +- u +- v.
struct FacePair {
    f32x8 hx, hy;
    Vec3x8 center, u, v;
};

// Number of candidates of a face pair: two of each edge of the parallelogram, four corners of the rectangle.
constexpr int face_candidates = 12;

// Keeps aligned faces of equal size complete under rounding: the rectangle is widened by this fraction of its size, and
// its corners count as inside the parallelogram only where they are inside it by as much.
constexpr float face_tolerance = 1e-4f;

// Computes the vertices of the polygon where the parallelogram, projected along z, overlaps the rectangle. These are
// the ends of the parallelogram's edges, each clipped to the rectangle (always the start, the end only where it is
// clipped), and the rectangle's corners inside the parallelogram. Candidates with a separation greater than `margin`
// are not valid. `rounding` is the error of the coordinates.
CAIRN_INLINE CandidatePoints<face_candidates> clip(const FacePair& f, f32x8 margin, f32x8 rounding) {
    CandidatePoints<face_candidates> c;
    const f32x8 wx = f.hx + (splat(face_tolerance) * f.hx + rounding),
                wy = f.hy + (splat(face_tolerance) * f.hy + rounding);
    // 1 / d for the slab test. An edge that covers less than a hundredth of the widening in the slab's direction counts
    // as parallel to its sides; there only a division by zero must be avoided.
    const auto inverse = [](f32x8 d, f32x8 width) {
        const f32x8 smallest = splat(0.01f * face_tolerance) * width;
        return one() / select(abs(d) > smallest, d, smallest);
    };
    const f32x8 inverse_ux = inverse(f.u.x, wx), inverse_uy = inverse(f.u.y, wy);
    const f32x8 inverse_vx = inverse(f.v.x, wx), inverse_vy = inverse(f.v.y, wy);
    // The edges in order around the parallelogram: from +u+v to -u+v to -u-v to +u-v and back.
    for (int e = 0; e < 4; ++e) {
        const bool along_u = e % 2 == 0, forward = e >= 2, plus = e == 0 || e == 3;
        const Vec3x8 side = along_u ? f.v : f.u, edge = along_u ? f.u : f.v;
        const Vec3x8 middle = plus ? f.center + side : f.center - side, d = forward ? edge : -edge;
        const f32x8 ix = along_u ? inverse_ux : inverse_vx, iy = along_u ? inverse_uy : inverse_vy;
        const f32x8 x1 = (-wx - middle.x) * ix, x2 = (wx - middle.x) * ix;
        const f32x8 y1 = (-wy - middle.y) * iy, y2 = (wy - middle.y) * iy;
        const f32x8 low = max(min(x1, x2), min(y1, y2)), high = min(max(x1, x2), max(y1, y2));
        const f32x8 start = max(forward ? low : -high, -one()), end = min(forward ? high : -low, one());
        const mask8 crosses = start < end;
        for (int k = 0; k < 2; ++k) {
            const f32x8 t = k == 0 ? start : end;
            const int i = 2 * e + k;
            c.x[i] = middle.x + t * d.x;
            c.y[i] = middle.y + t * d.y;
            c.z[i] = middle.z + t * d.z;
            c.valid[i] = crosses & (c.z[i] <= margin);
            if (k == 1) c.valid[i] = c.valid[i] & (end < one());
        }
    }
    // A parallelogram seen edge-on has no inside.
    const f32x8 area = f.u.x * f.v.y - f.u.y * f.v.x;
    const f32x8 reach = (abs(f.u.x) + abs(f.u.y) + abs(f.u.z)) * (abs(f.v.x) + abs(f.v.y) + abs(f.v.z));
    const mask8 open = abs(area) > splat(face_tolerance) * reach;
    const f32x8 inverse_area = one() / select(open, area, one()), inside = splat(1.0f - face_tolerance);
    for (int e = 0; e < 4; ++e) {
        const int i = 8 + e;
        c.x[i] = e == 0 || e == 3 ? f.hx : -f.hx;
        c.y[i] = e < 2 ? f.hy : -f.hy;
        const f32x8 dx = c.x[i] - f.center.x, dy = c.y[i] - f.center.y;
        const f32x8 s = (dx * f.v.y - dy * f.v.x) * inverse_area, t = (f.u.x * dy - f.u.y * dx) * inverse_area;
        c.z[i] = f.center.z + (s * f.u.z + t * f.v.z);
        c.valid[i] = open & (abs(s) < inside) & (abs(t) < inside) & (c.z[i] <= margin);
    }
    return c;
}

} // namespace cairn::CAIRN_ISA
