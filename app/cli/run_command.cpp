#include "cli/activity.h"
#include "cli/checkpoints.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/joint_targets.h"
#include "cli/outputs.h"
#include "cli/pictures.h"
#include "cli/progress.h"
#include "cli/ranks.h"
#include "cli/recorders.h"
#include "cli/shared_run.h"

#include "scene/mesh_files.h"
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

// Mean and quantiles of the wall-clock time of a step, in milliseconds.
struct StepTimes {
    double mean = 0.0, median = 0.0, p99 = 0.0;
};

// Statistics of step times in bounded memory: for long runs, quantiles are computed from every second step, every
// fourth, and so on.
class StepClock {
  public:
    void add(double milliseconds) {
        ++steps_;
        sum_ += milliseconds;
        if (steps_ % stride_ != 0) return;
        sample_.push_back(milliseconds);
        if (sample_.size() < largest_sample) return;
        for (std::size_t i = 0; i < largest_sample / 2; ++i) sample_[i] = sample_[2 * i + 1];
        sample_.resize(largest_sample / 2);
        stride_ *= 2;
    }
    std::uint64_t steps() const { return steps_; }

    StepTimes times() const {
        StepTimes result;
        if (sample_.empty()) return result;
        std::vector<double> sorted = sample_;
        std::sort(sorted.begin(), sorted.end());
        const auto quantile = [&](double q) {
            return sorted[static_cast<std::size_t>(std::lround(q * static_cast<double>(sorted.size() - 1)))];
        };
        return {sum_ / static_cast<double>(steps_), quantile(0.5), quantile(0.99)};
    }

  private:
    static constexpr std::size_t largest_sample = std::size_t{1} << 20;
    std::vector<double> sample_;
    std::uint64_t steps_ = 0, stride_ = 1;
    double sum_ = 0.0;
};

struct Outcome {
    StepClock clock;
    double max_penetration = 0.0; // m, over all steps
    bool interrupted = false;
    StageTimes stages; // summed over all steps
    std::vector<RankReport> ranks;
    std::uint64_t first_step = 0; // step number of the checkpoint it resumed from, or 0
    std::string resumed_from;     // the folder of that checkpoint
    CheckpointCount checkpoints;
    std::uint64_t steps() const { return first_step + clock.steps(); } // including steps before resuming
};

void add(StageTimes& sum, const StageTimes& times) {
    sum.broad_phase += times.broad_phase, sum.narrow_phase += times.narrow_phase, sum.islands += times.islands;
    sum.prepare += times.prepare, sum.solve += times.solve, sum.finalize += times.finalize;
}

std::uint64_t count_steps(const RunOptions& options, double time_step) {
    if (options.frames) return static_cast<std::uint64_t>(*options.frames);
    const double steps = std::round(options.seconds.value_or(default_seconds) / time_step);
    if (steps > max_steps) throw Error(ErrorCode::invalid_value, "--seconds", {}, "is more than a billion steps");
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(steps));
}

// Most video formats store color for blocks of 2x2 pixels.
void check_size(const RunOptions& options) {
    if (options.video.empty() || viewer::takes_odd_sizes(options.video)) return;
    for (const auto& [option, size] : {std::pair("--width", options.width), std::pair("--height", options.height)}) {
        if (size % 2 != 0) {
            throw Error(ErrorCode::invalid_value, option, std::to_string(size),
                        "must be even for videos other than .gif");
        }
    }
}

void check_window(const RunOptions& options) {
    if (options.until && *options.until < options.from) {
        throw Error(ErrorCode::invalid_value, "--until", fmt::format("{}", *options.until),
                    fmt::format("must not be before --from, {}", options.from));
    }
    const bool is_windowed = options.every != 1 || options.from > 0.0 || options.until;
    if (is_windowed && options.csv.empty() && options.animate.empty() && options.video.empty()) {
        throw Error(ErrorCode::invalid_value, "--every, --from and --until", {},
                    "are for --csv, --animate and --video, and there is none");
    }
}

// Rejects ranges that would leave files empty.
void check_moments(const RunOptions& options, float time_step, std::uint64_t steps) {
    const double step = static_cast<double>(time_step), end = static_cast<double>(steps) * step;
    if (options.from > end + 1e-3 * step) {
        throw Error(ErrorCode::invalid_value, "--from", fmt::format("{}", options.from),
                    fmt::format("must not be after the end of the run, {:.6g} s", end));
    }
    const double every = static_cast<double>(options.every); // a video has all moments in the range, so at least these
    const double first = every * std::ceil((options.from / step - 1e-3) / every);
    if (first > static_cast<double>(steps) || !is_in_window(options, first * step, step)) {
        throw Error(ErrorCode::invalid_value, "--every, --from and --until", {}, "select no step");
    }
}

// Rejects a run that ends before the step of its checkpoint.
void require_steps_left(const RunOptions& options, std::uint64_t steps, std::uint64_t first) {
    if (first <= steps) return;
    throw Error(ErrorCode::invalid_value, options.frames ? "--frames" : "--seconds", fmt::format("{} steps", steps),
                fmt::format("must be at least {} steps, those that the checkpoint in {} has completed", first,
                            options.resume.generic_string()));
}

void apply_options(const RunOptions& options, scene::Scene& scene, int ranks) {
    if (options.time_step) scene.info.time_step = static_cast<float>(*options.time_step);
    WorldDef settings = scene.world.settings();
    if (options.substeps) settings.substeps = *options.substeps;
    if (options.integrator) settings.integrator = *options.integrator;
    if (options.substeps || options.integrator) scene.world.set_settings(settings);
    scene.world.set_threads(options.threads.value_or(ranks > 1 ? 1 : hardware_threads()));
}

// Simulates from the first or resumed step to the end, or until interrupted.
Outcome simulate(const RunOptions& options, scene::Scene& scene, std::optional<JointTargets>& targets,
                 std::uint64_t steps, const InterruptGuard& interrupt, const Ranks& ranks) {
    set_activity("preparing the output files", options.scene);
    Checkpoints checkpoints(options, ranks, scene);
    const std::uint64_t first = checkpoints.first_step();
    require_steps_left(options, steps, first);
    const checkpoint::Moment* const resumed = checkpoints.last() ? &checkpoints.last()->moment : nullptr;
    Recorders recorders(options, scene, resumed);
    checkpoints.restore(scene.world, targets);
    const SharedRun shared(ranks, scene.world);
    set_activity("simulating", options.scene);
    const float time_step = scene.info.time_step;
    Outcome outcome;
    outcome.first_step = first;
    if (resumed) outcome.resumed_from = checkpoints.last()->place.generic_string();
    if (resumed) outcome.max_penetration = resumed->max_penetration;
    const auto write_checkpoint = [&] {
        checkpoints.write(scene.world, targets,
                          {.max_penetration = outcome.max_penetration, .table = recorders.table_progress()});
    };
    {
        ProgressLine progress(steps, "steps", static_cast<double>(time_step));
        recorders.add(scene.world, first, time_step);
        for (std::uint64_t i = first; i < steps; ++i) {
            shared.compare_now_and_then(scene.world, i);
            const SharedRun::Requests now = shared.agree({interrupt.requested(), checkpoints.is_due(i)});
            outcome.interrupted = now.end;
            if (now.end) break;
            if (now.checkpoint) write_checkpoint();
            set_activity_count(i, steps);
            if (targets) targets->apply(scene.world, time_step);
            const auto start = std::chrono::steady_clock::now();
            scene.world.step(time_step);
            const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
            outcome.clock.add(elapsed.count());
            const Statistics statistics = scene.world.statistics();
            outcome.max_penetration = std::max(outcome.max_penetration, statistics.max_penetration);
            add(outcome.stages, statistics.times);
            recorders.add(scene.world, i + 1, time_step);
            if (shared.is_first()) progress.show(i + 1);
        }
        shared.compare(scene.world);
        if (checkpoints.is_written()) write_checkpoint(); // the final state, to resume from
        outcome.checkpoints = checkpoints.count();
        outcome.ranks = shared.reports();
    }
    recorders.finish(scene);
    return outcome;
}

nlohmann::ordered_json vector_json(const glm::dvec3& v) { return nlohmann::ordered_json::array({v.x, v.y, v.z}); }

std::string json_summary(const std::string& path, const scene::Scene& scene, const Outcome& outcome) {
    const World& world = scene.world;
    const StepTimes times = outcome.clock.times();
    const Statistics statistics = world.statistics();
    nlohmann::ordered_json json;
    json["scene"] = path;
    json["title"] = scene.info.title;
    json["bodies"] = statistics.bodies;
    json["steps"] = outcome.steps();
    if (!outcome.resumed_from.empty())
        json["resumed_from"] = {{"step", outcome.first_step}, {"checkpoint", outcome.resumed_from}};
    json["time_step"] = static_cast<double>(scene.info.time_step);
    json["threads"] = world.threads();
    for (const RankReport& rank : outcome.ranks) {
        json["ranks"].push_back({{"memory_mb", 1e-6 * rank.memory},
                                 {"peak_memory_mb", 1e-6 * rank.peak_memory},
                                 {"seconds_in_messages", rank.waited},
                                 {"processor_seconds_else", rank.computed},
                                 {"messages", rank.messages},
                                 {"bytes", rank.bytes}});
    }
    json["isa"] = std::string(instruction_set());
    json["ms_per_step"] = {{"mean", times.mean}, {"median", times.median}, {"p99", times.p99}};
    const StageTimes& stages = outcome.stages;
    const double steps = static_cast<double>(std::max<std::uint64_t>(outcome.clock.steps(), 1));
    json["ms_of_stages"] = {{"broad_phase", stages.broad_phase / steps},
                            {"narrow_phase", stages.narrow_phase / steps},
                            {"islands", stages.islands / steps},
                            {"prepare", stages.prepare / steps},
                            {"solve", stages.solve / steps},
                            {"finalize", stages.finalize / steps}};
    json["hash"] = fmt::format("{:016x}", world.state_hash());
    json["energy"] = {{"kinetic", world.kinetic_energy()}, {"potential", world.potential_energy()}};
    json["momentum"] = {{"linear", vector_json(world.linear_momentum())},
                        {"angular", vector_json(world.angular_momentum())}};
    json["max_penetration"] = outcome.max_penetration;
    json["contacts"] = statistics.contacts;
    json["contact_points"] = statistics.contact_points;
    if (const CheckpointCount& count = outcome.checkpoints; count.written > 0) {
        json["checkpoints"] = {{"written", count.written},
                               {"last_step", count.last_step},
                               {"megabytes", 1e-6 * count.bytes},
                               {"seconds", count.seconds},
                               {"processor_seconds_saving", count.saving_seconds},
                               {"processor_seconds_own_part", count.own_part_seconds}};
    }
    json["interrupted"] = outcome.interrupted;
    json["warnings"] = scene.warnings;
    // File names may contain invalid UTF-8, which is replaced.
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string text_summary(const std::string& path, const scene::Scene& scene, const Outcome& outcome,
                         const RunOptions& options) {
    const World& world = scene.world;
    const StepTimes times = outcome.clock.times();
    const Statistics statistics = world.statistics();
    std::string text = fmt::format("{} ({}): {} bodies, {} awake\n", path, scene.info.title, statistics.bodies,
                                   statistics.awake_bodies);
    text +=
        fmt::format("{} steps of {:.6g} s{} on {} ({}){}: {:.3f} ms a step (median {:.3f}, 99 % within {:.3f})\n",
                    outcome.steps(), scene.info.time_step,
                    outcome.resumed_from.empty()
                        ? ""
                        : fmt::format(", the last {} of them from {}", outcome.clock.steps(), outcome.resumed_from),
                    world.threads() == 1 ? "1 thread" : fmt::format("{} threads", world.threads()), instruction_set(),
                    outcome.interrupted ? ", interrupted" : "", times.mean, times.median, times.p99);
    text += describe(outcome.ranks, outcome.clock.steps());
    text += describe(outcome.checkpoints, options);
    text += fmt::format("{} contacts, {} points, deepest overlap during the run {:.3g} mm\n", statistics.contacts,
                        statistics.contact_points, 1000.0 * outcome.max_penetration);
    text += fmt::format("kinetic energy {:.6g} J, potential {:.6g} J, state {:016x}\n", world.kinetic_energy(),
                        world.potential_energy(), world.state_hash());
    return text;
}

// Warns of speeds clamped during the run; clamping of the scene file's own velocities is reported when it is loaded.
void warn_of_speeds(scene::Scene& scene, std::uint64_t count) {
    if (count == 0) return;
    const WorldDef& settings = scene.world.settings();
    scene.warnings.push_back(fmt::format("speeds were cut to the world's limits of {} m/s and {} rad/s, {} in all",
                                         settings.max_linear_speed, settings.max_angular_speed,
                                         count == 1 ? "once" : fmt::format("{} times", count)));
    complain("warning: " + scene.warnings.back());
}

} // namespace

scene::Scene ReadOptions::load(const std::filesystem::path& path, std::shared_ptr<CommandListener> listener) const {
    set_activity("reading", path.generic_string());
    if (scene::is_mesh_file(path)) {
        throw Error(ErrorCode::unsupported, path.generic_string(), {},
                    "is a mesh, not a scene; `cairn convert` makes a body of it");
    }
    scene::Scene scene =
        scene::load(path, {.fixed_base = fixed_base, .decompose = decompose, .listener = std::move(listener)});
    if (floor) scene::add_floor(scene);
    return scene;
}

namespace {

// Options of a rank that writes nothing, because rank 0 does.
RunOptions without_outputs(RunOptions options) {
    options.csv.clear(), options.png.clear(), options.video.clear(), options.save.clear(), options.animate.clear();
    return options;
}

int run_on(const RunOptions& given, const Ranks& ranks) {
    const bool is_first = ranks.rank() == 0;
    const RunOptions options = is_first ? given : without_outputs(given);
    check_outputs(std::vector<Output>{{"--csv", options.csv},
                                      {"--png", options.png},
                                      {"--video", options.video},
                                      {"--save", options.save},
                                      {"--animate", options.animate}});
    check_size(given);
    check_window(given);
    const std::filesystem::path path = scene::find_scene(options.scene);
    scene::Scene scene = options.read.load(path);
    if (is_first) print_warnings(scene.warnings);
    apply_options(options, scene, ranks.size());
    const std::uint64_t steps = count_steps(options, scene.info.time_step);
    check_moments(options, scene.info.time_step, steps);
    const InterruptGuard interrupt; // until all files are written: a second signal must not lose them
    std::optional<JointTargets> targets;
    if (!options.targets.empty()) targets.emplace(options.targets, scene, options.servo_frequency);
    const std::uint64_t cut_before = scene.world.statistics().clamped_speeds;
    const Outcome outcome = simulate(options, scene, targets, steps, interrupt, ranks);
    if (!is_first) return 0;
    warn_of_speeds(scene, scene.world.statistics().clamped_speeds - cut_before);
    const std::string name = path.generic_string();
    print(options.json ? json_summary(name, scene, outcome) : text_summary(name, scene, outcome, options));
    return 0;
}

} // namespace

int run_command(const RunOptions& options) {
    Ranks ranks("start it without mpirun");
    return ranks.run([&] { return run_on(options, ranks); });
}

} // namespace cairn::cli
