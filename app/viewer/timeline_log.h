/// \file timeline_log.h
/// The commands executed in a world, step by step: what a timeline repeats to get to another moment.
#pragma once

#include "viewer/scene_source.h"

#include <cairn/commands.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace cairn::viewer {

/// A position in a run: the number of steps made, and the number of changes made since the last of them.
struct Moment {
    std::uint64_t step = 0;
    std::uint32_t changes = 0;
    friend auto operator<=>(const Moment&, const Moment&) = default;
};

/// Listens to one world. While `is_logging_paused`, the world repeats known commands, so nothing is appended.
class TimelineLog final : public CommandListener, public CommandSource {
  public:
    using Bytes = std::shared_ptr<const std::vector<std::byte>>;
    struct Frame {
        std::vector<Bytes> changes;          ///< Commands before the step; group notes are empty.
        Bytes step;                          ///< The step command; null: not made yet.
        std::optional<StateDigest> digest{}; ///< Digest of the state after the step, if known.
    };

    /// Empty, or with the commands of a recording.
    explicit TimelineLog(const RecordedRun& run);

    Moment now;
    bool is_logging_paused = false;

    std::uint64_t first_step() const { return first_step_; }
    std::uint64_t last_step() const { return first_step_ + frames_.size() - 1; }
    bool is_at_end() const;
    const Frame& frame(std::uint64_t step) const { return frames_[std::size_t(step - first_step_)]; }
    Frame& frame(std::uint64_t step) { return frames_[std::size_t(step - first_step_)]; }
    /// Forgets everything after `now`.
    void truncate();
    /// Records a change that is no command to the world (of groups): a moment of its own with an empty command.
    void note();
    /// The known future of a moment.
    struct Future {
        Moment from;
        std::vector<Frame> frames; ///< The frame of `from` and the frames after it; empty if nothing follows.
    };
    Future future() const;
    /// Restores a known future in place of later changes; no step may have been made since. The caller moves the world
    /// back: `now` stays.
    void restore_future(const Future& known);
    /// Forgets everything before that step.
    void forget_before(std::uint64_t step);
    std::size_t bytes() const { return bytes_; }
    /// The earliest moment since the last call at which the run branched off its known future.
    std::optional<Moment> take_branch() { return std::exchange(branched_at_, std::nullopt); }
    bool is_recorded() const { return recorded_ != nullptr; }

    /// The commands from one step to `now`, to be repeated in another world; immutable data is shared.
    struct Excerpt {
        std::vector<Frame> frames; ///< The last frame has no step.
        std::shared_ptr<CommandSource> source;
    };
    Excerpt excerpt(std::uint64_t from) const;

    void on_command(std::span<const std::byte> command) override;
    void on_step(const World& world) noexcept override;
    std::uint64_t number_of(const Shape& shape) override;
    std::uint64_t number_of(const Snapshot& snapshot) override;
    const Shape& shape(std::uint64_t number) override;
    const Snapshot& snapshot(std::uint64_t number) override;

  private:
    struct Parts;
    Bytes shared(std::span<const std::byte> command);

    std::deque<Frame> frames_; // the last frame has no step yet
    std::uint64_t first_step_ = 0;
    std::optional<Moment> branched_at_;
    std::size_t bytes_ = 0;
    Bytes last_step_command_;
    std::shared_ptr<CommandSource> recorded_; // of the recording
    std::deque<Shape> shapes_;
    std::unordered_map<const void*, std::uint64_t> numbers_;
    std::deque<Snapshot> snapshots_;
};

/// Executes a logged command in a world. An empty command does nothing.
void repeat(World& world, const std::vector<std::byte>& change, CommandSource& source);

/// Suspends logging while states are restored or commands repeated: sets `is_logging_paused` for its lifetime.
class LoggingPause {
  public:
    explicit LoggingPause(TimelineLog& log) : log_(log), before_(log.is_logging_paused) {
        log_.is_logging_paused = true;
    }
    ~LoggingPause() { log_.is_logging_paused = before_; }
    LoggingPause(const LoggingPause&) = delete;
    LoggingPause& operator=(const LoggingPause&) = delete;

  private:
    TimelineLog& log_;
    bool before_;
};

} // namespace cairn::viewer
