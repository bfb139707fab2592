/// \file world_pool.h
/// Many small worlds that run side by side.
#pragma once

#include <cairn/snapshot.h>
#include <cairn/world.h>

#include <cstddef>
#include <functional>
#include <memory>

namespace cairn {

/// Worlds that start alike and go on apart, for training, sampling and search. Each is stepped by one thread, and the
/// worlds share the working memory of steps: one of 12 bodies takes some 30 kB, and once all have run for a while,
/// nothing is allocated. Results are those of worlds that are stepped one by one, bit for bit, whatever the number of
/// threads. One pool must not be used by two threads at a time; its worlds may be read by many between its calls.
class WorldPool {
  public:
    /// `count` worlds as `start` has them. `threads`: the caller's and those that the pool keeps, 1 to 256. Throws
    /// `Error`: those of `World::restore`; invalid_value for `threads`; unsupported when the system has no more
    /// threads.
    WorldPool(const Snapshot& start, std::size_t count, int threads = 1);
    ~WorldPool();
    WorldPool(WorldPool&&) noexcept;
    WorldPool& operator=(WorldPool&&) noexcept;
    WorldPool(const WorldPool&) = delete;
    WorldPool& operator=(const WorldPool&) = delete;

    std::size_t size() const noexcept; ///< How many worlds there are; 0 once it was moved from.
    int threads() const;
    /// One of them, from 0; valid as long as the pool. `world(i).restore(start)` begins anew. Throws `Error`
    /// (invalid_value) beyond size().
    World& world(std::size_t index);
    const World& world(std::size_t index) const;

    /// Steps every world `count` times (>= 0) by `dt` seconds (> 0, finite).
    void step(float dt, int count = 1);
    /// Calls `work` once for each world, on any of the threads and in any order: to set what the world is to do, step
    /// it and read what came of it. It must not use the pool, nor other worlds of it. Where calls throw, all worlds are
    /// visited all the same, and the exception of the world with the least number arrives.
    void for_each(const std::function<void(World& world, std::size_t index)>& work);

  private:
    struct Impl;
    Impl& impl() const; // throws Error (wrong_state) if it was moved from
    std::unique_ptr<Impl> impl_;
};

} // namespace cairn
