#include "viewer/samples.h"
#include "viewer/stage.h"

#include "test_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace cairn;
using namespace cairn::viewer;

constexpr double all = std::numeric_limits<double>::infinity();

double value(const Sample& sample, Quantity quantity) { return sample.values[std::size_t(quantity)]; }

TEST(Samples, AreWhatTheLawsSay) {
    World world;
    BodyDef def = test::body_at({0.0, 100.0, 0.0});
    def.linear_velocity = {3.0f, 0.0f, 0.0f};
    def.mass = 2.0f;
    const BodyId id = world.create_body(def);
    world.add_shape(id, Sphere{});
    const Sample start = measure(world, id, 0, 1.0 / 60.0);
    for (int i = 0; i < 60; ++i) world.step(1.0f / 60.0f);
    const Sample end = measure(world, id, 60, 1.0 / 60.0);
    EXPECT_NEAR(value(start, Quantity::kinetic_energy), 9.0, 1e-6);
    EXPECT_NEAR(value(start, Quantity::potential_energy), 2.0 * 9.81 * 100.0, 1e-3);
    EXPECT_NEAR(value(end, Quantity::total_energy) / value(start, Quantity::total_energy), 1.0, 1e-3);
    EXPECT_NEAR(value(end, Quantity::momentum_y), -2.0 * 9.81, 1e-3);
    EXPECT_NEAR(value(end, Quantity::body_velocity_y), -9.81, 1e-3);
    EXPECT_NEAR(value(end, Quantity::body_x), 3.0, 1e-4);
    EXPECT_NEAR(value(start, Quantity::angular_momentum_z), -2.0 * 3.0 * 100.0, 1e-3);
    EXPECT_TRUE(std::isnan(value(measure(world, {}, 60, 1.0 / 60.0), Quantity::body_x)));
}

TEST(Samples, WhatRestsPressesWithItsWeight) {
    LoadedScene scene = test::boxes_on_plane(1);
    const BodyId box = scene.world.bodies().back();
    for (int i = 0; i < 30; ++i) scene.world.step(1.0f / 60.0f);
    const double weight = 9.81 * double(scene.world.body(box).mass());
    EXPECT_NEAR(value(measure(scene.world, box, 30, 1.0 / 60.0), Quantity::body_contact_force), weight, 0.01 * weight);
}

// Energies at the end, and the drift of the energy balance since the start.
struct Balance {
    double kinetic, friction, impacts, external_work, drift;
    explicit Balance(const Stage& stage) {
        const SampleLog log = stage.state().samples;
        const Sample &start = log[0], &end = log[log.size() - 1];
        kinetic = value(end, Quantity::kinetic_energy);
        friction = value(end, Quantity::lost_to_friction);
        impacts = value(end, Quantity::lost_in_impacts);
        external_work = value(end, Quantity::external_work);
        drift = value(end, Quantity::energy_balance) - value(start, Quantity::energy_balance);
    }
};

// A box at rest on a plane, in which state the first sample is taken.
struct SampledBox : Stage {
    SampledBox() : Stage(test::load_boxes, "1") {
        apply(command::SetPaused{true});
        for (int i = 0; i < 30; ++i) step();
        apply(command::TakeSamples{true});
    }
};

TEST(Samples, WhatSlidesLosesItsEnergyToFriction) {
    SampledBox stage;
    const BodyId box = stage.state().layout->bodies[1].id;
    const double mass = double(stage.world().body(box).mass()), start = stage.world().body(box).position().x;
    stage.apply(command::EditBody{box, edit::Velocity{{4.0f, 0.0f, 0.0f}}});
    for (int i = 0; i < 30; ++i) stage.step(); // it still slides
    const Balance sliding(stage);
    const double way = stage.world().body(box).position().x - start;
    const double friction = 0.6 * mass * 9.81; // N
    EXPECT_NEAR(sliding.external_work, 0.5 * mass * 16.0, 0.01 * mass);
    EXPECT_NEAR(sliding.friction, friction * way, 0.02 * friction * way);
    EXPECT_NEAR(sliding.impacts, 0.0, 0.02 * friction * way);
    EXPECT_NEAR(sliding.kinetic, 0.5 * mass * 16.0 - friction * way, 0.02 * friction * way);
    EXPECT_NEAR(sliding.drift, 0.0, 0.005 * friction * way);
    for (int i = 0; i < 60; ++i) stage.step(); // until it rests
    const Balance rest(stage);
    EXPECT_NEAR(rest.friction, 0.5 * mass * 16.0, 0.03 * 0.5 * mass * 16.0);
    EXPECT_NEAR(rest.drift, 0.0, 0.01 * 0.5 * mass * 16.0);
}

TEST(Samples, WhatBouncesLosesItsEnergyInImpacts) {
    SampledBox stage;
    SpawnSettings ball = small_sphere_preset();
    ball.restitution = 0.6f;
    stage.apply(command::Spawn{ball, {0.0, 5.0, 8.0}});
    stage.step();
    const BodyId id = stage.state().layout->bodies[2].id;
    const Position place = stage.world().body(id).position();
    const double radius = stage.world().shape_bounds(stage.world().body(id).shapes()[0]).max.y - place.y;
    const double weight = 9.81 * double(stage.world().body(id).mass());
    const double fall = weight * (place.y - radius); // J, above the ground
    for (int i = 0; i < 80; ++i) stage.step();       // it has bounced once and is in the air
    const Balance once(stage);
    EXPECT_NEAR(once.impacts, (1.0 - 0.09) * fall, 0.02 * fall); // the mean of both restitutions is 0.3
    EXPECT_NEAR(once.friction, 0.0, 0.01 * fall);
    EXPECT_NEAR(once.drift, 0.0, 0.02 * fall);
    for (int i = 0; i < 600; ++i) stage.step(); // until it rests
    const Balance rest(stage);
    EXPECT_NEAR(rest.impacts + rest.friction, fall, 0.02 * fall);
    EXPECT_NEAR(rest.drift, 0.0, 0.02 * fall);
}

TEST(Samples, WhatKeysPushIsBroughtIn) {
    SampledBox stage;
    const BodyId box = stage.state().layout->bodies[1].id;
    const double mass = double(stage.world().body(box).mass()), start = stage.world().body(box).position().x;
    stage.apply(command::SetForce{{40.0f, 0.0f, 0.0f}});
    for (int i = 0; i < 60; ++i) stage.step();
    const double way = stage.world().body(box).position().x - start;
    const Balance balance(stage);
    EXPECT_NEAR(balance.external_work, 40.0 * mass * way, 0.02 * 40.0 * mass * way);
    EXPECT_NEAR(balance.friction, 0.6 * 9.81 * mass * way, 0.03 * 0.6 * 9.81 * mass * way);
    EXPECT_NEAR(balance.drift, 0.0, 0.01 * 40.0 * mass * way);
}

TEST(Samples, LaterOnesAreReplacedAndTheOldestGo) {
    SampleLog log;
    for (std::uint64_t step = 0; step < 1000; ++step) log.add({step, {}, double(step), {}});
    const SampleLog copy = log;
    log.add({600, {}, -1.0, {}});
    ASSERT_EQ(log.size(), 601u);
    EXPECT_EQ(log[600].time, -1.0);
    EXPECT_EQ(log[599].time, 599.0);
    EXPECT_EQ(copy.size(), 1000u) << "a copy stays as it is";
    EXPECT_EQ(copy[777].time, 777.0);
    for (std::uint64_t step = 601; step < 100000; ++step) log.add({step, {}, double(step), {}});
    EXPECT_LT(log.size(), 70000u);
    EXPECT_EQ(log[log.size() - 1].step, 99999u);
    for (std::size_t i = 1; i < log.size(); ++i) ASSERT_EQ(log[i].step, log[i - 1].step + 1);
}

TEST(Samples, TheStageTakesThemAndAChartShowsOneBody) {
    Stage stage(test::load_boxes, "2");
    for (int i = 0; i < 5; ++i) stage.step();
    EXPECT_TRUE(stage.state().samples.is_empty()) << "not asked for";
    stage.apply(command::TakeSamples{true});
    for (int i = 0; i < 20; ++i) stage.step();
    stage.apply(command::GrabBody{{{0.0, 0.6, 10.0}, {0.0f, 0.0f, -1.0f}}, 1});
    stage.apply(command::ReleaseGrab{true});
    for (int i = 0; i < 10; ++i) stage.step();
    const StageState state = stage.state();
    EXPECT_EQ(state.samples.size(), 31u);
    const PlotGroup& places = plot_groups()[3];
    const Chart chart = sample_chart(state.samples, places, all, state.selected, "crate");
    EXPECT_EQ(chart.title, "position of the body crate");
    ASSERT_EQ(chart.curves.size(), 3u);
    EXPECT_EQ(chart.curves[1].label, "y");
    EXPECT_TRUE(std::isnan(chart.curves[1].y[10])) << "it was not selected yet";
    EXPECT_NEAR(chart.curves[1].y.back(), 0.5, 0.01);
    EXPECT_EQ(sample_chart(state.samples, places, 0.099, state.selected, "").curves[0].x.size(), 6u);
    const Chart phase = sample_chart(state.samples, places, all, state.selected, "", Quantity::body_velocity_y);
    EXPECT_EQ(phase.x_label, "velocity y, m/s");
}

} // namespace
