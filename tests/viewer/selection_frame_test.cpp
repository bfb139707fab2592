// A rectangle drawn with the mouse selects the bodies in it.
#include "viewer/controller.h"
#include "viewer/selection_frame.h"
#include "viewer/stage.h"

#include "test_scene.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;

using test::aspect;

// Four boxes in a row, 2 m apart on a plane, and the controller of a window that looks at them.
struct FrameDesk {
    Stage stage{test::load_boxes, "4"};
    Controller controller{[this](Command command) { stage.apply(command); }, {}};
    std::vector<BodyId> boxes;

    FrameDesk() {
        stage.apply(command::SetPaused{true});
        for (const BodyLayout& body : stage.state().layout->bodies)
            if (body.type == BodyType::dynamic) boxes.push_back(body.id);
        controller.update(stage.state());
    }
    glm::vec2 seen(const Position& point) const { return *controller.camera.project(point, aspect); }
    // Drags from one corner to the other with the button down; `answered`: the stage has already reported what the
    // press hit.
    void span(const glm::vec2& from, const glm::vec2& to, bool answered = true) {
        controller.set_constraint(DragConstraint::vertical); // as with Shift
        controller.move_cursor(from, aspect);
        controller.button_down(MouseButton::left);
        if (answered) controller.update(stage.state());
        controller.move_cursor(to, aspect);
    }
    void let_go() {
        controller.button_up(MouseButton::left);
        controller.set_constraint(DragConstraint::view_plane);
        controller.update(stage.state());
    }
    std::vector<BodyId> selection() const { return test::selection_of(stage); }
    std::vector<BodyId> some(std::initializer_list<std::size_t> indices) const { return test::some_of(boxes, indices); }
    // Corners that enclose the first two boxes entirely, and cut the third one.
    glm::vec2 low() const { return seen({-1.0, -0.2, 1.0}); }
    glm::vec2 high() const { return seen({4.0, 2.0, 0.0}); }
};

TEST(SelectionFrame, ShiftAndADragBesideBodiesSelectWhatLiesInItAsAWhole) {
    for (const bool answered : {true, false}) { // a slow stage receives both ends of the drag at once
        FrameDesk desk;
        const Position eye = desk.controller.camera.position();
        desk.span(desk.high(), desk.low(), answered); // from any corner
        desk.let_go();
        EXPECT_EQ(desk.selection(), desk.some({0, 1})) << answered;
        EXPECT_EQ(desk.controller.camera.position(), eye) << "it does not orbit";
        EXPECT_FALSE(desk.stage.state().timeline.undoable) << "to select changes nothing";
    }
}

TEST(SelectionFrame, IsShownWhileItIsSpannedAndLightsUpWhatItWouldSelect) {
    FrameDesk desk;
    EXPECT_FALSE(desk.controller.selection_frame());
    desk.span(desk.low(), desk.high());
    const auto frame = desk.controller.selection_frame();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->low, desk.low());
    EXPECT_EQ(frame->high, desk.high());
    EXPECT_EQ(desk.controller.frame_options(desk.stage.state()).selection, desk.some({0, 1}));
    EXPECT_TRUE(desk.selection().empty());
    desk.controller.key_down("", "Escape");
    EXPECT_FALSE(desk.controller.selection_frame());
    desk.let_go();
    EXPECT_TRUE(desk.selection().empty()) << "Escape takes it back";
}

TEST(SelectionFrame, AddsToWhatIsSelectedAndTakesGroupsAsAWhole) {
    FrameDesk desk;
    desk.stage.apply(command::SelectBody{desk.boxes[1]});
    desk.stage.apply(command::GrabBody{{{6.0, 0.6, 10.0}, {0.0f, 0.0f, -1.0f}}, 1});
    desk.stage.apply(command::ReleaseGrab{true, true});
    desk.stage.apply(command::GroupSelected{});
    desk.stage.apply(command::SelectBody{desk.boxes[2]});
    desk.controller.update(desk.stage.state());
    desk.span(desk.low(), desk.high());
    desk.let_go();
    EXPECT_EQ(desk.selection(), desk.some({0, 1, 2, 3}));
    EXPECT_EQ(desk.stage.state().selected, desk.boxes[1]) << "windows tell about the last one";
}

TEST(SelectionFrame, AnEmptyOneSaysSoAndLeavesTheSelection) {
    FrameDesk desk;
    desk.stage.apply(command::SelectBody{desk.boxes[3]});
    desk.span({-0.9f, 0.9f}, {-0.6f, 0.7f});
    desk.let_go();
    EXPECT_EQ(desk.selection(), desk.some({3}));
    EXPECT_NE(desk.stage.state().message.text, "");
}

TEST(SelectionFrame, ADragThatBeginsOnABodyPullsItUpAndDown) {
    for (const bool answered : {true, false}) {
        FrameDesk desk;
        desk.stage.apply(command::Spawn{box_preset(), {2.0, 5.0, 0.0}}); // lies inside what would be the rectangle
        desk.controller.update(desk.stage.state());
        desk.span(desk.seen({0.0, 0.5, 0.5}), desk.seen({5.0, 9.0, 0.0}), answered);
        EXPECT_FALSE(desk.controller.selection_frame());
        EXPECT_EQ(desk.controller.dragging(), answered);
        desk.let_go();
        EXPECT_EQ(desk.selection(), desk.some({0}));
    }
}

TEST(SelectionFrame, WithoutShiftADragBesideBodiesOrbits) {
    FrameDesk desk;
    const Position eye = desk.controller.camera.position();
    desk.controller.move_cursor(desk.high(), aspect);
    desk.controller.button_down(MouseButton::left);
    desk.controller.update(desk.stage.state());
    desk.controller.set_constraint(DragConstraint::vertical); // pressed later: only the beginning of the drag counts
    desk.controller.move_cursor(desk.low(), aspect);
    EXPECT_FALSE(desk.controller.selection_frame());
    desk.let_go();
    EXPECT_NE(desk.controller.camera.position(), eye);
    EXPECT_TRUE(desk.selection().empty());
}

// A camera that looks along -z from a distance of 10 m, so that 0.1 of the picture's height is 0.414 m at the origin.
struct View {
    World world;
    OrbitCamera camera{{{0.0, 0.0, 10.0}, {0.0, 0.0, 0.0}}};
    BodyId add(const Position& position, const Shape& shape, BodyType type = BodyType::dynamic) {
        BodyDef def = test::body_at(position);
        def.type = type;
        const BodyId body = world.create_body(def);
        world.add_shape(body, shape);
        return body;
    }
    std::vector<BodyId> within(const Position& low, const Position& high) {
        MeshCache meshes;
        const WorldLayout layout = read_layout(world, {}, meshes);
        return bodies_within(SelectionFrame::between(*camera.project(low, aspect), *camera.project(high, aspect)),
                             layout, read_motion(world, layout), camera, aspect);
    }
};

TEST(SelectionFrame, BallsAreInItByTheirOutline) {
    View view;
    const BodyId ball = view.add({0.0, 0.0, 0.0}, Sphere{1.0f});
    EXPECT_EQ(view.within({-1.01, -1.01, 0.0}, {1.01, 1.01, 0.0}), std::vector{ball});
    EXPECT_TRUE(view.within({-0.99, -1.01, 0.0}, {1.01, 1.01, 0.0}).empty());
    EXPECT_TRUE(view.within({-1.01, -1.01, 0.0}, {1.01, 0.99, 0.0}).empty());
}

TEST(SelectionFrame, AllShapesOfABodyCountAndHiddenBodiesAreFound) {
    View view;
    const BodyId wide = view.add({0.0, 0.0, 0.0}, Box{.half_extents = {0.5f, 0.5f, 0.5f}});
    ShapeDef aside;
    aside.position = {3.0f, 0.0f, 0.0f};
    view.world.add_shape(wide, Sphere{0.2f}, aside);
    const BodyId hidden = view.add({0.0, 0.0, -5.0}, Hull(test::cube_corners()));
    EXPECT_EQ(view.within({-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}), std::vector{hidden});
    EXPECT_EQ(view.within({-1.0, -1.0, 0.0}, {3.5, 1.0, 0.0}), (std::vector{wide, hidden}));
}

TEST(SelectionFrame, HasNoPlanesAndNothingBehindTheEye) {
    View view;
    view.add({0.0, -1.0, 0.0}, Plane{}, BodyType::static_);
    view.add({0.0, 0.0, 20.0}, Sphere{0.1f});
    const BodyId wall = view.add({0.0, 0.0, -2.0}, Box{.half_extents = {1.0f, 1.0f, 0.1f}}, BodyType::static_);
    const BodyId empty = view.world.create_body(test::body_at({0.5, 0.5, 0.0}));
    EXPECT_EQ(view.within({-90.0, -90.0, 0.0}, {90.0, 90.0, 0.0}), (std::vector{wall, empty}));
}

} // namespace
