#include "viewer/meshes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

namespace {

using namespace cairn;
using namespace cairn::viewer;

Vec3 place(const TriangleMesh& mesh, std::size_t i) { return mesh.vertices[mesh.indices[i]].corner; }

// Volume by the divergence theorem; positive if the triangles face outwards.
double volume(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        sum += glm::dot(place(mesh, i), glm::cross(place(mesh, i + 1), place(mesh, i + 2))) / 6.0;
    return sum;
}

// A surface is closed if every edge is used once in each direction.
bool is_closed(const TriangleMesh& mesh) {
    std::map<std::pair<int, int>, int> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{mesh.indices[i + k], mesh.indices[i + (k + 1) % 3]}];
    for (const auto& [edge, count] : edges)
        if (count != 1 || edges.count({edge.second, edge.first}) != 1) return false;
    return true;
}

TEST(Meshes, CapIsADiskThatFacesTheViewer) {
    for (const auto& [segments, rings] : {std::pair(3, 1), {10, 1}, {24, 2}, {96, 6}}) {
        const TriangleMesh mesh = cap_mesh(segments, rings);
        EXPECT_EQ(mesh.indices.size(), 3u * std::size_t(segments * (2 * rings - 1)));
        double area = 0.0;
        const auto flat = [&](std::size_t i) {
            const Vec3 corner = mesh.vertices[mesh.indices[i]].corner;
            return Vec3(corner.x * corner.z, corner.y * corner.z, 0.0f);
        };
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const float twice = glm::cross(flat(i + 1) - flat(i), flat(i + 2) - flat(i)).z;
            EXPECT_GT(twice, 0.0f);
            area += 0.5 * twice;
        }
        EXPECT_NEAR(area, 0.5 * segments * std::sin(6.283185307179586 / segments), 1e-5);
    }
}

TEST(Meshes, BoxFacesOutwards) {
    const TriangleMesh mesh = box_mesh();
    EXPECT_EQ(mesh.indices.size(), 3u * 12u);
    EXPECT_NEAR(volume(mesh), 8.0, 1e-5);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3 area = glm::cross(place(mesh, i + 1) - place(mesh, i), place(mesh, i + 2) - place(mesh, i));
        EXPECT_LT(glm::distance(glm::normalize(area), mesh.vertices[mesh.indices[i]].normal), 1e-6f);
    }
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
