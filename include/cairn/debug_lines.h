/// \file debug_lines.h
/// Lines that show what a world consists of, for programs that draw it themselves.
#pragma once

#include <cairn/math.h>

namespace cairn {

/// What `World::debug_lines` shows.
struct DebugLinesDef {
    /// Edges of shapes; of infinite planes a grid of 20 m. Bodies that are static, kinematic, awake and asleep, and
    /// triggers, have colors of their own.
    bool shapes = true;
    bool bounds = false;     ///< Boxes around shapes, along the axes of the world.
    bool centers = false;    ///< The axes of inertia at the centers of mass of dynamic bodies: x red, y green, z blue.
    bool velocities = false; ///< From each center of mass of what moves to where it is in a tenth of a second.
    bool contacts = true;    ///< At each point that touches, the normal.
    bool joints = true;      ///< From both centers of mass to the anchors, and the axes of the joint there.
    float size = 0.2f;       ///< m, > 0: the length of axes, and of normals.
    float impulse_scale = 0.0f; ///< m/(N s), >= 0. Not 0: a normal is as long as this times the impulse at its point.
};

/// A straight line.
struct DebugLine {
    Position begin, end; ///< m, in world space.
    Vec3 color;          ///< Red, green and blue, 0 to 1.
};

} // namespace cairn
