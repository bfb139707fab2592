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

// The second shape's faces are the reference only where they are less deep by this part of the extent.
constexpr double second_face_tolerance = 1e-4;
// Where distances are exact, a normal is made that of a face within this part of the extent.
constexpr double snap_tolerance = 2e-3;
// With a cylinder, this part of the tolerance for polytopes: round sides and rims have normals of their own.
constexpr double round_part = 0.1;

// Of lengths, as part of the extent.
constexpr double rounding = 1e-6;
// Of the preference for faces: how much deeper a face that has not been compared with the others may be than its points
// reach.
constexpr double unsearched_reach = 0.3;
// Of an overlap: how far from the border of a face its points must be for the other faces to be out of the question.
constexpr double min_amid = 1.2;
// Of the distance of the cores: directions are within a thousandth. Round shapes come nearer by a factor in each turn
// of GJK, polytopes are exact at once: 1e-8 took 13 turns for cylinders and capsules, and a third more instructions.
constexpr double direction_tolerance = 1e-6;

// Features that pass each other by more than this part of the extent do not touch there.
constexpr double sideways_tolerance = 0.1;

// No contact: the shapes are that far apart along the normal.
bool put_apart(Manifold& out, DVec3 normal, double separation) {
    math::put(out.normal, math::to_float(normal));
    out.points[0][3] = static_cast<float>(separation);
    return true;
}

// Between a sharp box, inset by so much, and a triangle. False where EPA must look: they are others, or they meet.
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

// Of which the nearest points are looked for.
bool is_by_exact_cores(const Convex& a, const Convex& b) { return !a.is_sharp || !b.is_sharp; }
CorePair quick_pair(Core a, Core b) {
    a.is_quick = b.is_quick = true;
    return {a, b};
}
CorePair cores_of(const Convex& a, const Convex& b) {
    if (is_by_exact_cores(a, b)) return quick_pair(exact_core(a), exact_core(b));
    return quick_pair(inset_core(a), inset_core(b));
}

// The direction between the cores; false when the shapes are farther apart than the margin. `met`: what is nearest.
bool find_axis(const Convex& a, const Convex& b, double margin, DVec3 guess, Axis& axis, ContactMemory& met) {
    met = nothing_met;
    if (axis_of_box_and_triangle(a, a.radius, b, axis)) return axis.separation <= margin;
    const bool is_exact = is_by_exact_cores(a, b);
    const CorePair pair = cores_of(a, b);
    GjkResult r = gjk_distance(pair, guess, margin + pair.a.radius + pair.b.radius, direction_tolerance);
    axis.normal = r.normal;
    if (r.state == GjkResult::State::far) {
        // The corners of sharp shapes reach farther than the radius.
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

// Edge against edge, or whatever lies farthest along the normal.
struct EdgeContact {
    ContactPoints points;
    EdgePoints found;

    void find(const Convex& a, const Convex& b, const Axis& axis) {
        Feature first, second;
        edge_feature(a, axis.normal, first);
        edge_feature(b, -axis.normal, second);
        found = edge_points(first, second, axis.normal, axis.separation, points);
    }
    // Whether the shapes are nearest to each other there: between the ends of two edges that the axis is across, if
    // nothing overlaps.
    bool is_nearest(const Axis& axis, double extent) const {
        return axis.separation >= 0 && found.is_cross && found.sideways <= rounding * extent;
    }
    void write(const Axis& axis, double extent, double margin, Manifold& out) {
        // Not these features but the inside of a round or a tilted face: the cores know where.
        if (found.sideways > sideways_tolerance * extent)
            points.frame.origin = axis.touch - (0.5 * points.list[0].separation) * axis.normal;
        write_manifold(points, axis.normal, points.frame.origin, extent, margin, none, out);
    }
};

// A contact of one point.
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

// The smaller inset or radius of the two, without that of polygons.
double inset_part_of(const Convex& a, const Convex& b) {
    return a.shallow > 0 && b.shallow > 0 ? std::min(a.shallow, b.shallow) : std::max(a.shallow, b.shallow);
}

// Faces are preferred where they are less separated by no more than this: they give up to four points.
double face_preference(const Convex& a, const Convex& b, double extent) {
    if (!a.is_sharp || !b.is_sharp) return snap_tolerance * extent;
    const bool is_round = a.kind == Convex::Kind::cylinder || b.kind == Convex::Kind::cylinder;
    return (is_round ? round_part : 1) * inset_part_of(a, b);
}

// The face along whose normal the shapes are farthest apart, if that is about as good as the axis; which may be such a
// face itself.
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

// Inset cores round off edges: where those meet a round side, the axis is that of the shapes themselves. True if it is
// another then.
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

// Contact along an axis found from the cores, or along the normal of a face where that is about as good: true then.
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

// Whether the face that was the contact in the last step still is: its points come as near as any can along its
// normal, so that no other direction separates the shapes more. True as well when they are apart along it; there are no
// points then, and the normal is that. The other faces need not be looked at. `axis`: of that face, if it is one.
//
// Where the shapes overlap by d, a direction at an angle f to the normal makes that d cos(f) + b sin(f) at least, if
// the points are b away from the border of the face: not less than d as long as b > d tan(f / 2).
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

// What the normal of the last step tells without the cores. True when the shapes are apart along it, or when a face
// near it is the contact: its points come as near as any points can along the face's normal, so that no other
// direction is better, nor any other face. Only while the overlap is shallow: deeper, edges might be better. `axis`: of
// the face of the last step, or of none.
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

// Cylinders, and capsules with equal ends.
bool has_straight_side(const Convex& c) {
    const bool is_cylinder = c.kind == Convex::Kind::cylinder && c.is_sharp;
    return (is_cylinder || c.kind == Convex::Kind::capsule) && c.size.x == c.size.z && c.size.y > 0;
}

// Whether two such shapes whose axes cross at an angle are nearest to each other between their ends: along the normal
// of both axes then, or they are apart along it. Where they overlap, the ends are out of the question if they are
// farther than that away (contact_by_last_face).
bool contact_by_sides(const Convex& a, const Convex& b, double margin, Manifold& out) {
    if (!has_straight_side(a) || !has_straight_side(b)) return false;
    const DVec3 u = a.axes.c1, v = b.axes.c1, r = b.center - a.center, across = math::cross(u, v);
    const double square = dot(across, across);
    if (!(square > min_crossing * min_crossing)) return false;
    const double uv = dot(u, v), ur = dot(u, r), vr = dot(v, r);
    const double s = (ur - uv * vr) / square, t = (uv * ur - vr) / square; // from the centers, in meters
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
    const DVec3 origin = a.center - height * up; // of the plane
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

// Where the polygon holds a point, seen along its normal: on the face, or at the nearest edge or corner.
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

// A push counts as downward where its direction has this against the normal, as in kernels/collide_box_rectangle.cpp.
constexpr double downward = 1e-3;

constexpr double squared_rounding = 1e-10; // of a unit vector in float that is computed twice

// Where the contact is; one that would push down is none.
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

// The points over the polygon, `separation` along its normal or more.
bool front_manifold(const Convex& a, const Convex& polygon, double separation, double margin, Manifold& out) {
    const FaceAxis face{-polygon.axes.c1, separation, 0, true, unknown_vertex, polygon.corners[0]};
    FacePoints found;
    return face_manifold(a, polygon, face, separation, a.extent, a.extent, margin, found, out);
}

// Pushed out along the normal, by the lower side; by the middle where that reaches beyond the polygon.
void lift(const Convex& a, const Convex& polygon, double margin, Manifold& out) {
    const DVec3 up = polygon.axes.c1;
    const double separation = separation_along(a, polygon, -up);
    if (separation > margin || front_manifold(a, polygon, separation, margin, out)) return;
    const DVec3 m = middle(a);
    const double height = dot(m - polygon.corners[0], up);
    const DVec3 position = m + (0.5 * separation - height) * up;
    point_manifold(position, -up, separation, 0xffff, a.extent, margin, out);
}

// A contact with the front of a polygon, that the guess does not tell.
SurfaceContact contact_from_cores(const Convex& a, const Convex& polygon, double margin, DVec3 guess, FacePoints& found,
                                  Manifold& out) {
    const DVec3 up = polygon.axes.c1;
    Axis axis;
    ContactMemory met;
    if (!find_axis(a, polygon, margin, guess, axis, met)) return {};
    if (dot(axis.normal, up) > downward) {
        // It would be pushed down: it has left the polygon, or is so much above it that it is pushed up.
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
        // What does not reach the front is not held: it may stand on the far side of a thin wall.
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
