/// \file commands.h
/// The changes of a world as bytes: who is told of them, and how they are made again. Recordings and undoing are made
/// of these.
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

/// Is told of every change of a world (`World::set_command_listener`).
class CommandListener {
  public:
    virtual ~CommandListener() = default;
    /// A change is about to be made: its arguments were checked, and nothing but running out of memory can stop it.
    /// `command` is the call with its arguments (`command_encoding`), valid until this returns. What this throws
    /// reaches the caller, and the world stays as it was. The world must not be changed from here.
    virtual void on_command(std::span<const std::byte> command) = 0;
    /// A step has been made, of which `on_command` was told before.
    virtual void on_step(const World&) noexcept {}
    /// The number under which a command shall name this Hull, Mesh or HeightField: that by which a `CommandSource`
    /// finds it again. `World::execute` adds what the shape has beside its geometry (the rounding of a hull).
    virtual std::uint64_t number_of(const Shape& shape) = 0;
    /// The number under which a command shall name this snapshot.
    virtual std::uint64_t number_of(const Snapshot& snapshot) = 0;
};

/// Where `World::execute` finds what commands name by a number.
class CommandSource {
  public:
    virtual ~CommandSource() = default;
    /// The Hull, Mesh or HeightField of that number. Throws `Error` (invalid_file) if there is none.
    virtual const Shape& shape(std::uint64_t number) = 0;
    /// The snapshot of that number. Throws `Error` (invalid_file) if there is none.
    virtual const Snapshot& snapshot(std::uint64_t number) = 0;
};

/// How commands are encoded, as JSON: rules, calls by their numbers, and the types of their arguments. A build of
/// another version reads what this one writes, as long as it knows the calls.
std::string_view command_encoding() noexcept;

/// Shapes as in commands, for who keeps snapshots (`SnapshotDefinitions::shapes`) in files.
std::vector<std::byte> encode_shapes(std::span<const Shape> shapes, CommandListener& numbers);
/// The shapes of `encode_shapes`. Throws `Error` (invalid_file, unsupported) if it is none of its results.
std::vector<Shape> decode_shapes(std::span<const std::byte> bytes, CommandSource& source);

/// The call that a command is, such as "World::create_body"; empty if it is none that this build knows.
std::string_view command_name(std::span<const std::byte> command) noexcept;

/// Four sums over all bodies of a hash of place, rotation and velocities. Worlds with other sums are not the same; from
/// the sums of one, the other can tell in which bodies they differ, if these are one or two.
struct StateDigest {
    std::array<std::uint64_t, 4> sums{}; ///< Each below 2^61 - 1.
    friend bool operator==(const StateDigest&, const StateDigest&) = default;
};

} // namespace cairn
