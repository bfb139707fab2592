// Joints of robots.
#pragma once

#include "scene/rigid.h"
#include "scene/scene.h"

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace cairn::scene {

// Links that fixed joints hold together: one body. Its frame is that of the first of them.
struct RobotPart {
    struct Member {
        urdf::LinkConstSharedPtr link;
        Rigid at; // in the part
    };
    std::vector<Member> links;
    Rigid world;                     // of the part
    bool is_world = false;           // does not move
    BodyId body;                     // null: the world, without any shape
    std::size_t scenery = 0;         // so many of its first shapes are of the link `world`
    urdf::JointConstSharedPtr joint; // that it hangs on; none: of the root
    std::size_t parent = 0;          // the part on the other side of it
    Rigid frame;                     // of the joint, in that part
};

// Where joints stand at the start: at 0, or at the nearest position that their limits allow.
class RobotPose {
  public:
    RobotPose(const urdf::ModelInterface& model, const std::string& name) : model_(model), name_(name) {}
    // What the joint has moved its child by, in its own frame.
    Rigid motion(const urdf::Joint& joint) const;

  private:
    double position(const urdf::Joint& joint, int depth = 0) const;
    const urdf::ModelInterface& model_;
    const std::string& name_;
};

class RobotJoints {
  public:
    RobotJoints(const std::string& name, const std::vector<RobotPart>& parts, Scene& scene)
        : name_(name), parts_(parts), scene_(scene) {}
    void add();

  private:
    void add(const RobotPart& part);
    void add_mimic(const RobotPart& part);
    const RobotPart* part_of(const std::string& joint) const;

    const std::string& name_;
    const std::vector<RobotPart>& parts_;
    Scene& scene_;
};

} // namespace cairn::scene
