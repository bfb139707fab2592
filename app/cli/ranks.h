// The processes that mpirun has started beside this one.
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

// One process on its own is rank 0 of 1, and nothing of MPI is touched. While one of these lives, all others are there;
// its end waits for theirs.
class Ranks : public sweep::Source {
  public:
    // Throws Error (unsupported) if mpirun has started this program and it was built without MPI; `otherwise`: what
    // else can be done then.
    explicit Ranks(const char* otherwise);
    ~Ranks() override;

    int rank() const { return rank_; }
    int size() const { return size_; }

    // Chunks are handed out by a counter that all ranks share.
    std::uint64_t next() override;
    void attend() override;
    std::uint64_t taken() const { return taken_; } // of all ranks, when last attended to

    // By which a world is stepped by all ranks, as long as this lives; null if there is one.
    std::shared_ptr<CountingCommunicator> communicator() const;

    void meet(); // waits until all ranks have come here
    // Calls `command`, a part of the program that returns its exit code. What it throws is told and ends all ranks;
    // where there are no others, it is thrown on.
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
    std::mutex mutex_; // MPI is called by one thread at a time
    std::uint64_t taken_ = 0;
    sweep::LocalSource alone_;
};

// What a rank has told the others, and how long that and waiting for them took.
struct Traffic {
    std::uint64_t messages = 0, bytes = 0; // that went out, those of broadcasts once
    double seconds = 0, processor_seconds = 0;
};

double processor_seconds(); // of this thread

// The ranks as a communicator that counts.
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
