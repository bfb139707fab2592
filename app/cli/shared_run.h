// `cairn run` under mpirun: one world on all ranks.
#pragma once

#include "cli/ranks.h"

#include <cairn/world.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cairn::cli {

// What a rank has needed.
struct RankReport {
    double memory = 0.0, peak_memory = 0.0; // bytes: that it has allocated at the end; that were its, at most
    double waited = 0.0;                    // s: telling the others, and waiting for them
    double computed = 0.0;                  // s of its processor: all else, by the thread that steps
    std::uint64_t messages = 0, bytes = 0;  // sent
};

// What the ranks agree on beside the steps. With one rank, nothing is asked of anybody.
class SharedRun {
  public:
    // The ranks must live as long as this and the world.
    SharedRun(const Ranks& ranks, World& world);

    bool is_first() const { return rank_ == 0; } // which writes and prints, alone
    // What all ranks do next: they end if any of them is to, and write a checkpoint if the first one is to.
    struct Requests {
        bool end = false, checkpoint = false;
    };
    Requests agree(Requests here) const;
    // Throws Error (wrong_state) on a rank whose state is another than that of the first.
    void compare(const World& world) const;
    // Every so often, and at the start: compares.
    void compare_now_and_then(const World& world, std::uint64_t step) const;
    std::vector<RankReport> reports() const; // of all ranks, for all
  private:
    std::shared_ptr<CountingCommunicator> communicator_; // null if there is one
    int rank_;
    double start_;
};

// A line about all of them; empty if there is one.
std::string describe(const std::vector<RankReport>& reports, std::uint64_t steps);

} // namespace cairn::cli
