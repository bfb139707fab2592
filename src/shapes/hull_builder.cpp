// Builds a Hull from points: validation, grid, triangulation, faces, and derived data.
#include "shapes/hull_builder.h"

#include "core/order.h"
#include "shapes/hull_exact.h"
#include "shapes/hull_faces.h"
#include "shapes/refuse.h"

#include <cairn/error.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace cairn {

using math::DVec3;
using math::Vec3;

namespace hull {

namespace {

constexpr float largest_coordinate = 1e6f; // greatest absolute coordinate of a point, m
constexpr double min_extent = 1e-6;        // least extent of the points, m, as for other shapes
constexpr double min_thickness = 1e-5;     // least thickness, relative to the extent
// Least thickness relative to the largest coordinate: the offset of a plane is a float, whose error is up to a tenth of
// this.
constexpr double finest_plane = 1e-6;
// number of points beyond which they and the data derived from them exceed the nearest caches
constexpr std::size_t many_points = 1024;
constexpr std::size_t max_points = std::size_t(1) << 30;

[[noreturn]] void refuse(const std::string& value, const std::string& expected) {
    throw Error(ErrorCode::invalid_value, "Hull points", value, expected);
}

struct Bounds {
    DVec3 lo, hi;
    double extent = 0;  // the longest side
    double largest = 0; // the largest absolute coordinate
};

Bounds check(std::span<const Vec3> points) {
    if (points.size() < 4) refuse(std::to_string(points.size()), "must be 4 at least");
    if (points.size() > max_points) refuse(std::to_string(points.size()), "must be 2^30 at most");
    for (std::size_t i = 0; i < points.size(); ++i)
        for (int k = 0; k < 3; ++k)
            if (!(std::fabs(points[i][k]) <= largest_coordinate))
                refuse("point " + std::to_string(i) + " with " + "xyz"[k] + " = " + number_text(points[i][k]),
                       std::isfinite(points[i][k]) ? "must have coordinates from -1e6 to 1e6" : "must be finite");
    Bounds r{math::to_double(points[0]), math::to_double(points[0])};
    for (const Vec3 p : points) r.lo = math::min(r.lo, math::to_double(p)), r.hi = math::max(r.hi, math::to_double(p));
    const DVec3 size = r.hi - r.lo, reach = math::max(math::abs(r.lo), math::abs(r.hi));
    r.extent = std::max({size.x, size.y, size.z});
    r.largest = std::max({reach.x, reach.y, reach.z});
    if (!(r.extent >= min_extent))
        refuse("an extent of " + number_text(r.extent) + " m", "must not all lie in one point (within 1e-6 m)");
    return r;
}

void require_breadth(double breadth, double extent) {
    if (!(breadth > min_thickness * extent))
        refuse("a breadth of " + number_text(breadth) + " m in an extent of " + number_text(extent) + " m",
               "must not all lie on one line (within 1e-5 of their extent)");
}

void require_thickness(double thickness, const Bounds& bounds) {
    if (!(thickness > min_thickness * bounds.extent))
        refuse("a thickness of at most " + number_text(thickness) + " m in an extent of " + number_text(bounds.extent) +
                   " m",
               "must not all lie in one plane (within 1e-5 of their extent)");
    if (!(thickness > finest_plane * bounds.largest))
        refuse("a thickness of at most " + number_text(thickness) + " m with a coordinate of " +
                   number_text(bounds.largest) + " m",
               "must not all lie in one plane (within 1e-6 of the largest coordinate, as planes are kept in floats)");
}

// The points on the integer grid, scaled by a power of two, so that flat faces stay flat.
struct Grid {
    double scale = 1; // grid units per meter
    std::vector<GridPoint> points;
};

Grid make_grid(std::span<const Vec3> points, const Bounds& bounds) {
    int exponent = 0;
    std::frexp(bounds.extent, &exponent);
    Grid grid{std::ldexp(1.0, grid_bits - exponent), {}};
    grid.points.reserve(points.size());
    auto rounded = [&](double x) { return std::int32_t(std::floor(x * grid.scale + 0.5)); };
    for (const Vec3 p : points) {
        const DVec3 d = math::to_double(p) - bounds.lo;
        grid.points.push_back({rounded(d.x), rounded(d.y), rounded(d.z)});
    }
    return grid;
}

// The position of a grid point on a space-filling curve (Morton order): interleaved bits of x, y and z, from the
// highest.
std::uint32_t place_on_curve(GridPoint p) {
    auto spread = [](std::int32_t x) {
        auto bits = std::uint32_t(x) >> (grid_bits - 10) & 0x3ff;
        bits = (bits | bits << 16) & 0x030000ff;
        bits = (bits | bits << 8) & 0x0300f00f;
        bits = (bits | bits << 4) & 0x030c30c3;
        return (bits | bits << 2) & 0x09249249;
    };
    return spread(p.x) | spread(p.y) << 1 | spread(p.z) << 2;
}

// Reorders points so that neighbors in space are neighbors in memory.
std::vector<Vec3> put_along_curve(std::span<const Vec3> points, std::span<const GridPoint> grid) {
    std::vector<std::uint64_t> places;
    places.reserve(points.size());
    for (const GridPoint p : grid) places.push_back(place_on_curve(p));
    std::vector<Vec3> r;
    r.reserve(points.size());
    for (const std::uint32_t i : order_by(places)) r.push_back(points[i]);
    return r;
}

struct Polyhedron {
    std::vector<std::uint32_t> sources; // per vertex: the index of its point
    std::vector<GridPoint> points;      // the vertices
    std::vector<Triangle> triangles;
    std::vector<Face> faces; // in the order of their loops, each of which starts with its least vertex
    std::vector<std::uint32_t> loops;
    std::optional<Climber> climber;  // on the triangles; created after the faces
    std::vector<std::uint32_t> tops; // per face: the support vertex along its normal
};

Polyhedron select(std::span<const GridPoint> points, const Triangulation& triangulation,
                  std::span<const std::uint32_t> sources) {
    Polyhedron r;
    r.triangles = triangulation.triangles;
    for (const std::uint32_t p : triangulation.points) {
        r.points.push_back(points[p]);
        r.sources.push_back(sources.empty() ? p : sources[p]);
    }
    return r;
}

// Rotates each loop so that it starts with its least vertex, and sorts the faces by their loops.
void sort_faces(Polyhedron& body, const Faces& made) {
    std::vector<std::uint32_t> starts; // position of the least vertex in each loop
    // the edge from the least vertex: unique, since no two faces have an edge in the same direction
    std::vector<std::uint64_t> edges;
    starts.reserve(made.faces.size()), edges.reserve(made.faces.size());
    for (const Face& face : made.faces) {
        std::uint32_t least = 0;
        for (std::uint32_t i = 1; i < face.count; ++i)
            if (made.loops[face.first + i] < made.loops[face.first + least]) least = i;
        starts.push_back(least);
        edges.push_back(std::uint64_t(made.loops[face.first + least]) << 32 |
                        made.loops[face.first + (least + 1) % face.count]);
    }
    body.faces.reserve(made.faces.size()), body.loops.reserve(made.loops.size());
    for (const std::uint32_t f : order_by(edges)) {
        const Face& face = made.faces[f];
        const auto first = made.loops.begin() + face.first, middle = first + starts[f], last = first + face.count;
        body.faces.push_back({face.normal, std::uint32_t(body.loops.size()), face.count});
        body.loops.insert(body.loops.end(), middle, last);
        body.loops.insert(body.loops.end(), first, middle);
    }
}

Climber make_climber(const Polyhedron& body) {
    std::vector<DVec3> vertices;
    vertices.reserve(body.points.size());
    for (const GridPoint p : body.points) vertices.push_back(to_double(p));
    std::vector<Climber::Edge> edges;
    edges.reserve(3 * body.triangles.size());
    for (const Triangle& t : body.triangles)
        for (int k = 0; k < 3; ++k) edges.push_back({t.corners[k], t.corners[(k + 1) % 3]});
    return {std::move(vertices), edges};
}

// The normal of a face as it will be stored.
DVec3 float_normal(const Face& face) { return math::to_double(math::to_float(face.normal)); }

void climb(Polyhedron& body) {
    body.climber = make_climber(body);
    body.tops.reserve(body.faces.size());
    for (const Face& face : body.faces)
        body.tops.push_back(body.climber->farthest(float_normal(face), body.loops[face.first]));
}

// Merges triangles into faces, and removes points that are no corners then, until all points are corners. Returns false
// if no solid remains.
bool form_faces(Polyhedron& body, double plane_tolerance, double corner_tolerance) {
    while (true) {
        const Faces faces = make_faces(body.points, body.triangles, plane_tolerance, corner_tolerance);
        if (!faces.is_sound) return false;
        if (faces.redundant.empty()) {
            sort_faces(body, faces);
            climb(body);
            return true;
        }
        std::vector<bool> goes(body.points.size(), false);
        for (const std::uint32_t p : faces.redundant) goes[p] = true;
        std::vector<GridPoint> points;
        std::vector<std::uint32_t> sources;
        for (std::size_t p = 0; p < body.points.size(); ++p)
            if (!goes[p]) points.push_back(body.points[p]), sources.push_back(body.sources[p]);
        if (points.size() < 4) return false;
        const Simplex simplex = first_simplex(points);
        if (!(simplex.thickness > 0)) return false;
        body = select(points, triangulate(points, simplex, 0), sources);
    }
}

// Whether no corner of a face is more than the tolerance below its plane, and no input point more than that above it.
bool is_within(const Polyhedron& body, const PointTree& left_out, double tolerance) {
    const auto& vertices = body.climber->vertices();
    for (std::size_t f = 0; f < body.faces.size(); ++f) {
        const Face& face = body.faces[f];
        const DVec3 normal = float_normal(face);
        const double offset = math::dot(normal, vertices[body.tops[f]]);
        for (std::uint32_t i = 0; i < face.count; ++i)
            if (math::dot(normal, vertices[body.loops[face.first + i]]) < offset - tolerance) return false;
        if (left_out.farthest(normal, offset + tolerance).found) return false;
    }
    return true;
}

// Merging triangles may exceed its tolerance where many small steps add up. The result is therefore checked, and
// recomputed with a smaller tolerance if necessary. With tolerance 0 it is exact, and only the points left out at first
// deviate, by at most a quarter of the tolerance.
Polyhedron make_polyhedron(std::span<const GridPoint> points, const Simplex& simplex, double tolerance) {
    const Triangulation start = triangulate(points, simplex, tolerance / 8);
    for (const double part : {1.0, 1.0 / 8, 1.0 / 64, 0.0}) {
        Polyhedron body = select(points, start, {});
        if (!form_faces(body, part * tolerance / 4, part * tolerance / 64)) continue;
        std::vector<std::uint32_t> left_out = start.left_out;
        std::set_difference(start.points.begin(), start.points.end(), body.sources.begin(), body.sources.end(),
                            std::back_inserter(left_out));
        if (part == 0 || is_within(body, PointTree(points, left_out), tolerance)) return body;
    }
    return {}; // unreachable: the last iteration always returns
}

void fill_adjacency(HullData& hull) {
    hull.neighbor_start.assign(hull.vertices.size() + 1, 0);
    for (const std::uint32_t v : hull.loops) ++hull.neighbor_start[v + 1];
    for (std::size_t v = 0; v < hull.vertices.size(); ++v) hull.neighbor_start[v + 1] += hull.neighbor_start[v];
    hull.neighbors.resize(hull.loops.size());
    hull.faces_at.resize(hull.loops.size());
    std::vector<std::uint32_t> next(hull.neighbor_start.begin(), hull.neighbor_start.end() - 1);
    for (std::uint32_t f = 0; f < hull.faces.size(); ++f) {
        const HullFace& face = hull.faces[f];
        for (std::uint32_t i = 0; i < face.count; ++i) {
            const std::uint32_t from = hull.loops[face.first + i], to = hull.loops[face.first + (i + 1) % face.count];
            const std::uint32_t at = next[from]++;
            hull.neighbors[at] = to, hull.faces_at[at] = f;
        }
    }
    for (std::size_t v = 0; v < hull.vertices.size(); ++v)
        std::sort(hull.neighbors.begin() + hull.neighbor_start[v], hull.neighbors.begin() + hull.neighbor_start[v + 1]);
}

// The least distance between the plane of a face and the opposite vertex. Faces are visited from neighbor to neighbor,
// since their opposite vertices are close to each other.
float find_width(const HullData& hull, const Climber& climber) {
    constexpr std::uint32_t unknown = ~std::uint32_t{};
    std::vector<std::uint32_t> opposite(hull.faces.size(), unknown), order{0};
    std::vector<bool> is_visited(hull.vertices.size(), false);
    double width = -1;
    opposite[0] = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const HullFace& face = hull.faces[order[k]];
        const DVec3 normal = math::to_double(face.normal);
        const std::uint32_t v = climber.farthest(-normal, opposite[order[k]]);
        const double across = double(face.offset) - math::dot(normal, math::to_double(hull.vertices[v]));
        if (width < 0 || across < width) width = across;
        for (std::uint32_t i = face.first; i < face.first + face.count; ++i) {
            const std::uint32_t corner = hull.loops[i];
            if (is_visited[corner]) continue;
            is_visited[corner] = true;
            for (std::uint32_t j = hull.neighbor_start[corner]; j < hull.neighbor_start[corner + 1]; ++j)
                if (const std::uint32_t f = hull.faces_at[j]; opposite[f] == unknown)
                    opposite[f] = v, order.push_back(f);
        }
    }
    return float(width);
}

void fill_faces(HullData& hull, const Polyhedron& body, std::span<const Vec3> points) {
    hull.vertices.reserve(body.sources.size());
    for (const std::uint32_t p : body.sources) hull.vertices.push_back(points[p]);
    hull.lo = hull.hi = hull.vertices[0];
    double square = 0;
    for (const Vec3 v : hull.vertices) {
        hull.lo = math::min(hull.lo, v), hull.hi = math::max(hull.hi, v);
        square = std::max(square, math::dot(math::to_double(v), math::to_double(v)));
    }
    hull.bounding_radius = float(std::sqrt(square) * (1 + 0x1p-23)); // rounded up
    hull.faces.reserve(body.faces.size());
    for (std::size_t f = 0; f < body.faces.size(); ++f) {
        const Face& face = body.faces[f];
        const DVec3 top = math::to_double(hull.vertices[body.tops[f]]);
        hull.faces.push_back(
            {math::to_float(face.normal), float(math::dot(float_normal(face), top)), face.first, face.count, 0});
    }
    hull.loops = body.loops;
    fill_adjacency(hull);
    hull.width = find_width(hull, *body.climber);
}

} // namespace

Climber::Climber(std::vector<DVec3> vertices, std::span<const Edge> edges)
    : vertices_(std::move(vertices)), start_(vertices_.size() + 1, 0), neighbors_(edges.size()) {
    for (const Edge& edge : edges) ++start_[edge.from + 1];
    for (std::size_t v = 0; v < vertices_.size(); ++v) start_[v + 1] += start_[v];
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    for (const Edge& edge : edges) neighbors_[next[edge.from]++] = edge.to;
}

std::uint32_t Climber::farthest(DVec3 direction, std::uint32_t start) const {
    std::uint32_t best = start;
    double height = math::dot(direction, vertices_[best]);
    for (bool climbs = true; climbs;) {
        climbs = false;
        const std::uint32_t from = best;
        for (std::uint32_t i = start_[from]; i < start_[from + 1]; ++i) {
            const double h = math::dot(direction, vertices_[neighbors_[i]]);
            if (h > height) height = h, best = neighbors_[i], climbs = true;
        }
    }
    return best;
}

} // namespace hull

HullData build_hull(std::span<const Vec3> points) {
    using namespace hull;
    const Bounds bounds = check(points);
    Grid grid = make_grid(points, bounds);
    std::vector<Vec3> along_curve;
    if (points.size() > many_points) {
        along_curve = put_along_curve(points, grid.points);
        points = along_curve;
        grid = make_grid(points, bounds);
    }
    const Simplex simplex = first_simplex(grid.points);
    require_breadth(simplex.breadth / grid.scale, bounds.extent);
    require_thickness(simplex.thickness / grid.scale, bounds);
    const double noise = std::min(0x1p-20 * bounds.largest, 1e-3 * bounds.extent);
    const double tolerance = std::min(1e-5 * bounds.extent + noise, 0.05 * simplex.thickness / grid.scale);
    Polyhedron body = make_polyhedron(grid.points, simplex, tolerance * grid.scale);
    HullData r;
    r.tolerance = float(tolerance + 0x1p-23 * bounds.largest);
    fill_faces(r, body, points);
    require_thickness(r.width, bounds);
    measure_mass(r);
    inset_core(r);
    arrange(r);
    return r;
}

namespace {

// Projects the corners of a face into its plane; e2 is normal x e1.
inline void lay_flat(const HullData& hull, const HullFace& face, const DVec3& e1, const DVec3& e2, double* x,
                     double* y) {
    const std::uint32_t* const loop = &hull.loops[face.first];
    const DVec3 first = math::to_double(hull.vertices[loop[0]]);
    for (std::uint32_t i = 0; i < face.count; ++i) {
        const DVec3 d = math::to_double(hull.vertices[loop[i]]) - first;
        x[i] = math::dot(d, e1), y[i] = math::dot(d, e2);
    }
}

inline DVec3 first_axis(const HullData& hull, const HullFace& face, const DVec3& normal) {
    const std::uint32_t* const loop = &hull.loops[face.first];
    return direction_in_plane(math::to_double(hull.vertices[loop[1]]) - math::to_double(hull.vertices[loop[0]]),
                              normal);
}

} // namespace

HullOutline outline_of(const HullData& hull, std::size_t index, SideBlock (&made)[made_blocks]) {
    const HullFace& face = hull.faces[index];
    const DVec3 normal = hull.unit_normal(index);
    HullOutline r;
    r.e1 = first_axis(hull, face, normal);
    const auto grow = [&](double x, double y) { r.size = std::max(r.size, std::max(std::fabs(x), std::fabs(y))); };
    if (face.count > max_made_sides) {
        r.sides = {&hull.sides[face.first_side], blocks_of(face.count)};
        for (const SideBlock& block : r.sides)
            for (std::size_t k = 0; k < SideBlock::width; ++k) grow(block.x[k], block.y[k]);
        return r;
    }
    double x[max_made_sides + 1], y[max_made_sides + 1];
    lay_flat(hull, face, r.e1, math::cross(normal, r.e1), x, y);
    for (std::uint32_t i = 0; i < face.count; ++i) grow(x[i], y[i]);
    make_sides(x, y, face.count, made);
    r.sides = {made, blocks_of(face.count)};
    return r;
}

namespace {

// The radius of the largest ball about a point that lies within the hull, or 0.
double inner_radius_about(const HullData& hull, DVec3 point) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const HullFace& face : hull.faces)
        nearest = std::min(nearest, double(face.offset) - math::dot(math::to_double(face.normal), point));
    return std::max(0.0, nearest - 2 * double(hull.tolerance)); // corners may deviate from their faces by the tolerance
}

// The middle of the bounds may be near the surface or outside, as for flat tetrahedra. The distance of the center of
// mass from every face is at least a quarter of the hull's extent perpendicular to it (Minkowski; Radon).
void find_inside(HullData& hull) {
    constexpr double least = 0.125; // relative to the width: half of what the center of mass guarantees
    hull.inside = 0.5 * (math::to_double(hull.lo) + math::to_double(hull.hi));
    hull.inner_radius = inner_radius_about(hull, hull.inside);
    if (hull.inner_radius >= least * double(hull.width)) return;
    const double at_center = inner_radius_about(hull, hull.unit_mass.center);
    if (at_center > hull.inner_radius) hull.inside = hull.unit_mass.center, hull.inner_radius = at_center;
}

} // namespace

void arrange(HullData& hull) {
    hull.vertex_columns = Columns(hull.vertices);
    hull.unit_factors.clear(), hull.sides.clear();
    std::size_t blocks = 0;
    for (HullFace& face : hull.faces)
        if (face.count > max_made_sides) face.first_side = std::uint32_t(blocks), blocks += blocks_of(face.count);
    hull.unit_factors.reserve(hull.faces.size()), hull.sides.resize(blocks);
    std::vector<Vec3> normals;
    std::vector<float> offsets;
    for (const HullFace& face : hull.faces) {
        hull.unit_factors.push_back(1.0 / math::length(math::to_double(face.normal)));
        normals.push_back(face.normal);
        offsets.push_back(face.offset);
        if (face.count <= max_made_sides) continue;
        const DVec3 normal = hull.unit_normal(hull.unit_factors.size() - 1), e1 = first_axis(hull, face, normal);
        std::vector<double> x(face.count + SideBlock::width), y = x;
        lay_flat(hull, face, e1, math::cross(normal, e1), x.data(), y.data());
        make_sides(x.data(), y.data(), face.count, &hull.sides[face.first_side]);
    }
    hull.plane_columns = PlaneColumns(normals, offsets);
    find_inside(hull);
}

} // namespace cairn
