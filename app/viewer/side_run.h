/// \file side_run.h
/// A second run of the scene beside the one that commands change: a world with a timeline of its own, kept at the same
/// step as the main run.
#pragma once

#include "viewer/timeline.h"
#include "viewer/world_state.h"

#include <cairn/world.h>

#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace cairn::viewer {

/// A joint or force field of a drag or held key: it exists in a world only as long as it is held.
struct Held {
    std::variant<JointId, ForceFieldId> id;
    Moment since;
};
/// Removes those of the held objects that exist in a world.
void end_held(World& world, std::span<const Held> held);

/// The displayed data of a run.
struct RunPicture {
    std::shared_ptr<const WorldLayout> layout;
    std::shared_ptr<const WorldMotion> previous, current;
};

/// The appearance of a scene's bodies and joints.
struct Looks {
    std::span<const Appearance> appearances;
    std::span<const Visual> visuals;
    std::span<const JointAppearance> strings;
};

class SideRun {
  public:
    /// A copy of a world in its present state, with the same past and the same known future. `held`: objects that are
    /// removed at the end of that future, because nobody holds them in this copy.
    SideRun(const World& world, const Timeline& timeline, std::vector<Held> held, float step_length,
            const Looks& looks);

    World world;
    Timeline timeline;
    std::vector<Held> held;

    /// Goes to the state after `step` steps, or as near as it gets within about `seconds` of real time: follows the
    /// known run, and beyond it continues without user input. Returns true if it has arrived. Throws what the world's
    /// calls throw.
    bool go_to(std::uint64_t step, double seconds, const Looks& looks);
    bool is_at(std::uint64_t step) const { return timeline.now().step == step; }
    /// To be called when bodies may have been added, removed or changed.
    void refresh(const Looks& looks);
    const RunPicture& picture() const { return picture_; }

  private:
    void live_step();

    float step_length_;
    MeshCache meshes_;
    RunPicture picture_;
};

/// The difference of two runs at one step.
struct RunDifference {
    /// Number of bodies with another position or rotation, or present in only one of the runs.
    std::size_t elsewhere = 0;
    double farthest = 0.0; ///< Greatest distance between the two positions of a body, m.
    BodyId farthest_body;  ///< The body at that distance; null: none.
};
/// Whether two poses of a body differ visibly: by more than a millimeter or a thousandth of a turn.
bool is_elsewhere(const Transform& a, const Transform& b);
/// Compares two runs. Each motion must belong to the layout passed with it.
RunDifference difference(const WorldLayout& layout, const WorldMotion& motion, const RunPicture& other);

} // namespace cairn::viewer
