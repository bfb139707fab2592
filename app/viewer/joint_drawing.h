/// \file joint_drawing.h
/// Joints as strokes: their anchors, axes, limits and present positions.
#pragma once

#include "viewer/render_frame.h"

#include <optional>
#include <span>

namespace cairn::viewer {

/// Whether a joint is drawn (`FrameOptions::joints`), and so can be picked.
bool is_shown(const JointLayout& joint, const JointState& state, const WorldLayout& layout,
              const FrameOptions& options);

/// Adds strokes and veils to the frame for the shown joints of `motion.joints`. `bodies`: the transforms of the
/// layout's bodies, as drawn.
///
/// Anchors are dots, connected to their bodies by thin strokes. A hinge has its axis, and a sector from the lower to
/// the upper limit with a hand at the present angle; a slider its axis with a stop at each limit; a ball joint its
/// cone; a distance joint its line (a spring a coil); a servo a cross at its target; gears their circles; a pulley its
/// rope. The color is that of `joint_color`; the selected joint is white and bolder.
void draw_joints(RenderFrame& frame, const WorldLayout& layout, const WorldMotion& motion,
                 std::span<const Transform> bodies, const FrameOptions& options);

/// From blue to yellow by the joint's load as a share of its breaking force or torque; red where the joint is violated:
/// anchors separated by more than a twentieth of `reach` (of its bodies), or an angular error of more than 0.1 rad.
Vec3 joint_color(const JointLayout& joint, const JointState& state);

/// The viewpoint for strokes.
struct StrokeView {
    Vec3 eye, forward;    ///< Relative to the frame's origin; unit vector.
    float pixel = 0.001f; ///< Height of a pixel at a distance of one meter, in meters.
    /// With an orthographic projection: everything is as large as at this distance.
    std::optional<float> parallel_distance;
};

/// Adds the triangles of a stroke, three points each: a flat band that faces the eye, or a disk. Relative to the
/// frame's origin.
void add_band(std::vector<Vec3>& triangles, const Stroke& stroke, const StrokeView& view);

} // namespace cairn::viewer
