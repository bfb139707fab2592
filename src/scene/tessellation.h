// Shapes as triangles to look at.
#pragma once

#include "scene/scene.h"

namespace cairn::scene {

// In the shape's frame, with normals where the shape is round or the faces of a solid should look flat. Infinite planes
// are squares of 200 m, strips as long, and double-sided ones can be seen from both sides.
Surface tessellate(const Shape& shape);

} // namespace cairn::scene
