/// \file snapshot_ring.h
/// The last states of a world, to go back to: what a game over a network, or a search, does in every frame.
#pragma once

#include <cairn/world.h>

#include <cstddef>
#include <memory>

namespace cairn {

/// The last states of one world. Of each, only what the next one has otherwise is kept: a body at rest takes almost
/// nothing. Going back is faster than by snapshots, and as exact.
///
///     cairn::SnapshotRing ring(8);
///     for (;;) {
///         ring.push(world);
///         world.step(dt);
///         // What another player did three frames ago is known only now:
///         ring.restore(world, 2); // the state before the last step but two
///     }
class SnapshotRing {
  public:
    /// `frames`: how many states it keeps, at least 1; the oldest goes when there are more. Throws `Error`
    /// (invalid_value).
    explicit SnapshotRing(std::size_t frames);
    ~SnapshotRing();
    SnapshotRing(SnapshotRing&&) noexcept;
    SnapshotRing& operator=(SnapshotRing&&) noexcept;

    /// Keeps the state of a world as it is now. Throws `Error` (wrong_state) as `World::save` does; the ring is then as
    /// it was. Where memory runs out, the ring is empty.
    void push(const World& world);
    /// Makes a world what it was when it was pushed; `back` = 0: the last time, at most `size()` - 1. What was pushed
    /// after that is forgotten. Like `World::restore`, which a command listener is told of. Throws `Error`:
    /// invalid_value, wrong_state; world and ring are then as they were.
    void restore(World& world, std::size_t back = 0);
    void clear(); ///< Forgets all.

    std::size_t size() const noexcept;     ///< How many states it has.
    std::size_t capacity() const noexcept; ///< As it was made for.
    /// Bytes that a state takes beside the one after it, or of the last one: all of it, in which the others' are not
    /// counted. Definitions, which many states share, are not counted. Throws `Error` (invalid_value) unless
    /// `back` < `size()`.
    std::size_t bytes(std::size_t back) const;

  private:
    struct Ring;
    std::unique_ptr<Ring> ring_;
};

} // namespace cairn
