#include "bench/consistency.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <ctime>

namespace cairn::bench {

namespace {

struct ConsistencyScene {
    const char* name;
    int size;
};
constexpr ConsistencyScene scenes[] = {{"pile_boxes", 27}, {"tower", 10}, {"chain", 5}};
constexpr double shortest_step = 0.001 / 64, piece_time = 0.128, between_pieces = 0.256; // s
constexpr int doublings = 11;                                                            // up to 32 ms

using States = std::vector<BodyState>;

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

// The scene with its bodies in the given states.
Scene scene_at(Scene scene, const States& states) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        SceneBody& body = scene.bodies[i];
        if (body.motion != Motion::dynamic) continue;
        body.position = Vec3(states[i].position);
        body.rotation = states[i].rotation;
        body.linear_velocity = states[i].linear_velocity;
        body.angular_velocity = states[i].angular_velocity;
    }
    return scene;
}

struct Piece {
    States end;
    double seconds = 0; // processor time
};

Piece run_piece(const EngineKind& kind, const Scene& scene, double time_step) {
    const auto engine = kind.make();
    engine->build(scene, {});
    const int steps = int(std::lround(piece_time / time_step));
    const double start = processor_seconds();
    for (int i = 0; i < steps; ++i) engine->step(float(time_step));
    Piece piece;
    piece.seconds = processor_seconds() - start;
    engine->read(piece.end);
    return piece;
}

// States of the second half of the reference run, in which bodies touch.
std::vector<States> reference_states(const EngineKind& kind, const Scene& scene, int pieces) {
    const auto engine = kind.make();
    engine->build(scene, {});
    const int steps = int(std::lround(between_pieces / shortest_step));
    std::vector<States> states(static_cast<std::size_t>(pieces));
    for (States& state : states) {
        for (int i = 0; i < steps; ++i) engine->step(float(shortest_step));
        engine->read(state);
    }
    return states;
}

double mean_deviation(const Scene& scene, const States& one, const States& other) {
    double sum = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (scene.bodies[i].motion == Motion::dynamic) sum += glm::length(one[i].position - other[i].position);
    return sum / double(scene.dynamic_count);
}

void measure_engine(const EngineKind& kind, const Scene& scene, int pieces, std::vector<ConsistencyPoint>& points) {
    std::vector<Scene> starts;
    for (const States& states : reference_states(kind, scene, pieces)) starts.push_back(scene_at(scene, states));
    std::vector<States> references;
    for (int k = 0; k <= doublings; ++k) {
        ConsistencyPoint point{scene.name, std::string(kind.name), shortest_step * double(1 << k), 0, 0};
        double seconds = 0;
        for (std::size_t i = 0; i < starts.size(); ++i) {
            Piece piece = run_piece(kind, starts[i], point.time_step);
            seconds += piece.seconds;
            if (k == 0)
                references.push_back(std::move(piece.end));
            else
                point.deviation += mean_deviation(scene, piece.end, references[i]) / double(pieces);
        }
        point.real_time_factor = piece_time * double(pieces) / seconds;
        points.push_back(std::move(point));
    }
}

} // namespace

std::vector<ConsistencyPoint> measure_consistency(const ConsistencyOptions& options, const Progress& progress) {
    std::vector<ConsistencyPoint> points;
    for (const auto& [name, size] : scenes) {
        const Scene scene = make_scene(name, size);
        for (const EngineKind& kind : options.engines) {
            progress(fmt::format("{}: {}", name, kind.name));
            measure_engine(kind, scene, options.pieces, points);
        }
    }
    return points;
}

std::string consistency_json(const std::vector<ConsistencyPoint>& points) {
    nlohmann::json all = nlohmann::json::array();
    for (const ConsistencyPoint& p : points)
        all.push_back({{"scene", p.scene},
                       {"engine", p.engine},
                       {"time_step", p.time_step},
                       {"deviation", p.deviation},
                       {"real_time_factor", p.real_time_factor}});
    return nlohmann::json{{"consistency", std::move(all)}}.dump(2) + "\n";
}

std::string consistency_tables(const std::vector<ConsistencyPoint>& points) {
    std::string text =
        "Deviation from the own run at 1/64 ms after 128 ms, mm, and simulated time over processor time\n";
    const std::string* scene = nullptr;
    for (const ConsistencyPoint& p : points) {
        if (!scene || *scene != p.scene)
            text += fmt::format("\n{:<10}{:<10}{:>10}{:>14}{:>12}\n", p.scene, "engine", "step ms", "deviation mm",
                                "real time");
        scene = &p.scene;
        text += fmt::format("{:<10}{:<10}{:>10.4f}{:>14.5f}{:>11.1f}x\n", "", p.engine, 1000 * p.time_step,
                            1000 * p.deviation, p.real_time_factor);
    }
    return text;
}

} // namespace cairn::bench
