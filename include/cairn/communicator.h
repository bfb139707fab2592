/// \file communicator.h
/// The interface through which several processes step one world together (`World::set_communicator`). It covers the MPI
/// calls that a world needs without depending on MPI; `cairn run` under mpirun implements it with MPI.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace cairn {

/// The processes (ranks) that step one world together. Unless stated otherwise, all ranks call the members other than
/// `rank` and `size`, in the same order, and each call waits for the data that it needs from other ranks. A failed
/// rank, or one that makes other calls, is not recoverable: a member may then throw, which aborts the step (the world
/// refuses all further calls), or end the process.
class Communicator {
  public:
    /// A message to another rank.
    struct Outgoing {
        int rank;
        std::span<const std::byte> bytes;
    };
    /// A message from another rank; its size is that of `bytes`.
    struct Incoming {
        int rank;
        std::span<std::byte> bytes;
    };

    virtual ~Communicator() = default;
    virtual int rank() const = 0; ///< Number of this process, from 0 to size() - 1.
    virtual int size() const = 0; ///< Number of ranks, at least 1.

    /// Sends the messages `out` and receives the messages `in`: at most one message from each rank to each other rank.
    /// Called only by ranks that send or receive something.
    virtual void exchange(std::span<const Outgoing> out, std::span<const Incoming> in) = 0;
    /// Copies `bytes` of the rank `root` to all other ranks; `bytes` has the same size on all ranks.
    virtual void broadcast(int root, std::span<std::byte> bytes) = 0;
    /// The sum of `number` over all ranks.
    virtual std::uint64_t sum(std::uint64_t number) = 0;
};

} // namespace cairn
