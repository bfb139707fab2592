// The MPI ranks that mpirun has started.
#pragma once

#include "sweep/run.h"

#include <cairn/communicator.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace cairn::cli {

class CountingCommunicator;

// The set of ranks. A process started without mpirun is rank 0 of 1 and does not use MPI. The constructor and
// destructor are collective: the destructor waits for the other ranks.
class Ranks : public sweep::Source {
  public:
    // Throws Error (unsupported) if mpirun has started this program and it was built without MPI; `otherwise`: the
    // suggested alternative.
    explicit Ranks(const char* otherwise);
    ~Ranks() override;

    int rank() const { return rank_; }
    int size() const { return size_; }

    // Hands out chunks by a counter that all ranks share.
    std::uint64_t next() override;
    void poll() override;
    std::uint64_t taken() const { return taken_; } // by all ranks, as of the last `poll`

    // The communicator by which all ranks step one world; valid during this object's lifetime; null for a single rank.
    std::shared_ptr<CountingCommunicator> communicator() const;

    void meet(); // barrier over all ranks
    // Calls `command`, which returns an exit code. An exception is reported and ends all ranks; with a single rank it
    // propagates.
    int run(const std::function<int()>& command);

    struct Message {
        int rank;
        std::byte* bytes;
        std::size_t size;
    };
    struct Functions {
        void (*begin)(int*, int*);
        std::int64_t (*next)();
        std::int64_t (*taken)();
        void (*meet)();
        void (*exchange)(const Message*, int, int);
        void (*broadcast)(int, std::byte*, std::size_t);
        std::uint64_t (*sum)(std::uint64_t);
        void (*end)();
        void (*abort)(int);
    };

  private:
    Functions mpi_{};
    bool has_mpi_ = false;
    int rank_ = 0, size_ = 1;
    std::mutex mutex_; // serializes MPI calls
    std::uint64_t taken_ = 0;
    sweep::LocalSource alone_;
};

// Number of messages of a rank, and the time spent on sending and waiting.
struct Traffic {
    std::uint64_t messages = 0, bytes = 0; // sent; a broadcast counts once
    double seconds = 0, processor_seconds = 0;
};

double processor_seconds(); // CPU time of this thread

// A communicator over the ranks that counts its traffic.
class CountingCommunicator final : public Communicator {
  public:
    CountingCommunicator(const Ranks::Functions& mpi, int rank, int size) : mpi_(mpi), rank_(rank), size_(size) {}
    int rank() const override { return rank_; }
    int size() const override { return size_; }
    void exchange(std::span<const Outgoing> out, std::span<const Incoming> in) override;
    void broadcast(int root, std::span<std::byte> bytes) override;
    std::uint64_t sum(std::uint64_t number) override;

    const Traffic& traffic() const { return traffic_; }

  private:
    Ranks::Functions mpi_;
    int rank_, size_;
    Traffic traffic_;
    std::vector<Ranks::Message> messages_;
};

} // namespace cairn::cli
