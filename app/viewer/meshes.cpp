#include "viewer/meshes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace cairn::viewer {

namespace {

// Adds a triangle, turned so that its front looks along `outward`, judged with a small bevel.
void add_triangle(Mesh& mesh, std::uint16_t a, std::uint16_t b, std::uint16_t c, const Vec3& outward) {
    const auto place = [&mesh](std::uint16_t index) {
        return mesh.vertices[index].corner - mesh.vertices[index].inset * 0.1f;
    };
    if (glm::dot(glm::cross(place(b) - place(a), place(c) - place(a)), outward) < 0.0f) std::swap(b, c);
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

void add_quad(Mesh& mesh, const std::array<std::uint16_t, 4>& around, const Vec3& outward) {
    add_triangle(mesh, around[0], around[1], around[2], outward);
    add_triangle(mesh, around[0], around[2], around[3], outward);
}

} // namespace

Mesh sphere_mesh(int subdivisions) {
    const float t = 0.5f * (1.0f + std::sqrt(5.0f));
    std::vector<Vec3> points{{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                             {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
    for (Vec3& point : points) point = glm::normalize(point);
    std::vector<std::uint16_t> triangles{0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                         4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                         6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
    for (int level = 0; level < subdivisions; ++level) {
        std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint16_t> middles;
        const auto middle = [&](std::uint16_t a, std::uint16_t b) -> std::uint16_t {
            const auto [place, is_new] =
                middles.try_emplace({std::min(a, b), std::max(a, b)}, std::uint16_t(points.size()));
            if (is_new) points.push_back(glm::normalize(points[a] + points[b]));
            return place->second;
        };
        std::vector<std::uint16_t> finer;
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            const std::uint16_t a = triangles[i], b = triangles[i + 1], c = triangles[i + 2];
            const std::uint16_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
        }
        triangles = std::move(finer);
    }
    Mesh mesh;
    for (const Vec3& point : points) mesh.vertices.push_back({point, Vec3(0.0f), point});
    mesh.indices = std::move(triangles);
    return mesh;
}

Mesh box_mesh() {
    Mesh mesh;
    // At each corner one vertex for each of its three faces, moved inwards along the other two axes.
    const auto index_of = [](int corner, int axis) { return std::uint16_t(3 * corner + axis); };
    const auto sign = [](int corner, int axis) { return (corner >> axis) & 1 ? 1.0f : -1.0f; };
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 signs(sign(corner, 0), sign(corner, 1), sign(corner, 2));
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 inset = signs, normal(0.0f);
            inset[axis] = 0.0f;
            normal[axis] = signs[axis];
            mesh.vertices.push_back({signs, inset, normal});
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        const int u = 1 << ((axis + 1) % 3), v = 1 << ((axis + 2) % 3), w = 1 << axis;
        for (const int side : {0, w}) { // the two faces across this axis
            Vec3 outward(0.0f);
            outward[axis] = side ? 1.0f : -1.0f;
            add_quad(mesh,
                     {index_of(side, axis), index_of(side | u, axis), index_of(side | u | v, axis),
                      index_of(side | v, axis)},
                     outward);
        }
        const int u_axis = (axis + 1) % 3, v_axis = (axis + 2) % 3;
        for (const int edge : {0, u, v, u | v}) { // the four edges along this axis
            Vec3 outward(0.0f);
            outward[u_axis] = sign(edge, u_axis);
            outward[v_axis] = sign(edge, v_axis);
            add_quad(mesh,
                     {index_of(edge, u_axis), index_of(edge, v_axis), index_of(edge | w, v_axis),
                      index_of(edge | w, u_axis)},
                     outward);
        }
    }
    for (int corner = 0; corner < 8; ++corner)
        add_triangle(mesh, index_of(corner, 0), index_of(corner, 1), index_of(corner, 2),
                     mesh.vertices[index_of(corner, 0)].corner);
    return mesh;
}

Mesh rectangle_mesh() {
    const Vec3 up(0.0f, 1.0f, 0.0f), none(0.0f);
    Mesh mesh;
    mesh.vertices = {{{-1, 0, -1}, none, up}, {{-1, 0, 1}, none, up}, {{1, 0, 1}, none, up}, {{1, 0, -1}, none, up}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

} // namespace cairn::viewer
