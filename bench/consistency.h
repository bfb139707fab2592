// How much an engine's answer depends on the time step, after Erez, Tassa and Todorov, "Simulation Tools for
// Model-Based Robotics" (ICRA 2015). Each engine is its own reference: a run at 1/64 ms. From states along that run,
// short pieces are run at longer steps, and compared with the piece at 1/64 ms from the same state. An engine that
// deviates less at the same speed gives the user more for his time.
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
    double deviation = 0;        // m: of the bodies' origins from the reference at the end of a piece, mean
    double real_time_factor = 0; // simulated time over the processor time that it took
};

struct ConsistencyOptions {
    std::vector<EngineKind> engines;
    int pieces = 10; // states along the reference run that are restarted from
};

// On a pile of 27 boxes, a tower of 10 boxes and a chain of 5 hinges, at steps of 1/64, 1/32, ..., 32 ms.
std::vector<ConsistencyPoint> measure_consistency(const ConsistencyOptions& options, const Progress& progress);

// {"consistency": [{scene, engine, time_step, deviation, real_time_factor}, ...]}
std::string consistency_json(const std::vector<ConsistencyPoint>& points);
// A table a scene: steps down, engines across.
std::string consistency_tables(const std::vector<ConsistencyPoint>& points);

} // namespace cairn::bench
