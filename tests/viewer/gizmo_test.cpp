// Gizmo: handles with which the mouse moves, rotates and scales a body.
#include "viewer/controller.h"
#include "viewer/gizmo.h"
#include "viewer/scaling.h"
#include "viewer/stage.h"

#include "test_scene.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;

// A stage with a selected box, and a controller that looks at it.
struct Hand {
    Stage stage{test::load_boxes, "1"};
    Controller controller{[this](Command command) { stage.apply(command); }, {}};

    Hand() {
        stage.apply(command::SetPaused{true});
        stage.apply(command::SelectBody{stage.state().layout->bodies[1].id});
        controller.update(stage.state());
        controller.camera.set_pose({{3.0, 4.0, 8.0}, {0.0, 0.5, 0.0}});
    }
    BodyFacts facts() const { return *stage.state().inspected; }
    glm::vec2 on_screen(const Position& point) const { return *controller.camera.project(point, test::aspect); }
    void move(const glm::vec2& cursor) {
        controller.move_cursor(cursor, test::aspect);
        controller.update(stage.state());
    }
    // Grabs the handle and moves it by that distance on the screen.
    void drag(GizmoHandle handle, const glm::vec2& by) {
        const glm::vec2 start = on_screen(controller.gizmo.grip(facts(), controller.camera, handle));
        move(start);
        controller.button_down(MouseButton::left);
        for (int i = 1; i <= 5; ++i) move(start + by * (float(i) / 5.0f));
        controller.button_up(MouseButton::left);
        controller.update(stage.state());
    }
};

TEST(Gizmo, MovesAlongOneAxisAndFollowsTheCursor) {
    Hand hand;
    hand.controller.gizmo.mode = GizmoMode::move;
    for (const GizmoHandle handle : {GizmoHandle::x, GizmoHandle::y, GizmoHandle::z}) {
        const BodyFacts before = hand.facts();
        const Position grip = hand.controller.gizmo.grip(before, hand.controller.camera, handle);
        Position to = grip;
        to[int(handle)] += 1.5;
        hand.drag(handle, hand.on_screen(to) - hand.on_screen(grip));
        const Position moved = hand.facts().position - before.position;
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(moved[i], i == int(handle) ? 1.5 : 0.0, 1e-3) << int(handle);
    }
}

TEST(Gizmo, TurnsAboutOneAxisByTheAngleOfTheCursor) {
    Hand hand;
    hand.controller.gizmo.mode = GizmoMode::turn;
    const BodyFacts before = hand.facts();
    const Position grip = hand.controller.gizmo.grip(before, hand.controller.camera, GizmoHandle::y);
    const Vec3 arm(grip - before.center);
    const Vec3 turned = glm::angleAxis(0.7f, Vec3(0.0f, 1.0f, 0.0f)) * arm;
    hand.drag(GizmoHandle::y, hand.on_screen(before.center + Position(turned)) - hand.on_screen(grip));
    const Quat rotation = hand.facts().rotation;
    EXPECT_NEAR(2.0f * std::atan2(rotation.y, rotation.w), 0.7f, 2e-3f);
    EXPECT_NEAR(glm::length(hand.facts().center - before.center), 0.0, 1e-6);
}

TEST(Gizmo, ScalesTheShapeAndItsMass) {
    Hand hand;
    hand.controller.gizmo.mode = GizmoMode::scale;
    ASSERT_EQ(hand.controller.gizmo.handles(hand.facts()).size(), 4u);
    const float mass = hand.facts().mass.mass;
    const auto half_size = [&] { return hand.stage.state().layout->shapes[1].half_size; };
    hand.drag(GizmoHandle::all,
              {1.0f / 3.0f / test::aspect, 1.0f / 3.0f}); // a third of the height in total: one doubling
    EXPECT_NEAR(half_size().x, 1.0f, 1e-3f);
    EXPECT_NEAR(half_size().y, 1.0f, 1e-3f);
    EXPECT_NEAR(hand.facts().mass.mass, 8.0f * mass, 0.05f * mass);
    const Position grip = hand.controller.gizmo.grip(hand.facts(), hand.controller.camera, GizmoHandle::x);
    const Position half = 0.5 * (grip + hand.facts().center);
    hand.drag(GizmoHandle::x, hand.on_screen(half) - hand.on_screen(grip));
    EXPECT_NEAR(half_size().x, 0.5f, 1e-3f);
    EXPECT_NEAR(half_size().y, 1.0f, 1e-3f);
    EXPECT_EQ(hand.stage.state().layout->shapes[1].color, Vec3(1.0f, 0.0f, 0.0f)); // the scene's own color, as before
}

TEST(Gizmo, EachDragIsUndoneByItself) {
    Hand hand;
    hand.controller.gizmo.mode = GizmoMode::move;
    const Position start = hand.facts().position;
    hand.drag(GizmoHandle::y, {0.0f, 0.3f});
    const Position once = hand.facts().position;
    hand.drag(GizmoHandle::y, {0.0f, 0.2f});
    ASSERT_GT(hand.facts().position.y, once.y + 0.1);
    hand.stage.apply(command::Undo{});
    EXPECT_EQ(hand.facts().position, once);
    hand.stage.apply(command::Undo{});
    EXPECT_EQ(hand.facts().position, start);
    hand.stage.apply(command::Redo{});
    EXPECT_EQ(hand.facts().position, once);
    hand.controller.gizmo.mode = GizmoMode::scale;
    hand.controller.update(hand.stage.state());
    hand.drag(GizmoHandle::all, {0.2f, 0.0f});
    ASSERT_GT(hand.stage.state().layout->shapes[1].half_size.x, 0.55f);
    hand.stage.apply(command::Undo{});
    EXPECT_EQ(hand.stage.state().layout->shapes[1].half_size.x, 0.5f);
}

TEST(Gizmo, BesideTheHandlesTheMouseDoesWhatItDid) {
    Hand hand;
    hand.controller.gizmo.mode = GizmoMode::move;
    const glm::vec2 middle = hand.on_screen(hand.facts().center);
    hand.move(middle);
    hand.controller.button_down(MouseButton::left);
    hand.controller.update(hand.stage.state());
    EXPECT_TRUE(hand.controller.dragging()) << "the body itself, by its spring";
    hand.controller.button_up(MouseButton::left);
    hand.controller.gizmo.mode = GizmoMode::none;
    EXPECT_TRUE(hand.controller.gizmo.handles(hand.facts()).empty());
}

TEST(Scaling, KeepsFormAndDensityOfEveryShape) {
    World world;
    for (const Shape& shape :
         {Shape(Sphere{0.5f}), Shape(Box{{0.5f, 0.4f, 0.3f}, 0.1f}), Shape(Capsule{0.5f, 0.2f, 0.1f}),
          Shape(Cylinder{0.5f, 0.3f, {}, 0.05f}), Shape(Hull(test::cube_corners()))}) {
        const BodyId id = world.create_body();
        ShapeDef def;
        def.position = {0.2f, 0.1f, 0.0f};
        world.add_shape(id, shape, def);
        const MassProperties before = world.body(id).mass_properties();
        const std::vector<ShapeId> shapes = world.body(id).shapes();
        scale_body(world, id, Vec3(2.0f));
        const MassProperties after = world.body(id).mass_properties();
        EXPECT_EQ(world.body(id).shapes(), shapes);
        EXPECT_NEAR(after.mass / before.mass, 8.0f, 1e-3f);
        EXPECT_NEAR(after.inertia_diagonal.x / before.inertia_diagonal.x, 32.0f, 0.05f);
        EXPECT_NEAR(after.center_of_mass.x, 2.0f * before.center_of_mass.x, 1e-4f);
    }
}

TEST(Scaling, OfABodyWithAMassOfItsOwnScalesThatToo) {
    World world;
    BodyDef def;
    def.mass = 3.0f;
    const BodyId id = world.create_body(def);
    world.add_shape(id, Box{});
    EXPECT_TRUE(can_be_stretched(world, id));
    scale_body(world, id, {2.0f, 1.0f, 1.0f});
    EXPECT_FLOAT_EQ(world.body(id).mass(), 6.0f);
    world.add_shape(id, Sphere{});
    EXPECT_FALSE(can_be_stretched(world, id));
}

} // namespace
