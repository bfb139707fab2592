#include "shapes/box_depth.h"

#include "shapes/box_capsule.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

constexpr int max_corners = 64;
// Tolerance of the depth, relative to the depth; rounding error relative to the size of the other shape.
constexpr double depth_tolerance = 1e-6, rounding = 1e-13;
// The distance up to which a point counts as part of a shape, relative to the size of the box.
constexpr double point_tolerance = 1e-4;
constexpr int after(int i) { return i == 2 ? 0 : i + 1; }
constexpr DVec3 along(int axis, double length) {
    return {axis == 0 ? length : 0, axis == 1 ? length : 0, axis == 2 ? length : 0};
}

// Clamps x; NaN becomes the least value.
double within(double x, double least, double most) { return !(x > least) ? least : x > most ? most : x; }

struct Chord {
    DVec3 first, last; // support points of the other shape
};
struct Chords {
    Chords() {}
    void add(DVec3 first, DVec3 last) { list[count++] = {first, last}; }
    int count = 0;
    union { // uninitialized until used: clearing it takes longer than all other work
        Chord list[max_corners + 2];
    };
};

// The minimum penetration depth occurs only at certain kinds of normals. The Minkowski difference of a box and another
// shape has candidates of three kinds: a corner of the box against the interior of a face of the other shape, with the
// normal of this face; an edge of the box against anything, with a normal perpendicular to the edge; or a face of the
// box, whose normal is perpendicular to two such edges. So everything except the faces of the other shape follows from
// three plane cross sections. Each is searched by a two-dimensional EPA (epa.h) with chords in place of triangles:
// chords closer than the least depth so far are expanded to the support point along their normal, and most chords never
// are.
// All coordinates are in the frame of the box; normals point from the box to the other shape.
class BoxDepthSearch {
  public:
    BoxDepthSearch(const Convex& box, const Convex& other)
        : box_(box), other_(other), core_(exact_core(other)), half_(box.size) {}

    std::optional<BoxDepth> find() {
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {0, 1}) try_face_of_box(axis, side);
        if (are_apart_) return std::nullopt;
        try_faces_of_other();
#pragma GCC unroll 3
        for (int edge = 0; edge < 3; ++edge) {
            const int j = after(edge), k = after(j);
#pragma GCC unroll 4
            for (int sides = 0; sides < 4; ++sides) {
                const Quarter q{edge, j, k, sides & 1 ? -1.0 : 1.0, sides & 2 ? -1.0 : 1.0};
                const Chord whole{ends_[j][sides & 1], ends_[k][sides >> 1]};
                if (may_be_less(measure(q, whole))) try_edge(q, whole);
            }
        }
        if (are_apart_ || !is_met()) return std::nullopt;
        return BoxDepth{least_.depth, box_.axes * least_.normal, box_.center + box_.axes * least_.on_box,
                        box_.center + box_.axes * least_.on_other};
    }

  private:
    struct Way {
        double depth = std::numeric_limits<double>::infinity();
        DVec3 normal, on_box, on_other;
        bool is_of_other = false; // whether the normal is that of a face of the other shape
    };

    DVec3 to_box(DVec3 p) const { return to_local(box_, p - box_.center); }
    DVec3 farthest(DVec3 d) const { return to_box(core_support(core_, box_.axes * d)); }
    double half_projection(DVec3 normal) const { return dot(half_, math::abs(normal)); }
    DVec3 corner(DVec3 d) const {
        return {d.x < 0 ? -half_.x : half_.x, d.y < 0 ? -half_.y : half_.y, d.z < 0 ? -half_.z : half_.z};
    }

    void offer(const Way& way) {
        are_apart_ = are_apart_ || way.depth < 0;
        if (way.depth < least_.depth) least_ = way;
    }

    void try_face_of_box(int axis, int side) {
        const DVec3 normal = along(axis, side == 0 ? 1 : -1), met = farthest(-normal);
        ends_[axis][side] = met;
        size_ = std::max(size_, math::length(met));
        const double depth = half_[axis] - dot(normal, met);
        offer({depth, normal, met + depth * normal, met});
    }

    // A face of the other shape, given by its outward normal.
    void try_face_of_other(DVec3 out) {
        const DVec3 normal = -out, met = farthest(out), on_box = corner(normal);
        const double depth = half_projection(normal) - dot(normal, met);
        offer({depth, normal, on_box, on_box - depth * normal, true});
    }
    void try_faces_of_other() {
        switch (other_.kind) {
        case Convex::Kind::box:
            for (int axis = 0; axis < 3; ++axis) try_both_sides(other_.axes.column(axis));
            break;
        case Convex::Kind::polygon:
            try_both_sides(other_.axes.c1);
            break;
        case Convex::Kind::cylinder:
            try_both_sides(other_.axes.c1);
            try_round_side();
            break;
        case Convex::Kind::hull:
            try_faces_of_hull();
            break;
        case Convex::Kind::ball:
        case Convex::Kind::capsule:
            break;
        }
    }
    void try_both_sides(DVec3 axis) {
        const DVec3 local = to_local(box_, axis);
        try_face_of_other(local);
        try_face_of_other(-local);
    }

    // The lateral surface of a cylinder or cone, in the planes through its axis and a corner of the box, provided that
    // no edge of the box leads from this corner deeper into the cylinder.
    void try_round_side() {
        const DVec3 size = other_.size, center = to_box(other_.center), axis = to_local(box_, other_.axes.c1);
        const double slope = size.x - size.z, length = std::sqrt(4 * size.y * size.y + slope * slope);
        const double across = 2 * size.y / length, up = slope / length; // the normal of the lateral surface
        for (int i = 0; i < 8; ++i) {
            const DVec3 to{i & 1 ? -half_.x : half_.x, i & 2 ? -half_.y : half_.y, i & 4 ? -half_.z : half_.z};
            const DVec3 from_center = to - center, off = from_center - dot(from_center, axis) * axis;
            const double distance = math::length(off);
            if (!(distance > 0)) continue;
            const DVec3 out = (across / distance) * off + up * axis;
            if (out.x * to.x > 0 || out.y * to.y > 0 || out.z * to.z > 0) continue;
            try_face_of_other(out);
        }
    }

    // Tests the faces of a hull whose depth may be less than the least so far, which is estimated from planes in
    // floats, with a rounding error relative to the sizes.
    void try_faces_of_hull() {
        using namespace columns;
        const HullData& hull = *other_.hull;
        const DVec3 center = to_local(other_, box_.center - other_.center);
        math::Vec3 sides[3];
        for (int i = 0; i < 3; ++i) sides[i] = math::to_float(half_[i] * to_local(other_, box_.axes.column(i)));
        constexpr double float_rounding = 4e-6;
        const double slack =
            float_rounding * (math::length(center) + math::length(half_) + double(hull.bounding_radius)) +
            double(hull.tolerance);
        const auto size = [](F4 v) { return greater(v, -v); };
        for (std::size_t i = 0; i < hull.plane_columns.size(); i += PlaneColumns::width) {
            const F4 depth = size(hull.plane_columns.along(i, sides[0])) + size(hull.plane_columns.along(i, sides[1])) +
                             size(hull.plane_columns.along(i, sides[2])) -
                             hull.plane_columns.above(i, math::to_float(center));
            unsigned less = bits(depth < splat(float(least_.depth + slack)));
            for (; less; less &= less - 1) {
                const std::size_t face = i + std::size_t(__builtin_ctz(less));
                try_face_of_other(to_local(box_, other_.axes * hull.unit_normal(face)));
            }
        }
    }

    // The quarter of the cross section perpendicular to an edge of the box that belongs to one of its corners.
    struct Quarter {
        int edge, j, k;
        double sign_j, sign_k;
    };
    // Distances of a point from the two faces of the box that bound the quarter, positive inside the box.
    double on_j(const Quarter& q, DVec3 p) const { return half_[q.j] - q.sign_j * p[q.j]; }
    double on_k(const Quarter& q, DVec3 p) const { return half_[q.k] - q.sign_k * p[q.k]; }
    struct ChordMeasures {
        double first_j, first_k, run, rise;
        double square, inside; // squared length of the chord; its distance times its length
    };
    ChordMeasures measure(const Quarter& q, const Chord& c) const {
        const double first_j = on_j(q, c.first), first_k = on_k(q, c.first);
        const double run = first_j - on_j(q, c.last), rise = on_k(q, c.last) - first_k;
        return {first_j, first_k, run, rise, run * run + rise * rise, rise * first_j + run * first_k};
    }
    // False if no normal beyond the chord lies between those of the two faces, or if the chord is not nearer than the
    // least depth.
    bool may_be_less(const ChordMeasures& m) const {
        if (!(m.run > 0 && m.rise > 0)) return false;
        constexpr double part = (1 - depth_tolerance) * (1 - depth_tolerance);
        return !(m.inside > 0 && m.inside * m.inside >= part * least_.depth * least_.depth * m.square);
    }
    void try_edge(const Quarter& q, const Chord& whole) {
        Chords chords;
        chords.add(whole.first, whole.last);
        while (chords.count > 0) {
            const Chord c = chords.list[--chords.count];
            const ChordMeasures m = measure(q, c);
            if (!may_be_less(m)) continue;
            const double scale = 1 / std::sqrt(m.square);
            const DVec3 normal = along(q.j, q.sign_j * scale * m.rise) + along(q.k, q.sign_k * scale * m.run);
            const DVec3 met = farthest(-normal);
            const double depth = scale * (m.rise * on_j(q, met) + m.run * on_k(q, met));
            if (depth < least_.depth) {
                const DVec3 on_other = nearest_of(q, c, m, met);
                const DVec3 on_box = along(q.edge, on_other[q.edge]) + along(q.j, q.sign_j * half_[q.j]);
                offer({depth, normal, on_box + along(q.k, q.sign_k * half_[q.k]), on_other});
            }
            if (depth - scale * m.inside <= depth_tolerance * depth + rounding * size_) continue;
            if (are_apart_ || corners_++ == max_corners) return;
            chords.add(c.first, met);
            chords.add(met, c.last);
        }
    }
    // The point of the polyline first - met - last at the same fraction along the chord as the foot of the
    // perpendicular from the edge of the box.
    DVec3 nearest_of(const Quarter& q, const Chord& c, const ChordMeasures& m, DVec3 met) const {
        const double nearest = (m.run * m.first_j - m.rise * m.first_k) / m.square;
        const double middle = (m.run * (m.first_j - on_j(q, met)) + m.rise * (on_k(q, met) - m.first_k)) / m.square;
        if (nearest < middle) return met + within((middle - nearest) / middle, 0, 1) * (c.first - met);
        return met + within((nearest - middle) / (1 - middle), 0, 1) * (c.last - met);
    }

    // Whether the deepest point of one shape lies on the other after the separating translation.
    bool is_met() {
        const double slack = point_tolerance * math::length(half_);
        if (least_.is_of_other) {
            const DVec3 world = box_.center + box_.axes * least_.on_other;
            return holds(world, slack);
        }
        DVec3& p = least_.on_box;
        for (int i = 0; i < 3; ++i) p[i] = within(p[i], -half_[i], half_[i]);
        const DVec3 off = least_.on_other + least_.depth * least_.normal - p;
        return dot(off, off) <= slack * slack;
    }
    // Whether the other shape contains a point that is known to lie on the plane of one of its faces, or on the side of
    // a cylinder.
    bool holds(DVec3 p, double slack) const {
        const DVec3 local = to_local(other_, p - other_.center), size = other_.size;
        switch (other_.kind) {
        case Convex::Kind::box:
            return std::fabs(local.x) <= size.x + slack && std::fabs(local.y) <= size.y + slack &&
                   std::fabs(local.z) <= size.z + slack;
        case Convex::Kind::cylinder: {
            const double radius = size.x + (local.y + size.y) / (2 * size.y) * (size.z - size.x);
            const double most = radius + slack;
            return std::fabs(local.y) <= size.y + slack && local.x * local.x + local.z * local.z <= most * most;
        }
        case Convex::Kind::hull: {
            const PlaneColumns& planes = other_.hull->plane_columns;
            for (std::size_t i = 0; i < planes.size(); i += PlaneColumns::width)
                if (columns::bits(planes.above(i, math::to_float(local)) > columns::splat(float(slack)))) return false;
            return true;
        }
        case Convex::Kind::polygon:
            for (int i = 0; i < other_.corner_count; ++i) {
                const DVec3 from = other_.corners[i], to = other_.corners[i + 1 == other_.corner_count ? 0 : i + 1];
                const DVec3 side = math::cross(other_.axes.c1, to - from);
                if (dot(side, p - from) < -slack * math::length(side)) return false;
            }
            return true;
        default:
            return false;
        }
    }
    const Convex &box_, &other_;
    Core core_;
    DVec3 half_;
    DVec3 ends_[3][2]; // support points of the other shape against the normals of the box's faces
    double size_ = 0;
    Way least_;
    bool are_apart_ = false;
    int corners_ = 0;
};

} // namespace

std::optional<BoxDepth> box_depth(const Convex& box, const Convex& other) {
    if (other.kind == Convex::Kind::capsule) {
        if (!is_capsule_of_one_radius(other)) return std::nullopt;
        const SegmentGap gap = gap_to_segment(box, other);
        if (const double distance = math::length(gap.off); distance > rounding * math::length(box.size)) {
            const DVec3 on_box = box.center + box.axes * gap.on_box, off = box.axes * gap.off;
            return BoxDepth{-distance, (1 / distance) * off, on_box, on_box + off};
        }
    }
    return BoxDepthSearch(box, other).find();
}

} // namespace cairn
