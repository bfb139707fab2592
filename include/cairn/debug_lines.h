/// \file debug_lines.h
/// Lines that show the contents of a world, for programs with their own renderer.
#pragma once

#include <cairn/math.h>

namespace cairn {

/// What `World::debug_lines` shows.
struct DebugLinesDef {
    /// Edges of shapes; an infinite plane is shown as a grid of 20 m. The color tells whether a body is static,
    /// kinematic, awake or asleep; triggers have a color of their own.
    bool shapes = true;
    bool bounds = false; ///< Axis-aligned bounding boxes of shapes; infinite planes have none.
    /// Principal axes of inertia at the centers of mass of dynamic bodies: x red, y green, z blue.
    bool centers = false;
    bool velocities = false; ///< From the center of mass of each moving body to where its velocity brings it in 0.1 s.
    bool contacts = true;    ///< The normal at each contact point.
    /// From the centers of mass of both bodies to their anchors, and the axes of the joint at the anchor of A.
    bool joints = true;
    float size = 0.2f; ///< m, > 0: length of axes and normals.
    /// m/(N s), >= 0. If > 0, the length of a normal is this times the normal impulse of its contact point in the last
    /// step.
    float impulse_scale = 0.0f;
};

/// A straight line.
struct DebugLine {
    Position begin, end; ///< m, in world space.
    Vec3 color;          ///< Red, green and blue, 0 to 1.
};

} // namespace cairn
