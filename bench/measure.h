// Runs engines on scenes, one after another in rounds, and sums up.
#pragma once

#include "bench/engine.h"
#include "bench/quality.h"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cairn::bench {

struct MeasureOptions {
    std::vector<std::string> scenes;
    std::vector<EngineKind> engines;
    int rounds = 3;
    int steps = 0;                  // 0: the scene's
    int size = 0;                   // 0: the scene's
    std::vector<int> threads = {1}; // numbers of them; engines without threads run once, on one
    EngineSettings settings;
};

// One engine on one scene. Times are medians over the rounds of that round's mean, median and so on.
struct Result {
    std::string scene, engine, engine_version;
    int threads = 1, steps = 0, rounds = 0;
    std::size_t bodies = 0;                                         // dynamic ones
    double mean_ms = 0, median_ms = 0, p99_ms = 0, greatest_ms = 0; // of a step
    double cpu_ms = 0; // CPU time of a step, mean: what a busy machine adds to mean_ms is not in it
    double min_mean_ms = 0, greatest_mean_ms = 0; // over the rounds
    double build_ms = 0;
    double contacts = 0, points = 0;                      // mean over the sampled steps
    std::optional<double> candidates;                     // likewise
    std::optional<int> substeps;                          // most in any sampled step
    std::optional<double> nanoseconds_per_point;          // mean_ms over points
    std::vector<std::pair<std::string, double>> stage_ms; // mean over the steps
    std::optional<double> bytes_per_body;                 // heap that the world holds at the end, over all its bodies
    // At the end of the last round, unless said otherwise.
    Penetrations penetrations;
    double penetration_peak = 0;              // greatest at each quarter of the run, m
    std::optional<JointErrors> joint_errors;  // of scenes with joints
    double joint_error_peak = 0;              // greatest at every tenth step, m
    std::optional<Displacement> displacement; // of scenes that should stand
    double kinetic_energy = 0;
    std::size_t lost = 0;
    bool repeatable = true; // every round ended in the same state, by bits
};

using Progress = std::function<void(const std::string& line)>;

// Per scene the engines take turns: A B A B. `progress` is told what begins, and
// which engine cannot do a scene. Throws SceneError and cairn::Error.
std::vector<Result> measure(const MeasureOptions& options, const Progress& progress);

} // namespace cairn::bench
