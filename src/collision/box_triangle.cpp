#include "collision/box_triangle.h"

#include "collision/contact_points.h"
#include "kernels/kernels.h"

#include <algorithm>
#include <limits>

namespace cairn {

using math::DVec3;

namespace {

// As in contact_clip.cpp.
constexpr double face_tolerance = 1e-4, edge_on = 1e-2;
// As in contact_points.cpp.
constexpr double tie = 1 + 2e-4;

double dot(const double (&a)[3], const double (&b)[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
void cross(const double (&a)[3], const double (&b)[3], double (&out)[3]) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}
void difference(const double (&a)[3], const double (&b)[3], double (&out)[3]) {
    for (int i = 0; i < 3; ++i) out[i] = a[i] - b[i];
}
void put(double (&out)[3], DVec3 v) { out[0] = v.x, out[1] = v.y, out[2] = v.z; }

// Whether gap > least, both times the root of `square`.
bool is_beyond(double gap, double least, double square) { return gap > 0 && gap * gap > least * least * square; }

// Sides of a polygon that cut another one: how far the corners of that are inside of each, by any factor for each side.
template <int corners, int sides> struct Sides {
    double inside[corners][sides];

    // The part of the edge from corner p to q that is within all sides; false if there is none.
    bool cut(int p, int q, double& start, double& end) const {
        start = 0, end = 1;
        if ((outside[p] & outside[q]) != 0) return false;
        for (unsigned crossed = outside[p] | outside[q]; crossed != 0; crossed &= crossed - 1) {
            const int side = __builtin_ctz(crossed);
            const double t = inside[p][side] / (inside[p][side] - inside[q][side]);
            if ((outside[p] >> side & 1) != 0)
                start = std::max(start, t);
            else
                end = std::min(end, t);
        }
        return start <= end;
    }
    void mark() {
        for (int i = 0; i < corners; ++i) {
            outside[i] = 0;
            for (int k = 0; k < sides; ++k) outside[i] |= unsigned(inside[i][k] < 0) << k;
        }
    }
    unsigned outside[corners]; // a bit for each side
};

} // namespace

BoxOnTriangles::BoxOnTriangles(const Convex& box, DVec3 center, const math::DMat3& axes, double margin)
    : half_(frame_.half), margin_(margin), slack_(1e-6 * box.extent + 1e-12 * math::length(center - box.center)),
      extent_(box.extent), inset_(box.radius) {
    put(frame_.half, box.size);
    put(frame_.origin, to_local(box, center - box.center));
    for (int k = 0; k < 3; ++k) put(frame_.axes[k], to_local(box, axes.column(k)));
    frame_.margin = margin_, frame_.slack = slack_, frame_.extent = extent_, frame_.inset = inset_;
    batch_.count = 0;
}

void BoxOnTriangles::add(const Triangle& triangle, std::uint32_t index) {
    const int n = batch_.count++;
    batch_.index[n] = index;
    const math::Vec3 corners[3] = {triangle.a, triangle.b, triangle.c};
    for (int c = 0; c < 3; ++c)
        for (int axis = 0; axis < 3; ++axis) batch_.vertices[c][axis][n] = corners[c][axis];
}

double BoxOnTriangles::look() {
    for (int n = batch_.count; n % 4 != 0; ++n) // what the kernel looks at beyond the last
        for (auto& corner : batch_.vertices)
            for (auto& along : corner) along[n] = along[n - 1];
    kernels().see_triangles(frame_, batch_);
    return batch_.distance;
}

void BoxOnTriangles::take(int i) {
    for (int c = 0; c < 3; ++c)
        for (int axis = 0; axis < 3; ++axis) corners_[c][axis] = batch_.corners[c][axis][i];
    for (int axis = 0; axis < 3; ++axis) normal_[axis] = batch_.normal[axis][i];
    square_ = batch_.square[i], height_ = batch_.height[i], along_normal_ = batch_.along_normal[i];
}

BoxOnTriangles::Verdict BoxOnTriangles::test(int i, BoxHit& hit) {
    const TriangleView view = batch_.view[i];
    if (view == TriangleView::apart) return Verdict::apart;
    if (view == TriangleView::level) return Verdict::unsure;
    take(i);
    if (view == TriangleView::behind) return is_beside() ? Verdict::apart : Verdict::unsure;
    const Face box_face{batch_.along_box[i], batch_.box_face[i] / 2, batch_.box_face[i] % 2 == 0 ? 1.0 : -1.0};
    best_face_ = {};
    find_borders();
    if (view == TriangleView::deep) return beyond_faces(box_face, hit);
    // The same choice, and the same doubts, as in convex_contact.cpp.
    const bool is_triangle = view == TriangleView::on_triangle;
    const double least = is_triangle ? along_normal_ : box_face.separation;
    hit.count = 0;
    const double reached = is_triangle ? on_triangle(hit) : on_box(box_face, hit);
    if (hit.count == 0 || !(reached <= least + (inset_ + rounding * extent_))) {
        if (!border_is_near()) return Verdict::apart;
        best_face_ = reach_of(box_face, is_triangle, reached);
        return beyond_faces(box_face, hit);
    }
    return pushes_down(hit) ? Verdict::apart : Verdict::touching;
}

// The middle of the box is not over the triangle, as seen along the normal.
bool BoxOnTriangles::is_beside() const {
    for (int e = 0; e < 3; ++e) {
        double edge[3], inward[3];
        difference(corners_[(e + 1) % 3], corners_[e], edge);
        cross(normal_, edge, inward);
        if (is_beyond(dot(inward, corners_[e]), slack_, dot(inward, inward))) return true;
    }
    return false;
}

// What a triangle has beyond faces is at its border.
bool BoxOnTriangles::border_is_near() const {
    Sides<3, 6> sides;
    for (int c = 0; c < 3; ++c)
        for (int i = 0; i < 3; ++i) {
            const double reach = half_[i] + (margin_ + inset_); // as far as points may be from where faces say
            sides.inside[c][2 * i] = reach - corners_[c][i];
            sides.inside[c][2 * i + 1] = reach + corners_[c][i];
        }
    sides.mark();
    double start, end;
    return sides.cut(0, 1, start, end) || sides.cut(1, 2, start, end) || sides.cut(2, 0, start, end);
}

void BoxOnTriangles::find_borders() {
    for (int e = 0; e < 3; ++e) {
        double edge[3];
        difference(corners_[(e + 1) % 3], corners_[e], edge);
        cross(normal_, edge, inward_[e]);
        lengths_[e] = std::sqrt(dot(edge, edge));
    }
}

void BoxOnTriangles::add(BoxHit& hit, const double (&position)[3], double separation) const {
    hit.points[hit.count++] = {{position[0], position[1], position[2]}, separation};
}

// The face of the box that looks at the triangle most, cut at the borders of that. Returns the least separation.
double BoxOnTriangles::on_triangle(BoxHit& hit) const {
    const double nx = std::fabs(normal_[0]), ny = std::fabs(normal_[1]), nz = std::fabs(normal_[2]);
    const int i = nx >= ny && nx >= nz ? 0 : ny >= nz ? 1 : 2, j = (i + 1) % 3, k = (i + 2) % 3;
    const double face = normal_[i] > 0 ? -half_[i] : half_[i], hj = half_[j], hk = half_[k];

    double ac[3], ab[3];
    difference(corners_[1], corners_[0], ab);
    difference(corners_[2], corners_[0], ac);
    const double along = std::fabs(dot(ab, ac)) / lengths_[0], across = std::sqrt(square_) / lengths_[0];
    const double slack = face_tolerance * std::max(lengths_[0], std::max(along, across));

    // Around the face: ++, -+, --, +- along axes j and k.
    Sides<4, 3> sides;
    for (int e = 0; e < 3; ++e) {
        const double(&w)[3] = inward_[e];
        const double middle = w[i] * face - dot(w, corners_[e]) + slack * lengths_[e], u = w[j] * hj, v = w[k] * hk;
        sides.inside[0][e] = middle + u + v;
        sides.inside[1][e] = middle - u + v;
        sides.inside[2][e] = middle - u - v;
        sides.inside[3][e] = middle + u - v;
    }
    sides.mark();
    const double z = height_ + normal_[i] * face, zj = normal_[j] * hj, zk = normal_[k] * hk;
    const double at_j[4] = {hj, -hj, -hj, hj}, at_k[4] = {hk, hk, -hk, -hk};
    const double at_z[4] = {z + zj + zk, z - zj + zk, z - zj - zk, z + zj - zk};

    double reached = std::numeric_limits<double>::infinity();
    const auto offer = [&](double pi, double pj, double pk, double separation) { // a point of the box
        if (separation < reached) reached = separation;
        if (separation > margin_) return;
        double p[3];
        p[i] = pi - 0.5 * separation * normal_[i];
        p[j] = pj - 0.5 * separation * normal_[j];
        p[k] = pk - 0.5 * separation * normal_[k];
        add(hit, p, separation);
    };
    for (int e = 0; e < 4; ++e) {
        const int next = (e + 1) % 4;
        double start, end;
        if (!sides.cut(e, next, start, end)) continue;
        const double dj = at_j[next] - at_j[e], dk = at_k[next] - at_k[e], dz = at_z[next] - at_z[e];
        offer(face, at_j[e] + start * dj, at_k[e] + start * dk, at_z[e] + start * dz);
        if (end < 1) offer(face, at_j[e] + end * dj, at_k[e] + end * dk, at_z[e] + end * dz);
    }
    // Corners of the triangle under the face.
    for (const double(&corner)[3] : corners_) {
        const double separation = (face - corner[i]) / normal_[i];
        const double pj = corner[j] + separation * normal_[j], pk = corner[k] + separation * normal_[k];
        if (std::fabs(pj) <= hj - slack && std::fabs(pk) <= hk - slack) offer(face, pj, pk, separation);
    }
    hit.normal = {-normal_[0], -normal_[1], -normal_[2]};
    hit.on_face = true;
    hit.separation = reached;
    if (hit.count > 0) hit.foot = hit.points[0].position + 0.5 * hit.points[0].separation * hit.normal;
    return reached;
}

// The triangle cut at the borders of the box's face. Returns the least separation.
double BoxOnTriangles::on_box(const Face& face, BoxHit& hit) const {
    const int i = face.axis, j = (i + 1) % 3, k = (i + 2) % 3;
    const double sign = face.sign, hi = half_[i], hj = half_[j], hk = half_[k];
    const double slack = face_tolerance * 2 * std::max(hj, hk);
    double at_z[3];
    Sides<3, 4> sides;
    for (int c = 0; c < 3; ++c) {
        const double(&p)[3] = corners_[c];
        at_z[c] = sign * p[i] - hi;
        sides.inside[c][0] = hj + slack - p[j];
        sides.inside[c][1] = hj + slack + p[j];
        sides.inside[c][2] = hk + slack - p[k];
        sides.inside[c][3] = hk + slack + p[k];
    }
    sides.mark();
    double reached = std::numeric_limits<double>::infinity();
    const auto offer = [&](double pj, double pk, double separation) {
        if (separation < reached) reached = separation;
        if (separation > margin_) return;
        double p[3];
        p[i] = sign * (hi + 0.5 * separation), p[j] = pj, p[k] = pk;
        add(hit, p, separation);
    };
    for (int e = 0; e < 3; ++e) {
        const int next = (e + 1) % 3;
        double start, end;
        if (!sides.cut(e, next, start, end)) continue;
        const double(&p)[3] = corners_[e], (&q)[3] = corners_[next];
        const double dj = q[j] - p[j], dk = q[k] - p[k], dz = at_z[next] - at_z[e];
        offer(p[j] + start * dj, p[k] + start * dk, at_z[e] + start * dz);
        if (end < 1) offer(p[j] + end * dj, p[k] + end * dk, at_z[e] + end * dz);
    }
    // Corners of the face over the triangle, around it from ++ to -+ and so on.
    if (std::fabs(normal_[i]) > edge_on) {
        const double around = normal_[i] > 0 ? 1 : -1;
        Sides<4, 3> borders;
        for (int e = 0; e < 3; ++e) {
            const double(&p)[3] = corners_[e], (&q)[3] = corners_[(e + 1) % 3];
            const double ej = around * (q[j] - p[j]), ek = around * (q[k] - p[k]);
            const double middle = ek * p[j] - ej * p[k] - slack * std::sqrt(ej * ej + ek * ek);
            const double u = -ek * hj, v = ej * hk;
            borders.inside[0][e] = middle + u + v;
            borders.inside[1][e] = middle - u + v;
            borders.inside[2][e] = middle - u - v;
            borders.inside[3][e] = middle + u - v;
        }
        borders.mark();
        for (int c = 0; c < 4; ++c) {
            if (borders.outside[c] != 0) continue;
            const double pj = c == 0 || c == 3 ? hj : -hj, pk = c < 2 ? hk : -hk;
            const double pi = -(height_ + normal_[j] * pj + normal_[k] * pk) / normal_[i];
            offer(pj, pk, sign * pi - hi);
        }
    }
    double normal[3] = {0, 0, 0};
    normal[i] = sign;
    hit.normal = {normal[0], normal[1], normal[2]};
    if (hit.count > 0) choose_deepest(face, reached, hit);
    return reached;
}

// Among equally deep points the outermost, as in contact_points.cpp.
void BoxOnTriangles::choose_deepest(const Face& face, double reached, BoxHit& hit) const {
    const int j = (face.axis + 1) % 3, k = (face.axis + 2) % 3;
    const double middle_j = (corners_[0][j] + corners_[1][j] + corners_[2][j]) * (1.0 / 3);
    const double middle_k = (corners_[0][k] + corners_[1][k] + corners_[2][k]) * (1.0 / 3);
    double outermost = -1;
    int best = 0;
    for (int n = 0; n < hit.count; ++n) {
        if (!(hit.points[n].separation <= reached + flat_contact_part * extent_)) continue;
        const double dj = hit.points[n].position[j] - middle_j, dk = hit.points[n].position[k] - middle_k;
        const double d = dj * dj + dk * dk;
        if (d > outermost * tie) outermost = d, best = n;
    }
    const BoxHit::Point& deepest = hit.points[best];
    hit.separation = reached;
    hit.foot = deepest.position + 0.5 * deepest.separation * hit.normal;
    hit.on_face = -face.sign * normal_[face.axis] >= same_direction || is_inside(hit.foot);
}

// Not at the borders of the triangle, as seen along its normal.
bool BoxOnTriangles::is_inside(DVec3 foot) const {
    for (int e = 0; e < 3; ++e) {
        const double from[3] = {foot.x - corners_[e][0], foot.y - corners_[e][1], foot.z - corners_[e][2]};
        if (!(dot(inward_[e], from) > 1e-4 * extent_ * lengths_[e])) return false;
    }
    return true;
}

} // namespace cairn
