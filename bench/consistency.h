// How much an engine's result depends on the time step, after Erez, Tassa and Todorov, "Simulation Tools for
// Model-Based Robotics" (ICRA 2015). Each engine is its own reference: a run at 1/64 ms. From states along that run,
// short pieces are simulated with longer steps and compared with the piece at 1/64 ms from the same state. The less an
// engine deviates at a given speed, the better.
#pragma once

#include "bench/engine.h"
#include "bench/measure.h"

#include <string>
#include <vector>

namespace cairn::bench {

// One engine on one scene at one step.
struct ConsistencyPoint {
    std::string scene, engine;
    double time_step = 0;        // s
    double deviation = 0;        // mean distance of the bodies' origins from the reference at the end of a piece, m
    double real_time_factor = 0; // simulated time over processor time
};

struct ConsistencyOptions {
    std::vector<EngineKind> engines;
    int pieces = 10; // number of states of the reference run from which pieces start
};

// Measures a pile of 27 boxes, a tower of 10 boxes and a chain of 5 hinges at steps of 1/64, 1/32, ..., 32 ms.
std::vector<ConsistencyPoint> measure_consistency(const ConsistencyOptions& options, const Progress& progress);

// {"consistency": [{scene, engine, time_step, deviation, real_time_factor}, ...]}
std::string consistency_json(const std::vector<ConsistencyPoint>& points);
// A table per scene, with the steps as rows and the engines as columns.
std::string consistency_tables(const std::vector<ConsistencyPoint>& points);

} // namespace cairn::bench
