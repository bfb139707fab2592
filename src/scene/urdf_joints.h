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

// The links that fixed joints connect: one body. Its frame is that of the first link.
struct RobotPart {
    struct Member {
        urdf::LinkConstSharedPtr link;
        Rigid at; // in the frame of the part
    };
    std::vector<Member> links;
    Rigid world;                     // pose of the part
    bool is_world = false;           // the part does not move
    BodyId body;                     // null: the world, without any shape
    std::size_t scenery = 0;         // the number of its first shapes that come from the link `world`
    urdf::JointConstSharedPtr joint; // the joint to its parent; none for the root
    std::size_t parent = 0;          // the part on the other side of the joint
    Rigid frame;                     // of the joint, in the frame of the parent
};

// The initial positions of joints: 0, or the nearest position within their limits.
class RobotPose {
  public:
    RobotPose(const urdf::ModelInterface& model, const std::string& name) : model_(model), name_(name) {}
    // Returns the displacement of the child at the joint's position, in the frame of the joint.
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
