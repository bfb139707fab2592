// Members of a file that nobody reads: most likely misspelled, and said so.
#pragma once

#include "scene/json_value.h"

#include <optional>
#include <string>
#include <vector>

namespace cairn::scene {

// Warns of every member of `object` that is not among `known`, with the nearest of those. `extensions`, `extras` and
// `name` are always known.
void warn_of_unknown_members(const Value& object, const std::vector<std::string>& known,
                             std::vector<std::string>& warnings);

// Goes through all objects of the extensions that are read, but CAIRN_world and CAIRN_joint, which see to themselves;
// and through the names of extensions.
void check_spelling(const Value& document, const std::optional<Value>& scene, std::vector<std::string>& warnings);

} // namespace cairn::scene
