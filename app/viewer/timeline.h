/// \file timeline.h
/// The past of a world, for time travel: all commands, and a snapshot now and then. To get to another moment, the
/// nearest earlier snapshot is restored and the commands after it are executed again, which reproduces the run bit for
/// bit. From there the known run is followed until a new command is given, which starts a new future.
#pragma once

#include "viewer/impact.h"
#include "viewer/kept_states.h"
#include "viewer/timeline_log.h"

#include <cairn/snapshot_ring.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cairn::viewer {

/// An event on the timeline that a user may want to go to.
struct Mark {
    enum class Kind { impact, break_, change };
    Kind kind = Kind::change;
    std::uint64_t step = 0; ///< Number of steps made when it happened.
    float strength = 0.0f;  ///< Impacts: approach speed, m/s. Breaks: force, N.
    std::string text;       ///< Empty for an impact.
};

/// Groups of bodies that are selected together. They are no part of the world, but follow its timeline and are undone
/// like its changes. They may hold removed bodies, which return when the removal is undone.
using Groups = std::vector<std::vector<BodyId>>;

class Timeline {
  public:
    /// `budget`: bytes for states and commands. Beyond it, every other state is dropped; if few are left, the older
    /// half of the run.
    explicit Timeline(std::size_t budget = std::size_t{256} << 20) : budget_(budget) {}

    /// Begins with the present state of the world, and listens to its commands. `run`: the recorded future, if any.
    void begin(World& world, const RecordedRun& run, Groups groups = {});

    std::uint64_t first_step() const { return log_->first_step(); }
    std::uint64_t last_step() const { return log_->last_step(); }
    Moment now() const { return log_->now; }
    /// Nothing is known beyond the present moment.
    bool is_at_end() const { return log_->is_at_end(); }
    /// Whether the next step follows the known run rather than beginning a new future: false after `undo`.
    bool follows() const { return !is_at_end() && !is_undone_; }
    std::size_t bytes() const { return log_->bytes() + states_.bytes(); }
    double seconds_kept() const { return keeping_seconds_; } ///< Real time that keeping states has taken so far.
    const std::shared_ptr<const std::vector<Mark>>& marks() const { return marks_; }

    bool is_recording() const { return log_->is_recorded(); } ///< The timeline began with the run of a recording file.

    /// To be called after each step that the caller made; `seconds`: the time that the step took.
    void after_step(const World& world, double seconds);
    /// Executes the known changes and the step that come next. Returns true if the changes included other ones than of
    /// joints and velocities. A command that cannot be executed throws its `Error`. `before_step` is called between the
    /// changes and the step; may be empty.
    bool follow(World& world, const std::function<void(const World&)>& before_step = {});
    /// Goes to a moment between the first and the last, for about that many seconds of real time: false if it has not
    /// arrived yet. The world is at some moment of the run in any case.
    bool seek(World& world, Moment to, double seconds = 1e9);
    /// Goes one step back; false at the beginning.
    bool step_back(World& world);

    /// Whether a change is merged with a preceding one of the same name, so that both are undone together.
    enum class Merge { never, soon, always };
    /// Names all commands from that moment to the present one as a single undoable change; does nothing if that moment
    /// is the present one.
    void name_change(const Moment& from, std::string name, Merge merge = Merge::never);
    /// Prevents the next change from being merged with the last one.
    void end_change() { has_ended_ = true; }
    /// Removes the last change from the undo history, if it has that name, because it was not intended.
    void unname_change(const std::string& name);
    std::optional<std::string> undoable() const; ///< The name of the change that `undo` would revert.
    std::optional<std::string> redoable() const;
    /// Goes to the moment before the last change. The reverted changes can be redone until a step is made.
    bool undo(World& world);
    bool redo(World& world); ///< Goes to the moment at which the next change is made.

    /// Calls `change`, which changes the world without steps. If it throws, the world and the known future are restored
    /// bit for bit.
    void attempt(World& world, const std::function<void()>& change);
    /// The groups at the present moment.
    const Groups& groups() const { return std::prev(groups_.upper_bound(log_->now))->second; }
    /// Sets the groups from the present moment on; this is a change to be named by `name_change`.
    void set_groups(Groups groups);

    /// The comparison of repeated steps with the known states of the original run.
    struct Verdict {
        std::uint64_t compared = 0;                   ///< Number of states compared.
        std::optional<std::uint64_t> first_different; ///< Step number.
        std::uint64_t here = 0, there = 0; ///< State hashes of the last compared state, or of the first different one.
    };
    const Verdict& verdict() const { return verdict_; }

    /// The last `steps` steps, to be repeated in another world.
    struct Excerpt {
        Snapshot start;
        TimelineLog::Excerpt log;
    };
    Excerpt excerpt(std::uint64_t steps) const;
    /// A copy of this timeline for `copy`, a copy of the world in its present state, which the new timeline listens to.
    /// It follows the known future, also after `undo`.
    Timeline fork(World& copy) const;
    /// Impacts up to the present moment, oldest first; only the last thousands are kept.
    const std::deque<KnownHit>& hits() const { return hits_; }
    /// For repeating the run in another world: the number of changes before that step, and the execution of one of
    /// them, which returns true unless it only changed joints or velocities, and throws what the world's calls throw.
    std::size_t change_count(std::uint64_t step) const { return log_->frame(step).changes.size(); }
    bool repeat_change(World& other, const Moment& change);
    /// Forgets the known future.
    void forget_future();
    /// The earliest moment since the last call at which the run branched off its known future.
    std::optional<Moment> take_branch();

  private:
    // Recent states of consecutive steps, for stepping back. A copy of the ring starts empty.
    struct Ring {
        std::optional<SnapshotRing> states;
        std::uint64_t last = 0; // step number of the last state; the states before it are one step apart
        Ring() = default;
        Ring(const Ring&) {}
        Ring(Ring&&) = default;
        Ring& operator=(const Ring&) = delete;
        Ring& operator=(Ring&&) = default;
    };
    struct Change {
        Moment begin, end;
        std::string name;
    };
    void keep(const World& world, double step_seconds);
    void compare(const World& world);
    void watch(const World& world);
    void note(Mark mark);
    bool restore_before(World& world, std::uint64_t step, std::optional<std::uint64_t> after);
    bool follow_one(World& world, const std::function<void(const World&)>& before_step = {});
    bool execute_changes(World& world, std::uint32_t count);
    void drop_other_future();
    bool is_state_due(std::uint64_t steps) const;
    void make_room(std::size_t bytes);
    void forget_what_came_before();
    void name_recorded_changes();
    void gather_marks();

    std::size_t budget_;
    std::shared_ptr<TimelineLog> log_;
    KeptStates states_; // never empty after `begin`
    decltype(RecordedRun::keyframe) recorded_keyframe_;
    std::uint64_t recorded_until_ = 0; // step from which on the run differs from the recording
    std::deque<Change> changes_;
    // Keyed by the moment from which the groups hold; the first key is at or before the first known step.
    std::map<Moment, Groups> groups_;
    std::deque<KnownHit> hits_;
    std::deque<Mark> events_;         // impacts and breaks
    std::uint64_t watched_until_ = 0; // step number; events up to it have been collected
    std::shared_ptr<const std::vector<Mark>> marks_;
    bool is_undone_ = false;
    bool has_ended_ = false;                         // the last change is closed to merging
    double step_seconds_ = 0.0, keep_seconds_ = 0.0; // means
    double since_kept_ = 0.0;                        // compute time of steps since a state was kept, s
    double keeping_seconds_ = 0.0;                   // sum
    Ring ring_;
    Verdict verdict_;
    std::optional<Moment> branched_at_;
};

} // namespace cairn::viewer
