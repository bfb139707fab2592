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
