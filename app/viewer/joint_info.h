/// \file joint_info.h
/// Joints in words and numbers, for lists, panels and reports: what their kinds and positions are called, and which of
/// their values can be changed by hand.
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
    std::optional<JointRange> limits{}; ///< What the joint keeps it in, if anything.
};
/// The positions of a joint, in the order of `JointState::positions`.
std::vector<JointPosition> joint_positions(const Joint& joint);

/// A `JointControl` of a joint. The pointer is good as long as the joint is.
struct JointAxisEdit {
    const char* name;
    bool is_angle;
    JointControl* control;
};
/// All of them; the kinds without any have none.
std::vector<JointAxisEdit> joint_axes(Joint& joint);

/// A spring as `JointSpring::from_frequency` takes it.
struct Swing {
    float hertz = 0.0f;
    float damping_ratio = 0.0f; ///< 0 without stiffness.
};
/// Only of springs per unit of mass.
Swing swing_of(const JointSpring& spring);

/// The share of what breaks the joint that its force or torque was in the last step; 0 for one that does not break.
float joint_load(const JointDef& def, const JointState& state);

/// What a joint is called in lists: its name, or its kind and number.
std::string joint_label(JointId id, const JointDef& def);

} // namespace cairn::viewer
