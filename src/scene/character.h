// Characters in scene files: `character` of `CAIRN_body`.
#pragma once

#include "scene/json_value.h"

#include <cairn/world.h>

namespace cairn::scene {

// Makes the body a character as the file says.
void read_character(const Value& here, Body body);
// What the file says of a character.
nlohmann::ordered_json written_character(const Body& body);

} // namespace cairn::scene
