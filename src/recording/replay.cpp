// Replaying a recording on a world of its own.
#include "recording/contents.h"
#include "recording/log_format.h"
#include "recording/recording.h"

#include <cairn/error.h>

#include <algorithm>
#include <utility>

namespace cairn::recording {

std::string Divergence::text() const {
    const std::string start = "step " + std::to_string(step) + ": ";
    return start + (bodies.empty() ? std::string("more than two bodies differ, or a body is missing")
                                   : names + (bodies.size() == 1 ? " differs" : " differ"));
}

struct Replay::State {
    State(const Recording::Contents& recorded, int threads)
        : contents(recorded), cursor(recorded), parts(recorded), thread_count(threads) {
        world.set_threads(threads);
    }

    const Recording::Contents& contents;
    LogCursor cursor;
    Parts parts;
    int thread_count;
    World world;
    std::uint64_t steps = 0;
    std::optional<Divergence> divergence;
    bool is_branched = false, can_use_keyframes = true;
    std::uint64_t refused = 0;
    std::string first_refusal;

    void execute(std::span<const std::byte> command);
    void compare(const StateDigest& recorded);
    void forget();
    void restart();
    bool go_to_keyframe(const Recording::Contents::Keyframe& keyframe);
};

void Replay::State::execute(std::span<const std::byte> command) {
    try {
        world.execute(command, parts);
    } catch (const Error& error) {
        const std::string where =
            contents.where("step " + std::to_string(steps + 1) + ": " + std::string(command_name(command)));
        const bool is_of_branch = error.code() == ErrorCode::invalid_handle || error.code() == ErrorCode::wrong_state;
        if (!is_branched || !is_of_branch) throw Error(error.code(), where, "", error.what());
        if (refused++ == 0) first_refusal = where + ": " + error.what();
    }
}

void Replay::State::compare(const StateDigest& recorded) {
    if (is_branched || divergence || world.state_digest() == recorded) return;
    divergence.emplace();
    divergence->step = steps;
    divergence->bodies = world.bodies_that_differ(recorded);
    for (const BodyId id : divergence->bodies) {
        if (!divergence->names.empty()) divergence->names += " and ";
        divergence->names += "body " + std::to_string(id.index());
        if (const std::string& name = std::as_const(world).body(id).name(); !name.empty())
            divergence->names += " \"" + name + "\"";
    }
}

void Replay::State::forget() {
    divergence.reset();
    is_branched = false;
    refused = 0;
    first_refusal.clear();
}

void Replay::State::restart() {
    world = World();
    world.set_threads(thread_count);
    cursor.move_to({});
    steps = 0;
    forget();
}

// Restores a keyframe. Returns false if this build cannot use it.
bool Replay::State::go_to_keyframe(const Recording::Contents::Keyframe& keyframe) {
    try {
        world.restore(parts.state_of(keyframe));
    } catch (const Error& error) {
        if (error.code() != ErrorCode::unsupported) throw;
        return can_use_keyframes = false;
    }
    cursor.move_to(keyframe.next);
    steps = keyframe.step;
    forget();
    return true;
}

Replay::Replay(const Recording& recording, int threads)
    : state_(std::make_unique<State>(*recording.contents_, threads)) {}
Replay::~Replay() = default;
Replay::Replay(Replay&&) noexcept = default;

bool Replay::step() {
    State& s = *state_;
    for (;;) {
        const LogEntry& entry = s.cursor.peek();
        if (entry.kind == LogEntry::Kind::end) return false;
        if (entry.kind == LogEntry::Kind::digest) { // a digest of the step before a keyframe
            s.cursor.take();
            continue;
        }
        const bool is_last = is_step(entry.command);
        s.execute(entry.command);
        s.cursor.take();
        if (!is_last) continue;
        ++s.steps;
        if (s.cursor.peek().kind == LogEntry::Kind::digest) {
            s.compare(s.cursor.peek().digest);
            s.cursor.take();
        }
        return true;
    }
}

void Replay::seek(std::uint64_t step) {
    State& s = *state_;
    const std::uint64_t most = s.contents.info.steps;
    if (step > most)
        throw Error(ErrorCode::invalid_value, "Replay::seek step", std::to_string(step),
                    "must be at most " + std::to_string(most) + ", the steps of " + s.contents.file.name());
    const auto& all = s.contents.keyframes;
    auto next = std::upper_bound(all.begin(), all.end(), step,
                                 [](std::uint64_t value, const auto& keyframe) { return value < keyframe.step; });
    const bool has_keyframe = s.can_use_keyframes && next != all.begin();
    const bool is_ahead = !s.is_branched && s.steps <= step;
    if (!(is_ahead && (!has_keyframe || std::prev(next)->step <= s.steps)))
        if (!has_keyframe || !s.go_to_keyframe(*std::prev(next)))
            if (!is_ahead) s.restart();
    while (s.steps < step && this->step()) {}
}

std::uint64_t Replay::steps() const { return state_->steps; }
const std::optional<Divergence>& Replay::divergence() const { return state_->divergence; }
World& Replay::world() { return state_->world; }
const World& Replay::world() const { return state_->world; }
void Replay::branch() { state_->is_branched = true; }
std::uint64_t Replay::refused_calls() const { return state_->refused; }
const std::string& Replay::first_refusal() const { return state_->first_refusal; }

} // namespace cairn::recording
