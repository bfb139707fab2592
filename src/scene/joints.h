// Joints of KHR_physics_rigid_bodies, read and written.
#pragma once

#include "scene/json_value.h"
#include "scene/scene.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace cairn::scene {

// Limits and drives alone: an entry of physicsJoints.
struct JointRules {
    std::vector<JointLimit> limits;
    std::vector<JointDrive> drives;
};

class JointTable {
  public:
    explicit JointTable(const Value& document); // reads and checks all entries
    const JointRules& rules(const Value& index) const;
    bool empty() const { return rules_.empty(); }

  private:
    std::optional<Value> entries_;
    std::vector<JointRules> rules_;
};

nlohmann::ordered_json write_joint_rules(const JointDescription& joint);

} // namespace cairn::scene
