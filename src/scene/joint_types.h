// Joint types that the draft lacks: as CAIRN_joint writes them, and their nearest equivalents in the draft.
#pragma once

#include "scene/json_value.h"

#include <cairn/joint.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace cairn::scene {

// Reads the joint that CAIRN_joint describes. `own` must have a member "type".
Joint read_typed_joint(const Value& own);

// Warns of members that the joint type does not have.
// `write_typed_joint` returns the members of CAIRN_joint; none for a GeneralJoint. Members with default values are left
// out.
void warn_of_unknown_joint_members(const Value& own, std::vector<std::string>& warnings);

nlohmann::ordered_json write_typed_joint(const Joint& joint);

// Returns limits and drives with the same effect, as far as the draft can express it.
GeneralJoint nearest_general_joint(const Joint& joint);

} // namespace cairn::scene
