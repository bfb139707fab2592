// Runs rows, one after the other.
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
    ran,     // to the end
    stopped, // by a rule
    failed,  // an error: nothing was measured
};

// Of one thread. What a row says depends on nothing but its number.
class Runner {
  public:
    // Checks all paths and expressions. Throws Error (invalid_file). `plan` and `start` must outlive it.
    Runner(const Plan& plan, const Start& start);

    // The numbers of a row in the order of the columns, without the index. Once `interrupted` is true it may end before
    // its time, and gives false: the numbers are good for nothing.
    bool run(std::uint64_t row, std::span<double> numbers, const std::atomic<bool>& interrupted);
    // Likewise, with these values of the parameters.
    bool run_with(std::span<const double> parameters, std::span<double> numbers, const std::atomic<bool>& interrupted);

    // Why the last row failed; empty if it did not.
    const std::string& failure() const { return failure_; }
    // The world as the last row left it.
    const World& world() const { return trial_.world; }

  private:
    struct Formula {
        Expression expression;
        std::vector<std::size_t> readings; // what it needs of the world
    };
    struct Reading {
        Address address;
        double value = 0.0;
    };
    // All numbers of a property that is set.
    struct Target {
        Address address;
        std::vector<std::pair<std::size_t, std::size_t>> components; // and the settings that give them
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
    std::deque<Reading> readings_; // which expressions point into
    std::vector<Formula> settings_, stops_, measures_;
    std::vector<Target> targets_;
    std::vector<double> results_; // of measures
    std::uint64_t steps_done_ = 0;
    Outcome outcome_ = Outcome::ran;
    std::string failure_;
    bool has_step_measures_ = false;
};

} // namespace cairn::sweep
