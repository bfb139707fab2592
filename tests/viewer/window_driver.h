// Sends key presses and mouse movements to a running viewer's window through xdotool, and reads the state that the
// viewer reports.
#pragma once

#include <nlohmann/json.hpp>

#include <signal.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <thread>
#include <utility>

namespace cairn::viewer::test {

using Json = nlohmann::json;

inline void pause_for(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

class Driver {
  public:
    Driver(std::string folder, pid_t viewer) : folder_(std::move(folder)), viewer_(viewer) {}

    int failures() const { return failures_; }
    const std::string& folder() const { return folder_; }

    // The latest report; null if there is none.
    Json state() const {
        std::ifstream file(folder_ + "/state.json");
        return Json::parse(file, nullptr, false);
    }

    /// Waits until the condition holds; fails after fifteen seconds.
    void check(const std::string& name, const std::function<bool(const Json&)>& condition) {
        for (int i = 0; i < 150 && kill(viewer_, 0) == 0; ++i) {
            const Json now = state();
            if (now.is_object() && condition(now)) {
                std::cout << "ok      " << name << std::endl;
                return;
            }
            pause_for(0.1);
        }
        std::cout << "FAILED  " << name << "\n" << state().dump() << std::endl;
        ++failures_;
    }

    bool xdotool(const std::string& arguments) const { return std::system(("xdotool " + arguments).c_str()) == 0; }
    // Holds the key long enough for a slow frame to notice.
    void key(const std::string& name) const {
        xdotool("keydown " + name);
        pause_for(0.15);
        xdotool("keyup " + name);
        pause_for(0.15);
    }
    void chord(const std::string& modifiers, const std::string& name) const {
        xdotool("keydown " + modifiers);
        key(name);
        xdotool("keyup " + modifiers);
    }
    void type(const std::string& text) const {
        xdotool("type --delay 60 '" + text + "'");
        pause_for(0.3);
    }
    void click(double x, double y) const {
        cursor(x, y);
        press();
        let_go();
        pause_for(0.3);
    }
    /// Clicks an element of the interface whose position the report contains.
    void click_on(const std::string& place) {
        check("there is " + place,
              [&](const Json& s) { return s.contains("places") && s.at("places").contains(place); });
        const auto place_now = [&] { return state().at("places").value(place, Json()); };
        Json at = place_now();
        for (int i = 0; i < 20; ++i) { // the element may still be moving while windows open and grow
            pause_for(0.1);
            const Json before = std::exchange(at, place_now());
            if (at.is_array() && at == before) break;
        }
        click(at.at(0).get<double>(), at.at(1).get<double>());
    }
    void cursor(double x, double y) const {
        xdotool("mousemove --window " + window_ + " " + std::to_string(int(x)) + " " + std::to_string(int(y)));
        pause_for(0.3);
    }
    void press() const {
        xdotool("mousedown 1");
        pause_for(0.4);
    }
    void let_go() const { xdotool("mouseup 1"); }

    // Finds the window; returns false if none appears within a minute.
    bool find_window() {
        const std::string file = folder_ + "/window";
        for (int i = 0; i < 300 && kill(viewer_, 0) == 0; ++i) {
            if (std::system(("xdotool search --onlyvisible --name Cairn >" + file).c_str()) == 0) {
                std::ifstream(file) >> window_;
                // Without a window manager the keyboard input goes to the focused window.
                return !window_.empty() && xdotool("windowfocus " + window_);
            }
            pause_for(0.2);
        }
        return false;
    }

  private:
    std::string folder_, window_;
    pid_t viewer_;
    int failures_ = 0;
};

/// The `main` function of a driver: waits for the window, runs the tests, and ends the viewer.
inline int drive(int argc, char** argv, const std::function<void(Driver&)>& tests) {
    if (argc != 3) {
        std::cerr << "usage: DRIVER FOLDER VIEWER_PROCESS\n";
        return 2;
    }
    Driver driver(argv[1], pid_t(std::stol(argv[2])));
    if (!driver.find_window()) {
        std::cout << "FAILED  no window appeared\n";
        return 1;
    }
    driver.cursor(700, 480);
    tests(driver);
    driver.chord("ctrl", "q");
    std::cout << driver.failures() << " failures" << std::endl;
    return driver.failures() == 0 ? 0 : 1;
}

} // namespace cairn::viewer::test
