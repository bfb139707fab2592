// What the rows of a sweep say together.
#pragma once

#include "sweep/plan.h"
#include "sweep/runner.h"
#include "sweep/store.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cairn::sweep {

// Of the numbers of a column that are numbers.
struct ColumnSummary {
    std::string name;
    std::uint64_t count = 0; // how many are
    double mean = 0.0, deviation = 0.0, min = 0.0, max = 0.0;
};

// How much of the variance of a measure a parameter explains: by itself (`first`), and with all that it does together
// with others (`total`).
struct Sensitivity {
    double first = 0.0, first_error = 0.0; // standard error; not a number where it is not known
    double total = 0.0, total_error = 0.0; // not a number but for Sampling::sensitivity
};

// A share of the rows, evenly picked, that fits into memory: for plots.
struct Sample {
    static constexpr std::uint64_t most_rows = 200'000, most_numbers = 20'000'000;
    std::uint64_t every = 1;                  // of so many rows one
    std::vector<std::vector<double>> columns; // parameters, then measures
};

// Takes the rows in their order.
class Summary {
  public:
    explicit Summary(const Plan& plan);
    void add(std::uint64_t row, std::span<const double> numbers);

    std::uint64_t rows() const { return rows_; }
    std::uint64_t count(Outcome outcome) const { return outcomes_[static_cast<std::size_t>(outcome)]; }
    std::uint64_t hash() const { return hash_.value(); }                     // of all numbers of all rows
    const std::vector<std::uint64_t>& failures() const { return failures_; } // the first ten
    const Sample& sample() const { return sample_; }
    std::vector<ColumnSummary> columns() const; // parameters and measures
    // By parameter and measure. Of samplings other than `sensitivity` it comes from rows that have nearly the same
    // value of the parameter.
    Sensitivity sensitivity(std::size_t parameter, std::size_t measure) const;

  private:
    struct Moments {
        std::uint64_t count = 0;
        double mean = 0.0, squares = 0.0, min = 0.0, max = 0.0;
        void add(double x);
    };
    // Sums over points of the design, of one measure.
    struct PointSums {
        double count = 0.0, sum = 0.0, squares = 0.0;
        std::vector<double> first, total; // by parameter
    };
    static constexpr std::size_t batches = 10; // whose estimates tell the error
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
    std::vector<double> point_;                // measures of the rows of the present point
    std::vector<std::vector<PointSums>> sums_; // by batch and measure
    std::uint64_t points_ = 0;
    std::vector<double> origins_; // of measures: the first value, which sums are about
};

} // namespace cairn::sweep
