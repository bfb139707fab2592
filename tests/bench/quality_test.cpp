#include "bench/quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace cairn::bench;
using cairn::Position;
using cairn::Quat;
using cairn::Vec3;

PlacedPart sphere_at(Position center, float radius) {
    Part part;
    part.shape = PartShape::sphere;
    part.radius = radius;
    return place(part, {center, {}, {}, {}});
}

PlacedPart box_at(Position center, Vec3 half_extents, Quat rotation = Quat(1, 0, 0, 0)) {
    Part part;
    part.half_extents = half_extents;
    return place(part, {center, rotation, {}, {}});
}

Quat turn(Vec3 axis, double angle) {
    const double s = std::sin(angle / 2);
    return Quat(float(std::cos(angle / 2)), float(axis.x * s), float(axis.y * s), float(axis.z * s));
}

TEST(BenchPenetration, of_two_spheres_is_the_overlap_of_their_radii) {
    EXPECT_NEAR(penetration(sphere_at({0, 0, 0}, 1), sphere_at({1.5, 0, 0}, 1)), 0.5, 1e-12);
    EXPECT_NEAR(penetration(sphere_at({0, 0, 0}, 1), sphere_at({0, 3, 0}, 0.5)), -1.5, 1e-12);
}

TEST(BenchPenetration, of_a_sphere_and_a_box_counts_from_the_nearest_feature) {
    const PlacedPart box = box_at({0, 0, 0}, {1, 2, 3});
    EXPECT_NEAR(penetration(sphere_at({1.25, 0, 0}, 0.5), box), 0.25, 1e-12);           // face
    EXPECT_NEAR(penetration(box, sphere_at({1.25, 0, 0}, 0.5)), 0.25, 1e-12);           // in either order
    EXPECT_NEAR(penetration(sphere_at({1.3, 2.4, 0}, 0.75), box), 0.25, 1e-6);          // edge, 0.5 away
    EXPECT_NEAR(penetration(sphere_at({1 + 2.0, 2 + 1.0, 3 + 2.0}, 1), box), -2, 1e-9); // corner, 3 away
    EXPECT_NEAR(penetration(sphere_at({0.75, 0, 0}, 0.5), box), 0.75, 1e-12);           // center inside
}

TEST(BenchPenetration, of_boxes_is_least_along_a_face_or_an_edge) {
    const PlacedPart box = box_at({0, 0, 0}, {0.5f, 0.5f, 0.5f});
    EXPECT_NEAR(penetration(box, box_at({0.25, 0.9, 0.1}, {0.5f, 0.5f, 0.5f})), 0.1, 1e-9);
    EXPECT_NEAR(penetration(box, box_at({0.25, 1.2, 0.1}, {0.5f, 0.5f, 0.5f})), -0.2, 1e-9);
    // An edge pointing down, as deep as the half diagonal reaches.
    const double reach = std::sqrt(0.5);
    const PlacedPart on_edge =
        box_at({0, 0.5 + reach - 0.05, 0}, {0.5f, 0.5f, 0.5f}, turn({0, 0, 1}, std::acos(0.0) / 2));
    EXPECT_NEAR(penetration(box, on_edge), 0.05, 1e-6);
    // Two edges across each other: only the axis of both edges tells.
    const double quarter = std::acos(0.0) / 2;
    const PlacedPart along_z = box_at({0, 0, 0}, {0.5f, 0.5f, 2}, turn({0, 0, 1}, quarter));
    const PlacedPart along_x = box_at({0, 2 * reach - 0.03, 0}, {2, 0.5f, 0.5f}, turn({1, 0, 0}, quarter));
    EXPECT_NEAR(penetration(along_z, along_x), 0.03, 1e-6);
}

TEST(BenchPenetration, of_boxes_is_symmetric_and_no_shorter_move_separates_them) {
    std::mt19937 random(7);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    int overlapping = 0;
    for (int i = 0; i < 500; ++i) {
        const auto any_box = [&](Position center) {
            const glm::dvec3 axis = glm::normalize(glm::dvec3(between(-1, 1), between(-1, 1), between(0.1, 1)));
            return box_at(center, Vec3(between(0.2, 1), between(0.2, 1), between(0.2, 1)),
                          turn(Vec3(axis), between(0, 3)));
        };
        const PlacedPart a = any_box({0, 0, 0}), b = any_box({between(-1, 1), between(-1, 1), between(-1, 1)});
        const double depth = penetration(a, b);
        EXPECT_NEAR(depth, penetration(b, a), 1e-12);
        if (depth <= 0.01) continue;
        ++overlapping;
        // No move by less than the depth sets them apart.
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 20; ++k) {
            const glm::dvec3 way = glm::normalize(glm::dvec3(between(-1, 1), between(-1, 1), between(-1, 1)));
            PlacedPart moved = b;
            moved.center += 0.99 * depth * way;
            least = std::min(least, penetration(a, moved));
        }
        EXPECT_GT(least, 0);
    }
    EXPECT_GT(overlapping, 100);
}

TEST(BenchPenetration, of_a_scene_covers_every_kind_of_pair_once) {
    Scene scene = make_scene("tower", 3);
    std::vector<BodyState> states;
    for (const SceneBody& body : scene.bodies) states.push_back({Position(body.position), body.rotation, {}, {}});
    states[1].position.y -= 0.01; // into the floor, and away from the box above
    states[3].position.y -= 0.03; // into the box below
    const Penetrations p = measure_penetrations(scene, states);
    EXPECT_EQ(p.overlaps, 2u);
    EXPECT_NEAR(p.greatest, 0.03, 1e-6);
    EXPECT_NEAR(p.mean, 0.02, 1e-6);
}

TEST(BenchQuality, tells_drift_from_sag) {
    const Scene scene = make_scene("tower", 2);
    std::vector<BodyState> states;
    for (const SceneBody& body : scene.bodies) states.push_back({Position(body.position), body.rotation, {}, {}});
    states[1].position += Position(0.3, 0, 0.4);
    states[2].position += Position(0.1, -0.2, 0);
    const Displacement d = measure_displacement(scene, states);
    EXPECT_NEAR(d.drift, 0.5, 1e-12);
    EXPECT_NEAR(d.sag, 0.2, 1e-12);
}

TEST(BenchQuality, counts_what_is_lost) {
    const Scene scene = make_scene("pile_boxes", 20);
    std::vector<BodyState> states;
    for (const SceneBody& body : scene.bodies) states.push_back({Position(body.position), body.rotation, {}, {}});
    EXPECT_EQ(count_lost(scene, states), 0u);
    states.back().position.y = -10;
    states[states.size() - 2].linear_velocity.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(count_lost(scene, states), 2u);
}

TEST(BenchQuality, adds_up_linear_and_rotational_energy) {
    const Scene scene = make_scene("tower", 1); // 1000 kg, side 1 m: moment 1000/6 kg m^2
    std::vector<BodyState> states(scene.bodies.size());
    states[1].linear_velocity = {0, 2, 0};
    states[1].angular_velocity = {3, 0, 0};
    EXPECT_NEAR(measure_kinetic_energy(scene, states), 0.5 * 1000 * 4 + 0.5 * 1000.0 / 6 * 9, 1e-3);
}

} // namespace
