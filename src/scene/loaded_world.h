// Creates the world that a file is read into.
#pragma once

#include "scene/scene.h"

namespace cairn::scene {

// The command listener, if any, is set before anything is added, so that it receives all commands that build the world.
inline World loaded_world(const WorldDef& def, const LoadOptions& options) {
    World world(def);
    if (options.listener) world.set_command_listener(options.listener);
    return world;
}

} // namespace cairn::scene
