// Charts of many rows, as SVG elements for a page.
#pragma once

#include <span>
#include <string>

namespace cairn::cli {

// Numbers of a column and what it is called.
struct Series {
    std::string name;
    std::span<const double> values; // what is no finite number is left out
};

// How often values fall into which of some equal ranges. Empty if there are no values.
std::string histogram(const Series& series);

// The mean of `values` against `x`, with the range from the 5 % to the 95 % quantile of each group of rows.
std::string effect_plot(const Series& x, const Series& values);

// The mean of `values` in the cells of a grid of `x` and `y`, by color. Cells without rows are left white.
std::string heat_map(const Series& x, const Series& y, const Series& values);

} // namespace cairn::cli
