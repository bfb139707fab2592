// Box against box, 8 pairs at a time: the separating axis test over 15 axes (Gottschalk, Lin, Manocha, "OBBTree",
// 1996), then face clipping or the closest points of two edges (see box_pair.h).
#include "kernels/collide/box_corner.h"
#include "kernels/collide/box_pair.h"
#include "kernels/collide/collide.h"

namespace cairn::CAIRN_ISA {

namespace {

// The reference faces of the last step; other numbers mean none.
CAIRN_INLINE f32x8 kept_faces(const BoxBatch& batch, int k) {
    return batch.kept != nullptr ? kept_bytes(batch.kept + k, 0, 4) : splat(15.0f);
}

// Chooses the reference face: that with the greatest separation, where the reference face of the last step gets a
// bonus.
struct FaceChoicex8 {
    f32x8 kept, bonus; // the reference face of the last step, and its bonus
    f32x8 preferred = splat(no_separation), greatest = splat(no_separation), face = zero();

    void add(int number, f32x8 separation) {
        const f32x8 n = splat(static_cast<float>(number)), s = select(kept == n, separation + bonus, separation);
        const mask8 m = s > preferred;
        preferred = select(m, s, preferred);
        face = select(m, n, face);
        greatest = max(greatest, separation);
    }
};

void test_axes(const BoxBatch& batch, int count, BoxContactList& faces, BoxContactList& edges,
               BoxContactList& corners) {
    for (int k = 0; k < count; k += 8) {
        const BoxPairx8 p = gather_boxes<false>(batch.poses, batch.first + k, batch.second + k);
        const RelativeBoxx8 q = relate(p);
        const f32x8 margin = load_unaligned(batch.margin + k);

        f32x8 separation[6];
        FaceChoicex8 choice = {kept_faces(batch, k), splat(kept_face) * p.smallest};
        for (int i = 0; i < 3; ++i) {
            const f32x8 radius = p.hb[0] * q.absolute[i][0] + p.hb[1] * q.absolute[i][1] + p.hb[2] * q.absolute[i][2];
            choice.add(i, separation[i] = abs(q.ta[i]) - (p.ha[i] + radius));
        }
        choice.preferred = choice.preferred + (splat(second_face_tolerance) * p.smallest + p.error);
        for (int j = 0; j < 3; ++j) {
            const f32x8 radius = p.ha[0] * q.absolute[0][j] + p.ha[1] * q.absolute[1][j] + p.ha[2] * q.absolute[2][j];
            choice.add(3 + j, separation[3 + j] = abs(q.tb[j]) - (p.hb[j] + radius));
        }
        const f32x8 greatest = choice.greatest;
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
        // Where the face axes alone separate the shapes, the distance comes from them alone: it must not depend on
        // whether the other pairs of the eight required the edge axes.
        const f32x8 apart = select(touching, max(greatest, edge_separation), greatest);
        touching = touching & (edge_separation <= margin);
        clear_manifolds(batch.out + k, touching, apart);
        const mask8 by_edge = edge_separation > greatest + (splat(edge_tolerance) * p.smallest + p.error);
        const CornerNormalx8 corner = corner_normal(p, q, separation, greatest);
        if (const mask8 meet = and_not(touching & corner.holds, by_edge); any(meet)) {
            append_corners(corners, k, bits(meet), max(greatest, edge_separation), corner.normal);
            touching = and_not(touching, meet);
        }
        append(faces, edges, k, touching, by_edge, choice.face, edge, max(greatest, edge_separation),
               edge_separation > greatest);
    }
}

} // namespace

void box_box(CAIRN_COLLIDE_PARAMETERS) {
    for (int start = 0; start < count; start += batch_pairs) {
        const std::uint32_t* const batch_kept = kept != nullptr ? kept + start : nullptr;
        const BoxBatch batch = {poses, first + start, second + start, margin + start, batch_kept, out + start};
        BoxContactList faces, edges, corners;
        test_axes(batch, count - start < batch_pairs ? count - start : batch_pairs, faces, edges, corners);
        face_manifolds<false>(batch, faces, edges);
        edge_manifolds<false>(batch, edges);
        corner_manifolds(batch, corners);
    }
}

} // namespace cairn::CAIRN_ISA
