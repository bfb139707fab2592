// Checkpoints of a run in a folder, each in a folder of its own, `step_N`: a part written by each of the processes
// (ranks) that run together, and an index (checkpoint/index.h), written last. What was begun and not finished has no
// index. Any other number of ranks reads it.
#pragma once

#include "checkpoint/index.h"

#include <cairn/communicator.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cairn::checkpoint {

struct Checkpoint {
    Moment moment;
    std::vector<std::vector<std::byte>> sections;
    std::filesystem::path place; // its folder
};

// Reads the last whole checkpoint of a folder; none if there is not one step_N in it. Each rank reads its share of the
// parts and sends it to the others. `tell` gets a line, on one rank, for each that is passed over: not finished, cut
// off, damaged, not readable. `ranks`: null, if there is one. Throws Error: io, if the folder cannot be read;
// invalid_file, if none of the checkpoints is whole; wrong_state, if the last one is of another run.
std::optional<Checkpoint> read_last(const std::filesystem::path& folder, const Identity& identity, Communicator* ranks,
                                    const std::function<void(const std::string&)>& tell);

// All of its members are called by all ranks at a time. What one of them throws, the others are not told: the program
// ends them.
class Writer {
  public:
    // Makes the folder if it is missing, and keeps others from writing there. `keep`: how many checkpoints, at least 1.
    // Throws Error: io; wrong_state, if another program writes there.
    Writer(std::filesystem::path folder, Identity identity, Communicator* ranks, int keep);
    ~Writer();
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    // The same on all ranks, of which each writes an equal share. Once it is whole, checkpoints of earlier steps but
    // for `keep` - 1 are removed. Throws Error: io; wrong_state on a rank whose first section begins otherwise than
    // that of the first rank (a snapshot begins with checksums of all that follows).
    void write(const Moment& moment, std::span<const std::span<const std::byte>> sections);
    double part_seconds() const { return part_seconds_; } // of the processor, for all parts of this rank so far

  private:
    bool is_first() const { return rank_ == 0; }
    void compare(std::span<const std::byte> section) const;
    std::vector<Part> gather(const Part& own) const;
    void finish(const Index& index, const std::filesystem::path& place) const;
    void remove_older(std::uint64_t step) const;

    std::filesystem::path folder_;
    Identity identity_;
    Communicator* ranks_;
    int rank_ = 0, size_ = 1, keep_;
    int lock_ = -1; // the folder, open; of the first rank
    double part_seconds_ = 0.0;
};

// The steps of the checkpoints in a folder, finished or not, the last first. Throws Error (io); a folder that is not
// there has none.
std::vector<std::uint64_t> steps_in(const std::filesystem::path& folder);

} // namespace cairn::checkpoint
