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
void add_triangle(TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, const Vec3& outward) {
    const auto place = [&mesh](std::uint32_t index) {
        return mesh.vertices[index].corner - mesh.vertices[index].inset * 0.1f;
    };
    if (glm::dot(glm::cross(place(b) - place(a), place(c) - place(a)), outward) < 0.0f) std::swap(b, c);
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

void add_quad(TriangleMesh& mesh, const std::array<std::uint32_t, 4>& around, const Vec3& outward) {
    add_triangle(mesh, around[0], around[1], around[2], outward);
    add_triangle(mesh, around[0], around[2], around[3], outward);
}

} // namespace

TriangleMesh sphere_mesh(int subdivisions) {
    const float t = 0.5f * (1.0f + std::sqrt(5.0f));
    std::vector<Vec3> points{{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                             {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
    for (Vec3& point : points) point = glm::normalize(point);
    std::vector<std::uint32_t> triangles{0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                         4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                         6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
    for (int level = 0; level < subdivisions; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) -> std::uint32_t {
            const auto [place, is_new] =
                middles.try_emplace({std::min(a, b), std::max(a, b)}, std::uint32_t(points.size()));
            if (is_new) points.push_back(glm::normalize(points[a] + points[b]));
            return place->second;
        };
        std::vector<std::uint32_t> finer;
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            const std::uint32_t a = triangles[i], b = triangles[i + 1], c = triangles[i + 2];
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
        }
        triangles = std::move(finer);
    }
    TriangleMesh mesh;
    for (const Vec3& point : points) mesh.vertices.push_back({point, Vec3(0.0f), point});
    mesh.indices = std::move(triangles);
    return mesh;
}

TriangleMesh box_mesh() {
    TriangleMesh mesh;
    // At each corner one vertex for each of its three faces, moved inwards along the other two axes.
    const auto index_of = [](int corner, int axis) { return std::uint32_t(3 * corner + axis); };
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

namespace {

// The direction from the axis to point `i` of a ring. The upper end's rings are turned by half a segment: the
// triangles between the ends then lean to neither side, which shows where the upper radius is zero.
Vec3 ring_direction(int i, int segments, float end) {
    const double angle = 6.283185307179586 * (i + (end > 0.0f ? 0.5 : 0.0)) / segments;
    return {float(std::cos(angle)), 0.0f, float(-std::sin(angle))};
}

// Appends a ring of vertices, and returns the index of the first.
std::uint32_t add_ring(TriangleMesh& mesh, int segments, float end, float part, bool faces_end) {
    const auto first = std::uint32_t(mesh.vertices.size());
    for (int i = 0; i < segments; ++i) {
        const Vec3 direction = ring_direction(i, segments, end);
        const Vec3 normal = faces_end ? Vec3(0.0f, end, 0.0f) : direction;
        mesh.vertices.push_back({direction + Vec3(0.0f, end, 0.0f), Vec3(part, 0.0f, 0.0f), normal});
    }
    return first;
}

std::uint32_t add_pole(TriangleMesh& mesh, float end, float part) {
    mesh.vertices.push_back({Vec3(0.0f, end, 0.0f), Vec3(part, 0.0f, 0.0f), Vec3(0.0f, end, 0.0f)});
    return std::uint32_t(mesh.vertices.size() - 1);
}

// The triangles between two rings, of which `upper` lies further along +y.
void join_rings(TriangleMesh& mesh, std::uint32_t lower, std::uint32_t upper, int segments) {
    for (int i = 0; i < segments; ++i) {
        const auto here = std::uint32_t(i), next = std::uint32_t((i + 1) % segments);
        mesh.indices.insert(mesh.indices.end(),
                            {lower + here, lower + next, upper + here, lower + next, upper + next, upper + here});
    }
}

void join_pole(TriangleMesh& mesh, std::uint32_t ring, std::uint32_t pole, int segments, float end) {
    for (int i = 0; i < segments; ++i) {
        const auto here = std::uint32_t(i), next = std::uint32_t((i + 1) % segments);
        if (end > 0.0f)
            mesh.indices.insert(mesh.indices.end(), {ring + here, ring + next, pole});
        else
            mesh.indices.insert(mesh.indices.end(), {ring + next, ring + here, pole});
    }
}

} // namespace

TriangleMesh capsule_mesh(int segments, int rings) {
    TriangleMesh mesh;
    std::array<std::uint32_t, 2> seams{};
    for (const float end : {-1.0f, 1.0f}) {
        std::uint32_t ring = add_ring(mesh, segments, end, 0.0f, false);
        seams[end > 0.0f] = ring;
        for (int k = 1; k < rings; ++k) {
            const std::uint32_t next = add_ring(mesh, segments, end, float(k) / float(rings), false);
            join_rings(mesh, end > 0.0f ? ring : next, end > 0.0f ? next : ring, segments);
            ring = next;
        }
        join_pole(mesh, ring, add_pole(mesh, end, 1.0f), segments, end);
    }
    join_rings(mesh, seams[0], seams[1], segments);
    return mesh;
}

TriangleMesh cylinder_mesh(int segments) {
    TriangleMesh mesh;
    std::array<std::uint32_t, 2> sides{};
    for (const float end : {-1.0f, 1.0f}) {
        const std::uint32_t rim = add_ring(mesh, segments, end, 1.0f, true);
        const std::uint32_t side = sides[end > 0.0f] = add_ring(mesh, segments, end, 2.0f, false);
        join_pole(mesh, rim, add_pole(mesh, end, 0.0f), segments, end);
        join_rings(mesh, end > 0.0f ? side : rim, end > 0.0f ? rim : side, segments);
    }
    join_rings(mesh, sides[0], sides[1], segments);
    return mesh;
}

TriangleMesh rectangle_mesh() {
    const Vec3 up(0.0f, 1.0f, 0.0f), none(0.0f);
    TriangleMesh mesh;
    mesh.vertices = {{{-1, 0, -1}, none, up}, {{-1, 0, 1}, none, up}, {{1, 0, 1}, none, up}, {{1, 0, -1}, none, up}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

} // namespace cairn::viewer
