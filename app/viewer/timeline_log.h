/// \file timeline_log.h
/// All that was done to a world as commands, step by step: what a timeline does again to get to another moment.
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

/// Where a run stands: so many steps are made, and so many of the changes that come before the next one.
struct Moment {
    std::uint64_t step = 0;
    std::uint32_t changes = 0;
    friend auto operator<=>(const Moment&, const Moment&) = default;
};

/// Listens to one world. While `is_going`, what is done to it is nothing new.
class TimelineLog final : public CommandListener, public CommandSource {
  public:
    using Bytes = std::shared_ptr<const std::vector<std::byte>>;
    struct Frame {
        std::vector<Bytes> changes;          ///< Before the step; notes are empty.
        Bytes step;                          ///< Null: not made yet.
        std::optional<StateDigest> digest{}; ///< Of the state after it, where it is known.
    };

    /// Empty, or with what a recording has.
    explicit TimelineLog(const RecordedRun& run);

    Moment now;
    bool is_going = false;

    std::uint64_t first_step() const { return first_step_; }
    std::uint64_t last_step() const { return first_step_ + frames_.size() - 1; }
    bool is_at_end() const;
    const Frame& frame(std::uint64_t step) const { return frames_[std::size_t(step - first_step_)]; }
    Frame& frame(std::uint64_t step) { return frames_[std::size_t(step - first_step_)]; }
    /// What comes after `now` is forgotten.
    void truncate();
    /// Takes down a change of what no world knows: a moment of its own, at which nothing is done.
    void note();
    /// What is known at one moment to follow it.
    struct Future {
        Moment from;
        std::vector<Frame> frames; ///< That of `from` and those after it; none if nothing follows.
    };
    Future future() const;
    /// Knows that again in place of what was done since, steps excepted. The caller goes back there: `now` stays.
    void take_up(const Future& known);
    /// What comes before that step is forgotten.
    void forget_before(std::uint64_t step);
    std::size_t bytes() const { return bytes_; }
    /// The earliest moment from which something else was done than before, since this was asked last.
    std::optional<Moment> take_branch() { return std::exchange(branched_at_, std::nullopt); }
    bool is_recorded() const { return recorded_ != nullptr; }

    /// The commands from one step to `now`, to be done elsewhere: shares what does not change.
    struct Excerpt {
        std::vector<Frame> frames; ///< The last one without a step.
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

    std::deque<Frame> frames_; // the last one is open
    std::uint64_t first_step_ = 0;
    std::optional<Moment> branched_at_;
    std::size_t bytes_ = 0;
    Bytes last_step_command_;
    std::shared_ptr<CommandSource> recorded_; // of a recording
    std::deque<Shape> shapes_;
    std::unordered_map<const void*, std::uint64_t> numbers_;
    std::deque<Snapshot> snapshots_;
};

/// Does again what a log has of a world. A note does nothing.
void repeat(World& world, const std::vector<std::byte>& change, CommandSource& source);

/// Is told nothing when a world is handed states: sets `is_going` for as long as it lives.
class Going {
  public:
    explicit Going(TimelineLog& log) : log_(log), before_(log.is_going) { log_.is_going = true; }
    ~Going() { log_.is_going = before_; }
    Going(const Going&) = delete;
    Going& operator=(const Going&) = delete;

  private:
    TimelineLog& log_;
    bool before_;
};

} // namespace cairn::viewer
