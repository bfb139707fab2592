/// \file commands.h
/// Commands: the calls that change a world, encoded as bytes. A listener receives them, and `World::execute` repeats
/// them. Recordings (docs/recordings.md) and undo (history.h) are built on them.
#pragma once

#include <cairn/shape.h>
#include <cairn/snapshot.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace cairn {

class World;

/// Receives every change of a world (`World::set_command_listener`).
class CommandListener {
  public:
    virtual ~CommandListener() = default;
    /// Called just before a change is made: its arguments have been checked, and only a lack of memory can still
    /// prevent it. `command` is the call with its arguments, encoded as `command_encoding` describes, and valid until
    /// this function returns. An exception that this function throws reaches the caller of the change, and the world
    /// stays as it was. The world must not be changed from here.
    virtual void on_command(std::span<const std::byte> command) = 0;
    /// Called after each step; `on_command` was called before it.
    virtual void on_step(const World&) noexcept {}
    /// Returns the number by which commands refer to this Hull, Mesh or HeightField, and by which a `CommandSource`
    /// finds it again. The number stands for the geometry only: commands hold the other members of the shape (the
    /// rounding of a hull), and `World::execute` applies them.
    virtual std::uint64_t number_of(const Shape& shape) = 0;
    /// Returns the number by which commands refer to this snapshot.
    virtual std::uint64_t number_of(const Snapshot& snapshot) = 0;
};

/// Supplies `World::execute` with the shapes and snapshots to which commands refer by number.
class CommandSource {
  public:
    virtual ~CommandSource() = default;
    /// The Hull, Mesh or HeightField with that number. Throws `Error` (invalid_file) if there is none.
    virtual const Shape& shape(std::uint64_t number) = 0;
    /// The snapshot with that number. Throws `Error` (invalid_file) if there is none.
    virtual const Snapshot& snapshot(std::uint64_t number) = 0;
};

/// A description of the encoding of commands, as JSON: the rules, the numbers of the calls, and the types of their
/// arguments. Builds of other versions can read commands of this one as long as they know the calls.
std::string_view command_encoding() noexcept;

/// Encodes shapes in the same way as commands do, for programs that store snapshots (`SnapshotDefinitions::shapes`) in
/// files.
std::vector<std::byte> encode_shapes(std::span<const Shape> shapes, CommandListener& numbers);
/// Decodes what `encode_shapes` returned. Throws `Error` (invalid_file, unsupported) for other bytes.
std::vector<Shape> decode_shapes(std::span<const std::byte> bytes, CommandSource& source);

/// The name of the call that a command encodes, such as "World::create_body"; empty if this build does not know it.
std::string_view command_name(std::span<const std::byte> command) noexcept;

/// Four sums, over all bodies, of hashes of position, rotation and velocities. Worlds with different sums differ. If
/// they differ in one or two bodies only, `World::bodies_that_differ` can tell which from the sums.
struct StateDigest {
    std::array<std::uint64_t, 4> sums{}; ///< Each below 2^61 - 1.
    friend bool operator==(const StateDigest&, const StateDigest&) = default;
};

} // namespace cairn
