#include "bench/surface_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn::bench {

namespace {

using Vector = glm::dvec3;

constexpr double infinity = std::numeric_limits<double>::infinity();

// The depth of a point, in the mesh's frame, below the plane of the triangle above or below it; -infinity beside the
// mesh.
double point_depth(const SurfaceMesh& mesh, const Vector& point) {
    const double spacing = double(mesh.spacing);
    const double x = point.x / spacing + 0.5 * (mesh.columns - 1), z = point.z / spacing + 0.5 * (mesh.rows - 1);
    if (!(x >= 0 && x <= mesh.columns - 1 && z >= 0 && z <= mesh.rows - 1)) return -infinity;
    const int column = std::min(static_cast<int>(x), mesh.columns - 2),
              row = std::min(static_cast<int>(z), mesh.rows - 2);
    // The first triangle of a cell is on the side of greater z.
    const bool is_first = z - row >= x - column;
    const std::size_t start = (static_cast<std::size_t>(row) * static_cast<std::size_t>(mesh.columns - 1) +
                               static_cast<std::size_t>(column)) *
                                  6 +
                              (is_first ? 0 : 3);
    const auto corner = [&](std::size_t i) { return Vector(mesh.vertices[mesh.indices[start + i]]); };
    const Vector normal = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    return glm::dot(normal, corner(0) - point);
}

// The vertices of the part relative to its center; for spheres and capsules the centers of their balls.
std::vector<Vector> corners_of(const PlacedPart& part) {
    constexpr int around = 32;
    constexpr double pi = 3.14159265358979323846;
    std::vector<Vector> corners;
    switch (part.shape) {
    case PartShape::box:
        for (int i = 0; i < 8; ++i) {
            Vector corner(0.0);
            for (int k = 0; k < 3; ++k) corner += (i >> k & 1 ? 1.0 : -1.0) * part.half_extents[k] * part.axes[k];
            corners.push_back(corner);
        }
        break;
    case PartShape::capsule:
        corners = {part.half_height * part.axes[1], -part.half_height * part.axes[1]};
        break;
    case PartShape::cylinder:
        for (int i = 0; i < around; ++i) {
            const double angle = 2 * pi * i / around;
            const Vector arm = part.radius * (std::cos(angle) * part.axes[0] + std::sin(angle) * part.axes[2]);
            corners.push_back(arm + part.half_height * part.axes[1]);
            corners.push_back(arm - part.half_height * part.axes[1]);
        }
        break;
    case PartShape::hull:
        return part.polyhedron.corners;
    case PartShape::sphere:
    case PartShape::mesh:
        corners.push_back(Vector(0.0));
        break;
    }
    return corners;
}

// The depth of a point, relative to the part's center, inside the part: the distance to its nearest face or side.
double depth_inside(const PlacedPart& part, const Vector& point) {
    const double along = glm::dot(point, part.axes[1]);
    double depth = infinity;
    switch (part.shape) {
    case PartShape::sphere:
        return part.radius - glm::length(point);
    case PartShape::box:
        for (int i = 0; i < 3; ++i)
            depth = std::min(depth, part.half_extents[i] - std::abs(glm::dot(point, part.axes[i])));
        return depth;
    case PartShape::capsule:
        return part.radius - glm::length(point - std::clamp(along, -part.half_height, part.half_height) * part.axes[1]);
    case PartShape::cylinder:
        return std::min(part.half_height - std::abs(along), part.radius - glm::length(point - along * part.axes[1]));
    case PartShape::hull:
        for (std::size_t i = 0; i < part.polyhedron.normals.size(); ++i)
            depth = std::min(depth, part.polyhedron.offsets[i] - glm::dot(part.polyhedron.normals[i], point));
        return depth;
    case PartShape::mesh:
        break;
    }
    return -infinity;
}

} // namespace

double surface_depth(const PlacedPart& part, const PlacedPart& surface) {
    const SurfaceMesh& mesh = *surface.mesh;
    const auto to_mesh = [&](const Vector& v) {
        return Vector(glm::dot(v, surface.axes[0]), glm::dot(v, surface.axes[1]), glm::dot(v, surface.axes[2]));
    };
    const Vector center = to_mesh(part.center - surface.center);
    const bool is_round = part.shape == PartShape::sphere || part.shape == PartShape::capsule;
    double depth = -infinity;
    for (const Vector& corner : corners_of(part))
        depth = std::max(depth, point_depth(mesh, center + to_mesh(corner)) + (is_round ? part.radius : 0.0));

    const double spacing = double(mesh.spacing), reach = part.bounding_radius / spacing;
    const auto range = [&](double middle, int count) {
        const double at = std::clamp(middle / spacing + 0.5 * (count - 1), -1e6, 1e6);
        return std::pair{std::max(0, static_cast<int>(std::floor(at - reach))),
                         std::min(count - 1, static_cast<int>(std::ceil(at + reach)))};
    };
    const auto [first_column, last_column] = range(center.x, mesh.columns);
    const auto [first_row, last_row] = range(center.z, mesh.rows);
    for (int row = first_row; row <= last_row; ++row)
        for (int column = first_column; column <= last_column; ++column) {
            const Vector vertex(mesh.vertices[static_cast<std::size_t>(row * mesh.columns + column)]);
            const Vector to_world =
                vertex.x * surface.axes[0] + vertex.y * surface.axes[1] + vertex.z * surface.axes[2];
            depth = std::max(depth, depth_inside(part, surface.center + to_world - part.center));
        }
    return depth;
}

} // namespace cairn::bench
