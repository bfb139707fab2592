// Scenes as worlds of Cairn: of those that are measured, and of those that are saved.
#pragma once

#include "bench/scenes.h"

#include <cairn/cairn.h>

namespace cairn::bench {

// What a scene asks of a world; all else is Cairn's default, except that nothing falls asleep.
WorldDef world_settings(const Scene& scene);

enum class Walls {
    boxes,      // as they are
    rectangles, // of a part with Part::inner_face that face alone
};

// Adds the scene's bodies to a world, in their order, and its joints.
std::vector<BodyId> add_bodies(const Scene& scene, World& world, Walls walls);

} // namespace cairn::bench
