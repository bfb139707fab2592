// Charts of many rows, as SVG elements.
#pragma once

#include <span>
#include <string>

namespace cairn::cli {

// A column of numbers and its name.
struct Series {
    std::string name;
    std::span<const double> values; // values that are not finite are ignored
};

// A histogram with bins of equal width. Empty if there are no values.
std::string histogram(const Series& series);

// The mean of `values` against `x`, with the range from the 5 % to the 95 % quantile of each group of rows.
std::string effect_plot(const Series& x, const Series& values);

// The mean of `values` in the cells of a grid of `x` and `y`, as color. Cells without rows are white.
std::string heat_map(const Series& x, const Series& y, const Series& values);

} // namespace cairn::cli
