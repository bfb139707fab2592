/// \file chart.h
/// Curves over two axes, as data: drawn in the window (chart_view.h), and saved as tables and pictures.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cairn::viewer {

struct Curve {
    std::string label;
    std::vector<double> x, y;       ///< Equally many values each; values that are not finite make a gap.
    std::uint32_t color = 0x33383f; ///< 0xRRGGBB.
    bool as_points = false;
    bool is_reference = false; ///< A curve for comparison: drawn wider and paler.
};

struct Chart {
    std::string title, x_label, y_label;
    bool log_x = false, log_y = false;
    std::vector<Curve> curves;
    std::optional<double> top; ///< Upper limit of the y axis; higher values are cut off.
};

/// One axis: maps values to 0..1.
struct ChartAxis {
    bool is_log = false;
    double low = 0.0, high = 1.0; ///< Range of the value, or of its decimal logarithm.
    double share(double value) const;
    double value(double share) const;
};
/// Axes that include all values that can be drawn.
ChartAxis x_axis(const Chart& chart);
ChartAxis y_axis(const Chart& chart);

struct ChartTick {
    double value = 0.0;
    std::string label; ///< May be empty.
};
/// About `wanted` ticks at round values; on a logarithmic axis at powers of ten.
std::vector<ChartTick> ticks_of(const ChartAxis& axis, int wanted);

/// The slope of a curve in a doubly logarithmic chart, by least squares over its points; empty for fewer than two
/// points.
std::optional<double> log_slope(const Curve& curve);

/// A CSV table: one column for x and one for each curve if all curves have the same x, else two columns for each.
std::string chart_csv(const Chart& chart);

/// Curve colors that are distinguishable with the common kinds of color blindness (Okabe and Ito 2008), and readable on
/// dark and light backgrounds.
inline constexpr std::uint32_t chart_colors[] = {0xe69f00, 0x56b4e9, 0x20b080, 0xcc79a7, 0xd55e00, 0x4080d0};

} // namespace cairn::viewer
