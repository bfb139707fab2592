// Physics measured against what the equations say. Each case runs small worlds and compares what it sees with a closed
// form, or with published numbers of other engines. `cairn validate` prints the rows; tests/physics asserts them.
// Uses only the engine's public headers.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::validation {

// How a measurement is judged.
enum class Bar {
    relative, // |measured - expected| <= bar * |expected|
    absolute, // |measured - expected| <= bar, in the unit of the quantity
    at_most,  // measured <= bar; expected is what it would ideally be
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
    std::string note{}; // why a row cannot hold, or what is special about it; empty: nothing to say
    // What a row that is known to miss its bar is held to by the tests, so that it does not get worse; 0: its bar.
    double known_bar = 0;

    // False where the measurement is not a finite number.
    bool passes() const { return keeps(bar); }
    bool is_no_worse_than_known() const { return passes() || (known_bar > 0 && keeps(known_bar)); }

  private:
    bool keeps(double bound) const;
};

// One line, or cloud of points, of a plot.
struct Curve {
    std::string label;
    std::vector<double> x{}, y{}; // as many of one as of the other
    bool as_points = false;
};

struct Plot {
    std::string title, x_label, y_label;
    bool log_x = false, log_y = false;
    std::vector<Curve> curves;
};

// What others have published about the same scene, to be printed beside ours. Not judged.
struct Published {
    std::string quantity, engine, value, source;
};

struct Result {
    std::vector<Row> rows;
    std::vector<Plot> plots;
    std::vector<Published> published;
};

// The lengths of a step at which a case is measured where that makes sense, s.
inline constexpr double time_steps[] = {1.0 / 60, 1.0 / 240, 1.0 / 1000};

struct Case {
    int number; // of the table in docs/validation.md; the cases from the literature follow as 25 to 28, impacts as 29
                // and 30
    std::string_view name;  // in snake_case, as `cairn validate --case` takes it
    std::string_view title; // in words
    std::string_view law;   // the formula and its source
    Result (*measure)();    // deterministic; takes seconds at most
};

// All of them, by their numbers.
std::span<const Case> cases();

// The case of that name or number ("7"); null if there is none.
const Case* find_case(std::string_view name_or_number);

} // namespace cairn::validation
