#include "collision/box_triangle.h"

#include "collision/contact_points.h"

#include <algorithm>
#include <limits>

namespace cairn {

using math::DVec3;

namespace {

constexpr double off_border = 1e-4; // of the extent: distance from the border of points on the face

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

// Whether gap > least * sqrt(square), without computing the root.
bool is_beyond(double gap, double least, double square) { return gap > 0 && gap * gap > least * least * square; }

// Signed distances of the corners of one polygon from the sides of another one that clips it, positive inside; each
// side's distances may be scaled by any positive factor.
template <int corners, int sides> struct Sides {
    double inside[corners][sides];

    // Clips the edge from corner p to q to the part, in edge parameters, that is within all sides; false if there is
    // none.
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
    unsigned outside[corners]; // one bit per side
};

} // namespace

BoxOnTriangles::BoxOnTriangles(const TriangleKernels& kernels, const Convex& box, DVec3 center, const math::DMat3& axes,
                               double margin)
    : kernels_(kernels), half_(frame_.half), margin_(margin),
      slack_(1e-6 * box.extent + 1e-12 * math::length(center - box.center)), extent_(box.extent), inset_(box.radius) {
    put(frame_.half, box.size);
    put(frame_.origin, to_local(box, center - box.center));
    for (int k = 0; k < 3; ++k) put(frame_.axes[k], to_local(box, axes.column(k)));
    frame_.margin = margin_, frame_.slack = slack_, frame_.extent = extent_, frame_.inset = inset_;
    batch_.count = 0;
}

void BoxOnTriangles::place(const Triangle& triangle, int i) {
    const math::Vec3 corners[3] = {triangle.a, triangle.b, triangle.c};
    for (int c = 0; c < 3; ++c)
        for (int axis = 0; axis < 3; ++axis) batch_.vertices[c][axis][i] = corners[c][axis];
}

double BoxOnTriangles::look() {
    for (int n = batch_.count; n % 4 != 0; ++n) // pad the last block of lanes
        for (auto& corner : batch_.vertices)
            for (auto& along : corner) along[n] = along[n - 1];
    kernels_.see(frame_, batch_);
    for (List* list : {&on_box_, &on_triangle_, &others_}) list->count = 0;
    for (int i = 0; i < batch_.count; ++i) {
        const TriangleView view = batch_.view[i];
        if (view == TriangleView::apart) continue;
        List& list = view == TriangleView::on_box        ? on_box_
                     : view == TriangleView::on_triangle ? on_triangle_
                                                         : others_;
        list.which[list.count++] = i;
    }
    for (List* list : {&on_box_, &on_triangle_})
        for (int n = list->count; n % 4 != 0; ++n) list->which[n] = list->which[n - 1];
    return batch_.distance;
}

void BoxOnTriangles::take(int i) {
    tested_ = i;
    for (int c = 0; c < 3; ++c)
        for (int axis = 0; axis < 3; ++axis) corners_[c][axis] = batch_.corners[c][axis][i];
    for (int axis = 0; axis < 3; ++axis) normal_[axis] = batch_.normal[axis][i];
    along_normal_ = batch_.along_normal[i];
}

void BoxOnTriangles::touch(bool is_triangle, const int* which, FaceTouches& out) const {
    (is_triangle ? kernels_.touch_on_triangle : kernels_.touch_on_box)(frame_, batch_, which, out);
}

// Extracts the contact points of one SIMD lane of the kernel's result, which has at least one.
void BoxOnTriangles::write(const FaceTouches& touches, bool is_triangle, int i, int lane, BoxHit& hit) const {
    const int x = touches.axis[lane], y = x < 2 ? x + 1 : 0, z = y < 2 ? y + 1 : 0;
    const auto place = [&](int n) {
        double p[3];
        p[x] = touches.position[n][0][lane];
        p[y] = touches.position[n][1][lane];
        p[z] = touches.position[n][2][lane];
        return DVec3{p[0], p[1], p[2]};
    };
    hit.count = 0;
    for (auto left = static_cast<unsigned>(touches.present[lane]); left != 0; left &= left - 1) {
        const int n = __builtin_ctz(left);
        hit.points[hit.count++] = {place(n), touches.separation[n][lane]};
    }
    hit.separation = touches.reached[lane];
    SurfacePoint deepest = hit.points[0];
    if (is_triangle) {
        hit.normal = {-batch_.normal[0][i], -batch_.normal[1][i], -batch_.normal[2][i]};
        hit.on_face = true;
    } else {
        const int n = static_cast<int>(touches.deepest[lane]);
        deepest = {place(n), touches.separation[n][lane]};
        double normal[3] = {0, 0, 0};
        normal[x] = box_face(i).sign;
        hit.normal = {normal[0], normal[1], normal[2]};
        hit.on_face = touches.on_face[lane] != 0;
    }
    hit.foot = deepest.position + 0.5 * deepest.separation * hit.normal;
}

BoxOnTriangles::Verdict BoxOnTriangles::on_face(bool is_triangle, int i, int lane, BoxHit& hit) {
    // The same choice of reference face, with the same tolerances, as in convex_contact.cpp.
    const double least = is_triangle ? batch_.along_normal[i] : batch_.along_box[i], reached = touches_.reached[lane];
    hit.count = 0;
    if (touches_.present[lane] != 0) write(touches_, is_triangle, i, lane, hit);
    if (hit.count == 0 || !(reached <= least + (inset_ + rounding * extent_))) {
        take(i);
        if (!border_is_near()) return Verdict::apart;
        best_face_ = reach_of(is_triangle, reached);
        return beyond_faces(hit);
    }
    const Face face = box_face(i);
    if (!is_triangle && face.sign * batch_.normal[face.axis][i] > downward) return Verdict::apart; // it would push down
    return Verdict::touching;
}

BoxOnTriangles::Verdict BoxOnTriangles::on_no_face(int i, BoxHit& hit) {
    const TriangleView view = batch_.view[i];
    if (view == TriangleView::level) return Verdict::unsure;
    take(i);
    if (view == TriangleView::behind) return is_beside() ? Verdict::apart : Verdict::unsure;
    best_face_ = {};
    return beyond_faces(hit);
}

// Whether the center of the box is not over the triangle, as seen along the normal.
bool BoxOnTriangles::is_beside() const {
    for (int e = 0; e < 3; ++e) {
        double edge[3], inward[3];
        difference(corners_[(e + 1) % 3], corners_[e], edge);
        cross(normal_, edge, inward);
        if (is_beyond(dot(inward, corners_[e]), slack_, dot(inward, inward))) return true;
    }
    return false;
}

// Whether the box is near an edge of the triangle: contacts that are not along a face normal occur only there.
bool BoxOnTriangles::border_is_near() const {
    Sides<3, 6> sides;
    for (int c = 0; c < 3; ++c)
        for (int i = 0; i < 3; ++i) {
            const double reach = half_[i] + (margin_ + inset_); // the greatest distance of such contacts from the box
            sides.inside[c][2 * i] = reach - corners_[c][i];
            sides.inside[c][2 * i + 1] = reach + corners_[c][i];
        }
    sides.mark();
    double start, end;
    return sides.cut(0, 1, start, end) || sides.cut(1, 2, start, end) || sides.cut(2, 0, start, end);
}

// Whether a point is inside the borders of the triangle, as seen along its normal, by more than the tolerance.
bool BoxOnTriangles::is_inside(DVec3 foot) const {
    for (int e = 0; e < 3; ++e) {
        const DVec3 from = corner(e), edge = corner((e + 1) % 3) - from;
        const double inside = math::dot(math::cross(up(), edge), foot - from);
        if (!(inside > 0 && inside * inside > off_border * off_border * extent_ * extent_ * math::dot(edge, edge)))
            return false;
    }
    return true;
}

} // namespace cairn
