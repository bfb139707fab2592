/// \file kept_states.h
/// Snapshots of a run at some of its steps, stored as a tree of differences as in recordings. A helper thread computes
/// the differences, because that takes as long as several steps.
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

/// Which states are kept, and the result of every call, do not depend on the speed of the helper thread: it gets one
/// state at a time, and callers that need the result wait for it. Copies share states and thread.
class KeptStates {
  public:
    KeptStates();

    /// Keeps the state of a world after `step` steps: the first state, or one later than all others.
    void keep(const World& world, std::uint64_t step);

    std::size_t count() const { return states_.size(); }
    std::uint64_t first() const { return states_.begin()->first; } ///< Step number. At least one state must be kept.
    std::uint64_t last() const { return states_.rbegin()->first; } ///< Step number. At least one state must be kept.
    /// The step of the last state that is kept at or before that step, which must not be before `first`.
    std::uint64_t before(std::uint64_t step) const;
    /// The state of a step at which one is kept.
    Snapshot state(std::uint64_t step) const;
    /// Null where no state is kept.
    const StateDigest* digest(std::uint64_t step) const;

    /// Drops the states after that step. A state at or before it must be kept.
    void drop_after(std::uint64_t step);
    /// Drops every other state; the first one stays.
    void thin_out();
    /// Drops the older half of the states. There must be at least three.
    void drop_oldest();

    /// Memory for differences, for states held whole, and for definitions. The difference of the last state is included
    /// only once some call has waited for it.
    std::size_t bytes() const;
    /// Size of the last state in full, bytes.
    std::size_t last_size() const { return states_.empty() ? 0 : states_.rbegin()->second.size; }
    /// Compute time of steps between two kept states, seconds: the least, so that keeping states costs little, and the
    /// usual one where it does not span many steps.
    double least_seconds() const { return tree_.least_work(); }
    double usual_seconds() const { return tree_.usual_work(); }
    /// Factor by which thinning out has increased the distance between states.
    double thinned() const { return tree_.thinned(); }
    /// Waits for the last difference. Throws std::bad_alloc if there was no memory for it; that state is then dropped.
    void settle();

  private:
    class Helper;
    using Patch = std::shared_future<std::string>;
    struct Kept {
        std::uint64_t id = 0;     // in the tree
        std::uint64_t parent = 0; // step of the parent state; its own step if it has none
        Patch patch;
        std::size_t size = 0; // of the full state, bytes
        std::shared_ptr<const SnapshotDefinitions> definitions;
        StateDigest digest;
    };
    // The patches that lead from a state in memory, or from an empty one, to another state.
    struct PatchChain {
        recording::WholeState start;
        std::vector<Patch> patches;
        recording::WholeState end() const; // waits for the patches
    };
    PatchChain patches_to(std::uint64_t step) const;

    recording::KeyframeTree tree_;
    std::map<std::uint64_t, Kept> states_; // by step number
    bool is_settled_ = true;               // the last difference has been waited for
    std::shared_ptr<Helper> helper_;
};

} // namespace cairn::viewer
