// The triangles of hulls, meshes and height fields.
#include "viewer/shape_meshes.h"

#include "test_scene.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;

using Corner = std::tuple<float, float, float>;

Corner corner(const TriangleMesh& mesh, std::size_t i) {
    const Vec3& p = mesh.vertices[mesh.indices[i]].corner;
    return {p.x, p.y, p.z};
}

// Whether every edge is used once in each direction; vertices are identified by their positions.
bool is_closed_mesh(const TriangleMesh& mesh) {
    std::map<std::pair<Corner, Corner>, int> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{corner(mesh, i + k), corner(mesh, i + (k + 1) % 3)}];
    return std::all_of(edges.begin(), edges.end(), [&](const auto& item) {
        return item.second == 1 && edges.count({item.first.second, item.first.first}) == 1;
    });
}

double volume_of_mesh(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto place = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]].corner; };
        sum += glm::dot(place(0), glm::cross(place(1), place(2))) / 6.0;
    }
    return sum;
}

// The least cosine of the angle between a triangle's normal and its vertex normals.
float min_agreement(const TriangleMesh& mesh) {
    float least = 1.0f;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto vertex = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]]; };
        const Vec3 flat =
            glm::normalize(glm::cross(vertex(1).corner - vertex(0).corner, vertex(2).corner - vertex(0).corner));
        for (std::size_t k = 0; k < 3; ++k) least = std::min(least, glm::dot(flat, vertex(k).normal));
    }
    return least;
}

TEST(ShapeMeshes, HullsAreClosedFlatAndOutwards) {
    const Hull cube(test::cube_corners());
    const TriangleMesh mesh = hull_triangles(cube);
    EXPECT_EQ(mesh.vertices.size(), 24u); // four for each face
    EXPECT_EQ(mesh.indices.size(), 36u);
    EXPECT_TRUE(is_closed_mesh(mesh));
    EXPECT_NEAR(volume_of_mesh(mesh), 8.0, 1e-4);
    EXPECT_GT(min_agreement(mesh), 0.9999f);
}

TEST(ShapeMeshes, RoundedShapesAreClosedSmoothAndFillTheirVolume) {
    Hull hull(test::cube_corners()); // of 2 m
    hull.rounding = 0.5f;
    const float pi = 3.14159265f;
    const struct {
        Shape shape;
        double volume;
    } cases[] = {{hull, 8.0 + 24.0 * 0.5 + 6.0 * pi * 0.25 + 4.0 / 3.0 * pi * 0.125},
                 {Box{{1.0f, 1.0f, 1.0f}, 0.5f}, 8.0 + 24.0 * 0.5 + 6.0 * pi * 0.25 + 4.0 / 3.0 * pi * 0.125},
                 // Pappus's theorem: the rim is a quarter disk that is revolved; both ends together are half a disk.
                 {Cylinder{1.0f, 1.0f, {}, 0.25f},
                  pi * 1.25 * 1.25 * 2.0 + 2.0 * pi * 0.25 + pi * (pi * 0.0625 + 4.0 / 3.0 * 0.25 * 0.0625)}};
    for (const auto& c : cases) {
        const TriangleMesh mesh = rounded_shape_triangles(c.shape);
        EXPECT_TRUE(is_closed_mesh(mesh)) << c.shape.index();
        EXPECT_NEAR(volume_of_mesh(mesh) / c.volume, 1.0, 0.012) << c.shape.index();
        EXPECT_LT(volume_of_mesh(mesh), c.volume) << c.shape.index();
        EXPECT_GT(min_agreement(mesh), 0.9f) << c.shape.index();
    }
    EXPECT_TRUE(rounded_shape_triangles(Box{}).indices.empty());
}

TEST(ShapeMeshes, RoundedShapesThatAreAlikeShareAMesh) {
    MeshCache cache;
    EXPECT_EQ(cache.mesh_of(Box{}), nullptr);
    const auto first = cache.mesh_of(Box{Vec3(0.5f), 0.1f});
    ASSERT_NE(first, nullptr);
    EXPECT_NEAR(first->extent.x, 0.6f, 1e-6f);
    EXPECT_EQ(cache.mesh_of(Box{Vec3(0.5f), 0.1f}), first);
    EXPECT_NE(cache.mesh_of(Box{Vec3(0.5f), 0.2f}), first);
    Hull hull(test::cube_corners());
    const auto sharp = cache.mesh_of(hull);
    hull.rounding = 0.1f;
    EXPECT_NE(cache.mesh_of(hull), sharp);
    EXPECT_EQ(cache.size(), 4u);
}

TEST(ShapeMeshes, SharpEdgesStaySharp) {
    const cairn::Mesh cube = test::cube_surface();
    const TriangleMesh mesh = surface_triangles(cube.vertices(), cube.indices());
    EXPECT_EQ(mesh.vertices.size(), 24u);
    EXPECT_EQ(mesh.indices.size(), 36u);
    EXPECT_TRUE(is_closed_mesh(mesh));
    EXPECT_NEAR(volume_of_mesh(mesh), 8.0, 1e-4);
    EXPECT_GT(min_agreement(mesh), 0.9999f);
}

TEST(ShapeMeshes, RoundSurfacesAreSmooth) {
    std::vector<Vec3> points{{0, -1, 0}};
    std::vector<std::uint32_t> indices;
    constexpr std::uint32_t segments = 24, rings = 11;
    for (std::uint32_t ring = 0; ring < rings; ++ring)
        for (std::uint32_t i = 0; i < segments; ++i) {
            const float up = 3.1415927f * (float(ring + 1) / float(rings + 1) - 0.5f);
            const float around = 6.2831853f * float(i) / float(segments);
            points.emplace_back(std::cos(up) * std::sin(around), std::sin(up), std::cos(up) * std::cos(around));
            const std::uint32_t here = 1 + ring * segments + i, next = 1 + ring * segments + (i + 1) % segments;
            if (ring == 0)
                indices.insert(indices.end(), {0, next, here});
            else
                indices.insert(indices.end(), {here - segments, next - segments, next, here - segments, next, here});
            if (ring + 1 == rings) indices.insert(indices.end(), {here, next, 1 + rings * segments});
        }
    points.emplace_back(0, 1, 0);
    const TriangleMesh mesh = surface_triangles(points, indices);
    EXPECT_EQ(mesh.vertices.size(), points.size()); // triangles at a point share one vertex normal
    for (const MeshVertex& vertex : mesh.vertices) EXPECT_GT(glm::dot(vertex.normal, vertex.corner), 0.999f);
}

TEST(ShapeMeshes, NormalsDoNotDependOnHowAFaceIsCut) {
    // The end of a flat-topped ridge: the same quadrilateral, divided along either diagonal.
    const std::vector<Vec3> points{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}, {2, -0.3f, 0}, {2, -0.3f, 1}};
    const std::array<std::vector<std::uint32_t>, 2> cuts{
        {{0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4}, {0, 1, 2, 1, 3, 2, 2, 3, 5, 2, 5, 4}}};
    std::array<Vec3, 2> normals{};
    for (std::size_t i = 0; i < 2; ++i) {
        const TriangleMesh mesh = surface_triangles(points, cuts[i]);
        for (const MeshVertex& vertex : mesh.vertices)
            if (vertex.corner == points[3]) normals[i] = vertex.normal;
    }
    EXPECT_GT(normals[0].x, 0.05f);
    EXPECT_LT(glm::distance(normals[0], normals[1]), 1e-5f);
}

TEST(ShapeMeshes, AFanOfManyTrianglesIsBuiltQuickly) {
    std::vector<Vec3> points{{0, 80, 0}}; // a cone: no two triangles have the same slope
    std::vector<std::uint32_t> indices;
    constexpr std::uint32_t count = 200000; // all triangles share one vertex: the time must not be quadratic
    for (std::uint32_t i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * i / count;
        points.push_back({float(100.0 * std::cos(angle)), 0.0f, float(-100.0 * std::sin(angle))});
        indices.insert(indices.end(), {0u, 1u + i, 1u + (i + 1) % count});
    }
    const TriangleMesh mesh = surface_triangles(points, indices);
    EXPECT_EQ(mesh.indices.size(), indices.size());
    EXPECT_GT(min_agreement(mesh), 0.999f);
}

TEST(ShapeMeshes, HeightFieldsLieWhereTheirHeightsAre) {
    const std::vector<float> heights{0, 1, 2, 0, 1, 2}; // three columns, two rows: a ramp along x
    const TriangleMesh mesh = height_field_triangles(HeightField(3, 2, {2.0f, 1.0f}, heights));
    ASSERT_EQ(mesh.vertices.size(), 6u);
    EXPECT_EQ(mesh.vertices[0].corner, Vec3(-2.0f, 0.0f, -0.5f));
    EXPECT_EQ(mesh.vertices[5].corner, Vec3(2.0f, 2.0f, 0.5f));
    ASSERT_EQ(mesh.indices.size(), 12u);
    EXPECT_GT(min_agreement(mesh), 0.9999f); // upwards, and equal over the whole ramp
    // Each cell is divided from its corner of least x and z to the opposite one.
    for (std::size_t i = 0; i < 12; i += 3) {
        int ends = 0;
        for (std::size_t k = 0; k < 3; ++k) ends += mesh.indices[i + k] == i / 6 || mesh.indices[i + k] == i / 6 + 4;
        EXPECT_EQ(ends, 2);
    }
}

TEST(ShapeMeshes, HolesOfHeightFieldsAreNotDrawn) {
    std::vector<float> heights(25, 1.0f);
    heights[12] = HeightField::hole;
    const HeightField field(5, 5, {1.0f, 1.0f}, heights);
    const TriangleMesh mesh = height_field_triangles(field);
    EXPECT_EQ(mesh.indices, field.indices());
    EXPECT_GT(min_agreement(mesh), 0.9999f);
    for (const auto& vertex : mesh.vertices)
        EXPECT_TRUE(std::isfinite(vertex.corner.y) && std::isfinite(vertex.normal.y));
}

TEST(ShapeMeshes, AFieldOfAMillionHeightsIsDrawnWhole) {
    constexpr int side = 1000;
    std::vector<float> heights(std::size_t(side) * side, 0.0f);
    heights.back() = 5.0f;
    const TriangleMesh mesh = height_field_triangles(HeightField(side, side, {1.0f, 1.0f}, heights));
    EXPECT_EQ(mesh.vertices.size(), heights.size());
    EXPECT_EQ(mesh.indices.size(), 6u * (side - 1) * (side - 1));
    EXPECT_EQ(*std::max_element(mesh.indices.begin(), mesh.indices.end()), heights.size() - 1);
    EXPECT_EQ(mesh.vertices.back().corner, Vec3(499.5f, 5.0f, 499.5f));
}

TEST(ShapeMeshes, AHugeFieldIsDrawnCoarserButToItsEdges) {
    constexpr int columns = 4002, rows = 2001;
    const std::vector<float> heights(std::size_t(columns) * rows, 1.0f);
    const TriangleMesh mesh = height_field_triangles(HeightField(columns, rows, {1.0f, 1.0f}, heights));
    EXPECT_LE(mesh.vertices.size(), max_heights);
    EXPECT_GT(mesh.vertices.size(), max_heights / 4);
    EXPECT_EQ(mesh.vertices.front().corner, Vec3(-2000.5f, 1.0f, -1000.0f));
    EXPECT_EQ(mesh.vertices.back().corner, Vec3(2000.5f, 1.0f, 1000.0f));
    EXPECT_GT(min_agreement(mesh), 0.9999f);
}

TEST(ShapeMeshes, VisualsKeepTheirNormalsOrAreFlat) {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<std::uint32_t> triangles{0, 1, 2, 0, 2, 3};
    const std::vector<Vec3> normals{{0, 0, 2}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
    const TriangleMesh shaded = visual_triangles(points, normals, triangles);
    ASSERT_EQ(shaded.vertices.size(), 4u);
    EXPECT_EQ(shaded.vertices[0].normal, Vec3(0.0f, 0.0f, 1.0f)); // normalized
    EXPECT_EQ(shaded.vertices[1].normal, Vec3(0.0f, 1.0f, 0.0f));
    EXPECT_EQ(shaded.indices, triangles);
    const TriangleMesh flat = visual_triangles(points, {}, triangles);
    ASSERT_EQ(flat.vertices.size(), 6u);
    EXPECT_EQ(flat.vertices[0].normal, Vec3(0.0f, 0.0f, 1.0f));
    EXPECT_EQ(flat.vertices[5].normal, Vec3(1.0f, 0.0f, 0.0f));
}

TEST(ShapeMeshes, TheBallAroundAMeshHoldsItAll) {
    const cairn::Mesh cube = test::cube_surface();
    const ShapeMesh mesh = make_shape_mesh(surface_triangles(cube.vertices(), cube.indices()), MeshVisual::surface);
    EXPECT_LT(glm::length(mesh.center), 1e-6f);
    EXPECT_NEAR(mesh.radius, std::sqrt(3.0f), 1e-5f);
}

TEST(MeshCache, MakesTheMeshOfSharedDataOnceAndDropsWhatIsUnused) {
    const Hull hull(test::cube_corners()), same_data = hull, other(test::cube_corners());
    MeshCache cache;
    const auto mesh = cache.mesh_of(hull);
    EXPECT_EQ(cache.mesh_of(same_data), mesh);
    EXPECT_NE(cache.mesh_of(other), mesh);
    EXPECT_EQ(cache.mesh_of(Sphere{}), nullptr);
    cache.drop_unused();
    EXPECT_EQ(cache.size(), 2u);
    EXPECT_EQ(cache.mesh_of(hull), mesh);
    cache.drop_unused();
    EXPECT_EQ(cache.size(), 1u);
    EXPECT_EQ(cache.mesh_of(hull), mesh);
}

} // namespace
