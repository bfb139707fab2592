// Benchmark scenes as Cairn worlds: for measurements, and for saving.
#pragma once

#include "bench/scenes.h"

#include <cairn/cairn.h>

namespace cairn::bench {

// The settings that a scene requires; everything else is Cairn's default, except that bodies never sleep.
WorldDef world_settings(const Scene& scene);

enum class Walls {
    boxes,      // boxes as in the scene
    rectangles, // for a part with Part::inner_face only that face
};

// Adds the scene's bodies to a world in their order, and its joints.
std::vector<BodyId> add_bodies(const Scene& scene, World& world, Walls walls);

} // namespace cairn::bench
