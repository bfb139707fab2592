// Characters in scene files: `character` of `CAIRN_body`.
#pragma once

#include "scene/json_value.h"

#include <cairn/world.h>

namespace cairn::scene {

// Makes the body a character with the settings in the file.
void read_character(const Value& here, Body body);
// Returns the settings of a character as JSON.
nlohmann::ordered_json written_character(const Body& body);

} // namespace cairn::scene
