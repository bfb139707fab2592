#include "cli/activity.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/outputs.h"
#include "cli/progress.h"
#include "cli/ranks.h"
#include "cli/sweep_results.h"

#include "files/output_file.h"
#include "sweep/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <vector>

namespace cairn::cli {

namespace {

std::filesystem::path results_folder(const SweepOptions& options) {
    if (!options.out.empty()) return options.out;
    std::filesystem::path name = options.plan.stem();
    if (name.empty() || name == "." || name == "..") name = "sweep";
    return name += ".results";
}

// Runs and prints a single row, one column per line.
int print_row(const sweep::Plan& plan, const sweep::Start& start, std::uint64_t row) {
    if (row >= plan.design.rows()) {
        throw Error(ErrorCode::invalid_value, "--row", std::to_string(row),
                    fmt::format("must be below {}, the number of rows", plan.design.rows()));
    }
    sweep::Runner runner(plan, start);
    std::vector<double> numbers(plan.numbers());
    const std::atomic<bool> never{false};
    runner.run(row, numbers, never);
    const std::vector<std::string> names = plan.columns();
    std::string text = fmt::format("index = {}\n", row);
    for (std::size_t i = 0; i < numbers.size(); ++i) text += fmt::format("{} = {}\n", names[i + 1], numbers[i]);
    print(text);
    if (runner.failure().empty()) return 0;
    complain(fmt::format("row {}: {}", row, runner.failure()));
    return 1;
}

// Prints a description of the sweep, and the time of a row: that of the second run, because the first one allocates
// memory.
int check_plan(const sweep::Plan& plan, const sweep::Start& start) {
    sweep::Runner runner(plan, start);
    std::vector<double> numbers(plan.numbers());
    const std::atomic<bool> never{false};
    runner.run(0, numbers, never);
    const std::string failure = runner.failure();
    const auto begin = std::chrono::steady_clock::now();
    runner.run(plan.design.rows() - 1, numbers, never);
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - begin;
    std::string names;
    for (const std::string& name : plan.columns()) names += (names.empty() ? "" : ", ") + name;
    print(fmt::format("{}: {} rows of {}; the last took {:.3f} ms\n", plan.file, plan.design.rows(), names,
                      elapsed.count()));
    if (failure.empty() && runner.failure().empty()) return 0;
    complain(failure.empty() ? fmt::format("row {}: {}", plan.design.rows() - 1, runner.failure())
                             : "row 0: " + failure);
    return 1;
}

// The missing chunks of this shard: every N-th chunk, so that all shards take about the same time.
std::vector<std::uint64_t> chunks_to_do(const SweepOptions& options, const sweep::Store& store) {
    std::vector<std::uint64_t> chunks = store.missing();
    if (options.shards == 0) return chunks;
    std::erase_if(chunks, [&](std::uint64_t chunk) { return chunk % options.shards != options.shard - 1; });
    return chunks;
}

void put_together(const SweepOptions& options, const sweep::Plan& plan, const sweep::Start& start,
                  const sweep::Store& store, const std::filesystem::path& folder) {
    set_activity("combining the results", folder.generic_string());
    const sweep::Summary summary = write_rows(plan, store, folder);
    const std::vector<std::string> failures = failure_lines(plan, start, summary);
    files::write_file(folder / "report.html", sweep_report(plan, summary, failures));
    const std::string json = sweep_json(plan, summary, failures);
    files::write_file(folder / "summary.json", json);
    print(options.json ? json : sweep_text(plan, summary, failures, folder));
}

// Runs all missing rows, on all ranks. Returns false if interrupted.
bool run_missing(const SweepOptions& options, const sweep::Plan& plan, const sweep::Start& start, sweep::Store& store,
                 Ranks& ranks) {
    const std::vector<std::uint64_t> chunks = chunks_to_do(options, store);
    ranks.meet(); // before anything is written, so that all ranks see the same missing chunks
    const InterruptGuard interrupt;
    std::uint64_t rows = 0;
    for (const std::uint64_t chunk : chunks) rows += store.chunks().rows_in(chunk);
    if (!chunks.empty()) {
        set_activity("running", plan.file);
        ProgressLine progress(rows, "rows");
        const int threads = options.threads.value_or(ranks.size() > 1 ? 1 : hardware_threads());
        sweep::run_chunks(plan, start, store, chunks, threads, ranks, [&](const sweep::Count& count) {
            const bool is_one = ranks.size() == 1;
            const std::string failed = fmt::format(", {} failed{}", count.failed, is_one ? "" : " here");
            const std::uint64_t begun = std::min(rows, ranks.taken() * store.chunks().size);
            if (ranks.rank() == 0) progress.show(is_one ? count.rows : begun, failed);
            return !interrupt.requested();
        });
    }
    ranks.meet();
    return !interrupt.requested();
}

// Reports the number of rows in the folder. Missing rows are no error for one shard of several.
int tell_missing(const SweepOptions& options, const sweep::Plan& plan, const sweep::Store& store, bool was_whole,
                 const std::filesystem::path& folder) {
    std::uint64_t left = 0;
    for (const std::uint64_t chunk : store.missing()) left += store.chunks().rows_in(chunk);
    const std::string text =
        fmt::format("{} of {} rows are in {}", plan.design.rows() - left, plan.design.rows(), folder.generic_string());
    if (!was_whole || options.shards == 0) {
        complain(fmt::format("interrupted: {}; continue with --resume", text));
        return 1;
    }
    print(fmt::format("part {} of {} is done: {}; the last part combines the results\n", options.shard, options.shards,
                      text));
    return 0;
}

int run_sweep(const SweepOptions& options, Ranks& ranks) {
    set_activity("reading", options.plan.generic_string());
    const sweep::Plan plan = sweep::read_plan(options.plan);
    set_activity("reading", plan.scene.generic_string());
    const sweep::Start start = sweep::load_start(plan);
    if (ranks.rank() == 0) print_warnings(start.warnings);
    { const sweep::Runner checks(plan, start); }
    if (options.check) return check_plan(plan, start);
    if (options.row) return print_row(plan, start, *options.row);

    const std::filesystem::path folder = results_folder(options);
    sweep::Store store(folder, plan, start);
    if (!options.resume && options.shards == 0 && !store.is_empty()) {
        throw Error(ErrorCode::wrong_state, folder.generic_string(), {},
                    "has rows of this sweep: continue with --resume, or choose another folder with --out");
    }
    const bool was_whole = run_missing(options, plan, start, store, ranks);
    if (ranks.rank() != 0) return was_whole ? 0 : 1;
    store.look();
    if (!store.missing().empty()) return tell_missing(options, plan, store, was_whole, folder);
    put_together(options, plan, start, store, folder);
    return 0;
}

} // namespace

int sweep_command(const SweepOptions& options) {
    Ranks ranks("use --shard I/N");
    return ranks.run([&] { return run_sweep(options, ranks); });
}

} // namespace cairn::cli
