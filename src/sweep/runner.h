// Runs rows one after the other.
#pragma once

#include "sweep/address.h"
#include "sweep/expression.h"
#include "sweep/plan.h"

#include <atomic>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cairn::sweep {

enum class Outcome {
    ran,     // until the end
    stopped, // by a stop rule
    failed,  // by an error: nothing was measured
};

// Runs rows on one thread. The result of a row depends on nothing but its number.
class Runner {
  public:
    // Checks all paths and expressions. Throws Error (invalid_file). `plan` and `start` must outlive the runner.
    Runner(const Plan& plan, const Start& start);

    // Computes the numbers of a row in the order of the columns, without the index. Once `interrupted` is true, it may
    // end early and return false; the numbers are then invalid.
    bool run(std::uint64_t row, std::span<double> numbers, const std::atomic<bool>& interrupted);
    // The same as `run` for given values of the parameters.
    bool run_with(std::span<const double> parameters, std::span<double> numbers, const std::atomic<bool>& interrupted);

    // The reason why the last row failed; empty if it did not.
    const std::string& failure() const { return failure_; }
    // The world at the end of the last row.
    const World& world() const { return trial_.world; }

  private:
    struct Formula {
        Expression expression;
        std::vector<std::size_t> readings; // the readings of the world that the expression uses
    };
    struct Reading {
        Address address;
        double value = 0.0;
    };
    // A property that is set, and the settings of its components.
    struct Target {
        Address address;
        std::vector<std::pair<std::size_t, std::size_t>> components; // component, and the setting that gives its value
        std::string place;
    };

    Formula formula(const std::string& text, const std::string& place, bool sees_measures);
    void add_target(const Assignment& setting, std::size_t index);
    double value(const Formula& formula);
    void prepare();
    bool simulate(const std::atomic<bool>& interrupted);
    void measure(std::uint64_t step, std::uint64_t steps);
    bool is_stopped();
    void finish();

    const Plan& plan_;
    const Start& start_;
    Trial trial_;
    std::vector<double> parameters_;
    std::deque<Reading> readings_; // a deque, as expressions hold pointers to the values
    std::vector<Formula> settings_, stops_, measures_;
    std::vector<Target> targets_;
    std::vector<double> results_; // by measure
    std::uint64_t steps_done_ = 0;
    Outcome outcome_ = Outcome::ran;
    std::string failure_;
    bool has_step_measures_ = false;
};

} // namespace cairn::sweep
