#include "bench/measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace cairn::bench {

namespace {

constexpr int sample_interval = 10; // steps between counts, which cost time and cache outside the measured step

// Bytes that the program currently holds on the heap.
std::optional<double> heap_bytes() {
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
#else
    return std::nullopt;
#endif
}

class Stopwatch {
  public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Results of one round of one engine.
struct Round {
    double build_ms = 0, cpu_ms = 0, mean_ms = 0, median_ms = 0, p99_ms = 0, greatest_ms = 0;
    double contacts = 0, points = 0;
    std::optional<double> candidates;
    std::optional<int> substeps;
    std::vector<std::pair<std::string, double>> stage_ms;
    std::optional<double> bytes;
    double penetration_peak = 0, joint_error_peak = 0;
    std::vector<BodyState> states; // at the end
};

void add_counts(Round& round, const StepCounts& counts, double weight) {
    round.contacts += weight * static_cast<double>(counts.contacts);
    round.points += weight * static_cast<double>(counts.points);
    if (counts.candidates)
        round.candidates = round.candidates.value_or(0) + weight * static_cast<double>(*counts.candidates);
    if (counts.substeps) round.substeps = std::max(round.substeps.value_or(0), *counts.substeps);
}

void add_stages(Round& round, const std::vector<StageTime>& stages, double weight) {
    if (round.stage_ms.empty())
        for (const StageTime& stage : stages) round.stage_ms.emplace_back(stage.name, 0.0);
    for (std::size_t i = 0; i < stages.size(); ++i) round.stage_ms[i].second += weight * stages[i].milliseconds;
}

void summarize_times(Round& round, std::vector<double> times) {
    for (const double t : times) round.mean_ms += t / static_cast<double>(times.size());
    std::sort(times.begin(), times.end());
    const auto quantile = [&](double q) {
        return times[static_cast<std::size_t>(std::lround(q * static_cast<double>(times.size() - 1)))];
    };
    round.median_ms = quantile(0.5);
    round.p99_ms = quantile(0.99);
    round.greatest_ms = times.back();
}

Round run_round(const Scene& scene, const EngineKind& kind, const EngineSettings& settings) {
    Round round;
    const auto step_count = static_cast<std::size_t>(scene.steps);
    std::vector<double> times(step_count);
    round.states.reserve(scene.bodies.size());
    const std::size_t samples = (step_count + sample_interval - 1) / sample_interval;
    const double weight = 1.0 / static_cast<double>(samples);

    const std::optional<double> heap_before = heap_bytes();
    const Stopwatch build_watch;
    const std::unique_ptr<Engine> engine = kind.make();
    engine->build(scene, settings);
    round.build_ms = build_watch.milliseconds();

    double cpu_ticks = 0;
    for (std::size_t i = 0; i < step_count; ++i) {
        const std::clock_t cpu_start = std::clock();
        const Stopwatch watch;
        engine->step(scene.time_step);
        times[i] = watch.milliseconds();
        cpu_ticks += static_cast<double>(std::clock() - cpu_start);
        if ((step_count - 1 - i) % sample_interval == 0) {
            add_counts(round, engine->counts(), weight);
            add_stages(round, engine->stages(), weight);
            if (!scene.joints.empty()) {
                engine->read(round.states);
                round.joint_error_peak =
                    std::max(round.joint_error_peak, measure_joint_errors(scene, round.states).greatest);
            }
        }
        for (const std::size_t quarter : {1, 2, 3, 4}) {
            if (i + 1 != std::max<std::size_t>(1, step_count * quarter / 4)) continue;
            engine->read(round.states);
            round.penetration_peak =
                std::max(round.penetration_peak, measure_penetrations(scene, round.states).greatest);
        }
    }
    if (const std::optional<double> heap_after = heap_bytes()) round.bytes = *heap_after - heap_before.value_or(0);
    round.cpu_ms = cpu_ticks * (1000.0 / CLOCKS_PER_SEC) / static_cast<double>(step_count);
    summarize_times(round, std::move(times));
    return round;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return n % 2 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

// One engine with a number of threads.
struct Entry {
    EngineKind kind;
    EngineSettings settings;
    std::vector<Round> rounds;
};

Result sum_up(const Scene& scene, const Entry& entry) {
    const std::vector<Round>& rounds = entry.rounds;
    const auto over_rounds = [&](auto&& value) {
        std::vector<double> values;
        for (const Round& round : rounds) values.push_back(value(round));
        return median(std::move(values));
    };
    const Round& last = rounds.back();
    Result r;
    r.scene = scene.name;
    r.engine = entry.kind.name;
    r.engine_version = entry.kind.version;
    r.threads = entry.settings.threads;
    r.steps = scene.steps;
    r.rounds = static_cast<int>(rounds.size());
    r.bodies = scene.dynamic_count;
    r.mean_ms = over_rounds([](const Round& round) { return round.mean_ms; });
    r.median_ms = over_rounds([](const Round& round) { return round.median_ms; });
    r.p99_ms = over_rounds([](const Round& round) { return round.p99_ms; });
    r.greatest_ms = over_rounds([](const Round& round) { return round.greatest_ms; });
    r.cpu_ms = over_rounds([](const Round& round) { return round.cpu_ms; });
    r.build_ms = over_rounds([](const Round& round) { return round.build_ms; });
    const auto by_mean = [](const Round& a, const Round& b) { return a.mean_ms < b.mean_ms; };
    r.min_mean_ms = std::min_element(rounds.begin(), rounds.end(), by_mean)->mean_ms;
    r.greatest_mean_ms = std::max_element(rounds.begin(), rounds.end(), by_mean)->mean_ms;
    r.contacts = last.contacts;
    r.points = last.points;
    r.candidates = last.candidates;
    r.substeps = last.substeps;
    if (r.points > 0) r.nanoseconds_per_point = r.mean_ms * 1e6 / r.points;
    for (std::size_t i = 0; i < last.stage_ms.size(); ++i)
        r.stage_ms.emplace_back(last.stage_ms[i].first,
                                over_rounds([&](const Round& round) { return round.stage_ms[i].second; }));
    if (last.bytes) r.bytes_per_body = *last.bytes / static_cast<double>(scene.bodies.size());
    r.penetrations = measure_penetrations(scene, last.states);
    r.penetration_peak = last.penetration_peak;
    if (!scene.joints.empty()) r.joint_errors = measure_joint_errors(scene, last.states);
    r.joint_error_peak = last.joint_error_peak;
    if (scene.stands) r.displacement = measure_displacement(scene, last.states);
    r.kinetic_energy = measure_kinetic_energy(scene, last.states);
    r.lost = count_lost(scene, last.states);
    for (const Round& round : rounds) r.repeatable = r.repeatable && hash_of(round.states) == hash_of(last.states);
    return r;
}

} // namespace

std::vector<Result> measure(const MeasureOptions& options, const Progress& progress) {
    std::vector<Result> results;
    for (const std::string& name : options.scenes) {
        Scene scene = make_scene(name, options.size);
        if (options.steps > 0) scene.steps = options.steps;
        std::vector<Entry> entries;
        for (const EngineKind& kind : options.engines) {
            if (const std::string why = kind.refusal ? kind.refusal(scene) : ""; !why.empty()) {
                progress(name + ": without " + std::string(kind.name) + ", " + why);
                continue;
            }
            for (const int threads : kind.has_threads ? options.threads : std::vector<int>{1}) {
                entries.push_back({kind, options.settings, {}});
                entries.back().settings.threads = threads;
            }
        }
        for (int round = 0; round < options.rounds; ++round)
            for (Entry& entry : entries) {
                progress(name + ": round " + std::to_string(round + 1) + " of " + std::to_string(options.rounds) +
                         ", " + std::string(entry.kind.name) + ", threads: " + std::to_string(entry.settings.threads));
                entry.rounds.push_back(run_round(scene, entry.kind, entry.settings));
            }
        for (const Entry& entry : entries) results.push_back(sum_up(scene, entry));
    }
    return results;
}

} // namespace cairn::bench
