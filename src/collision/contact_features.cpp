#include "collision/contact_features.h"

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

// Cosine: an edge counts as perpendicular to a direction up to this.
constexpr double across_tolerance = 1e-2;

void hull_face(const Convex& c, int face, Feature& out) {
    const HullFace& f = c.hull->faces[static_cast<std::size_t>(face)];
    for (std::uint32_t i = 0; i < f.count; ++i)
        out.points.add(hull_point(c, c.hull->vertices[c.hull->loops[f.first + i]]));
}

void box_face(const Convex& c, int face, Feature& out) {
    const int i = face / 2;
    DVec3 s = c.size[(i + 1) % 3] * c.axes.column((i + 1) % 3), t = c.size[(i + 2) % 3] * c.axes.column((i + 2) % 3);
    if (face % 2 != 0) std::swap(s, t);
    const DVec3 middle = c.center + c.size[i] * out.normal;
    for (const DVec3& p : {middle + s + t, middle - s + t, middle - s - t, middle + s - t}) out.points.add(p);
}

// The generator line of a cylinder's side in the direction n, projected perpendicularly to the axis.
void side_line(const Convex& c, DVec3 n, Feature& out) {
    const DVec3 local = to_local(c, n);
    const double across = std::sqrt(local.x * local.x + local.z * local.z);
    const DVec3 radial = across > 0 ? DVec3{local.x / across, 0, local.z / across} : DVec3{1, 0, 0};
    out.kind = Feature::Kind::segment;
    out.points.add(c.center + c.axes * (c.size.x * radial + DVec3{0, -c.size.y, 0}));
    out.points.add(c.center + c.axes * (c.size.z * radial + DVec3{0, c.size.y, 0}));
}

void capsule_line(const Convex& c, DVec3 n, Feature& out) {
    const DVec3 half = c.size.y * c.axes.c1;
    out.kind = Feature::Kind::segment;
    out.points.add(c.center - half + c.size.x * n);
    out.points.add(c.center + half + c.size.z * n);
}

// The face whose normal is most along n, among those at the vertex that is farthest along n.
int face_of_hull(const Convex& c, const DVec3& n, int vertex) {
    const HullData& hull = *c.hull;
    const DVec3 d = to_local(c, n);
    const std::size_t v =
        vertex != unknown_vertex ? static_cast<std::size_t>(vertex) : hull.vertex_columns.nearly_farthest(d);
    int best = 0;
    double most = -2;
    for (std::uint32_t i = hull.neighbor_start[v]; i < hull.neighbor_start[v + 1]; ++i) {
        const std::uint32_t face = hull.faces_at[i];
        const double along = dot(hull.unit_normal(face), d);
        best = along > most ? static_cast<int>(face) : best;
        most = along > most ? along : most;
    }
    return best;
}
int supporting_face(const Convex& c, const DVec3& n, int vertex) {
    if (c.kind == Convex::Kind::box) return box_face_along(to_local(c, n));
    if (c.kind == Convex::Kind::polygon) return dot(c.axes.c1, n) < 0 ? 1 : 0;
    return face_of_hull(c, n, vertex);
}

// The farthest point of the core along n, with the edge from there that is most nearly perpendicular to n.
void polytope_edge(const Convex& c, DVec3 n, Feature& out) {
    DVec3 from;
    if (c.kind == Convex::Kind::hull) {
        const std::size_t vertex = c.hull->vertex_columns.nearly_farthest(to_local(c, n));
        from = hull_point(c, c.hull->vertices[vertex]);
        out.index = static_cast<std::uint32_t>(vertex);
    } else
        from = core_support(exact_core(c), n);
    out.points.add(from);
    double least = across_tolerance;
    DVec3 to;
    const auto offer = [&](DVec3 p) {
        const DVec3 d = p - from;
        const double along = std::fabs(dot(d, n)) / math::length(d);
        if (along < least) least = along, to = p;
    };
    if (c.kind == Convex::Kind::box) {
        const DVec3 local = to_local(c, from - c.center);
        for (int i = 0; i < 3; ++i) offer(from - 2 * local[i] * c.axes.column(i));
    } else if (c.kind == Convex::Kind::polygon) {
        for (int i = 0; i < c.corner_count; ++i) {
            const DVec3 p = c.corners[i], q = c.corners[(i + 1) % c.corner_count];
            if (p == from) offer(q);
            if (q == from) offer(p);
        }
    } else {
        const HullData& hull = *c.hull;
        for (std::uint32_t i = hull.neighbor_start[out.index]; i < hull.neighbor_start[out.index + 1]; ++i)
            offer(hull_point(c, hull.vertices[hull.neighbors[i]]));
    }
    if (least < across_tolerance) {
        out.kind = Feature::Kind::segment;
        out.points.add(to);
    }
}

void reset(Feature& f) {
    f.kind = Feature::Kind::point;
    f.index = 0;
    f.points.clear();
}

void shift(Feature& f, DVec3 by) {
    for (DVec3& p : f.points) p += by;
    f.center += by;
}

// Moves a feature from the core of a rounded shape to its surface, where that has the normal n: the feature is then as
// far along n as its points are.
void move_out(const Convex& c, DVec3 n, Feature& f) {
    const bool has_core = c.kind != Convex::Kind::ball && c.kind != Convex::Kind::capsule;
    if (has_core && !c.is_sharp) shift(f, c.radius * n);
}

// The face of the core.
void core_face(const Convex& c, int face, Feature& out) {
    reset(out);
    out.kind = Feature::Kind::polygon;
    out.index = static_cast<std::uint32_t>(face);
    out.normal = face_normal(c, face);
    switch (c.kind) {
    case Convex::Kind::box:
        return box_face(c, face, out);
    case Convex::Kind::hull:
        return hull_face(c, face, out);
    case Convex::Kind::polygon:
        for (int i = 0; i < c.corner_count; ++i) out.points.add(c.corners[face == 0 ? i : c.corner_count - 1 - i]);
        return;
    default:
        out.kind = Feature::Kind::disc;
        out.center = c.center + c.size.y * out.normal;
        out.radius = face == 0 ? c.size.z : c.size.x;
        out.u = c.axes.c0;
        out.v = math::cross(out.normal, out.u);
    }
}

void core_incident(const Convex& c, const DVec3& n, int vertex, Feature& out) {
    reset(out);
    switch (c.kind) {
    case Convex::Kind::ball:
        out.points.add(c.center + c.radius * n);
        return;
    case Convex::Kind::capsule:
        return capsule_line(c, n, out);
    case Convex::Kind::cylinder: {
        // The flat end, if its normal is more along n than that of the side.
        const DVec3 local = to_local(c, n);
        const double dr = c.size.x - c.size.z, side = std::sqrt(4 * c.size.y * c.size.y + dr * dr);
        const double across = std::sqrt(local.x * local.x + local.z * local.z);
        const double along_side = (2 * c.size.y * across + dr * local.y) / side;
        const int end = local.y > 0 ? 0 : 1;
        if (std::fabs(local.y) > along_side && (end == 0 ? c.size.z : c.size.x) > 0) return core_face(c, end, out);
        return side_line(c, n, out);
    }
    default:
        return core_face(c, supporting_face(c, n, vertex), out);
    }
}

} // namespace

void face_feature(const Convex& c, int face, Feature& out) {
    core_face(c, face, out);
    move_out(c, out.normal, out);
}

void incident_feature(const Convex& c, const DVec3& n, int vertex, Feature& out) {
    core_incident(c, n, vertex, out);
    move_out(c, n, out);
}

void edge_feature(const Convex& c, DVec3 n, Feature& out) {
    reset(out);
    if (c.kind == Convex::Kind::capsule || c.kind == Convex::Kind::cylinder) {
        c.kind == Convex::Kind::capsule ? capsule_line(c, n, out) : side_line(c, n, out);
        const DVec3 d = out.points[1] - out.points[0];
        if (std::fabs(dot(d, n)) < across_tolerance * math::length(d)) return move_out(c, n, out);
        reset(out);
        out.points.add(support(c, n));
    } else if (c.kind == Convex::Kind::ball)
        out.points.add(c.center + c.radius * n);
    else {
        polytope_edge(c, n, out);
        move_out(c, n, out);
    }
}

} // namespace cairn
