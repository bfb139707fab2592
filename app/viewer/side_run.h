/// \file side_run.h
/// Another run of the scene beside the one that commands change: a world with a timeline of its own, which is taken to
/// whatever moment that one is at.
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

/// Of keys and drags: what exists in a world only as long as they are held.
struct Held {
    std::variant<JointId, ForceFieldId> id;
    Moment since;
};
/// Removes from a world what of these it has.
void end_held(World& world, std::span<const Held> held);

/// What there is to see of a run.
struct RunPicture {
    std::shared_ptr<const WorldLayout> layout;
    std::shared_ptr<const WorldMotion> previous, current;
};

/// What a scene's bodies look like beside what they are.
struct Looks {
    std::span<const Appearance> appearances;
    std::span<const Visual> visuals;
    std::span<const JointAppearance> strings;
};

class SideRun {
  public:
    /// A copy of a world as it stands, with the same past and the same known future. `held`: what ends when that future
    /// does, as nobody holds it here.
    SideRun(const World& world, const Timeline& timeline, std::vector<Held> held, float step_length,
            const Looks& looks);

    World world;
    Timeline timeline;
    std::vector<Held> held;

    /// Goes to the moment after so many steps, or as near as it gets in about so many seconds of real time: follows
    /// what is known, and beyond it steps on with nobody's help. True: it is there. Throws what the world's calls
    /// throw.
    bool go_to(std::uint64_t step, double seconds, const Looks& looks);
    bool is_at(std::uint64_t step) const { return timeline.now().step == step; }
    /// Bodies may have come, gone or changed.
    void refresh(const Looks& looks);
    const RunPicture& picture() const { return picture_; }

  private:
    void live_step();

    float step_length_;
    MeshCache meshes_;
    RunPicture picture_;
};

/// How two runs differ at a moment.
struct RunDifference {
    std::size_t elsewhere = 0; ///< Bodies that are at another place, turned otherwise, or in one of the two alone.
    double farthest = 0.0;     ///< m: the greatest distance between the two places of a body.
    BodyId farthest_body;      ///< Null: none.
};
/// Whether a body is seen to be elsewhere: by more than a millimeter or a thousandth of a turn.
bool is_elsewhere(const Transform& a, const Transform& b);
/// The motions of the two pictures must be of their layouts.
RunDifference difference(const WorldLayout& layout, const WorldMotion& motion, const RunPicture& other);

} // namespace cairn::viewer
