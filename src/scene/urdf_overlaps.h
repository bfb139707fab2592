// Links of a robot that overlap in its initial pose.
#pragma once

#include "scene/urdf_joints.h"

namespace cairn::scene {

// Shapes that are larger than the real part, such as the hull of a hollow mesh, may overlap other shapes of the robot
// in its initial pose, and would push each other away at once. Collision is disabled between two parts whose shapes
// overlap; one warning names the parts. Shapes of the link `world` are not part of the robot.
void disable_overlapping_collisions(const std::string& name, const std::vector<RobotPart>& parts, Scene& scene);

} // namespace cairn::scene
