// The index of a checkpoint: a small JSON file that lists its parts. A checkpoint is complete once its index exists.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::checkpoint {

// A property that must be the same when a run is continued, in the order of comparison.
struct Trait {
    std::string name, value;
    std::string difference; // the message if it differs, "was written by another version"; not in the index
};
using Identity = std::vector<Trait>;

// How much of a table has been written, for a run that continues it.
struct TableExtent {
    std::uint64_t bytes = 0;    // including the line or header that names the columns
    std::uint64_t rows = 0;     // in these bytes
    std::uint32_t columns = 0;  // checksum of that line or header, as for a table without rows
    std::uint32_t rows_crc = 0; // checksum of the rest
};

// A table as written so far.
struct TableProgress {
    std::string file;    // complete path
    std::string moments; // the moments that it contains
    TableExtent extent;
};

// The moment of a checkpoint, and data of the run so far that is not part of the state.
struct Moment {
    std::uint64_t step = 0;       // number of completed steps
    double time = 0.0;            // s
    std::uint64_t state_hash = 0; // World::state_hash
    double max_penetration = 0.0; // m, maximum over all steps
    std::optional<TableProgress> table;
};

struct Part {
    std::string file; // name; in the index's folder
    std::uint64_t bytes = 0;
    std::uint32_t crc = 0;
};

struct Index {
    Identity identity;
    Moment moment;
    std::vector<std::uint64_t> sections; // size of each, bytes; concatenated, they are divided into the parts
    std::vector<Part> parts;
};

std::string to_text(const Index& index);

// Parses an index. `place` names it in messages. Throws Error (invalid_file), also if its own checksum does not match.
Index read_index(std::string_view text, const std::string& place);

// Throws Error (wrong_state) if an index belongs to another run than `here`.
void require_same(const Identity& here, const Index& index, const std::string& place);

// The hexadecimal form of checksums in indices and messages.
std::string hex(std::uint32_t crc);

} // namespace cairn::checkpoint
