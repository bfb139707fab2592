// Validation of snapshots before anything uses them: a matching checksum does not tell who made the file.
#pragma once

#include <cairn/error.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace cairn {

// A location in a snapshot, for messages: a member of an element of a list.
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

// Throws Error(invalid_file) unless the condition holds.
inline void require_sound(bool holds, SnapshotPlace place, std::int64_t value, const char* expected) {
    if (!holds) [[unlikely]]
        refuse_snapshot(place, value, expected);
}

// Checks a single number, or the number of elements of a list.
inline void require_count(const char* what, std::size_t count, std::size_t expected) {
    if (count != expected) [[unlikely]]
        throw Error(ErrorCode::invalid_file, std::string("Snapshot.") + what, std::to_string(count),
                    "must be " + std::to_string(expected) + " by the rest of the snapshot");
}

} // namespace cairn
