// Warns of members of a file that no reader uses, most likely misspelled.
#pragma once

#include "scene/json_value.h"

#include <optional>
#include <string>
#include <vector>

namespace cairn::scene {

// Warns of every member of `object` that is not among `known`, with the most similar known name. `extensions`, `extras`
// and `name` are always known.
void warn_of_unknown_members(const Value& object, const std::vector<std::string>& known,
                             std::vector<std::string>& warnings);

// Checks all objects of the extensions that are read, except CAIRN_world and CAIRN_joint, which have their own checks;
// and the names of extensions.
void check_spelling(const Value& document, const std::optional<Value>& scene, std::vector<std::string>& warnings);

} // namespace cairn::scene
