// Two branches of a run: one is changed by commands, the other is shown beside it.
#include "viewer/render_frame.h"
#include "viewer/stage.h"

#include "test_scene.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;
using test::seek;
using test::step_to;

constexpr std::uint64_t parting = 10, end = 40;

// A box that was shot at another box, and all its positions.
struct Shot {
    Stage stage{test::load_boxes, "2"};
    std::vector<Position> places;

    Shot() {
        stage.apply(command::SetPaused{true});
        SpawnSettings box = box_preset();
        box.speed = 12.0f; // hits the first box after a third of a second, and does not push it as far as the second
        stage.apply(command::Shoot{box, {{-6.0, 0.6, 0.0}, {1.0f, 0.0f, 0.0f}}});
        places.push_back(here());
        while (stage.timeline().now().step < end) {
            stage.step();
            places.push_back(here());
        }
    }
    Position here() const { return stage.state().current->transforms[3].position; }
    Position there() const { return stage.state().other->picture.current->transforms[3].position; }
};

TEST(SideRun, GoesOnAsItWasWhereTheOtherIsChanged) {
    Shot shot;
    seek(shot.stage, parting);
    shot.stage.apply(command::BranchOff{});
    ASSERT_TRUE(shot.stage.state().other);
    EXPECT_EQ(shot.stage.state().other->branched_at, parting);
    EXPECT_EQ(shot.stage.state().timeline.last, parting); // a new future begins
    EXPECT_EQ(shot.stage.state().other->difference.elsewhere, 0u);
    const BodyId ball = shot.stage.state().layout->bodies[3].id;
    shot.stage.apply(command::EditBody{ball, edit::Velocity{{0.0f, 5.0f, 0.0f}}});
    for (std::uint64_t step = parting + 1; step <= end; ++step) {
        shot.stage.step();
        EXPECT_EQ(shot.there(), shot.places[step]) << step;
        EXPECT_NE(shot.here(), shot.places[step]) << step;
    }
    const RunDifference difference = shot.stage.state().other->difference;
    EXPECT_GE(difference.elsewhere, 1u);
    EXPECT_EQ(difference.farthest_body, ball);
    EXPECT_GT(difference.farthest, 0.5);
}

TEST(SideRun, GoesOnBeyondWhatWasKnown) {
    Shot shot, longer;
    step_to(longer.stage, 2 * end);
    seek(shot.stage, parting);
    shot.stage.apply(command::BranchOff{});
    shot.stage.apply(command::RemoveLast{});
    step_to(shot.stage, 2 * end);
    EXPECT_EQ(shot.there(), longer.here());
    EXPECT_EQ(shot.stage.state().layout->bodies.size(), 3u);
    EXPECT_EQ(shot.stage.state().other->difference.elsewhere, 2u); // the removed body, and the one that it did not hit
}

TEST(SideRun, FollowsThroughTimeInBothDirections) {
    Shot shot;
    seek(shot.stage, parting);
    shot.stage.apply(command::BranchOff{});
    step_to(shot.stage, end);
    for (const std::uint64_t step : {end - 1, end - 2, std::uint64_t{15}, std::uint64_t{35}, std::uint64_t{3}}) {
        seek(shot.stage, step);
        shot.stage.advance(0.0);
        EXPECT_EQ(shot.there(), shot.places[step]) << step;
    }
    shot.stage.apply(command::StepBack{});
    EXPECT_EQ(shot.there(), shot.places[2]);
}

TEST(SideRun, ExchangedItIsTheOneThatCommandsChange) {
    Shot shot;
    seek(shot.stage, parting);
    shot.stage.apply(command::BranchOff{});
    shot.stage.apply(command::RemoveLast{});
    step_to(shot.stage, 20);
    shot.stage.apply(command::ExchangeRuns{});
    EXPECT_EQ(shot.here(), shot.places[20]);
    EXPECT_EQ(shot.stage.state().timeline.last, end); // the future of this branch is known
    EXPECT_EQ(shot.stage.state().other->picture.layout->bodies.size(), 3u);
    step_to(shot.stage, end);
    EXPECT_EQ(shot.here(), shot.places[end]);
    EXPECT_FALSE(shot.stage.state().timeline.verdict.first_different);
    shot.stage.apply(command::ExchangeRuns{});
    EXPECT_EQ(shot.stage.state().layout->bodies.size(), 3u);
    shot.stage.apply(command::Undo{}); // undoes a change of this branch
    EXPECT_EQ(shot.stage.state().layout->bodies.size(), 4u);
    shot.stage.apply(command::EndOtherRun{});
    EXPECT_FALSE(shot.stage.state().other);
}

TEST(SideRun, NobodyHoldsWhatWasHeldThere) {
    Stage stage(test::load_boxes, "1");
    stage.apply(command::SetPaused{true});
    stage.apply(command::SetForce{{40.0f, 0.0f, 0.0f}});
    for (int i = 0; i < 20; ++i) stage.step();
    stage.apply(command::BranchOff{});
    for (int i = 0; i < 40; ++i) stage.step();
    const StageState state = stage.state();
    const double pushed = state.current->transforms[1].position.x;
    const double let_go = state.other->picture.current->transforms[1].position.x;
    EXPECT_GT(pushed, 10.0);
    EXPECT_LT(let_go, 0.6 * pushed);
    EXPECT_GT(let_go, 1.0);
}

TEST(SideRun, GhostsAreOfBodiesThatAreElsewhere) {
    Shot shot;
    seek(shot.stage, parting);
    shot.stage.apply(command::BranchOff{});
    shot.stage.apply(command::RemoveLast{});
    step_to(shot.stage, 15); // the box has not hit anything yet
    const StageState state = shot.stage.state();
    const FrameOptions options;
    RenderFrame frame = make_frame(*state.layout, *state.previous, *state.current, 1.0f, state.scene_camera, options);
    add_ghosts(frame, *state.layout, *state.current, state.other->picture, 1.0f, options);
    EXPECT_EQ(frame.boxes.size(), 2u);
    ASSERT_EQ(frame.ghosts.boxes.size(), 1u);
    EXPECT_EQ(frame.ghosts.boxes[0].position, Vec3(shot.there() - frame.origin));
}

} // namespace
