// The two phases that box-box and box-rectangle share. Phase one, 8 pairs at a time, finds the axis of least
// penetration (see collide_box_box.cpp, collide_box_rectangle.cpp) and sorts the pairs that touch into a list of face
// contacts and a list of edge contacts. Phase two computes the manifolds of each list, again 8 at a time, so that no
// lane computes what it does not need.
#pragma once

#include "kernels/collide/face_clip.h"

namespace cairn::CAIRN_ISA {

// Pairs per batch; the lists live on the stack.
constexpr int batch_pairs = 512;

// An edge contact replaces a face contact only where its penetration is less by this fraction of the smallest half
// extent: a face gives up to four points, which stacks need. Faces whose penetration is within this of the least
// contribute to the normal where corners meet.
constexpr float edge_tolerance = 5e-2f;
// A face of the second shape is the reference only where its penetration is less by this fraction of the smallest half
// extent.
constexpr float second_face_tolerance = 1e-4f;
// The reference face of the last step stays the reference until another one's penetration is less by this fraction of
// the smallest half extent. Otherwise the faces of two boxes that lie flat on each other alternate, and with them the
// contact points.
constexpr float kept_face = 3e-3f;
// The error of a projected length, as a fraction of the sum of all half extents.
constexpr float projection_error = 5e-7f;
// Edges whose cross product is shorter than this are parallel: they give no separating axis.
constexpr float parallel_edges = 1e-5f;
// Less than every separation that can occur, m.
constexpr float no_separation = -1e30f;

// The result of phase one for one pair.
struct BoxContact {
    std::uint32_t pair; // index in the batch
    float face;         // 0..2: face axis of the first shape; 3..5: of the second
    float edge;         // 3 i + j: the cross product of axis i of the first and axis j of the second
    float separation;   // the greatest over all axes, which is the true separation
    bool edge_is_best;  // whether an edge axis, not a face axis, has that separation
    float normal[3];    // set where corners meet
};

struct BoxContactList {
    int count = 0;
    BoxContact contacts[batch_pairs + 8];
};

struct BoxPairx8 {
    Vec3x8 offset;         // from the center of a to the center of b
    Vec3x8 a[3], b[3];     // axes in world space
    f32x8 ha[3], hb[3];    // half extents
    f32x8 smallest, error; // the smallest half extent; the error of a projected length
};

// With `flat`, the second shape is a rectangle: a box without thickness along its y axis.
template <bool flat>
CAIRN_INLINE BoxPairx8 gather_boxes(const ShapePose* poses, const std::uint32_t* first, const std::uint32_t* second) {
    const ShapePosex8 a = gather_shapes(poses, first), b = gather_shapes(poses, second);
    const Mat3x8 ra = to_matrix(a.q), rb = to_matrix(b.q);
    BoxPairx8 p = {flat ? offset_between(a, b) : nonzero_center_offset(a, b),
                   {ra.c0, ra.c1, ra.c2},
                   {rb.c0, rb.c1, rb.c2},
                   {a.size.x, a.size.y, a.size.z},
                   {b.size.x, flat ? zero() : b.size.y, b.size.z},
                   zero(),
                   zero()};
    const f32x8 smallest_b = flat ? min(p.hb[0], p.hb[2]) : min(min(p.hb[0], p.hb[1]), p.hb[2]);
    p.smallest = min(min(min(p.ha[0], p.ha[1]), p.ha[2]), smallest_b);
    p.error = splat(projection_error) * ((p.ha[0] + p.ha[1] + p.ha[2]) + (p.hb[0] + p.hb[1] + p.hb[2]));
    return p;
}

// The second box in the frame of the first, and the offset in both frames.
struct RelativeBoxx8 {
    f32x8 r[3][3], absolute[3][3]; // r[i][j] = a[i] . b[j]
    f32x8 ta[3], tb[3];            // offset . a[i], offset . b[j]
};

CAIRN_INLINE RelativeBoxx8 relate(const BoxPairx8& p) {
    RelativeBoxx8 q;
    for (int i = 0; i < 3; ++i) {
        q.ta[i] = dot(p.a[i], p.offset);
        q.tb[i] = dot(p.b[i], p.offset);
        for (int j = 0; j < 3; ++j) {
            q.r[i][j] = dot(p.a[i], p.b[j]);
            q.absolute[i][j] = abs(q.r[i][j]);
        }
    }
    return q;
}

// Axis a[i] x b[j]: the separation along it, `projected` = offset . (a[i] x b[j]), and the length of the cross product.
// Nearly parallel edges give an axis whose direction is uncertain by error / length. This is subtracted from the
// separation, so that such an axis wins only by more than its own uncertainty.
struct EdgeAxisx8 {
    f32x8 separation, projected, length;
};
CAIRN_INLINE EdgeAxisx8 edge_axis(const BoxPairx8& p, const RelativeBoxx8& q, int i, int j) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    const f32x8 squared = q.r[i1][j] * q.r[i1][j] + q.r[i2][j] * q.r[i2][j];
    const mask8 defined = squared > splat(parallel_edges * parallel_edges);
    const f32x8 length = sqrt(select(defined, squared, one()));
    const f32x8 projected = q.ta[i2] * q.r[i1][j] - q.ta[i1] * q.r[i2][j];
    const f32x8 radius = (p.ha[i1] * q.absolute[i2][j] + p.ha[i2] * q.absolute[i1][j]) +
                         (p.hb[j1] * q.absolute[i][j2] + p.hb[j2] * q.absolute[i][j1]);
    const f32x8 separation = ((abs(projected) - radius) - p.error) / length;
    return {select(defined, separation, splat(no_separation)), projected, length};
}

// Selects one of three values by number: 0, 1, or anything greater.
template <class T> CAIRN_INLINE T choose(f32x8 number, T v0, T v1, T v2) {
    return select(number < splat(0.5f), v0, select(number < splat(1.5f), v1, v2));
}
// Rotates three values cyclically, so that number `first` comes first.
template <class T> CAIRN_INLINE void rotate_to(f32x8 first, const T (&in)[3], T (&out)[3]) {
    for (int i = 0; i < 3; ++i) out[i] = choose(first, in[i], in[(i + 1) % 3], in[(i + 2) % 3]);
}

// Appends the touching lanes of eight pairs, of which the first is number `base` of the batch, to the lists.
CAIRN_INLINE void append(BoxContactList& faces, BoxContactList& edges, int base, mask8 touching, mask8 by_edge,
                         f32x8 face, f32x8 edge, f32x8 separation, mask8 edge_is_best) {
    alignas(32) float face_lane[8], edge_lane[8], separation_lane[8];
    store(face_lane, face);
    store(edge_lane, edge);
    store(separation_lane, separation);
    const int touch = bits(touching), by_edge_bits = bits(by_edge), best = bits(edge_is_best);
    for (int i = 0; i < 8; ++i) {
        if ((touch >> i & 1) == 0) continue;
        BoxContactList& list = (by_edge_bits >> i & 1) != 0 ? edges : faces;
        list.contacts[list.count++] = {static_cast<std::uint32_t>(base + i),
                                       face_lane[i],
                                       edge_lane[i],
                                       separation_lane[i],
                                       (best >> i & 1) != 0,
                                       {}};
    }
}

// The pairs of one batch, and eight entries of a list. Lanes beyond the end of the list repeat its last entry, and
// write the same manifold again.
struct BoxBatch {
    const ShapePose* poses;
    const std::uint32_t *first, *second;
    const float* margin;
    const std::uint32_t* kept; // features of the last step; null: none
    Manifold* out;
};
struct ListedPairs {
    alignas(32) float face[8], edge[8], separation[8], margin[8];
    std::uint32_t first[8], second[8];
    Manifold* out[8];
};
CAIRN_INLINE const BoxContact& listed_at(const BoxContactList& list, int i) {
    return list.contacts[i < list.count ? i : list.count - 1];
}
CAIRN_INLINE ListedPairs gather_listed(const BoxBatch& batch, const BoxContactList& list, int k) {
    ListedPairs r;
    for (int i = 0; i < 8; ++i) {
        const BoxContact& c = listed_at(list, k + i);
        r.face[i] = c.face;
        r.edge[i] = c.edge;
        r.separation[i] = c.separation;
        r.margin[i] = batch.margin[c.pair];
        r.first[i] = batch.first[c.pair];
        r.second[i] = batch.second[c.pair];
        r.out[i] = batch.out + c.pair;
    }
    return r;
}

// Byte number `byte` of each lane's features of the last step, without the lowest bits. The lowest byte of a feature is
// 16 * face + the candidate's index, or 128 + edge.
CAIRN_INLINE f32x8 kept_bytes(const std::uint32_t* features, int byte, int lowest_bits) {
    using Words = std::int32_t __attribute__((vector_size(32)));
    using Floats = float __attribute__((vector_size(32)));
    Words words;
    std::memcpy(&words, features, sizeof words);
    const Floats lanes = __builtin_convertvector((words >> (8 * byte) & 255) >> lowest_bits, Floats);
    alignas(32) float lane[8];
    std::memcpy(lane, &lanes, sizeof lane);
    return load(lane);
}

// The indices of the candidates of eight listed faces that were contact points in the last step. Where another face was
// the reference, and for absent points, the results are no valid indices.
CAIRN_INLINE void gather_kept(const BoxBatch& batch, const BoxContactList& list, int k, f32x8 face, f32x8 (&index)[4]) {
    std::uint32_t features[8];
    for (int i = 0; i < 8; ++i)
        features[i] = batch.kept != nullptr ? batch.kept[listed_at(list, k + i).pair] : no_features;
    for (int j = 0; j < 4; ++j) index[j] = kept_bytes(features, j, 0) - splat(16.0f) * face;
}

// A feature number: a small integer as the mantissa bits of 2^23.
CAIRN_INLINE f32x8 feature_number(f32x8 small_integer) { return small_integer + splat(8388608.0f); }

// The frame of the reference face, and the incident face: that of the other shape which is most opposed to it.
struct FaceFrame {
    Vec3x8 normal, e1, e2; // outward normal of the reference face, and its sides' directions
    Vec3x8 origin;         // its center, relative to the first shape's center
    mask8 second;          // whether the reference face is the second shape's
    Vec3x8 other_center;   // the other shape's center in this frame, from the reference shape's center
    FacePair faces;
};

template <bool flat> CAIRN_INLINE FaceFrame face_frame(const BoxPairx8& p, f32x8 face) {
    FaceFrame f;
    f.second = face > splat(2.5f);
    const f32x8 axis = face - select(f.second, splat(3.0f), zero());
    Vec3x8 reference[3], other[3], e[3];
    f32x8 h_reference[3], h_other[3], h[3];
    for (int i = 0; i < 3; ++i) {
        reference[i] = select(f.second, p.b[i], p.a[i]);
        other[i] = select(f.second, p.a[i], p.b[i]);
        h_reference[i] = select(f.second, p.hb[i], p.ha[i]);
        h_other[i] = select(f.second, p.ha[i], p.hb[i]);
    }
    rotate_to(axis, reference, e);
    rotate_to(axis, h_reference, h);
    const Vec3x8 t = select(f.second, -p.offset, p.offset);
    mask8 flip = dot(e[0], t) < zero();
    if (flat) flip = and_not(flip, f.second); // a rectangle's normal points up, also for boxes below it
    f.normal = select(flip, -e[0], e[0]);
    f.e1 = e[1];
    f.e2 = e[2];
    f.origin = select(f.second, p.offset, zero3()) + h[0] * f.normal;

    f32x8 facing[3];
    for (int i = 0; i < 3; ++i) facing[i] = dot(f.normal, other[i]);
    const f32x8 f0 = abs(facing[0]), f1 = abs(facing[1]), f2 = abs(facing[2]);
    f32x8 incident = select((f0 >= f1) & (f0 >= f2), zero(), select(f1 >= f2, one(), splat(2.0f)));
    if (flat) incident = select(f.second, incident, one()); // a rectangle has only this face
    Vec3x8 s[3];
    f32x8 hs[3];
    rotate_to(incident, other, s);
    rotate_to(incident, h_other, hs);
    const f32x8 side = select(choose(incident, facing[0], facing[1], facing[2]) > zero(), -hs[0], hs[0]);
    const auto to_frame = [&](Vec3x8 v) { return Vec3x8{dot(v, f.e1), dot(v, f.e2), dot(v, f.normal)}; };
    f.other_center = to_frame(t);
    f.faces = {h[1], h[2], to_frame(t + side * s[0]), hs[1] * to_frame(s[1]), hs[2] * to_frame(s[2])};
    f.faces.center.z = f.faces.center.z - h[0];
    return f;
}

// A tilted box that has sunk below a rectangle may extend beyond it with its whole lower face. It is then pushed up at
// its center, which is over the rectangle.
CAIRN_INLINE void lift_by_center(const FaceFrame& f, f32x8 separation, ReducedPoints& points) {
    const Vec3x8 c = f.other_center;
    const mask8 sunk = f.second & (c.z < zero()) & (abs(c.x) < f.faces.hx) & (abs(c.y) < f.faces.hy);
    const mask8 lift = and_not(sunk, points.present[0]);
    points.x[0] = select(lift, c.x, points.x[0]);
    points.y[0] = select(lift, c.y, points.y[0]);
    points.z[0] = select(lift, separation, points.z[0]);
    points.index[0] = select(lift, splat(static_cast<float>(face_candidates)), points.index[0]);
    points.present[0] = points.present[0] | lift;
}

// Computes the manifolds of the face list. A face that was preferred to an edge with less penetration never reports
// more than the true penetration; where its polygon does not come near that depth, the pair moves to the edge list.
template <bool flat> void face_manifolds(const BoxBatch& batch, const BoxContactList& faces, BoxContactList& edges) {
    for (int k = 0; k < faces.count; k += 8) {
        const ListedPairs listed = gather_listed(batch, faces, k);
        const BoxPairx8 p = gather_boxes<flat>(batch.poses, listed.first, listed.second);
        const f32x8 face = load(listed.face), least = load(listed.separation);
        const FaceFrame f = face_frame<flat>(p, face);
        const auto candidates = clip(f.faces, load(listed.margin), p.error);
        const f32x8 nearest = splat(same_point) * p.smallest + splat(4.0f) * p.error;
        const f32x8 even = splat(flat_contact) * p.smallest;
        ReducedPoints points = reduce(candidates, nearest, even);
        if (flat) {
            lift_by_center(f, least, points);
        } else {
            f32x8 kept[4];
            gather_kept(batch, faces, k, face, kept);
            prefer(kept, candidates, splat(kept_depth) * p.smallest, even, points);
        }

        ContactPointx8 contact[4];
        for (int i = 0; i < 4; ++i) {
            contact[i].position =
                f.origin + (points.x[i] * f.e1 + points.y[i] * f.e2) + (splat(0.5f) * points.z[i]) * f.normal;
            contact[i].separation = max(points.z[i], least);
            contact[i].feature = feature_number(points.index[i] + splat(16.0f) * face);
            contact[i].present = points.present[i];
        }
        write_manifolds(listed.out, select(f.second, -f.normal, f.normal), contact);

        const f32x8 reached = select(points.present[0], points.z[0], splat(unused_separation));
        const int missed = bits(reached > least + splat(edge_tolerance) * p.smallest + p.error);
        if (missed == 0) continue;
        for (int i = 0; i < 8 && k + i < faces.count; ++i)
            if ((missed >> i & 1) != 0 && faces.contacts[k + i].edge_is_best)
                edges.contacts[edges.count++] = faces.contacts[k + i];
    }
}

// The closest points of two edges: those of their lines, clamped to the edges. w: from the middle of the first edge to
// the middle of the second; u, v: their unit directions; s, t: positions along them.
CAIRN_INLINE void closest_on_edges(Vec3x8 w, Vec3x8 u, Vec3x8 v, f32x8 cross_squared, f32x8 hu, f32x8 hv, f32x8& s,
                                   f32x8& t) {
    const f32x8 uv = dot(u, v), uw = dot(u, w), vw = dot(v, w);
    s = clamp((uw - uv * vw) / cross_squared, -hu, hu);
    t = clamp(s * uv - vw, -hv, hv);
    s = clamp(t * uv + uw, -hu, hu);
}

// Computes the manifolds of the edge list: one point midway between the two edges. Edges that do not overlap give a
// point only where they come within the margin; by the axis alone, edges that pass beside each other would also touch.
template <bool flat> void edge_manifolds(const BoxBatch& batch, const BoxContactList& edges) {
    for (int k = 0; k < edges.count; k += 8) {
        const ListedPairs listed = gather_listed(batch, edges, k);
        const BoxPairx8 p = gather_boxes<flat>(batch.poses, listed.first, listed.second);
        const f32x8 edge = load(listed.edge), margin = load(listed.margin);
        const f32x8 i = select(edge < splat(2.5f), zero(), select(edge < splat(5.5f), one(), splat(2.0f)));
        const f32x8 j = edge - splat(3.0f) * i;
        const Vec3x8 u = choose(i, p.a[0], p.a[1], p.a[2]), v = choose(j, p.b[0], p.b[1], p.b[2]);
        const Vec3x8 product = cross(u, v);
        const f32x8 squared = max(dot(product, product), splat(0.25f * parallel_edges * parallel_edges));
        f32x8 scale = one() / sqrt(squared);
        scale = select(dot(product, p.offset) < zero(), -scale, scale);
        const Vec3x8 normal = scale * product;

        // The middles of the edges of a and b that lie farthest along the normal and against it.
        Vec3x8 middle_a = zero3(), middle_b = p.offset;
        for (int axis = 0; axis < 3; ++axis) {
            const f32x8 number = splat(static_cast<float>(axis));
            const f32x8 ha = select(number == i, zero(), p.ha[axis]), hb = select(number == j, zero(), p.hb[axis]);
            middle_a = middle_a + select(dot(normal, p.a[axis]) < zero(), -ha, ha) * p.a[axis];
            middle_b = middle_b + select(dot(normal, p.b[axis]) < zero(), hb, -hb) * p.b[axis];
        }
        const Vec3x8 w = middle_b - middle_a;
        f32x8 s, t;
        closest_on_edges(w, u, v, squared, choose(i, p.ha[0], p.ha[1], p.ha[2]), choose(j, p.hb[0], p.hb[1], p.hb[2]),
                         s, t);
        const Vec3x8 on_a = middle_a + s * u, on_b = middle_b + t * v, gap = on_b - on_a;
        const f32x8 separation = dot(normal, w);
        const mask8 touching = (separation <= zero()) | (dot(gap, gap) <= margin * margin);
        const mask8 none = zero() > zero();
        const ContactPointx8 unused = {zero3(), zero(), zero(), none};
        write_manifolds(listed.out, normal,
                        {{splat(0.5f) * (on_a + on_b), separation, feature_number(edge + splat(128.0f)), touching},
                         unused,
                         unused,
                         unused});
    }
}

} // namespace cairn::CAIRN_ISA
