#include "sweep/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace cairn::sweep {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t failures_kept = 10;

// First-order and total indices from sums over points: the estimators of Saltelli and others (2010) and of Jansen
// (1999).
struct Indices {
    double first = unknown, total = unknown;
};

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Returns the standard error of the mean of independent estimates.
double standard_error(const std::vector<double>& values) {
    if (values.size() < 2) return unknown;
    const double mean = mean_of(values), n = static_cast<double>(values.size());
    double squares = 0.0;
    for (const double v : values) squares += (v - mean) * (v - mean);
    return std::sqrt(squares / (n - 1.0) / n);
}

} // namespace

void Summary::Moments::add(double x) {
    min = count == 0 || x < min ? x : min;
    max = count == 0 || x > max ? x : max;
    ++count;
    const double step = x - mean;
    mean += step / static_cast<double>(count);
    squares += step * (x - mean);
}

Summary::Summary(const Plan& plan)
    : plan_(plan), parameters_(plan.design.parameters().size()), measures_(plan.measures.size()),
      moments_(parameters_ + measures_),
      sums_(batches, std::vector<PointSums>(measures_, PointSums{0.0, 0.0, 0.0, std::vector<double>(parameters_),
                                                                 std::vector<double>(parameters_)})),
      origins_(measures_, unknown) {
    sample_.columns.resize(parameters_ + measures_);
    const std::uint64_t most = std::clamp<std::uint64_t>(
        Sample::most_numbers / std::max<std::size_t>(1, moments_.size()), 1, Sample::most_rows);
    sample_.every = (plan.design.rows() + most - 1) / most;
}

void Summary::add(std::uint64_t row, std::span<const double> numbers) {
    ++rows_;
    for (const double number : numbers) hash_.add(number);
    const auto outcome = static_cast<std::size_t>(numbers.back());
    ++outcomes_[outcome];
    if (outcome == static_cast<std::size_t>(Outcome::failed) && failures_.size() < failures_kept)
        failures_.push_back(row);
    for (std::size_t i = 0; i < moments_.size(); ++i) {
        if (std::isfinite(numbers[i])) moments_[i].add(numbers[i]);
        if (row % sample_.every == 0) sample_.columns[i].push_back(numbers[i]);
    }
    if (plan_.design.sampling() != Sampling::sensitivity) return;
    for (std::size_t m = 0; m < measures_; ++m) point_.push_back(numbers[parameters_ + m]);
    if (sensitivity_row(row, parameters_).role == parameters_ + 1) add_point();
}

void Summary::add_point() {
    const std::size_t batch = static_cast<std::size_t>(points_++ % batches);
    for (std::size_t m = 0; m < measures_; ++m) {
        const auto of_role = [&](std::size_t role) { return point_[role * measures_ + m]; };
        bool is_whole = true;
        for (std::size_t role = 0; role < parameters_ + 2; ++role) is_whole &= std::isfinite(of_role(role));
        if (!is_whole) continue;
        if (std::isnan(origins_[m])) origins_[m] = of_role(0);
        const double a = of_role(0) - origins_[m], b = of_role(1) - origins_[m];
        PointSums& sums = sums_[batch][m];
        sums.count += 1.0;
        sums.sum += a + b;
        sums.squares += a * a + b * b;
        for (std::size_t i = 0; i < parameters_; ++i) {
            const double ab = of_role(2 + i) - origins_[m];
            sums.first[i] += b * (ab - a);
            sums.total[i] += (a - ab) * (a - ab);
        }
    }
    point_.clear();
}

std::vector<ColumnSummary> Summary::columns() const {
    std::vector<ColumnSummary> columns;
    const std::vector<std::string> names = plan_.columns();
    for (std::size_t i = 0; i < moments_.size(); ++i) {
        const Moments& m = moments_[i];
        const double count = static_cast<double>(m.count);
        ColumnSummary column{names[i + 1], m.count, unknown, unknown, unknown, unknown};
        if (m.count > 0) column.mean = m.mean, column.min = m.min, column.max = m.max;
        if (m.count > 1) column.deviation = std::sqrt(m.squares / (count - 1.0));
        columns.push_back(column);
    }
    return columns;
}

Sensitivity Summary::sensitivity(std::size_t parameter, std::size_t measure) const {
    return plan_.design.sampling() == Sampling::sensitivity ? of_design(parameter, measure)
                                                            : of_rows(parameter, measure);
}

Sensitivity Summary::of_design(std::size_t parameter, std::size_t measure) const {
    const auto indices = [&](double count, double sum, double squares, double first, double total) {
        const double mean = sum / (2.0 * count), variance = squares / (2.0 * count) - mean * mean;
        if (!(count >= 2.0) || !(variance > 0.0)) return Indices{};
        return Indices{first / count / variance, total / (2.0 * count) / variance};
    };
    double count = 0.0, sum = 0.0, squares = 0.0, first = 0.0, total = 0.0;
    std::vector<double> firsts, totals;
    for (const std::vector<PointSums>& batch : sums_) {
        const PointSums& s = batch[measure];
        count += s.count, sum += s.sum, squares += s.squares;
        first += s.first[parameter], total += s.total[parameter];
        const Indices part = indices(s.count, s.sum, s.squares, s.first[parameter], s.total[parameter]);
        if (std::isnan(part.first)) continue;
        firsts.push_back(part.first), totals.push_back(part.total);
    }
    const Indices all = indices(count, sum, squares, first, total);
    return {all.first, standard_error(firsts), all.total, standard_error(totals)};
}

Sensitivity Summary::of_rows(std::size_t parameter, std::size_t measure) const {
    Sensitivity none{unknown, unknown, unknown, unknown};
    const std::vector<double>& xs = sample_.columns[parameter];
    const std::vector<double>& ys = sample_.columns[parameters_ + measure];
    std::vector<std::pair<double, double>> pairs;
    for (std::size_t i = 0; i < xs.size(); ++i) {
        if (std::isfinite(ys[i])) pairs.emplace_back(xs[i], ys[i]);
    }
    if (pairs.size() < 4) return none;
    std::sort(pairs.begin(), pairs.end());
    // Groups of equal values, or of neighboring ones if there are too many different values.
    constexpr std::size_t most_groups = 20;
    std::vector<std::size_t> ends;
    for (std::size_t i = 1; i <= pairs.size() && ends.size() <= most_groups; ++i) {
        if (i == pairs.size() || pairs[i].first != pairs[i - 1].first) ends.push_back(i);
    }
    if (ends.size() > most_groups) {
        const std::size_t groups = std::min(most_groups, pairs.size() / 2);
        ends.clear();
        for (std::size_t g = 1; g <= groups; ++g) ends.push_back(pairs.size() * g / groups);
    }
    const double n = static_cast<double>(pairs.size()), k = static_cast<double>(ends.size());
    double mean = 0.0, all = 0.0, between = 0.0;
    for (const auto& [x, y] : pairs) mean += y / n;
    for (const auto& [x, y] : pairs) all += (y - mean) * (y - mean);
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
        double sum = 0.0;
        for (std::size_t i = begin; i < end; ++i) sum += pairs[i].second - mean;
        if (end > begin) between += sum * sum / static_cast<double>(end - begin);
        begin = end;
    }
    if (!(all > 0.0) || ends.size() < 2 || n <= k) return none;
    // The variance between small groups that is due to chance is subtracted.
    none.first = std::max(0.0, (between - (k - 1.0) * (all - between) / (n - k)) / all);
    return none;
}

} // namespace cairn::sweep
