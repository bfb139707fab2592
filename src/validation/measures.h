// What several cases need to take a measurement: steps, worst values, and where a behavior changes.
#pragma once

#include <cmath>
#include <limits>

namespace cairn::validation {

inline int steps_in(double seconds, double time_step) { return int(std::lround(seconds / time_step)); }

// Of several measurements of one quantity, the one that is farthest from what is expected. A value that is not a
// number stays.
struct Farthest {
    double expected = 0;
    double value = expected;

    void add(double measured) {
        if (!(std::fabs(measured - expected) <= std::fabs(value - expected))) value = measured;
    }
};

// Where `holds` changes from true at `low` to false at `high`, to within `width`. Not a number if it does not.
template <class Holds> double last_where(double low, double high, double width, Holds holds) {
    if (!holds(low) || holds(high)) return std::numeric_limits<double>::quiet_NaN();
    while (high - low > width) {
        const double middle = 0.5 * (low + high);
        (holds(middle) ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace cairn::validation
