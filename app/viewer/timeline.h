/// \file timeline.h
/// The past of a world, to go back to: all that was done to it, and whole states now and then. To get to another
/// moment, the nearest state before it is restored and what followed is done again, which gives the same bits. From
/// there the run is followed as it was, until something else is done: then a new future begins.
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

/// Something on the timeline that one may want to go to.
struct Mark {
    enum class Kind { impact, break_, change };
    Kind kind = Kind::change;
    std::uint64_t step = 0; ///< Steps made when it happened.
    float strength = 0.0f;  ///< Impacts: m/s of approach. Breaks: N.
    std::string text;       ///< Of an impact, empty.
};

/// Bodies that are selected together. No world knows them, but they come and go with its moments and are undone like
/// its changes. They may hold bodies that are gone, which come back when that is undone.
using Groups = std::vector<std::vector<BodyId>>;

class Timeline {
  public:
    /// `budget`: bytes that states and commands may take. Where it is spent, every other state goes; where few are
    /// left, the older half of the run.
    explicit Timeline(std::size_t budget = std::size_t{256} << 20) : budget_(budget) {}

    /// Begins with the world as it is, and listens to it. `run`: what is known to follow.
    void begin(World& world, const RecordedRun& run, Groups groups = {});

    std::uint64_t first_step() const { return log_->first_step(); }
    std::uint64_t last_step() const { return log_->last_step(); }
    Moment now() const { return log_->now; }
    /// Nothing is known that comes after now.
    bool is_at_end() const { return log_->is_at_end(); }
    /// Whether the next step shall do what was done before, rather than begin a new future: not after `undo`.
    bool follows() const { return !is_at_end() && !is_undone_; }
    std::size_t bytes() const { return log_->bytes() + states_.bytes(); }
    double seconds_kept() const {
        return keeping_seconds_;
    } ///< That keeping states took since the beginning, real time.
    const std::shared_ptr<const std::vector<Mark>>& marks() const { return marks_; }

    bool is_recording() const { return log_->is_recorded(); } ///< It began with what a file has.

    /// To be called after a step that the caller made: `seconds` are those that it took.
    void after_step(const World& world, double seconds);
    /// Makes the known changes and the step that come next. True if other changes than those of joints and velocities
    /// were among them. Where a command cannot be carried out, its `Error` comes through.
    /// `before_step` is called between the changes and the step; may be empty.
    bool follow(World& world, const std::function<void(const World&)>& before_step = {});
    /// Goes to a moment, for about so many seconds of real time: false if it has not come there yet. It ends at a
    /// moment in any case. Between the first and the last.
    bool seek(World& world, Moment to, double seconds = 1e9);
    /// One step back, false at the beginning.
    bool step_back(World& world);

    /// Whether a change goes on that of the same name before it, so that both are undone together.
    enum class Merge { never, soon, always };
    /// What was done from that moment to now is a change of that name; nothing, if that moment is now.
    void name_change(const Moment& from, std::string name, Merge merge = Merge::never);
    /// What is done next is a change of its own.
    void end_change() { has_ended_ = true; }
    /// The last change, if it is of that name, was none that anybody meant.
    void unname_change(const std::string& name);
    std::optional<std::string> undoable() const; ///< The name of the change that `undo` takes back.
    std::optional<std::string> redoable() const;
    /// Goes to the moment before the last change before now. What follows can be redone until a step is made.
    bool undo(World& world);
    bool redo(World& world); ///< Goes to where the next change is made.

    /// Does what changes the world, without steps. Where it throws, the world and what is known of its future are as
    /// they were, bit for bit.
    void attempt(World& world, const std::function<void()>& change);
    /// Those at this moment.
    const Groups& groups() const { return std::prev(groups_.upper_bound(log_->now))->second; }
    /// From now on, which is a change to be named.
    void set_groups(Groups groups);

    /// How what was done again compares with what is known of the states then.
    struct Verdict {
        std::uint64_t compared = 0;                   ///< States.
        std::optional<std::uint64_t> first_different; ///< Step.
        std::uint64_t here = 0, there = 0; ///< Hashes of the last one that was compared, or of that first one.
    };
    const Verdict& verdict() const { return verdict_; }

    /// The last so many steps, to be done elsewhere.
    struct Excerpt {
        Snapshot start;
        TimelineLog::Excerpt log;
    };
    Excerpt excerpt(std::uint64_t steps) const;
    /// The same past and the same known future for a copy of the world as it stands now, which it listens to from now
    /// on. It follows that future, also after `undo`.
    Timeline fork(World& copy) const;
    /// Impacts up to now, the oldest first; only the last thousands are kept.
    const std::deque<KnownHit>& hits() const { return hits_; }
    /// For another world to which the same shall be done: how many changes come before that step, and one of them. True
    /// if it was another than of joints and velocities. Throws what the world's calls throw.
    std::size_t change_count(std::uint64_t step) const { return log_->frame(step).changes.size(); }
    bool repeat_change(World& other, const Moment& change);
    /// Nothing is known from now on of what comes after now.
    void forget_future();
    /// The earliest moment since the last call from which something else was done than before.
    std::optional<Moment> take_branch();

  private:
    // States one after the other, to step back through. A copy begins without.
    struct Ring {
        std::optional<SnapshotRing> states;
        std::uint64_t last = 0; // the states are those up to this step, one after each
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
    KeptStates states_; // there is at least one
    decltype(RecordedRun::keyframe) recorded_keyframe_;
    std::uint64_t recorded_until_ = 0; // from there on, what the recording has is no longer what follows
    std::deque<Change> changes_;
    std::map<Moment, Groups> groups_; // from each moment on; the first is that of the first known step or before it
    std::deque<KnownHit> hits_;
    std::deque<Mark> events_;         // impacts and breaks
    std::uint64_t watched_until_ = 0; // step: what happened up to there is among them
    std::shared_ptr<const std::vector<Mark>> marks_;
    bool is_undone_ = false;
    bool has_ended_ = false;                         // the last change
    double step_seconds_ = 0.0, keep_seconds_ = 0.0; // means
    double since_kept_ = 0.0;                        // s of steps since a state that is kept
    double keeping_seconds_ = 0.0;                   // sum
    Ring ring_;
    Verdict verdict_;
    std::optional<Moment> branched_at_;
};

} // namespace cairn::viewer
