// Plots, integrators and what the solver sees, in the window. Started by window_test.sh.
#include "window_driver.h"

#include <filesystem>
#include <sstream>

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

// What a student is to find out: which integrator gains energy, with a picture for the report.
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
        // time, exact, explicit Euler, semi-implicit Euler, Runge-Kutta 4
        const std::vector<double> row = last_row(file_text(driver, "integrators_spring_energy.csv"));
        return row.size() == 5 && row[2] > 1000.0 && std::abs(row[3]) < 10.0 && std::abs(row[4]) < 0.01;
    });
    driver.click_on("integrators.pendulum");
    driver.click_on("integrators.csv");
    driver.check("another system is a click away", [&](const Json&) {
        return std::filesystem::exists(driver.folder() + "/integrators_pendulum_error.csv");
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
        return table.starts_with("\"time, s\",kinetic energy,potential energy,total energy\n") && row.size() == 4 &&
               std::abs(row[1] + row[2] - row[3]) < 1e-6 * row[3] && row[3] > 2000.0; // the crate's m g h, and more
    });
    driver.key("space");
    driver.key("F3");
    driver.check("F3 closes them", [](const Json& s) { return s.at("plots").at("open") == false; });
}

void test_solver(Driver& driver) {
    driver.key("F5");
    driver.check("F5 shows contacts",
                 [](const Json& s) { return s.at("solver_shown") == Json::array({"contacts and forces"}); });
    driver.click_on("panel.solver");
    driver.click_on("solver.friction cones");
    driver.click_on("solver.axes of inertia");
    driver.check("the panel shows more", [](const Json& s) {
        return s.at("solver_shown") == Json::array({"contacts and forces", "friction cones", "axes of inertia"});
    });
}

} // namespace

int main(int argc, char** argv) {
    return drive(argc, argv, [](Driver& driver) {
        driver.check("opens the scene", [](const Json& s) { return s.at("scene").at("title") == "One box"; });
        test_integrators(driver);
        if (driver.failures() > 0) return;
        test_plots(driver);
        test_solver(driver);
    });
}
