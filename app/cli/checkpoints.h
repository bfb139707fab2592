// Checkpoints of `cairn run`: when one is due, its content, and resuming from the last one.
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

// Checkpoint statistics of a run's summary.
struct CheckpointCount {
    std::uint64_t written = 0, last_step = 0;
    double bytes = 0.0;            // total of all checkpoints, of all ranks
    double seconds = 0.0;          // total wall-clock time, including waits for other ranks
    double saving_seconds = 0.0;   // total CPU time for the snapshots, which each rank makes in full
    double own_part_seconds = 0.0; // total CPU time for writing the parts of this rank
};

class Checkpoints {
  public:
    // `scene`: before its first step, with all options applied. Creates the folder for new checkpoints. Throws Error:
    // io; wrong_state, if the folder has checkpoints that the run does not resume from.
    Checkpoints(const RunOptions& options, const Ranks& ranks, const scene::Scene& scene);

    // The checkpoint to resume from, if requested and available. Throws Error (`checkpoint::read_last`).
    const std::optional<checkpoint::Checkpoint>& last() const { return last_; }
    // Step number at which the run starts or resumes.
    std::uint64_t first_step() const { return last_ ? last_->moment.step : 0; }
    // Restores the checkpoint's state, and frees its bytes. Throws Error (invalid_file).
    void restore(World& world, std::optional<JointTargets>& targets);

    bool is_written() const { return writer_ != nullptr; }
    // Whether a checkpoint is due after that many steps. Ranks may differ; the result of rank 0 decides.
    bool is_due(std::uint64_t step) const;
    // Writes a checkpoint; collective over all ranks, at most once per step. `moment`: filled in by the caller except
    // for values from the world. Throws Error (`checkpoint::Writer`).
    void write(const World& world, const std::optional<JointTargets>& targets, checkpoint::Moment moment);

    const CheckpointCount& count() const { return count_; }

  private:
    void require_new_folder() const;

    const RunOptions& options_;
    std::shared_ptr<CountingCommunicator> communicator_; // separate from that of the steps, so that messages do not mix
    std::shared_ptr<const SnapshotDefinitions> definitions_; // of the initial scene
    checkpoint::Identity identity_;
    std::optional<checkpoint::Checkpoint> last_;
    std::unique_ptr<checkpoint::Writer> writer_;
    std::uint64_t last_step_ = 0; // step number of the last checkpoint written or read
    std::chrono::steady_clock::time_point last_time_;
    CheckpointCount count_;
};

// A summary line; empty if no checkpoint was written.
std::string describe(const CheckpointCount& count, const RunOptions& options);

} // namespace cairn::cli
