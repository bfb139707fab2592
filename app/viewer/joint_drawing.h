/// \file joint_drawing.h
/// Joints as strokes: their anchors, axes, limits and where they stand.
#pragma once

#include "viewer/render_frame.h"

#include <optional>
#include <span>

namespace cairn::viewer {

/// True for a joint that is drawn (`FrameOptions::joints`), and so can be picked.
bool is_shown(const JointLayout& joint, const JointState& state, const WorldLayout& layout,
              const FrameOptions& options);

/// Adds strokes and veils for those of `motion.joints` that are shown to the frame. `bodies`: the transforms of the
/// layout's bodies, as drawn.
///
/// Anchors are dots, with thin strokes to the bodies that they belong to. A hinge has its axis and a sector from the
/// lower to the upper limit with a hand at the present angle; a slider its way with a stop at each limit; a ball joint
/// its cone; a distance its line (a spring a coiled one); a servo a cross at its target; gears their circles; a pulley
/// its rope. The color is that of `joint_color`; the selected joint is white and bolder.
void draw_joints(RenderFrame& frame, const WorldLayout& layout, const WorldMotion& motion,
                 std::span<const Transform> bodies, const FrameOptions& options);

/// From calm blue to yellow by the share of its break force that a joint bears; red where it does not hold what it
/// should: apart by more than a twentieth of `reach` (of its bodies), or turned by more than 0.1 rad.
Vec3 joint_color(const JointLayout& joint, const JointState& state);

/// From where strokes are seen.
struct StrokeView {
    Vec3 eye, forward;                      ///< Relative to the frame's origin; unit.
    float pixel = 0.001f;                   ///< The height of a pixel at a distance of one, in meters.
    std::optional<float> parallel_distance; ///< Where rays are parallel: everything is as large as at this distance.
};

/// The triangles of a stroke, three points each: a flat band that faces the eye, or a disk. All relative to the
/// frame's origin.
void add_band(std::vector<Vec3>& triangles, const Stroke& stroke, const StrokeView& view);

} // namespace cairn::viewer
