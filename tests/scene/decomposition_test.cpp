// Concave meshes of dynamic bodies, as convex parts.
#include "mesh_text.h"

#include "scene/decomposition.h"
#include "scene/mesh_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;

using std::numbers::pi;

struct Solid {
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> indices;

    void add_box(const glm::dvec3& center, const glm::dvec3& half, double turn = 0.0) {
        const std::uint32_t base = static_cast<std::uint32_t>(vertices.size());
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 p = center + half * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
            vertices.push_back(
                Vec3(std::cos(turn) * p.x - std::sin(turn) * p.y, std::sin(turn) * p.x + std::cos(turn) * p.y, p.z));
        }
        for (const std::uint32_t i : {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                      2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5}) {
            indices.push_back(base + i);
        }
    }
    void turn(const glm::dquat& q, const glm::dvec3& by) {
        for (Vec3& v : vertices) v = Vec3(q * glm::dvec3(v) + by);
    }
};

Solid water_wheel() { // a hub with eight paddles
    Solid solid;
    solid.add_box({0, 0, 0}, {0.2, 0.2, 0.2});
    for (int i = 0; i < 8; ++i) solid.add_box({0.6, 0, 0}, {0.5, 0.03, 0.2}, i * pi / 4);
    return solid;
}

Solid torus(int around, int across) {
    Solid solid;
    for (int i = 0; i < around * across; ++i) {
        const double a = 2 * pi * (i / across) / around, b = 2 * pi * (i % across) / across, r = 1 + 0.3 * std::cos(b);
        solid.vertices.push_back(Vec3(r * std::cos(a), r * std::sin(a), 0.3 * std::sin(b)));
    }
    const auto at = [&](int i, int k) { return static_cast<std::uint32_t>(i % around * across + k % across); };
    for (int i = 0; i < around; ++i) {
        for (int k = 0; k < across; ++k) {
            for (const std::uint32_t v :
                 {at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k), at(i + 1, k + 1), at(i, k + 1)}) {
                solid.indices.push_back(v);
            }
        }
    }
    return solid;
}

double volume(const std::vector<Hull>& parts) {
    double sum = 0.0;
    for (const Hull& part : parts) sum += part.volume();
    return sum;
}

// Whether a point, as a tiny ball, overlaps a body made of these parts.
bool is_in(const std::vector<Hull>& parts, const glm::dvec3& point) {
    World world;
    const BodyId body = world.create_body({.type = BodyType::static_});
    for (const Hull& part : parts) world.add_shape(body, part);
    return !world.overlap(Sphere{1e-4f}, {point, {1.0f, 0.0f, 0.0f, 0.0f}}).empty();
}

TEST(Decomposition, ConvexMeshesStayOneHull) {
    Solid box;
    box.add_box({1, 2, 3}, {0.5, 1.0, 2.0});
    EXPECT_EQ(scene::decompose(box.vertices, box.indices).size(), 1u);
    EXPECT_NEAR(volume(scene::decompose(box.vertices, box.indices)), 8.0, 1e-4);
    box.turn(glm::normalize(glm::dquat(0.7, 0.3, 0.2, 0.5)), {3, 2, 1});
    const std::vector<Hull> turned = scene::decompose(box.vertices, box.indices);
    EXPECT_NEAR(volume(turned), 8.0, 0.08); // the voxel steps may be taken for a dent, but must not add much volume
}

TEST(Decomposition, PartsComeNearTheSolidWhicheverWayItStands) {
    std::mt19937 random(3);
    std::normal_distribution<double> any;
    const double around = 48, across = 24; // number of flat faces around and across the torus
    const double exact = 0.5 * across * std::sin(2 * pi / across) * 0.09 * around * std::sin(2 * pi / around);
    for (int round = 0; round < 5; ++round) {
        Solid ring = torus(48, 24);
        const glm::dquat q = glm::normalize(glm::dquat(any(random), any(random), any(random), any(random)));
        const glm::dvec3 by(any(random), any(random), any(random));
        ring.turn(q, by);
        const std::vector<Hull> parts = scene::decompose(ring.vertices, ring.indices);
        EXPECT_GT(parts.size(), 5u);
        EXPECT_LE(parts.size(), 32u);
        EXPECT_NEAR(volume(parts) / exact, 1.0, 0.08);
        EXPECT_FALSE(is_in(parts, by)); // the hole
        for (int i = 0; i < 12; ++i) {
            const double a = i * pi / 6;
            EXPECT_TRUE(is_in(parts, q * glm::dvec3(std::cos(a), std::sin(a), 0.0) + by)) << round << " " << i;
            EXPECT_FALSE(is_in(parts, q * glm::dvec3(1.36 * std::cos(a), 1.36 * std::sin(a), 0.0) + by));
        }
    }
}

TEST(Decomposition, EqualMeshesGiveEqualPartsInBoundedTime) {
    const Solid wheel = water_wheel();
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<Hull> first = scene::decompose(wheel.vertices, wheel.indices),
                            second = scene::decompose(wheel.vertices, wheel.indices);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_TRUE(std::equal(first[i].vertices().begin(), first[i].vertices().end(), second[i].vertices().begin()));
    }
    for (const std::size_t most : {std::size_t{1}, std::size_t{2}, std::size_t{5}, std::size_t{64}}) {
        EXPECT_LE(scene::decompose(wheel.vertices, wheel.indices, {.max_parts = most}).size(), most);
    }
    // A soup of random triangles encloses no volume in particular, and must not take longer.
    std::mt19937 random(1);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    Solid noise;
    for (std::uint32_t i = 0; i < 30000; ++i) {
        noise.vertices.push_back({any(random), any(random), any(random)});
        noise.indices.push_back(i);
    }
    EXPECT_FALSE(scene::decompose(noise.vertices, noise.indices).empty());
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(elapsed.count(), 60.0);
}

// Without decomposition the wheel was its convex hull, a drum, and did not turn when balls fell on it.
TEST(Decomposition, AWaterWheelTurns) {
    const Solid wheel = water_wheel();
    MeshParts parts;
    std::vector<float> numbers;
    for (const Vec3& v : wheel.vertices) numbers.insert(numbers.end(), {v.x, v.y, v.z});
    std::vector<std::uint16_t> corners;
    for (const std::uint32_t i : wheel.indices) corners.push_back(static_cast<std::uint16_t>(i));
    parts.mesh(parts.positions(numbers), parts.indices(corners));
    parts.joints = R"({"limits":[{"linearAxes":[0,1,2],"min":0,"max":0},{"angularAxes":[0,1],"min":0,"max":0}]})";
    parts.nodes = node(R"("name":"wheel","children":[2],)", R"("motion":{},"collider":{"geometry":{"node":1}})") +
                  R"(,{"mesh":0},)" + node("", R"("joint":{"joint":0,"connectedNode":3})") + R"(,{})";
    parts.roots = "0,3";
    Scene scene = load_text(parts.text());
    const BodyId id = scene.world.find_body("wheel").value();
    EXPECT_GT(scene.world.body(id).shapes().size(), 8u);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("convex parts"), std::string::npos) << scene.warnings[0];
    for (int i = 0; i < 40; ++i) { // balls fall onto the paddles of one side
        const BodyId drop = scene.world.create_body({.position = {0.8, 1.5 + 0.4 * i, 0.0}});
        scene.world.add_shape(drop, Sphere{0.1f});
    }
    double turned = 0.0;
    for (int i = 0; i < 300; ++i) {
        scene.world.step(1.0f / 60.0f);
        turned -= static_cast<double>(scene.world.body(id).angular_velocity().z) / 60.0;
    }
    EXPECT_GT(turned, 2.0 * pi);
    const std::string saved = scene::save_to_string(scene);
    Scene again = load_text(saved);
    EXPECT_EQ(again.world.body(again.world.find_body("wheel").value()).shapes().size(),
              scene.world.body(id).shapes().size());
}

TEST(Decomposition, OtherFilesAreCutIfTheyOrTheUserAskForIt) {
    const Solid ring = torus(24, 12);
    scene::MeshFile mesh{ring.vertices, ring.indices};
    for (const bool asks : {false, true}) {
        scene::MeshImport options;
        options.decompose = asks;
        const Scene scene = scene_of_mesh(mesh, options, "ring");
        EXPECT_EQ(scene.world.body(scene.world.bodies().at(0)).shapes().size() > 1, asks);
    }
    std::string points, faces, counts;
    for (const Vec3& v : ring.vertices) {
        for (int k = 0; k < 3; ++k) points.append(std::to_string(v[k])).append(", ");
    }
    for (const std::uint32_t i : ring.indices) faces += std::to_string(i) + ", ";
    for (std::size_t i = 0; i < ring.indices.size() / 3; ++i) counts += "3, ";
    for (const char* way : {"convexHull", "convexDecomposition"}) {
        const Scene scene = load_text(
            "#usda 1.0\ndef Mesh \"m\" (prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsCollisionAPI\", "
            "\"PhysicsMeshCollisionAPI\"]) { uniform token physics:approximation = \"" +
                std::string(way) + "\"\n point3f[] points = [" + points + "]\n int[] faceVertexIndices = [" + faces +
                "]\n int[] faceVertexCounts = [" + counts + "] }",
            "ring.usda");
        const bool is_cut = std::string(way) == "convexDecomposition";
        EXPECT_EQ(scene.world.body(scene.world.bodies().at(0)).shapes().size() > 1, is_cut) << way;
    }
}

} // namespace
