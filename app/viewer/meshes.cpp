#include "viewer/meshes.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace cairn::viewer {

namespace {

// Appends two triangles; `around`: counterclockwise as seen from outside.
void add_quad(TriangleMesh& mesh, const std::array<std::uint32_t, 4>& around) {
    mesh.indices.insert(mesh.indices.end(), {around[0], around[1], around[2], around[0], around[2], around[3]});
}

} // namespace

TriangleMesh cap_mesh(int segments, int rings) {
    TriangleMesh mesh;
    const Vec3 none(0.0f), towards(0.0f, 0.0f, 1.0f);
    mesh.vertices.push_back({none, none, towards});
    for (int ring = 1; ring <= rings; ++ring) {
        const auto first = std::uint32_t(mesh.vertices.size());
        for (int i = 0; i < segments; ++i) {
            const double angle = 6.283185307179586 * i / segments;
            const auto here = std::uint32_t(i), next = std::uint32_t((i + 1) % segments);
            mesh.vertices.push_back(
                {Vec3(float(std::cos(angle)), float(std::sin(angle)), float(ring) / float(rings)), none, towards});
            if (ring == 1)
                mesh.indices.insert(mesh.indices.end(), {0, first + here, first + next});
            else
                add_quad(mesh, {first + here, first + next, first - std::uint32_t(segments) + next,
                                first - std::uint32_t(segments) + here});
        }
    }
    return mesh;
}

TriangleMesh box_mesh() {
    TriangleMesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            Vec3 normal(0.0f), u(0.0f), v(0.0f);
            normal[axis] = side;
            u[(axis + 1) % 3] = side;
            v[(axis + 2) % 3] = 1.0f;
            const auto first = std::uint32_t(mesh.vertices.size());
            for (const Vec3& corner : {normal - u - v, normal + u - v, normal + u + v, normal - u + v})
                mesh.vertices.push_back({corner, Vec3(0.0f), normal});
            add_quad(mesh, {first, first + 1, first + 2, first + 3});
        }
    return mesh;
}

namespace {

// The direction from the axis to point `i` of a ring. The upper end's rings are rotated by half a segment, so that the
// triangles between the ends are symmetric; asymmetry would be visible where the upper radius is zero.
Vec3 ring_direction(int i, int segments, float end) {
    const double angle = 6.283185307179586 * (i + (end > 0.0f ? 0.5 : 0.0)) / segments;
    return {float(std::cos(angle)), 0.0f, float(-std::sin(angle))};
}

// Appends a ring of vertices, and returns the index of the first one.
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

// Appends the triangles between two rings; `upper` has the greater y.
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
