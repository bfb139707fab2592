// Checkpoints of a run in a folder. Each has a folder of its own, `step_N`, with a part written by each of the
// cooperating processes (ranks), and an index (checkpoint/index.h), written last: an unfinished checkpoint has no
// index. Any number of ranks can read it.
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
    std::filesystem::path place; // the checkpoint's folder
};

// Reads the last complete checkpoint of a folder; none if it contains no step_N. Each rank reads its share of the parts
// and sends it to the others. `tell` receives a line, on one rank, for each checkpoint that is skipped: unfinished,
// truncated, damaged or unreadable. `ranks`: null if there is only one. Throws Error: io, if the folder cannot be read;
// invalid_file, if no checkpoint is complete; wrong_state, if the last one is of another run.
std::optional<Checkpoint> read_last(const std::filesystem::path& folder, const Identity& identity, Communicator* ranks,
                                    const std::function<void(const std::string&)>& tell);

// All members are called collectively by all ranks. If one rank throws, the others are not notified: the program must
// end them.
class Writer {
  public:
    // Creates the folder if it is missing, and locks it against other writers. `keep`: the number of checkpoints to
    // keep, at least 1. Throws Error: io; wrong_state, if another program writes there.
    Writer(std::filesystem::path folder, Identity identity, Communicator* ranks, int keep);
    ~Writer();
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    // Writes a checkpoint of sections that are the same on all ranks, each of which writes an equal share. Once it is
    // complete, older checkpoints except the last `keep` - 1 are removed. Throws Error: io; wrong_state on a rank whose
    // first section begins differently from that of the first rank (a snapshot begins with checksums of all that
    // follows).
    void write(const Moment& moment, std::span<const std::span<const std::byte>> sections);
    double part_seconds() const { return part_seconds_; } // processor time for all parts of this rank so far

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
    int lock_ = -1; // file descriptor of the locked folder, on the first rank
    double part_seconds_ = 0.0;
};

// The steps of the checkpoints in a folder, complete or not, the last first. Throws Error (io); empty if the folder
// does not exist.
std::vector<std::uint64_t> steps_in(const std::filesystem::path& folder);

} // namespace cairn::checkpoint
