// Finds the parameters of a plan with which a simulation reproduces measurements.
#pragma once

#include "sweep/plan.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace cairn::sweep {

// The measurements, with a row for each experiment.
struct Measurements {
    std::vector<std::size_t> inputs;  // by column, the parameters that were set in the experiments
    std::vector<std::size_t> outputs; // by column, the measures
    std::vector<std::vector<double>> input_rows, output_rows;
};

// Reads a table whose columns are named by parameters and measures. Throws Error (io, invalid_file).
Measurements read_measurements(const Plan& plan, const std::filesystem::path& path);

struct FitOptions {
    int threads = 1;
    std::uint64_t evaluations = 0; // maximum number of evaluations, each of all experiments; 0: 300 per parameter
};

struct Fitted {
    std::string name;
    double value = 0.0;
    double error = 0.0; // standard error; NaN if the measurements do not determine it
};

struct Fit {
    std::vector<Fitted> parameters;
    double residual = 0.0;   // root mean square of (computed - measured) / deviation
    std::size_t numbers = 0; // number of compared values
    std::uint64_t evaluations = 0;
    bool is_interrupted = false;
};

// Fits the parameters that are not a column of the measurements, within their ranges, by least squares: a global search
// (DIRECT-L), followed by a local one from its best point (Sbplx), both from NLopt. `goes_on` is called before each
// evaluation with the number of evaluations so far and the least residual, and returns false to stop. Throws Error
// (invalid_file) if no parameter is left to be fitted, or if one has no range.
Fit fit(const Plan& plan, const Start& start, const Measurements& measured, const FitOptions& options,
        const std::function<bool(std::uint64_t, double)>& goes_on);

} // namespace cairn::sweep
