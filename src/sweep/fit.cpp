#include "sweep/fit.h"

#include "sweep/runner.h"

#include "files/csv_reader.h"
#include "scene/gltf_file.h"

#include <nlopt.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>
#include <set>
#include <string_view>
#include <thread>
#include <utility>

namespace cairn::sweep {

namespace {

// The residual, in deviations, where the scene yields no number: greater than any real one.
constexpr double no_number = 1e6;

bool has_range(const Parameter& parameter) {
    return (parameter.kind == Parameter::Kind::uniform || parameter.kind == Parameter::Kind::log) &&
           parameter.low < parameter.high;
}

// Runs all experiments with given parameters on several threads.
class Experiments {
  public:
    Experiments(const Plan& plan, const Start& start, const Measurements& measured, int threads)
        : plan_(plan), measured_(measured) {
        const std::size_t count = std::min(static_cast<std::size_t>(threads), measured.output_rows.size());
        for (std::size_t i = 0; i < count; ++i) runners_.push_back(std::make_unique<Runner>(plan, start));
    }

    // Returns (computed - measured) / deviation for each experiment and measure, independent of the number of threads.
    std::vector<double> residuals(std::span<const double> parameters) {
        const std::size_t width = measured_.outputs.size();
        std::vector<double> result(measured_.output_rows.size() * width);
        std::atomic<std::size_t> next{0};
        std::mutex mutex;
        std::exception_ptr error;
        const auto work = [&](Runner& runner) {
            try {
                for (std::size_t row = next++; row < measured_.output_rows.size(); row = next++) {
                    one(runner, parameters, row, std::span<double>(result).subspan(row * width, width));
                }
            } catch (...) {
                const std::lock_guard<std::mutex> lock(mutex);
                if (!error) error = std::current_exception();
            }
        };
        {
            std::vector<std::jthread> threads;
            for (std::size_t i = 1; i < runners_.size(); ++i) threads.emplace_back([&, i] { work(*runners_[i]); });
            work(*runners_[0]);
        } // the threads are joined here
        if (error) std::rethrow_exception(error);
        return result;
    }

  private:
    void one(Runner& runner, std::span<const double> parameters, std::size_t row, std::span<double> out) const {
        std::vector<double> values(parameters.begin(), parameters.end()), numbers(plan_.numbers());
        for (std::size_t i = 0; i < measured_.inputs.size(); ++i) {
            values[measured_.inputs[i]] = measured_.input_rows[row][i];
        }
        const std::atomic<bool> never{false};
        runner.run_with(values, numbers, never);
        for (std::size_t i = 0; i < measured_.outputs.size(); ++i) {
            const std::size_t measure = measured_.outputs[i];
            const double off = numbers[plan_.design.parameters().size() + measure] - measured_.output_rows[row][i];
            out[i] = std::isfinite(off) ? off / plan_.measures[measure].deviation : no_number;
        }
    }

    const Plan& plan_;
    const Measurements& measured_;
    std::vector<std::unique_ptr<Runner>> runners_;
};

double sum_of_squares(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double v : values) sum += v * v;
    return sum;
}

// Returns the diagonal of the inverse of a symmetric positive definite matrix, by its Cholesky factor; NaN if the
// matrix is not positive definite.
std::vector<double> inverse_diagonal(std::vector<std::vector<double>> a) {
    const std::size_t n = a.size();
    std::vector<double> diagonal(n, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t k = 0; k < j; ++k) a[j][j] -= a[j][k] * a[j][k];
        if (!(a[j][j] > 0.0)) return diagonal;
        a[j][j] = std::sqrt(a[j][j]);
        for (std::size_t i = j + 1; i < n; ++i) {
            for (std::size_t k = 0; k < j; ++k) a[i][j] -= a[i][k] * a[j][k];
            a[i][j] /= a[j][j];
        }
    }
    for (std::size_t column = 0; column < n; ++column) {
        std::vector<double> x(n); // solution of L x = e
        for (std::size_t i = column; i < n; ++i) {
            x[i] = i == column ? 1.0 : 0.0;
            for (std::size_t k = column; k < i; ++k) x[i] -= a[i][k] * x[k];
            x[i] /= a[i][i];
        }
        diagonal[column] = 0.0;
        for (std::size_t i = column; i < n; ++i) diagonal[column] += x[i] * x[i];
    }
    return diagonal;
}

class Fitter {
  public:
    Fitter(const Plan& plan, const Start& start, const Measurements& measured, const FitOptions& options,
           const std::function<bool(std::uint64_t, double)>& goes_on)
        : plan_(plan), experiments_(plan, start, measured, options.threads), goes_on_(goes_on) {
        const std::vector<Parameter>& parameters = plan.design.parameters();
        parameters_.resize(parameters.size());
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            if (std::count(measured.inputs.begin(), measured.inputs.end(), i) > 0) continue;
            if (!has_range(parameters[i])) {
                throw Error(ErrorCode::invalid_file, plan.file + ": parameters[" + std::to_string(i) + "]", {},
                            "must be a column of the measurements, or have \"from\" below \"to\" to be fitted");
            }
            free_.push_back(i);
        }
        if (free_.empty()) {
            throw Error(ErrorCode::invalid_file, plan.file + ": parameters", {},
                        "leave nothing to fit: all of them are columns of the measurements");
        }
        count_ = options.evaluations > 0 ? options.evaluations : 300 * free_.size();
        best_.assign(free_.size(), 0.5);
    }

    Fit run() {
        search(NLOPT_GN_DIRECT_L, count_ / 2);
        if (!is_interrupted_) search(NLOPT_LN_SBPLX, count_ - count_ / 2);
        Fit result;
        set(best_);
        const std::vector<double> residuals = experiments_.residuals(parameters_);
        result.numbers = residuals.size();
        result.residual = std::sqrt(sum_of_squares(residuals) / static_cast<double>(residuals.size()));
        result.evaluations = evaluations_;
        result.is_interrupted = is_interrupted_;
        const std::vector<double> values = parameters_;
        const std::vector<double> errors = standard_errors(residuals);
        for (std::size_t i = 0; i < free_.size(); ++i) {
            result.parameters.push_back({plan_.design.parameters()[free_[i]].name, values[free_[i]], errors[i]});
        }
        return result;
    }

  private:
    // Sets the fitted parameters; coordinates from 0 to 1 span their ranges.
    void set(const std::vector<double>& place) {
        for (std::size_t i = 0; i < free_.size(); ++i) {
            const Parameter& parameter = plan_.design.parameters()[free_[i]];
            parameters_[free_[i]] = place[i] <= 0.0   ? parameter.low
                                    : place[i] >= 1.0 ? parameter.high
                                                      : parameter.quantile(place[i]);
        }
    }

    double evaluate(const std::vector<double>& place) {
        set(place);
        const double squares = sum_of_squares(experiments_.residuals(parameters_));
        ++evaluations_;
        if (squares < least_) least_ = squares, best_ = place;
        return squares;
    }

    void search(nlopt_algorithm algorithm, std::uint64_t evaluations) {
        const std::size_t n = free_.size();
        nlopt_ = nlopt_create(algorithm, static_cast<unsigned>(n));
        if (nlopt_ == nullptr) throw std::bad_alloc();
        const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> owner(nlopt_, nlopt_destroy);
        const std::vector<double> zero(n, 0.0), one(n, 1.0), step(n, 0.02);
        nlopt_set_lower_bounds(nlopt_, zero.data());
        nlopt_set_upper_bounds(nlopt_, one.data());
        nlopt_set_initial_step(nlopt_, step.data());
        nlopt_set_xtol_rel(nlopt_, 1e-7);
        nlopt_set_maxeval(nlopt_, static_cast<int>(std::clamp<std::uint64_t>(evaluations, 1, 1'000'000'000)));
        nlopt_set_min_objective(nlopt_, &Fitter::objective, this);
        std::vector<double> place = best_;
        double least = 0.0;
        const nlopt_result result = nlopt_optimize(nlopt_, place.data(), &least);
        if (error_) std::rethrow_exception(error_);
        if (result < 0 && result != NLOPT_FORCED_STOP && result != NLOPT_ROUNDOFF_LIMITED) {
            throw Error(ErrorCode::unsupported, plan_.file, {},
                        std::string("cannot be fitted: ") + nlopt_result_to_string(result));
        }
    }

    // Exceptions must not propagate through NLopt, which is C.
    static double objective(unsigned count, const double* place, double*, void* self) {
        Fitter& fitter = *static_cast<Fitter*>(self);
        try {
            if (!fitter.goes_on_(fitter.evaluations_, fitter.least_)) {
                fitter.is_interrupted_ = true;
                nlopt_force_stop(fitter.nlopt_);
                return HUGE_VAL;
            }
            return fitter.evaluate({place, place + count});
        } catch (...) {
            fitter.error_ = std::current_exception();
            nlopt_force_stop(fitter.nlopt_);
            return HUGE_VAL;
        }
    }

    // By central differences: each run starts from the same snapshot, so that only the parameter differs.
    std::vector<double> standard_errors(const std::vector<double>& residuals) {
        const std::size_t n = free_.size();
        constexpr double step = 1e-3; // relative to the range
        std::vector<std::vector<double>> slopes;
        for (std::size_t i = 0; i < n; ++i) {
            std::vector<double> low = best_, high = best_;
            low[i] = std::max(0.0, best_[i] - step), high[i] = std::min(1.0, best_[i] + step);
            set(low);
            const double from = parameters_[free_[i]];
            std::vector<double> slope = experiments_.residuals(parameters_);
            set(high);
            const double way = parameters_[free_[i]] - from;
            const std::vector<double> above = experiments_.residuals(parameters_);
            for (std::size_t k = 0; k < slope.size(); ++k) slope[k] = (above[k] - slope[k]) / way;
            slopes.push_back(std::move(slope));
        }
        std::vector<std::vector<double>> normal(n, std::vector<double>(n));
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                for (std::size_t k = 0; k < residuals.size(); ++k) normal[i][j] += slopes[i][k] * slopes[j][k];
            }
        }
        std::vector<double> errors = inverse_diagonal(normal);
        const double freedom = static_cast<double>(residuals.size()) - static_cast<double>(n);
        const double variance = freedom > 0.0 ? sum_of_squares(residuals) / freedom : HUGE_VAL;
        for (double& error : errors) error = std::sqrt(error * variance);
        return errors;
    }

    const Plan& plan_;
    Experiments experiments_;
    const std::function<bool(std::uint64_t, double)>& goes_on_;
    std::vector<std::size_t> free_; // indices of the fitted parameters
    std::vector<double> parameters_, best_;
    std::uint64_t count_ = 0, evaluations_ = 0;
    double least_ = HUGE_VAL;
    nlopt_opt nlopt_ = nullptr;
    bool is_interrupted_ = false;
    std::exception_ptr error_;
};

} // namespace

Measurements read_measurements(const Plan& plan, const std::filesystem::path& path) {
    const std::vector<std::byte> bytes = scene::read_file(path);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    files::CsvReader reader(text, path.generic_string());
    if (text.empty()) reader.fail("must have a first line with names of parameters and measures");
    Measurements measured;
    std::vector<bool> is_input;
    const std::vector<std::string> names = reader.row();
    std::set<std::string> seen;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!seen.insert(names[i]).second) reader.fail(i, names[i], "must be named once only");
        const std::vector<Parameter>& parameters = plan.design.parameters();
        const auto parameter =
            std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& p) { return p.name == names[i]; });
        const auto measure = std::find_if(plan.measures.begin(), plan.measures.end(),
                                          [&](const Measure& m) { return m.name == names[i]; });
        is_input.push_back(parameter != parameters.end());
        if (is_input.back()) {
            measured.inputs.push_back(static_cast<std::size_t>(parameter - parameters.begin()));
        } else if (measure != plan.measures.end()) {
            measured.outputs.push_back(static_cast<std::size_t>(measure - plan.measures.begin()));
        } else {
            reader.fail(i, names[i], "must be a parameter or a measure of " + plan.file);
        }
    }
    if (measured.outputs.empty()) reader.fail("must have a column with the name of a measure");
    while (!reader.at_end()) {
        const std::vector<std::string> fields = reader.row();
        if (fields.size() == 1 && fields[0].empty()) continue;
        if (fields.size() != names.size()) {
            reader.fail("must have " + std::to_string(names.size()) + " fields as the first line, has " +
                        std::to_string(fields.size()));
        }
        std::vector<double>& inputs = measured.input_rows.emplace_back();
        std::vector<double>& outputs = measured.output_rows.emplace_back();
        for (std::size_t i = 0; i < fields.size(); ++i) {
            (is_input[i] ? inputs : outputs).push_back(reader.number(i, fields[i]));
        }
    }
    if (measured.output_rows.empty()) reader.fail("must have a line of numbers after the first");
    return measured;
}

Fit fit(const Plan& plan, const Start& start, const Measurements& measured, const FitOptions& options,
        const std::function<bool(std::uint64_t, double)>& goes_on) {
    return Fitter(plan, start, measured, options, goes_on).run();
}

} // namespace cairn::sweep
