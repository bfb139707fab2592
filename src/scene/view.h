// Cameras and lights of glTF files: where a scene is first looked at from, and what shines on it.
#pragma once

#include "scene/json_value.h"
#include "scene/node_transform.h"
#include "scene/scene.h"

namespace cairn::scene {

// Takes the camera of a node if there is none yet, and its light.
// `map`: of the node in the world. Returns whether it took a camera, which looks at a point a meter before it.
bool read_view(const Value& document, const Value& node, const Affine& map, SceneInfo& info);

// Lets a camera that has a direction look at the point of its axis that is nearest to the middle of what moves.
void aim_camera(const World& world, Camera& camera);

} // namespace cairn::scene
