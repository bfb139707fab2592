// Statistics over all rows of a sweep.
#pragma once

#include "sweep/plan.h"
#include "sweep/runner.h"
#include "sweep/store.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cairn::sweep {

// Statistics of a column; values that are not numbers do not count.
struct ColumnSummary {
    std::string name;
    std::uint64_t count = 0; // of values that are numbers
    double mean = 0.0, deviation = 0.0, min = 0.0, max = 0.0;
};

// The share of the variance of a measure that a parameter explains: by itself (`first`), and including its interactions
// with other parameters (`total`).
struct Sensitivity {
    double first = 0.0, first_error = 0.0; // standard error; NaN where unknown
    double total = 0.0, total_error = 0.0; // NaN except for Sampling::sensitivity
};

// An evenly spaced subset of the rows that fits into memory, for plots.
struct Sample {
    static constexpr std::uint64_t most_rows = 200'000, most_numbers = 20'000'000;
    std::uint64_t every = 1;                  // one of so many rows is kept
    std::vector<std::vector<double>> columns; // parameters, then measures
};

// Accumulates the rows in their order.
class Summary {
  public:
    explicit Summary(const Plan& plan);
    void add(std::uint64_t row, std::span<const double> numbers);

    std::uint64_t rows() const { return rows_; }
    std::uint64_t count(Outcome outcome) const { return outcomes_[static_cast<std::size_t>(outcome)]; }
    std::uint64_t hash() const { return hash_.value(); }                     // of all numbers of all rows
    const std::vector<std::uint64_t>& failures() const { return failures_; } // row numbers of the first ten failures
    const Sample& sample() const { return sample_; }
    std::vector<ColumnSummary> columns() const; // parameters and measures
    // Returns the sensitivity of a measure to a parameter. For samplings other than `sensitivity` it is estimated from
    // rows with nearly the same value of the parameter.
    Sensitivity sensitivity(std::size_t parameter, std::size_t measure) const;

  private:
    struct Moments {
        std::uint64_t count = 0;
        double mean = 0.0, squares = 0.0, min = 0.0, max = 0.0;
        void add(double x);
    };
    // Sums over the points of the design, for one measure.
    struct PointSums {
        double count = 0.0, sum = 0.0, squares = 0.0;
        std::vector<double> first, total; // by parameter
    };
    static constexpr std::size_t batches = 10; // the spread of their estimates gives the error
    void add_point();
    Sensitivity of_design(std::size_t parameter, std::size_t measure) const;
    Sensitivity of_rows(std::size_t parameter, std::size_t measure) const;

    const Plan& plan_;
    std::size_t parameters_, measures_;
    std::uint64_t rows_ = 0, outcomes_[3]{};
    RowHash hash_;
    std::vector<std::uint64_t> failures_;
    std::vector<Moments> moments_;
    Sample sample_;
    std::vector<double> point_;                // measures of the rows of the current point
    std::vector<std::vector<PointSums>> sums_; // by batch and measure
    std::uint64_t points_ = 0;
    std::vector<double> origins_; // by measure: the first value, which is subtracted before summing
};

} // namespace cairn::sweep
