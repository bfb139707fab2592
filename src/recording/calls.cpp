// Reading the calls of a recording, for worlds that are stepped by the user.
#include "recording/contents.h"
#include "recording/log_format.h"
#include "recording/recording.h"

#include <cairn/error.h>

#include <algorithm>
#include <mutex>

namespace cairn::recording {

namespace {

// A thread-safe source: parts are read on demand, and those returned stay valid.
class SharedParts final : public CommandSource {
  public:
    explicit SharedParts(const Recording::Contents& contents) : parts_(contents) {}
    const Shape& shape(std::uint64_t number) override {
        const std::lock_guard lock(mutex_);
        return parts_.shape(number);
    }
    const Snapshot& snapshot(std::uint64_t number) override {
        const std::lock_guard lock(mutex_);
        return snapshots_.emplace_back(parts_.snapshot(number));
    }

  private:
    std::mutex mutex_;
    Parts parts_;
    std::deque<Snapshot> snapshots_; // those that commands refer to, which are few
};

} // namespace

struct CallReader::State {
    explicit State(const Recording::Contents& recorded)
        : contents(recorded), cursor(recorded), parts(recorded), source(std::make_shared<SharedParts>(recorded)) {}
    const Recording::Contents& contents;
    LogCursor cursor;
    Parts parts; // for keyframes
    std::shared_ptr<CommandSource> source;
};

CallReader::CallReader(const Recording& recording) : state_(std::make_unique<State>(*recording.contents_)) {}
CallReader::~CallReader() = default;

bool CallReader::next(RecordedCall& call) {
    const LogEntry& entry = state_->cursor.peek();
    if (entry.kind == LogEntry::Kind::end) return false;
    call.command.clear();
    call.is_step = false;
    call.digest.reset();
    if (entry.kind == LogEntry::Kind::command) {
        call.command.assign(entry.command.begin(), entry.command.end());
        call.is_step = is_step(entry.command);
        state_->cursor.take();
        if (!call.is_step) return true;
        if (state_->cursor.peek().kind != LogEntry::Kind::digest) return true;
    }
    call.digest = state_->cursor.peek().digest;
    state_->cursor.take();
    return true;
}

std::shared_ptr<CommandSource> CallReader::source() const { return state_->source; }

std::optional<std::pair<std::uint64_t, Snapshot>> CallReader::keyframe(std::uint64_t after, std::uint64_t until) {
    const auto& all = state_->contents.keyframes;
    const auto next = std::upper_bound(all.begin(), all.end(), until,
                                       [](std::uint64_t value, const auto& keyframe) { return value < keyframe.step; });
    if (next == all.begin() || std::prev(next)->step <= after) return std::nullopt;
    return std::pair(std::prev(next)->step, state_->parts.state_of(*std::prev(next)));
}

} // namespace cairn::recording
