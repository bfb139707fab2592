// CAIRN_world, the extension object of a glTF scene that holds what the Khronos drafts lack: the settings of
// the world, its force fields, and what the scene says about itself.
#pragma once

#include "scene/json_value.h"
#include "scene/scene.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace cairn::scene {

struct WorldSettings {
    WorldDef world;
    SceneInfo info;
};

// Members that are not known are left out with a warning, so that a slip of the pen does not go unnoticed.
WorldSettings read_world_settings(const Value& settings, std::vector<std::string>& warnings);

// The title and the hint alone, for lists.
void read_title(const Value& settings, SceneInfo& info);

nlohmann::ordered_json write_world_settings(const WorldDef& world, const SceneInfo& info);

} // namespace cairn::scene
