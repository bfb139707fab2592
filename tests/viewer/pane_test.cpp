// Panes: the same scene with other settings, simulated beside the run.
#include "viewer/pane.h"
#include "viewer/pane_layout.h"
#include "viewer/stage.h"

#include "test_scene.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;
using test::seek;
using test::step_to;

// The settings of the run itself, which a test then modifies.
PaneSettings settings_of(const Stage& stage) {
    const StageState state = stage.state();
    return {float(state.time_step), state.usual_substeps, state.settings.integrator, {}};
}

Position place(const StageState& state, std::size_t pane, std::size_t body) {
    return state.panes[pane].picture.current->transforms[body].position;
}

TEST(Pane, WithTheSameSettingsDoesTheSame) {
    Stage stage(test::load_boxes, "2");
    stage.apply(command::SetPaused{true});
    WorldDef def = stage.state().settings;
    def.adaptive_substeps = false; // as in panes
    stage.apply(command::SetSettings{def});
    stage.apply(command::SetPanes{{settings_of(stage)}});
    stage.apply(command::Shoot{box_preset(), {{-6.0, 0.6, 0.0}, {1.0f, 0.0f, 0.0f}}});
    step_to(stage, 30);
    stage.apply(command::Spawn{small_sphere_preset(), {0.0, 3.0, 0.0}});
    step_to(stage, 60);
    const StageState state = stage.state();
    ASSERT_EQ(state.panes[0].picture.layout->bodies.size(), 5u);
    EXPECT_EQ(state.panes[0].difference.elsewhere, 0u);
    EXPECT_EQ(state.panes[0].difference.farthest, 0.0);
    EXPECT_EQ(state.panes[0].energy, state.energy);
    EXPECT_EQ(state.panes[0].trouble, "");
}

TEST(Pane, FrictionAndIntegratorsMakeADifference) {
    Stage stage(test::load_boxes, "2");
    stage.apply(command::SetPaused{true});
    std::vector<PaneSettings> panes(3, settings_of(stage));
    panes[0].friction = 0.0f;
    panes[1].integrator = Integrator::explicit_euler;
    panes[2].step_length *= 0.25f;
    stage.apply(command::SetPanes{panes});
    const BodyId box = stage.state().layout->bodies[1].id;
    stage.apply(command::EditBody{box, edit::Velocity{{-3.0f, 0.0f, 0.0f}}});
    SpawnSettings ball = small_sphere_preset();
    stage.apply(command::Spawn{ball, {0.0, 30.0, 5.0}});
    step_to(stage, 90);
    const StageState state = stage.state();
    // Without friction the box moves on at 3 m/s for 1.5 s; with 0.6 it comes to rest after 3^2 / (2 0.6 9.81) m.
    EXPECT_NEAR(place(state, 0, 1).x, -4.5, 0.05);
    EXPECT_GT(state.current->transforms[1].position.x, -1.6);
    // A body that falls for a time t in steps of length h is above t^2 g / 2 by t g h / 2 with explicit Euler, and
    // below it by as much with semi-implicit Euler, whose steps are the substeps.
    const double fallen = 0.5 * 9.81 * 1.5 * 1.5, h = 1.0 / 60.0 / state.usual_substeps;
    EXPECT_NEAR(place(state, 1, 3).y - (30.0 - fallen), 0.5 * 1.5 * 9.81 * h, 1e-3);
    EXPECT_NEAR(place(state, 2, 3).y - (30.0 - fallen), -0.25 * 0.5 * 1.5 * 9.81 * h, 1e-3);
}

TEST(Pane, GoesWithTheRunThroughTimeAndItsChanges) {
    Stage stage(test::load_boxes, "1");
    stage.apply(command::SetPaused{true});
    std::vector<PaneSettings> panes(3, settings_of(stage));
    panes[0].step_length *= 0.5f;
    panes[1].step_length *= 2.0f;
    panes[2].substeps = 1;
    step_to(stage, 5);
    stage.apply(command::SetPanes{panes});
    step_to(stage, 20);
    stage.apply(command::Spawn{small_sphere_preset(), {0.0, 6.0, 0.0}});
    std::vector<std::vector<Position>> known(101);
    for (std::uint64_t step = 21; step <= 100; ++step) {
        stage.step();
        const StageState state = stage.state();
        for (std::size_t pane = 0; pane < 3; ++pane) known[step].push_back(place(state, pane, 2));
    }
    for (const std::uint64_t step : {30u, 99u, 80u, 25u, 61u}) {
        seek(stage, step);
        const StageState state = stage.state();
        for (std::size_t pane = 0; pane < 3; ++pane) EXPECT_EQ(place(state, pane, 2), known[step][pane]) << step;
    }
    seek(stage, 10);
    for (std::size_t pane = 0; pane < 3; ++pane) EXPECT_EQ(stage.state().panes[pane].picture.layout->bodies.size(), 2u);
    seek(stage, 60);
    stage.apply(command::Undo{}); // to before the ball was added
    for (std::size_t pane = 0; pane < 3; ++pane) EXPECT_EQ(stage.state().panes[pane].picture.layout->bodies.size(), 2u);
    stage.apply(command::Redo{});
    seek(stage, 40);
    stage.apply(command::RemoveLast{}); // starts another future
    step_to(stage, 50);
    for (std::size_t pane = 0; pane < 3; ++pane) EXPECT_EQ(stage.state().panes[pane].picture.layout->bodies.size(), 2u);
}

TEST(Pane, StartsAnewWithTheSceneAndEndsWhenNobodyLooks) {
    Stage stage(test::load_boxes, "1");
    stage.apply(command::SetPaused{true});
    stage.apply(command::SetPanes{{settings_of(stage), settings_of(stage)}});
    stage.apply(command::Spawn{small_sphere_preset(), {0.0, 6.0, 0.0}});
    step_to(stage, 10);
    stage.apply(command::LoadScene{"3"});
    ASSERT_EQ(stage.state().panes.size(), 2u);
    EXPECT_EQ(stage.state().panes[1].picture.layout->bodies.size(), 4u);
    EXPECT_EQ(stage.state().panes_began, 0u);
    stage.apply(command::SetPanes{});
    EXPECT_TRUE(stage.state().panes.empty());
}

TEST(PaneSettings, WordsTellWhichNumberIsTheLeast) {
    EXPECT_EQ(describe({}), "step 1/60 s, 6 substeps, semi-implicit Euler");
    EXPECT_EQ(describe({}, true), "step 1/60 s, 6 substeps or more, semi-implicit Euler");
}

TEST(PaneLayout, PanesFillTheAreaWithoutOverlaps) {
    const PaneRect area{300.0f, 0.0f, 980.0f, 680.0f};
    for (std::size_t count = 1; count <= most_panes; ++count) {
        float filled = 0.0f;
        for (std::size_t i = 0; i < count; ++i) {
            const PaneRect pane = pane_rect(area, count, i);
            filled += pane.width * pane.height;
            EXPECT_GE(pane.left, area.left);
            EXPECT_LE(pane.left + pane.width, area.left + area.width + 1e-3f);
            EXPECT_LE(pane.top + pane.height, area.top + area.height + 1e-3f);
            EXPECT_EQ(pane_at(area, count, pane.left + 0.5f * pane.width, pane.top + 0.5f * pane.height), i);
        }
        const float whole = area.width * area.height * (count == 3 ? 0.75f : 1.0f);
        EXPECT_GT(filled, 0.98f * whole);
        EXPECT_LE(filled, whole);
    }
    EXPECT_EQ(pane_at(area, 4, 10.0f, 10.0f), 0u); // on the panel
}

} // namespace
