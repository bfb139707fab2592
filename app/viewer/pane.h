/// \file pane.h
/// The same scene with other settings, shown beside the run that commands change: every change of that run is repeated
/// in the pane at the same simulated time.
#pragma once

#include "viewer/side_run.h"
#include "viewer/timeline.h"

#include <cairn/world.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace cairn::viewer {

/// The settings by which a pane differs from the main run.
struct PaneSettings {
    float step_length = 1.0f / 60.0f; ///< s, > 0.
    int substeps = 6;                 ///< Exact number of substeps; the scene's own setting is ignored.
    Integrator integrator = Integrator::semi_implicit_euler;
    std::optional<float> friction; ///< Static and dynamic friction of all surfaces; absent: the scene's values.
    friend bool operator==(const PaneSettings&, const PaneSettings&) = default;
};
/// Greatest number of panes, including the first, which is the run that commands change.
inline constexpr std::size_t most_panes = 4;
/// `may_be_more`: the substeps are a minimum, and islands may use more where needed.
std::string describe(const PaneSettings& settings, bool may_be_more = false);

/// The displayed data of a pane.
struct PaneState {
    PaneSettings settings;
    RunPicture picture;
    double energy = 0.0; ///< J, kinetic and potential.
    RunDifference difference;
    std::string trouble; ///< Changes that could not be repeated; empty: none.
};

/// The world state and moment from which the panes start.
struct PaneStart {
    Snapshot snapshot;
    Moment moment;
};

class Pane {
  public:
    /// `first_step_length`: of the main run.
    Pane(const PaneStart& start, int threads, float first_step_length, const PaneSettings& settings,
         const Looks& looks);

    const PaneSettings& settings() const { return settings_; }
    /// Goes to the present moment of the main run, or as near as it gets within about that many seconds of real time.
    /// Before the start of the panes, the pane shows its start state.
    bool go_to(Timeline& first, double seconds, const Looks& looks);
    /// Drops what follows that moment, because the main run has branched off there.
    void forget_after(const Moment& moment);
    PaneState state(const WorldLayout& layout, const WorldMotion& motion) const;
    const World& world() const { return world_; }

  private:
    struct Keyframe {
        Snapshot snapshot;
        Moment done;
    };
    std::uint64_t step_at(std::uint64_t first_step) const;
    bool repeat_changes(Timeline& first);
    void restore(std::uint64_t step, const Moment& moment);
    void take_settings();
    void read_picture(bool with_layout, const Looks& looks);

    World world_;
    PaneSettings settings_;
    float first_step_length_;
    Moment start_, done_;                         // moments of the main run: changes before `done_` have been repeated
    std::uint64_t step_ = 0;                      // own steps since the start
    std::map<std::uint64_t, Keyframe> keyframes_; // keyed by the pane's own step count
    bool is_stale_ = false;                       // the main run has branched off before the pane's present state
    std::string trouble_;
    MeshCache meshes_;
    std::shared_ptr<const std::vector<JointLayout>> joints_;
    RunPicture picture_;
};

} // namespace cairn::viewer
