/// \file communicator.h
/// What a world needs to be stepped by several processes together (`World::set_communicator`): the calls of MPI that it
/// makes, without MPI. `cairn run` under mpirun has one made of MPI.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace cairn {

/// The processes (ranks) that step one world together. All members but the first two are called by all ranks, in the
/// same order; each waits for what it needs of the others. A rank that is gone, or that makes other calls, cannot be
/// got over: a member may throw, which ends the step half way (the world then refuses everything), or end the process.
class Communicator {
  public:
    /// A message to another rank.
    struct Outgoing {
        int rank;
        std::span<const std::byte> bytes;
    };
    /// A message from another rank, which has the size of `bytes`.
    struct Incoming {
        int rank;
        std::span<std::byte> bytes;
    };

    virtual ~Communicator() = default;
    virtual int rank() const = 0; ///< Of this process, from 0.
    virtual int size() const = 0; ///< How many ranks there are, at least 1.

    /// Sends what goes out and receives what comes in, at most one message from each rank to each other one. Called by
    /// those ranks that have messages alone.
    virtual void exchange(std::span<const Outgoing> out, std::span<const Incoming> in) = 0;
    /// `bytes` of the rank `root` for all, which have the same size there.
    virtual void broadcast(int root, std::span<std::byte> bytes) = 0;
    /// The sum of the numbers of all ranks.
    virtual std::uint64_t sum(std::uint64_t number) = 0;
};

} // namespace cairn
