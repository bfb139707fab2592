/// \file kept_states.h
/// Whole states of a run at some of its moments, as recordings have them: a tree of differences. A thread of its own
/// finds the differences, as that takes as long as some steps.
#pragma once

#include "recording/keyframe_tree.h"

#include <cairn/world.h>

#include <cstddef>
#include <cstdint>
#include <future>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace cairn::viewer {

/// What is kept, and what any call answers, does not depend on how fast that thread is: it is handed one state at a
/// time, and whoever needs the outcome waits for it. A copy shares states and thread.
class KeptStates {
  public:
    KeptStates();

    /// Keeps the state of a world after so many steps: the first, or one that is later than all others.
    void keep(const World& world, std::uint64_t step);

    std::size_t count() const { return states_.size(); }
    std::uint64_t first() const { return states_.begin()->first; } ///< Steps. There must be one.
    std::uint64_t last() const { return states_.rbegin()->first; } ///< Likewise.
    /// The last one that is kept at or before that step; not before `first`.
    std::uint64_t before(std::uint64_t step) const;
    /// Of a step at which a state is kept.
    Snapshot state(std::uint64_t step) const;
    /// Null where no state is kept.
    const StateDigest* digest(std::uint64_t step) const;

    /// Those after that step go. One at or before it must be there.
    void drop_after(std::uint64_t step);
    /// Every other one goes; the first stays.
    void thin_out();
    /// The older half goes. There must be three.
    void drop_oldest();

    /// Differences, those states that are whole in memory, and definitions. That of the last state is counted from the
    /// next call that waits for it on.
    std::size_t bytes() const;
    std::size_t last_size() const { return states_.empty() ? 0 : states_.rbegin()->second.size; } ///< Bytes, whole.
    /// Seconds of steps between two: at the least, so that keeping them costs little, and where they are not many
    /// steps.
    double least_seconds() const { return tree_.least_work(); }
    double usual_seconds() const { return tree_.usual_work(); }
    double thinned() const { return tree_.thinned(); } ///< How many times as far apart they are as at first.
    /// Waits for the last difference. Throws std::bad_alloc where there was no memory for it: that state is gone then.
    void settle();

  private:
    class Helper;
    using Patch = std::shared_future<std::string>;
    struct Kept {
        std::uint64_t id = 0;     // in the tree
        std::uint64_t parent = 0; // step; its own: it has none
        Patch patch;
        std::size_t size = 0; // bytes, whole
        std::shared_ptr<const SnapshotDefinitions> definitions;
        StateDigest digest;
    };
    // Patches that lead from a state in memory, or from nothing, to another.
    struct Way {
        recording::WholeState start;
        std::vector<Patch> patches;
        recording::WholeState end() const; // waits for them
    };
    Way way_to(std::uint64_t step) const;

    recording::KeyframeTree tree_;
    std::map<std::uint64_t, Kept> states_; // by steps made
    bool is_settled_ = true;               // the last one
    std::shared_ptr<Helper> helper_;
};

} // namespace cairn::viewer
