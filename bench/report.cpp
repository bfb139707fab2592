#include "bench/report.h"

#include <cairn/version.h>
#include <cairn/world.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>

namespace cairn::bench {

namespace {

template <class T> nlohmann::json or_null(const std::optional<T>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json();
}

nlohmann::json to_object(const Result& r) {
    nlohmann::json stages = nlohmann::json::object();
    for (const auto& [name, ms] : r.stage_ms) stages[name] = ms;
    return {
        {"scene", r.scene},
        {"engine", r.engine},
        {"engine_version", r.engine_version},
        {"threads", r.threads},
        {"bodies", r.bodies},
        {"steps", r.steps},
        {"rounds", r.rounds},
        {"substeps", or_null(r.substeps)},
        {"mean_ms", r.mean_ms},
        {"median_ms", r.median_ms},
        {"p99_ms", r.p99_ms},
        {"max_ms", r.greatest_ms},
        {"cpu_ms", r.cpu_ms},
        {"mean_ms_min", r.min_mean_ms},
        {"mean_ms_greatest", r.greatest_mean_ms},
        {"build_ms", r.build_ms},
        {"contacts", r.contacts},
        {"points", r.points},
        {"candidates", or_null(r.candidates)},
        {"ns_per_point", or_null(r.nanoseconds_per_point)},
        {"penetration_max", r.penetrations.greatest},
        {"penetration_p99", r.penetrations.p99},
        {"penetration_mean", r.penetrations.mean},
        {"penetration_peak", r.penetration_peak},
        {"overlaps", r.penetrations.overlaps},
        {"joint_error_max", r.joint_errors ? nlohmann::json(r.joint_errors->greatest) : nlohmann::json()},
        {"joint_error_mean", r.joint_errors ? nlohmann::json(r.joint_errors->mean) : nlohmann::json()},
        {"joint_error_peak", r.joint_errors ? nlohmann::json(r.joint_error_peak) : nlohmann::json()},
        {"drift", r.displacement ? nlohmann::json(r.displacement->drift) : nlohmann::json()},
        {"sag", r.displacement ? nlohmann::json(r.displacement->sag) : nlohmann::json()},
        {"kinetic_energy", r.kinetic_energy},
        {"lost", r.lost},
        {"repeatable", r.repeatable},
        {"bytes_per_body", or_null(r.bytes_per_body)},
        {"stages_ms", std::move(stages)},
    };
}

std::string lengths(double meters) { return fmt::format("{:.2f}", 1000 * meters); } // mm

} // namespace

std::string to_tables(const std::vector<Result>& results) {
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(
        out,
        "Time, ms per step (medians over rounds; cpu: mean CPU time; spread: least and greatest mean of a round)\n");
    fmt::format_to(out, "{:<14} {:<7} {:>2} {:>6} {:>8} {:>8} {:>8} {:>8} {:>17} {:>8} {:>8} {:>8} {:>4} {:>7}\n",
                   "scene", "engine", "T", "bodies", "cpu", "mean", "median", "p99", "spread", "contacts", "points",
                   "ns/point", "sub", "B/body");
    for (const Result& r : results)
        fmt::format_to(out,
                       "{:<14} {:<7} {:>2} {:>6} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.0f} "
                       "{:>8.0f} {:>8} {:>4} "
                       "{:>7}\n",
                       r.scene, r.engine, r.threads, r.bodies, r.cpu_ms, r.mean_ms, r.median_ms, r.p99_ms,
                       r.min_mean_ms, r.greatest_mean_ms, r.contacts, r.points,
                       r.nanoseconds_per_point ? fmt::format("{:.1f}", *r.nanoseconds_per_point) : "-",
                       r.substeps ? fmt::format("{}", *r.substeps) : "-",
                       r.bytes_per_body ? fmt::format("{:.0f}", *r.bytes_per_body) : "-");

    fmt::format_to(
        out, "\nQuality at the end (lengths in mm; overlap peak: deepest at each quarter of the run; gap: between "
             "the anchors of a joint; gap peak: widest at every tenth step)\n");
    fmt::format_to(out, "{:<14} {:<7} {:>2} {:>9} {:>9} {:>9} {:>9} {:>9} {:>10} {:>10} {:>12} {:>5} {:>6}\n", "scene",
                   "engine", "T", "overlap", "99 %", "peak", "gap mean", "gap peak", "drift", "sag", "energy, J",
                   "lost", "repeat");
    for (const Result& r : results)
        fmt::format_to(
            out, "{:<14} {:<7} {:>2} {:>9} {:>9} {:>9} {:>9} {:>9} {:>10} {:>10} {:>12.5g} {:>5} {:>6}\n", r.scene,
            r.engine, r.threads, lengths(r.penetrations.greatest), lengths(r.penetrations.p99),
            lengths(r.penetration_peak), r.joint_errors ? lengths(r.joint_errors->mean) : "-",
            r.joint_errors ? lengths(r.joint_error_peak) : "-", r.displacement ? lengths(r.displacement->drift) : "-",
            r.displacement ? lengths(r.displacement->sag) : "-", r.kinetic_energy, r.lost, r.repeatable ? "yes" : "no");

    bool has_title = false;
    for (const Result& r : results) {
        if (r.stage_ms.empty()) continue;
        if (!has_title) fmt::format_to(out, "\nStages, ms per step (share of their sum)\n");
        has_title = true;
        double sum = 0;
        for (const auto& stage : r.stage_ms) sum += stage.second;
        fmt::format_to(out, "{:<14} {:<7} {:>2}", r.scene, r.engine, r.threads);
        for (const auto& [name, ms] : r.stage_ms)
            fmt::format_to(out, "  {} {:.3f} ({:.0f} %)", name, ms, sum > 0 ? 100 * ms / sum : 0.0);
        fmt::format_to(out, "\n");
    }
    return text;
}

std::string to_json(const std::vector<Result>& results) {
    nlohmann::json all = nlohmann::json::array();
    for (const Result& r : results) all.push_back(to_object(r));
    // Non-finite numbers become null.
    const nlohmann::json document = {
        {"cairn", version_string}, {"instruction_set", instruction_set()}, {"results", std::move(all)}};
    return document.dump(2) + "\n";
}

} // namespace cairn::bench
