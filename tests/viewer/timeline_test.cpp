#include "viewer/stage.h"

#include "recording/recorder.h"
#include "recording/recording.h"
#include "test_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <random>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;

// The hash of the state before the first step and after each step.
std::vector<std::uint64_t> run(Stage& stage, int steps) {
    std::vector<std::uint64_t> hashes{stage.world().state_hash()};
    for (int i = 0; i < steps; ++i) {
        stage.step();
        hashes.push_back(stage.world().state_hash());
    }
    return hashes;
}

void go_to(Stage& stage, std::uint64_t step) {
    stage.apply(command::SeekTo{step});
    for (int i = 0; i < 1000 && stage.until_next_step() == 0.0; ++i) stage.advance(0.0);
}

std::size_t dynamic_bodies(const Stage& stage) { return stage.world().statistics().dynamic_bodies; }

// Boxes that fall onto each other, so that every step changes the state.
LoadedScene falling_boxes(const std::string& path) {
    LoadedScene scene = test::boxes_on_plane(0);
    for (int i = 0; i < std::stoi(path); ++i) {
        BodyDef def = test::body_at({0.3 * (i % 3), 1.0 + 1.2 * i, 0.2 * (i % 2)});
        def.angular_velocity = {0.1f * float(i), 0.3f, 0.0f};
        scene.world.add_shape(scene.world.create_body(def), Box{});
    }
    return scene;
}

TEST(Timeline, EveryMomentIsReachedAgainWithTheSameBits) {
    Stage stage(falling_boxes, "6");
    const std::vector<std::uint64_t> hashes = run(stage, 600);
    std::mt19937 random(1);
    for (int i = 0; i < 40; ++i) {
        const std::uint64_t step = random() % hashes.size();
        go_to(stage, step);
        ASSERT_EQ(stage.world().state_hash(), hashes[step]) << step;
        ASSERT_EQ(stage.state().timeline.now, step);
    }
    EXPECT_EQ(stage.state().timeline.last, 600u);
    EXPECT_GT(stage.timeline().verdict().compared, 0u);
    EXPECT_FALSE(stage.timeline().verdict().first_different);
}

TEST(Timeline, StepsBackThroughEveryStepToTheBeginning) {
    Stage stage(falling_boxes, "4");
    const std::vector<std::uint64_t> hashes = run(stage, 130);
    for (std::size_t step = 130; step-- > 0;) {
        stage.apply(command::StepBack{});
        ASSERT_EQ(stage.world().state_hash(), hashes[step]) << step;
    }
    EXPECT_EQ(stage.state().message.serial, 0u);
    stage.apply(command::StepBack{});
    EXPECT_EQ(stage.state().message.serial, 1u); // there is no earlier step
    EXPECT_TRUE(stage.state().paused);
}

TEST(Timeline, PlaysBackwardsAndFollowsWhatWasThenForwards) {
    Stage stage(falling_boxes, "3");
    stage.apply(command::Spawn{box_preset(), {0.0, 9.0, 0.0}});
    run(stage, 20);
    stage.apply(command::Spawn{small_sphere_preset(), {2.0, 5.0, 0.0}});
    const std::vector<std::uint64_t> hashes = run(stage, 60);
    EXPECT_EQ(dynamic_bodies(stage), 5u);
    stage.apply(command::PlayBackwards{});
    EXPECT_TRUE(stage.state().timeline.is_backwards);
    for (int i = 0; i < 70; ++i) stage.step();
    EXPECT_EQ(stage.state().timeline.now, 10u);
    EXPECT_EQ(dynamic_bodies(stage), 4u) << "the sphere was not there yet";
    EXPECT_EQ(stage.state().layout->bodies.size(), 5u);
    stage.apply(command::TogglePause{});
    stage.apply(command::TogglePause{});
    for (int i = 0; i < 70; ++i) stage.step();
    EXPECT_EQ(stage.world().state_hash(), hashes.back());
    EXPECT_EQ(dynamic_bodies(stage), 5u);
    EXPECT_EQ(stage.state().timeline.last, 80u) << "nothing new was made";
    stage.step();
    EXPECT_EQ(stage.state().timeline.last, 81u) << "at the end it goes on";
}

TEST(Timeline, BackwardsItStopsAtTheBeginning) {
    Stage stage(falling_boxes, "1");
    run(stage, 5);
    stage.apply(command::PlayBackwards{});
    for (int i = 0; i < 6; ++i) stage.step();
    EXPECT_TRUE(stage.state().paused);
    EXPECT_FALSE(stage.state().timeline.is_backwards);
    EXPECT_EQ(stage.state().timeline.now, 0u);
}

TEST(Timeline, SomethingElseInThePastMakesAnotherFuture) {
    Stage stage(falling_boxes, "3");
    run(stage, 50);
    stage.apply(command::Spawn{box_preset(), {4.0, 9.0, 0.0}});
    run(stage, 50);
    go_to(stage, 20);
    EXPECT_EQ(dynamic_bodies(stage), 3u);
    stage.apply(command::Spawn{small_sphere_preset(), {4.0, 3.0, 0.0}});
    EXPECT_EQ(stage.state().timeline.last, 20u) << "what followed is no more";
    const std::vector<std::uint64_t> other = run(stage, 60);
    go_to(stage, 40);
    EXPECT_EQ(stage.world().state_hash(), other[20]);
    ASSERT_EQ(stage.state().timeline.undoable, "add a body");
    stage.apply(command::Undo{});
    EXPECT_EQ(stage.state().timeline.now, 20u);
    EXPECT_EQ(stage.state().timeline.undoable, std::nullopt) << "the box belonged to the other future";
}

TEST(Timeline, UndoAndRedoInAnyOrderGiveTheBitsFromBefore) {
    Stage stage(falling_boxes, "3");
    stage.apply(command::SetPaused{true});
    std::mt19937 random(7);
    std::vector<std::uint64_t> after{stage.world().state_hash()}; // states after each change
    for (int i = 0; i < 100; ++i) {
        switch (random() % 4) {
        case 0:
            stage.apply(command::RemoveLast{});
            stage.apply(command::Spawn{box_preset(), {double(random() % 9), 9.0, 0.0}});
            break;
        case 1:
            stage.apply(command::Spawn{small_sphere_preset(), {double(random() % 9), 5.0, 1.0}});
            break;
        case 2:
            stage.apply(command::Shoot{box_preset(), Ray{{0.0, 1.0, 9.0}, {0.0f, 0.0f, -1.0f}}});
            break;
        default:
            stage.apply(command::SetFreeze{true});
            stage.apply(command::SetFreeze{false});
        }
        while (stage.timeline().undoable() && stage.timeline().marks()->size() >= after.size())
            after.push_back(stage.world().state_hash());
        if (random() % 3 == 0) stage.step(), stage.step();
    }
    int made = 0;
    for (std::size_t i = 0; i < stage.timeline().marks()->size(); ++i)
        made += (*stage.timeline().marks())[i].kind == Mark::Kind::change ? 1 : 0;
    EXPECT_GT(made, 60);
    // The states after each redo, in a random walk through the undo history.
    std::vector<std::uint64_t> undone;
    while (stage.timeline().undoable()) {
        stage.apply(command::Undo{});
        undone.push_back(stage.world().state_hash());
    }
    ASSERT_EQ(int(undone.size()), made);
    int place = made; // number of changes that are undone
    for (int i = 0; i < 300; ++i) {
        if (random() % 2 == 0 && place < made) {
            stage.apply(command::Undo{});
            ++place;
            ASSERT_EQ(stage.world().state_hash(), undone[std::size_t(place - 1)]) << i;
        } else if (place > 0) {
            stage.apply(command::Redo{});
            --place;
        }
    }
}

TEST(Timeline, AfterUndoingTimeGoesOnWithoutTheChange) {
    Stage stage(falling_boxes, "2");
    run(stage, 10);
    stage.apply(command::RemoveLast{});
    run(stage, 10);
    EXPECT_EQ(dynamic_bodies(stage), 1u);
    stage.apply(command::Undo{});
    EXPECT_TRUE(stage.state().paused);
    EXPECT_EQ(dynamic_bodies(stage), 2u);
    EXPECT_EQ(stage.state().timeline.redoable, "remove a body");
    stage.apply(command::Redo{});
    EXPECT_EQ(dynamic_bodies(stage), 1u);
    stage.apply(command::Undo{});
    stage.step();
    EXPECT_EQ(dynamic_bodies(stage), 2u);
    EXPECT_EQ(stage.state().timeline.redoable, std::nullopt);
    stage.apply(command::Redo{});
    EXPECT_EQ(stage.state().message.text, "There is nothing to redo.");
}

TEST(Timeline, ADragIsUndoneAsOneAndLeavesNothingBehind) {
    Stage stage(test::load_boxes, "1");
    run(stage, 5);
    const std::uint64_t before = stage.world().state_hash();
    stage.apply(command::GrabBody{{{0.0, 0.6, 10.0}, {0.0f, 0.0f, -1.0f}}, 1});
    stage.apply(command::MoveGrab{{1.0, 3.0, 0.0}});
    run(stage, 20);
    go_to(stage, 15); // in the middle of the drag
    EXPECT_TRUE(stage.state().current->joints->empty()) << "the drag is no joint of the scene";
    stage.apply(command::Spawn{small_sphere_preset(), {4.0, 3.0, 0.0}});
    EXPECT_EQ(stage.world().joints().size(), 0u) << "nobody holds it in the new future";
    stage.apply(command::Undo{});
    stage.apply(command::Undo{});
    EXPECT_EQ(stage.world().state_hash(), before);
    EXPECT_EQ(stage.state().timeline.undoable, std::nullopt);
}

TEST(Timeline, AClickThatSelectsIsNothingToUndo) {
    Stage stage(test::load_boxes, "1");
    stage.apply(command::GrabBody{{{0.0, 0.6, 10.0}, {0.0f, 0.0f, -1.0f}}, 1});
    stage.step();
    stage.apply(command::ReleaseGrab{true});
    EXPECT_TRUE(stage.state().selected);
    EXPECT_EQ(stage.state().timeline.undoable, std::nullopt);
    stage.step();
    const std::uint64_t end = stage.world().state_hash();
    go_to(stage, 1);
    EXPECT_EQ(stage.world().joints().size(), 1u) << "before it was let go";
    stage.step();
    go_to(stage, 0);
    go_to(stage, 2);
    EXPECT_EQ(stage.world().joints().size(), 0u);
    EXPECT_EQ(stage.world().state_hash(), end);
}

TEST(Timeline, AClickBesideBodiesLeavesTheDragBeforeItToBeUndone) {
    Stage stage(test::load_boxes, "1");
    stage.apply(command::GrabBody{{{0.0, 0.6, 10.0}, {0.0f, 0.0f, -1.0f}}, 1});
    run(stage, 5);
    stage.apply(command::ReleaseGrab{false});
    stage.apply(command::GrabBody{{{0.0, 0.6, 10.0}, {0.0f, 1.0f, 0.0f}}, 2});
    stage.apply(command::ReleaseGrab{true});
    EXPECT_EQ(stage.state().timeline.undoable, "drag");
}

TEST(Timeline, AKeyOfTheFutureDoesNotPushWhatGoesOnFromThePast) {
    Stage stage(falling_boxes, "1");
    stage.apply(command::SetForce{{40.0f, 0.0f, 0.0f}});
    run(stage, 30);
    stage.apply(command::SetForce{{0.0f, 0.0f, 0.0f}});
    run(stage, 10);
    const auto& marks = *stage.state().timeline.marks;
    ASSERT_EQ(
        std::count_if(marks.begin(), marks.end(), [](const Mark& mark) { return mark.kind == Mark::Kind::change; }), 1)
        << "pressed and let go, it is one change";
    go_to(stage, 15); // the key was held at that time
    stage.apply(command::RemoveLast{});
    stage.apply(command::Spawn{box_preset(), {0.0, 5.0, 0.0}});
    run(stage, 10);
    EXPECT_EQ(stage.state().current->transforms.back().position.x, 0.0);
}

TEST(Timeline, ImpactsAndBreaksAreMarkedOnce) {
    Stage stage(
        [](const std::string&) {
            LoadedScene scene = test::boxes_on_plane(1);
            const BodyId box = scene.world.create_body(test::body_at({4.0, 6.0, 0.0}));
            scene.world.add_shape(box, Box{});
            JointDef def = scene.world.joint_at({}, box, {4.0, 6.5, 0.0}, {1.0f, 0.0f, 0.0f}, FixedJoint{});
            def.break_force = 100.0f; // less than the weight of the box, N
            scene.world.create_joint(def);
            return scene;
        },
        "");
    run(stage, 120);
    const auto count = [&](Mark::Kind kind) {
        const auto& marks = *stage.state().timeline.marks;
        return std::count_if(marks.begin(), marks.end(), [&](const Mark& mark) { return mark.kind == kind; });
    };
    EXPECT_EQ(count(Mark::Kind::break_), 1);
    EXPECT_EQ(count(Mark::Kind::impact), 1);
    const Mark impact = stage.state().timeline.marks->back();
    EXPECT_NEAR(impact.strength, 10.3f, 0.5f); // sqrt(2 g 5.5 m)
    go_to(stage, 0);
    for (int i = 0; i < 120; ++i) stage.step();
    EXPECT_EQ(count(Mark::Kind::impact), 1) << "done again, it is the same impact";
}

// The steps are reported to take 20 ms each: at first a state is kept every 15 steps.
std::vector<std::uint64_t> run_within_budget(Timeline& timeline, LoadedScene& scene, int steps, std::size_t most) {
    timeline.begin(scene.world, {});
    std::vector<std::uint64_t> hashes{scene.world.state_hash()};
    for (int i = 0; i < steps; ++i) {
        scene.world.step(1.0f / 60.0f);
        timeline.after_step(scene.world, 0.02);
        hashes.push_back(scene.world.state_hash());
        EXPECT_LE(timeline.bytes(), most);
    }
    return hashes;
}

TEST(Timeline, AllOfTheRunIsWithinReachWhereTheBudgetIsSpent) {
    Timeline timeline(std::size_t{400} << 10);
    LoadedScene scene = falling_boxes("8");
    constexpr int steps = 2000;
    const std::vector<std::uint64_t> hashes = run_within_budget(timeline, scene, steps, std::size_t{400} << 10);
    EXPECT_EQ(timeline.first_step(), 0u);
    EXPECT_GT(timeline.bytes(), std::size_t{90} << 10);
    std::uint64_t farthest = 0; // greatest distance from the preceding kept state, steps
    for (std::uint64_t step = steps; step > 50; step -= 50) {
        ASSERT_TRUE(timeline.seek(scene.world, {step, 0}));
        ASSERT_EQ(scene.world.state_hash(), hashes[step]) << step;
        World kept;
        kept.restore(timeline.excerpt(0).start);
        farthest = std::max(farthest, step - kept.step_count());
    }
    EXPECT_LE(farthest, 300u);
}

// 64 boxes that fall and come to rest, for 50 s. 200 complete states would take several times the budget.
TEST(Timeline, AnyMomentOfALongRunIsWithinThirtyStepsOfAStateThatIsKept) {
    constexpr std::size_t budget = std::size_t{1} << 20;
    constexpr std::uint64_t steps = 3000;
    Timeline timeline(budget);
    LoadedScene scene = falling_boxes("64");
    const std::vector<std::uint64_t> hashes = run_within_budget(timeline, scene, int(steps), budget);
    EXPECT_EQ(timeline.first_step(), 0u);
    std::mt19937 random(2);
    for (int i = 0; i < 60; ++i) {
        const std::uint64_t to = random() % steps;
        timeline.seek(scene.world, {steps, 0});
        std::uint64_t done_again = 1;
        while (!timeline.seek(scene.world, {to, 0}, 0.0)) ++done_again; // one step per call
        ASSERT_EQ(scene.world.state_hash(), hashes[to]) << to;
        ASSERT_LE(done_again, 30u) << to;
    }
}

TEST(Timeline, TheOldestGoesWhereFewStatesAreLeft) {
    Timeline timeline(std::size_t{40} << 10);
    LoadedScene scene = falling_boxes("8");
    const std::vector<std::uint64_t> hashes = run_within_budget(timeline, scene, 2000, std::size_t{64} << 10);
    ASSERT_GT(timeline.first_step(), 100u);
    ASSERT_LT(timeline.first_step(), 1990u);
    EXPECT_TRUE(timeline.seek(scene.world, {0, 0}));
    EXPECT_EQ(timeline.now().step, timeline.first_step());
    EXPECT_EQ(scene.world.state_hash(), hashes[timeline.first_step()]);
}

// A run from a file, as the program passes it to the stage: the boxes exist, and the steps are still to be read.
LoadedScene recorded_boxes(const recording::Recording& recording, recording::CallReader& reader) {
    LoadedScene scene;
    scene.run.source = reader.source();
    scene.run.keyframe = [&](std::uint64_t after, std::uint64_t until) { return reader.keyframe(after, until); };
    scene.run.steps.emplace_back();
    recording::RecordedCall call;
    while (reader.next(call)) {
        RecordedStep& open = scene.run.steps.back();
        if (call.is_step) {
            open.step = call.command;
            open.digest = call.digest;
            scene.run.steps.emplace_back();
        } else if (scene.run.steps.size() == 1) {
            scene.world.execute(call.command, *scene.run.source);
        } else {
            open.changes.push_back(call.command);
        }
    }
    EXPECT_EQ(scene.run.steps.size(), recording.info().steps + 1);
    return scene;
}

TEST(Timeline, ARecordingIsFollowedSoughtAndLeftForAnotherFuture) {
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "cairn_timeline_test.mcap";
    std::vector<std::uint64_t> hashes;
    {
        LoadedScene scene = falling_boxes("5");
        recording::Recorder recorder(path);
        scene.world.set_command_listener(recorder.listener());
        hashes.push_back(scene.world.state_hash());
        for (int i = 0; i < 400; ++i) {
            if (i == 200) scene.world.destroy_body(scene.world.bodies().back());
            scene.world.step(1.0f / 60.0f);
            hashes.push_back(scene.world.state_hash());
        }
        recorder.close();
    }
    const recording::Recording recording(path);
    recording::CallReader reader(recording);
    Stage stage([&](const std::string&) { return recorded_boxes(recording, reader); }, "");
    EXPECT_TRUE(stage.state().timeline.is_recording);
    EXPECT_EQ(stage.state().timeline.last, 400u);
    ASSERT_EQ(stage.state().timeline.marks->size(), 1u);
    EXPECT_EQ(stage.state().timeline.marks->front().text, "destroy body");
    for (const std::uint64_t step : {350u, 10u, 201u, 199u, 400u, 0u, 130u}) {
        go_to(stage, step);
        ASSERT_EQ(stage.world().state_hash(), hashes[step]) << step;
    }
    EXPECT_EQ(dynamic_bodies(stage), 5u);
    for (int i = 0; i < 270; ++i) stage.step();
    EXPECT_EQ(stage.world().state_hash(), hashes.back());
    EXPECT_EQ(dynamic_bodies(stage), 4u);
    EXPECT_TRUE(stage.state().paused) << "at the end of the recording";
    EXPECT_GT(stage.timeline().verdict().compared, 270u);
    EXPECT_EQ(stage.timeline().verdict().here, stage.timeline().verdict().there) << "the hashes of the last one";
    EXPECT_NE(stage.timeline().verdict().here, 0u);
    EXPECT_FALSE(stage.timeline().verdict().first_different);
    go_to(stage, 150);
    stage.apply(command::Spawn{box_preset(), {5.0, 5.0, 0.0}});
    const std::vector<std::uint64_t> other = run(stage, 150);
    EXPECT_EQ(dynamic_bodies(stage), 6u);
    go_to(stage, 290);
    EXPECT_EQ(stage.world().state_hash(), other[140]) << "not by a state of the recorded future";
    std::filesystem::remove(path);
}

double cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

// The share of recording in the processor time of stepping, on this thread. `has_kept`: set if a state was kept.
double share_of_recording(bool& has_kept) {
    LoadedScene scene = test::boxes_on_plane(0);
    for (int i = 0; i < 2000; ++i) {
        const BodyDef def = test::body_at({1.1 * (i % 10), 1.0 + 1.05 * (i / 100), 1.1 * (i / 10 % 10)});
        const BodyId body = scene.world.create_body(def);
        i % 2 == 0 ? scene.world.add_shape(body, Box{}) : scene.world.add_shape(body, Sphere{});
    }
    Timeline timeline;
    timeline.begin(scene.world, {});
    double stepping = 0.0, recording = 0.0;
    for (int i = 0; i < 600; ++i) {
        const double start = cpu_seconds();
        scene.world.step(1.0f / 60.0f);
        const double stepped = cpu_seconds();
        timeline.after_step(scene.world, stepped - start);
        stepping += stepped - start;
        recording += cpu_seconds() - stepped;
    }
    has_kept = has_kept || timeline.seconds_kept() > 0.0;
    return recording / stepping;
}

// The minimum of three runs: other programs on the machine use its caches, which costs processor time.
TEST(Timeline, RecordingTakesAFewHundredthsOfAStep) {
    bool has_kept = false; // not in every run: if saving the first state was slow, the next ones are delayed
    const double share =
        std::min({share_of_recording(has_kept), share_of_recording(has_kept), share_of_recording(has_kept)});
    EXPECT_TRUE(has_kept);
    RecordProperty("share", std::to_string(share));
    EXPECT_LT(share, 0.05);
}

} // namespace
