#include "collision/convex_contact.h"

#include "collision/contact_axis.h"
#include "collision/face_points.h"
#include "collision/flat_points.h"
#include "shapes/box_triangle_distance.h"
#include "shapes/epa.h"

#include <limits>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

constexpr double none = -std::numeric_limits<double>::infinity();

// Share of the extent: a face of the second shape is the reference face only if it is less deep than the first shape's
// by this.
constexpr double second_face_tolerance = 1e-4;
// Share of the extent: where distances are exact, the normal is replaced by that of a face within this.
constexpr double snap_tolerance = 2e-3;
// With a cylinder, the tolerance is this share of that for polytopes: round sides and rims have normals of their own.
constexpr double round_part = 0.1;

// Share of the extent: tolerance of lengths for rounding errors.
constexpr double rounding = 1e-6;
// Share of the preference for faces: a face that has not been compared with the others may be deeper than its deepest
// point by this at most.
constexpr double unsearched_reach = 0.3;
// Multiple of the overlap: how far from the border of a face its points must be, so that no other face can be better.
constexpr double min_amid = 1.2;
// Relative tolerance of the distance of the cores in GJK: directions are accurate to a thousandth. For round shapes,
// each iteration of GJK reduces the error by a factor, for polytopes the result is exact: 1e-8 took 13 iterations for
// cylinders and capsules, and a third more instructions.
constexpr double direction_tolerance = 1e-6;

// Share of the extent: features whose nearest points are laterally farther apart than this do not touch there.
constexpr double sideways_tolerance = 0.1;

// Reports that there is no contact: the shapes are `separation` apart along the normal.
bool put_apart(Manifold& out, DVec3 normal, double separation) {
    math::put(out.normal, math::to_float(normal));
    out.points[0][3] = static_cast<float>(separation);
    return true;
}

// The axis between a sharp box, inset by `inset`, and a triangle. False if EPA is needed: for other shapes, or if they
// overlap.
bool axis_of_box_and_triangle(const Convex& a, double inset, const Convex& b, Axis& axis) {
    if (a.kind != Convex::Kind::box || !a.is_sharp || b.kind != Convex::Kind::polygon || b.corner_count != 3)
        return false;
    DVec3 corners[3], on_a, on_b;
    for (int i = 0; i < 3; ++i) corners[i] = to_local(a, b.corners[i] - a.center);
    const DVec3 core = a.size - DVec3{inset, inset, inset};
    if (!nearest_of_box_and_triangle(core, corners, on_a, on_b)) return false;
    const DVec3 between = on_b - on_a;
    axis.normal = a.axes * ((1 / math::length(between)) * between);
    axis.touch = a.center + a.axes * (0.5 * (on_a + on_b)) + (0.5 * inset) * axis.normal;
    measure(a, b, axis);
    return true;
}

// Whether GJK runs on the exact cores, not on the inset ones.
bool is_by_exact_cores(const Convex& a, const Convex& b) { return !a.is_sharp || !b.is_sharp; }
CorePair quick_pair(Core a, Core b) {
    a.is_quick = b.is_quick = true;
    return {a, b};
}
CorePair cores_of(const Convex& a, const Convex& b) {
    if (is_by_exact_cores(a, b)) return quick_pair(exact_core(a), exact_core(b));
    return quick_pair(inset_core(a), inset_core(b));
}

// Finds the direction between the cores; false if the shapes are farther apart than the margin. `met`: the nearest
// edges.
bool find_axis(const Convex& a, const Convex& b, double margin, DVec3 guess, Axis& axis, ContactMemory& met) {
    met = nothing_met;
    if (axis_of_box_and_triangle(a, a.radius, b, axis)) return axis.separation <= margin;
    const bool is_exact = is_by_exact_cores(a, b);
    const CorePair pair = cores_of(a, b);
    GjkResult r = gjk_distance(pair, guess, margin + pair.a.radius + pair.b.radius, direction_tolerance);
    axis.normal = r.normal;
    if (r.state == GjkResult::State::far) {
        // The corners of sharp shapes are farther out than the radius around the inset core.
        axis.separation = separation_along(a, b, r.normal);
        if (is_exact || axis.separation > margin) return false;
        r = gjk_distance(pair, r.normal, std::numeric_limits<double>::infinity(), direction_tolerance);
    }
    if (r.state == GjkResult::State::overlapping) {
        const Penetration p = epa_depth(pair, r.simplex);
        axis.normal = p.normal;
        axis.touch = 0.5 * (p.on_a + p.on_b);
    } else {
        axis.normal = r.normal;
        met = memory_of_edges(pair, r);
        axis.touch = 0.5 * (r.on_a + pair.a.radius * r.normal + r.on_b - pair.b.radius * r.normal);
    }
    measure(a, b, axis);
    return axis.separation <= margin;
}

// A contact of two edges, or of the points that are farthest along the normal.
struct EdgeContact {
    ContactPoints points;
    EdgePoints found;

    void find(const Convex& a, const Convex& b, const Axis& axis) {
        Feature first, second;
        edge_feature(a, axis.normal, first);
        edge_feature(b, -axis.normal, second);
        found = edge_points(first, second, axis.normal, axis.separation, points);
    }
    // Whether the shapes are nearest to each other there: between the ends of two edges that the axis is perpendicular
    // to, and without an overlap.
    bool is_nearest(const Axis& axis, double extent) const {
        return axis.separation >= 0 && found.is_cross && found.sideways <= rounding * extent;
    }
    void write(const Axis& axis, double extent, double margin, Manifold& out) {
        // The nearest points are not on these features but inside a round or tilted face: the cores give the position.
        if (found.sideways > sideways_tolerance * extent)
            points.frame.origin = axis.touch - (0.5 * points.list[0].separation) * axis.normal;
        write_manifold(points, axis.normal, points.frame.origin, extent, margin, none, out);
    }
};

// Writes a contact with one point.
void point_manifold(DVec3 position, DVec3 normal, double separation, std::uint32_t feature, double extent,
                    double margin, Manifold& out) {
    ContactPoints points;
    points.frame.origin = position - (0.5 * separation) * normal, points.frame.normal = normal;
    points.list.add({0, 0, separation, feature});
    write_manifold(points, normal, position, extent, margin, none, out);
}

double common_extent(const Convex& a, const Convex& b) {
    const double extent = a.extent < b.extent ? a.extent : b.extent;
    return extent < 1e30 ? extent : math::length(b.corners[1] - b.corners[0]);
}

// The smaller inset or radius of the two shapes, ignoring polygons.
double inset_part_of(const Convex& a, const Convex& b) {
    return a.shallow > 0 && b.shallow > 0 ? std::min(a.shallow, b.shallow) : std::max(a.shallow, b.shallow);
}

// How much deeper a face may be than the axis and still be preferred, as faces give up to four points.
double face_preference(const Convex& a, const Convex& b, double extent) {
    if (!a.is_sharp || !b.is_sharp) return snap_tolerance * extent;
    const bool is_round = a.kind == Convex::Kind::cylinder || b.kind == Convex::Kind::cylinder;
    return (is_round ? round_part : 1) * inset_part_of(a, b);
}

// The face along whose normal the shapes are farthest apart, if its separation is about that of the axis, which may
// itself be a face normal.
FaceAxis preferred_face(const Convex& a, const Convex& b, const Axis& axis, double preference, double extent,
                        FacePoints& found) {
    const double tolerance = second_face_tolerance * extent;
    const bool is_first = axis.face >= 0 && !axis.is_second, is_second = axis.face >= 0 && axis.is_second;
    FaceAxis floor;
    floor.separation = axis.separation - (is_second ? tolerance : preference);
    FaceAxis face = found.on_a.find(a, b, axis.on_b, is_first ? static_cast<const FaceAxis&>(axis) : floor);
    if (face.face >= 0) floor.separation = face.separation + tolerance;
    const bool is_better = is_second && axis.separation > floor.separation;
    if (is_better) floor = axis, floor.normal = -axis.normal;
    const FaceAxis second = found.on_b.find(b, a, axis.on_a, floor);
    if (second.face >= 0)
        face = {-second.normal, second.separation, second.face, true, second.opposite, second.on_face};
    return face;
}

// Inset cores round off edges: where these meet a round side, the axis is that of the sharp shapes. True if it has
// changed.
bool sharpen(const Convex& a, const Convex& b, Axis& axis) {
    if (!a.is_sharp || !b.is_sharp) return false;
    Axis exact;
    if (!axis_of_box_and_triangle(a, 0, b, exact)) {
        const CorePair pair = quick_pair(exact_core(a), exact_core(b));
        const GjkResult r = gjk_distance(pair, axis.normal, std::numeric_limits<double>::infinity());
        exact.normal = r.state == GjkResult::State::overlapping ? epa_depth(pair, r.simplex).normal : r.normal;
        measure(a, b, exact);
    }
    if (!(exact.separation > axis.separation)) return false;
    axis = exact;
    return true;
}

// Writes the contact along an axis found from the cores, or along the normal of a face if that is about as good: then
// true.
bool contact_along(const Convex& a, const Convex& b, Axis axis, double margin, FacePoints& found, Manifold& out) {
    const double extent = common_extent(a, b), preference = face_preference(a, b, extent);
    const FaceAxis face = preferred_face(a, b, axis, preference, extent, found);
    if (face.face >= 0) {
        const double least = std::max(axis.separation, face.separation);
        if (least > margin) return false;
        if (face_manifold(a, b, face, least, preference + rounding * extent, extent, margin, found, out)) return true;
    }
    EdgeContact edges;
    edges.find(a, b, axis);
    if (face.face >= 0 && !edges.is_nearest(axis, extent) && sharpen(a, b, axis)) {
        if (axis.separation > margin) return false;
        edges.find(a, b, axis);
    }
    edges.write(axis, extent, margin, out);
    return false;
}

// Whether the reference face of the last step still gives the contact: its points come as near as any can along its
// normal, so that no other direction separates the shapes more, and other faces need not be tested. Also true if the
// shapes are separated along its normal; there are no points then, and the manifold's normal is that of the face.
// `axis` receives the data of this face, if there is one.
//
// Where the shapes overlap by d, the overlap along a direction at an angle f to the normal is d cos(f) + b sin(f) at
// least, if the points are b away from the border of the face: not less than d as long as b > d tan(f / 2).
bool contact_by_last_face(const Convex& a, const Convex& b, double margin, ContactMemory memory, Axis& axis,
                          FacePoints& found, Manifold& out) {
    if (!face_of_memory(memory, a, b, axis)) return false;
    const Convex &c = axis.is_second ? b : a, &other = axis.is_second ? a : b;
    const DVec3 outward = face_normal(c, axis.face);
    axis.normal = axis.is_second ? -outward : outward;
    const DVec3 on_face = axis.on_face = face_point(c, axis.face);
    const NearSupport nearest = near_support(other, -outward);
    axis.opposite = nearest.vertex;
    axis.on_a = axis.is_second ? nearest.point : on_face, axis.on_b = axis.is_second ? on_face : nearest.point;
    axis.separation = dot(axis.normal, axis.on_b - axis.on_a);
    if (axis.separation > margin) return put_apart(out, axis.normal, axis.separation);
    if (axis.separation < -inset_part_of(a, b)) return false;
    const double extent = common_extent(a, b);
    const double tolerance = unsearched_reach * face_preference(a, b, extent) + rounding * extent;
    if (!face_manifold(a, b, axis, axis.separation, tolerance, extent, margin, found, out)) return false;
    if (axis.separation >= 0 || found.are_amid(c, axis.separation + tolerance, min_amid * -axis.separation))
        return true;
    clear_manifold(out);
    return false;
}

// Tries to find the contact from the last normal, without the cores. True if the shapes are separated along it, or if a
// face near it gives the contact: its points come as near as any points can along the face's normal, so that no other
// direction or face is better. Only for shallow overlaps: for deeper ones, edges might be better. `axis`: that of the
// last reference face, or without a face.
bool contact_by_guess(const Convex& a, const Convex& b, double margin, Axis axis, DVec3 guess, FacePoints& found,
                      Manifold& out) {
    if (axis.face < 0) {
        const double square = dot(guess, guess);
        if (!(square > 0)) return false;
        axis.normal = (1 / std::sqrt(square)) * guess;
        measure(a, b, axis);
    }
    if (axis.separation > margin) return put_apart(out, axis.normal, axis.separation);
    if (face_count(a) == 0 && face_count(b) == 0) return false;
    const double extent = common_extent(a, b), preference = face_preference(a, b, extent);
    const FaceAxis face = preferred_face(a, b, axis, preference, extent, found);
    if (face.face < 0) return false;
    if (face.separation > margin) return put_apart(out, face.normal, face.separation);
    if (face.separation < -inset_part_of(a, b)) return false;
    return face_manifold(a, b, face, face.separation, preference + rounding * extent, extent, margin, found, out);
}

// Whether a shape is a cylinder, or a capsule with equal ends.
bool has_straight_side(const Convex& c) {
    const bool is_cylinder = c.kind == Convex::Kind::cylinder && c.is_sharp;
    return (is_cylinder || c.kind == Convex::Kind::capsule) && c.size.x == c.size.z && c.size.y > 0;
}

// Whether two such shapes, whose axes cross at an angle, are nearest to each other between their ends: then the normal
// is perpendicular to both axes. Also true if they are separated along it. If they overlap, the ends cannot be nearest
// if they are farther away than a multiple of the overlap (contact_by_last_face).
bool contact_by_sides(const Convex& a, const Convex& b, double margin, Manifold& out) {
    if (!has_straight_side(a) || !has_straight_side(b)) return false;
    const DVec3 u = a.axes.c1, v = b.axes.c1, r = b.center - a.center, across = math::cross(u, v);
    const double square = dot(across, across);
    if (!(square > min_crossing * min_crossing)) return false;
    const double uv = dot(u, v), ur = dot(u, r), vr = dot(v, r);
    const double s = (ur - uv * vr) / square, t = (uv * ur - vr) / square; // distances from the centers, in meters
    const double side = dot(across, r) < 0 ? -1 : 1;
    const DVec3 n = (side / std::sqrt(square)) * across;
    const double separation = dot(n, r) - (a.size.x + b.size.x), room = min_amid * std::max(-separation, 0.0);
    if (!(std::fabs(s) < a.size.y - room && std::fabs(t) < b.size.y - room)) return false;
    if (separation > margin) return put_apart(out, n, separation);
    const DVec3 position = a.center + s * u + (a.size.x + 0.5 * separation) * n;
    point_manifold(position, n, separation, 0, common_extent(a, b), margin, out);
    return true;
}

} // namespace

void collide_convex(const Convex& a, const Convex& b, double margin, DVec3 guess, ContactMemory& memory,
                    Manifold& out) {
    clear_manifold(out);
    if (contact_by_sides(a, b, margin, out)) return;
    FacePoints found;
    Axis last;
    const auto tell_face = [&] {
        if (out.count > 0) out.features[0] |= found.known.is_second ? on_second_face : on_first_face;
    };
    if (contact_by_last_face(a, b, margin, memory, last, found, out)) return tell_face();
    Axis axis;
    if (axis_of_edges(memory, cores_of(a, b), axis)) {
        measure(a, b, axis);
    } else {
        memory = nothing_met;
        if (contact_by_guess(a, b, margin, last, guess, found, out)) {
            if (out.count > 0) memory = memory_of_face(found.known.face, found.known.is_second);
            return tell_face();
        }
        find_axis(a, b, margin, guess, axis, memory);
    }
    if (axis.separation <= margin && contact_along(a, b, axis, margin, found, out)) {
        memory = memory_of_face(found.known.face, found.known.is_second);
        tell_face();
    }
    if (out.count > 0) return;
    math::put(out.normal, math::to_float(axis.normal));
    if (axis.separation > margin) put_apart(out, axis.normal, axis.separation);
}

void collide_plane(const Convex& a, DVec3 up, double height, double margin, Manifold& out) {
    clear_manifold(out);
    const DVec3 origin = a.center - height * up; // a point of the plane
    Feature lower;
    incident_feature(a, -up, unknown_vertex, lower);
    ContactPoints points;
    if (lower.kind == Feature::Kind::disc) {
        Feature square;
        square_under(lower, origin, up, square);
        disc_points(square, lower, a.extent, points);
    } else {
        const FlatFrame flat(up, origin);
        points.frame = {origin, flat.e1, flat.e2, up};
        for (const DVec3& p : lower.points) {
            const DVec3 q = points.frame.to_frame(p);
            points.list.add({q.x, q.y, q.z, lower.index << 16 | static_cast<std::uint32_t>(points.list.size())});
        }
    }
    write_manifold(points, -up, a.center, a.extent, margin, none, out);
}

namespace {

// The part of the polygon that contains a point, seen along its normal: the face, or the nearest edge or corner.
SurfaceContact part_of(const Convex& polygon, DVec3 p, double extent) {
    SurfaceContact r;
    int outside = 0;
    for (int i = 0; i < polygon.corner_count; ++i) {
        const DVec3 from = polygon.corners[i], d = polygon.corners[(i + 1) % polygon.corner_count] - from;
        const double length = math::length(d);
        if (dot(math::cross(polygon.axes.c1, d), p - from) > 1e-4 * extent * length) continue;
        if (++outside == 1) r.part = SurfaceContact::Part::edge, r.index = i;
        const double along = dot(p - from, d);
        if (along <= 1e-4 * extent * length) r.part = SurfaceContact::Part::corner, r.index = i;
        if (along >= length * length - 1e-4 * extent * length)
            r.part = SurfaceContact::Part::corner, r.index = (i + 1) % polygon.corner_count;
    }
    return r;
}

bool is_over(const Convex& polygon, DVec3 p) {
    for (int i = 0; i < polygon.corner_count; ++i) {
        const DVec3 from = polygon.corners[i], d = polygon.corners[(i + 1) % polygon.corner_count] - from;
        if (dot(math::cross(polygon.axes.c1, d), p - from) < 0) return false;
    }
    return true;
}

// A push on the first shape counts as downward if its cosine with the polygon's normal is below minus this, as in
// kernels/collide_box_rectangle.cpp.
constexpr double downward = 1e-3;

constexpr double squared_rounding = 1e-10; // difference of a unit vector in float that is computed twice

// Where on the polygon the contact is; a contact that would push down is removed.
SurfaceContact place_of(const Convex& a, const Convex& polygon, Manifold& out) {
    if (out.count == 0) return {};
    const DVec3 n{out.normal[0], out.normal[1], out.normal[2]};
    const double cosine = -dot(n, polygon.axes.c1);
    if (cosine < -downward) {
        clear_manifold(out);
        return {};
    }
    SurfaceContact r;
    const DVec3 off = n + polygon.axes.c1;
    if (dot(off, off) > squared_rounding) {
        const float* p = out.points[0];
        r = part_of(polygon, DVec3{p[0], p[1], p[2]} + (0.5 * p[3]) * n, a.extent);
    }
    r.cosine = cosine;
    return r;
}

// Writes the points over the polygon, with the separation along its normal, at least `separation`.
bool front_manifold(const Convex& a, const Convex& polygon, double separation, double margin, Manifold& out) {
    const FaceAxis face{-polygon.axes.c1, separation, 0, true, unknown_vertex, polygon.corners[0]};
    FacePoints found;
    return face_manifold(a, polygon, face, separation, a.extent, a.extent, margin, found, out);
}

// Pushes a shape out along the polygon's normal, by the points of its lower side; by its center if these are beyond the
// polygon.
void lift(const Convex& a, const Convex& polygon, double margin, Manifold& out) {
    const DVec3 up = polygon.axes.c1;
    const double separation = separation_along(a, polygon, -up);
    if (separation > margin || front_manifold(a, polygon, separation, margin, out)) return;
    const DVec3 m = middle(a);
    const double height = dot(m - polygon.corners[0], up);
    const DVec3 position = m + (0.5 * separation - height) * up;
    point_manifold(position, -up, separation, 0xffff, a.extent, margin, out);
}

// The contact with the front of a polygon if the guess was not sufficient.
SurfaceContact contact_from_cores(const Convex& a, const Convex& polygon, double margin, DVec3 guess, FacePoints& found,
                                  Manifold& out) {
    const DVec3 up = polygon.axes.c1;
    Axis axis;
    ContactMemory met;
    if (!find_axis(a, polygon, margin, guess, axis, met)) return {};
    if (dot(axis.normal, up) > downward) {
        // The normal would push the shape down. Then it has left the polygon, or it is so far above it that it is
        // pushed up.
        const double upward = separation_along(a, polygon, -up);
        if (axis.separation > 0.5 * upward || axis.separation > 0) return {};
        axis.normal = -up;
        measure(a, polygon, axis);
    }
    contact_along(a, polygon, axis, margin, found, out);
    return place_of(a, polygon, out);
}

} // namespace

SurfaceContact collide_surface(const Convex& a, const Convex& polygon, double margin, DVec3 guess, Manifold& out) {
    clear_manifold(out);
    const DVec3 up = polygon.axes.c1, m = inside_of(a);
    const double height = dot(m - polygon.corners[0], up);
    if (height < 0) {
        // A shape that does not extend to the front is not pushed out: it may be on the far side of a thin wall.
        const double top = dot(near_support(a, up).point - polygon.corners[0], up);
        if (top > 0 && is_over(polygon, m)) lift(a, polygon, margin, out);
        return {.is_lifted = true};
    }
    FacePoints found;
    if (contact_by_guess(a, polygon, margin, {}, guess, found, out)) return place_of(a, polygon, out);
    return contact_from_cores(a, polygon, margin, guess, found, out);
}

SurfaceContact collide_surface_beyond(const FaceReach& known, const Convex& a, const Convex& polygon, double margin,
                                      DVec3 guess, Manifold& out) {
    clear_manifold(out);
    FacePoints found;
    found.known = known;
    return contact_from_cores(a, polygon, margin, guess, found, out);
}

void collide_lifted(const Convex& a, const Convex& polygon, double margin, Manifold& out) {
    clear_manifold(out);
    lift(a, polygon, margin, out);
}

void collide_front(const Convex& a, const Convex& polygon, double margin, Manifold& out) {
    clear_manifold(out);
    const double separation = separation_along(a, polygon, -polygon.axes.c1);
    if (separation <= margin) front_manifold(a, polygon, separation, margin, out);
}

} // namespace cairn
