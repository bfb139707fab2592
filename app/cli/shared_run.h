// `cairn run` under mpirun: one world on all ranks.
#pragma once

#include "cli/ranks.h"

#include <cairn/world.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cairn::cli {

// Resource use of a rank.
struct RankReport {
    double memory = 0.0, peak_memory = 0.0; // bytes: allocated at the end; peak resident memory
    double waited = 0.0;                    // s: sending messages and waiting for other ranks
    double computed = 0.0;                  // s of CPU time of the stepping thread, without messages
    std::uint64_t messages = 0, bytes = 0;  // sent
};

// Coordination of the ranks besides the steps. A single rank does not communicate.
class SharedRun {
  public:
    // The ranks must outlive this object and the world.
    SharedRun(const Ranks& ranks, World& world);

    bool is_first() const { return rank_ == 0; } // rank 0, which alone writes and prints
    // The next actions of all ranks: they end if any rank requests it, and write a checkpoint if rank 0 requests it.
    struct Requests {
        bool end = false, checkpoint = false;
    };
    Requests agree(Requests here) const;
    // Throws Error (wrong_state) on a rank whose state differs from that of rank 0.
    void compare(const World& world) const;
    // Compares at the start and at regular intervals.
    void compare_now_and_then(const World& world, std::uint64_t step) const;
    std::vector<RankReport> reports() const; // of all ranks; every rank gets all reports
  private:
    std::shared_ptr<CountingCommunicator> communicator_; // null for a single rank
    int rank_;
    double start_;
};

// A line about all ranks; empty for a single rank.
std::string describe(const std::vector<RankReport>& reports, std::uint64_t steps);

} // namespace cairn::cli
