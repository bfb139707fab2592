// Checks that apply to every reading of a glTF document, whether a world is built from it or only its title is read.
#pragma once

#include "scene/json_value.h"

#include <optional>
#include <string>
#include <vector>

namespace cairn::scene {

// The names of the glTF extensions that are read.
const std::vector<std::string>& understood_extensions();

// Checks the version of the format, and that every extension that the file requires is either known or irrelevant here.
void check_document(const Value& document);

// Returns the scene to be shown: the one that the member `scene` names, else the first; empty if the file has none.
std::optional<Value> default_scene(const Value& document);

// Returns the extension object of that name on a node, a scene or any other object.
std::optional<Value> extension(const Value& owner, const char* name);

// Returns the element of `array` that `index` refers to; an absent array counts as empty. `what` names the elements in
// messages.
Value element(const std::optional<Value>& array, const Value& index, std::size_t limit, const char* what);

} // namespace cairn::scene
