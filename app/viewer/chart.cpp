#include "viewer/chart.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace cairn::viewer {

namespace {

std::string number(double value, int digits) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

ChartAxis fit(const Chart& chart, bool along_x) {
    ChartAxis axis;
    axis.is_log = along_x ? chart.log_x : chart.log_y;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Curve& curve : chart.curves) {
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            const double value = along_x ? curve.x[i] : curve.y[i];
            if (!std::isfinite(curve.x[i]) || !std::isfinite(curve.y[i]) || (axis.is_log && !(value > 0.0))) continue;
            const double scaled = axis.is_log ? std::log10(value) : value;
            low = std::min(low, scaled);
            high = std::max(high, scaled);
        }
    }
    if (!along_x && chart.top) high = std::min(high, *chart.top);
    if (!(low <= high)) low = 0.0, high = 1.0;
    if (high - low < 1e-9 * std::max(1.0, std::abs(high))) { // a constant curve
        const double around = axis.is_log ? 0.5 : std::max(0.5, 0.1 * std::abs(high));
        low -= around, high += around;
    }
    if (!axis.is_log && low > 0.0 && low < 0.3 * high) low = 0.0;
    const double room = along_x && !axis.is_log ? 0.0 : 0.06 * (high - low);
    axis.low = low == 0.0 ? 0.0 : low - room;
    axis.high = high + room;
    return axis;
}

// Omits the plus sign and leading zeros of exponents: 1e6, 1e-9.
std::string tick_label(double value, int digits) {
    std::string text = number(value, digits);
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return text;
    if (text[e + 1] == '+') text.erase(e + 1, 1);
    for (const std::size_t first = e + (text[e + 1] == '-' ? 2 : 1); text[first] == '0';) text.erase(first, 1);
    return text;
}

} // namespace

double ChartAxis::share(double value) const { return ((is_log ? std::log10(value) : value) - low) / (high - low); }

double ChartAxis::value(double share) const {
    const double scaled = low + share * (high - low);
    return is_log ? std::pow(10.0, scaled) : scaled;
}

ChartAxis x_axis(const Chart& chart) { return fit(chart, true); }
ChartAxis y_axis(const Chart& chart) { return fit(chart, false); }

std::vector<ChartTick> ticks_of(const ChartAxis& axis, int wanted) {
    std::vector<ChartTick> ticks;
    if (axis.is_log) {
        const int every = std::max(1, int(std::ceil((axis.high - axis.low) / (wanted + 1))));
        for (int power = int(std::ceil(axis.low)); power <= int(std::floor(axis.high)); ++power) {
            const double value = std::pow(10.0, power);
            ticks.push_back({value, power % every == 0 ? tick_label(value, 3) : std::string()});
        }
        if (ticks.size() >= 2) return ticks;
        ticks.clear(); // less than a decade: round values as on a linear axis
        for (const double share : {0.1, 0.5, 0.9}) {
            const double value = axis.value(share);
            const double unit = std::pow(10.0, std::floor(std::log10(value)));
            const double round = std::max(std::round(value / unit), 1.0) * unit;
            if (axis.share(round) >= 0.0 && axis.share(round) <= 1.0) ticks.push_back({round, tick_label(round, 2)});
        }
        return ticks;
    }
    const double raw = (axis.high - axis.low) / wanted, decade = std::pow(10.0, std::floor(std::log10(raw)));
    double step = 10.0 * decade;
    for (const double factor : {5.0, 2.0, 1.0})
        if (factor * decade >= raw * (1.0 - 1e-9)) step = factor * decade;
    for (double k = std::ceil(axis.low / step - 1e-9); k * step <= axis.high + 1e-9 * step; ++k)
        ticks.push_back({k * step, tick_label(k == 0.0 ? 0.0 : k * step, 6)});
    return ticks;
}

std::optional<double> log_slope(const Curve& curve) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (!(curve.x[i] > 0.0) || !(curve.y[i] > 0.0) || !std::isfinite(curve.y[i])) continue;
        const double x = std::log10(curve.x[i]), y = std::log10(curve.y[i]);
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    const double spread = n * sxx - sx * sx;
    if (n < 2 || !(spread > 0.0)) return std::nullopt;
    return (n * sxy - sx * sy) / spread;
}

std::string chart_csv(const Chart& chart) {
    const auto quoted = [](const std::string& text) { return text.find(',') == text.npos ? text : '"' + text + '"'; };
    const bool shares_x = std::all_of(chart.curves.begin(), chart.curves.end(),
                                      [&](const Curve& curve) { return curve.x == chart.curves.front().x; });
    std::string text;
    std::size_t rows = 0;
    for (const Curve& curve : chart.curves) {
        if (text.empty() || !shares_x) text += (text.empty() ? "" : ",") + quoted(chart.x_label);
        text += "," + quoted(curve.label);
        rows = std::max(rows, curve.x.size());
    }
    text += "\n";
    for (std::size_t row = 0; row < rows; ++row) {
        std::string line;
        for (const Curve& curve : chart.curves) {
            const bool has = row < curve.x.size();
            const bool first = &curve == &chart.curves.front();
            if (first || !shares_x) line += (first ? "" : ",") + (has ? number(curve.x[row], 17) : std::string());
            line += "," + (has && std::isfinite(curve.y[row]) ? number(curve.y[row], 17) : std::string());
        }
        text += line + "\n";
    }
    return text;
}

} // namespace cairn::viewer
