// The header of a snapshot's bytes, before the state.
#pragma once

#include "core/hash.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace cairn {

inline constexpr std::uint64_t snapshot_magic = 0x34316e7269616321ull; // "!cairn14"

struct SnapshotHeader {
    std::uint64_t magic = 0, layout = 0;
    std::uint64_t definitions = 0;                                       // hash of the definitions' bytes
    std::uint64_t checksum = 0;                                          // of the header and all bytes after it
    std::uint64_t bodies = 0, contacts = 0, joints = 0, broad_phase = 0; // bytes
};

// World number written by `without_world`. The definitions begin with the world number (4 bytes), and nothing else in a
// snapshot depends on it.
inline constexpr std::uint32_t least_world = 1;

inline std::uint64_t hash_of(const std::vector<std::byte>& bytes) {
    Hash64 sum;
    sum.add_bytes(bytes.data(), bytes.size());
    return sum.value();
}

// Computed in four independent parts, since each word of a part has to wait for the one before it.
inline std::uint64_t checksum_of(SnapshotHeader header, const std::vector<std::byte>& snapshot) {
    std::array<Hash64, 4> parts;
    header.checksum = 0;
    parts[0].add_bytes(&header, sizeof header);
    const std::byte* const data = snapshot.data() + sizeof header;
    const std::size_t size = snapshot.size() - sizeof header, part = size / 32; // words of 8 bytes
    for (std::size_t i = 0; i < part; ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
            std::uint64_t word;
            std::memcpy(&word, data + 8 * (k * part + i), 8);
            parts[k].add(word);
        }
    }
    parts[3].add_bytes(data + 32 * part, size - 32 * part);
    Hash64 sum;
    for (const Hash64& hash : parts) sum.add(hash.value());
    return sum.value();
}

} // namespace cairn
