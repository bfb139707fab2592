#include "collision/contact_memory.h"

#include "collision/contact_axis.h"

namespace cairn {

using math::cross;
using math::dot;
using math::DVec3;

namespace {

// Kinds of memory, stored in the bits above four corner numbers.
constexpr std::uint32_t of_first = 1, of_second = 2, of_edges = 3;
constexpr int corner_bits = 7, kind_shift = 4 * corner_bits;
constexpr std::uint32_t max_corners = 1u << corner_bits;

// As a share of the extent: no other vertex may be farther along the axis than an edge by more than this.
constexpr double farther = 1e-6;

const Columns& corners_of(const Core& core) {
    return core.is_inset ? core.shape->hull->core : core.shape->hull->vertex_columns;
}

DVec3 nearly_farthest(const Core& core, DVec3 unit) {
    const Columns& corners = corners_of(core);
    return hull_point(*core.shape, corners[corners.nearly_farthest(to_local(*core.shape, unit))]);
}

// The index of the core's vertex at p; max_corners if there is none.
std::uint32_t corner_at(const Core& core, DVec3 p) {
    const Columns& corners = corners_of(core);
    for (std::uint32_t i = 0; i < corners.size() && i < max_corners; ++i)
        if (hull_point(*core.shape, corners[i]) == p) return i;
    return max_corners;
}

struct Edge {
    DVec3 from, to;
    int count = 0; // ends found so far
    void offer(DVec3 p) {
        if (count == 0)
            from = p, count = 1;
        else if (!(p == from) && count == 1)
            to = p, count = 2;
        else if (!(p == from) && !(p == to))
            count = 3;
    }
};

// Decodes the edge between two vertex numbers.
bool edge_of(const Core& core, std::uint32_t numbers, Edge& edge) {
    const std::uint32_t i = numbers % max_corners, k = numbers / max_corners % max_corners;
    const Columns& corners = corners_of(core);
    if (i == k || i >= corners.size() || k >= corners.size()) return false;
    edge.from = hull_point(*core.shape, corners[i]);
    edge.to = hull_point(*core.shape, corners[k]);
    return true;
}

bool are_hulls(const CorePair& cores) {
    return cores.a.shape->kind == Convex::Kind::hull && cores.b.shape->kind == Convex::Kind::hull;
}

} // namespace

ContactMemory memory_of_face(int face, bool is_second) {
    if (face < 0 || face >= 1 << kind_shift) return nothing_met;
    return (is_second ? of_second : of_first) << kind_shift | static_cast<std::uint32_t>(face);
}

bool face_of_memory(ContactMemory memory, const Convex& a, const Convex& b, Axis& axis) {
    const std::uint32_t kind = memory >> kind_shift;
    if (kind != of_first && kind != of_second) return false;
    const int face = static_cast<int>(memory & ((1u << kind_shift) - 1));
    if (!has_face(kind == of_second ? b : a, face)) return false;
    axis.face = face, axis.is_second = kind == of_second;
    return true;
}

ContactMemory memory_of_edges(const CorePair& cores, const GjkResult& found) {
    if (found.state != GjkResult::State::apart || found.simplex.count != 3 || !are_hulls(cores)) return nothing_met;
    Edge first, second;
    for (int i = 0; i < 3; ++i) first.offer(found.simplex.points[i].a), second.offer(found.simplex.points[i].b);
    if (first.count != 2 || second.count != 2) return nothing_met;
    std::uint32_t memory = of_edges;
    for (const std::uint32_t corner : {corner_at(cores.b, second.to), corner_at(cores.b, second.from),
                                       corner_at(cores.a, first.to), corner_at(cores.a, first.from)}) {
        if (corner >= max_corners) return nothing_met;
        memory = memory << corner_bits | corner;
    }
    return memory;
}

// Two convex shapes are nearest to each other at two given points if the planes through these points, perpendicular to
// the line between them, have the shapes on either side.
bool axis_of_edges(ContactMemory memory, const CorePair& cores, Axis& axis) {
    if (memory >> kind_shift != of_edges || !are_hulls(cores)) return false;
    Edge a, b;
    if (!edge_of(cores.a, memory, a) || !edge_of(cores.b, memory >> (2 * corner_bits), b)) return false;
    const DVec3 u = a.to - a.from, v = b.to - b.from, between = b.from - a.from, across = cross(u, v);
    const double square = dot(across, across);
    if (!(square > min_crossing * min_crossing * dot(u, u) * dot(v, v))) return false;
    const double s = dot(cross(between, v), across) / square, t = dot(cross(between, u), across) / square;
    if (!(s > 0 && s < 1 && t > 0 && t < 1)) return false;
    const double along = dot(across, between), length = std::sqrt(square);
    if (!(along * along > 0)) return false;
    const DVec3 n = ((along > 0 ? 1 : -1) / length) * across;
    const double slack = farther * std::min(cores.a.shape->extent, cores.b.shape->extent);
    if (dot(n, nearly_farthest(cores.a, n) - a.from) > slack) return false;
    if (dot(n, b.from - nearly_farthest(cores.b, -n)) > slack) return false;
    axis.normal = n;
    axis.touch = 0.5 * ((a.from + s * u + cores.a.radius * n) + (b.from + t * v - cores.b.radius * n));
    return true;
}

} // namespace cairn
