// The window's inspector: a body is clicked, changed, copied and removed, and all of it is undone. Started by
// window_test.sh.
#include "window_driver.h"

#include <cmath>
#include <filesystem>
#include <string>

namespace {

using namespace cairn::viewer::test;

const Json& crate(const Json& state) { return state.at("bodies").at(1); }

void test_inspector(Driver& driver) {
    driver.check("nothing is inspected", [](const Json& s) { return !s.contains("inspected"); });
    const Json screen = crate(driver.state()).at("screen");
    driver.click(screen.at(0).get<double>(), screen.at(1).get<double>());
    driver.check("a click on a body opens its inspector", [](const Json& s) {
        return s.contains("inspected") && s.at("inspected").at("name") == "crate" &&
               s.at("inspected").at("mass") == 500.0 && s.at("places").contains("inspector.name");
    });
    driver.check("which is at the right, off the middle of the picture",
                 [](const Json& s) { return s.at("places").at("inspector.name").at(0).get<double>() > 600.0; });
    driver.click_on("inspector.name");
    driver.chord("ctrl", "a");
    driver.type("anvil");
    driver.key("Return");
    driver.check("it is given a name", [](const Json& s) {
        return s.at("inspected").at("name") == "anvil" && crate(s).at("name") == "anvil";
    });
    driver.check("letters that were typed are no commands", [](const Json& s) { return s.at("dynamic_count") == 1; });
    const Json mass = driver.state().at("places").at("inspector.mass");
    driver.xdotool("keydown ctrl"); // Ctrl and a click make a slider editable
    driver.click(mass.at(0).get<double>(), mass.at(1).get<double>());
    driver.xdotool("keyup ctrl");
    driver.chord("ctrl", "a");
    driver.type("20");
    driver.key("Return");
    driver.check("and a mass", [](const Json& s) { return s.at("inspected").at("mass") == 20.0; });
    driver.click_on("inspector.duplicate");
    driver.check("duplicated, the copy is selected", [](const Json& s) {
        return s.at("dynamic_count") == 2 && s.at("inspected").at("index") == 2 && s.at("inspected").at("mass") == 20.0;
    });
    driver.click_on("inspector.delete");
    driver.check("and deleted", [](const Json& s) { return s.at("dynamic_count") == 1 && !s.contains("inspected"); });
}

void test_undo(Driver& driver) {
    driver.cursor(600, 120); // away from the interface, which would take the keys
    for (const auto& [name, what] : {std::pair("remove a body", "removing"),
                                     {"duplicate a body", "the copy"},
                                     {"mass of a body", "the mass"},
                                     {"name of a body", "the name"}}) {
        driver.check(std::string("next to be undone is ") + what,
                     [&, wanted = name](const Json& s) { return s.at("timeline").at("undoable") == wanted; });
        driver.chord("ctrl", "z");
    }
    driver.check("all is as it was", [](const Json& s) {
        return s.at("dynamic_count") == 1 && crate(s).at("name") == "crate" &&
               s.at("timeline").at("undoable").is_null();
    });
}

void drag_handle(Driver& driver, std::size_t handle, double right, double down) {
    driver.check("there is handle " + std::to_string(handle),
                 [&](const Json& s) { return s.at("gizmo").at("handles").size() > handle; });
    const Json at = driver.state().at("gizmo").at("handles").at(handle);
    const double x = at.at(0).get<double>(), y = at.at(1).get<double>();
    driver.cursor(x, y);
    driver.press();
    driver.cursor(x + right, y + down);
    driver.let_go();
    pause_for(0.3);
}

void test_handles(Driver& driver) {
    // So that a lifted body stays in place.
    driver.check("undoing pauses", [](const Json& s) { return s.at("paused") == true; });
    const Json screen = crate(driver.state()).at("screen");
    driver.click(screen.at(0).get<double>(), screen.at(1).get<double>());
    driver.key("q");
    driver.check("Q shows handles to move it", [](const Json& s) { return s.at("gizmo").at("mode") == "move"; });
    drag_handle(driver, 1, 0.0, -60.0);
    driver.check("the upward one lifts it straight up", [](const Json& s) {
        const Json& place = crate(s).at("position");
        return place.at(1).get<double>() > 1.2 && std::abs(place.at(0).get<double>()) < 0.01;
    });
    driver.chord("ctrl", "z");
    driver.check("which is undone",
                 [](const Json& s) { return std::abs(crate(s).at("position").at(1).get<double>() - 0.5) < 0.01; });
    driver.click_on("inspector.turn");
    drag_handle(driver, 1, 40.0, 0.0);
    driver.check("a ring turns it", [](const Json& s) {
        const Json& rotation = s.at("inspected").at("rotation");
        return std::abs(rotation.at(2).get<double>()) > 0.1 && std::abs(rotation.at(1).get<double>()) < 0.01;
    });
    driver.click_on("inspector.scale");
    const double mass = driver.state().at("inspected").at("mass").get<double>();
    drag_handle(driver, 3, 80.0, 0.0);
    driver.check("the dot in the middle makes it larger, and heavier",
                 [&](const Json& s) { return s.at("inspected").at("mass").get<double>() > 1.5 * mass; });
    driver.cursor(600, 120);
    for (const char* name : {"scale a body", "move or rotate a body"}) {
        driver.check(std::string("undoable: ") + name,
                     [&](const Json& s) { return s.at("timeline").at("undoable") == name; });
        driver.chord("ctrl", "z");
    }
    driver.check("all is as it was", [&](const Json& s) {
        return s.at("timeline").at("undoable").is_null() && s.at("inspected").at("mass") == mass;
    });
    driver.click_on("inspector.scale");
    driver.check("no handles", [](const Json& s) { return s.at("gizmo").at("mode") == "none"; });
    driver.cursor(600, 120);
    driver.key("space");
}

// With a copy of the crate beside it: a selection rectangle around both, a group of them, and undoing all of it.
void test_frame(Driver& driver) {
    driver.key("space");
    driver.chord("ctrl", "d");
    driver.check("a copy stands beside it", [](const Json& s) { return s.at("dynamic_count") == 2; });
    driver.key("Escape");
    driver.key("F2"); // otherwise the panel would receive the press
    driver.key("F");  // frames both with a margin
    driver.check("nothing is selected", [](const Json& s) { return s.at("selection").empty(); });
    const Json one = crate(driver.state()).at("screen"), other = driver.state().at("bodies").at(2).at("screen");
    const double apart = other.at(0).get<double>() - one.at(0).get<double>();
    const double left = one.at(0).get<double>() - apart, top = one.at(1).get<double>() - apart;
    driver.xdotool("keydown shift");
    driver.cursor(left, top);
    driver.press();
    driver.cursor(other.at(0).get<double>() + apart, other.at(1).get<double>() + apart);
    driver.check("Shift and a drag beside bodies span a frame", [&](const Json& s) {
        return s.at("frame").is_array() && std::abs(s.at("frame").at(0).get<double>() - left) < 2;
    });
    driver.let_go();
    driver.xdotool("keyup shift");
    driver.check("which selects both", [](const Json& s) {
        return s.at("selection") == Json::array({1, 2}) && s.at("frame").is_null();
    });
    driver.chord("ctrl", "g");
    driver.check("Ctrl+G makes them a group", [](const Json& s) {
        return s.at("is_group") == true && s.at("timeline").at("undoable") == "group bodies";
    });
    driver.chord("ctrl", "z");
    driver.check("Ctrl+Z undoes that", [](const Json& s) {
        return s.at("is_group") == false && s.at("timeline").at("undoable") == "duplicate a body";
    });
    driver.chord("ctrl", "z");
    driver.check("and the copy", [](const Json& s) { return s.at("dynamic_count") == 1; });
    driver.key("F2");
    driver.key("Home");
    driver.key("space");
}

void test_saving(Driver& driver) {
    driver.chord("ctrl", "s");
    driver.check("Ctrl+S saves the scene", [&](const Json& s) {
        const std::string notice = s.at("notice").get<std::string>();
        return notice.starts_with("Saved ") && notice.ends_with(".gltf") &&
               std::filesystem::exists(driver.folder() + "/" + notice.substr(6));
    });
}

void test_comfort(Driver& driver) {
    driver.cursor(400, 400);
    driver.chord("ctrl", "p");
    driver.check("Ctrl+P opens the list of commands", [](const Json& s) { return s.at("palette") == true; });
    driver.type("light theme");
    driver.key("Return");
    driver.check("which does what is typed", [](const Json& s) {
        return s.at("palette") == false && s.at("light_theme") == true && s.at("dynamic_count") == 1;
    });
    driver.chord("ctrl", "p");
    driver.check("it opens again", [](const Json& s) { return s.at("palette") == true; });
    driver.key("Escape");
    driver.check("Escape closes it", [](const Json& s) { return s.at("palette") == false; });
    driver.chord("ctrl", "5");
    driver.chord("ctrl", "1");
    driver.check("from the front with parallel rays", [](const Json& s) {
        return s.at("parallel") == true && std::abs(s.at("camera").at("position").at(0).get<double>()) < 1e-3;
    });
    driver.chord("ctrl", "3");
    driver.check("from the top", [](const Json& s) {
        const Json& eye = s.at("camera").at("position");
        return eye.at(1).get<double>() > 10.0 * std::abs(eye.at(2).get<double>());
    });
    if (std::system("command -v ffmpeg >/dev/null") != 0) return;
    driver.key("F10");
    driver.check("F10 begins a video",
                 [](const Json& s) { return s.at("notice") == "A video is being recorded: F10 ends it."; });
    driver.key("F10");
    driver.check("and ends it", [&](const Json& s) {
        const std::string notice = s.at("notice").get<std::string>();
        return notice.ends_with(".mp4") && std::filesystem::file_size(driver.folder() + "/" + notice.substr(6)) > 1000;
    });
}

} // namespace

int main(int argc, char** argv) {
    return drive(argc, argv, [](Driver& driver) {
        driver.check("opens the scene", [](const Json& s) { return s.at("scene").at("title") == "One box"; });
        test_inspector(driver);
        if (driver.failures() > 0) return;
        test_undo(driver);
        test_handles(driver);
        test_frame(driver);
        test_saving(driver);
        test_comfort(driver);
    });
}
