/// \file world_pool.h
/// Many small worlds that are stepped in parallel.
#pragma once

#include <cairn/snapshot.h>
#include <cairn/world.h>

#include <cstddef>
#include <functional>
#include <memory>

namespace cairn {

/// Worlds that start from the same state and then run independently, for training, sampling and search. Each is stepped
/// by one thread, and the worlds share the working memory of steps: a world of 12 bodies takes some 30 kB, and once all
/// worlds have run for a while, stepping allocates no memory. Results equal those of worlds that are stepped one by
/// one, bit for bit, for any number of threads. A pool must not be used by two threads at the same time; between its
/// calls, any number of threads may read its worlds.
class WorldPool {
  public:
    /// Creates `count` worlds, each restored from `start`. `threads`: number of threads including the caller's, 1 to
    /// 256. Throws `Error` as `World::restore` does, invalid_value if `threads` is out of range, and unsupported if the
    /// system cannot create the threads.
    WorldPool(const Snapshot& start, std::size_t count, int threads = 1);
    ~WorldPool();
    WorldPool(WorldPool&&) noexcept;
    WorldPool& operator=(WorldPool&&) noexcept;
    WorldPool(const WorldPool&) = delete;
    WorldPool& operator=(const WorldPool&) = delete;

    std::size_t size() const noexcept; ///< Number of worlds; 0 after the pool was moved from.
    int threads() const;
    /// The world with that index, from 0; the reference is valid as long as the pool exists. `world(i).restore(start)`
    /// resets a world. Throws `Error` (invalid_value) unless index < size().
    World& world(std::size_t index);
    const World& world(std::size_t index) const;

    /// Steps every world `count` times (>= 0) by `dt` seconds (> 0, finite).
    void step(float dt, int count = 1);
    /// Calls `work` once for each world, on any of the threads and in any order: to set its inputs, step it, and read
    /// its results. `work` must not use the pool or its other worlds. If calls throw, all worlds are visited
    /// nevertheless, and the exception from the world with the lowest index is rethrown.
    void for_each(const std::function<void(World& world, std::size_t index)>& work);

  private:
    struct Impl;
    Impl& impl() const; // throws Error (wrong_state) if it was moved from
    std::unique_ptr<Impl> impl_;
};

} // namespace cairn
