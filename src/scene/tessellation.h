// Shapes as triangles for display.
#pragma once

#include "scene/scene.h"

namespace cairn::scene {

// The triangles are in the shape's frame, with normals where the shape is round or the faces of a solid should look
// flat. Infinite planes are squares of 200 m, strips are as long, and double-sided planes are visible from both sides.
Surface tessellate(const Shape& shape);

} // namespace cairn::scene
