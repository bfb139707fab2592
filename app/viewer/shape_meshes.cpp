#include "viewer/shape_meshes.h"

#include <cairn/triangles.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <variant>
#include <vector>

namespace cairn::viewer {

namespace {

// Cells of a height field per tile, in each direction; two triangles per cell make one mesh part.
constexpr std::size_t cells_per_tile = 64;
static_assert(2 * cells_per_tile * cells_per_tile == triangles_per_part);
constexpr std::size_t max_smoothed = 64; // triangles at one vertex; beyond it, all stay flat-shaded

// Normalizes a vector; returns up for a zero vector.
Vec3 direction_of(const Vec3& v) {
    const float length = glm::length(v);
    return length > 0.0f && std::isfinite(length) ? v / length : Vec3(0.0f, 1.0f, 0.0f);
}

// The triangle corners around each vertex: those of vertex v are corners[start[v]] to corners[start[v + 1] - 1].
struct VertexCorners {
    std::vector<std::uint32_t> start, corners;
};

VertexCorners corners_of(std::size_t vertex_count, std::span<const std::uint32_t> indices) {
    VertexCorners result;
    result.start.assign(vertex_count + 1, 0);
    for (const std::uint32_t vertex : indices) ++result.start[vertex + 1];
    for (std::size_t v = 0; v < vertex_count; ++v) result.start[v + 1] += result.start[v];
    result.corners.resize(indices.size());
    std::vector<std::uint32_t> next(result.start.begin(), result.start.end() - 1);
    for (std::size_t i = 0; i < indices.size(); ++i) result.corners[next[indices[i]]++] = std::uint32_t(i);
    return result;
}

// The normal of one corner: the mean over the triangles around the vertex whose normals differ little from its own,
// weighted by their angles there (Thuermer and Wuethrich 1998), so that it does not depend on the triangulation of
// faces.
Vec3 corner_normal(std::span<const std::uint32_t> around, std::uint32_t own, std::span<const Vec3> normals,
                   std::span<const float> angles) {
    const Vec3& flat = normals[own / 3];
    if (around.size() > max_smoothed) return flat;
    Vec3 sum(0.0f);
    for (const std::uint32_t corner : around) {
        const Vec3& other = normals[corner / 3];
        if (corner == own || glm::dot(flat, other) > smooth_cosine) sum += other * angles[corner];
    }
    return direction_of(sum);
}

struct Ball {
    Vec3 center{0.0f, 0.0f, 0.0f}, extent{0.0f, 0.0f, 0.0f};
    float radius = 0.0f;
};

// Bounding box, and bounding sphere about the box's center.
template <class Range, class PlaceOf> Ball ball_around(const Range& range, const PlaceOf& place_of) {
    if (std::empty(range)) return {};
    Vec3 least = place_of(range[0]), greatest = least;
    for (const auto& item : range) {
        least = glm::min(least, place_of(item));
        greatest = glm::max(greatest, place_of(item));
    }
    Ball ball{0.5f * (least + greatest), 0.5f * (greatest - least), 0.0f};
    for (const auto& item : range) ball.radius = std::max(ball.radius, glm::distance(place_of(item), ball.center));
    return ball;
}

template <class Data> const void* address_of(const std::shared_ptr<const Data>& data) { return data.get(); }

} // namespace

TriangleMesh hull_triangles(const Hull& hull) {
    TriangleMesh mesh;
    const auto vertices = hull.vertices();
    for (std::size_t f = 0; f < hull.face_count(); ++f) {
        const auto face = hull.face(f);
        // Newell's formula: averages over all corners, so that no three of them determine the normal alone.
        Vec3 normal(0.0f);
        for (std::size_t i = 0; i < face.size(); ++i)
            normal += glm::cross(vertices[face[i]] - vertices[face[0]],
                                 vertices[face[(i + 1) % face.size()]] - vertices[face[0]]);
        normal = direction_of(normal);
        const auto first = std::uint32_t(mesh.vertices.size());
        for (const std::uint32_t corner : face) mesh.vertices.push_back({vertices[corner], Vec3(0.0f), normal});
        for (std::uint32_t i = 2; i < face.size(); ++i)
            mesh.indices.insert(mesh.indices.end(), {first, first + i - 1, first + i});
    }
    return mesh;
}

TriangleMesh surface_triangles(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices) {
    std::vector<Vec3> normals(indices.size() / 3);
    std::vector<float> angles(indices.size());
    for (std::size_t t = 0; t < normals.size(); ++t) {
        const std::array<Vec3, 3> p{vertices[indices[3 * t]], vertices[indices[3 * t + 1]],
                                    vertices[indices[3 * t + 2]]};
        normals[t] = direction_of(glm::cross(p[1] - p[0], p[2] - p[0]));
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 u = direction_of(p[(k + 1) % 3] - p[k]), v = direction_of(p[(k + 2) % 3] - p[k]);
            angles[3 * t + k] = std::acos(std::clamp(glm::dot(u, v), -1.0f, 1.0f));
        }
    }
    const VertexCorners corners = corners_of(vertices.size(), indices);
    TriangleMesh mesh;
    mesh.indices.resize(indices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const std::span around(corners.corners.data() + corners.start[v], corners.start[v + 1] - corners.start[v]);
        const std::size_t first = mesh.vertices.size();
        for (const std::uint32_t corner : around) {
            const Vec3 normal = corner_normal(around, corner, normals, angles);
            // Corners with equal normals share a vertex; where very many triangles meet, only the latest are compared.
            std::size_t place = std::max(first, mesh.vertices.size() - std::min(mesh.vertices.size(), max_smoothed));
            while (place < mesh.vertices.size() && glm::dot(mesh.vertices[place].normal, normal) < 0.99999f) ++place;
            if (place == mesh.vertices.size()) mesh.vertices.push_back({vertices[v], Vec3(0.0f), normal});
            mesh.indices[corner] = std::uint32_t(place);
        }
    }
    return mesh;
}

TriangleMesh height_field_triangles(const HeightField& field) {
    const std::span<const float> heights = field.heights();
    const glm::vec2 spacing = field.spacing();
    const auto columns = std::size_t(field.columns()), rows = std::size_t(field.rows());
    std::size_t stride = 1;
    const auto lines = [&stride](std::size_t count) { return (count - 2) / stride + 2; }; // includes the last one
    while (lines(columns) * lines(rows) > max_heights) ++stride;
    const std::size_t across = lines(columns), along = lines(rows);
    const auto place = [&](std::size_t i, std::size_t k) {
        const std::size_t c = std::min(i * stride, columns - 1), r = std::min(k * stride, rows - 1);
        return Vec3((float(c) - 0.5f * float(columns - 1)) * spacing.x, heights[r * columns + c],
                    (float(r) - 0.5f * float(rows - 1)) * spacing.y);
    };
    TriangleMesh mesh;
    mesh.vertices.reserve(across * along);
    for (std::size_t k = 0; k < along; ++k) {
        for (std::size_t i = 0; i < across; ++i) {
            const Vec3 here = place(i, k);
            if (here.y == HeightField::hole) { // used by no triangle
                mesh.vertices.push_back({Vec3(here.x, 0.0f, here.z), Vec3(0.0f), Vec3(0.0f, 1.0f, 0.0f)});
                continue;
            }
            // The normal from finite differences over the neighboring columns and rows, one-sided at the border.
            const auto beside = [&](std::size_t i1, std::size_t k1) {
                const Vec3 p = place(i1, k1);
                return p.y == HeightField::hole ? Vec3(p.x, here.y, p.z) : p;
            };
            const Vec3 dx = beside(std::min(i + 1, across - 1), k) - beside(i > 0 ? i - 1 : 0, k);
            const Vec3 dz = beside(i, std::min(k + 1, along - 1)) - beside(i, k > 0 ? k - 1 : 0);
            mesh.vertices.push_back({here, Vec3(0.0f), direction_of(glm::cross(dz, dx))});
        }
    }
    mesh.indices.reserve(6 * (across - 1) * (along - 1));
    const auto is_hole = [&](std::size_t i, std::size_t k) { return place(i, k).y == HeightField::hole; };
    const auto add_cell = [&](std::size_t i, std::size_t k) {
        const auto near = std::uint32_t(k * across + i), far = std::uint32_t(near + across);
        if (is_hole(i, k) || is_hole(i + 1, k + 1)) return;
        if (!is_hole(i, k + 1)) mesh.indices.insert(mesh.indices.end(), {near, far, far + 1});
        if (!is_hole(i + 1, k)) mesh.indices.insert(mesh.indices.end(), {near, far + 1, near + 1});
    };
    for (std::size_t k0 = 0; k0 + 1 < along; k0 += cells_per_tile)
        for (std::size_t i0 = 0; i0 + 1 < across; i0 += cells_per_tile)
            for (std::size_t k = k0; k < std::min(k0 + cells_per_tile, along - 1); ++k)
                for (std::size_t i = i0; i < std::min(i0 + cells_per_tile, across - 1); ++i) add_cell(i, k);
    return mesh;
}

TriangleMesh visual_triangles(std::span<const Vec3> vertices, std::span<const Vec3> normals,
                              std::span<const std::uint32_t> indices, std::span<const glm::vec2> coordinates,
                              std::span<const Vec3> colors) {
    TriangleMesh mesh;
    const auto place = [&](std::size_t i) {
        return coordinates.empty() ? Vec3(0.0f) : Vec3(coordinates[i].x, coordinates[i].y, 0.0f);
    };
    if (!normals.empty()) {
        for (std::size_t i = 0; i < vertices.size(); ++i)
            mesh.vertices.push_back({vertices[i], place(i), direction_of(normals[i])});
        mesh.indices.assign(indices.begin(), indices.end());
        mesh.colors.assign(colors.begin(), colors.end());
        return mesh;
    }
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const Vec3 a = vertices[indices[i]], b = vertices[indices[i + 1]], c = vertices[indices[i + 2]];
        const Vec3 normal = direction_of(glm::cross(b - a, c - a));
        for (const std::size_t corner : {i, i + 1, i + 2}) {
            mesh.indices.push_back(std::uint32_t(mesh.vertices.size()));
            mesh.vertices.push_back({vertices[indices[corner]], place(indices[corner]), normal});
            if (!colors.empty()) mesh.colors.push_back(colors[indices[corner]]);
        }
    }
    return mesh;
}

ShapeMesh make_shape_mesh(TriangleMesh triangles, MeshVisual look) {
    ShapeMesh mesh;
    mesh.triangles = std::move(triangles);
    mesh.look = look;
    const std::vector<std::uint32_t>& indices = mesh.triangles.indices;
    constexpr std::size_t step = 3 * triangles_per_part;
    for (std::size_t first = 0; first < indices.size(); first += step) {
        const std::span part = std::span(indices).subspan(first, std::min(step, indices.size() - first));
        const Ball ball = ball_around(part, [&](std::uint32_t i) { return mesh.triangles.vertices[i].corner; });
        mesh.parts.push_back({first, part.size(), ball.center, ball.radius});
    }
    const Ball ball = ball_around(mesh.triangles.vertices, [](const MeshVertex& vertex) { return vertex.corner; });
    mesh.center = ball.center;
    mesh.extent = ball.extent;
    mesh.radius = ball.radius;
    return mesh;
}

TriangleMesh rounded_shape_triangles(const Shape& shape) {
    const ShapeTriangles triangles = rounded_triangles(shape);
    TriangleMesh mesh;
    for (std::size_t i = 0; i < triangles.vertices.size(); ++i)
        mesh.vertices.push_back({triangles.vertices[i], Vec3(0.0f), triangles.normals[i]});
    mesh.indices = triangles.indices;
    return mesh;
}

namespace {

// Sizes that two rounded shapes must share, besides their data, to share a mesh.
std::vector<float> sizes_of(const Shape& shape) {
    const float rounding = rounding_of(shape);
    if (!(rounding > 0.0f)) return {};
    if (const Box* box = std::get_if<Box>(&shape))
        return {rounding, box->half_extents.x, box->half_extents.y, box->half_extents.z};
    if (const Cylinder* c = std::get_if<Cylinder>(&shape))
        return {rounding, c->half_height, c->radius, c->radius_top.value_or(c->radius), 0.0f};
    return {rounding};
}

} // namespace

std::shared_ptr<const ShapeMesh> MeshCache::mesh_of(const Shape& shape) {
    const Hull* hull = std::get_if<Hull>(&shape);
    const Mesh* surface = std::get_if<Mesh>(&shape);
    const HeightField* field = std::get_if<HeightField>(&shape);
    const void* address = hull      ? address_of(hull->data())
                          : surface ? address_of(surface->data())
                          : field   ? address_of(field->data())
                                    : nullptr;
    const Key key{address, sizes_of(shape)};
    if (!address && key.second.empty()) return nullptr;
    if (const auto found = entries_.find(key); found != entries_.end()) {
        found->second.used = true;
        return found->second.mesh;
    }
    ShapeMesh mesh =
        !key.second.empty() ? make_shape_mesh(rounded_shape_triangles(shape), MeshVisual::facets)
        : hull              ? make_shape_mesh(hull_triangles(*hull), MeshVisual::facets)
        : surface ? make_shape_mesh(surface_triangles(surface->vertices(), surface->indices()), MeshVisual::surface)
                  : make_shape_mesh(height_field_triangles(*field), MeshVisual::terrain);
    return entries_.emplace(key, Entry{shape, std::make_shared<const ShapeMesh>(std::move(mesh))}).first->second.mesh;
}

void MeshCache::drop_unused() {
    std::erase_if(entries_, [](const auto& item) { return !item.second.used; });
    for (auto& [key, entry] : entries_) entry.used = false;
}

} // namespace cairn::viewer
