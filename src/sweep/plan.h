// The plan of a sweep; docs/sweep.md describes the file.
#pragma once

#include "sweep/design.h"

#include "scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::sweep {

// A property that is set before a row starts, to the value of an expression.
struct Assignment {
    std::string path, expression;
    std::string place; // in the plan, for messages
};

// A quantity that is measured in each row.
struct Measure {
    enum class Take {
        end,   // the value at the end
        at,    // the value after the step nearest to `time`
        max,   // the maximum over all steps and the initial state
        min,   // the minimum over all steps and the initial state
        mean,  // the mean over the steps
        first, // the first time at which the value is not 0, s
        since, // the time from which on the value is not 0 until the end, s
    };
    std::string name, expression;
    Take take = Take::end;
    double time = 0.0;      // s
    double deviation = 1.0; // standard deviation of the measurement, for `fit`
    std::string place;
};

// Returns the name of a kind of measurement in plans: "max".
std::string_view name_of(Measure::Take take);

struct Plan {
    std::string file;            // for messages
    std::filesystem::path scene; // path of the scene file
    bool fixed_base = false, floor = false;
    Design design{Sampling::grid, {}, 1, 0};
    std::vector<Assignment> settings;
    std::vector<Measure> measures;
    std::vector<Assignment> stops; // expressions that end a row; `path` is empty
    double seconds = 10.0;
    // A hash of everything that rows depend on except the scene: the plan's text and its table.
    std::uint64_t fingerprint = 0;

    // Returns the names of the columns: index, parameters, measures, time, outcome.
    std::vector<std::string> columns() const;
    // The number of columns without the index.
    std::size_t numbers() const { return design.parameters().size() + measures.size() + 2; }
};

// The purpose of reading a plan: a fit needs no sampling, and no values of the parameters that were measured.
enum class Purpose { sweep, fit };

// Reads a plan. Throws Error: io, invalid_file.
Plan read_plan(const std::filesystem::path& path, Purpose purpose = Purpose::sweep);

// The initial state of all rows, and a fingerprint that tells whether two sweeps are the same.
struct Start {
    Snapshot snapshot;
    double time_step = 1.0 / 60.0; // s
    std::uint64_t fingerprint = 0;
    std::vector<std::string> warnings; // of the scene
};
Start load_start(const Plan& plan);

} // namespace cairn::sweep
