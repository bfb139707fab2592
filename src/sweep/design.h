// The design of a sweep: the parameter values of each row, as a function of the row's number alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cairn::sweep {

// A parameter of a sweep: a list of values, or a distribution.
struct Parameter {
    enum class Kind {
        list,    // `values`
        uniform, // from `low` to `high`
        log,     // from `low` to `high`, both positive, with a uniformly distributed logarithm
        normal,  // mean `low`, standard deviation `high`
    };
    std::string name;
    Kind kind = Kind::list;
    std::vector<double> values;
    double low = 0.0, high = 0.0;

    // Returns the quantile of `u`, above 0 and below 1.
    double quantile(double u) const;
};

enum class Sampling {
    grid,        // every combination of the parameters' values; the last parameter changes fastest
    random,      // independent draws
    sobol,       // a Sobol sequence (Joe and Kuo, 2008), with a random shift if the seed is not 0
    sensitivity, // for sensitivity indices: see `sensitivity_row`
    table,       // the rows of a table: all parameters are lists of equal length
};

// The rows of a design for sensitivity indices come in groups of d + 2 for d parameters (Saltelli and others, 2010):
// the points a and b, and for each parameter i the point a with parameter i of b.
struct SensitivityRow {
    std::uint64_t point = 0;
    std::size_t role = 0; // 0: a; 1: b; 2 + i: a with parameter i of b
};
SensitivityRow sensitivity_row(std::uint64_t row, std::size_t parameters);

class Design {
  public:
    static constexpr std::uint64_t max_rows = 1'000'000'000;

    // `count`: the number of points to draw. Throws Error (invalid_value) whose field is empty.
    Design(Sampling sampling, std::vector<Parameter> parameters, std::uint64_t count, std::uint64_t seed);

    std::uint64_t rows() const { return rows_; }
    Sampling sampling() const { return sampling_; }
    const std::vector<Parameter>& parameters() const { return parameters_; }
    // Computes the values of a row, one per parameter. Thread-safe.
    void values(std::uint64_t row, std::span<double> out) const;

  private:
    Sampling sampling_;
    std::vector<Parameter> parameters_;
    std::uint64_t seed_, rows_ = 0;
};

} // namespace cairn::sweep
