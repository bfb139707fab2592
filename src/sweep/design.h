// Which values the parameters take in which row: a function of the row's number alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cairn::sweep {

// Of one parameter. A list of values, or a distribution.
struct Parameter {
    enum class Kind {
        list,    // `values`
        uniform, // from `low` to `high`
        log,     // likewise, with an evenly spread logarithm; both positive
        normal,  // mean `low`, standard deviation `high`
    };
    std::string name;
    Kind kind = Kind::list;
    std::vector<double> values;
    double low = 0.0, high = 0.0;

    // That below which the share `u` lies, above 0 and below 1.
    double quantile(double u) const;
};

enum class Sampling {
    grid,        // every value of each parameter with every one of the others; the last parameter changes fastest
    random,      // independent of each other
    sobol,       // a Sobol sequence (Joe and Kuo, 2008), moved by a random shift if the seed is not 0
    sensitivity, // for indices of sensitivity: see `sensitivity_row`
    table,       // the rows of a table: all parameters are lists of equal length
};

// The rows of a design for indices of sensitivity come in groups of d + 2 for d parameters (Saltelli and others, 2010):
// the points a and b, and for each parameter the point a with that parameter of b.
struct SensitivityRow {
    std::uint64_t point = 0;
    std::size_t role = 0; // 0: a; 1: b; 2 + i: a with parameter i of b
};
SensitivityRow sensitivity_row(std::uint64_t row, std::size_t parameters);

class Design {
  public:
    static constexpr std::uint64_t max_rows = 1'000'000'000;

    // `count`: of points that are drawn. Throws Error (invalid_value) whose field is empty.
    Design(Sampling sampling, std::vector<Parameter> parameters, std::uint64_t count, std::uint64_t seed);

    std::uint64_t rows() const { return rows_; }
    Sampling sampling() const { return sampling_; }
    const std::vector<Parameter>& parameters() const { return parameters_; }
    // One number a parameter. From any number of threads.
    void values(std::uint64_t row, std::span<double> out) const;

  private:
    Sampling sampling_;
    std::vector<Parameter> parameters_;
    std::uint64_t seed_, rows_ = 0;
};

} // namespace cairn::sweep
