#include "bench/overlap.h"

#include "bench/rotate.h"
#include "bench/surface_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cairn::bench {

namespace {

using Vector = glm::dvec3;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double parallel = 1e-6; // sine of the angle below which the cross product of two edges is not used

Polyhedron place_hull(const ConvexHull& hull, const Vector (&axes)[3]) {
    Polyhedron placed;
    const auto turn = [&](const Vec3& v) {
        return double(v.x) * axes[0] + double(v.y) * axes[1] + double(v.z) * axes[2];
    };
    for (const Vec3& point : hull.points) placed.corners.push_back(turn(point));
    for (const auto& triangle : hull.triangles) {
        const Vector &a = placed.corners[triangle[0]], &b = placed.corners[triangle[1]],
                     &c = placed.corners[triangle[2]];
        placed.normals.push_back(glm::normalize(glm::cross(b - a, c - a)));
        placed.offsets.push_back(glm::dot(placed.normals.back(), a));
        for (int i = 0; i < 3; ++i) { // each edge once: its two triangles have it in opposite directions
            const std::uint32_t from = triangle[std::size_t(i)], to = triangle[std::size_t((i + 1) % 3)];
            if (from < to) placed.edges.push_back(placed.corners[to] - placed.corners[from]);
        }
    }
    return placed;
}

// Support function: the extent of a part from its center along a unit vector.
double reach(const PlacedPart& part, const Vector& direction) {
    switch (part.shape) {
    case PartShape::sphere:
        return part.radius;
    case PartShape::box: {
        double sum = 0;
        for (int i = 0; i < 3; ++i) sum += std::abs(glm::dot(direction, part.axes[i])) * part.half_extents[i];
        return sum;
    }
    case PartShape::capsule:
        return part.radius + part.half_height * std::abs(glm::dot(direction, part.axes[1]));
    case PartShape::cylinder: {
        const double along = glm::dot(direction, part.axes[1]);
        return part.half_height * std::abs(along) + part.radius * std::sqrt(std::max(0.0, 1 - along * along));
    }
    case PartShape::hull: {
        double most = -infinity;
        for (const Vector& corner : part.polyhedron.corners) most = std::max(most, glm::dot(direction, corner));
        return most;
    }
    case PartShape::mesh:
        break;
    }
    return infinity;
}

// The distance by which b must move along the unit vector to be separated from a: an upper bound of the penetration
// depth.
double overlap_along(const PlacedPart& a, const PlacedPart& b, const Vector& direction) {
    return reach(a, direction) + reach(b, -direction) - glm::dot(direction, b.center - a.center);
}

std::vector<Vector> face_normals(const PlacedPart& part) {
    if (part.shape == PartShape::box) return {part.axes[0], part.axes[1], part.axes[2]};
    if (part.shape == PartShape::cylinder) return {part.axes[1]};
    return part.polyhedron.normals;
}

std::vector<Vector> edges(const PlacedPart& part) {
    if (part.shape == PartShape::box) return {part.axes[0], part.axes[1], part.axes[2]};
    if (part.shape == PartShape::cylinder || part.shape == PartShape::capsule) return {part.axes[1]};
    return part.polyhedron.edges;
}

struct Axis {
    Vector direction;
    double overlap;
};

// Tests both directions along a face normal or a cross product of edges, and keeps the axis of least overlap. If
// `found` is set, all axes are added to it.
class AxisTest {
  public:
    AxisTest(const PlacedPart& a, const PlacedPart& b) : a_(a), b_(b) {}
    std::vector<Axis>* found = nullptr;
    double least = infinity;

    void try_both_ways(const Vector& axis) {
        for (const Vector& direction : {axis, -axis}) {
            const double overlap = overlap_along(a_, b_, direction);
            least = std::min(least, overlap);
            if (found) found->push_back({direction, overlap});
        }
    }
    void try_faces() {
        for (const PlacedPart* part : {&a_, &b_})
            for (const Vector& normal : face_normals(*part)) try_both_ways(normal);
    }
    void try_edges() {
        const std::vector<Vector> edges_a = edges(a_), edges_b = edges(b_);
        for (const Vector& edge_a : edges_a)
            for (const Vector& edge_b : edges_b) {
                const Vector axis = glm::cross(edge_a, edge_b);
                const double length = glm::length(axis);
                if (length > parallel * glm::length(edge_a) * glm::length(edge_b)) try_both_ways(axis / length);
            }
    }

  private:
    const PlacedPart &a_, &b_;
};

// The separating axis test over all face normals and all cross products of edges (Gottschalk, Lin, Manocha, "OBBTree",
// 1996), for boxes and hulls.
double polyhedra_penetration(const PlacedPart& a, const PlacedPart& b) {
    AxisTest test(a, b);
    test.try_faces();
    if (test.least > 0) test.try_edges();
    return test.least;
}

// Descends on the unit sphere to a smaller overlap: tries sixteen directions with ever shorter steps, down to a
// microradian.
double descend(const PlacedPart& a, const PlacedPart& b, Axis axis) {
    constexpr double first_step = 0.1, last_step = 1e-6, sixteenth = 0.392699081698724;
    double turn = 0; // rotates the sixteen directions, so that no ridge stays between them
    for (double step = first_step; step > last_step;) {
        const Vector any = std::abs(axis.direction.x) < 0.6 ? Vector(1, 0, 0) : Vector(0, 1, 0);
        const Vector u = glm::normalize(glm::cross(axis.direction, any)), v = glm::cross(axis.direction, u);
        Axis best = axis;
        for (int way = 0; way < 16; ++way) {
            const double angle = turn + way * sixteenth;
            const Vector direction =
                glm::normalize(axis.direction + step * (std::cos(angle) * u + std::sin(angle) * v));
            const double overlap = overlap_along(a, b, direction);
            if (overlap < best.overlap) best = {direction, overlap};
        }
        if (best.overlap == axis.overlap) step *= 0.7;
        axis = best;
        turn += 1;
    }
    return axis.overlap;
}

// Unit directions to the centers of the cells of a cube's surface.
const std::vector<Vector>& all_around() {
    static const std::vector<Vector> directions = [] {
        constexpr int n = 3;
        std::vector<Vector> list;
        for (int x = -n; x <= n; ++x)
            for (int y = -n; y <= n; ++y)
                for (int z = -n; z <= n; ++z)
                    if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == n)
                        list.push_back(glm::normalize(Vector(x, y, z)));
        return list;
    }();
    return directions;
}

// Pairs with round shapes: candidate axes that may be exact, then directions all around, and a descent from the best
// ones.
double round_penetration(const PlacedPart& a, const PlacedPart& b) {
    constexpr std::size_t starts = 5;
    std::vector<Axis> found;
    AxisTest test(a, b);
    test.found = &found;
    const Vector offset = b.center - a.center;
    const double distance = glm::length(offset);
    if (distance > 0) test.try_both_ways(offset / distance);
    for (const PlacedPart* part : {&a, &b}) { // from side to side, across the axis
        const Vector across = offset - glm::dot(offset, part->axes[1]) * part->axes[1];
        if (glm::length(across) > parallel * distance) test.try_both_ways(glm::normalize(across));
    }
    test.try_faces();
    test.try_edges();
    if (test.least <= 0) return test.least;
    for (const Vector& direction : all_around()) {
        found.push_back({direction, overlap_along(a, b, direction)});
        if (found.back().overlap <= 0) return found.back().overlap;
    }
    const std::size_t count = std::min(starts, found.size());
    std::partial_sort(found.begin(), found.begin() + std::ptrdiff_t(count), found.end(),
                      [](const Axis& x, const Axis& y) { return x.overlap < y.overlap; });
    double least = infinity;
    for (std::size_t i = 0; i < count; ++i) least = std::min(least, descend(a, b, found[i]));
    return least;
}

double sphere_box_penetration(const PlacedPart& sphere, const PlacedPart& box) {
    const Vector offset = sphere.center - box.center;
    Vector outside(0.0);
    double inside = -infinity; // greatest signed distance from a face plane
    for (int i = 0; i < 3; ++i) {
        const double distance = std::abs(glm::dot(offset, box.axes[i])) - box.half_extents[i];
        outside[i] = std::max(distance, 0.0);
        inside = std::max(inside, distance);
    }
    return sphere.radius - (glm::length(outside) + std::min(inside, 0.0));
}

// The distance of two segments (Ericson, "Real-Time Collision Detection", 2005, 5.1.9), both of nonzero length.
double segment_distance(const PlacedPart& a, const PlacedPart& b) {
    const Vector u = 2 * a.half_height * a.axes[1], v = 2 * b.half_height * b.axes[1];
    const Vector from = a.center - 0.5 * u, to = b.center - 0.5 * v, w = from - to;
    const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), uw = glm::dot(u, w),
                 vw = glm::dot(v, w);
    const double area = uu * vv - uv * uv;
    double s = area > parallel * parallel * uu * vv ? std::clamp((uv * vw - uw * vv) / area, 0.0, 1.0) : 0.5;
    const double t = std::clamp((uv * s + vw) / vv, 0.0, 1.0);
    s = std::clamp((uv * t - uw) / uu, 0.0, 1.0);
    return glm::length(w + s * u - t * v);
}

bool is_flat(const PlacedPart& part) { return part.shape == PartShape::box || part.shape == PartShape::hull; }

} // namespace

PlacedPart place(const Scene& scene, const Part& part, const BodyState& body) {
    PlacedPart placed;
    placed.shape = part.shape;
    placed.center = body.position + rotate(body.rotation, Vector(part.position));
    for (int i = 0; i < 3; ++i) {
        Vector axis(0.0);
        axis[i] = 1.0;
        placed.axes[i] = rotate(body.rotation, rotate(part.rotation, axis));
    }
    placed.radius = double(part.radius);
    placed.half_height = double(part.half_height);
    placed.half_extents = Vector(part.half_extents);
    switch (part.shape) {
    case PartShape::sphere:
        placed.bounding_radius = placed.radius;
        break;
    case PartShape::box:
        placed.bounding_radius = glm::length(placed.half_extents);
        break;
    case PartShape::capsule:
        placed.bounding_radius = placed.radius + placed.half_height;
        break;
    case PartShape::cylinder:
        placed.bounding_radius = std::hypot(placed.radius, placed.half_height);
        break;
    case PartShape::hull:
        placed.polyhedron = place_hull(scene.hulls[part.index], placed.axes);
        for (const Vector& corner : placed.polyhedron.corners)
            placed.bounding_radius = std::max(placed.bounding_radius, glm::length(corner));
        break;
    case PartShape::mesh:
        placed.mesh = &scene.meshes[part.index];
        for (const Vec3& vertex : placed.mesh->vertices)
            placed.bounding_radius = std::max(placed.bounding_radius, glm::length(Vector(vertex)));
        break;
    }
    return placed;
}

double penetration(const PlacedPart& a, const PlacedPart& b) {
    if (a.mesh) return surface_depth(b, a);
    if (b.mesh) return surface_depth(a, b);
    if (is_flat(a) && is_flat(b)) return polyhedra_penetration(a, b);
    const bool a_is_sphere = a.shape == PartShape::sphere, b_is_sphere = b.shape == PartShape::sphere;
    if (a_is_sphere && b_is_sphere) return a.radius + b.radius - glm::length(a.center - b.center);
    if (a_is_sphere && b.shape == PartShape::box) return sphere_box_penetration(a, b);
    if (b_is_sphere && a.shape == PartShape::box) return sphere_box_penetration(b, a);
    if (a.shape == PartShape::capsule && b.shape == PartShape::capsule) {
        const double distance = segment_distance(a, b);
        if (distance > 0) return a.radius + b.radius - distance;
    }
    return round_penetration(a, b);
}

} // namespace cairn::bench
