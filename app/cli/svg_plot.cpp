#include "cli/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace cairn::cli {

namespace {

using validation::Curve;
using validation::Plot;

constexpr double width = 480, plot_height = 300;               // without the legend
constexpr double left = 78, right = 18, top = 36, bottom = 50; // margins of the axes
constexpr double legend_line = 18, character = 6.1;            // of text at 11 pixels
// Ratio of the slopes of adjacent segments, toward shorter steps, below which rounding errors dominate.
constexpr double min_slope_change = 0.7;
constexpr double min_slope_fit = 0.98; // squared correlation above which a slope is meaningful
constexpr const char* ink = "#33383f";
constexpr const char* expected_color = "#a9b0ba";
constexpr std::array<const char*, 6> colors = {"#1f6fb2", "#d1495b", "#2f8f6b", "#8657a8", "#d98a1f", "#4a4f57"};

// Whether a curve is a reference, recognized by its label.
bool is_expected(const Curve& curve) {
    return curve.label.find("expected") != std::string::npos || curve.label.find("closed form") != std::string::npos;
}

// One axis: maps values to pixels.
struct Axis {
    bool log = false;
    double low = 0, high = 1;       // of the value, or of its logarithm
    double at_low = 0, at_high = 1; // pixels

    double scaled(double value) const { return log ? std::log10(value) : value; }
    double pixel(double value) const { return at_low + (scaled(value) - low) / (high - low) * (at_high - at_low); }
};

struct Tick {
    double value = 0;
    std::string label; // SVG text; empty: a grid line without label
};

bool can_show(const Plot& plot, double x, double y) {
    return std::isfinite(x) && std::isfinite(y) && (!plot.log_x || x > 0) && (!plot.log_y || y > 0);
}

Axis fit_axis(const Plot& plot, bool along_x) {
    Axis axis;
    axis.log = along_x ? plot.log_x : plot.log_y;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Curve& curve : plot.curves)
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            if (!can_show(plot, curve.x[i], curve.y[i])) continue;
            const double value = axis.scaled(along_x ? curve.x[i] : curve.y[i]);
            low = std::min(low, value), high = std::max(high, value);
        }
    if (low > high) low = 0, high = 1;
    if (high - low < 1e-9 * std::max(1.0, std::fabs(high))) { // a constant curve
        const double around = axis.log ? 0.5 : std::max(1e-9, 0.1 * std::fabs(high));
        low -= around, high += around;
    }
    if (along_x && !axis.log && low > 0 && low < 0.1 * high) low = 0; // extends a time axis to 0
    const double room = along_x ? (axis.log ? 0.04 : 0.0) : 0.06;
    axis.low = low - room * (high - low);
    axis.high = high + room * (high - low);
    // An axis that starts at 0 is not extended below.
    if (!axis.log && low >= 0 && axis.low < 0) axis.low = 0;
    return axis;
}

std::string plain(double value) {
    if (std::fabs(value) < 1e-12) return "0";
    std::string text = fmt::format("{:.6g}", value);
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return text;
    const std::string mantissa = text.substr(0, e);
    const std::string power =
        fmt::format("10<tspan dy=\"-4\" font-size=\"8\">{}</tspan>", std::stoi(text.substr(e + 1)));
    return mantissa == "1" ? power : mantissa + "·" + power;
}

std::vector<Tick> linear_ticks(const Axis& axis, double wanted) {
    const double raw = (axis.high - axis.low) / wanted, decade = std::pow(10, std::floor(std::log10(raw)));
    double step = 10 * decade;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * decade >= raw) {
            step = factor * decade;
            break;
        }
    // As many decimals as distinguish two ticks; powers of ten where that gives unreadable numbers.
    const double size = std::max(std::fabs(axis.low), std::fabs(axis.high));
    const int decimals = std::max(0, int(std::ceil(-std::log10(step) - 1e-9)));
    const auto label = [&](double value) {
        return size >= 1e-3 && size < 1e6 && decimals <= 7 ? fmt::format("{:.{}f}", value, decimals) : plain(value);
    };
    std::vector<Tick> ticks;
    for (double k = std::ceil(axis.low / step - 1e-9); k * step <= axis.high + 1e-9 * step; ++k)
        ticks.push_back({k * step, label(k == 0 ? 0.0 : k * step)});
    return ticks;
}

std::string power_of_ten(int exponent) {
    if (exponent >= -3 && exponent <= 3) return fmt::format("{:.6g}", std::pow(10, exponent));
    return fmt::format("10<tspan dy=\"-4\" font-size=\"8\">{}</tspan>", exponent);
}

std::vector<Tick> log_ticks(const Axis& axis) {
    std::vector<Tick> ticks;
    const double decades = axis.high - axis.low;
    const int every = std::max(1, int(std::ceil(decades / 7)));
    for (int k = int(std::floor(axis.low)); k <= int(std::ceil(axis.high)); ++k)
        for (const int factor : {1, 2, 5}) {
            const double value = factor * std::pow(10, k), at = std::log10(value);
            if (at < axis.low || at > axis.high || (factor > 1 && decades > 2.5)) continue;
            const bool named = factor > 1 || k % every == 0;
            // Between whole powers: 0.002, or 2 x 10^-5.
            const std::string label = factor == 1 ? power_of_ten(k) : plain(value);
            ticks.push_back({value, named ? label : std::string()});
        }
    return ticks;
}

// Slope of a least-squares line through the logarithms, from the right end as far as the error decreases; rounding
// errors dominate beyond that. Empty if the points do not fit a line.
std::optional<double> fitted_slope(const Plot& plot, const Curve& curve) {
    if (!plot.log_x || !plot.log_y) return std::nullopt;
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (can_show(plot, curve.x[i], curve.y[i])) points.emplace_back(std::log10(curve.x[i]), std::log10(curve.y[i]));
    std::sort(points.rbegin(), points.rend());
    const auto slope_after = [&](std::size_t i) {
        return (points[i].second - points[i + 1].second) / (points[i].first - points[i + 1].first);
    };
    if (points.size() < 3 || slope_after(0) <= 0) return std::nullopt;
    std::size_t count = 2;
    while (count < points.size() && slope_after(count - 1) > min_slope_change * slope_after(count - 2)) ++count;
    points.resize(count);
    double sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
    for (const auto& [x, y] : points) sx += x, sy += y, sxx += x * x, sxy += x * y, syy += y * y;
    const double n = double(count), xx = n * sxx - sx * sx, xy = n * sxy - sx * sy, yy = n * syy - sy * sy;
    if (count < 3 || xx <= 0 || yy <= 0 || xy * xy < min_slope_fit * xx * yy) return std::nullopt;
    return xy / xx;
}

// Sizes of a curve's marks and of the lines between them. Curves drawn first are larger, so that coinciding curves are
// all visible. `later`: number of curves with marks drawn on top.
double mark_radius(std::size_t later) { return 3 + 1.3 * double(later); }
double join_width(std::size_t later) { return 1.2 + 1.1 * double(later); }

struct LegendEntry {
    std::string text;
    const char *color, *dashes; // dashes: an attribute, or empty
    bool as_points, is_expected;
    std::size_t later; // curves with marks drawn on top
    double x = 0, y = 0;
};

// Places the entries one after the other, in as many lines as needed; returns the height.
double lay_out(std::vector<LegendEntry>& entries) {
    double x = left, y = plot_height + 4;
    for (LegendEntry& entry : entries) {
        const double needs = 26 + character * double(entry.text.size());
        if (x > left && x + needs > width - 4) x = left, y += legend_line;
        entry.x = x, entry.y = y;
        x += needs + 14;
    }
    return entries.empty() ? 0 : y + legend_line - plot_height;
}

void draw_axes(std::string& out, const Plot& plot, const Axis& x, const Axis& y) {
    for (const Tick& tick : x.log ? log_ticks(x) : linear_ticks(x, 6)) {
        const double at = x.pixel(tick.value);
        out += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"#e6e9ed\"/>", at, y.at_low, y.at_high);
        out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", at, y.at_low + 16,
                           tick.label);
    }
    for (const Tick& tick : y.log ? log_ticks(y) : linear_ticks(y, 6)) {
        const double at = y.pixel(tick.value);
        const bool is_zero = !y.log && std::fabs(tick.value) < 1e-12;
        out += fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"{}\"/>", x.at_low, at, x.at_high,
                           is_zero ? "#c3c8cf" : "#e6e9ed");
        out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", x.at_low - 7, at + 4,
                           tick.label);
    }
    out += fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}H{:.1f}\" stroke=\"#8a919b\" fill=\"none\"/>", x.at_low,
                       y.at_high, y.at_low, x.at_high);
    const double middle = (y.at_low + y.at_high) / 2;
    out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", (x.at_low + x.at_high) / 2,
                       y.at_low + 36, escaped(plot.x_label));
    out += fmt::format("<text x=\"14\" y=\"{0:.1f}\" text-anchor=\"middle\" transform=\"rotate(-90 14 {0:.1f})\">{1}"
                       "</text>",
                       middle, escaped(plot.y_label));
    out += fmt::format("<text x=\"{:.1f}\" y=\"20\" font-size=\"13\" font-weight=\"600\">{}</text>", left,
                       escaped(plot.title));
}

void draw_line(std::string& out, const Plot& plot, const Curve& curve, const Axis& x, const Axis& y, const char* color,
               double stroke, const char* dashes) {
    std::string path;
    bool pen_down = false;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const bool visible = can_show(plot, curve.x[i], curve.y[i]);
        if (visible)
            path += fmt::format("{}{:.1f} {:.1f}", pen_down ? "L" : "M", x.pixel(curve.x[i]), y.pixel(curve.y[i]));
        pen_down = visible;
    }
    if (!path.empty())
        out +=
            fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\" fill=\"none\" stroke-linejoin=\"round\"{}/>",
                        path, color, stroke, dashes);
}

void draw_points(std::string& out, const Plot& plot, const Curve& curve, const Axis& x, const Axis& y,
                 const char* color, double radius) {
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (can_show(plot, curve.x[i], curve.y[i]))
            out += fmt::format(
                "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\" stroke=\"white\" stroke-width=\"0.8\"/>",
                x.pixel(curve.x[i]), y.pixel(curve.y[i]), radius, color);
}

void draw_legend(std::string& out, const std::vector<LegendEntry>& entries) {
    for (const LegendEntry& entry : entries) {
        const double y = entry.y + 8;
        if (entry.as_points)
            out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"/>", entry.x + 9, y,
                               mark_radius(entry.later), entry.color);
        else
            out += fmt::format("<path d=\"M{:.1f} {:.1f}h18\" stroke=\"{}\" stroke-width=\"{}\"{}/>", entry.x, y,
                               entry.color, entry.is_expected ? 4 : 2, entry.dashes);
        out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", entry.x + 24, y + 4, escaped(entry.text));
    }
}

} // namespace

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += c;
    }
    return result;
}

std::string svg_plot(const Plot& plot) {
    Axis x = fit_axis(plot, true), y = fit_axis(plot, false);
    x.at_low = left, x.at_high = width - right;
    y.at_low = plot_height - bottom, y.at_high = top;
    std::vector<LegendEntry> legend;
    std::size_t next_color = 0;
    for (const Curve& curve : plot.curves) {
        const std::optional<double> slope = fitted_slope(plot, curve);
        const char* dashes = next_color >= colors.size() && !is_expected(curve) ? " stroke-dasharray=\"5 3\"" : "";
        const char* color = is_expected(curve) ? expected_color : colors[next_color++ % colors.size()];
        legend.push_back({curve.label + (slope ? fmt::format(" (slope {:.2f})", *slope) : ""), color, dashes,
                          curve.as_points, is_expected(curve), 0});
    }
    for (std::size_t i = legend.size(), later = 0; i-- > 0;) {
        legend[i].later = later;
        if (legend[i].as_points) ++later;
    }
    const double height = plot_height + lay_out(legend);
    std::string out = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
                                  "width=\"{0:.0f}\" height=\"{1:.0f}\" role=\"img\" font-family=\"system-ui, "
                                  "Helvetica, Arial, sans-serif\" font-size=\"11\" fill=\"{2}\"><title>{3}</title>"
                                  "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>",
                                  width, height, ink, escaped(plot.title));
    draw_axes(out, plot, x, y);
    // The wide lines of reference curves are drawn first, points last.
    for (std::size_t i = 0; i < plot.curves.size(); ++i)
        if (legend[i].is_expected) draw_line(out, plot, plot.curves[i], x, y, legend[i].color, 4, "");
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const Curve& curve = plot.curves[i];
        const bool joins_points = curve.as_points && plot.log_x && plot.log_y;
        if (!legend[i].is_expected && (!curve.as_points || joins_points))
            draw_line(out, plot, curve, x, y, legend[i].color, joins_points ? join_width(legend[i].later) : 1.6,
                      legend[i].dashes);
    }
    for (std::size_t i = 0; i < plot.curves.size(); ++i)
        if (plot.curves[i].as_points)
            draw_points(out, plot, plot.curves[i], x, y, legend[i].color, mark_radius(legend[i].later));
    draw_legend(out, legend);
    return out + "</svg>";
}

} // namespace cairn::cli
