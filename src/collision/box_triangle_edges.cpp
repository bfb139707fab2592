// Contacts of a box and a triangle that face normals do not determine: between two edges, or at a corner of one of
// them. The choices, and their order, are those of the general convex test in convex_contact.cpp.
#include "collision/box_triangle.h"
#include "collision/contact_features.h"
#include "shapes/box_triangle_distance.h"

#include <algorithm>
#include <limits>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

// The same values as in convex_contact.cpp and contact_features.cpp.
constexpr double sideways_tolerance = 0.1, across_tolerance = 1e-2;

// The edge of the box that is perpendicular to the direction n within the tolerance, or the corner that is farthest
// along n.
EdgeLine edge_of_box(DVec3 half, DVec3 n) {
    EdgeLine edge{{n.x < 0 ? -half.x : half.x, n.y < 0 ? -half.y : half.y, n.z < 0 ? -half.z : half.z}, {}};
    double least = across_tolerance;
    for (int i = 0; i < 3; ++i) {
        if (!(std::fabs(n[i]) < least)) continue;
        least = std::fabs(n[i]);
        edge.way = {};
        edge.way[i] = -2 * edge.from[i];
    }
    return edge;
}

// The edge of the triangle that is perpendicular to n within the tolerance, or the corner that is farthest against n.
EdgeLine edge_of_triangle(const DVec3 (&corners)[3], DVec3 n) {
    int lowest = 0;
    const double heights[3] = {dot(corners[0], n), dot(corners[1], n), dot(corners[2], n)};
    for (int i = 1; i < 3; ++i)
        if (heights[i] < heights[lowest]) lowest = i;
    EdgeLine edge{corners[lowest], {}};
    double least = across_tolerance;
    for (const int other : {(lowest + 1) % 3, (lowest + 2) % 3}) {
        const DVec3 way = corners[other] - edge.from;
        const double along = (heights[other] - heights[lowest]) / math::length(way);
        if (along < least) least = along, edge.way = way;
    }
    return edge;
}

} // namespace

// The separating direction from the inset box to the triangle; false if those overlap.
bool BoxOnTriangles::find_axis(double inset, Axis& axis) const {
    const DVec3 corners[3] = {corner(0), corner(1), corner(2)}, size = half();
    DVec3 on_box, on_triangle;
    if (!nearest_of_box_and_triangle(size - DVec3{inset, inset, inset}, corners, on_box, on_triangle)) return false;
    const DVec3 between = on_triangle - on_box;
    const DVec3 n = (1 / math::length(between)) * between;
    axis.normal = n;
    axis.touch = 0.5 * (on_box + on_triangle) + (0.5 * inset) * n;
    axis.separation =
        std::min(dot(n, corners[0]), std::min(dot(n, corners[1]), dot(n, corners[2]))) - dot(math::abs(n), size);
    return true;
}

// Whether the face makes the contact after all: the deepest of its points must be no farther apart than `least`, the
// best separation found, plus a tolerance. `hit` receives the points.
bool BoxOnTriangles::touches_face(bool is_triangle, double least, BoxHit& hit) {
    const FaceReach asked = reach_of(is_triangle, 0);
    if (best_face_.face != asked.face || best_face_.is_second != asked.is_second) {
        const int alone[4] = {tested_, tested_, tested_, tested_};
        FaceTouches touches;
        touch(is_triangle, alone, touches);
        best_face_ = reach_of(is_triangle, touches.reached[0]);
        hit.count = 0;
        if (touches.present[0] != 0) write(touches, is_triangle, tested_, 0, hit);
    }
    if (hit.count == 0 || !(best_face_.reached <= least + (inset_ + rounding * extent_))) return false;
    for (SurfacePoint* p = hit.points; p != hit.points + hit.count; ++p) p->separation = std::max(p->separation, least);
    if (hit.separation < least) {
        hit.foot += (0.5 * (least - hit.separation)) * hit.normal;
        hit.on_face = is_on_face(hit);
        hit.separation = least;
    }
    return true;
}

BoxOnTriangles::Verdict BoxOnTriangles::on_edges(const Axis& axis, BoxHit& hit) const {
    const DVec3 corners[3] = {corner(0), corner(1), corner(2)}, n = axis.normal;
    EdgePoints found = edge_points(edge_of_box(half(), n), edge_of_triangle(corners, n), n, axis.separation);
    // The nearest points are not on these edges but inside a tilted face: the cores give the position.
    if (found.sideways > sideways_tolerance * extent_) found.points[0].position = axis.touch;
    hit.count = 0;
    hit.separation = std::numeric_limits<double>::infinity();
    for (int i = 0; i < found.count; ++i) {
        const EdgePoints::Point& p = found.points[i];
        if (p.separation > margin_) continue;
        hit.points[hit.count++] = {p.position, p.separation};
        hit.separation = std::min(hit.separation, p.separation);
    }
    if (hit.count == 0) return Verdict::apart;
    // If two points are equally deep, the second counts as deepest, as in contact_points.cpp.
    const bool is_second = hit.count == 2 && hit.points[1].separation <= hit.separation + flat_contact_part * extent_;
    const SurfacePoint& deepest = hit.points[is_second ? 1 : 0];
    hit.normal = n;
    hit.foot = deepest.position + (0.5 * deepest.separation) * n;
    hit.on_face = is_on_face(hit);
    return Verdict::touching;
}

BoxOnTriangles::Verdict BoxOnTriangles::beyond_faces(BoxHit& hit) {
    const Face box_face = this->box_face(tested_);
    Axis axis;
    if (!find_axis(inset_, axis)) return Verdict::beyond_faces;
    if (axis.separation > margin_) return Verdict::apart;
    if (dot(axis.normal, up()) > downward) {
        // The normal would push the box down. Then the box has left the triangle, or it is so far above it that it is
        // pushed up.
        if (axis.separation > 0.5 * along_normal_ || axis.separation > 0) return Verdict::apart;
        axis.normal = -up(), axis.separation = along_normal_;
    }
    const double floor = axis.separation - inset_;
    const bool is_box_face = box_face.separation > floor;
    const bool is_triangle =
        along_normal_ > (is_box_face ? box_face.separation + second_face_tolerance * extent_ : floor);
    if (is_box_face || is_triangle) {
        const double least = std::max(axis.separation, is_triangle ? along_normal_ : box_face.separation);
        if (least > margin_) return Verdict::apart;
        if (touches_face(is_triangle, least, hit)) return pushes_down(hit) ? Verdict::apart : Verdict::touching;
        // Inset cores round off edges: where these meet a face, the axis is that of the sharp shapes.
        Axis exact;
        if (!find_axis(0, exact)) return Verdict::beyond_faces;
        if (exact.separation > axis.separation) axis = exact;
        if (axis.separation > margin_) return Verdict::apart;
    }
    return dot(axis.normal, up()) > downward ? Verdict::apart : on_edges(axis, hit);
}

} // namespace cairn
