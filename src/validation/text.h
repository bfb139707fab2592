// Formats numbers for the names of rows, curves and plots.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace cairn::validation {

// At most six significant digits: "0.5", "1e-06".
inline std::string text(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g", value);
    return buffer;
}

// A time step in seconds: "1/60", or a decimal where its reciprocal is not an integer.
inline std::string step_text(double seconds) {
    const double per_second = std::round(1 / seconds);
    if (per_second > 1 && std::fabs(seconds * per_second - 1) < 1e-6) return "1/" + text(per_second);
    return text(seconds);
}

} // namespace cairn::validation
