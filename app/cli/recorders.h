// All that `cairn run` writes while it runs.
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

// Whether a moment is told to be written, of those at the start and after each step. Times are sums of steps.
bool is_in_window(const RunOptions& options, double time, double time_step);

class Recorders {
  public:
    // `scene`: as it begins. `resumed`: where a checkpoint is gone on from; the table is gone on with then, and what
    // cannot be is told to begin there. Throws Error (`TableWriter`).
    Recorders(const RunOptions& options, const scene::Scene& scene, const checkpoint::Moment* resumed);

    // Before the first step of this program, and after each.
    void add(const World& world, std::uint64_t step, float time_step);
    // How far the table is written; none if nobody can go on with it. Throws Error (io).
    std::optional<checkpoint::TableProgress> table_progress();

    void finish(const scene::Scene& scene);

  private:
    void open_table(const scene::Scene& scene);
    void tell_late_beginnings() const;

    const RunOptions& options_;
    const checkpoint::Moment* resumed_;
    bool is_table_resumed_ = false, is_table_resumable_ = false;
    std::unique_ptr<TrajectoryWriter> csv_;
    std::unique_ptr<PictureRecorder> pictures_;
    std::optional<scene::AnimationBaker> animation_;
};

} // namespace cairn::cli
