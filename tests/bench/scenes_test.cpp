#include "bench/mass.h"
#include "bench/quality.h"
#include "bench/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace {

using namespace cairn::bench;
using cairn::Vec3;

std::vector<BodyState> initial_states(const Scene& scene) {
    std::vector<BodyState> states;
    for (const SceneBody& body : scene.bodies)
        states.push_back({cairn::Position(body.position), body.rotation, body.linear_velocity, body.angular_velocity});
    return states;
}

TEST(BenchScenes, have_the_dynamic_bodies_that_their_names_promise) {
    const std::map<std::string_view, std::size_t> expected = {
        {"pile_spheres", 8000},  {"pile_boxes", 5000}, {"pile_mixed", 5000}, {"pyramid", 820},  {"large_pyramid", 5050},
        {"many_pyramids", 5500}, {"tower", 40},        {"mass_ratio", 5},    {"tumbler", 2000}, {"convex", 1000},
        {"terrain", 2000},       {"props", 1500},      {"capsules", 3000},   {"chain", 20},     {"joint_grid", 4032},
        {"joint_swing", 4032},   {"ragdolls", 5500},
    };
    ASSERT_EQ(scene_kinds().size(), expected.size());
    for (const SceneKind& kind : scene_kinds()) {
        const Scene scene = make_scene(kind.name);
        std::size_t dynamic = 0;
        for (const SceneBody& body : scene.bodies) dynamic += body.motion == Motion::dynamic;
        EXPECT_EQ(dynamic, expected.at(kind.name)) << kind.name;
        EXPECT_EQ(scene.dynamic_count, dynamic) << kind.name;
    }
}

TEST(BenchScenes, follow_the_size_that_is_asked_for) {
    EXPECT_EQ(make_scene("pile_boxes", 1234).dynamic_count, 1234u);
    EXPECT_EQ(make_scene("pyramid", 10).dynamic_count, 55u);
    EXPECT_EQ(make_scene("many_pyramids", 2).dynamic_count, 220u);
    EXPECT_EQ(make_scene("tower", 7).dynamic_count, 7u);
    const Scene heavy = make_scene("mass_ratio", 10);
    EXPECT_FLOAT_EQ(heavy.bodies.back().mass, 10 * heavy.bodies[1].mass);
}

TEST(BenchScenes, refuse_a_wrong_name_or_size) {
    EXPECT_THROW(make_scene("pile"), SceneError);
    EXPECT_THROW(make_scene("pile_boxes", -1), SceneError);
    EXPECT_THROW(make_scene("tumbler", 2157), SceneError);
    EXPECT_EQ(make_scene("tumbler", 2156).dynamic_count, 2156u);
}

TEST(BenchScenes, are_the_same_each_time) {
    for (const SceneKind& kind : scene_kinds())
        EXPECT_EQ(hash_of(initial_states(make_scene(kind.name))), hash_of(initial_states(make_scene(kind.name))));
}

TEST(BenchScenes, begin_without_overlaps_and_within_their_bounds) {
    for (const SceneKind& kind : scene_kinds()) {
        const Scene scene = make_scene(kind.name);
        const std::vector<BodyState> states = initial_states(scene);
        EXPECT_LT(measure_penetrations(scene, states).greatest, 1e-5) << kind.name;
        EXPECT_EQ(count_lost(scene, states), 0u) << kind.name;
        EXPECT_EQ(measure_kinetic_energy(scene, states), 0.0) << kind.name; // the drum is not dynamic
    }
}

TEST(BenchScenes, begin_with_the_frames_of_every_joint_in_one_place) {
    for (const SceneKind& kind : scene_kinds()) {
        const Scene scene = make_scene(kind.name);
        EXPECT_LT(measure_joint_errors(scene, initial_states(scene)).greatest, 1e-5) << kind.name;
        for (const SceneJoint& joint : scene.joints) {
            const SceneBody &a = scene.bodies.at(joint.body_a), &b = scene.bodies.at(joint.body_b);
            ASSERT_TRUE(a.motion == Motion::dynamic || b.motion == Motion::dynamic) << kind.name;
            const cairn::Quat turn = glm::conjugate(a.rotation * joint.axes_a) * (b.rotation * joint.axes_b);
            ASSERT_LT(glm::length(Vec3(turn.x, turn.y, turn.z)), 1e-6f) << kind.name;
        }
    }
}

TEST(BenchScenes, join_every_sphere_of_a_net_to_its_neighbors) {
    for (const char* name : {"joint_grid", "joint_swing"}) {
        const Scene scene = make_scene(name);
        EXPECT_EQ(scene.joints.size(), 64u * 63 + 63 * 63) << name;
        EXPECT_FALSE(scene.collides);
        std::vector<int> joints_of(scene.bodies.size());
        for (const SceneJoint& joint : scene.joints) {
            const Vec3 way = scene.bodies[joint.body_b].position - scene.bodies[joint.body_a].position;
            EXPECT_FLOAT_EQ(glm::length(way), 1.0f);
            ++joints_of[joint.body_a], ++joints_of[joint.body_b];
        }
        for (std::size_t i = 0; i < scene.bodies.size(); ++i)
            EXPECT_GE(joints_of[i], scene.bodies[i].motion == Motion::fixed ? 1 : 2) << name;
    }
}

TEST(BenchScenes, drop_ragdolls_of_11_bodies_whose_masses_are_one_to_ten) {
    const Scene scene = make_scene("ragdolls", 7);
    ASSERT_EQ(scene.dynamic_count, 77u);
    ASSERT_EQ(scene.joints.size(), 70u);
    const std::size_t walls = scene.bodies.size() - scene.dynamic_count;
    float least = 1e9f, greatest = 0, sum = 0;
    for (std::size_t i = walls; i < walls + 11; ++i) {
        least = std::min(least, scene.bodies[i].mass);
        greatest = std::max(greatest, scene.bodies[i].mass);
        sum += scene.bodies[i].mass;
    }
    EXPECT_NEAR(greatest / least, 10, 0.5);
    EXPECT_NEAR(sum, 76, 2);
    std::size_t hinges = 0;
    std::vector<bool> hangs(scene.bodies.size());
    for (const SceneJoint& joint : scene.joints) {
        hinges += joint.kind == JointKind::hinge;
        EXPECT_EQ((joint.body_a - walls) / 11, (joint.body_b - walls) / 11); // joints within one ragdoll
        // The joints form a tree whose root is the pelvis.
        EXPECT_FALSE(hangs[joint.body_b]);
        hangs[joint.body_b] = true;
        EXPECT_TRUE(joint.kind == JointKind::hinge ? joint.angle.has_value() : joint.reach.has_value());
        const AngleRange range = joint.angle.value_or(AngleRange{});
        EXPECT_TRUE(range.lower <= 0 && range.upper >= 0);
    }
    EXPECT_EQ(hinges, 28u);
    EXPECT_EQ(std::count(hangs.begin(), hangs.end(), true), 70);
}

TEST(BenchScenes, give_bodies_the_mass_of_their_shape) {
    const Scene spheres = make_scene("pile_spheres", 1);
    EXPECT_NEAR(spheres.bodies.back().mass, 1000 * 3.14159265 / 6, 1e-3);
    const Scene boxes = make_scene("pile_boxes", 1);
    EXPECT_FLOAT_EQ(boxes.bodies.back().mass, 1000.0f);
    EXPECT_EQ(boxes.bodies.front().mass, 0.0f);
}

TEST(BenchScenes, drop_twenty_hulls_of_12_to_24_corners) {
    const Scene scene = make_scene("convex");
    ASSERT_EQ(scene.hulls.size(), 20u);
    for (const ConvexHull& hull : scene.hulls) {
        EXPECT_GE(hull.points.size(), 12u);
        EXPECT_LE(hull.points.size(), 24u);
        EXPECT_LT(glm::length(mass_of(hull).center), 1e-6);
    }
}

TEST(BenchScenes, drop_compounds_of_3_to_7_parts_with_their_mass_off_their_origin) {
    const Scene scene = make_scene("props");
    bool is_off = false;
    for (const SceneBody& body : scene.bodies) {
        if (body.motion != Motion::dynamic) continue;
        EXPECT_GE(body.part_count, 3u);
        EXPECT_LE(body.part_count, 7u);
        is_off = is_off || glm::length(body.center_of_mass) > 0.05f;
    }
    EXPECT_TRUE(is_off);
}

TEST(BenchScenes, have_terrain_of_20000_triangles_that_is_the_same_everywhere) {
    const SurfaceMesh mesh = make_scene("terrain").meshes.at(0);
    EXPECT_EQ(mesh.indices.size(), 3u * 20000);
    std::vector<BodyState> vertices;
    for (const Vec3& vertex : mesh.vertices) {
        BodyState state;
        state.position = cairn::Position(vertex);
        vertices.push_back(state);
    }
    EXPECT_EQ(hash_of(vertices), 2354352866128397056u);
}

} // namespace
