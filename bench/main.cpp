// `cairn_bench`: measures the speed and quality of Cairn and other engines on the same scenes, or writes the scenes to
// files. Invalid arguments end it with one line on stderr and exit code 2, an error at run time with one line and exit
// code 1.
#include "bench/consistency.h"
#include "bench/measure.h"
#include "bench/queries.h"
#include "bench/report.h"
#include "bench/rollback.h"
#include "bench/save.h"

#include <cairn/error.h>
#include <cairn/world.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <numeric>
#include <optional>

namespace {

using cairn::bench::EngineKind;
using cairn::bench::SceneKind;

std::vector<EngineKind> engine_kinds() {
    std::vector<EngineKind> kinds = {cairn::bench::cairn_engine()};
#ifdef CAIRN_BENCH_BULLET
    kinds.push_back(cairn::bench::bullet_engine());
#endif
#ifdef CAIRN_BENCH_ODE
    kinds.push_back(cairn::bench::ode_engine());
#endif
    return kinds;
}

std::vector<std::string> missing_peers() {
    std::vector<std::string> names;
#ifndef CAIRN_BENCH_BULLET
    names.emplace_back("Bullet");
#endif
#ifndef CAIRN_BENCH_ODE
    names.emplace_back("ODE");
#endif
    return names;
}

struct Options {
    cairn::bench::MeasureOptions measure;
    std::vector<std::string> engines;
    std::optional<std::string> folder; // folder in which scenes are saved, instead of being measured
    bool json = false, list = false, consistency = false, rollback = false, queries = false;
};

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const SceneKind& kind : cairn::bench::scene_kinds()) names.emplace_back(kind.name);
    return names;
}

std::vector<std::string> engine_names() {
    std::vector<std::string> names;
    for (const EngineKind& kind : engine_kinds()) names.emplace_back(kind.name);
    return names;
}

void add_options(CLI::App& app, Options& options) {
    auto& measure = options.measure;
    measure.scenes = scene_names();
    options.engines = engine_names();
    app.add_option("--scenes", measure.scenes, "Scenes, separated by commas (default: all; see --list)")
        ->delimiter(',')
        ->check(CLI::IsMember(scene_names()));
    app.add_option("--engines", options.engines, "Engines, separated by commas (default: all)")
        ->delimiter(',')
        ->check(CLI::IsMember(engine_names()));
    app.add_option("--rounds", measure.rounds, "Times that each engine runs, by turns (default 3)")
        ->check(CLI::Range(1, 1000));
    app.add_option("--steps", measure.steps, "Steps of a round (default: the scene's)")->check(CLI::Range(1, 10000000));
    app.add_option("--n", measure.size, "Size of the scenes; what it counts depends on the scene (see --list)")
        ->check(CLI::Range(1, 10000000));
    app.add_option("--substeps", measure.settings.substeps, "Substeps of a step, in every engine (default: its own)")
        ->check(CLI::Range(1, 256));
    measure.threads = {1};
    if (cairn::hardware_threads() > 1) measure.threads.push_back(cairn::hardware_threads());
    app.add_option("--threads", measure.threads, "Numbers of threads, separated by commas (default: 1 and all)")
        ->delimiter(',')
        ->check(CLI::Range(1, 256));
    app.add_option("--save", options.folder,
                   "Measure nothing: write the scenes to this folder, as NAME.gltf that `cairn view` opens");
    app.add_flag("--consistency", options.consistency,
                 "Measure how the answers depend on the time step instead (Erez et al. 2015); takes minutes");
    app.add_flag("--rollback", options.rollback,
                 "Measure instead what it costs to go 8 frames back, 1,000 times, with 500 bodies (uses --threads)");
    app.add_flag("--queries", options.queries,
                 "Measure instead how many queries a second a pile of 5,000 bodies at rest answers, on one thread");
    app.add_flag("--json", options.json, "Print one JSON object instead of tables");
    app.add_flag("--list", options.list, "List the scenes and engines, and measure nothing");
}

std::string listing() {
    std::string text = "Scenes\n";
    for (const SceneKind& kind : cairn::bench::scene_kinds())
        text += fmt::format("  {:<14} {}; --n: {} (default {})\n", kind.name, kind.description, kind.size_meaning,
                            kind.default_size);
    text += "Engines\n";
    for (const EngineKind& kind : engine_kinds()) text += fmt::format("  {:<14} {}\n", kind.name, kind.version);
    for (const std::string& peer : missing_peers())
        text += fmt::format("  (built without {}, which was not found)\n", peer);
    return text;
}

int complain(std::string text, int code) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    fmt::print(stderr, "cairn_bench: {}\n", text);
    return code;
}

void show_progress(const std::string& line) { fmt::print(stderr, "{}\n", line); }

std::string times(const Options& options) {
    const auto results = cairn::bench::measure(options.measure, show_progress);
    return options.json ? cairn::bench::to_json(results) : cairn::bench::to_tables(results);
}

std::string consistency(const Options& options) {
    const auto points = cairn::bench::measure_consistency({options.measure.engines}, show_progress);
    return options.json ? consistency_json(points) : consistency_tables(points);
}

// Returns exit code 1 if a world after a rollback differs from one without.
int measure_rollbacks(const std::vector<int>& thread_counts) {
    std::size_t wrong = 0;
    for (const int threads : thread_counts) {
        cairn::bench::RollbackOptions options;
        options.threads = threads;
        auto result = cairn::bench::measure_rollback(options);
        std::vector<double>& ms = result.milliseconds;
        const double sum = std::accumulate(ms.begin(), ms.end(), 0.0);
        const auto late = std::count_if(ms.begin(), ms.end(), [](double x) { return x > 1000.0 / 60; });
        std::sort(ms.begin(), ms.end());
        fmt::print("{} rollbacks of {} frames, {} bodies ({} to {} awake), {} contacts, {} joints, {} thread(s)\n",
                   ms.size(), options.frames, result.bodies, result.min_awake, result.max_awake, result.contacts,
                   result.joints, threads);
        fmt::print("  ms: mean {:.2f}, median {:.2f}, 99 % below {:.2f}, worst {:.2f}; {} above 16.67\n",
                   sum / double(ms.size()), ms[ms.size() / 2], ms[ms.size() * 99 / 100], ms.back(), late);
        fmt::print("  ms: restore {:.3f}, each of {} steps {:.3f}, save {:.3f}; of the processor in all {:.2f}\n",
                   result.restore, options.frames, result.step, result.save, result.processor);
        const double n = double(result.bodies);
        const cairn::SnapshotSizes& sizes = result.sizes;
        fmt::print("  snapshot: {} bytes; per body {:.0f} for its state, {:.0f} contacts, {:.0f} joints, {:.0f} broad "
                   "phase; {:.0f} shared definitions\n",
                   result.bytes, double(sizes.bodies) / n, double(sizes.contacts) / n, double(sizes.joints) / n,
                   double(sizes.broad_phase) / n, double(sizes.definitions) / n);
        fmt::print("  states other than those of a world that never went back: {}\n", result.wrong);
        wrong += result.wrong;
    }
    return wrong == 0 ? 0 : 1;
}

int measure_queries() {
    const auto rates = cairn::bench::measure_queries({});
    for (const cairn::bench::QueryRate& rate : rates)
        fmt::print("{:<15} {:>9.0f} a second, {:.2f} of the rays; {:.0f} % met something\n", rate.kind, rate.per_second,
                   rate.per_second / rates[0].per_second, 100 * rate.met);
    return 0;
}

int run(Options& options) {
    if (options.queries) return measure_queries();
    if (options.rollback) return measure_rollbacks(options.measure.threads);
    if (options.list) {
        fmt::print("{}", listing());
        return 0;
    }
    // All sizes are checked before the first measurement.
    for (const std::string& scene : options.measure.scenes) cairn::bench::check_size(scene, options.measure.size);
    if (options.folder) {
        for (const std::string& name : options.measure.scenes)
            fmt::print("{}\n",
                       save_scene(cairn::bench::make_scene(name, options.measure.size), *options.folder).string());
        return 0;
    }
    for (const std::string& name : options.engines)
        for (const EngineKind& kind : engine_kinds())
            if (kind.name == name) options.measure.engines.push_back(kind);
    for (const std::string& peer : missing_peers()) fmt::print(stderr, "built without {}, which was not found\n", peer);
    const std::string text = options.consistency ? consistency(options) : times(options);
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!written || std::fflush(stdout) != 0) return complain("stdout cannot be written", 1);
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app("Times physics engines on the same scenes, nothing asleep.", "cairn_bench");
    Options options;
    add_options(app, options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error); // --help
        return complain(error.what(), 2);
    }
    try {
        return run(options);
    } catch (const cairn::bench::SceneError& error) {
        return complain(error.what(), 2);
    } catch (const std::exception& error) {
        return complain(error.what(), 1);
    }
}
