#include "cli/activity.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/outputs.h"
#include "cli/progress.h"
#include "cli/what_if.h"

#include "recording/recording.h"
#include "scene/scene.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace cairn::cli {

namespace {

struct Apart {
    double distance = 0.0; // greatest distance, m
    BodyId body;
};

// The greatest distance of a body from its position in the recorded run.
Apart greatest_distance(const World& world, const World& recorded) {
    Apart apart;
    const std::vector<BodyId> bodies = world.bodies();
    const std::uint32_t number = bodies.empty() ? 0 : bodies[0].world();
    for (const BodyId id : recorded.bodies()) {
        const BodyId here = BodyId::make(id.index(), id.generation(), number);
        if (!world.is_valid(here)) continue;
        const double distance = glm::length(world.body(here).position() - recorded.body(id).position());
        if (distance > apart.distance) apart = {distance, id};
    }
    return apart;
}

std::string body_text(const World& world, BodyId id) {
    const std::string& name = world.body(id).name();
    return fmt::format("body {}{}", id.index(), name.empty() ? "" : " \"" + name + "\"");
}

struct Verdict {
    std::optional<recording::Divergence> divergence;
    std::string refusal; // error of a command that could not be executed
    double seconds = 0.0;
    bool interrupted = false;
};

// Replays up to `end` steps.
Verdict replay_to(recording::Replay& replay, std::uint64_t end, bool until_differs, const InterruptGuard& interrupt) {
    Verdict verdict;
    const auto start = std::chrono::steady_clock::now();
    ProgressLine progress(end, "steps");
    try {
        while (replay.steps() < end && replay.step()) {
            set_activity_count(replay.steps(), end);
            progress.show(replay.steps());
            if (until_differs && replay.divergence()) break;
            if ((verdict.interrupted = interrupt.requested())) break;
        }
    } catch (const Error& error) {
        if (error.code() == ErrorCode::io) throw;
        verdict.refusal = error.what();
    }
    verdict.divergence = replay.divergence();
    verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return verdict;
}

std::string state_text(const World& world) {
    const Statistics statistics = world.statistics();
    return fmt::format("{} bodies, {} awake, {} contacts, kinetic energy {:.6g} J, potential {:.6g} J, state {:016x}\n",
                       statistics.bodies, statistics.awake_bodies, statistics.contacts, world.kinetic_energy(),
                       world.potential_energy(), world.state_hash());
}

std::string verdict_text(const std::string& name, const recording::Replay& replay, const Verdict& verdict,
                         std::uint64_t steps) {
    if (!verdict.refusal.empty()) return fmt::format("DIFFERS: {}\n", verdict.refusal);
    if (verdict.divergence) return fmt::format("DIFFERS: {}: {}\n", name, verdict.divergence->text());
    return fmt::format("{}: {} of {} steps the same{}, {}, {:.3f} s\n", name, replay.steps(), steps,
                       verdict.interrupted ? ", interrupted" : "",
                       replay.world().threads() == 1 ? "1 thread" : fmt::format("{} threads", replay.world().threads()),
                       verdict.seconds);
}

void print_json(const std::string& name, const recording::Replay& replay, const Verdict& verdict) {
    const World& world = replay.world();
    nlohmann::ordered_json json{{"recording", name},
                                {"steps", replay.steps()},
                                {"threads", world.threads()},
                                {"seconds", verdict.seconds},
                                {"same", !verdict.divergence && verdict.refusal.empty()},
                                {"interrupted", verdict.interrupted}};
    if (verdict.divergence) {
        json["step"] = verdict.divergence->step;
        json["differs"] = verdict.divergence->text();
    }
    if (!verdict.refusal.empty()) json["differs"] = verdict.refusal;
    json["hash"] = fmt::format("{:016x}", world.state_hash());
    json["energy"] = {{"kinetic", world.kinetic_energy()}, {"potential", world.potential_energy()}};
    print(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

// Saves the present world, without data that only the scene file had: colors, the camera.
void save_world(World&& world, const std::string& title, float time_step, const std::filesystem::path& path) {
    set_activity("writing", path.generic_string());
    scene::Scene scene{std::move(world), {}, {}, {}, {}};
    scene.info.title = title;
    scene.info.time_step = time_step;
    scene::save(scene, path);
}

// Continues two replays from the same step, one of them as recorded, and prints how they differ.
void compare_branch(recording::Replay& branch, recording::Replay& recorded, std::uint64_t end,
                    const InterruptGuard& interrupt) {
    ProgressLine progress(end, "steps");
    while (branch.steps() < end && !interrupt.requested()) {
        set_activity_count(branch.steps(), end);
        if (!branch.step() || !recorded.step()) break;
        progress.show(branch.steps());
    }
    const World &world = std::as_const(branch).world(), &before = std::as_const(recorded).world();
    print("recorded: " + state_text(before));
    print("what if:  " + state_text(world));
    const Apart apart = greatest_distance(world, before);
    if (apart.distance > 0)
        print(fmt::format("greatest distance after {} steps: {}, {:.6g} m\n", branch.steps(),
                          body_text(before, apart.body), apart.distance));
    else
        print("all bodies are at the same positions\n");
    if (branch.refused_calls() > 0)
        complain(fmt::format("warning: {} recorded calls could not be made, the first: {}", branch.refused_calls(),
                             branch.first_refusal()));
}

} // namespace

int replay_command(const ReplayOptions& options) {
    check_outputs(std::vector<Output>{{"--save", options.save}});
    const std::vector<WhatIf> changes = parse_what_if(options.what_if);
    if (!changes.empty() && options.verify)
        throw Error(ErrorCode::invalid_value, "--what-if", {}, "cannot be verified: it was not recorded");
    const std::string name = options.recording.generic_string();
    set_activity("reading", name);
    const recording::Recording recording(options.recording);
    const recording::RecordingInfo& info = recording.info();
    if (info.is_cut_off)
        complain(fmt::format("warning: {} was cut off; its first {} steps are complete", name, info.steps));
    if (options.at && *options.at > info.seconds + 1e-3)
        throw Error(ErrorCode::invalid_value, "--at", fmt::format("{}", *options.at),
                    fmt::format("must be within the {:.6g} s of {}", info.seconds, name));
    const int threads = options.threads.value_or(hardware_threads());
    const InterruptGuard interrupt;
    recording::Replay replay(recording, threads);
    set_activity("replaying", name);
    const std::uint64_t moment = options.at ? recording.steps_until(*options.at) : changes.empty() ? info.steps : 0;
    Verdict verdict;
    if (options.at && !options.verify) {
        replay.seek(moment);
        verdict.divergence = replay.divergence();
    } else {
        verdict = replay_to(replay, moment, options.verify, interrupt);
    }
    const bool differs = verdict.divergence || !verdict.refusal.empty();
    if (!changes.empty() && !differs) {
        recording::Replay recorded(recording, threads);
        recorded.seek(moment);
        replay.branch();
        for (const WhatIf& change : changes) change.apply(replay.world());
        compare_branch(replay, recorded, info.steps, interrupt);
    } else if (options.json) {
        print_json(name, replay, verdict);
    } else {
        if (options.at && !options.verify && !differs)
            print(fmt::format("{}: after {} of {} steps\n", name, replay.steps(), info.steps));
        else
            print(verdict_text(name, replay, verdict, info.steps));
        print(state_text(std::as_const(replay).world()));
    }
    const double mean = info.steps > 0 ? info.seconds / static_cast<double>(info.steps) : 1.0 / 60;
    if (!options.save.empty())
        save_world(std::move(replay.world()), info.source, static_cast<float>(std::clamp(mean, 1e-4, 1.0)),
                   options.save);
    return differs ? 1 : 0;
}

} // namespace cairn::cli
