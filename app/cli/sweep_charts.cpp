#include "cli/sweep_charts.h"

#include "cli/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace cairn::cli {

namespace {

constexpr double chart_width = 420.0, chart_height = 260.0, chart_left = 62.0, chart_right = 14.0, chart_top = 12.0,
                 chart_bottom = 42.0;
constexpr double legend_width = 70.0;
constexpr std::size_t most_cells = 24, most_bars = 40;

// A linear map from a range of values to a range of pixels.
struct Scale {
    double low = 0.0, high = 1.0, from = 0.0, to = 1.0;
    double operator()(double v) const { return from + (to - from) * (v - low) / (high - low); }
};

Scale scale_of(double low, double high, double from, double to) {
    if (!(high > low)) { // a single value is centered
        const double half = low == 0.0 ? 0.5 : 0.05 * std::fabs(low);
        low -= half, high += half;
    }
    return {low, high, from, to};
}

std::pair<double, double> range_of(std::span<const double> values) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double v : values) {
        if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
    }
    return {low, high};
}

std::string text_at(double x, double y, const std::string& text, const char* anchor, const char* more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>", x, y, anchor, more,
                       escaped(text));
}

std::string axes(const Scale& x, const Scale& y, const std::string& x_name, const std::string& y_name) {
    std::string svg = fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}H{:.1f}\" fill=\"none\" stroke=\"#555\"/>", x.from,
                                  y.to, y.from, x.to);
    for (int i = 0; i <= 4; ++i) {
        const double share = 0.25 * i;
        svg += text_at(x.from + share * (x.to - x.from), y.from + 16.0,
                       fmt::format("{:.3g}", x.low + share * (x.high - x.low)), "middle");
        svg += text_at(x.from - 6.0, y.from + share * (y.to - y.from) + 4.0,
                       fmt::format("{:.3g}", y.low + share * (y.high - y.low)), "end");
    }
    svg += text_at(0.5 * (x.from + x.to), y.from + 34.0, x_name, "middle", " font-weight=\"bold\"");
    const double middle = 0.5 * (y.from + y.to);
    return svg + text_at(11.0, middle, y_name, "middle",
                         fmt::format(" font-weight=\"bold\" transform=\"rotate(-90 11 {:.1f})\"", middle).c_str());
}

std::string picture(double width, const std::string& inside) {
    return fmt::format("<svg viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
                       "xmlns=\"http://www.w3.org/2000/svg\" font-family=\"sans-serif\" font-size=\"10\">"
                       "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>{2}</svg>\n",
                       width, chart_height, inside);
}

// Groups of rows by the values of a column: one for each distinct value if there are few, else ranges of equal width.
class Groups {
  public:
    Groups(std::span<const double> values, std::size_t most) {
        std::vector<double> sorted(values.begin(), values.end());
        std::erase_if(sorted, [](double v) { return !std::isfinite(v); });
        std::sort(sorted.begin(), sorted.end());
        sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
        if (sorted.empty()) return;
        if (sorted.size() <= most) {
            centers_ = sorted;
            return;
        }
        low_ = sorted.front(), width_ = (sorted.back() - sorted.front()) / static_cast<double>(most);
        for (std::size_t i = 0; i < most; ++i) centers_.push_back(low_ + (static_cast<double>(i) + 0.5) * width_);
    }
    const std::vector<double>& centers() const { return centers_; }
    std::size_t of(double v) const {
        if (width_ > 0.0) {
            return std::min(centers_.size() - 1, static_cast<std::size_t>(std::max(0.0, (v - low_) / width_)));
        }
        return static_cast<std::size_t>(std::lower_bound(centers_.begin(), centers_.end(), v) - centers_.begin());
    }
    // Lower border of a group's cell; for the number of groups, the upper border of the last cell.
    double border(std::size_t i) const {
        const std::vector<double>& c = centers_;
        if (c.size() == 1) return c[0] + (i == 0 ? -0.5 : 0.5);
        if (i == 0) return c[0] - 0.5 * (c[1] - c[0]);
        if (i == c.size()) return c[i - 1] + 0.5 * (c[i - 1] - c[i - 2]);
        return 0.5 * (c[i - 1] + c[i]);
    }

  private:
    std::vector<double> centers_;
    double low_ = 0.0, width_ = 0.0;
};

// From dark blue over green to yellow, with lightness increasing with the value.
std::string color_of(double share) {
    constexpr std::array<std::array<double, 3>, 5> stops{
        {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};
    const double at = 4.0 * std::clamp(share, 0.0, 1.0);
    const std::size_t i = std::min<std::size_t>(3, static_cast<std::size_t>(at));
    std::array<int, 3> mixed{};
    for (std::size_t k = 0; k < 3; ++k) {
        mixed[k] = static_cast<int>(stops[i][k] + (at - static_cast<double>(i)) * (stops[i + 1][k] - stops[i][k]));
    }
    return fmt::format("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2]);
}

} // namespace

std::string histogram(const Series& series) {
    const auto [low, high] = range_of(series.values);
    if (!(low <= high)) return {};
    const Scale x = scale_of(low, high, chart_left, chart_width - chart_right);
    std::vector<double> counts(most_bars);
    for (const double v : series.values) {
        if (!std::isfinite(v)) continue;
        const double place = static_cast<double>(most_bars) * (v - x.low) / (x.high - x.low);
        counts[std::min(most_bars - 1, static_cast<std::size_t>(place))] += 1.0;
    }
    const Scale y =
        scale_of(0.0, *std::max_element(counts.begin(), counts.end()), chart_height - chart_bottom, chart_top);
    std::string svg;
    const double width = (x.to - x.from) / static_cast<double>(most_bars);
    for (std::size_t i = 0; i < most_bars; ++i) {
        const double from = x.from + static_cast<double>(i) * width, to = y(counts[i]);
        svg += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"#3b528b\"/>",
                           from, to, 0.92 * width, y.from - to);
    }
    return picture(chart_width, svg + axes(x, y, series.name, "rows"));
}

std::string effect_plot(const Series& x_series, const Series& values) {
    const Groups groups(x_series.values, most_cells);
    std::vector<std::vector<double>> members(groups.centers().size());
    for (std::size_t i = 0; i < values.values.size(); ++i) {
        if (std::isfinite(values.values[i])) members[groups.of(x_series.values[i])].push_back(values.values[i]);
    }
    const auto [low, high] = range_of(values.values);
    if (!(low <= high)) return {};
    const Scale x = scale_of(groups.centers().front(), groups.centers().back(), chart_left, chart_width - chart_right);
    const Scale y = scale_of(low, high, chart_height - chart_bottom, chart_top);
    std::string line, svg;
    for (std::size_t g = 0; g < members.size(); ++g) {
        std::vector<double>& all = members[g];
        if (all.empty()) continue;
        std::sort(all.begin(), all.end());
        double sum = 0.0;
        for (const double v : all) sum += v;
        const auto quantile = [&](double q) {
            return all[static_cast<std::size_t>(q * static_cast<double>(all.size() - 1))];
        };
        const double at = x(groups.centers()[g]), mean = y(sum / static_cast<double>(all.size()));
        svg += fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}\" stroke=\"#9ab\" stroke-width=\"3\"/>", at,
                           y(quantile(0.05)), y(quantile(0.95)));
        line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", at, mean);
    }
    svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#3b528b\" stroke-width=\"2\"/>", line);
    return picture(chart_width, svg + axes(x, y, x_series.name, values.name));
}

std::string heat_map(const Series& x_series, const Series& y_series, const Series& values) {
    // The number of cells is chosen so that most have several rows.
    const double each = 0.5 * std::sqrt(static_cast<double>(values.values.size()));
    const std::size_t most = std::clamp(static_cast<std::size_t>(each), std::size_t{4}, most_cells);
    const Groups columns(x_series.values, most), rows(y_series.values, most);
    const std::size_t width = columns.centers().size(), height = rows.centers().size();
    if (width == 0 || height == 0) return {};
    std::vector<double> sums(width * height), counts(width * height);
    for (std::size_t i = 0; i < values.values.size(); ++i) {
        if (!std::isfinite(values.values[i])) continue;
        const std::size_t cell = rows.of(y_series.values[i]) * width + columns.of(x_series.values[i]);
        sums[cell] += values.values[i];
        counts[cell] += 1.0;
    }
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i]; // NaN in empty cells
    const auto [low, high] = range_of(sums);
    if (!(low <= high)) return {};
    const Scale x = scale_of(columns.border(0), columns.border(width), chart_left, chart_width - chart_right);
    const Scale y = scale_of(rows.border(0), rows.border(height), chart_height - chart_bottom, chart_top);
    const Scale share = scale_of(low, high, 0.0, 1.0);
    std::string svg;
    for (std::size_t r = 0; r < height; ++r) {
        for (std::size_t c = 0; c < width; ++c) {
            if (std::isnan(sums[r * width + c])) continue;
            const double from = x(columns.border(c)), to = y(rows.border(r + 1));
            svg += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>", from,
                               to, x(columns.border(c + 1)) - from + 0.3, y(rows.border(r)) - to + 0.3,
                               color_of(share(sums[r * width + c])));
        }
    }
    const double bar = chart_width + 6.0, step = (chart_height - chart_bottom - chart_top) / 20.0;
    for (int i = 0; i < 20; ++i) {
        svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.2f}\" width=\"12\" height=\"{:.2f}\" fill=\"{}\"/>", bar,
                           chart_height - chart_bottom - (i + 1) * step, step + 0.3, color_of((i + 0.5) / 20.0));
    }
    svg += text_at(bar + 16.0, chart_height - chart_bottom, fmt::format("{:.3g}", share.low), "start");
    svg += text_at(bar + 16.0, chart_top + 8.0, fmt::format("{:.3g}", share.high), "start");
    return picture(chart_width + legend_width, svg + axes(x, y, x_series.name, y_series.name));
}

} // namespace cairn::cli
