// Box against box, 8 pairs at a time: the separating axis test over 15 axes (Gottschalk, Lin, Manocha, "OBBTree",
// 1996), then face clipping or the closest points of two edges (see box_pair.h).
#include "kernels/box_pair.h"
#include "kernels/collide.h"

namespace cairn::CAIRN_ISA {

namespace {

void test_axes(const BoxBatch& batch, int count, BoxContactList& faces, BoxContactList& edges) {
    for (int k = 0; k < count; k += 8) {
        const BoxPairx8 p = gather_boxes<false>(batch.poses, batch.first + k, batch.second + k);
        const RelativeBoxx8 q = relate(p);
        const f32x8 margin = load_unaligned(batch.margin + k);

        // Of the faces, `face` is the preferred and `greatest` the true maximum.
        f32x8 preferred = splat(no_separation), face = zero();
        for (int i = 0; i < 3; ++i) {
            const f32x8 radius = p.hb[0] * q.absolute[i][0] + p.hb[1] * q.absolute[i][1] + p.hb[2] * q.absolute[i][2];
            const f32x8 s = abs(q.ta[i]) - (p.ha[i] + radius);
            const mask8 m = s > preferred;
            preferred = select(m, s, preferred);
            face = select(m, splat(static_cast<float>(i)), face);
        }
        f32x8 greatest = preferred;
        preferred = preferred + (splat(second_face_tolerance) * p.smallest + p.error);
        for (int j = 0; j < 3; ++j) {
            const f32x8 radius = p.ha[0] * q.absolute[0][j] + p.ha[1] * q.absolute[1][j] + p.ha[2] * q.absolute[2][j];
            const f32x8 s = abs(q.tb[j]) - (p.hb[j] + radius);
            const mask8 m = s > preferred;
            preferred = select(m, s, preferred);
            face = select(m, splat(static_cast<float>(3 + j)), face);
            greatest = max(greatest, s);
        }
        mask8 touching = greatest <= margin;
        if (!any(touching)) {
            clear_manifolds(batch.out + k, touching, greatest);
            continue;
        }

        f32x8 edge_separation = splat(no_separation), edge = zero();
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const f32x8 s = edge_axis(p, q, i, j).separation;
                const mask8 m = s > edge_separation;
                edge_separation = select(m, s, edge_separation);
                edge = select(m, splat(static_cast<float>(3 * i + j)), edge);
            }
        touching = touching & (edge_separation <= margin);
        clear_manifolds(batch.out + k, touching, max(greatest, edge_separation));
        const mask8 by_edge = edge_separation > greatest + (splat(edge_tolerance) * p.smallest + p.error);
        append(faces, edges, k, touching, by_edge, face, edge, max(greatest, edge_separation),
               edge_separation > greatest);
    }
}

} // namespace

void box_box(CAIRN_COLLIDE_PARAMETERS) {
    for (int start = 0; start < count; start += batch_pairs) {
        const BoxBatch batch = {poses, first + start, second + start, margin + start, out + start};
        BoxContactList faces, edges;
        test_axes(batch, count - start < batch_pairs ? count - start : batch_pairs, faces, edges);
        face_manifolds<false>(batch, faces, edges);
        edge_manifolds<false>(batch, edges);
    }
}

} // namespace cairn::CAIRN_ISA
