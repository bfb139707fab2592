// Properties of every Hull, checked without the code that builds it: for the tests and the fuzzer.
#pragma once

#include "shapes/hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace cairn {

class HullChecker {
  public:
    HullChecker(std::span<const math::Vec3> points, const HullData& hull) : points_(points), hull_(hull) {}

    // Returns the first violation, or an empty string.
    std::string run() {
        for (const math::Vec3 p : points_)
            for (int k = 0; k < 3; ++k) largest_ = std::max(largest_, double(std::fabs(p[k])));
        for (int k = 0; k < 3; ++k) extent_ = std::max(extent_, double(hull_.hi[k]) - double(hull_.lo[k]));
        rounding_ = 0x1p-22 * largest_;
        check_vertices();
        if (wrong_.empty()) check_topology();
        if (wrong_.empty()) check_faces();
        if (wrong_.empty()) check_faces_at();
        if (wrong_.empty()) check_outlines();
        if (wrong_.empty()) check_support();
        if (wrong_.empty()) check_numbers();
        if (wrong_.empty()) check_core();
        return wrong_;
    }

  private:
    template <class... T> void wrong(const T&... parts) {
        if (!wrong_.empty()) return;
        std::ostringstream out;
        out.precision(9);
        (out << ... << parts);
        wrong_ = out.str();
    }
    static bool less(math::Vec3 a, math::Vec3 b) { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; }
    math::DVec3 vertex(std::size_t i) const { return math::to_double(hull_.vertices[i]); }
    static double above(const HullFace& face, math::DVec3 p) {
        return math::dot(math::to_double(face.normal), p) - double(face.offset);
    }

    void check_vertices() {
        std::vector<math::Vec3> sorted(points_.begin(), points_.end()), own = hull_.vertices;
        std::sort(sorted.begin(), sorted.end(), less);
        std::sort(own.begin(), own.end(), less);
        for (std::size_t i = 0; i < own.size(); ++i) {
            if (!std::binary_search(sorted.begin(), sorted.end(), own[i], less)) wrong("a vertex is no input point");
            if (i > 0 && own[i] == own[i - 1]) wrong("two vertices at the same place");
        }
        math::Vec3 lo = hull_.vertices.at(0), hi = lo;
        for (const math::Vec3 v : hull_.vertices) lo = math::min(lo, v), hi = math::max(hi, v);
        if (!(lo == hull_.lo && hi == hull_.hi)) wrong("bounds are not those of the vertices");
        for (std::size_t i = 0; i < own.size(); ++i)
            if (math::length(vertex(i)) > double(hull_.bounding_radius)) wrong("vertex ", i, " beyond bounding_radius");
    }

    void check_topology() {
        const std::size_t count = hull_.vertices.size();
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        std::vector<std::set<std::uint32_t>> neighbors(count);
        std::vector<int> faces_at(count, 0);
        for (const HullFace& face : hull_.faces) {
            if (face.count < 3 || face.first + face.count > hull_.loops.size()) return wrong("a face is no loop");
            for (std::uint32_t i = 0; i < face.count; ++i) {
                const std::uint32_t from = hull_.loops[face.first + i];
                const std::uint32_t to = hull_.loops[face.first + (i + 1) % face.count];
                if (from >= count || to >= count || from == to) return wrong("a loop has a bad index");
                if (++edges[{from, to}] > 1) return wrong("edge ", from, " ", to, " twice in the same direction");
                neighbors[from].insert(to);
                ++faces_at[from];
            }
        }
        for (const auto& [edge, times] : edges)
            if (!edges.count({edge.second, edge.first})) return wrong("the surface is open at an edge");
        if (long(count) - long(edges.size() / 2) + long(hull_.faces.size()) != 2) return wrong("V - E + F is not 2");
        if (hull_.neighbor_start.size() != count + 1) return wrong("neighbor_start has a wrong size");
        for (std::size_t v = 0; v < count; ++v) {
            if (faces_at[v] < 3) return wrong("vertex ", v, " has ", faces_at[v], " faces");
            const std::vector<std::uint32_t> own(hull_.neighbors.begin() + hull_.neighbor_start[v],
                                                 hull_.neighbors.begin() + hull_.neighbor_start[v + 1]);
            if (own != std::vector<std::uint32_t>(neighbors[v].begin(), neighbors[v].end()))
                return wrong("neighbors of vertex ", v, " are wrong");
        }
        std::vector<std::uint32_t> reached{0};
        std::vector<bool> seen(count, false);
        seen[0] = true;
        for (std::size_t i = 0; i < reached.size(); ++i)
            for (const std::uint32_t v : neighbors[reached[i]])
                if (!seen[v]) seen[v] = true, reached.push_back(v);
        if (reached.size() != count) wrong("the surface is in several parts");
    }

    void check_faces() {
        const double tolerance = double(hull_.tolerance) * (1 + 1e-6) + 1e-7 * extent_;
        for (std::size_t f = 0; f < hull_.faces.size(); ++f) {
            const HullFace& face = hull_.faces[f];
            const math::DVec3 normal = math::to_double(face.normal);
            if (std::fabs(math::length(normal) - 1) > 1e-6) return wrong("normal of face ", f, " is not unit");
            for (const math::Vec3 p : points_)
                if (above(face, math::to_double(p)) > tolerance)
                    return wrong("a point is ", above(face, math::to_double(p)), " above face ", f, ", allowed ",
                                 tolerance);
            for (std::uint32_t i = 0; i < face.count; ++i) {
                const auto corner = [&](std::uint32_t k) { return vertex(hull_.loops[face.first + k % face.count]); };
                if (std::fabs(above(face, corner(i))) > tolerance)
                    return wrong("a corner of face ", f, " is off its plane by ", above(face, corner(i)));
                // Convexity: all vertices are to the left of each edge in the plane of the face, within the tolerance
                // of the builder's grid, which rotates short edges.
                const math::DVec3 edge = corner(i + 1) - corner(i);
                const math::DVec3 out = math::normalized(math::cross(edge, normal));
                const double turn = 0x1p-28 * extent_ / math::length(edge);
                for (std::uint32_t k = 2; k < face.count; ++k)
                    if (const double d = math::dot(out, corner(i + k) - corner(i));
                        d > 1e-7 * extent_ + turn * math::length(corner(i + k) - corner(i)))
                        return wrong("face ", f, " is not convex: corner ", k, " of ", face.count, " after ", i, " by ",
                                     d);
            }
        }
    }

    // The faces at a vertex are exactly those that have it in their loops.
    void check_faces_at() {
        std::vector<std::set<std::uint32_t>> faces(hull_.vertices.size());
        for (std::uint32_t f = 0; f < hull_.faces.size(); ++f)
            for (std::uint32_t i = 0; i < hull_.faces[f].count; ++i)
                faces[hull_.loops[hull_.faces[f].first + i]].insert(f);
        if (hull_.faces_at.size() != hull_.neighbors.size()) return wrong("faces_at has a wrong size");
        for (std::size_t v = 0; v < faces.size(); ++v)
            if (std::set<std::uint32_t>(hull_.faces_at.begin() + hull_.neighbor_start[v],
                                        hull_.faces_at.begin() + hull_.neighbor_start[v + 1]) != faces[v])
                return wrong("faces at vertex ", v, " are wrong");
    }

    // In the plane of a face, each vertex of the face is at its position, on its two sides and inside all others,
    // within its distance from the plane and within the rotation of short sides by the builder's grid.
    void check_outlines() {
        const double near = 1e-9 * extent_ + rounding_;
        for (std::size_t f = 0; f < hull_.faces.size(); ++f) {
            const HullFace& face = hull_.faces[f];
            SideBlock made[made_blocks];
            const HullOutline outline = outline_of(hull_, f, made);
            const math::DVec3 e1 = outline.e1, e2 = math::cross(hull_.unit_normal(f), e1);
            double size = 0;
            for (std::uint32_t i = 0; i < face.count; ++i) {
                const SideBlock& own = outline.sides[i / SideBlock::width];
                const double x = own.x[i % SideBlock::width], y = own.y[i % SideBlock::width];
                const math::DVec3 d = vertex(hull_.loops[face.first + i]) - vertex(hull_.loops[face.first]);
                if (std::fabs(math::dot(d, e1) - x) > near || std::fabs(math::dot(d, e2) - y) > near)
                    return wrong("corner ", i, " of the outline of face ", f, " is not where its vertex is");
                size = std::max({size, std::fabs(x), std::fabs(y)});
                const unsigned count = (face.count + SideBlock::width - 1) / SideBlock::width;
                for (unsigned k = 0; k < count * SideBlock::width; ++k) {
                    double inside[SideBlock::width];
                    outline.sides[k / SideBlock::width].inside(x, y, 0, inside);
                    const double distance = inside[k % SideBlock::width];
                    const bool on_side = k == i || (k + 1) % face.count == i;
                    if (k < face.count && on_side ? std::fabs(distance) > near : distance < -allowed_turn(face, k))
                        return wrong("corner ", i, " of face ", f, " is ", distance, " inside of side ", k);
                }
            }
            if (std::fabs(size - outline.size) > near) return wrong("size of the outline of face ", f);
        }
    }
    double allowed_turn(const HullFace& face, std::uint32_t side) const {
        if (side >= face.count) return 0;
        const math::DVec3 edge =
            vertex(hull_.loops[face.first + (side + 1) % face.count]) - vertex(hull_.loops[face.first + side]);
        return 1e-7 * extent_ + double(hull_.tolerance) + 0x1p-28 * extent_ / math::length(edge) * extent_ * 2;
    }

    // In no direction does a point extend noticeably farther than the vertices.
    void check_support() {
        std::vector<math::DVec3> directions;
        for (int x = -3; x <= 3; ++x)
            for (int y = -3; y <= 3; ++y)
                for (int z = -3; z <= 3; ++z)
                    if (x != 0 || y != 0 || z != 0)
                        directions.push_back(math::normalized(math::DVec3{x + 0.1, y - 0.2, z + 0.3}));
        // Directions outward from a vertex, for sharp tips.
        for (std::size_t v = 0; v < hull_.vertices.size() && v < 100; ++v) {
            math::DVec3 d;
            for (std::uint32_t i = hull_.neighbor_start[v]; i < hull_.neighbor_start[v + 1]; ++i)
                d += math::normalized(vertex(v) - vertex(hull_.neighbors[i]));
            if (math::length(d) > 1e-9) directions.push_back(math::normalized(d));
        }
        for (const math::DVec3 d : directions) {
            double all = -1e30, own = -1e30;
            for (const math::Vec3 p : points_) all = std::max(all, math::dot(d, math::to_double(p)));
            for (const math::Vec3 p : hull_.vertices) own = std::max(own, math::dot(d, math::to_double(p)));
            if (all - own > 2 * double(hull_.tolerance))
                return wrong("the points reach ", all - own, " farther than the vertices, tolerance ", hull_.tolerance,
                             " in direction ", d.x, " ", d.y, " ", d.z);
        }
    }

    void check_numbers() {
        double width = 1e30;
        for (const HullFace& face : hull_.faces) {
            double least = 0;
            for (std::size_t v = 0; v < hull_.vertices.size(); ++v) least = std::min(least, above(face, vertex(v)));
            width = std::min(width, -least);
        }
        if (std::fabs(width - double(hull_.width)) > 1e-6 * width + rounding_)
            wrong("width is ", hull_.width, ", by brute force ", width);
        const MassSum& m = hull_.unit_mass;
        double corner_mass = 0; // by another method: tetrahedra from the first vertex
        for (const HullFace& face : hull_.faces)
            for (std::uint32_t i = 1; i + 1 < face.count; ++i) {
                const auto at = [&](std::uint32_t k) { return vertex(hull_.loops[face.first + k]) - vertex(0); };
                corner_mass += math::dot(at(0), math::cross(at(i), at(i + 1))) / 6;
            }
        if (!(m.mass > 0) || std::fabs(m.mass - corner_mass) > 1e-9 * m.mass + 1e-14 * extent_ * extent_ * extent_)
            wrong("volume is ", m.mass, ", by cones ", corner_mass);
        if (!math::is_finite(m.center)) wrong("center is not finite");
        for (const HullFace& face : hull_.faces)
            if (!(above(face, m.center) < rounding_)) wrong("the center of mass is outside");
        const PrincipalInertia p = diagonalize(m.inertia);
        for (int k = 0; k < 3; ++k)
            if (!(p.moments[k] > 0) || p.moments[k] > (p.moments[(k + 1) % 3] + p.moments[(k + 2) % 3]) * (1 + 1e-9))
                wrong("these moments of inertia are those of no body");
    }

    void check_core() {
        const double inset = hull_.inset, slack = 1e-3 * inset + rounding_;
        if (!(inset > 0 && inset <= 0.0401 * double(hull_.width))) wrong("inset ", inset);
        if (hull_.core.size() < 4 && rounding_ < 0.1 * inset) wrong("the core has ", hull_.core.size(), " corners");
        for (std::size_t i = 0; i < hull_.core.size(); ++i) {
            const math::Vec3 c = hull_.core[i];
            int tight = 0;
            for (const HullFace& face : hull_.faces) {
                const double below = -above(face, math::to_double(c));
                if (!(below >= inset - slack)) return wrong("a core corner is ", below, " below a face, inset ", inset);
                tight += below <= inset + slack;
            }
            if (tight < 3) return wrong("a core corner is on ", tight, " planes");
        }
    }

    std::span<const math::Vec3> points_;
    const HullData& hull_;
    double largest_ = 0, extent_ = 0, rounding_ = 0;
    std::string wrong_;
};

inline std::string check_hull(std::span<const math::Vec3> points, const HullData& hull) {
    return HullChecker(points, hull).run();
}

} // namespace cairn
