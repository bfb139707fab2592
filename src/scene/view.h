// Cameras and lights of glTF files: the initial view and the illumination of a scene.
#pragma once

#include "scene/json_value.h"
#include "scene/node_transform.h"
#include "scene/scene.h"

namespace cairn::scene {

// Reads the camera of a node, if there is none yet, and its light. `map` is the pose of the node in the world. Returns
// whether it read a camera, whose target is preliminarily one meter in front of it.
bool read_view(const Value& document, const Value& node, const Affine& map, SceneInfo& info);

// Moves the camera's target along its axis to the point nearest to the middle of the moving bodies.
void aim_camera(const World& world, Camera& camera);

} // namespace cairn::scene
