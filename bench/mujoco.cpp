// Compares Cairn with MuJoCo on MJCF models that both read, each on one thread: steps per second of processor time, and
// the distance of the bodies from the engine's own run with small steps (after Erez, Tassa and Todorov, ICRA 2015; see
// consistency.cpp). web/bench/mujoco.mjs does the same with the WebAssembly builds of both.
//
// From states along the run with small steps, pieces of 128 ms are simulated with longer steps. The deviation is the
// mean distance of the bodies from their positions at the end of the piece with small steps: both the mean over all
// pieces and the median, as in some falls a box on its edge tips over to one side or the other. The processor time is
// that of the pieces.
#include "scene/scene.h"

#include <cairn/cairn.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr double shortest_step = 0.001 / 64, piece_time = 0.128, between_states = 0.16; // s
constexpr int first_doubling = 6, last_doubling = 10;                                   // 1 to 16 ms
constexpr int most_states = 1000;

using Places = std::vector<glm::dvec3>;

// One engine with one model. Saved states are numbered from 0 in the order in which they were saved.
class Engine {
  public:
    virtual ~Engine() = default;
    virtual void step(double seconds) = 0;
    virtual void keep() = 0;
    virtual void go_back(std::size_t state) = 0;
    virtual Places places() = 0; // positions of the moving bodies
};

class CairnEngine final : public Engine {
  public:
    explicit CairnEngine(const std::filesystem::path& model) : scene_(cairn::scene::load(model)) {
        cairn::WorldDef settings = scene_.world.settings();
        settings.enable_sleep = false;
        scene_.world.set_settings(settings);
    }
    void step(double seconds) override { scene_.world.step(float(seconds)); }
    void keep() override { states_.push_back(scene_.world.save()); }
    void go_back(std::size_t state) override { scene_.world.restore(states_[state]); }
    Places places() override {
        Places all;
        for (const cairn::BodyId id : scene_.world.bodies()) {
            const cairn::Body body = scene_.world.body(id);
            if (body.type() == cairn::BodyType::dynamic) all.push_back(body.position());
        }
        return all;
    }

  private:
    cairn::scene::Scene scene_;
    std::vector<cairn::Snapshot> states_;
};

class MujocoEngine final : public Engine {
  public:
    explicit MujocoEngine(const std::filesystem::path& model) {
        char error[1000] = "";
        model_.reset(mj_loadXML(model.c_str(), nullptr, error, sizeof error));
        if (!model_) throw std::runtime_error(fmt::format("{}: MuJoCo: {}", model.string(), error));
        data_.reset(mj_makeData(model_.get()));
    }
    void step(double seconds) override {
        model_->opt.timestep = seconds;
        mj_step(model_.get(), data_.get());
    }
    void keep() override {
        states_.emplace_back(mj_makeData(model_.get()), mj_deleteData);
        mj_copyData(states_.back().get(), model_.get(), data_.get());
    }
    void go_back(std::size_t state) override { mj_copyData(data_.get(), model_.get(), states_[state].get()); }
    Places places() override {
        mj_kinematics(model_.get(), data_.get()); // otherwise the positions are those before the last step
        Places all;
        for (int body = 1; body < model_->nbody; ++body) { // body 0 is the world
            const mjtNum* const p = data_->xpos + 3 * body;
            all.push_back({p[0], p[1], p[2]});
        }
        return all;
    }

  private:
    std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model_{nullptr, mj_deleteModel};
    std::unique_ptr<mjData, decltype(&mj_deleteData)> data_{nullptr, mj_deleteData};
    std::vector<std::unique_ptr<mjData, decltype(&mj_deleteData)>> states_;
};

struct Options {
    std::filesystem::path folder;
    std::vector<std::string> models{"ragdoll", "ten_boxes"};
    int pieces = 12, rounds = 5;
};

struct Point {
    double step = 0, rate = 0;           // s; steps per second
    double deviation = 0, of_middle = 0; // mean and median over the pieces, m
};

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

// Runs the piece from a saved state; returns the processor time, s.
double run_piece(Engine& engine, std::size_t state, double step, Places& end) {
    engine.go_back(state);
    const double begin = processor_seconds();
    for (long left = std::lround(piece_time / step); left > 0; --left) engine.step(step);
    const double seconds = processor_seconds() - begin;
    end = engine.places();
    return seconds;
}

double mean_distance(const Places& one, const Places& other) {
    double sum = 0;
    for (std::size_t i = 0; i < one.size(); ++i) sum += glm::length(one[i] - other[i]);
    if (!std::isfinite(sum)) throw std::runtime_error("a position is not finite");
    return sum / double(one.size());
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Point measure_step(Engine& engine, const std::vector<Places>& ends, double step, int rounds) {
    Point point;
    point.step = step;
    const double steps = double(ends.size()) * double(std::lround(piece_time / step));
    std::vector<double> rates, deviations;
    Places end;
    for (int round = 0; round < rounds; ++round) {
        double seconds = 0;
        deviations.clear();
        for (std::size_t i = 0; i < ends.size(); ++i) {
            seconds += run_piece(engine, i, step, end);
            deviations.push_back(mean_distance(end, ends[i]));
        }
        rates.push_back(steps / seconds);
    }
    for (const double one : deviations) point.deviation += one / double(deviations.size());
    point.of_middle = median(deviations);
    point.rate = median(rates);
    return point;
}

std::vector<Point> measure(Engine& engine, const Options& options) {
    const long steps = std::lround(between_states / shortest_step);
    for (int i = 0; i < options.pieces; ++i) {
        for (long left = steps; left > 0; --left) engine.step(shortest_step);
        engine.keep();
    }
    std::vector<Places> ends(std::size_t(options.pieces));
    for (std::size_t i = 0; i < ends.size(); ++i) run_piece(engine, i, shortest_step, ends[i]);
    std::vector<Point> points;
    for (int k = first_doubling; k <= last_doubling; ++k)
        points.push_back(measure_step(engine, ends, shortest_step * double(1 << k), options.rounds));
    return points;
}

void print_model(const std::string& name, const std::vector<Point>& ours, const std::vector<Point>& theirs) {
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const Point &a = ours[i], &b = theirs[i];
        fmt::print("| {} | {:.0f} | {:.0f} | {:.0f} | {:.2f} | {:.2g} ({:.2g}) | {:.2g} ({:.2g}) |\n", name,
                   1000 * a.step, a.rate, b.rate, a.rate / b.rate, 1000 * a.deviation, 1000 * a.of_middle,
                   1000 * b.deviation, 1000 * b.of_middle);
    }
}

void run(const Options& options) {
    fmt::print("Native, {} kernels, {} pieces of 128 ms, median of {} rounds\n\n", cairn::instruction_set(),
               options.pieces, options.rounds);
    fmt::print("| model | step, ms | Cairn, steps a second | MuJoCo {}, steps a second | ratio | deviation (of the "
               "middle piece): Cairn, mm | "
               "MuJoCo, mm |\n|---|---|---|---|---|---|---|\n",
               mj_versionString());
    for (const std::string& name : options.models) {
        const std::filesystem::path file = options.folder / (name + ".xml");
        CairnEngine cairn(file);
        MujocoEngine mujoco(file);
        const std::vector<Point> ours = measure(cairn, options);
        print_model(name, ours, measure(mujoco, options));
    }
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Measures Cairn beside MuJoCo: steps a second of the processor, and mm of deviation, at equal steps.");
    app.add_option("--folder", options.folder, "with the models")->required();
    app.add_option("--models", options.models, "names of models")->delimiter(',')->capture_default_str();
    app.add_option("--pieces", options.pieces, "of 128 ms, from so many states of a fall")
        ->check(CLI::Range(1, most_states))
        ->capture_default_str();
    app.add_option("--rounds", options.rounds, "of timing, of which the median is taken")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        run(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench: {}\n", error.what());
        return 1;
    }
    return 0;
}
