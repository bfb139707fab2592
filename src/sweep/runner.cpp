#include "sweep/runner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cairn::sweep {

namespace {

constexpr double no_result = std::numeric_limits<double>::quiet_NaN();
constexpr double max_steps = 1e9;

} // namespace

Runner::Runner(const Plan& plan, const Start& start)
    : plan_(plan), start_(start), parameters_(plan.design.parameters().size()), results_(plan.measures.size()) {
    trial_.world.restore(start.snapshot);
    trial_.time_step = start.time_step;
    for (std::size_t i = 0; i < plan.settings.size(); ++i) {
        const Assignment& setting = plan.settings[i];
        settings_.push_back(formula(setting.expression, setting.place, false));
        add_target(setting, i);
    }
    // All changes of a joint are applied together.
    std::stable_sort(targets_.begin(), targets_.end(), [](const Target& a, const Target& b) {
        return a.address.subject.joint.bits < b.address.subject.joint.bits;
    });
    for (const Assignment& stop : plan.stops) stops_.push_back(formula(stop.expression, stop.place, false));
    for (const Measure& measure : plan.measures) {
        measures_.push_back(formula(measure.expression, measure.place, measure.take == Measure::Take::end));
        has_step_measures_ |= measure.take != Measure::Take::end;
    }
}

Runner::Formula Runner::formula(const std::string& text, const std::string& place, bool sees_measures) {
    std::vector<std::size_t> readings;
    const Variables find = [&](const std::string& name) -> double* {
        const std::vector<Parameter>& parameters = plan_.design.parameters();
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            if (parameters[i].name == name) return &parameters_[i];
        }
        for (std::size_t i = 0; i < measures_.size() && sees_measures; ++i) {
            if (plan_.measures[i].name == name) return &results_[i];
        }
        if (name != "time" && name.find('.') == std::string::npos) {
            throw Error(ErrorCode::invalid_value, name, {},
                        "must be a parameter, a measure before this one, a function, or a path such as "
                        "crate.position.x");
        }
        const Address address = find_address(trial_.world, name == "time" ? "world.time" : name);
        if (address.property->read == nullptr) {
            throw Error(ErrorCode::invalid_value, name, {}, "can be set, but not measured");
        }
        readings.push_back(readings_.size());
        return &readings_.emplace_back(Reading{address}).value;
    };
    try {
        Expression expression(text, find);
        return {std::move(expression), std::move(readings)};
    } catch (const Error& error) {
        throw Error(ErrorCode::invalid_file, place.substr(0, place.size() - 2), {}, error.what());
    }
}

void Runner::add_target(const Assignment& setting, std::size_t index) {
    const std::string place = setting.place.substr(0, setting.place.size() - 2);
    Address address;
    try {
        address = find_address(trial_.world, setting.path);
    } catch (const Error& error) {
        throw Error(ErrorCode::invalid_file, plan_.file + ": set", {}, error.what());
    }
    if (address.property->write == nullptr) {
        throw Error(ErrorCode::invalid_file, place, {}, "can be measured, but not set");
    }
    const auto is_same = [&](const Target& target) {
        const Subject &a = target.address.subject, &b = address.subject;
        return target.address.property == address.property && a.body == b.body && a.shape == b.shape &&
               a.joint == b.joint && a.axis == b.axis;
    };
    auto target = std::find_if(targets_.begin(), targets_.end(), is_same);
    if (target == targets_.end()) target = targets_.insert(targets_.end(), Target{address, {}, place});
    target->components.push_back({address.component, index});
}

double Runner::value(const Formula& formula) {
    for (const std::size_t i : formula.readings) readings_[i].value = readings_[i].address.read(trial_);
    return formula.expression.value();
}

void Runner::prepare() {
    trial_.world.restore(start_.snapshot);
    trial_.time_step = start_.time_step;
    // All values are computed before any is set, so that the order of the settings does not matter.
    std::vector<double> values;
    for (const Formula& setting : settings_) values.push_back(value(setting));
    Changes changes(trial_);
    for (const Target& target : targets_) {
        try {
            double numbers[4];
            target.address.property->read(trial_, target.address.subject, numbers);
            for (const auto& [component, setting] : target.components) numbers[component] = values[setting];
            target.address.property->write(changes, target.address.subject, numbers);
        } catch (const Error& error) {
            throw Error(error.code(), target.place, {}, error.what());
        }
    }
    changes.finish();
}

void Runner::measure(std::uint64_t step, std::uint64_t steps) {
    const double now = static_cast<double>(step) * trial_.time_step;
    for (std::size_t i = 0; i < measures_.size(); ++i) {
        const Measure& measure = plan_.measures[i];
        if (measure.take == Measure::Take::end) continue;
        if (measure.take == Measure::Take::at) {
            if (std::min(std::round(measure.time / trial_.time_step), static_cast<double>(steps)) ==
                static_cast<double>(step)) {
                results_[i] = value(measures_[i]);
            }
            continue;
        }
        double& result = results_[i];
        const double v = value(measures_[i]);
        switch (measure.take) {
        case Measure::Take::max:
            result = std::isnan(result) || v > result ? v : result;
            break;
        case Measure::Take::min:
            result = std::isnan(result) || v < result ? v : result;
            break;
        case Measure::Take::mean:
            if (step > 0) result = (step == 1 ? 0.0 : result) + v;
            break;
        case Measure::Take::first:
            if (std::isnan(result) && v != 0.0 && !std::isnan(v)) result = now;
            break;
        default: // since
            if (!(v != 0.0) || std::isnan(v)) {
                result = no_result;
            } else if (std::isnan(result)) {
                result = now;
            }
        }
    }
}

bool Runner::is_stopped() {
    return std::any_of(stops_.begin(), stops_.end(), [&](const Formula& stop) {
        const double v = value(stop);
        return v != 0.0 && !std::isnan(v);
    });
}

bool Runner::simulate(const std::atomic<bool>& interrupted) {
    const double count = std::round(plan_.seconds / trial_.time_step);
    if (count > max_steps) {
        throw Error(ErrorCode::invalid_value, "seconds", std::to_string(plan_.seconds), "is more than a billion steps");
    }
    const auto steps = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(count));
    const auto dt = static_cast<float>(trial_.time_step);
    if (has_step_measures_) measure(0, steps);
    for (std::uint64_t step = 1; step <= steps; ++step) {
        if (step % 64 == 0 && interrupted) return false;
        trial_.world.step(dt);
        steps_done_ = step;
        if (has_step_measures_) measure(step, steps);
        if (!stops_.empty() && is_stopped()) {
            outcome_ = Outcome::stopped;
            break;
        }
    }
    return true;
}

// Computes the measures that are only known at the end.
void Runner::finish() {
    for (std::size_t i = 0; i < measures_.size(); ++i) {
        if (plan_.measures[i].take == Measure::Take::end) results_[i] = value(measures_[i]);
        if (plan_.measures[i].take == Measure::Take::mean) results_[i] /= static_cast<double>(steps_done_);
    }
}

bool Runner::run(std::uint64_t row, std::span<double> numbers, const std::atomic<bool>& interrupted) {
    std::vector<double> values(parameters_.size());
    plan_.design.values(row, values);
    return run_with(values, numbers, interrupted);
}

bool Runner::run_with(std::span<const double> parameters, std::span<double> numbers,
                      const std::atomic<bool>& interrupted) {
    std::copy(parameters.begin(), parameters.end(), parameters_.begin());
    std::fill(results_.begin(), results_.end(), no_result);
    steps_done_ = 0;
    outcome_ = Outcome::ran;
    failure_.clear();
    try {
        prepare();
        if (!simulate(interrupted)) return false;
        finish();
    } catch (const Error& error) {
        failure_ = error.what();
        outcome_ = Outcome::failed;
        std::fill(results_.begin(), results_.end(), no_result);
    }
    auto out = std::copy(parameters_.begin(), parameters_.end(), numbers.begin());
    out = std::copy(results_.begin(), results_.end(), out);
    // All NaNs get the same bits, and negative zeros become positive, so that hashes are reproducible.
    for (auto n = numbers.begin(); n != out; ++n) *n = std::isnan(*n) ? no_result : *n + 0.0;
    *out++ = static_cast<double>(steps_done_) * trial_.time_step;
    *out = static_cast<double>(outcome_);
    return true;
}

} // namespace cairn::sweep
