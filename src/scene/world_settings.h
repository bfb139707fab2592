// CAIRN_world, the extension object of a glTF scene for what the Khronos drafts lack: the settings of the world, its
// force fields, and information about the scene.
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

// Unknown members are ignored with a warning, so that a misspelling does not go unnoticed.
WorldSettings read_world_settings(const Value& settings, std::vector<std::string>& warnings);

// Reads the title and the hint only, for lists of scenes.
void read_title(const Value& settings, SceneInfo& info);

nlohmann::ordered_json write_world_settings(const WorldDef& world, const SceneInfo& info);

} // namespace cairn::scene
