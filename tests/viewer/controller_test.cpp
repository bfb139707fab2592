#include "viewer/controller.h"

#include "viewer/palette.h"

#include "test_scene.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <iterator>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;

using test::aspect;

// A controller whose commands go directly to a stage, as the physics thread would pass them on.
struct Desk {
    Stage stage{test::load_boxes, "2"};
    std::vector<Command> posted;
    Controller controller{[this](Command command) {
                              posted.push_back(command);
                              stage.apply(command);
                          },
                          {{"2", "two"}, {"5", "five"}, {"0", "none"}},
                          {".gltf", ".glb"}};

    Desk() { controller.update(stage.state()); }
    std::size_t bodies() const { return stage.state().layout->bodies.size(); }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) {
            stage.step();
            controller.update(stage.state());
        }
    }
    void point_at(const Position& point) {
        const auto device = controller.camera.project(point, aspect);
        ASSERT_TRUE(device);
        controller.move_cursor(*device, aspect);
    }
};

TEST(Controller, KeysAddAndRemoveBodies) {
    Desk desk;
    for (const char* key : {"U", "I", "O"}) desk.controller.key_down("", key);
    EXPECT_EQ(desk.bodies(), 6u);
    desk.controller.key_down("", "Backspace");
    EXPECT_EQ(desk.bodies(), 5u);
    desk.controller.key_down("", "Delete");
    EXPECT_EQ(desk.bodies(), 3u);
}

TEST(Controller, EveryShapeHasAKey) {
    Desk desk;
    const auto newest = [&desk] { return desk.stage.state().layout->shapes.back(); };
    desk.controller.key_down("", "J");
    EXPECT_EQ(newest().type, ShapeType::capsule);
    desk.controller.key_down("", "K");
    EXPECT_EQ(newest().type, ShapeType::cylinder);
    EXPECT_GT(newest().half_size.z, 0.0f);
    desk.controller.key_down("", "L");
    EXPECT_EQ(newest().type, ShapeType::cylinder);
    EXPECT_EQ(newest().half_size.z, 0.0f); // a cone
    desk.controller.key_down("", "M");
    EXPECT_EQ(newest().type, ShapeType::hull);
    EXPECT_EQ(desk.bodies(), 7u);
    EXPECT_EQ(desk.stage.state().message.text, "");
}

TEST(Controller, PolyhedraVaryAndShareTheirMeshes) {
    Desk desk;
    std::set<SpawnSettings::Kind> kinds;
    for (int i = 0; i < 40; ++i) {
        desk.controller.key_down("", "M");
        kinds.insert(std::get<command::Spawn>(desk.posted.back()).settings.kind);
    }
    EXPECT_EQ(kinds.size(), std::size(polyhedron_kinds));
    EXPECT_EQ(desk.bodies(), 43u);
    EXPECT_EQ(desk.stage.state().layout->meshes.size(), std::size(polyhedron_kinds));
}

TEST(Controller, ADroppedSceneIsOpened) {
    Desk desk;
    desk.controller.drop_files(std::vector<std::string>{"/home/me/wood.png", "/home/me/Bridge.GLB"});
    ASSERT_TRUE(std::holds_alternative<command::LoadScene>(desk.posted.back()));
    EXPECT_EQ(std::get<command::LoadScene>(desk.posted.back()).path, "/home/me/Bridge.GLB");
    // The loader of this test cannot open the file: the current scene stays, and a message gives the reason.
    EXPECT_EQ(desk.stage.state().path, "2");
    EXPECT_EQ(desk.bodies(), 3u);
    EXPECT_NE(desk.stage.state().message.text.find("Bridge.GLB"), std::string::npos);
}

TEST(Controller, ADroppedFileThatIsNoSceneLeavesAMessage) {
    Desk desk;
    desk.controller.drop_files(std::vector<std::string>{"/home/me/letter.txt"});
    EXPECT_EQ(desk.stage.state().path, "2");
    const std::string text = desk.stage.state().message.text;
    EXPECT_NE(text.find("letter.txt"), std::string::npos);
    EXPECT_NE(text.find(".gltf"), std::string::npos);
    const std::size_t posted = desk.posted.size();
    desk.controller.drop_files({});
    EXPECT_EQ(desk.posted.size(), posted);
}

TEST(Controller, KeyRepeatAddsNothing) {
    Desk desk;
    desk.controller.key_down("", "U");
    desk.controller.key_down("", "U", true);
    EXPECT_EQ(desk.bodies(), 4u);
}

TEST(Controller, ForceLastsAsLongAsItsKey) {
    Desk desk;
    desk.controller.key_down("", "KP6");
    EXPECT_EQ(desk.stage.state().force, Vec3(force_key_acceleration, 0.0f, 0.0f));
    desk.controller.key_down("", "KP9");
    EXPECT_EQ(desk.stage.state().force, Vec3(force_key_acceleration, force_key_acceleration, 0.0f));
    desk.controller.key_up("KP6");
    EXPECT_EQ(desk.stage.state().force, Vec3(0.0f, force_key_acceleration, 0.0f));
    desk.controller.release_all();
    EXPECT_EQ(desk.stage.state().force, Vec3(0.0f));
}

TEST(Controller, ForceEndsEvenIfShiftIsLetGoFirst) {
    Desk desk;
    desk.controller.key_down("Shift+", "Left");
    EXPECT_LT(desk.stage.state().force.x, 0.0f);
    desk.controller.key_up("Left"); // Shift has been released by now
    EXPECT_EQ(desk.stage.state().force, Vec3(0.0f));
}

TEST(Controller, HeldKeysActOnANewSceneToo) {
    Desk desk;
    desk.controller.key_down("", "C");
    desk.controller.key_down("", "2");
    EXPECT_FALSE(desk.stage.state().pulled);
    desk.controller.update(desk.stage.state());
    EXPECT_TRUE(desk.stage.state().pulled);
    desk.controller.key_up("C");
    EXPECT_FALSE(desk.stage.state().pulled);
}

TEST(Controller, NumberAndPageKeysChooseScenes) {
    Desk desk;
    desk.controller.key_down("", "2");
    desk.controller.update(desk.stage.state());
    EXPECT_EQ(desk.stage.state().path, "5");
    desk.controller.key_down("", "PageDown");
    desk.controller.update(desk.stage.state());
    EXPECT_EQ(desk.stage.state().path, "0");
    desk.controller.key_down("", "PageDown");
    desk.controller.update(desk.stage.state());
    EXPECT_EQ(desk.stage.state().path, "2");
    desk.controller.key_down("", "9"); // there is no ninth scene
    EXPECT_EQ(desk.stage.state().path, "2");
}

TEST(Controller, ResetKeepsTheCameraAndANewSceneBringsItsOwn) {
    Desk desk;
    desk.controller.key_down("", "Right");
    const Position turned = desk.controller.camera.position();
    desk.controller.key_down("", "Delete");
    desk.controller.update(desk.stage.state());
    EXPECT_EQ(desk.controller.camera.position(), turned);
    desk.controller.key_down("", "2");
    desk.controller.update(desk.stage.state());
    EXPECT_NE(desk.controller.camera.position(), turned);
}

TEST(Controller, ParallelRaysOfASceneEndWithItAndThoseOfTheUserStay) {
    const auto load = [](const std::string& path) {
        LoadedScene scene = test::boxes_on_plane(1);
        scene.camera.is_parallel = path == "flat";
        return scene;
    };
    Stage stage(load, "flat");
    Controller controller([&](Command command) { stage.apply(command); }, {{"flat", ""}, {"deep", ""}});
    const auto key = [&](const char* modifiers, const char* name) {
        controller.key_down(modifiers, name);
        controller.update(stage.state());
        return controller.camera.is_parallel();
    };
    controller.update(stage.state());
    EXPECT_TRUE(controller.camera.is_parallel()) << "at once";
    EXPECT_FALSE(key("", "2"));
    EXPECT_TRUE(key("", "1"));
    EXPECT_FALSE(key("Ctrl+", "5"));
    EXPECT_TRUE(key("", "Home")) << "the scene's own view";
    EXPECT_FALSE(key("", "2"));
    EXPECT_TRUE(key("Ctrl+", "5"));
    EXPECT_TRUE(key("", "1"));
    EXPECT_TRUE(key("", "2"));
}

TEST(Controller, ParallelRaysThatComeFromAboveStayAboveTheGroundWhereverTheEyeIs) {
    const auto load = [](const std::string&) {
        LoadedScene scene = test::boxes_on_plane(1);
        scene.camera = {{0.0, -2.0, 5.0}, {0.0, -4.0, 0.0}}; // below the plane and looking further down
        scene.camera.is_parallel = true;
        return scene;
    };
    Stage stage(load, "flat");
    Controller controller([&](Command command) { stage.apply(command); }, {});
    controller.update(stage.state());
    for (int i = 0; i < 60; ++i) controller.key_down("", "Down", i > 0);
    EXPECT_LT(controller.camera.forward().y, 0.01f);
}

TEST(Controller, DraggingABodyMovesItAndNotTheCamera) {
    Desk desk;
    const Position eye = desk.controller.camera.position();
    desk.point_at({0.0, 0.5, 0.5});
    desk.controller.button_down(MouseButton::left);
    desk.run(1);
    EXPECT_TRUE(desk.controller.dragging());
    desk.point_at({0.0, 2.5, 0.5});
    desk.run(60);
    EXPECT_GT(desk.stage.state().current->transforms[1].position.y, 1.6);
    desk.controller.button_up(MouseButton::left);
    desk.run(90);
    EXPECT_LT(desk.stage.state().current->transforms[1].position.y, 1.0);
    EXPECT_EQ(desk.controller.camera.position(), eye);
}

TEST(Controller, DraggingBesideBodiesOrbits) {
    Desk desk;
    const Position eye = desk.controller.camera.position();
    desk.controller.move_cursor({0.0f, 0.9f}, aspect); // no body there
    desk.controller.button_down(MouseButton::left);
    desk.run(1);
    desk.controller.move_cursor({0.3f, 0.9f}, aspect);
    EXPECT_FALSE(desk.controller.dragging());
    EXPECT_LT(desk.controller.camera.position().x, eye.x); // the scene follows the hand
    EXPECT_EQ(desk.controller.camera.target(), Position(0.0, 0.5, 0.0));
    desk.controller.button_up(MouseButton::left);
    const Position after = desk.controller.camera.position();
    desk.controller.move_cursor({0.0f, 0.0f}, aspect);
    EXPECT_EQ(desk.controller.camera.position(), after);
}

TEST(Controller, ADragEndsWhenItsBodyIsRemoved) {
    Desk desk;
    desk.point_at({0.0, 0.5, 0.5});
    desk.controller.button_down(MouseButton::left);
    desk.run(1);
    ASSERT_TRUE(desk.controller.dragging());
    desk.controller.key_down("", "R");
    desk.run(1);
    EXPECT_FALSE(desk.controller.dragging());
    EXPECT_EQ(desk.bodies(), 2u);
    EXPECT_NE(desk.stage.state().message.text, "");
}

TEST(Controller, FrameLooksAtTheSelection) {
    Desk desk;
    desk.point_at({2.0, 0.5, 0.5});
    desk.controller.button_down(MouseButton::left);
    desk.controller.button_up(MouseButton::left);
    desk.controller.update(desk.stage.state());
    ASSERT_TRUE(desk.stage.state().selected);
    desk.controller.key_down("", "F");
    EXPECT_LT(glm::distance(desk.controller.camera.target(), Position(2.0, 0.5, 0.0)), 0.05);
    desk.controller.key_down("", "Home");
    EXPECT_EQ(desk.controller.camera.target(), Position(0.0, 0.5, 0.0));
}

TEST(Controller, TabGoesThroughAllColorsAndIslandsAreFoundOnlyWhenShown) {
    Desk desk;
    bool islands_shown = false;
    for (int i = 0; i < color_mode_count; ++i) {
        desk.controller.key_down("", "Tab");
        EXPECT_EQ(desk.stage.state().current->islands.empty(), desk.controller.colors != ColorMode::island);
        islands_shown = islands_shown || desk.controller.colors == ColorMode::island;
    }
    EXPECT_TRUE(islands_shown);
    EXPECT_EQ(desk.controller.colors, ColorMode::scene);
}

TEST(Controller, TimeKeys) {
    Desk desk;
    desk.controller.key_down("", "Space");
    EXPECT_TRUE(desk.stage.state().paused);
    desk.controller.key_down("", "[");
    desk.controller.key_down("", "[");
    EXPECT_EQ(desk.stage.state().speed, 0.25);
    desk.controller.key_down("", "]");
    EXPECT_EQ(desk.stage.state().speed, 0.5);
}

TEST(Controller, TheCameraStaysAboveThePlaneOfTheScene) {
    Desk desk;
    for (int i = 0; i < 60; ++i) desk.controller.key_down("", "Down", i > 0);
    EXPECT_GT(desk.controller.camera.position().y, 0.0);
    EXPECT_LT(desk.controller.camera.position().y, 1.0);
    desk.controller.wheel(-20.0f);
    EXPECT_GT(desk.controller.camera.position().y, 0.0);
}

TEST(Controller, ALineLeadsFromTheGrabbedPointToTheCursorWhileDragging) {
    Desk desk;
    const Position grabbed(0.0, 0.5, 0.5), cursor(-1.5, 3.0, 0.5);
    const auto frame = [&desk] {
        const StageState state = desk.stage.state();
        return make_frame(*state.layout, *state.previous, *state.current, 1.0f, desk.controller.camera.pose(),
                          desk.controller.frame_options(state));
    };
    EXPECT_TRUE(frame().strokes.empty());
    desk.point_at(grabbed);
    desk.controller.button_down(MouseButton::left);
    desk.controller.update(desk.stage.state());
    desk.point_at(cursor);
    desk.controller.update(desk.stage.state());
    const RenderFrame dragged = frame();
    ASSERT_EQ(dragged.strokes.size(), 3u); // a line, and a dot at each end
    const Stroke& line = dragged.strokes[0];
    EXPECT_LT(glm::distance(dragged.origin + Position(line.from), grabbed), 0.02);
    const auto end = desk.controller.camera.project(dragged.origin + Position(line.to), aspect);
    const auto wanted = desk.controller.camera.project(cursor, aspect);
    ASSERT_TRUE(end && wanted);
    EXPECT_LT(glm::distance(*end, *wanted), 1e-3f);
    EXPECT_GE(line.width, 2.0f);
    desk.run(120); // the body follows the cursor, which shortens the line
    EXPECT_LT(glm::length(frame().strokes[0].to - frame().strokes[0].from), 0.5f);
    desk.controller.button_up(MouseButton::left);
    desk.controller.update(desk.stage.state());
    for (const Stroke& stroke : frame().strokes) EXPECT_EQ(stroke.color, selection_color()) << "the line is gone";
}

} // namespace
