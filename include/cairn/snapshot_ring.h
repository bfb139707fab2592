/// \file snapshot_ring.h
/// A ring buffer of the last states of a world, for rollback in every frame, as in networked games and in searches.
#pragma once

#include <cairn/world.h>

#include <cstddef>
#include <memory>

namespace cairn {

/// The last states of one world. For each state only the difference from the next is stored, so that a body at rest
/// takes almost no memory. Restoring is faster than with snapshots, and as exact.
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
    /// `frames`: the number of states that the ring keeps, at least 1; beyond it the oldest state is dropped. Throws
    /// `Error` (invalid_value) for 0.
    explicit SnapshotRing(std::size_t frames);
    ~SnapshotRing();
    SnapshotRing(SnapshotRing&&) noexcept;
    SnapshotRing& operator=(SnapshotRing&&) noexcept;

    /// Stores the present state of the world. Throws `Error` (wrong_state) as `World::save` does; the ring then stays
    /// as it was. If memory runs out, the ring is left empty.
    void push(const World& world);
    /// Restores the world to a state that was pushed: `back` = 0 for the last one, up to `size()` - 1 for the oldest.
    /// States pushed after it are removed. Apart from that it acts like `World::restore`, also towards a command
    /// listener. Throws `Error` (invalid_value, wrong_state); world and ring then stay as they were.
    void restore(World& world, std::size_t back = 0);
    void clear(); ///< Removes all states.

    std::size_t size() const noexcept;     ///< Number of states in the ring.
    std::size_t capacity() const noexcept; ///< Greatest number of states, as given to the constructor.
    /// Memory of one state, bytes: for the last state (`back` = 0) its full size, for the others that of the stored
    /// difference. Definitions, which many states share, are not included. Throws `Error` (invalid_value) unless `back`
    /// < `size()`.
    std::size_t bytes(std::size_t back) const;

  private:
    struct Ring;
    std::unique_ptr<Ring> ring_;
};

} // namespace cairn
