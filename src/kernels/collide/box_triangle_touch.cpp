// The contact points of a face of a box with triangles, or of the face of a triangle with a box, four triangles at a
// time, in the frame of the box. As for all convex shapes (collision/contact_clip.cpp), the incident face is clipped
// against the borders of the reference face, and the corners of the reference face over the incident one count too.
#include "kernels/collide/box_triangles.h"

#include "simd/f64x4.h"

namespace cairn::CAIRN_ISA {

namespace {

// As in collision/contact_clip.cpp.
constexpr double face_tolerance = 1e-4, edge_on = 1e-2;
// As in collision/contact_points.cpp.
constexpr double tie = 1 + 2e-4, flat_contact = 1e-4;
// Where the cosine between the normals is at least this, a contact is on the face of the triangle wherever its points
// are.
constexpr double same_direction = 1 - 5e-11;
// Distance from the triangle's border beyond which a point is on the face, as a fraction of the extent.
constexpr double off_border = 1e-4;
constexpr double unlimited = 1e300;

CAIRN_INLINE f64x4 zero4() { return splat4(0); }
CAIRN_INLINE f64x4 one4() { return splat4(1); }

// Coordinates along the axis of FaceTouches, then along the next two axes in cyclic order.
struct Local {
    f64x4 p[3];
    f64x4& operator[](int i) { return p[i]; }
    const f64x4& operator[](int i) const { return p[i]; }
};
CAIRN_INLINE f64x4 dot(const Local& a, const Local& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
CAIRN_INLINE Local cross(const Local& a, const Local& b) {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}
CAIRN_INLINE Local operator-(const Local& a, const Local& b) { return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}}; }

// Four triangles and the box in the Local coordinates of each triangle.
struct LocalTriangles {
    Local half, normal, corners[3];
    f64x4 height;
};

CAIRN_INLINE LocalTriangles to_local(const int* axis, const BoxFrame& box, const TriangleBatch& batch,
                                     const int* which) {
    double rows[15][4], height[4];
    for (int n = 0; n < 4; ++n) {
        const int at = which[n];
        height[n] = batch.height[at];
        for (int k = 0; k < 3; ++k) {
            const int i = axis[n] + k < 3 ? axis[n] + k : axis[n] + k - 3;
            rows[k][n] = box.half[i];
            rows[3 + k][n] = batch.normal[i][at];
            for (int c = 0; c < 3; ++c) rows[6 + 3 * c + k][n] = batch.corners[c][i][at];
        }
    }
    LocalTriangles s;
    for (int k = 0; k < 3; ++k) {
        s.half[k] = load4(rows[k]);
        s.normal[k] = load4(rows[3 + k]);
        for (int c = 0; c < 3; ++c) s.corners[c][k] = load4(rows[6 + 3 * c + k]);
    }
    s.height = load4(height);
    return s;
}

CAIRN_INLINE mask4 bit4(int number) {
    const long long bit = 1LL << number;
    return mask4{bit, bit, bit, bit};
}

// Collects candidate points, which are offered one after the other.
struct Points {
    FaceTouches& out;
    f64x4 margin, reached;
    mask4 present;
};
CAIRN_INLINE void offer(Points& points, int number, mask4 is_there, const Local& p, f64x4 separation) {
    points.reached = select(is_there, min(separation, points.reached), points.reached);
    points.present |= is_there & (separation <= points.margin) & bit4(number);
    for (int k = 0; k < 3; ++k) store4(points.out.position[number][k], p.p[k]);
    store4(points.out.separation[number], separation);
}
CAIRN_INLINE void finish(const Points& points) {
    store4(points.out.reached, points.reached);
    store4(points.out.present, points.present);
}

// The part of an edge from p to q that is inside all sides. p and q: how far inside the ends are, in any unit for each
// side.
struct Part {
    f64x4 start, end;
    mask4 is_there;
};
template <int sides> CAIRN_INLINE Part cut(const f64x4 (&p)[sides], const f64x4 (&q)[sides]) {
    Part part = {zero4(), one4(), {}};
    mask4 is_outside = {};
    for (int k = 0; k < sides; ++k) {
        const mask4 out_p = p[k] < zero4(), out_q = q[k] < zero4();
        const f64x4 t = p[k] / select(out_p ^ out_q, p[k] - q[k], one4());
        part.start = select(out_p, max(part.start, t), part.start);
        part.end = select(out_q, min(part.end, t), part.end);
        is_outside |= out_p & out_q;
    }
    part.is_there = (part.start <= part.end) & ~is_outside;
    return part;
}

// The deepest point; among equally deep ones the outermost, as in contact_points.cpp.
struct Deepest {
    f64x4 j, k, separation, number;
};
CAIRN_INLINE Deepest deepest_of(const Points& points, int count, const LocalTriangles& s, f64x4 extent) {
    const f64x4 third = splat4(1.0 / 3);
    const f64x4 middle_j = (s.corners[0][1] + s.corners[1][1] + s.corners[2][1]) * third;
    const f64x4 middle_k = (s.corners[0][2] + s.corners[1][2] + s.corners[2][2]) * third;
    const f64x4 deep = points.reached + splat4(flat_contact) * extent;
    f64x4 outermost = splat4(-1);
    Deepest best = {zero4(), zero4(), zero4(), zero4()};
    for (int n = 0; n < count; ++n) {
        const f64x4 j = load4(points.out.position[n][1]), k = load4(points.out.position[n][2]);
        const f64x4 separation = load4(points.out.separation[n]);
        const f64x4 dj = j - middle_j, dk = k - middle_k, d = dj * dj + dk * dk;
        const mask4 is_present = (points.present & bit4(n)) != mask4{};
        const mask4 is_better = is_present & (separation <= deep) & (d > outermost * splat4(tie));
        outermost = select(is_better, d, outermost);
        best.j = select(is_better, j, best.j);
        best.k = select(is_better, k, best.k);
        best.separation = select(is_better, separation, best.separation);
        best.number = select(is_better, splat4(n), best.number);
    }
    return best;
}

// Whether a point is not at the borders of the triangle, as projected along its normal.
CAIRN_INLINE mask4 is_inside(const LocalTriangles& s, const Local& foot, f64x4 extent) {
    mask4 inside = ~mask4{};
    for (int e = 0; e < 3; ++e) {
        const Local edge = s.corners[(e + 1) % 3] - s.corners[e], inward = cross(s.normal, edge);
        inside &= dot(inward, foot - s.corners[e]) > splat4(off_border) * extent * sqrt(dot(edge, edge));
    }
    return inside;
}

// Offers the corners of the box's face that are over the triangle, in the order ++, -+, --, +- around the face.
CAIRN_INLINE void offer_corners_of_box(const LocalTriangles& s, f64x4 sign, f64x4 slack, Points& points) {
    const f64x4 ni = s.normal[0], hj = s.half[1], hk = s.half[2];
    const mask4 is_flat = abs(ni) > splat4(edge_on);
    const f64x4 around = select(ni > zero4(), one4(), -one4());
    mask4 inside[4] = {is_flat, is_flat, is_flat, is_flat};
    for (int e = 0; e < 3; ++e) {
        const Local &p = s.corners[e], &q = s.corners[(e + 1) % 3];
        const f64x4 ej = around * (q[1] - p[1]), ek = around * (q[2] - p[2]);
        const f64x4 middle = ek * p[1] - ej * p[2] - slack * sqrt(ej * ej + ek * ek);
        const f64x4 u = -ek * hj, v = ej * hk;
        inside[0] &= middle + u + v >= zero4();
        inside[1] &= middle - u + v >= zero4();
        inside[2] &= middle - u - v >= zero4();
        inside[3] &= middle + u - v >= zero4();
    }
    const f64x4 divisor = select(is_flat, ni, one4());
    for (int c = 0; c < 4; ++c) {
        const f64x4 pj = c == 0 || c == 3 ? hj : -hj, pk = c < 2 ? hk : -hk;
        const f64x4 pi = -(s.height + s.normal[1] * pj + s.normal[2] * pk) / divisor;
        const f64x4 separation = sign * pi - s.half[0];
        offer(points, 6 + c, inside[c], {{sign * (s.half[0] + splat4(0.5) * separation), pj, pk}}, separation);
    }
}

} // namespace

// Triangles clipped against the borders of the box's face.
void touch_on_box(const BoxFrame& box, const TriangleBatch& batch, const int* which, FaceTouches& out) {
    double signs[4];
    for (int n = 0; n < 4; ++n) {
        out.axis[n] = batch.box_face[which[n]] / 2;
        signs[n] = batch.box_face[which[n]] % 2 == 0 ? 1 : -1;
    }
    const LocalTriangles s = to_local(out.axis, box, batch, which);
    const f64x4 sign = load4(signs), hi = s.half[0], hj = s.half[1], hk = s.half[2], extent = splat4(box.extent);
    const f64x4 slack = splat4(2 * face_tolerance) * max(hj, hk);
    f64x4 inside[3][4], z[3];
    for (int c = 0; c < 3; ++c) {
        const Local& p = s.corners[c];
        z[c] = sign * p[0] - hi;
        inside[c][0] = hj + slack - p[1];
        inside[c][1] = hj + slack + p[1];
        inside[c][2] = hk + slack - p[2];
        inside[c][3] = hk + slack + p[2];
    }
    Points points = {out, splat4(box.margin), splat4(unlimited), {}};
    for (int e = 0; e < 3; ++e) {
        const int next = (e + 1) % 3;
        const Local &p = s.corners[e], &q = s.corners[next];
        const Part part = cut(inside[e], inside[next]);
        const auto offer_at = [&](int number, mask4 is_there, f64x4 t) {
            const f64x4 separation = z[e] + t * (z[next] - z[e]);
            offer(points, number, is_there,
                  {{sign * (hi + splat4(0.5) * separation), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])}},
                  separation);
        };
        offer_at(2 * e, part.is_there, part.start);
        offer_at(2 * e + 1, part.is_there & (part.end < one4()), part.end);
    }
    offer_corners_of_box(s, sign, slack, points);
    finish(points);

    const Deepest deepest = deepest_of(points, 10, s, extent);
    const Local foot = {{sign * (hi + deepest.separation), deepest.j, deepest.k}};
    const mask4 is_along = -sign * s.normal[0] >= splat4(same_direction);
    store4(out.on_face, is_along | is_inside(s, foot, extent));
    store4(out.deepest, __builtin_convertvector(deepest.number, mask4));
}

// The face of the box that is most opposed to the triangle, clipped against the borders of the triangle.
void touch_on_triangle(const BoxFrame& box, const TriangleBatch& batch, const int* which, FaceTouches& out) {
    double squares[4];
    for (int n = 0; n < 4; ++n) {
        const int at = which[n];
        const double x = __builtin_fabs(batch.normal[0][at]), y = __builtin_fabs(batch.normal[1][at]),
                     z = __builtin_fabs(batch.normal[2][at]);
        out.axis[n] = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        squares[n] = batch.square[at];
    }
    const LocalTriangles s = to_local(out.axis, box, batch, which);
    const f64x4 ni = s.normal[0], nj = s.normal[1], nk = s.normal[2], hj = s.half[1], hk = s.half[2];
    const f64x4 face = select(ni > zero4(), -s.half[0], s.half[0]);

    Local inward[3];
    f64x4 lengths[3];
    for (int e = 0; e < 3; ++e) {
        const Local edge = s.corners[(e + 1) % 3] - s.corners[e];
        inward[e] = cross(s.normal, edge);
        lengths[e] = sqrt(dot(edge, edge));
    }
    const f64x4 along = abs(dot(s.corners[1] - s.corners[0], s.corners[2] - s.corners[0])) / lengths[0];
    const f64x4 across = sqrt(load4(squares)) / lengths[0];
    const f64x4 slack = splat4(face_tolerance) * max(lengths[0], max(along, across));

    // The corners around the face: ++, -+, --, +- along axes 1 and 2.
    f64x4 inside[4][3];
    for (int e = 0; e < 3; ++e) {
        const Local& w = inward[e];
        const f64x4 middle = w[0] * face - dot(w, s.corners[e]) + slack * lengths[e], u = w[1] * hj, v = w[2] * hk;
        inside[0][e] = middle + u + v;
        inside[1][e] = middle - u + v;
        inside[2][e] = middle - u - v;
        inside[3][e] = middle + u - v;
    }
    const f64x4 z = s.height + ni * face, zj = nj * hj, zk = nk * hk;
    const f64x4 at_j[4] = {hj, -hj, -hj, hj}, at_k[4] = {hk, hk, -hk, -hk};
    const f64x4 at_z[4] = {z + zj + zk, z - zj + zk, z - zj - zk, z + zj - zk};

    Points points = {out, splat4(box.margin), splat4(unlimited), {}};
    const auto offer_point = [&](int number, mask4 is_there, f64x4 pj, f64x4 pk,
                                 f64x4 separation) { // (pj, pk): a point on the box's face
        const f64x4 half = splat4(0.5) * separation;
        offer(points, number, is_there, {{face - half * ni, pj - half * nj, pk - half * nk}}, separation);
    };
    for (int e = 0; e < 4; ++e) {
        const int next = (e + 1) % 4;
        const Part part = cut(inside[e], inside[next]);
        const f64x4 dj = at_j[next] - at_j[e], dk = at_k[next] - at_k[e], dz = at_z[next] - at_z[e];
        const auto offer_at = [&](int number, mask4 is_there, f64x4 t) {
            offer_point(number, is_there, at_j[e] + t * dj, at_k[e] + t * dk, at_z[e] + t * dz);
        };
        offer_at(2 * e, part.is_there, part.start);
        offer_at(2 * e + 1, part.is_there & (part.end < one4()), part.end);
    }
    // Corners of the triangle under the face.
    for (int c = 0; c < 3; ++c) {
        const Local& corner = s.corners[c];
        const f64x4 separation = (face - corner[0]) / ni;
        const f64x4 pj = corner[1] + separation * nj, pk = corner[2] + separation * nk;
        offer_point(8 + c, (abs(pj) <= hj - slack) & (abs(pk) <= hk - slack), pj, pk, separation);
    }
    finish(points);
}

} // namespace cairn::CAIRN_ISA
