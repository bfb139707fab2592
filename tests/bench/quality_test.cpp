#include "bench/mass.h"
#include "bench/quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace cairn::bench;
using cairn::Position;

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

std::vector<BodyState> states_at_start(const Scene& scene) {
    std::vector<BodyState> states;
    for (const SceneBody& body : scene.bodies) states.push_back({Position(body.position), body.rotation, {}, {}});
    return states;
}

TEST(BenchQuality, measures_the_distance_between_the_anchors_of_joints) {
    const Scene scene = make_scene("joint_grid", 2); // bodies 0 and 2 fixed; joints 0-1, 2-3, 1-3
    ASSERT_EQ(scene.joints.size(), 3u);
    std::vector<BodyState> states = states_at_start(scene);
    EXPECT_EQ(measure_joint_errors(scene, states).greatest, 0.0);
    states[1].position.y -= 0.03;
    EXPECT_NEAR(measure_joint_errors(scene, states).greatest, 0.03, 1e-12);
    EXPECT_NEAR(measure_joint_errors(scene, states).mean, 0.02, 1e-12);
    states[1].position.y += 0.03;
    // A quarter turn about z: the anchors 0.5 m above and beside the center move away from their counterparts.
    states[1].rotation = cairn::Quat(std::sqrt(0.5f), 0, 0, std::sqrt(0.5f));
    EXPECT_NEAR(measure_joint_errors(scene, states).greatest, std::sqrt(0.5), 1e-6);
    states[1].position.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(measure_joint_errors(scene, states).greatest, 0.0); // of joint 2-3, the only one with finite bodies
}

TEST(BenchPenetration, leaves_out_what_does_not_collide) {
    Scene scene = make_scene("ragdolls", 1); // limbs overlap at their joints
    std::vector<BodyState> states = states_at_start(scene);
    EXPECT_EQ(measure_penetrations(scene, states).overlaps, 0u);
    scene.joints.pop_back(); // a knee
    EXPECT_EQ(measure_penetrations(scene, states).overlaps, 1u);
    scene.collides = false;
    EXPECT_EQ(measure_penetrations(scene, states).overlaps, 0u);
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

TEST(BenchQuality, takes_the_inertia_of_a_compound_about_its_own_center) {
    // Two balls of 1 kg, 2 m apart, rotate about their common center: 2 * (0.4 r^2 + 1) kg m^2.
    Scene scene;
    const float density = 1 / (4.0f / 3.0f * 3.14159265f * 0.125f);
    SceneBody body = make_scene("tower", 1).bodies[1];
    Part ball;
    ball.shape = PartShape::sphere;
    ball.radius = 0.5f;
    ball.position = {5, 0, 0};
    scene.parts.push_back(ball);
    ball.position = {7, 0, 0};
    scene.parts.push_back(ball);
    const MassProperties mass =
        mass_of(scene, scene.parts[0], double(density)) + mass_of(scene, scene.parts[1], double(density));
    EXPECT_NEAR(mass.mass, 2, 1e-6);
    EXPECT_NEAR(mass.center.x, 6, 1e-12);
    body.part_count = 2;
    body.mass = float(mass.mass);
    body.inertia = cairn::Mat3(mass.inertia);
    scene.bodies = {body};
    std::vector<BodyState> states(1);
    states[0].angular_velocity = {0, 3, 0};
    EXPECT_NEAR(measure_kinetic_energy(scene, states), 0.5 * 2 * (0.4 * 0.25 + 1) * 9, 1e-4);
    // Rotated by a quarter turn about z, the world's y axis is the line through both centers: 2 * 0.4 r^2.
    states[0].rotation = cairn::Quat(std::sqrt(0.5f), 0, 0, std::sqrt(0.5f));
    EXPECT_NEAR(measure_kinetic_energy(scene, states), 0.5 * 2 * 0.4 * 0.25 * 9, 1e-4);
}

TEST(BenchQuality, does_not_count_overlaps_within_a_body) {
    Scene scene = make_scene("props", 30);
    std::vector<BodyState> states;
    for (const SceneBody& body : scene.bodies) states.push_back({Position(body.position), body.rotation, {}, {}});
    EXPECT_EQ(measure_penetrations(scene, states).overlaps, 0u);
    states[6].position = states[5].position + Position(0.01, 0, 0); // two bodies at almost the same position
    EXPECT_GT(measure_penetrations(scene, states).overlaps, 0u);
}

} // namespace
