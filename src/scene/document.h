// What is the same in every reading of a glTF document, whether a world is built from it or only its title read.
#pragma once

#include "scene/json_value.h"

#include <optional>
#include <string>
#include <vector>

namespace cairn::scene {

// Names of those that are read.
const std::vector<std::string>& understood_extensions();

// Checks the version of the format, and that the file requires no extension that matters here and is unknown.
void check_document(const Value& document);

// The scene to be shown: the one named by `scene`, else the first; empty if the file has none.
std::optional<Value> default_scene(const Value& document);

// The extension object of that name on a node, a scene or anything else.
std::optional<Value> extension(const Value& owner, const char* name);

// The element of `array` (absent: of an empty one) that `index` refers to; `what` names the elements.
Value element(const std::optional<Value>& array, const Value& index, std::size_t limit, const char* what);

} // namespace cairn::scene
