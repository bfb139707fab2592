// Checkpoints of `cairn run`: when they are due, what is in them, and going on from the last one.
#pragma once

#include "cli/commands.h"
#include "cli/joint_targets.h"
#include "cli/ranks.h"

#include "checkpoint/folder.h"
#include "scene/scene.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace cairn::cli {

// What a run's summary says of them.
struct CheckpointCount {
    std::uint64_t written = 0, last_step = 0;
    double bytes = 0.0;            // of all, and all ranks together
    double seconds = 0.0;          // of all, with the waits for other ranks
    double saving_seconds = 0.0;   // of the processor, for the snapshots, which each rank makes whole
    double own_part_seconds = 0.0; // likewise, for the parts of this rank
};

class Checkpoints {
  public:
    // `scene`: before its first step, with all options applied. Makes the folder of those that are to be written.
    // Throws Error: io; wrong_state, if there are some already that the run does not go on with.
    Checkpoints(const RunOptions& options, const Ranks& ranks, const scene::Scene& scene);

    // The one to go on from, if that was asked for and there is one. Throws Error (`checkpoint::read_last`).
    const std::optional<checkpoint::Checkpoint>& last() const { return last_; }
    std::uint64_t first_step() const { return last_ ? last_->moment.step : 0; } // that the run goes on from
    // Puts a run where it was then, and frees the bytes of the last checkpoint. Throws Error (invalid_file).
    void restore(World& world, std::optional<JointTargets>& targets);

    bool is_written() const { return writer_ != nullptr; }
    // Whether one is due after that many steps. Ranks may differ: what the first one says counts.
    bool is_due(std::uint64_t step) const;
    // On all ranks at a time; at most once for a step. `moment`: but for what the world itself says. Throws Error
    // (`checkpoint::Writer`).
    void write(const World& world, const std::optional<JointTargets>& targets, checkpoint::Moment moment);

    const CheckpointCount& count() const { return count_; }

  private:
    void require_new_folder() const;

    const RunOptions& options_;
    std::shared_ptr<CountingCommunicator> communicator_;     // of its own: its messages are not those of steps
    std::shared_ptr<const SnapshotDefinitions> definitions_; // of the scene as it begins
    checkpoint::Identity identity_;
    std::optional<checkpoint::Checkpoint> last_;
    std::unique_ptr<checkpoint::Writer> writer_;
    std::uint64_t last_step_ = 0; // of the last that was written or read
    std::chrono::steady_clock::time_point last_time_;
    CheckpointCount count_;
};

// A line about them; empty if none was written.
std::string describe(const CheckpointCount& count, const RunOptions& options);

} // namespace cairn::cli
