// Runs engines on scenes in alternating rounds, and summarizes the results.
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
    int steps = 0;                  // 0: default of the scene
    int size = 0;                   // 0: default of the scene
    std::vector<int> threads = {1}; // numbers of threads; engines without threads run once, on one
    EngineSettings settings;
};

// The result of one engine on one scene. Times are medians over the rounds of each round's mean, median and so on.
struct Result {
    std::string scene, engine, engine_version;
    int threads = 1, steps = 0, rounds = 0;
    std::size_t bodies = 0;                                         // dynamic bodies
    double mean_ms = 0, median_ms = 0, p99_ms = 0, greatest_ms = 0; // per step
    double cpu_ms = 0; // CPU time per step, mean; unlike mean_ms not affected by other programs on the machine
    double min_mean_ms = 0, greatest_mean_ms = 0; // over the rounds
    double build_ms = 0;
    double contacts = 0, points = 0;                      // mean over the sampled steps
    std::optional<double> candidates;                     // mean over the sampled steps
    std::optional<int> substeps;                          // maximum over the sampled steps
    std::optional<double> nanoseconds_per_point;          // mean_ms / points
    std::vector<std::pair<std::string, double>> stage_ms; // mean over the steps
    std::optional<double> bytes_per_body;                 // heap memory of the world at the end / bodies
    // State at the end of the last round, unless stated otherwise.
    Penetrations penetrations;
    double penetration_peak = 0;              // maximum over samples at each quarter of the run, m
    std::optional<JointErrors> joint_errors;  // for scenes with joints
    double joint_error_peak = 0;              // maximum over samples at every tenth step, m
    std::optional<Displacement> displacement; // for scenes that should stay at rest
    double kinetic_energy = 0;
    std::size_t lost = 0;
    bool repeatable = true; // whether every round ended in the same state, bit for bit
};

using Progress = std::function<void(const std::string& line)>;

// For each scene the engines alternate: A B A B. `progress` receives a line when a measurement begins, and when an
// engine cannot simulate a scene. Throws SceneError and cairn::Error.
std::vector<Result> measure(const MeasureOptions& options, const Progress& progress);

} // namespace cairn::bench
