// Reads and writes joints of KHR_physics_rigid_bodies, and CAIRN_joint, the extension object on them for properties
// that the draft cannot express.
#pragma once

#include "scene/json_value.h"
#include "scene/scene.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace cairn::scene {

// How many limits and drives that are not plain locks a GeneralJoint may have.
inline constexpr int max_free_rows = 8;
int free_rows(const GeneralJoint& joint);

class JointTable {
  public:
    JointTable(const Value& document, std::vector<std::string>& warnings); // reads and checks all entries
    // Returns the definition of a joint except its name, its bodies and frames, and whether the bodies collide.
    const JointDef& joint(const Value& index) const;
    bool empty() const { return joints_.empty(); }

  private:
    std::optional<Value> entries_;
    std::vector<JointDef> joints_;
};

// The result has a member "extensions" only if it needs CAIRN_joint.
nlohmann::ordered_json write_joint(const JointDef& joint);

} // namespace cairn::scene
