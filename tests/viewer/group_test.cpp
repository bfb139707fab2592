// Selecting several bodies at a time, and groups of bodies.
#include "viewer/controller.h"
#include "viewer/group_edit.h"
#include "viewer/stage.h"

#include "test_scene.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;

// Boxes 2 m apart along x, on a plane.
struct Boxes {
    Stage stage;
    std::vector<BodyId> boxes;
    explicit Boxes(int count = 4, Savers savers = {})
        : stage(test::load_boxes, std::to_string(count), std::move(savers)) {
        stage.apply(command::SetPaused{true});
        for (const BodyLayout& body : stage.state().layout->bodies)
            if (body.type == BodyType::dynamic) boxes.push_back(body.id);
    }
    void click(double x, bool shift = false) {
        stage.apply(command::GrabBody{{{x, 0.6, 10.0}, {0.0f, 0.0f, -1.0f}}, 1});
        stage.apply(command::ReleaseGrab{true, shift});
    }
    std::vector<BodyId> selection() const { return test::selection_of(stage); }
    std::vector<BodyId> some(std::initializer_list<std::size_t> indices) const { return test::some_of(boxes, indices); }
    Position place(std::size_t i) const { return stage.world().body(boxes[i]).position(); }
};

TEST(Groups, ShiftAndAClickSelectOneMoreOrOneLess) {
    Boxes scene;
    scene.click(0.0);
    EXPECT_EQ(scene.selection(), scene.some({0}));
    scene.click(4.0, true);
    scene.click(2.0, true);
    EXPECT_EQ(scene.selection(), scene.some({0, 1, 2}));
    EXPECT_EQ(scene.stage.state().selected, scene.boxes[1]) << "windows tell about the last one";
    scene.click(4.0, true);
    EXPECT_EQ(scene.selection(), scene.some({0, 1}));
    scene.click(-5.0, true); // beside all boxes
    EXPECT_EQ(scene.selection(), scene.some({0, 1}));
    scene.stage.apply(command::GrabBody{{{-5.0, 6.0, 0.0}, {0.0f, -1.0f, 0.0f}}, 1});
    scene.stage.apply(command::ReleaseGrab{true, true}); // on the ground
    EXPECT_EQ(scene.selection(), scene.some({0, 1}));
    scene.click(6.0);
    EXPECT_EQ(scene.selection(), scene.some({3}));
    scene.click(-5.0);
    EXPECT_TRUE(scene.selection().empty());
    EXPECT_FALSE(scene.stage.state().timeline.undoable) << "to select changes nothing";
}

TEST(Groups, AClickSelectsAllOfAGroupUntilItEnds) {
    Boxes scene;
    scene.click(0.0);
    scene.stage.apply(command::GroupSelected{});
    EXPECT_FALSE(scene.stage.state().is_group) << "one body is no group";
    scene.click(4.0, true);
    EXPECT_FALSE(scene.stage.state().is_group);
    scene.stage.apply(command::GroupSelected{});
    EXPECT_TRUE(scene.stage.state().is_group);
    scene.click(2.0);
    EXPECT_EQ(scene.selection(), scene.some({1}));
    scene.click(4.0);
    EXPECT_EQ(scene.selection(), scene.some({0, 2}));
    scene.click(2.0, true);
    EXPECT_EQ(scene.selection(), scene.some({0, 1, 2}));
    EXPECT_FALSE(scene.stage.state().is_group) << "and one more";
    scene.click(0.0, true);
    EXPECT_EQ(scene.selection(), scene.some({1})) << "a group comes and goes as a whole";
    scene.click(0.0);
    scene.stage.apply(command::UngroupSelected{});
    EXPECT_FALSE(scene.stage.state().is_group);
    scene.click(0.0);
    EXPECT_EQ(scene.selection(), scene.some({0}));
}

TEST(Selection, APlainClickSelectsWhatDoesNotMoveAndASecondOneEndsIt) {
    Boxes scene;
    scene.stage.apply(command::EditBody{scene.boxes[1], edit::Type{BodyType::static_}});
    scene.stage.apply(command::EditBody{scene.boxes[2], edit::Type{BodyType::kinematic}});
    for (const std::size_t i : {1u, 2u}) {
        scene.click(2.0 * double(i));
        EXPECT_EQ(scene.selection(), scene.some({i}));
        ASSERT_TRUE(scene.stage.state().inspected);
        EXPECT_EQ(scene.stage.state().inspected->id, scene.boxes[i]);
    }
    scene.click(4.0);
    EXPECT_TRUE(scene.selection().empty());
    scene.click(0.0);
    scene.click(2.0, true);
    scene.click(2.0);
    EXPECT_EQ(scene.selection(), scene.some({1})) << "of several it becomes the only one";
    scene.stage.apply(command::RemoveSelected{});
    EXPECT_FALSE(scene.stage.world().is_valid(scene.boxes[1]));
    scene.stage.apply(command::GrabBody{{{-5.0, 6.0, 0.0}, {0.0f, -1.0f, 0.0f}}, 1});
    scene.stage.apply(command::ReleaseGrab{true, false}); // the plane, which is infinite
    EXPECT_TRUE(scene.selection().empty());
}

TEST(Groups, AreMadeStaticRemovedAndBroughtBackTogether) {
    Boxes scene;
    scene.click(0.0);
    scene.click(2.0, true);
    scene.stage.apply(command::GroupSelected{});
    command::EditBodies change;
    for (const BodyId body : scene.selection()) change.edits.emplace_back(body, edit::Type{BodyType::static_});
    scene.stage.apply(change);
    for (const std::size_t i : {0u, 1u}) EXPECT_EQ(scene.stage.world().body(scene.boxes[i]).type(), BodyType::static_);
    EXPECT_EQ(scene.stage.world().body(scene.boxes[2]).type(), BodyType::dynamic);
    scene.click(-5.0);
    scene.click(2.0); // a static body is selected together with its group
    EXPECT_EQ(scene.selection(), scene.some({0, 1}));
    scene.stage.apply(command::Undo{});
    EXPECT_EQ(scene.stage.world().body(scene.boxes[0]).type(), BodyType::dynamic);
    EXPECT_EQ(scene.stage.world().body(scene.boxes[1]).type(), BodyType::dynamic);
    scene.stage.apply(command::RemoveSelected{});
    EXPECT_EQ(scene.stage.world().bodies().size(), 3u);
    EXPECT_TRUE(scene.selection().empty());
    scene.stage.apply(command::Undo{});
    EXPECT_EQ(scene.stage.world().bodies().size(), 5u);
    scene.click(0.0);
    EXPECT_EQ(scene.selection(), scene.some({0, 1})) << "it is a group again";
}

TEST(Groups, CopiesAreAGroupJoinedAsTheOriginalsAre) {
    Boxes scene;
    scene.click(0.0);
    scene.stage.apply(command::MakeJoint{{{2.0, 0.6, 10.0}, {0.0f, 0.0f, -1.0f}}, command::JoinKind::fixed});
    ASSERT_EQ(scene.stage.world().joints().size(), 1u);
    scene.click(0.0);
    scene.click(2.0, true);
    scene.stage.apply(command::GroupSelected{});
    scene.stage.apply(command::DuplicateSelected{});
    const StageState state = scene.stage.state();
    ASSERT_EQ(state.selection.size(), 2u);
    EXPECT_TRUE(state.is_group);
    const World& world = scene.stage.world();
    for (std::size_t i = 0; i < 2; ++i) {
        const Position shift = world.body(state.selection[i]).position() - scene.place(i);
        EXPECT_NEAR(shift.x, 1.05 * 3.0, 1e-3) << "beside both of them, 3 m wide";
    }
    ASSERT_EQ(world.joints().size(), 2u);
    const JointDef& joint = world.joint_def(world.joints()[1]);
    EXPECT_EQ(joint.body_a, state.selection[0]);
    EXPECT_EQ(joint.body_b, state.selection[1]);
    scene.stage.apply(command::Undo{});
    EXPECT_EQ(world.bodies().size(), 5u);
    EXPECT_EQ(world.joints().size(), 1u);
}

// Uses the handles of the controller, as a user does.
struct Hands {
    Boxes scene{4};
    Controller controller{[this](Command command) { scene.stage.apply(command); }, {}};
    Hands(GizmoMode mode) {
        controller.gizmo.mode = mode;
        scene.click(0.0);
        scene.click(2.0, true);
        controller.update(scene.stage.state());
    }
    void drag(GizmoHandle handle, const Position& way) {
        const BodyFacts facts = *scene.stage.state().handled;
        const Position grip = controller.gizmo.grip(facts, controller.camera, handle);
        constexpr float aspect = 1.6f;
        controller.move_cursor(*controller.camera.project(grip, aspect), aspect);
        controller.button_down(MouseButton::left);
        ASSERT_TRUE(controller.gizmo.is_dragged());
        for (const double part : {0.5, 1.0}) {
            controller.move_cursor(*controller.camera.project(grip + way * part, aspect), aspect);
            controller.update(scene.stage.state());
        }
        controller.button_up(MouseButton::left);
        controller.update(scene.stage.state());
    }
};

TEST(Groups, AHandleMovesAllAndOneUndoBringsThemBack) {
    Hands hands(GizmoMode::move);
    const Position first = hands.scene.place(0), second = hands.scene.place(1), other = hands.scene.place(2);
    EXPECT_NEAR(hands.scene.stage.state().handled->center.x, 1.0, 1e-6) << "in the middle of both";
    hands.drag(GizmoHandle::y, {0.0, 1.5, 0.0});
    EXPECT_NEAR(hands.scene.place(0).y - first.y, 1.5, 0.02);
    EXPECT_NEAR(hands.scene.place(1).y - second.y, 1.5, 0.02);
    EXPECT_NEAR(hands.scene.place(1).x, second.x, 1e-4);
    EXPECT_EQ(hands.scene.place(2), other);
    hands.scene.stage.apply(command::Undo{});
    EXPECT_NEAR(hands.scene.place(0).y, first.y, 1e-6);
    EXPECT_NEAR(hands.scene.place(1).y, second.y, 1e-6);
}

TEST(Groups, AHandleScalesAllAboutTheirMiddle) {
    Hands hands(GizmoMode::scale);
    const BodyFacts facts = *hands.scene.stage.state().handled;
    EXPECT_EQ(hands.controller.gizmo.handles(facts), (std::vector{GizmoHandle::all}));
    hands.drag(GizmoHandle::all, {1.0, 0.0, 0.0});
    const World& world = hands.scene.stage.world();
    const float size = std::get<Box>(world.shape(world.body(hands.scene.boxes[0]).shapes()[0])).half_extents.x;
    EXPECT_GT(size, 0.55f);
    const double factor = double(size) / 0.5, middle = facts.center.x;
    EXPECT_NEAR(hands.scene.place(0).x, middle - factor, 1e-3);
    EXPECT_NEAR(hands.scene.place(1).x, middle + factor, 1e-3);
}

TEST(Groups, TurnAsOneBody) {
    const Position center(1.0, 2.0, 3.0);
    const HeldBody held[]{{{}, {{2.0, 2.0, 3.0}, Quat(1, 0, 0, 0)}},
                          {{}, {{1.0, 2.0, 5.0}, glm::angleAxis(0.3f, Vec3(0.0f, 1.0f, 0.0f))}}};
    const Quat quarter = glm::angleAxis(1.5707963f, Vec3(0.0f, 1.0f, 0.0f));
    const auto edits = spread(edit::Pose{center, quarter}, center, 1.0f, held);
    ASSERT_EQ(edits.size(), 2u);
    const auto& first = std::get<edit::Pose>(edits[0].second);
    const auto& second = std::get<edit::Pose>(edits[1].second);
    EXPECT_LT(glm::distance(first.position, Position(1.0, 2.0, 2.0)), 1e-5);
    EXPECT_LT(glm::distance(second.position, Position(3.0, 2.0, 3.0)), 1e-5);
    EXPECT_GT(std::abs(glm::dot(second.rotation, glm::angleAxis(1.8707963f, Vec3(0.0f, 1.0f, 0.0f)))), 0.99999f);
}

TEST(Groups, AreInTheSceneThatIsSaved) {
    std::vector<std::vector<BodyId>> saved;
    Savers savers;
    savers.scene = [&](const std::filesystem::path&, LoadedScene& scene) { saved = scene.groups; };
    Boxes scene(3, savers);
    scene.click(0.0);
    scene.click(4.0, true);
    scene.stage.apply(command::GroupSelected{});
    scene.stage.apply(command::SaveScene{"there.gltf", {}});
    EXPECT_EQ(saved, (std::vector<std::vector<BodyId>>{scene.some({0, 2})}));
    scene.stage.apply(command::ResetScene{});
    scene.click(0.0);
    EXPECT_EQ(scene.stage.state().selection.size(), 1u) << "the scene as it was loaded has none";
}

} // namespace
