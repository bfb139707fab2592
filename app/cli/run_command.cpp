#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/outputs.h"
#include "cli/pictures.h"
#include "cli/progress.h"
#include "cli/trajectory_writer.h"

#include "scene/animation.h"
#include "scene/scene.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <vector>

namespace cairn::cli {

namespace {

constexpr double default_seconds = 10.0;
constexpr double max_steps = 1e9;

struct Outcome {
    std::vector<double> step_times; // ms
    double max_penetration = 0.0;   // m, over all steps
    bool interrupted = false;
};

// Mean and quantiles of the wall-clock time of a step, in milliseconds.
struct StepTimes {
    double mean = 0.0, median = 0.0, p99 = 0.0;
};

StepTimes summarize(std::vector<double> times) {
    StepTimes result;
    if (times.empty()) return result;
    std::sort(times.begin(), times.end());
    for (const double t : times) result.mean += t;
    result.mean /= static_cast<double>(times.size());
    const auto quantile = [&](double q) {
        return times[static_cast<std::size_t>(std::lround(q * static_cast<double>(times.size() - 1)))];
    };
    result.median = quantile(0.5);
    result.p99 = quantile(0.99);
    return result;
}

std::uint64_t count_steps(const RunOptions& options, double time_step) {
    if (options.frames) return static_cast<std::uint64_t>(*options.frames);
    const double steps = std::round(options.seconds.value_or(default_seconds) / time_step);
    if (steps > max_steps) throw Error(ErrorCode::invalid_value, "--seconds", {}, "is more than a billion steps");
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(steps));
}

// Most videos store color for two by two pixels.
void check_size(const RunOptions& options) {
    if (options.video.empty() || viewer::takes_odd_sizes(options.video)) return;
    for (const auto& [option, size] : {std::pair("--width", options.width), std::pair("--height", options.height)}) {
        if (size % 2 != 0) {
            throw Error(ErrorCode::invalid_value, option, std::to_string(size),
                        "must be even for videos other than .gif");
        }
    }
}

void apply_options(const RunOptions& options, scene::Scene& scene) {
    if (options.time_step) scene.info.time_step = static_cast<float>(*options.time_step);
    WorldDef settings = scene.world.settings();
    if (options.substeps) settings.substeps = *options.substeps;
    if (options.integrator) settings.integrator = *options.integrator;
    if (options.substeps || options.integrator) scene.world.set_settings(settings);
    scene.world.set_threads(options.threads.value_or(hardware_threads()));
}

Outcome simulate(const RunOptions& options, scene::Scene& scene, std::uint64_t steps, const InterruptGuard& interrupt) {
    std::unique_ptr<TrajectoryWriter> csv;
    if (!options.csv.empty()) csv = std::make_unique<TrajectoryWriter>(options.csv, scene.world);
    std::unique_ptr<PictureRecorder> pictures;
    if (!options.png.empty() || !options.video.empty()) {
        pictures = std::make_unique<PictureRecorder>(scene, options.png, options.video, options.width, options.height);
    }
    std::optional<scene::AnimationBaker> animation;
    if (!options.animate.empty()) animation.emplace(scene);
    Outcome outcome;
    {
        ProgressLine progress(steps);
        if (csv) csv->add(scene.world);
        if (animation) animation->add(scene.world);
        if (pictures) pictures->add(scene.world);
        for (std::uint64_t i = 0; i < steps && !interrupt.requested(); ++i) {
            const auto start = std::chrono::steady_clock::now();
            scene.world.step(scene.info.time_step);
            const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
            outcome.step_times.push_back(elapsed.count());
            outcome.max_penetration = std::max(outcome.max_penetration, scene.world.statistics().max_penetration);
            if (csv) csv->add(scene.world);
            if (animation) animation->add(scene.world);
            if (pictures) pictures->add(scene.world);
            progress.show(i + 1);
        }
        outcome.interrupted = interrupt.requested();
    }
    if (csv) csv->close();
    if (pictures) pictures->finish(scene.world);
    if (animation) animation->write(options.animate);
    if (!options.save.empty()) scene::save(scene, options.save);
    return outcome;
}

std::string json_summary(const std::string& path, const scene::Scene& scene, const Outcome& outcome) {
    const World& world = scene.world;
    const StepTimes times = summarize(outcome.step_times);
    const Statistics statistics = world.statistics();
    nlohmann::ordered_json json;
    json["scene"] = path;
    json["title"] = scene.info.title;
    json["bodies"] = statistics.bodies;
    json["steps"] = outcome.step_times.size();
    json["time_step"] = static_cast<double>(scene.info.time_step);
    json["threads"] = world.threads();
    json["isa"] = std::string(instruction_set());
    json["ms_per_step"] = {{"mean", times.mean}, {"median", times.median}, {"p99", times.p99}};
    json["hash"] = fmt::format("{:016x}", world.state_hash());
    json["energy"] = {{"kinetic", world.kinetic_energy()}, {"potential", world.potential_energy()}};
    json["max_penetration"] = outcome.max_penetration;
    json["contacts"] = statistics.contacts;
    json["contact_points"] = statistics.contact_points;
    json["interrupted"] = outcome.interrupted;
    json["warnings"] = scene.warnings;
    return json.dump(2) + "\n";
}

std::string text_summary(const std::string& path, const scene::Scene& scene, const Outcome& outcome) {
    const World& world = scene.world;
    const StepTimes times = summarize(outcome.step_times);
    const Statistics statistics = world.statistics();
    std::string text = fmt::format("{} ({}): {} bodies, {} awake\n", path, scene.info.title, statistics.bodies,
                                   statistics.awake_bodies);
    text +=
        fmt::format("{} steps of {:.6g} s on {} ({}){}: {:.3f} ms a step (median {:.3f}, 99 % within {:.3f})\n",
                    outcome.step_times.size(), scene.info.time_step,
                    world.threads() == 1 ? "1 thread" : fmt::format("{} threads", world.threads()), instruction_set(),
                    outcome.interrupted ? ", interrupted" : "", times.mean, times.median, times.p99);
    text += fmt::format("{} contacts, {} points, deepest overlap on the way {:.3g} mm\n", statistics.contacts,
                        statistics.contact_points, 1000.0 * outcome.max_penetration);
    text += fmt::format("kinetic energy {:.6g} J, potential {:.6g} J, state {:016x}\n", world.kinetic_energy(),
                        world.potential_energy(), world.state_hash());
    return text;
}

// Of what was cut while it ran; what the file asks for is said when it is loaded.
void warn_of_speeds(scene::Scene& scene, std::uint64_t count) {
    if (count == 0) return;
    const WorldDef& settings = scene.world.settings();
    scene.warnings.push_back(fmt::format("speeds were cut to the world's limits of {} m/s and {} rad/s, {} in all",
                                         settings.max_linear_speed, settings.max_angular_speed,
                                         count == 1 ? "once" : fmt::format("{} times", count)));
    complain("warning: " + scene.warnings.back());
}

} // namespace

int run_command(const RunOptions& options) {
    check_outputs(std::vector<Output>{{"--csv", options.csv},
                                      {"--png", options.png},
                                      {"--video", options.video},
                                      {"--save", options.save},
                                      {"--animate", options.animate}});
    check_size(options);
    const std::filesystem::path path = scene::find_scene(options.scene);
    scene::Scene scene = scene::load(path);
    print_warnings(scene.warnings);
    apply_options(options, scene);
    const std::uint64_t steps = count_steps(options, scene.info.time_step);
    const InterruptGuard interrupt; // until all is written: an impatient second signal must not lose it
    const std::uint64_t cut_before = scene.world.statistics().clamped_speeds;
    const Outcome outcome = simulate(options, scene, steps, interrupt);
    warn_of_speeds(scene, scene.world.statistics().clamped_speeds - cut_before);
    const std::string name = path.generic_string();
    print(options.json ? json_summary(name, scene, outcome) : text_summary(name, scene, outcome));
    return 0;
}

} // namespace cairn::cli
