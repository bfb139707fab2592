// Whole states on the way of a run, each kept as its difference from an earlier one.
//
//     number   1    2    3    4    5    6    7    8
//     parent   -    -    2    -    4    4    6    -
//
// They are counted from 1, and the parent of one is its number without its lowest bit: of 6 (110) 4 (100), of that
// none. So as many differences lead to a state as its number has bits that are set, half of the differences are from
// the state just before, and no other depends on those of odd numbers: to have half as many, these go, and the rest go
// on with half their numbers. Whoever has few of them has them evenly spread over the whole run, however long it gets.
//
// They come after so much work of stepping, as that is what going to a moment between two takes; and not so often that
// keeping them is more than a part of the work. A recording counts that work rather than measures it: the same run
// gives the same file.
//
// Where there is one at the beginning of the run it has number 0, and those without a parent are differences from it.
// Then the oldest ones can go as well: from the greatest power of two on, all differ from that state or from later
// ones, which stays so when it becomes number 0.
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

// The bytes of a whole state, which whoever has this shares.
struct WholeState {
    std::shared_ptr<const void> owner; // of the bytes
    std::string_view bytes;
};

class KeyframeTree {
  public:
    // `work`: s of a processor from one to the next; `share`: of the work that keeping states may be, if that is less
    // often; `budget`: bytes for all.
    KeyframeTree(double work, double share, std::size_t budget) : spacing_(work), share_(share), budget_(budget) {}

    // To be asked once after each step: whether to keep what the world is now.
    bool is_due(const World& world);
    double least_work() const { return thinned_ * cost_ / share_; } // s from the last one to the next
    double usual_work() const { return std::max(thinned_ * spacing_, least_work()); }

    // Of what is kept: which it is of all that ever were, counted from 1, and that of its parent, or 0. The patch to
    // keep leads from one of the states to the other.
    struct Difference {
        std::uint64_t id = 0, parent = 0;
        std::optional<WholeState> before; // nothing: there is no parent, or its state is in memory no longer
        WholeState after;
    };
    Difference add(WholeState state);
    // Before all others: number 0.
    Difference add_beginning(WholeState state);
    // What was added last has that place, and takes so many bytes. The answer: the places of what is kept no longer, as
    // the budget is spent.
    std::vector<std::size_t> settle(std::size_t place, std::uint64_t bytes);

    // What follows is for states that can be given up at any time. All of them are settled.

    // Every other one goes, and later ones come half as often: their places.
    std::vector<std::size_t> thin_out();
    // The place of the state that comes next as number 0: the greatest power of two. Nothing: there is only one.
    std::optional<std::size_t> next_beginning() const;
    // That becomes number 0, and takes so many bytes: the places of those before it, which go.
    std::vector<std::size_t> begin_there(std::uint64_t bytes);
    // Those after that one go.
    void drop_after(std::uint64_t id);

    // In memory are the last one, and those of its ancestors that have not been dropped.
    std::optional<WholeState> in_memory(std::uint64_t id) const;
    std::size_t bytes_in_memory() const;
    std::size_t count() const { return kept_.size(); }
    std::uint64_t bytes() const { return bytes_; } // of all patches
    double thinned() const { return thinned_; }    // how many times as far apart they are as at first

  private:
    struct InMemory {
        std::uint64_t number, id;
        WholeState state;
    };
    struct Kept {
        std::uint64_t number, id;
        double work; // s, when it came
        std::size_t place;
        std::uint64_t bytes;
    };
    Difference add(std::uint64_t number, WholeState state);

    double spacing_, share_; // s of work, 1
    std::size_t budget_;
    double thinned_ = 1;
    double work_ = 0, step_work_ = 0, cost_ = 0; // s: so far; of a step; of keeping one
    std::uint64_t steps_ = 0, last_ = 0, ids_ = 0, bytes_ = 0;
    std::vector<InMemory> path_; // the last one and its ancestors, the oldest first
    std::vector<Kept> kept_;     // by number, without gaps
};

} // namespace cairn::recording
