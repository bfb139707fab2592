#include "sweep/design.h"

#include "sweep/numbers.h"

#include <cairn/error.h>

#include <boost/random/sobol.hpp>

#include <cmath>
#include <utility>

namespace cairn::sweep {

namespace {

[[noreturn]] void refuse_design(const std::string& expected, const std::string& value = {}) {
    throw Error(ErrorCode::invalid_value, {}, value, expected);
}

// Returns the product, saturated at the maximum.
std::uint64_t product(std::uint64_t a, std::uint64_t b) { return b != 0 && a > UINT64_MAX / b ? UINT64_MAX : a * b; }

// Returns a point of the Sobol sequence, whose first point (all zeros) is left out.
void sobol_point(std::uint64_t number, std::uint64_t seed, std::span<double> out) {
    boost::random::sobol_engine<std::uint64_t, 64> engine(out.size());
    engine.seed(number);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const std::uint64_t shift = seed == 0 ? 0 : hash_pair(seed, i);
        out[i] = unit_interval(engine() ^ shift);
    }
}

} // namespace

double Parameter::quantile(double u) const {
    if (kind == Kind::list) {
        const auto index = static_cast<std::size_t>(u * static_cast<double>(values.size()));
        return values[index < values.size() ? index : values.size() - 1];
    }
    if (kind == Kind::normal) return low + high * normal_quantile(u);
    if (kind == Kind::log) return exponential(natural_log(low) * (1.0 - u) + natural_log(high) * u);
    return low * (1.0 - u) + high * u;
}

SensitivityRow sensitivity_row(std::uint64_t row, std::size_t parameters) {
    return {row / (parameters + 2), static_cast<std::size_t>(row % (parameters + 2))};
}

Design::Design(Sampling sampling, std::vector<Parameter> parameters, std::uint64_t count, std::uint64_t seed)
    : sampling_(sampling), parameters_(std::move(parameters)), seed_(seed) {
    const std::size_t dimensions = parameters_.size();
    for (const Parameter& parameter : parameters_) {
        if (parameter.kind == Parameter::Kind::list && parameter.values.empty()) {
            refuse_design("there are no values for \"" + parameter.name + "\", so that there is no row");
        }
    }
    rows_ = 1;
    switch (sampling_) {
    case Sampling::grid:
        for (const Parameter& parameter : parameters_) rows_ = product(rows_, parameter.values.size());
        break;
    case Sampling::table:
        rows_ = parameters_.empty() ? 0 : parameters_[0].values.size();
        break;
    case Sampling::sensitivity:
        rows_ = product(count, dimensions + 2);
        break;
    default:
        rows_ = count;
    }
    if (sampling_ == Sampling::sensitivity && dimensions == 0) refuse_design("must have a parameter");
    if (rows_ > max_rows) {
        refuse_design("must have at most 1000000000 rows", rows_ == UINT64_MAX ? "more" : std::to_string(rows_));
    }
}

void Design::values(std::uint64_t row, std::span<double> out) const {
    const std::size_t count = parameters_.size();
    switch (sampling_) {
    case Sampling::grid:
        for (std::size_t i = count; i-- > 0;) {
            out[i] = parameters_[i].values[row % parameters_[i].values.size()];
            row /= parameters_[i].values.size();
        }
        return;
    case Sampling::table:
        for (std::size_t i = 0; i < count; ++i) out[i] = parameters_[i].values[row];
        return;
    case Sampling::random:
        for (std::size_t i = 0; i < count; ++i) {
            out[i] = parameters_[i].quantile(unit_interval(hash_pair(hash_pair(seed_, row), i)));
        }
        return;
    case Sampling::sobol:
        sobol_point(row, seed_, out);
        for (std::size_t i = 0; i < count; ++i) out[i] = parameters_[i].quantile(out[i]);
        return;
    case Sampling::sensitivity: {
        const SensitivityRow place = sensitivity_row(row, count);
        std::vector<double> both(2 * count); // point a, then point b
        sobol_point(place.point, seed_, both);
        for (std::size_t i = 0; i < count; ++i) {
            const bool from_b = place.role == 1 || place.role == i + 2;
            out[i] = parameters_[i].quantile(both[from_b ? count + i : i]);
        }
        return;
    }
    }
}

} // namespace cairn::sweep
