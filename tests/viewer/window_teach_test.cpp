// Plots, integrators and the solver view in the window. Started by window_test.sh.
#include "window_driver.h"

#include <filesystem>
#include <sstream>
#include <utility>

namespace {

using namespace cairn::viewer::test;

std::string file_text(const Driver& driver, const std::string& name) {
    std::ifstream file(driver.folder() + "/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<double> last_row(const std::string& table) {
    std::istringstream lines(table);
    std::string line, last;
    while (std::getline(lines, line)) last = line;
    std::istringstream cells(last);
    std::vector<double> numbers;
    while (std::getline(cells, line, ',')) numbers.push_back(std::stod(line));
    return numbers;
}

// The task of a student: to find out which integrator gains energy, with a picture for the report.
void test_integrators(Driver& driver) {
    const auto start = std::chrono::steady_clock::now();
    driver.click_on("panel.integrators");
    driver.check("a button opens the integrators", [](const Json& s) { return s.at("integrators") == true; });
    driver.click_on("integrators.svg");
    driver.check("their plots are saved", [&](const Json& s) {
        return s.at("notice").get<std::string>().starts_with("Saved ") &&
               std::filesystem::exists(driver.folder() + "/integrators_spring_energy.svg");
    });
    driver.click_on("integrators.csv");
    driver.check("and their tables", [&](const Json&) {
        return std::filesystem::exists(driver.folder() + "/integrators_spring_error.csv");
    });
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    driver.check("within two minutes", [&](const Json&) { return seconds < 120.0; });
    driver.check("the picture has all curves", [&](const Json&) {
        const std::string picture = file_text(driver, "integrators_spring_energy.svg");
        return picture.starts_with("<svg") && picture.find("explicit Euler") != picture.npos &&
               picture.find("Runge-Kutta 4") != picture.npos;
    });
    driver.check("explicit Euler gains energy, Runge-Kutta 4 does not", [&](const Json&) {
        // Columns: time, exact, explicit Euler, semi-implicit Euler, Runge-Kutta 4.
        const std::vector<double> row = last_row(file_text(driver, "integrators_spring_energy.csv"));
        return row.size() == 5 && row[2] > 1000.0 && std::abs(row[3]) < 10.0 && std::abs(row[4]) < 0.01;
    });
    driver.click_on("integrators.pendulum");
    driver.click_on("integrators.csv");
    driver.check("another system is a click away", [&](const Json&) {
        return std::filesystem::exists(driver.folder() + "/integrators_pendulum_error.csv");
    });
    driver.click_on("integrators.top");
    driver.click_on("integrators.csv");
    driver.check("the top's force depends on its velocity: semi-implicit Euler gains energy, too", [&](const Json&) {
        const std::string table = file_text(driver, "integrators_top_energy.csv");
        const std::vector<double> row = table.empty() ? std::vector<double>() : last_row(table);
        return row.size() == 5 && row[3] > 100.0 && std::abs(row[4]) < 100.0;
    });
    driver.key("F4");
    driver.check("F4 closes them", [](const Json& s) { return s.at("integrators") == false; });
}

void test_plots(Driver& driver) {
    driver.key("F3");
    driver.check("F3 opens the plots, which fill", [](const Json& s) {
        return s.at("plots").at("open") == true && s.at("plots").at("shown").get<int>() > 30;
    });
    driver.key("u");
    driver.key("space");
    driver.click_on("plots.csv");
    driver.check("the energies are saved as a table", [&](const Json&) {
        const std::string table = file_text(driver, "energy.csv");
        const std::vector<double> row = table.empty() ? std::vector<double>() : last_row(table);
        return table.starts_with("\"time, s\",kinetic energy,potential energy,lost to friction,lost in impacts,brought "
                                 "in,all but what was brought in\n") &&
               row.size() == 7 && row[1] + row[2] > 2000.0 && // the crate's m g h, and more
               std::abs(row[1] + row[2] + row[3] + row[4] - row[5] - row[6]) < 1e-6 * row[6];
    });
    driver.key("space");
    driver.key("F3");
    driver.check("F3 closes them", [](const Json& s) { return s.at("plots").at("open") == false; });
}

// The window is moved by its title bar, above the choice of what is plotted.
void test_moved_window(Driver& driver) {
    driver.key("F3");
    driver.check("there are plots", [](const Json& s) { return s.at("plots").at("open") == true; });
    pause_for(0.5);
    const auto place = [](const Json& s) { return s.at("places").at("plots.group"); };
    const Json before = place(driver.state());
    const double x = before.at(0).get<double>(), y = before.at(1).get<double>() - 22.0;
    driver.cursor(x, y);
    driver.press();
    driver.cursor(x + 60.0, y - 40.0);
    driver.let_go();
    driver.check("a window is dragged by its title", [&](const Json& s) {
        return std::abs(place(s).at(0).get<double>() - before.at(0).get<double>() - 60.0) < 3.0 &&
               std::abs(place(s).at(1).get<double>() - before.at(1).get<double>() + 40.0) < 3.0;
    });
    const Json after = place(driver.state());
    std::ofstream(driver.folder() + "/moved") << after.at(0) << " " << after.at(1) << "\n";
    driver.key("F3");
}

// Uses the list of commands, as in a small window the panel would have to be scrolled.
void toggle_difference(Driver& driver) {
    driver.cursor(700, 420);
    driver.chord("ctrl", "p");
    driver.check("the list of commands opens", [](const Json& s) { return s.at("palette") == true; });
    driver.type("minkowski");
    driver.key("Return");
    driver.check("and closes", [](const Json& s) { return s.at("palette") == false; });
}

void test_solver(Driver& driver) {
    driver.key("F5");
    driver.check("F5 shows contacts",
                 [](const Json& s) { return s.at("solver_shown") == Json::array({"contacts and forces"}); });
    driver.click_on("panel.solver");
    driver.click_on("page.contacts and forces");
    driver.check("a link opens the page of the documentation", [&](const Json&) {
        return file_text(driver, "opened").ends_with("docs/guide/queries_and_events.md\n");
    });
    driver.click_on("solver.friction cones");
    driver.click_on("solver.axes of inertia");
    toggle_difference(driver);
    driver.key("u");
    pause_for(1.5);
    const Json crate = driver.state().at("bodies").at(1).at("screen");
    driver.click(crate.at(0).get<double>(), crate.at(1).get<double>());
    driver.check("of the crate and the box on it: they touch", [](const Json& s) {
        return s.contains("difference") && s.at("difference").at("other").get<int>() >= 2 &&
               s.at("difference").at("distance").get<double>() < 0.02;
    });
    toggle_difference(driver);
    driver.check("the panel shows more", [](const Json& s) {
        return s.at("solver_shown") == Json::array({"contacts and forces", "friction cones", "axes of inertia"});
    });
}

// The cursor position of a point in a pane, which is given in fractions of the pane.
std::pair<double, double> in_pane(const Json& state, std::size_t pane, double x, double y) {
    const Json& place = state.at("panes").at(pane).at("place");
    return {place.at(0).get<double>() + x * place.at(2).get<double>(),
            place.at(1).get<double>() + y * place.at(3).get<double>()};
}

// The same throw with three frictions.
void test_panes(Driver& driver) {
    driver.key("F6");
    driver.check("F6 shows four panes, with other steps", [](const Json& s) {
        return s.at("panes").size() == 3 &&
               s.at("panes").at(0).at("settings").get<std::string>().starts_with("step 1/120");
    });
    driver.click_on("panes.friction");
    driver.check("a click, and their frictions differ", [](const Json& s) {
        return s.at("panes").size() == 3 &&
               s.at("panes").at(0).at("settings").get<std::string>().ends_with("friction 0");
    });
    driver.check("nothing has moved yet", [](const Json& s) { return s.at("panes").at(0).at("farthest") < 0.01; });
    driver.xdotool("keydown shift");
    driver.xdotool("keydown Right");
    pause_for(1.0);
    driver.xdotool("keyup Right");
    driver.xdotool("keyup shift");
    driver.check("pushed, the crate slides farther where there is less friction", [](const Json& s) {
        const auto farthest = [&](std::size_t i) { return s.at("panes").at(i).at("farthest").get<double>(); };
        return farthest(0) > 1.0 && farthest(0) > farthest(1) + 0.3;
    });
    driver.key("Delete");
    driver.check("a reset begins the panes anew", [](const Json& s) {
        return s.at("panes").size() == 3 && s.at("panes").at(0).at("farthest") < 0.01 && s.at("body_count") == 2;
    });
    const Json pane = driver.state().at("bodies").at(1).at("screen"); // in the first pane
    driver.click(pane.at(0).get<double>(), pane.at(1).get<double>());
    driver.check("the inspector is in the column of the panel, and covers no picture", [](const Json& s) {
        return s.contains("inspected") && s.at("places").contains("inspector.name") &&
               s.at("places").at("inspector.name").at(0).get<double>() < s.at("left").get<double>() &&
               s.at("places").at("inspector.name").at(1).get<double>() > 200.0;
    });
    driver.key("Escape");
    driver.check("Escape closes it", [](const Json& s) { return !s.contains("inspected"); });
    const Json before = driver.state();
    const Json& crate = before.at("bodies").at(1).at("screen");
    const auto [x, y] =
        in_pane(before, 0,
                (crate.at(0).get<double>() - before.at("left").get<double>()) / before.at("size").at(0).get<double>(),
                crate.at(1).get<double>() / before.at("size").at(1).get<double>());
    driver.cursor(x, y);
    driver.press();
    driver.cursor(x + 80.0, y + 20.0);
    driver.let_go();
    driver.check(
        "a drag in another pane turns the camera of all, also where the crate is in the first", [&](const Json& s) {
            return s.at("selected").is_null() && s.at("camera").at("position") != before.at("camera").at("position");
        });
    driver.click_on("panes.remove");
    driver.check("panes can be removed", [](const Json& s) { return s.at("panes").size() == 2; });
    driver.key("F6");
    driver.check("F6 closes them", [](const Json& s) { return s.at("panes").empty(); });
}

// A box falls on the crate: the impulse is explained.
void test_impact(Driver& driver) {
    driver.key("u");
    driver.check("a box falls on the crate",
                 [](const Json& s) { return s.at("timeline").at("marks").at("impact").get<int>() >= 1; });
    const Json crate = driver.state().at("bodies").at(1).at("screen");
    driver.click(crate.at(0).get<double>(), crate.at(1).get<double>());
    driver.check("a click selects the crate", [](const Json& s) { return s.at("selected") == 1; });
    driver.cursor(500, 100);
    driver.key("F7");
    driver.check("F7 tells its last impact: the formula's impulse is near what it was given", [](const Json& s) {
        if (!s.contains("impact")) return false;
        const double formula = s.at("impact").at("impulse").get<double>();
        return formula > 100.0 && s.at("impact").at("step").get<std::uint64_t>() <= s.at("timeline").at("now");
    });
    driver.click_on("impact.watch");
    driver.check("shown again, slowly", [](const Json& s) {
        return s.at("speed") == 1.0 / 32.0 && s.at("timeline").at("now") <= s.at("impact").at("step");
    });
    driver.check("until it is over", [](const Json& s) {
        return s.at("paused") == true && s.at("speed") == 1.0 &&
               s.at("timeline").at("now") == s.at("impact").at("step").get<std::uint64_t>() + 6;
    });
    driver.key("F7");
    driver.key("space");
    driver.check("F7 closes it", [](const Json& s) { return !s.contains("impact"); });
}

} // namespace

int main(int argc, char** argv) {
    return drive(argc, argv, [](Driver& driver) {
        driver.check("opens the scene", [](const Json& s) { return s.at("scene").at("title") == "One box"; });
        test_integrators(driver);
        if (driver.failures() > 0) return;
        test_plots(driver);
        test_moved_window(driver);
        test_solver(driver);
        test_panes(driver);
        test_impact(driver);
    });
}
