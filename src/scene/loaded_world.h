// The world that a file is read into.
#pragma once

#include "scene/scene.h"

namespace cairn::scene {

// Whoever wants to be told of all that makes the world is, from the start.
inline World loaded_world(const WorldDef& def, const LoadOptions& options) {
    World world(def);
    if (options.listener) world.set_command_listener(options.listener);
    return world;
}

} // namespace cairn::scene
