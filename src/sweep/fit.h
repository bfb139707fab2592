// Finds the parameters of a plan with which a scene does what was measured.
#pragma once

#include "sweep/plan.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace cairn::sweep {

// What was measured: a row for each experiment.
struct Measurements {
    std::vector<std::size_t> inputs;  // parameters that the experiments were made with, by column
    std::vector<std::size_t> outputs; // measures, by column
    std::vector<std::vector<double>> input_rows, output_rows;
};

// The columns of the table are names of parameters and of measures. Throws Error (io, invalid_file).
Measurements read_measurements(const Plan& plan, const std::filesystem::path& path);

struct FitOptions {
    int threads = 1;
    std::uint64_t evaluations = 0; // at most so many, each of all experiments; 0: 300 for each parameter
};

struct Fitted {
    std::string name;
    double value = 0.0;
    double error = 0.0; // standard error; not a number if the measurements do not tell it
};

struct Fit {
    std::vector<Fitted> parameters;
    double residual = 0.0;   // root mean square of (computed - measured) / deviation
    std::size_t numbers = 0; // how many were compared
    std::uint64_t evaluations = 0;
    bool is_interrupted = false;
};

// Fits the parameters that are in no column, between the ends of their ranges. The least squares are looked for all
// over (DIRECT-L), then from the best place on (Sbplx); both are NLopt's. `goes_on` is asked before each evaluation
// with their number so far, and the least residual. Throws Error (invalid_file): nothing is left to be fitted, a
// parameter has no range.
Fit fit(const Plan& plan, const Start& start, const Measurements& measured, const FitOptions& options,
        const std::function<bool(std::uint64_t, double)>& goes_on);

} // namespace cairn::sweep
