/// \file pane.h
/// The same scene with other settings, beside the run that commands change: all that is done to that one is done to it,
/// too, at the same time of the scene.
#pragma once

#include "viewer/side_run.h"
#include "viewer/timeline.h"

#include <cairn/world.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace cairn::viewer {

/// What differs in a pane.
struct PaneSettings {
    float step_length = 1.0f / 60.0f; ///< s, > 0.
    int substeps = 6;                 ///< Exactly so many, whatever the scene asks for.
    Integrator integrator = Integrator::semi_implicit_euler;
    std::optional<float> friction; ///< Static and dynamic, of all surfaces; none: what the scene gives them.
    friend bool operator==(const PaneSettings&, const PaneSettings&) = default;
};
inline constexpr std::size_t most_panes = 4; ///< The first included, which is the run that commands change.
/// `may_be_more`: of substeps, where they are needed.
std::string describe(const PaneSettings& settings, bool may_be_more = false);

/// What there is to see of a pane.
struct PaneState {
    PaneSettings settings;
    RunPicture picture;
    double energy = 0.0; ///< J, kinetic and potential.
    RunDifference difference;
    std::string trouble; ///< What could not be repeated; empty: nothing.
};

/// The moment from which panes go on, and the world then.
struct PaneStart {
    Snapshot snapshot;
    Moment moment;
};

class Pane {
  public:
    /// `first_step_length`: of the run that it accompanies.
    Pane(const PaneStart& start, int threads, float first_step_length, const PaneSettings& settings,
         const Looks& looks);

    const PaneSettings& settings() const { return settings_; }
    /// Goes to the moment at which the other run is, or as near as it gets in about so many seconds of real time.
    /// Before the start of the panes it stands at that.
    bool go_to(Timeline& first, double seconds, const Looks& looks);
    /// From that moment on, what was done to the other run is no longer what was done.
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
    Moment start_, done_;                         // of the other run: what came before `done_` is repeated
    std::uint64_t step_ = 0;                      // own steps since the start
    std::map<std::uint64_t, Keyframe> keyframes_; // by own steps
    bool is_stale_ = false;                       // what it has done is no longer what was done
    std::string trouble_;
    MeshCache meshes_;
    std::shared_ptr<const std::vector<JointLayout>> joints_;
    RunPicture picture_;
};

} // namespace cairn::viewer
