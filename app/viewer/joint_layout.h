/// \file joint_layout.h
/// What drawing and panels need to know of a world's joints, copied out of it as its bodies are (world_state.h).
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
    float reach = 1.0f;        ///< Meters: how far the smaller of its moving bodies reaches; drawings are of that size.
    std::optional<Vec3> color; ///< Linear, of the string by which the scene shows it; absent: it does not.
};

/// All joints of a world but `hidden`. Entries of `strings` for joints that no longer exist are ignored.
std::vector<JointLayout> read_joints(const World& world, const WorldLayout& layout, JointId hidden = {},
                                     std::span<const JointAppearance> strings = {});

/// The two frames of a joint in the world, given the transforms of the layout's bodies.
struct JointFrames {
    Transform a, b;
};
JointFrames frames_of(const JointLayout& joint, std::span<const Transform> bodies);

} // namespace cairn::viewer
