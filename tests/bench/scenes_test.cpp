#include "bench/mass.h"
#include "bench/quality.h"
#include "bench/scenes.h"

#include <gtest/gtest.h>

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
        {"terrain", 2000},       {"props", 1500},      {"capsules", 3000},
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
