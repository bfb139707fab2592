// Helpers for measurements: numbers of steps, worst values, and thresholds of behavior.
#pragma once

#include <cmath>
#include <limits>

namespace cairn::validation {

inline int steps_in(double seconds, double time_step) { return int(std::lround(seconds / time_step)); }

// Keeps the one of several measurements of a quantity that is farthest from the expected value. Once a value is not a
// number, it stays.
struct Farthest {
    double expected = 0;
    double value = expected;

    void add(double measured) {
        if (!(std::fabs(measured - expected) <= std::fabs(value - expected))) value = measured;
    }
};

// Returns by bisection where `holds` changes from true at `low` to false at `high`, to within `width`. Returns NaN if
// it does not change.
template <class Holds> double last_where(double low, double high, double width, Holds holds) {
    if (!holds(low) || holds(high)) return std::numeric_limits<double>::quiet_NaN();
    while (high - low > width) {
        const double middle = 0.5 * (low + high);
        (holds(middle) ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace cairn::validation
