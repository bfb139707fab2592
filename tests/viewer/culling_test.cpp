#include "viewer/culling.h"

#include "test_scene.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;

TEST(Culling, WhatIsInThePictureIsDrawn) {
    const ShapeMesh field = make_shape_mesh(height_field_triangles(test::hills(400, 0.5f)), MeshVisual::terrain);
    ASSERT_GT(field.parts.size(), 30u);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-90.0f, 90.0f), height(1.0f, 40.0f), unit(-1.0f, 1.0f);
    int left_out = 0;
    for (int i = 0; i < 30; ++i) {
        Instance instance;
        const Quat turn = glm::normalize(Quat(unit(random), unit(random), unit(random), unit(random)));
        instance.rotation = {turn.x, turn.y, turn.z, turn.w};
        instance.position = {place(random), 0.0f, place(random)};
        const OrbitCamera camera(
            CameraPose{{place(random), height(random), place(random)}, {place(random), height(random), place(random)}});
        const auto ranges = visible_ranges(field, std::span(&instance, 1),
                                           side_planes(camera.projection(test::aspect) * camera.view({0.0, 0.0, 0.0})));
        std::vector<bool> is_drawn(field.triangles.indices.size());
        for (const IndexRange& range : ranges)
            for (std::size_t k = range.first; k < range.first + range.count; ++k) is_drawn[k] = true;
        for (std::size_t k = 0; k < is_drawn.size(); k += 7) {
            const Vec3 corner = field.triangles.vertices[field.triangles.indices[k]].corner;
            const auto device = camera.project(Position(instance.position + turn * corner), test::aspect);
            const bool is_seen = device && std::abs(device->x) < 1.0f && std::abs(device->y) < 1.0f;
            ASSERT_TRUE(is_drawn[k] || !is_seen);
            left_out += !is_drawn[k];
        }
    }
    EXPECT_GT(left_out, 0);
}

TEST(Culling, MostOfALargeFieldIsLeftOutFromNearby) {
    const ShapeMesh field = make_shape_mesh(height_field_triangles(test::hills(1000, 1.0f)), MeshVisual::terrain);
    // Looks at a corner of the field.
    const OrbitCamera camera(CameraPose{{-480.0, 5.0, -480.0}, {-490.0, 2.0, -490.0}});
    const Instance instance;
    std::size_t drawn = 0;
    for (const IndexRange& range :
         visible_ranges(field, std::span(&instance, 1),
                        side_planes(camera.projection(test::aspect) * camera.view({0.0, 0.0, 0.0}))))
        drawn += range.count;
    EXPECT_GT(drawn, 0u);
    EXPECT_LT(drawn, field.triangles.indices.size() / 20);
}

TEST(Culling, PartsCoverAMeshInOrder) {
    const ShapeMesh field = make_shape_mesh(height_field_triangles(test::hills(150, 1.0f)), MeshVisual::terrain);
    std::size_t next = 0;
    for (const MeshPart& part : field.parts) {
        EXPECT_EQ(part.first, next);
        next += part.count;
        EXPECT_LE(part.count, 3 * triangles_per_part);
        for (std::size_t k = part.first; k < next; ++k) {
            const Vec3 corner = field.triangles.vertices[field.triangles.indices[k]].corner;
            EXPECT_LE(glm::distance(corner, part.center), part.radius * 1.00001f);
        }
    }
    EXPECT_EQ(next, field.triangles.indices.size());
}

} // namespace
