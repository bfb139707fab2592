// The index of a checkpoint: a small JSON file that says what its parts are. A checkpoint is whole once it is there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::checkpoint {

// What must be the same where a run goes on, in the order in which it is compared.
struct Trait {
    std::string name, value;
    std::string difference; // what it means if it is another one: "was written by another version"; not in the index
};
using Identity = std::vector<Trait>;

// How much of a table is written, for who goes on with it.
struct TableExtent {
    std::uint64_t bytes = 0;    // with the line or header that names the columns
    std::uint64_t rows = 0;     // in them
    std::uint32_t columns = 0;  // the checksum of that line or header, as of a table without rows
    std::uint32_t rows_crc = 0; // of what follows it
};

// A table that had been written so far.
struct TableProgress {
    std::string file;    // its whole path
    std::string moments; // which are in it
    TableExtent extent;
};

// When a checkpoint was made, and what is known of the run so far beside the bytes of its state.
struct Moment {
    std::uint64_t step = 0;       // how many have been made
    double time = 0.0;            // s
    std::uint64_t state_hash = 0; // World::state_hash
    double max_penetration = 0.0; // m, of all steps
    std::optional<TableProgress> table;
};

struct Part {
    std::string file; // beside the index
    std::uint64_t bytes = 0;
    std::uint32_t crc = 0;
};

struct Index {
    Identity identity;
    Moment moment;
    std::vector<std::uint64_t> sections; // how many bytes each has; one behind the other they are cut into the parts
    std::vector<Part> parts;
};

std::string to_text(const Index& index);

// `place` stands for it in messages. Throws Error (invalid_file), also where its own checksum does not fit.
Index read_index(std::string_view text, const std::string& place);

// Throws Error (wrong_state) if an index is of another run than `here`.
void require_same(const Identity& here, const Index& index, const std::string& place);

// How checksums are written in indices and messages.
std::string hex(std::uint32_t crc);

} // namespace cairn::checkpoint
