// The processes that mpirun has started beside this one.
#pragma once

#include "sweep/run.h"

#include <cstdint>
#include <mutex>

namespace cairn::cli {

// One process on its own is rank 0 of 1, and nothing of MPI is touched. While one of these lives, all others are there;
// its end waits for theirs.
class Ranks : public sweep::Source {
  public:
    // Throws Error (unsupported) if mpirun has started this program and it was built without MPI.
    Ranks();
    ~Ranks() override;

    int rank() const { return rank_; }
    int size() const { return size_; }

    // Chunks are handed out by a counter that all ranks share.
    std::uint64_t next() override;
    void attend() override;
    std::uint64_t taken() const { return taken_; } // of all ranks, when last attended to

    void meet(); // waits until all ranks have come here
    // What went wrong here, which has been told, ends all ranks. Returns if there are no others.
    void abort_others(int code);

  private:
    struct Functions {
        void (*begin)(int*, int*);
        std::int64_t (*next)();
        std::int64_t (*taken)();
        void (*meet)();
        void (*end)();
        void (*abort)(int);
    };
    Functions mpi_{};
    bool has_mpi_ = false;
    int rank_ = 0, size_ = 1;
    std::mutex mutex_; // MPI is called by one thread at a time
    std::uint64_t taken_ = 0;
    sweep::LocalSource alone_;
};

} // namespace cairn::cli
