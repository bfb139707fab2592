#include "collision/box_triangle.h"

#include <algorithm>
#include <limits>

namespace cairn {

using math::DVec3;

namespace {

// As in contact_clip.cpp and convex_contact.cpp.
constexpr double face_tolerance = 1e-4, second_face_tolerance = 1e-4, rounding = 1e-6, edge_on = 1e-2, downward = 1e-3;
// As in contact_points.cpp.
constexpr double tie = 1 + 2e-4, flat_contact = 1e-4;
// At a cosine this near to 1 a contact is on the face of the triangle wherever it is.
constexpr double same_direction = 1 - 1e-6;

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
    : margin_(margin), extent_(box.extent), inset_(box.radius) {
    const DVec3 origin = to_local(box, center - box.center);
    put(half_, box.size);
    put(origin_, origin);
    for (int k = 0; k < 3; ++k) put(axes_[k], to_local(box, axes.column(k)));
    slack_ = 1e-6 * box.extent + 1e-12 * math::length(origin);
}

void BoxOnTriangles::to_box(math::Vec3 v, double (&out)[3]) const {
    for (int i = 0; i < 3; ++i)
        out[i] = origin_[i] + double(v.x) * axes_[0][i] + double(v.y) * axes_[1][i] + double(v.z) * axes_[2][i];
}

BoxOnTriangles::Verdict BoxOnTriangles::test(const Triangle& triangle, BoxHit& hit) {
    to_box(triangle.a, corners_[0]);
    to_box(triangle.b, corners_[1]);
    to_box(triangle.c, corners_[2]);
    double ab[3], ac[3];
    difference(corners_[1], corners_[0], ab);
    difference(corners_[2], corners_[0], ac);
    cross(ab, ac, normal_);
    square_ = dot(normal_, normal_);
    // Times the length of the normal: the height of the middle, and half the size of the box along the normal.
    height_ = -dot(normal_, corners_[0]);
    const double size =
        half_[0] * std::fabs(normal_[0]) + half_[1] * std::fabs(normal_[1]) + half_[2] * std::fabs(normal_[2]);
    if (height_ * height_ <= slack_ * slack_ * square_) return Verdict::unsure; // on which side?
    if (height_ < 0)
        return is_beyond(-height_ - size, slack_, square_) || is_beside() ? Verdict::apart : Verdict::unsure;
    if (is_beyond(height_ - size, margin_ + slack_, square_)) return Verdict::apart;
    const Face box_face = best_box_face();
    if (box_face.separation > margin_ + slack_) return Verdict::apart;

    const double length = std::sqrt(square_), scale = 1 / length;
    for (double& x : normal_) x *= scale;
    height_ *= scale;
    // The same choice, and the same doubts, as in convex_contact.cpp.
    const double along_normal = height_ - size * scale;
    const bool is_box_face = box_face.separation > along_normal - inset_ &&
                             !(along_normal > box_face.separation + second_face_tolerance * extent_);
    const double least = is_box_face ? box_face.separation : along_normal;
    if (std::max(least, along_normal) > margin_) return Verdict::apart;
    best_face_ = {};
    if (least < -inset_) return Verdict::beyond_faces;
    find_borders();
    hit.count = 0;
    const double reached = is_box_face ? on_box(box_face, hit) : on_triangle(hit);
    if (hit.count == 0 || !(reached <= least + (inset_ + rounding * extent_))) {
        if (!border_is_near()) return Verdict::apart;
        best_face_ = {is_box_face ? 2 * box_face.axis + (box_face.sign < 0 ? 1 : 0) : 0, !is_box_face, reached};
        return Verdict::beyond_faces;
    }
    if (is_box_face && box_face.sign * normal_[box_face.axis] > downward) return Verdict::apart; // it would push down
    return Verdict::touching;
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

// Along whose normal the triangle is farthest.
BoxOnTriangles::Face BoxOnTriangles::best_box_face() const {
    Face best{-std::numeric_limits<double>::infinity(), 0, 1};
    for (int i = 0; i < 3; ++i) {
        const double a = corners_[0][i], b = corners_[1][i], c = corners_[2][i];
        const double above = std::min(std::min(a, b), c) - half_[i], below = -std::max(std::max(a, b), c) - half_[i];
        if (above > best.separation) best = {above, i, 1};
        if (below > best.separation) best = {below, i, -1};
    }
    return best;
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
        if (!(hit.points[n].separation <= reached + flat_contact * extent_)) continue;
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
