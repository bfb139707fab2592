// Keyframes: full states at certain steps of a run, each stored as its difference from an earlier one.
//     number   1    2    3    4    5    6    7    8
//     parent   -    -    2    -    4    4    6    -
// Keyframes are numbered from 1. The parent of a keyframe is its number with the lowest set bit cleared: 6 (110) has
// the parent 4 (100), which has none. Hence the number of differences that lead to a state equals the number of set
// bits of its number, half of the differences are from the keyframe just before, and no keyframe depends on odd
// numbers: to halve the number of keyframes, the odd ones are dropped, and the others continue with half their numbers.
// So the keyframes stay evenly distributed over the run, however long it becomes.
// The distance of keyframes is measured in stepping work, because that determines how long seeking to a step between
// two keyframes takes; and they are so rare that keeping them takes only a fraction of the work. A recording estimates
// the work from counts rather than measure it, so that the same run gives the same file.
// A keyframe at the beginning of the run has number 0, and keyframes without a parent are differences from it. Then the
// oldest keyframes can be dropped, too: from the greatest power of two on, all keyframes are differences from that one
// or from later ones, and this remains true if it becomes number 0.
#pragma once

#include <cairn/world.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace cairn::recording {

// The bytes of a full state, shared by all copies of this struct.
struct WholeState {
    std::shared_ptr<const void> owner; // keeps the bytes alive
    std::string_view bytes;
};

class KeyframeTree {
  public:
    // `work`: processor time of the steps between two keyframes, s. `share`: the greatest share of the work that
    // keeping states may take; if exceeded, they become rarer. `budget`: bytes for all keyframes.
    KeyframeTree(double work, double share, std::size_t budget) : spacing_(work), share_(share), budget_(budget) {}

    // To be called once after each step: whether the current state should be kept.
    bool is_due(const World& world);
    double least_work() const { return thinned_ * cost_ / share_; } // s, between two keyframes
    double usual_work() const { return std::max(thinned_ * spacing_, least_work()); }

    // A keyframe to be stored, as a patch that leads from the state `before` to `after`. `id` is its index among all
    // keyframes ever added, counted from 1, and `parent` that of its parent, or 0.
    struct Difference {
        std::uint64_t id = 0, parent = 0;
        std::optional<WholeState> before; // empty if there is no parent, or its state is not in memory
        WholeState after;
    };
    Difference add(WholeState state);
    // Adds keyframe 0, before all others.
    Difference add_beginning(WholeState state);
    // Sets where the last added keyframe is stored, and its size. Returns the places of keyframes that are dropped
    // because the budget is exceeded.
    std::vector<std::size_t> settle(std::size_t place, std::uint64_t bytes);

    // The functions below are for keyframes that can be dropped at any time, and require that all of them are settled.

    // Drops every other keyframe, and doubles the distance of later ones. Returns the places of the dropped ones.
    std::vector<std::size_t> thin_out();
    // The place of the keyframe that can become number 0: the greatest power of two. Nothing if there is only number 0.
    std::optional<std::size_t> next_beginning() const;
    // Makes that keyframe number 0, now of this size. Returns the places of earlier keyframes, which are dropped.
    std::vector<std::size_t> begin_there(std::uint64_t bytes);
    // Drops the keyframes after that one.
    void drop_after(std::uint64_t id);

    // A state that is in memory: only the last keyframe, and its ancestors that were not dropped.
    std::optional<WholeState> in_memory(std::uint64_t id) const;
    std::size_t bytes_in_memory() const;
    std::size_t count() const { return kept_.size(); }
    std::uint64_t bytes() const { return bytes_; } // of all patches
    double thinned() const { return thinned_; }    // factor by which the distance of keyframes has grown

  private:
    struct InMemory {
        std::uint64_t number, id;
        WholeState state;
    };
    struct Kept {
        std::uint64_t number, id;
        double work; // s, when it was added
        std::size_t place;
        std::uint64_t bytes;
    };
    Difference add(std::uint64_t number, WholeState state);

    double spacing_, share_; // s; a ratio
    std::size_t budget_;
    double thinned_ = 1;
    double work_ = 0, step_work_ = 0, cost_ = 0; // s: total; of one step; of keeping one state
    std::uint64_t steps_ = 0, last_ = 0, ids_ = 0, bytes_ = 0;
    std::vector<InMemory> path_; // the last keyframe and its ancestors, oldest first
    std::vector<Kept> kept_;     // consecutive numbers
};

} // namespace cairn::recording
