#include "shapes/epa.h"

#include <limits>

namespace cairn {

using math::cross;
using math::dot;
using math::DVec3;

namespace {

constexpr int max_points = 64, max_faces = 2 * max_points;
constexpr double depth_tolerance = 1e-4;
// Relative to the size of the Minkowski difference: a thinner difference counts as flat; a point lower than this above
// a plane counts as coplanar.
constexpr double flat = 1e-9, coplanar = 1e-13;

struct Polytope {
    Polytope() {}
    struct Face {
        int corner[3]; // counterclockwise as seen from outside
        DVec3 normal;
        double distance; // of the plane from the origin; negative if the origin is outside
    };
    struct Edge {
        std::int16_t from, to;
        bool operator==(const Edge&) const = default;
    };
    int point_count = 0, face_count = 0;
    double size = 0;
    union { // uninitialized until used: clearing it takes as long as a search
        DifferencePoint points[max_points];
    };
    union {
        Face faces[max_faces];
    };

    bool add_face(int a, int b, int c) {
        if (face_count == max_faces) return false;
        const DVec3 pa = points[a].w, ab = points[b].w - pa, ac = points[c].w - pa;
        DVec3 normal = cross(ab, ac);
        const double square = dot(normal, normal);
        if (!(square > 1e-28 * dot(ab, ab) * dot(ac, ac))) return false;
        normal = (1 / std::sqrt(square)) * normal;
        faces[face_count++] = {{a, b, c}, normal, dot(normal, pa)};
        return true;
    }
    int nearest() const {
        int best = 0;
        double least = faces[0].distance;
        for (int i = 1; i < face_count; ++i)
            if (faces[i].distance < least) least = faces[i].distance, best = i;
        return best;
    }
    // Expands the hull by one point; returns false if rounding errors prevent a consistent surface.
    bool add_point(const DifferencePoint& p);
    void witness(const Face& face, Penetration& out) const;
};

bool Polytope::add_point(const DifferencePoint& p) {
    if (point_count == max_points) return false;
    // Collects the edges of faces visible from the point; edges that occur in both directions are interior.
    Edge edges[3 * max_faces];
    int edge_count = 0, kept = 0;
    for (int i = 0; i < face_count; ++i) {
        const Face& f = faces[i];
        if (dot(f.normal, p.w) - f.distance <= -coplanar * size) {
            if (kept < i) faces[kept] = f;
            ++kept;
            continue;
        }
        for (int k = 0; k < 3; ++k) {
            const Edge e{std::int16_t(f.corner[k]), std::int16_t(f.corner[k == 2 ? 0 : k + 1])}, back{e.to, e.from};
            int twin = 0;
            while (twin < edge_count && edges[twin] != back) ++twin;
            if (twin < edge_count)
                edges[twin] = edges[--edge_count];
            else
                edges[edge_count++] = e;
        }
    }
    face_count = kept;
    // The remaining edges (the horizon) must form a single loop, or the surface would not be closed.
    if (edge_count < 3) return false;
    int at = edges[0].to, steps = 1;
    while (at != edges[0].from && steps <= edge_count) {
        int next = 0;
        while (next < edge_count && edges[next].from != at) ++next;
        if (next == edge_count) return false;
        at = edges[next].to;
        ++steps;
    }
    if (steps != edge_count) return false;
    points[point_count++] = p;
    for (int i = 0; i < edge_count; ++i)
        if (!add_face(edges[i].from, edges[i].to, point_count - 1)) return false;
    return true;
}

// Computes the witness points on both cores at the origin's projection onto the surface, from the triangle in the plane
// of the face that contains the projection best.
void Polytope::witness(const Face& face, Penetration& out) const {
    double most = -1;
    for (int i = 0; i < face_count; ++i) {
        const Face& f = faces[i];
        if (!(f.distance - face.distance <= 1e-9 * size) || !(dot(f.normal, face.normal) > 1 - 1e-9)) continue;
        const DifferencePoint &a = points[f.corner[0]], &b = points[f.corner[1]], &c = points[f.corner[2]];
        const double wa = dot(cross(b.w, c.w), f.normal), wb = dot(cross(c.w, a.w), f.normal),
                     wc = dot(cross(a.w, b.w), f.normal), sum = wa + wb + wc;
        const double least = std::min(wa, std::min(wb, wc)) / sum;
        if (!(least > most)) continue;
        most = least;
        // If the projection is slightly outside of the triangle, its weights are clamped.
        const double ua = wa > 0 ? wa : 0, ub = wb > 0 ? wb : 0, uc = wc > 0 ? wc : 0, part = 1 / (ua + ub + uc);
        out.on_a = part * (ua * a.a + ub * b.a + uc * c.a);
        out.on_b = part * (ua * a.b + ub * b.b + uc * c.b);
    }
}

DVec3 orthogonal(DVec3 n) {
    const DVec3 axis = std::fabs(n.x) < 0.5 ? DVec3{1, 0, 0} : DVec3{0, 1, 0};
    return math::normalized(cross(axis, n));
}

// A separating direction for a flat Minkowski difference. Any direction perpendicular to it separates the cores with
// depth 0; the one closest to the line from the middle of the first shape to that of the second is chosen.
DVec3 part_flat(const CorePair& pair, int dimension, DVec3 axis) {
    const DVec3 offset = middle(*pair.b.shape) - middle(*pair.a.shape);
    if (dimension == 2) return dot(axis, offset) < 0 ? -axis : axis;
    const DVec3 across = dimension == 1 ? offset - dot(offset, axis) * axis : offset;
    const double length = math::length(across);
    if (length > 1e-9 * math::length(offset) && length > 0) return (1 / length) * across;
    return dimension == 1 ? orthogonal(axis) : DVec3{0, 1, 0};
}

// Finds four points of the Minkowski difference that span a volume, and returns 3. Otherwise returns the number of
// dimensions that it spans, and in `axis` its line or the normal of its plane.
int span_solid(const CorePair& pair, DifferencePoint (&p)[4], double& size, DVec3& axis) {
    constexpr DVec3 sides[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    p[0] = pair.support(sides[0]);
    double farthest = 0;
    size = math::length(p[0].w);
    for (const DVec3& side : sides) {
        const DifferencePoint q = pair.support(side);
        const double away = math::length(q.w - p[0].w);
        size = std::max(size, math::length(q.w));
        if (away > farthest) farthest = away, p[1] = q;
    }
    if (!(farthest > flat * size)) return 0;
    axis = (1 / farthest) * (p[1].w - p[0].w);
    const DVec3 e1 = orthogonal(axis), e2 = cross(axis, e1);
    farthest = 0;
    for (const DVec3& side : {e1, -e1, e2, -e2}) {
        const DifferencePoint q = pair.support(side);
        const DVec3 d = q.w - p[0].w;
        const double away = math::length(d - dot(d, axis) * axis);
        if (away > farthest) farthest = away, p[2] = q;
    }
    if (!(farthest > flat * size)) return 1;
    axis = math::normalized(cross(p[1].w - p[0].w, p[2].w - p[0].w));
    farthest = 0;
    for (const DVec3& side : {axis, -axis}) {
        const DifferencePoint q = pair.support(side);
        const double away = std::fabs(dot(q.w - p[0].w, axis));
        if (away > farthest) farthest = away, p[3] = q;
    }
    return farthest > flat * size ? 3 : 2;
}

} // namespace

Penetration epa_depth(const CorePair& cores, const Simplex& start) {
    CorePair pair = cores;
    pair.a.is_quick = pair.b.is_quick = false; // exact support points, since the search ends when none is farther
    Polytope polytope;
    DifferencePoint p[4];
    DVec3 axis;
    const auto volume = [&] { return dot(cross(p[1].w - p[0].w, p[2].w - p[0].w), p[3].w - p[0].w); };
    bool is_solid = false;
    Penetration best{std::numeric_limits<double>::infinity(), {0, 1, 0}, start.points[0].a, start.points[0].b};
    if (start.count == 4) {
        for (int i = 0; i < 4; ++i) {
            p[i] = start.points[i];
            polytope.size = std::max(polytope.size, math::length(p[i].w));
        }
        const double area = math::length(cross(p[1].w - p[0].w, p[2].w - p[0].w));
        is_solid = std::fabs(volume()) > 1e-6 * area * math::length(p[3].w - p[0].w);
    }
    if (!is_solid) {
        const int dimension = span_solid(pair, p, polytope.size, axis);
        if (dimension < 3) {
            best.normal = part_flat(pair, dimension, axis);
            best.depth = 0;
            return best;
        }
    }
    if (volume() > 0) std::swap(p[1], p[2]);
    for (int i = 0; i < 4; ++i) polytope.points[i] = p[i];
    polytope.point_count = 4;
    bool is_clean = polytope.add_face(0, 1, 2) && polytope.add_face(0, 2, 3) && polytope.add_face(0, 3, 1) &&
                    polytope.add_face(1, 3, 2);

    // Every direction gives an upper bound of the depth; the least is kept.
    while (is_clean) {
        const Polytope::Face nearest = polytope.faces[polytope.nearest()];
        const DifferencePoint next = pair.support(nearest.normal);
        const double depth = dot(next.w, nearest.normal);
        if (depth < best.depth) {
            best.depth = depth;
            best.normal = nearest.normal;
            polytope.witness(nearest, best);
        }
        if (depth - nearest.distance <= depth_tolerance * std::fabs(depth) + coplanar * polytope.size) break;
        is_clean = polytope.add_point(next);
    }
    if (!(best.depth > 0)) best.depth = 0;
    if (best.depth > 1e300) best.depth = dot(pair.support(best.normal).w, best.normal);
    return best;
}

} // namespace cairn
