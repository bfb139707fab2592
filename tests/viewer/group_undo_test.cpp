// Groups and undo: groups that are made, dissolved, undone and redone; and edits of several bodies, which are applied
// to all of them or to none.
#include "viewer/stage.h"

#include "test_scene.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;

// Boxes 2 m apart on a plane, and a static triangle mesh above them, which cannot become dynamic.
LoadedScene boxes_and_a_mesh(const std::string& path) {
    LoadedScene scene = test::load_boxes(path);
    BodyDef def = test::static_body();
    def.position = {0.0, 8.0, 0.0};
    def.name = "roof";
    scene.world.add_shape(scene.world.create_body(def), test::cube_surface());
    return scene;
}

struct GroupDesk {
    Stage stage;
    std::vector<BodyId> boxes;
    BodyId roof;
    explicit GroupDesk(Savers savers = {}) : stage(boxes_and_a_mesh, "4", std::move(savers)) {
        stage.apply(command::SetPaused{true});
        for (const BodyLayout& body : stage.state().layout->bodies)
            if (body.type == BodyType::dynamic)
                boxes.push_back(body.id);
            else if (body.name == "roof")
                roof = body.id;
    }
    void select(std::initializer_list<std::size_t> indices) {
        stage.apply(command::SelectNothing{});
        command::ReleaseGrab release;
        release.framed.emplace();
        for (const std::size_t i : indices) release.framed->push_back(boxes[i]);
        stage.apply(release);
    }
    void group(std::initializer_list<std::size_t> indices) {
        select(indices);
        stage.apply(command::GroupSelected{});
    }
    // The number of bodies that a click on that box selects.
    std::size_t with(std::size_t i) {
        stage.apply(command::SelectBody{boxes[i]});
        return stage.state().selection.size();
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) stage.step();
    }
    std::uint64_t hash() const { return stage.world().state_hash(); }
    std::string undoable() const { return stage.state().timeline.undoable.value_or(""); }
    std::string said() const { return stage.state().message.text; }
};

TEST(GroupUndo, MakingAGroupIsUndoneAndRedone) {
    GroupDesk desk;
    desk.run(5);
    const std::uint64_t before = desk.hash();
    desk.group({0, 2});
    EXPECT_EQ(desk.undoable(), "group bodies");
    EXPECT_EQ(desk.hash(), before) << "the world knows nothing of it";
    desk.run(10);
    desk.stage.apply(command::Undo{});
    EXPECT_EQ(desk.hash(), before);
    EXPECT_EQ(desk.with(0), 1u);
    EXPECT_EQ(desk.undoable(), "");
    desk.stage.apply(command::Redo{});
    EXPECT_EQ(desk.hash(), before);
    EXPECT_EQ(desk.with(0), 2u);
    EXPECT_TRUE(desk.stage.state().is_group);
    EXPECT_EQ(desk.stage.state().timeline.redoable, std::nullopt);
    desk.stage.apply(command::Undo{});
    desk.stage.apply(command::Spawn{box_preset(), {0.0, 3.0, 0.0}}); // a new future without the group
    EXPECT_EQ(desk.stage.state().timeline.redoable, std::nullopt);
    EXPECT_EQ(desk.with(0), 1u);
}

TEST(GroupUndo, EndingAGroupIsUndone) {
    GroupDesk desk;
    desk.group({0, 1, 2});
    desk.stage.apply(command::UngroupSelected{});
    EXPECT_EQ(desk.with(1), 1u);
    EXPECT_EQ(desk.undoable(), "end a group");
    desk.stage.apply(command::Undo{});
    EXPECT_EQ(desk.with(1), 3u);
    desk.stage.apply(command::Undo{});
    EXPECT_EQ(desk.with(1), 1u);
}

TEST(GroupUndo, WhatMakesNoGroupIsNothingToUndo) {
    GroupDesk desk;
    desk.select({0});
    desk.stage.apply(command::GroupSelected{});
    desk.stage.apply(command::UngroupSelected{});
    EXPECT_EQ(desk.undoable(), "");
    desk.group({0, 1});
    desk.stage.apply(command::GroupSelected{}); // the group exists already
    desk.stage.apply(command::Undo{});
    EXPECT_EQ(desk.undoable(), "");
}

TEST(GroupUndo, ACopiedGroupIsUndoneAsOne) {
    GroupDesk desk;
    desk.group({0, 1});
    const std::uint64_t before = desk.hash();
    desk.stage.apply(command::DuplicateSelected{});
    EXPECT_TRUE(desk.stage.state().is_group);
    EXPECT_EQ(desk.stage.timeline().groups().size(), 2u);
    desk.stage.apply(command::Undo{});
    EXPECT_EQ(desk.hash(), before);
    EXPECT_EQ(desk.stage.timeline().groups().size(), 1u);
    desk.stage.apply(command::Redo{});
    EXPECT_EQ(desk.stage.timeline().groups().size(), 2u);
}

TEST(GroupUndo, GroupsAreThoseOfTheMomentThatIsShown) {
    GroupDesk desk;
    desk.run(10);
    desk.group({1, 3});
    desk.run(10);
    const auto go_to = [&](std::uint64_t step) {
        desk.stage.apply(command::SeekTo{step});
        for (int i = 0; i < 1000 && desk.stage.until_next_step() == 0.0; ++i) desk.stage.advance(0.0);
    };
    go_to(5);
    EXPECT_EQ(desk.with(1), 1u);
    desk.run(10); // replays the known future
    EXPECT_EQ(desk.with(1), 2u);
    desk.run(10);
    EXPECT_EQ(desk.stage.state().timeline.now, 25u);
    EXPECT_EQ(desk.with(1), 2u);
}

TEST(GroupUndo, InAnyOrderOfChangesEachUndoGivesTheStateAndTheGroupsFromBefore) {
    GroupDesk desk;
    std::mt19937 random(11);
    struct Known {
        std::uint64_t hash;
        Groups groups;
    };
    std::vector<Known> before; // states before each change
    for (int i = 0; i < 60; ++i) {
        const Known now{desk.hash(), desk.stage.timeline().groups()};
        const std::size_t made = desk.stage.state().timeline.marks->size();
        const std::size_t a = random() % 4, b = random() % 4;
        switch (random() % 4) {
        case 0:
            desk.group({a, b});
            break;
        case 1:
            desk.stage.apply(command::SelectBody{desk.boxes[a]});
            desk.stage.apply(command::UngroupSelected{});
            break;
        case 2:
            desk.stage.apply(command::Spawn{small_sphere_preset(), {double(a), 5.0, 1.0}});
            break;
        default:
            desk.stage.apply(command::EditBody{desk.boxes[a], edit::Scale{Vec3(1.01f)}});
            desk.stage.apply(command::EndChange{});
        }
        if (desk.stage.state().timeline.marks->size() > made) before.push_back(now);
        desk.run(int(random() % 3));
    }
    EXPECT_GT(before.size(), 30u);
    for (int round = 0; round < 2; ++round) {
        for (std::size_t i = before.size(); i-- > 0;) {
            desk.stage.apply(command::Undo{});
            ASSERT_EQ(desk.hash(), before[i].hash) << i;
            ASSERT_EQ(desk.stage.timeline().groups(), before[i].groups) << i;
        }
        EXPECT_EQ(desk.undoable(), "");
        for (std::size_t i = 0; i < before.size(); ++i) desk.stage.apply(command::Redo{});
        EXPECT_EQ(desk.stage.state().timeline.redoable, std::nullopt);
    }
}

TEST(GroupUndo, RecordingsBranchesAndPanesGoPastIt) {
    std::uint64_t recorded = 0;
    Savers savers;
    savers.recording = [&](const std::filesystem::path&, const RecordingLooks&, World& world,
                           const std::function<void()>& run) {
        run();
        recorded = world.state_hash();
    };
    GroupDesk desk(savers);
    desk.stage.apply(command::SetPanes{{PaneSettings{}}});
    desk.run(5);
    desk.group({0, 1});
    desk.run(5);
    ASSERT_EQ(desk.stage.state().panes.size(), 1u);
    EXPECT_EQ(desk.stage.state().panes[0].trouble, "");
    desk.stage.apply(command::SaveRecording{"run.mcap", 30.0});
    for (int i = 0; i < 1000 && recorded == 0; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        desk.stage.advance(0.0);
    }
    EXPECT_EQ(recorded, desk.hash());
    desk.stage.apply(command::BranchOff{});
    desk.stage.apply(command::UngroupSelected{});
    desk.run(5);
    EXPECT_EQ(desk.with(0), 1u);
    desk.stage.apply(command::ExchangeRuns{});
    EXPECT_EQ(desk.with(0), 2u) << "in the run as it was they are still one";
}

// The hash of the world, the undo and redo entries, and the recorded future.
struct Everything {
    explicit Everything(const GroupDesk& desk)
        : hash(desk.hash()), undoable(desk.undoable()), redoable(desk.stage.timeline().redoable().value_or("")),
          last(desk.stage.timeline().last_step()), marks(desk.stage.timeline().marks()->size()),
          bodies(desk.stage.state().layout->bodies.size()), follows(desk.stage.timeline().follows()) {}
    std::uint64_t hash;
    std::string undoable, redoable;
    std::uint64_t last;
    std::size_t marks, bodies;
    bool follows;
    bool operator==(const Everything&) const = default;
};

TEST(EditBodies, WhereOneCannotBeChangedNoneIsAndTheReasonIsTold) {
    for (const bool is_undone : {false, true}) { // in the second round there is a change to redo
        GroupDesk desk;
        desk.stage.apply(command::EditBody{desk.boxes[0], edit::Type{BodyType::static_}});
        desk.stage.apply(command::EndChange{});
        desk.run(20);
        desk.stage.apply(command::EditBody{desk.boxes[1], edit::Type{BodyType::static_}});
        desk.run(3);
        if (is_undone) desk.stage.apply(command::Undo{});
        const Everything before(desk);
        command::EditBodies change;
        for (const BodyId body : {desk.boxes[0], desk.boxes[1], desk.roof, desk.boxes[2]})
            change.edits.emplace_back(body, edit::Type{BodyType::dynamic});
        desk.stage.apply(change);
        EXPECT_EQ(Everything(desk), before) << is_undone;
        EXPECT_EQ(desk.stage.world().body(desk.boxes[0]).type(), BodyType::static_);
        EXPECT_NE(desk.said().find("No body was changed, because roof cannot be: "), std::string::npos)
            << desk.said();
        change.edits.erase(change.edits.begin() + 2);
        desk.stage.apply(change); // the remaining bodies can be changed
        EXPECT_EQ(desk.stage.world().body(desk.boxes[0]).type(), BodyType::dynamic);
        desk.stage.apply(command::Undo{});
        EXPECT_EQ(desk.hash(), before.hash);
    }
}

TEST(EditBodies, ScalesThatGoTooFarChangeNoShapeAndNoColor) {
    GroupDesk desk;
    desk.select({0, 1});
    const auto shapes = [&] { return desk.stage.world().body(desk.boxes[0]).shapes(); };
    const std::vector<ShapeId> shapes_before = shapes();
    const Everything before(desk);
    command::EditBodies change;
    change.edits.emplace_back(desk.boxes[0], edit::Scale{Vec3(2.0f)});
    change.edits.emplace_back(desk.boxes[1], edit::Scale{Vec3(1e30f)});
    desk.stage.apply(change);
    EXPECT_EQ(Everything(desk), before);
    EXPECT_EQ(shapes(), shapes_before);
    EXPECT_NE(desk.said(), "");
    // A new shape reuses the index of the one that was undone, but not its color.
    desk.stage.apply(command::Spawn{box_preset(), {0.0, 3.0, 0.0}});
    EXPECT_FALSE(desk.stage.state().layout->shapes.back().color);
}

TEST(EditBodies, OneBodyOfWhichAShapeCannotBeScaledKeepsAllShapes) {
    Stage stage(
        [](const std::string&) {
            LoadedScene scene = test::boxes_on_plane(1);
            const BodyId body = scene.world.create_body(test::body_at({0.0, 3.0, 0.0}));
            scene.world.add_shape(body, Box{});
            scene.world.add_shape(body, Sphere{1e6f}, test::with_density(1e-6f));
            return scene;
        },
        "");
    const BodyId body = stage.state().layout->bodies.back().id;
    const std::uint64_t before = stage.world().state_hash();
    // The box can be scaled by that much, the ball cannot.
    stage.apply(command::EditBody{body, edit::Scale{Vec3(1e4f)}});
    EXPECT_EQ(stage.world().state_hash(), before);
    EXPECT_EQ(stage.world().body(body).shapes().size(), 2u);
    EXPECT_NE(stage.state().message.text, "");
}

} // namespace
