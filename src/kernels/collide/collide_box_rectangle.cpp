// Box against a one-sided finite rectangle, 8 pairs at a time.
//
// While the box's center is above the rectangle's plane, both are tested as convex shapes: the axes are the rectangle's
// normal, the box's three, and the six cross products of their edges; but the box is only ever pushed up or sideways.
// An axis that would push it down only decides whether there is a contact: there is none where the box leaves in that
// direction over the rectangle's edge by much less than it would upward, or is already out. A box whose center is below
// the plane is pushed up along the normal while the center is over the rectangle and part of the box is above the
// plane. Any other box below does not touch: it may be on the far side of a thin wall.
#include "kernels/collide/box_pair.h"
#include "kernels/collide/collide.h"

namespace cairn::CAIRN_ISA {

namespace {

// A push counts as downward where its direction has a component along the normal of less than this.
constexpr float downward = -1e-3f;

// The best axis so far, and (`blocked`) the greatest separation along an axis that would push downward.
struct BestAxis {
    f32x8 separation, axis, blocked;
};
// `against` is the sine of the axis' slope against the normal, positive where the push would go down.
CAIRN_INLINE void consider(BestAxis& best, f32x8 separation, f32x8 number, f32x8 against, f32x8 bias) {
    const mask8 down = -against < splat(downward);
    best.blocked = max(best.blocked, select(down, separation, splat(no_separation)));
    const mask8 m = and_not(separation > best.separation + bias, down);
    best.separation = select(m, separation, best.separation);
    best.axis = select(m, number, best.axis);
}

void test_axes(const BoxBatch& batch, int count, BoxContactList& faces, BoxContactList& edges) {
    for (int k = 0; k < count; k += 8) {
        const BoxPairx8 p = gather_boxes<true>(batch.poses, batch.first + k, batch.second + k);
        const RelativeBoxx8 q = relate(p);
        const f32x8 margin = load_unaligned(batch.margin + k), height = -q.tb[1];
        const f32x8 reach = p.ha[0] * q.absolute[0][1] + p.ha[1] * q.absolute[1][1] + p.ha[2] * q.absolute[2][1];
        const f32x8 lowest = height - reach;
        const auto signed_like = [](f32x8 value, f32x8 sign) { return select(sign < zero(), -value, value); };

        BestAxis face = {lowest, splat(4.0f), splat(no_separation)};
        f32x8 greatest = lowest;
        const f32x8 bias = splat(second_face_tolerance) * p.smallest + p.error;
        for (int i = 0; i < 3; ++i) {
            const f32x8 radius = p.hb[0] * q.absolute[i][0] + p.hb[2] * q.absolute[i][2];
            const f32x8 s = abs(q.ta[i]) - (p.ha[i] + radius);
            const f32x8 against = signed_like(q.r[i][1], q.ta[i]);
            consider(face, s, splat(static_cast<float>(i)), against, select(face.axis == splat(4.0f), bias, zero()));
            greatest = max(greatest, select(-against < splat(downward), splat(no_separation), s));
        }
        BestAxis edge = {splat(no_separation), zero(), face.blocked};
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; j += 2) {
                const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
                const EdgeAxisx8 e = edge_axis(p, q, i, j);
                const f32x8 slope = (q.r[i1][j] * q.r[i2][1] - q.r[i2][j] * q.r[i1][1]) / e.length;
                consider(edge, e.separation, splat(static_cast<float>(3 * i + j)), signed_like(slope, e.projected),
                         zero());
            }

        const mask8 above = height >= zero();
        const mask8 sunk = (abs(q.tb[0]) < p.hb[0]) & (abs(q.tb[2]) < p.hb[2]) & (-height < reach);
        face.axis = select(above, face.axis, splat(4.0f));
        greatest = select(above, greatest, lowest);
        const f32x8 edge_separation = select(above, edge.separation, splat(no_separation));
        const f32x8 separation = max(greatest, edge_separation);
        const mask8 leaves = edge.blocked > min(splat(0.5f) * separation, zero());
        const mask8 touching = (and_not(above, leaves) | and_not(sunk, above)) & (separation <= margin);
        clear_manifolds(batch.out + k, touching, splat(unused_separation));
        if (!any(touching)) continue;
        const mask8 by_edge = edge_separation > greatest + (splat(edge_tolerance) * p.smallest + p.error);
        append(faces, edges, k, touching, by_edge, face.axis, edge.axis, separation, edge_separation > greatest);
    }
}

} // namespace

void box_rectangle(CAIRN_COLLIDE_PARAMETERS) {
    for (int start = 0; start < count; start += batch_pairs) {
        const BoxBatch batch = {poses, first + start, second + start, margin + start, nullptr, out + start};
        BoxContactList faces, edges;
        test_axes(batch, count - start < batch_pairs ? count - start : batch_pairs, faces, edges);
        face_manifolds<true>(batch, faces, edges);
        edge_manifolds<true>(batch, edges);
    }
}

} // namespace cairn::CAIRN_ISA
