// The types of joints that the draft does not have: as CAIRN_joint writes them, and as the draft comes nearest to them.
#pragma once

#include "scene/json_value.h"

#include <cairn/joint.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace cairn::scene {

// The joint that CAIRN_joint describes. It must have a member "type".
Joint read_typed_joint(const Value& own);

// Members of CAIRN_joint; none for a GeneralJoint. What has its default is left out.
// Warns of members that its type does not have.
void warn_of_unknown_joint_members(const Value& own, std::vector<std::string>& warnings);

nlohmann::ordered_json write_typed_joint(const Joint& joint);

// Limits and drives that do the same, as far as the draft has words for it.
GeneralJoint nearest_general_joint(const Joint& joint);

} // namespace cairn::scene
