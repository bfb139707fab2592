/// \file joint_layout.h
/// The data of a world's joints that drawing and panels need, copied like that of bodies (world_state.h).
#pragma once

#include <cairn/cairn.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace cairn::viewer {

struct JointAppearance;
struct WorldLayout;

struct JointLayout {
    JointId id;
    JointDef def;
    std::optional<std::size_t> body_a, body_b; ///< Indices into `WorldLayout::bodies`; absent: the world.
    float reach = 1.0f;        ///< Size of the smaller of its moving bodies, meters; drawings scale with it.
    std::optional<Vec3> color; ///< Linear color of the string that the scene draws for it; absent: none.
};

/// All joints of a world except `hidden`. Entries of `strings` for joints that no longer exist are ignored.
std::vector<JointLayout> read_joints(const World& world, const WorldLayout& layout, JointId hidden = {},
                                     std::span<const JointAppearance> strings = {});

/// The two joint frames in the world, given the transforms of the layout's bodies.
struct JointFrames {
    Transform a, b;
};
JointFrames frames_of(const JointLayout& joint, std::span<const Transform> bodies);

} // namespace cairn::viewer
