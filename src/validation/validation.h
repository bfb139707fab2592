// Measures the engine's physics against theory. Each case simulates small worlds and compares the results with a closed
// form, or with published numbers of other engines. `cairn validate` prints the rows; tests/physics asserts them. Only
// the engine's public headers are used.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::validation {

// How a measurement is compared with its bar.
enum class Bar {
    relative, // |measured - expected| <= bar * |expected|
    absolute, // |measured - expected| <= bar, in the unit of the quantity
    at_most,  // measured <= bar; expected is the ideal value
    at_least, // measured >= bar
};

// One line of the report.
struct Row {
    std::string quantity;        // what was measured, with its unit: "range, m"
    double time_step = 1.0 / 60; // s
    double expected = 0;
    double measured = 0;
    double bar = 0;
    Bar kind = Bar::relative;
    std::string note{}; // why a row must fail, or what is special about it; may be empty
    // The bound that the tests apply to a row that is known to miss its bar, so that it does not get worse; 0: its bar.
    double known_bar = 0;

    // False if the measurement is not a finite number.
    bool passes() const { return keeps(bar); }
    bool is_no_worse_than_known() const { return passes() || (known_bar > 0 && keeps(known_bar)); }

  private:
    bool keeps(double bound) const;
};

// A line, or a set of points, of a plot.
struct Curve {
    std::string label;
    std::vector<double> x{}, y{}; // of equal length
    bool as_points = false;
};

struct Plot {
    std::string title, x_label, y_label;
    bool log_x = false, log_y = false;
    std::vector<Curve> curves;
};

// Published results of other engines for the same scene, which are printed for comparison but not judged.
struct Published {
    std::string quantity, engine, value, source;
};

struct Result {
    std::vector<Row> rows;
    std::vector<Plot> plots;
    std::vector<Published> published;
};

// The time steps at which a case is measured where applicable, s.
inline constexpr double time_steps[] = {1.0 / 60, 1.0 / 240, 1.0 / 1000};

struct Case {
    int number;             // in docs/validation.md; cases from the literature are 25 to 28, impacts 29 and 30
    std::string_view name;  // in snake_case, as `cairn validate --case` accepts it
    std::string_view title; // in words
    std::string_view law;   // the formula and its source
    Result (*measure)();    // deterministic; takes a few seconds at most
};

// All cases in the order of their numbers.
std::span<const Case> cases();

// Returns the case of that name or number ("7"); null if there is none.
const Case* find_case(std::string_view name_or_number);

} // namespace cairn::validation
