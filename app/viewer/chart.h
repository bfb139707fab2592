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
    std::vector<double> x, y;       ///< As many of one as of the other; what is not finite makes a gap.
    std::uint32_t color = 0x33383f; ///< 0xRRGGBB.
    bool as_points = false;
    bool is_reference = false; ///< What others are compared with: drawn wider and paler.
};

struct Chart {
    std::string title, x_label, y_label;
    bool log_x = false, log_y = false;
    std::vector<Curve> curves;
    std::optional<double> top; ///< What is above leaves the chart.
};

/// One axis: from values to 0 ... 1.
struct ChartAxis {
    bool is_log = false;
    double low = 0.0, high = 1.0; ///< Of the value, or of its decimal logarithm.
    double share(double value) const;
    double value(double share) const;
};
/// Such that all that can be shown is.
ChartAxis x_axis(const Chart& chart);
ChartAxis y_axis(const Chart& chart);

struct ChartTick {
    double value = 0.0;
    std::string label; ///< May be empty.
};
/// About `wanted` of them at round values; of a logarithmic axis at powers of ten.
std::vector<ChartTick> ticks_of(const ChartAxis& axis, int wanted);

/// The slope of a curve of a chart with two logarithmic axes, by least squares over its points; none where there are
/// fewer than two.
std::optional<double> log_slope(const Curve& curve);

/// A table: a column for x and one for each curve where all have the same x, else two columns for each.
std::string chart_csv(const Chart& chart);

/// Colors that the common kinds of color blindness tell apart (Okabe and Ito 2008), readable on dark and light.
inline constexpr std::uint32_t chart_colors[] = {0xe69f00, 0x56b4e9, 0x20b080, 0xcc79a7, 0xd55e00, 0x4080d0};

} // namespace cairn::viewer
