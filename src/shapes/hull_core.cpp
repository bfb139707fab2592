// Mass of a polyhedron, and its core: the polyhedron inside it whose faces are all moved inward.
#include "core/order.h"
#include "shapes/hull_builder.h"
#include "shapes/hull_exact.h"

#include <algorithm>
#include <cmath>

namespace cairn::hull {

using math::DVec3;

// Integrates 1, x and x x^T over the tetrahedra from an inner point o to the triangles of the faces. With corners o +
// a, o + b, o + c, D = a . (b x c) and s = a + b + c, the integrals about o are D / 6, s D / 24 and (s s^T + a a^T + b
// b^T + c c^T) D / 120 (by the divergence theorem, as in Mirtich: Fast and Accurate Computation of Polyhedral Mass
// Properties, JGT 1, 1996; in the form of Eberly: Polyhedral Mass Properties, 2002). About an inner point no terms
// cancel, wherever the origin of the frame is.
void measure_mass(HullData& hull) {
    DVec3 origin;
    for (const math::Vec3 v : hull.vertices) origin += math::to_double(v);
    origin = (1.0 / double(hull.vertices.size())) * origin;
    double volume = 0;
    DVec3 first;
    math::DSym3 second;
    auto product = [](double f, DVec3 v) {
        return math::DSym3{f * v.x * v.x, f * v.x * v.y, f * v.x * v.z, f * v.y * v.y, f * v.y * v.z, f * v.z * v.z};
    };
    for (const HullFace& face : hull.faces) {
        auto corner = [&](std::uint32_t i) {
            return math::to_double(hull.vertices[hull.loops[face.first + i]]) - origin;
        };
        const DVec3 a = corner(0);
        for (std::uint32_t i = 1; i + 1 < face.count; ++i) {
            const DVec3 b = corner(i), c = corner(i + 1), s = a + b + c;
            const double d = math::dot(a, math::cross(b, c));
            volume += d / 6;
            first += (d / 24) * s;
            const double f = d / 120;
            second = second + (product(f, s) + product(f, a)) + (product(f, b) + product(f, c));
        }
    }
    const DVec3 center = (1 / volume) * first;
    const math::DSym3 m = second + product(-volume, center); // about the center of mass
    hull.unit_mass.mass = volume;
    hull.unit_mass.center = origin + center;
    hull.unit_mass.inertia = {m.yy + m.zz, -m.xy, -m.xz, m.xx + m.zz, -m.yz, m.xx + m.yy};
}

namespace {

// An affine map to a body that is about as thick as it is long, based on second moments: coordinates along the
// principal axes, divided by the square roots of the moments. There, an inner point is far from all planes.
struct Rounding {
    DVec3 center, axes[3]; // axes divided by sizes
    DVec3 sizes;
};

Rounding make_rounding(const HullData& hull) {
    const PrincipalInertia principal = diagonalize(hull.unit_mass.inertia);
    const math::DMat3 rotation = math::to_matrix(principal.axes);
    const DVec3 m = principal.moments;
    const double half = 0.5 * (m.x + m.y + m.z);
    Rounding r;
    r.center = hull.unit_mass.center;
    for (int i = 0; i < 3; ++i) {
        const double square = (half - m[i]) / hull.unit_mass.mass, least = 0.05 * hull.width;
        r.sizes[i] = square > least * least ? std::sqrt(square) : least;
        r.axes[i] = rotation.column(i);
    }
    return r;
}

// Merges corners that coincide nearly, as where many planes almost meet in one point: neighbors within `distance` of a
// kept corner are dropped. This only makes the core smaller.
std::vector<math::Vec3> weld(std::span<const DVec3> points, std::span<const Triangle> triangles, double distance) {
    std::vector<math::Vec3> r;
    r.reserve(points.size());
    std::vector<bool> is_done(points.size(), false);
    std::vector<std::uint32_t> near;
    for (std::uint32_t seed = 0; seed < points.size(); ++seed) {
        if (is_done[seed]) continue;
        r.push_back(math::to_float(points[seed]));
        is_done[seed] = true;
        near.assign(1, seed);
        for (std::size_t i = 0; i < near.size(); ++i)
            for (const std::uint32_t other : triangles[near[i]].neighbors) {
                if (is_done[other] || math::length(points[other] - points[seed]) > distance) continue;
                is_done[other] = true;
                near.push_back(other);
            }
    }
    std::vector<std::uint64_t> keys;
    keys.reserve(r.size());
    for (const math::Vec3 v : r) keys.push_back(std::uint64_t(order_key(v.x)) << 32 | order_key(v.y));
    std::vector<math::Vec3> sorted;
    sorted.reserve(r.size());
    for (const std::uint32_t i : order_by(keys)) sorted.push_back(r[i]);
    for (auto first = sorted.begin(), last = first; first != sorted.end(); first = last) {
        while (last != sorted.end() && last->x == first->x && last->y == first->y) ++last;
        if (last - first > 1) std::stable_sort(first, last, [](math::Vec3 a, math::Vec3 b) { return a.z < b.z; });
    }
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    return sorted;
}

} // namespace

// The points y with n_i . y <= h_i for all i, h_i > 0, are dual to the convex hull of the points n_i / h_i: each face
// of that hull, N . u = N . u_0, gives the corner N / (N . u_0) (duality; de Berg et al.: Computational Geometry,
// section 11.4). Since the hull is exact for the dual points on their grid, each corner satisfies all constraints up to
// the rounding of the grid, however many planes meet there and however small their angles.
void inset_core(HullData& hull) {
    const Rounding rounding = make_rounding(hull);
    double depth = -1;
    for (const HullFace& face : hull.faces) {
        const double d = double(face.offset) - math::dot(math::to_double(face.normal), rounding.center);
        if (depth < 0 || d < depth) depth = d;
    }
    const double inset = float(std::min(0.04 * double(hull.width), 0.1 * depth));
    hull.inset = float(inset);
    std::vector<DVec3> dual;
    dual.reserve(hull.faces.size());
    DVec3 lo, hi; // the origin is inside
    for (const HullFace& face : hull.faces) {
        const DVec3 n = math::to_double(face.normal);
        const double h = double(face.offset) - inset - math::dot(n, rounding.center);
        DVec3 u;
        for (int i = 0; i < 3; ++i) u[i] = rounding.sizes[i] * math::dot(n, rounding.axes[i]) / h;
        dual.push_back(u);
        lo = math::min(lo, u), hi = math::max(hi, u);
    }
    const DVec3 size = hi - lo;
    const double scale = double((std::int64_t(1) << grid_bits) - 1) / std::max({size.x, size.y, size.z});
    auto rounded = [&](double x) { return std::int32_t(std::floor(x * scale + 0.5)); };
    std::vector<GridPoint> grid;
    grid.reserve(dual.size());
    for (const DVec3 u : dual) grid.push_back({rounded(u.x - lo.x), rounded(u.y - lo.y), rounded(u.z - lo.z)});
    const Triangulation triangulation = triangulate(grid, first_simplex(grid), 0);
    std::vector<DVec3> corners;
    corners.reserve(triangulation.triangles.size());
    for (const Triangle& t : triangulation.triangles) {
        const GridPoint a = grid[triangulation.points[t.corners[0]]];
        const DVec3 normal = math::normalized(to_double(
            area_vector(a, grid[triangulation.points[t.corners[1]]], grid[triangulation.points[t.corners[2]]])));
        const double offset = math::dot(normal, (1 / scale) * to_double(a) + lo);
        DVec3 corner = rounding.center;
        for (int i = 0; i < 3; ++i) corner += (rounding.sizes[i] * normal[i] / offset) * rounding.axes[i];
        corners.push_back(corner);
    }
    hull.core = Columns(weld(corners, triangulation.triangles, 1e-3 * inset));
}

} // namespace cairn::hull
