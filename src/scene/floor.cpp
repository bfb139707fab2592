#include "scene/scene.h"

#include <algorithm>
#include <cmath>

namespace cairn::scene {

void add_floor(Scene& scene) {
    double lowest = 0.0;
    bool is_first = true;
    for (const BodyId id : scene.world.bodies()) {
        for (const ShapeId shape : scene.world.body(id).shapes()) {
            const double bottom = scene.world.shape_bounds(shape).min.y;
            if (!std::isfinite(bottom) || scene.world.shape_def(shape).is_trigger) continue;
            lowest = is_first ? bottom : std::min(lowest, bottom);
            is_first = false;
        }
    }
    const BodyId floor =
        scene.world.create_body({.type = BodyType::static_, .position = {0.0, lowest, 0.0}, .name = "floor"});
    scene.world.add_shape(floor, Plane{});
}

} // namespace cairn::scene
