// All files that `cairn run` writes during a run.
#pragma once

#include "cli/commands.h"
#include "cli/pictures.h"
#include "cli/trajectory_writer.h"

#include "checkpoint/index.h"
#include "scene/animation.h"
#include "scene/scene.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace cairn::cli {

// Whether a moment, at the start or after a step, is within the range to be written. Times are sums of steps.
bool is_in_window(const RunOptions& options, double time, double time_step);

class Recorders {
  public:
    // `scene`: in its initial state. `resumed`: the checkpoint to resume from, if any; the table is then continued, and
    // a warning says that outputs that cannot be continued begin there. Throws Error (`TableWriter`).
    Recorders(const RunOptions& options, const scene::Scene& scene, const checkpoint::Moment* resumed);

    // To be called before the first step of this process, and after each step.
    void add(const World& world, std::uint64_t step, float time_step);
    // The written extent of the table; empty if the table cannot be resumed. Throws Error (io).
    std::optional<checkpoint::TableProgress> table_progress();

    void finish(const scene::Scene& scene);

  private:
    void open_table(const scene::Scene& scene);
    void warn_late_outputs() const;

    const RunOptions& options_;
    const checkpoint::Moment* resumed_;
    bool is_table_resumed_ = false, is_table_resumable_ = false;
    std::unique_ptr<TrajectoryWriter> csv_;
    std::unique_ptr<PictureRecorder> pictures_;
    std::optional<scene::AnimationBaker> animation_;
};

} // namespace cairn::cli
