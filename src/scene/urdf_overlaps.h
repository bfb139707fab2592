// Links of a robot that overlap as it is drawn.
#pragma once

#include "scene/urdf_joints.h"

namespace cairn::scene {

// Shapes that stand for more than there is, as the hull of what is hollow, overlap others of the robot where it is
// drawn: they would push each other away at once. Two parts of which shapes do so do not collide at all; one warning
// names them. What the link `world` has as shapes is no part of the robot.
void separate_overlaps(const std::string& name, const std::vector<RobotPart>& parts, Scene& scene);

} // namespace cairn::scene
