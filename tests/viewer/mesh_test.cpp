#include "viewer/meshes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <map>
#include <utility>

namespace {

using namespace cairn;
using namespace cairn::viewer;

constexpr float bevel = 0.1f;

Vec3 place(const TriangleMesh& mesh, std::size_t i) {
    const MeshVertex& vertex = mesh.vertices[mesh.indices[i]];
    return vertex.corner - vertex.inset * bevel;
}

// Volume by the divergence theorem; positive if the triangles face outwards.
double volume(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        sum += glm::dot(place(mesh, i), glm::cross(place(mesh, i + 1), place(mesh, i + 2))) / 6.0;
    return sum;
}

// In a closed surface every edge is used once in each direction.
bool is_closed(const TriangleMesh& mesh) {
    std::map<std::pair<int, int>, int> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{mesh.indices[i + k], mesh.indices[i + (k + 1) % 3]}];
    for (const auto& [edge, count] : edges)
        if (count != 1 || edges.count({edge.second, edge.first}) != 1) return false;
    return true;
}

TEST(Meshes, SphereIsClosedRoundAndOutwards) {
    double before = 0.0;
    for (int level = 0; level <= 4; ++level) {
        const TriangleMesh mesh = sphere_mesh(level);
        EXPECT_EQ(mesh.indices.size(), std::size_t(60) << (2 * level));
        EXPECT_TRUE(is_closed(mesh));
        for (const MeshVertex& vertex : mesh.vertices) EXPECT_NEAR(glm::length(vertex.corner), 1.0f, 1e-5f);
        EXPECT_GT(volume(mesh), before);
        before = volume(mesh);
    }
    EXPECT_NEAR(before, 4.18879, 0.02);
}

TEST(Meshes, BeveledBoxIsClosedAndOutwards) {
    const TriangleMesh mesh = box_mesh();
    EXPECT_EQ(mesh.indices.size(), 3u * 44u);
    EXPECT_TRUE(is_closed(mesh));
    // The box without its twelve edges (prisms b^2/2 x (2-2b)) and eight corners (b^3 less b^3/6 each).
    const double b = bevel;
    EXPECT_NEAR(volume(mesh), 8.0 - 12.0 * 0.5 * b * b * (2.0 - 2.0 * b) - 8.0 * b * b * b * (5.0 / 6.0), 1e-5);
}

TEST(Meshes, CapsuleIsClosedWithAPoleAtEachEnd) {
    const TriangleMesh mesh = capsule_mesh(12, 4);
    EXPECT_EQ(mesh.vertices.size(), 2u * (4u * 12u + 1u));
    EXPECT_EQ(mesh.indices.size(), 3u * 4u * 4u * 12u);
    EXPECT_TRUE(is_closed(mesh));
}

TEST(Meshes, CylinderIsClosed) {
    const TriangleMesh mesh = cylinder_mesh(12);
    EXPECT_EQ(mesh.vertices.size(), 2u * (2u * 12u + 1u));
    EXPECT_EQ(mesh.indices.size(), 3u * 8u * 12u);
    EXPECT_TRUE(is_closed(mesh));
}

TEST(Meshes, RectangleFacesUp) {
    const TriangleMesh mesh = rectangle_mesh();
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        EXPECT_GT(glm::cross(place(mesh, i + 1) - place(mesh, i), place(mesh, i + 2) - place(mesh, i)).y, 0.0f);
}

} // namespace
