// What a sweep does: docs/sweep.md describes the file.
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

// A property that is set before a row begins, to the value of an expression.
struct Assignment {
    std::string path, expression;
    std::string place; // in the plan, for messages
};

// A number that is measured.
struct Measure {
    enum class Take {
        end,   // the value at the end
        at,    // the value after the step that comes nearest to `time`
        max,   // the greatest of all steps, and before the first
        min,   // the least
        mean,  // over the steps
        first, // when it is not 0 for the first time, s
        since, // since when it is not 0 until the end, s
    };
    std::string name, expression;
    Take take = Take::end;
    double time = 0.0;      // s
    double deviation = 1.0; // standard deviation of what was measured, for `fit`
    std::string place;
};

// As it stands in a plan: "max".
std::string_view name_of(Measure::Take take);

struct Plan {
    std::string file;            // for messages
    std::filesystem::path scene; // the file
    bool fixed_base = false, floor = false;
    Design design{Sampling::grid, {}, 1, 0};
    std::vector<Assignment> settings;
    std::vector<Measure> measures;
    std::vector<Assignment> stops; // expressions; `path` is empty
    double seconds = 10.0;
    std::uint64_t fingerprint = 0; // of all that rows depend on but the scene: the plan's text and its table

    // index, parameters, measures, time, outcome
    std::vector<std::string> columns() const;
    std::size_t numbers() const { return design.parameters().size() + measures.size() + 2; } // without the index
};

// What a plan is read for: to fit parameters it needs no sample, and no values of those that were measured.
enum class Purpose { sweep, fit };

// Reads a plan. Throws Error: io, invalid_file.
Plan read_plan(const std::filesystem::path& path, Purpose purpose = Purpose::sweep);

// What rows start from, and a number that tells whether two sweeps are the same.
struct Start {
    Snapshot snapshot;
    double time_step = 1.0 / 60.0; // s
    std::uint64_t fingerprint = 0;
    std::vector<std::string> warnings; // of the scene
};
Start load_start(const Plan& plan);

} // namespace cairn::sweep
