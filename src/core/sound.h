// What a snapshot says must hold before anything follows it: a checksum that fits does not say who made it.
#pragma once

#include <cairn/error.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace cairn {

// Of a snapshot: a member of an element of a list, for messages.
struct SnapshotPlace {
    const char* list;
    std::size_t at;
    const char* member = "";
};

[[noreturn, gnu::noinline, gnu::cold]] inline void refuse_snapshot(SnapshotPlace place, std::int64_t value,
                                                                   const char* expected) {
    std::string field = std::string("Snapshot.") + place.list + "[" + std::to_string(place.at) + "]";
    if (*place.member != 0) field += std::string(".") + place.member;
    throw Error(ErrorCode::invalid_file, field, std::to_string(value), expected);
}

// Throws Error(invalid_file) unless it holds.
inline void require_sound(bool holds, SnapshotPlace place, std::int64_t value, const char* expected) {
    if (!holds) [[unlikely]]
        refuse_snapshot(place, value, expected);
}

// Of a number of which there is one, or of how many elements there are.
inline void require_count(const char* what, std::size_t count, std::size_t expected) {
    if (count != expected) [[unlikely]]
        throw Error(ErrorCode::invalid_file, std::string("Snapshot.") + what, std::to_string(count),
                    "must be " + std::to_string(expected) + " by the rest of the snapshot");
}

} // namespace cairn
