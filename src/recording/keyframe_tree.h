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
// keeping them is more than a part of the work. Work is counted, not measured: the same run gives the same file.
#pragma once

#include "recording/patch.h"

#include <cairn/world.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cairn::recording {

class KeyframeTree {
  public:
    // `work`: s of a processor from one to the next; `budget`: bytes for all.
    KeyframeTree(double work, std::size_t budget) : spacing_(work), budget_(budget) {}

    // To be asked once after each step: whether to keep what the world is now.
    bool is_due(const World& world);

    // Of what is kept: which it is of all that ever were, counted from 1, that of its parent, or 0, and the difference.
    struct Difference {
        std::uint64_t id = 0, parent = 0;
        std::string patch;
    };
    Difference add(std::string state);
    // What was added last lies in that chunk of a file, and takes so many bytes. The answer: chunks that are kept no
    // longer, as the budget is spent.
    std::vector<std::size_t> settle(std::size_t chunk, std::uint64_t bytes);

  private:
    struct Ancestor { // of the last one, and that itself
        std::uint64_t number, id;
        std::string state;
    };
    struct Kept {
        std::uint64_t number;
        double work; // s, when it came
        std::size_t chunk;
        std::uint64_t bytes;
    };
    void thin_out(std::vector<std::size_t>& gone);

    double spacing_; // s of work
    std::size_t budget_;
    double thinned_ = 1;                         // how many times as far apart they are as they were
    double work_ = 0, step_work_ = 0, cost_ = 0; // s: so far; of a step; of keeping one
    std::uint64_t steps_ = 0, last_ = 0, ids_ = 0, bytes_ = 0;
    std::vector<Ancestor> path_; // the last one's, the oldest first
    std::vector<Kept> kept_;     // by number
    Patcher patcher_;
};

} // namespace cairn::recording
