// Message formats of recordings, and names of their channels.
#pragma once

#include <cairn/commands.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace cairn::recording {

inline constexpr std::string_view topic_log = "/cairn/commands", topic_geometry = "/cairn/geometry",
                                  topic_snapshots = "/cairn/snapshots", topic_states = "/cairn/states",
                                  topic_keyframes = "/cairn/keyframes", // in files of versions before /cairn/states
    log_encoding = "cairn1";
inline constexpr std::uint64_t states_version = 1; // first field of messages of /cairn/states

// Documentation in the file itself, for readers without Cairn.
inline constexpr std::string_view parts_encoding =
    R"json({"encoding": "cairn parts, version 1",
"numbers": "LEB128; of fixed size (u32, u64) and floats: little endian",
"/cairn/commands": [
"number of steps before it",
"then again and again: size of a command, the command; after each step: 0, and the digest of the state, 4 of u64"],
"/cairn/geometry": [
"number",
"a byte: 0 hull, 1 mesh, 2 height field",
"hull: count, vertices of 3 floats in m",
"mesh: count, vertices of 3 floats in m; count, indices",
"height field: columns, rows of u32; spacing, 2 floats in m; count, heights, floats in m"],
"/cairn/snapshots": [
"number",
"number of the snapshot that has its definitions",
"size, bytes of the state",
"of one that has definitions: size, bytes, and the shapes as a list of Shape"],
"/cairn/states": [
"1, the version of what follows",
"number of steps before it",
"its number, counted from 1, and the number of another before it, or 0",
"a frame of zstd, whose prefix is what that of the other has, or nothing (as zstd --patch-from)",
"in it: size, bytes of the state; size, bytes of its definitions; the shapes as a list of Shape"]
})json";

// Size of a step command, bytes: its number, and the step length as a float.
inline constexpr std::size_t step_command_size = 5;
inline bool is_step(std::span<const std::byte> command) {
    return command.size() == step_command_size && command_name(command) == "World::step";
}
inline float step_length(std::span<const std::byte> command) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 4; ++i) bits |= std::uint32_t(command[i + 1]) << (8 * i);
    return std::bit_cast<float>(bits);
}

// Whether a command may change the appearance of a body that keeps its shapes.
inline bool changes_looks(std::span<const std::byte> command) {
    const std::string_view name = command_name(command);
    return name == "World::set_shape" || name == "World::set_shape_def" || name == "Body::set_type" ||
           name == "Body::set_name";
}

} // namespace cairn::recording
