// The timeline of the window: scrubbed with the mouse, played backwards, undone by keys. Started by window_test.sh.
#include "window_driver.h"

#include <filesystem>

namespace {

using namespace cairn::viewer::test;

std::uint64_t now(const Json& state) { return state.at("timeline").at("now").get<std::uint64_t>(); }
std::uint64_t last(const Json& state) { return state.at("timeline").at("last").get<std::uint64_t>(); }

// The x coordinate of the timeline's track at that share of its length, pixels.
double on_bar(const Json& state, double share) {
    const Json& bar = state.at("timeline").at("bar");
    return bar.at(0).get<double>() + share * (bar.at(1).get<double>() - bar.at(0).get<double>());
}
double bar_y(const Json& state) { return state.at("timeline").at("bar").at(2).get<double>(); }

void test_scrubbing(Driver& driver) {
    driver.check("the past is kept", [](const Json& s) { return last(s) > 60 && now(s) == last(s); });
    driver.key("u");
    driver.check("U adds a box, and a mark", [](const Json& s) {
        return s.at("dynamic_count") == 2 && s.at("timeline").at("marks").at("change") == 1;
    });
    driver.check("it falls, which is another mark",
                 [](const Json& s) { return s.at("timeline").at("marks").at("impact").get<int>() >= 1; });
    driver.key("space");
    const Json start = driver.state();
    driver.cursor(on_bar(start, 0.9), bar_y(start));
    driver.press();
    driver.check("a press on the bar goes to a moment", [&](const Json& s) {
        return s.at("paused") == true && std::abs(double(now(s)) / double(last(s)) - 0.9) < 0.03;
    });
    driver.cursor(on_bar(start, 0.2), bar_y(start));
    driver.check("dragged along it, to others: the box is not there yet", [&](const Json& s) {
        return std::abs(double(now(s)) / double(last(s)) - 0.2) < 0.03 && s.at("dynamic_count") == 1;
    });
    driver.let_go();
    const std::uint64_t end = last(driver.state());
    driver.check("what followed is still known", [&](const Json& s) { return last(s) == end; });
}

void test_directions(Driver& driver) {
    const std::uint64_t there = now(driver.state());
    driver.key("comma");
    driver.check("a comma goes one step back", [&](const Json& s) { return now(s) == there - 1; });
    driver.key("period");
    driver.check("a period follows one step", [&](const Json& s) { return now(s) == there; });
    for (int i = 0; i < 4; ++i) driver.key("bracketleft"); // slow enough to be observed
    driver.chord("shift", "space");
    driver.check("Shift+Space plays backwards",
                 [&](const Json& s) { return now(s) < there && s.at("timeline").at("backwards") == true; });
    for (int i = 0; i < 4; ++i) driver.key("bracketright");
    driver.check("to the beginning, and stops", [](const Json& s) {
        return now(s) == 0 && s.at("paused") == true && s.at("timeline").at("backwards") == false;
    });
    driver.key("space");
    driver.check("Space follows what was: the box comes again, with the same bits", [&](const Json& s) {
        return s.at("dynamic_count") == 2 && s.at("timeline").at("first_different").is_null();
    });
}

void test_undo(Driver& driver) {
    driver.check("it goes on beyond the end", [](const Json& s) { return now(s) == last(s) && now(s) > 100; });
    driver.key("i");
    driver.check("I adds a sphere", [](const Json& s) { return s.at("dynamic_count") == 3; });
    driver.chord("ctrl", "z");
    driver.check("Ctrl+Z takes it back", [](const Json& s) {
        return s.at("dynamic_count") == 2 && s.at("paused") == true && s.at("timeline").at("redoable") == "add a body";
    });
    driver.chord("ctrl", "z");
    driver.check("and the box",
                 [](const Json& s) { return s.at("dynamic_count") == 1 && s.at("timeline").at("undoable").is_null(); });
    driver.chord("ctrl+shift", "z");
    driver.chord("ctrl+shift", "z");
    driver.check("Ctrl+Shift+Z does both again",
                 [](const Json& s) { return s.at("dynamic_count") == 3 && s.at("timeline").at("redoable").is_null(); });
}

double height(const Json& position) { return position.at(1).get<double>(); }

// Two branches side by side: in one a ball falls, in the other it was never added.
void test_branches(Driver& driver) {
    driver.key("Home");
    driver.key("o");
    driver.check("O adds a ball, in the air", [](const Json& s) { return s.at("dynamic_count") == 4; });
    const std::uint64_t parting = now(driver.state());
    driver.chord("ctrl", "b");
    driver.check("Ctrl+B branches off", [&](const Json& s) {
        return s.contains("other") && s.at("other").at("parted_at") == parting && s.at("other").at("elsewhere") == 0;
    });
    driver.chord("ctrl", "z");
    driver.check("the ball is taken back in this run alone", [&](const Json& s) {
        return s.at("dynamic_count") == 3 && s.at("other").at("bodies") == 5 && s.at("other").at("elsewhere") == 1;
    });
    const double start = height(driver.state().at("other").at("positions").at(4));
    driver.key("space");
    driver.check("both go on: there it falls", [&](const Json& s) {
        return now(s) > parting + 20 && s.at("dynamic_count") == 3 &&
               height(s.at("other").at("positions").at(4)) < start - 0.3;
    });
    driver.key("space");
    driver.check("Space holds both", [](const Json& s) { return s.at("paused") == true; });
    driver.click_on("other.exchange");
    driver.check("exchanged, it is in this run",
                 [](const Json& s) { return s.at("dynamic_count") == 4 && s.at("other").at("bodies") == 4; });
    driver.chord("shift", "b");
    driver.check("Shift+B ends the other", [](const Json& s) { return !s.contains("other"); });
}

void test_saving(Driver& driver) {
    driver.key("F9");
    driver.check("F9 saves a recording", [&](const Json& s) {
        const std::string notice = s.at("notice").get<std::string>();
        return notice.starts_with("Saved ") && notice.ends_with(".mcap") &&
               std::filesystem::file_size(driver.folder() + "/" + notice.substr(6)) > 1000;
    });
}

} // namespace

int main(int argc, char** argv) {
    return drive(argc, argv, [](Driver& driver) {
        test_scrubbing(driver);
        if (driver.failures() > 0) return;
        test_directions(driver);
        test_undo(driver);
        test_branches(driver);
        test_saving(driver);
    });
}
