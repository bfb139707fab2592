// Keys and mouse of the window. Started by window_test.sh.
#include "window_driver.h"

namespace {

using namespace cairn::viewer::test;

const Json& crate(const Json& state) {
    for (const Json& body : state.at("bodies"))
        if (body.at("name") == "crate") return body;
    static const Json none{{"position", {1e9, 1e9, 1e9}}, {"index", -1}, {"speed", 1e9}, {"screen", {0, 0}}};
    return none;
}

double crate_at(const Json& state, int axis) { return crate(state).at("position").at(std::size_t(axis)).get<double>(); }

double camera_at(const Json& state, int axis) {
    return state.at("camera").at("position").at(std::size_t(axis)).get<double>();
}

void test_bodies(Driver& driver) {
    const auto bodies = [](int count) { return [count](const Json& s) { return s.at("dynamic_count") == count; }; };
    driver.check("opens the scene",
                 [](const Json& s) { return s.at("scene").at("title") == "One box" && s.at("dynamic_count") == 1; });
    driver.key("u");
    driver.check("U adds a box", bodies(2));
    driver.key("i");
    driver.check("I adds a large sphere", bodies(3));
    driver.key("o");
    driver.check("O adds a small sphere", bodies(4));
    driver.key("j");
    driver.check("J adds a capsule", bodies(5));
    driver.key("k");
    driver.check("K adds a cylinder", bodies(6));
    driver.key("l");
    driver.check("L adds a cone", bodies(7));
    driver.key("m");
    driver.check("M adds a polyhedron", bodies(8));
    driver.key("BackSpace");
    driver.check("Backspace removes the last body", bodies(7));
    driver.key("Delete");
    driver.check("Delete resets the scene",
                 [](const Json& s) { return s.at("dynamic_count") == 1 && s.at("scene").at("loads") == 2; });
}

void test_time(Driver& driver) {
    driver.key("space");
    driver.check("Space pauses", [](const Json& s) { return s.at("paused") == true; });
    const std::uint64_t steps = driver.state().at("steps").get<std::uint64_t>();
    driver.key("period");
    driver.check("a period takes one step",
                 [&](const Json& s) { return s.at("steps") == steps + 1 && s.at("paused") == true; });
    driver.key("space");
    driver.check("Space runs again", [&](const Json& s) {
        return s.at("paused") == false && s.at("steps").get<std::uint64_t>() > steps + 5;
    });
    driver.key("bracketleft");
    driver.check("[ slows down", [](const Json& s) { return s.at("speed") == 0.5; });
    driver.key("bracketright");
    driver.check("] speeds up", [](const Json& s) { return s.at("speed") == 1.0; });
}

void test_mouse(Driver& driver) {
    const Json start = driver.state();
    const double x = crate(start).at("screen").at(0).get<double>(), y = crate(start).at("screen").at(1).get<double>();
    driver.cursor(x, y);
    driver.press();
    driver.check("a press on a body grabs and selects it",
                 [](const Json& s) { return s.at("dragging") == true && s.at("selected") == crate(s).at("index"); });
    driver.cursor(x + 40, y - 120);
    driver.check("the dragged body follows the mouse",
                 [](const Json& s) { return crate_at(s, 1) > 1.5 && crate_at(s, 0) > 0.2; });
    driver.let_go();
    driver.check("let go, it falls", [](const Json& s) { return s.at("dragging") == false && crate_at(s, 1) < 1.0; });

    const double before = camera_at(driver.state(), 0);
    driver.cursor(450, 150); // an empty place: outside the panel, the title, the inspector and the body
    driver.press();
    driver.cursor(350, 150);
    driver.let_go();
    driver.check("a drag beside bodies orbits", [&](const Json& s) {
        return std::abs(camera_at(s, 0) - before) > 0.3 && s.at("camera").at("target").at(1) == 1.0;
    });
    driver.cursor(450, 450);
    driver.xdotool("mousedown 3");
    driver.cursor(450, 60); // upwards: the camera moves down
    driver.xdotool("mouseup 3");
    driver.check("the camera stays above the ground",
                 [](const Json& s) { return camera_at(s, 1) > 0.0 && camera_at(s, 1) < 0.9; });
    driver.key("Home");
    driver.check("Home restores the view", [](const Json& s) { return std::abs(camera_at(s, 0)) < 0.01; });
    driver.xdotool("click 4");
    driver.check("the wheel zooms", [](const Json& s) { return camera_at(s, 2) < 7.9; });
}

void test_joints(Driver& driver) {
    const auto joints = [](std::size_t count) {
        return [count](const Json& s) { return s.at("joints").size() == count; };
    };
    driver.key("Delete");
    driver.key("Home");
    driver.check("reset before the joints",
                 [](const Json& s) { return s.at("scene").at("loads") == 3 && std::abs(crate_at(s, 1) - 0.5) < 0.01; });
    const Json start = driver.state();
    const double x = crate(start).at("screen").at(0).get<double>(), y = crate(start).at("screen").at(1).get<double>();
    driver.cursor(x, y - 20);
    driver.key("w");
    driver.check("W fixes the body under the cursor to the world", [](const Json& s) {
        return s.at("joints").size() == 1 && s.at("joints").at(0).at("kind") == "fixed" && s.at("selected_joint") == 0;
    });
    driver.press();
    driver.check("a drag is no joint of the scene",
                 [](const Json& s) { return s.at("dragging") == true && s.at("joints").size() == 1; });
    driver.cursor(x + 40, y - 120);
    pause_for(0.5);
    driver.let_go();
    driver.check("the fixed body has stayed", [](const Json& s) {
        return s.at("dragging") == false && std::abs(crate_at(s, 1) - 0.5) < 0.05 && std::abs(crate_at(s, 0)) < 0.05;
    });
    driver.key("Escape");
    driver.check("Escape selects no joint", [](const Json& s) { return s.at("selected_joint").is_null(); });
    const Json anchor = driver.state().at("joints").at(0).at("screen");
    driver.cursor(anchor.at(0).get<double>(), anchor.at(1).get<double>());
    driver.xdotool("click 1");
    driver.check("a click selects the body, which shows its joints", [](const Json& s) {
        return s.at("selected") == crate(s).at("index") && s.at("selected_joint").is_null();
    });
    driver.xdotool("click 1");
    driver.check("a click on an anchor selects the joint", [](const Json& s) { return s.at("selected_joint") == 0; });
    driver.key("d");
    driver.check("D removes it", joints(0));
    driver.key("b");
    driver.check("B makes a ball joint", joints(1));
    driver.key("y");
    driver.check("Y makes a hinge", joints(2));
    driver.key("t");
    driver.check("T shows all joints", [](const Json& s) { return s.at("joints_shown") == "all"; });
    driver.key("t");
    driver.check("T hides them", [](const Json& s) { return s.at("joints_shown") == "none"; });
    driver.key("t");
    driver.check("T shows those that matter",
                 [](const Json& s) { return s.at("joints_shown") == "selected or loaded"; });
}

void test_forces(Driver& driver) {
    driver.key("Delete");
    driver.check("reset before the forces", [](const Json& s) { return s.at("scene").at("loads") == 4; });
    struct ForceKey {
        const char* name;
        std::size_t axis;
        double sign;
    };
    for (const ForceKey& force : {ForceKey{"KP_6", 0, 1.0},
                                  {"KP_4", 0, -1.0},
                                  {"KP_9", 1, 1.0},
                                  {"KP_7", 1, -1.0},
                                  {"KP_2", 2, 1.0},
                                  {"KP_8", 2, -1.0},
                                  {"shift+Left", 0, -1.0}}) {
        driver.xdotool(std::string("keydown ") + force.name);
        driver.check(std::string(force.name) + " pushes while held",
                     [&](const Json& s) { return s.at("force").at(force.axis) == 40.0 * force.sign; });
        driver.xdotool(std::string("keyup ") + force.name);
        driver.check(std::string(force.name) + " ends with the key", [](const Json& s) {
            return s.at("force") == Json::array({0.0, 0.0, 0.0});
        });
    }
    driver.check("the pushed crate has moved",
                 [](const Json& s) { return std::abs(crate_at(s, 0)) + std::abs(crate_at(s, 2)) > 0.2; });
    driver.xdotool("keydown c");
    driver.check("C pulls to the center while held", [](const Json& s) { return s.at("pulled") == true; });
    driver.xdotool("keyup c");
    driver.check("C ends with the key", [](const Json& s) { return s.at("pulled") == false; });
    driver.xdotool("keydown x");
    driver.check("X freezes while held",
                 [](const Json& s) { return s.at("frozen") == true && crate(s).at("speed").get<double>() < 0.2; });
    driver.xdotool("keyup x");
    driver.check("X ends with the key", [](const Json& s) { return s.at("frozen") == false; });
}

void test_picture_and_scenes(Driver& driver) {
    driver.key("Tab");
    driver.check("Tab changes the colors", [](const Json& s) { return s.at("colors") == "mass"; });
    driver.key("g");
    driver.check("G hides the grid", [](const Json& s) { return s.at("grid") == false; });
    driver.key("v");
    driver.check("V shows what collides", [](const Json& s) { return s.at("visuals") == false; });
    driver.key("F1");
    driver.check("F1 shows the key map", [](const Json& s) { return s.at("help") == true; });
    for (const char* column : {"help.left", "help.right"})
        driver.check(std::string("to its end: ") + column, [&](const Json& s) {
            return s.at("places").contains(column) && s.at("places").at(column).at(1).get<double>() < 495.0;
        });
    driver.key("Escape");
    driver.check("Escape hides it", [](const Json& s) { return s.at("help") == false; });
    driver.key("F2");
    driver.check("F2 hides the panel", [](const Json& s) { return s.at("panel") == false; });
    driver.check("without the panel the picture has the window",
                 [](const Json& s) { return s.at("left") == 0 && s.at("size").at(0) == 800; });
    driver.key("F2");
    driver.check("the panel is beside the picture",
                 [](const Json& s) { return s.at("left") == 220 && s.at("size").at(0) == 580; });
    driver.key("1");
    driver.check("1 chooses the first scene", [](const Json& s) { return s.at("scene").at("loads") == 5; });
    const std::string first = driver.state().at("scene").at("path").get<std::string>();
    driver.key("2");
    driver.check("2 chooses the second scene", [&](const Json& s) {
        return s.at("scene").at("loads") == 6 && s.at("scene").at("path").get<std::string>() > first;
    });
    for (int i = 0; i < 3; ++i) driver.key("Prior"); // backwards past the first scene: to the end of the list
    driver.check("the list follows to the last scenes", [](const Json& s) {
        return s.at("scene").at("loads") == 9 && s.at("scene_list").at("present_in_view") == true;
    });
}

} // namespace

int main(int argc, char** argv) {
    return drive(argc, argv, [](Driver& driver) {
        test_bodies(driver);
        if (driver.failures() > 0) return;
        test_time(driver);
        test_mouse(driver);
        test_joints(driver);
        test_forces(driver);
        test_picture_and_scenes(driver);
    });
}
