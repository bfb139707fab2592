/// \file joint_info.h
/// Names of joints, of their kinds and positions, and their editable values, for lists, panels and reports.
#pragma once

#include <cairn/cairn.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::viewer {

/// "hinge", "ball" ...
const char* name_of(const Joint& joint);
const char* name_of(JointSolver solver);
inline constexpr int joint_solver_count = 3;

/// One of `JointState::positions`.
struct JointPosition {
    std::string name;
    bool is_angle = false;              ///< Radians; else meters.
    std::optional<JointRange> limits{}; ///< Range within which the joint limits it, if any.
};
/// The positions of a joint, in the order of `JointState::positions`.
std::vector<JointPosition> joint_positions(const Joint& joint);

/// A `JointControl` of a joint. The pointer is valid as long as the joint exists.
struct JointAxisEdit {
    const char* name;
    bool is_angle;
    JointControl* control;
};
/// All controls of a joint; empty for kinds without any.
std::vector<JointAxisEdit> joint_axes(Joint& joint);

/// Parameters of a spring as in `JointSpring::from_frequency`.
struct Swing {
    float hertz = 0.0f;
    float damping_ratio = 0.0f; ///< 0 without stiffness.
};
/// Only for springs defined per unit of mass.
Swing swing_of(const JointSpring& spring);

/// Load of the joint in the last step as a share of its breaking force or torque; 0 for an unbreakable joint.
float joint_load(const JointDef& def, const JointState& state);

/// The display label of a joint: its name, or its kind and number.
std::string joint_label(JointId id, const JointDef& def);

} // namespace cairn::viewer
