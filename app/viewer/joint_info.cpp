#include "viewer/joint_info.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>

namespace cairn::viewer {

namespace {

constexpr const char* axis_names[] = {"x", "y", "z"};

bool is_plain_lock(const JointLimit& limit) { return !limit.stiffness && limit.min == 0.0f && limit.max == 0.0f; }

int count_of(const std::array<bool, 3>& axes) { return int(axes[0]) + int(axes[1]) + int(axes[2]); }

std::string list_of(const std::array<bool, 3>& axes) {
    std::string text;
    for (std::size_t i = 0; i < 3; ++i)
        if (axes[i]) text += axis_names[i];
    return text;
}

// The positions of a general joint in the engine's order: limits first, then drives; a drive shares the position of a
// limit on its own axis.
std::vector<JointPosition> general_positions(const GeneralJoint& joint) {
    struct Row {
        JointAxis kind;
        int axis; // -1: several axes
        bool has_drive;
    };
    std::vector<JointPosition> positions;
    std::vector<Row> rows;
    std::array<bool, 3> locked{};
    for (const JointLimit& limit : joint.limits)
        if (is_plain_lock(limit) && limit.kind == JointAxis::angular)
            for (std::size_t i = 0; i < 3; ++i) locked[i] = locked[i] || limit.axes[i];
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const JointLimit& limit : joint.limits) {
        if (is_plain_lock(limit)) continue;
        const bool is_angle = limit.kind == JointAxis::angular, is_single = count_of(limit.axes) == 1;
        positions.push_back({(is_angle ? "about " : "along ") + list_of(limit.axes), is_angle,
                             JointRange{limit.min.value_or(-infinity), limit.max.value_or(infinity), {}}});
        const int axis =
            is_single ? int(std::find(limit.axes.begin(), limit.axes.end(), true) - limit.axes.begin()) : -1;
        rows.push_back({limit.kind, axis, false});
    }
    const bool drives_share = count_of(locked) == 2; // only then do limits and drives measure the same angle
    for (const JointDrive& drive : joint.drives) {
        const bool is_angle = drive.kind == JointAxis::angular;
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) {
            return r.kind == drive.kind && r.axis == drive.axis && !r.has_drive && (!is_angle || drives_share);
        });
        if (row != rows.end()) {
            row->has_drive = true;
            continue;
        }
        positions.push_back({std::string(is_angle ? "rotation about " : "at ") + axis_names[drive.axis], is_angle});
        rows.push_back({drive.kind, drive.axis, true});
    }
    return positions;
}

struct Positions {
    using List = std::vector<JointPosition>;
    List operator()(const FixedJoint&) const { return {}; }
    List operator()(const BallJoint& joint) const {
        List list;
        if (joint.cone_angle) list.push_back({"swing", true, JointRange{0.0f, *joint.cone_angle, {}}});
        if (joint.twist) list.push_back({"twist", true, joint.twist});
        return list;
    }
    List operator()(const HingeJoint& joint) const { return {{"angle", true, joint.angle.limits}}; }
    List operator()(const SliderJoint& joint) const { return {{"translation", false, joint.translation.limits}}; }
    List operator()(const CylindricalJoint& joint) const {
        return {{"translation", false, joint.translation.limits}, {"angle", true, joint.angle.limits}};
    }
    List operator()(const UniversalJoint& joint) const {
        return {{"first", true, joint.first.limits}, {"second", true, joint.second.limits}};
    }
    List operator()(const DistanceJoint& joint) const { return {{"distance", false, joint.distance.limits}}; }
    List operator()(const WheelJoint& joint) const {
        List list{{"suspension", false, joint.suspension.limits}};
        if (joint.steering) list.push_back({"steering", true, joint.steering->limits});
        list.push_back({"spin", true, joint.spin.limits});
        return list;
    }
    List operator()(const ServoJoint&) const { // relative to the target
        return {{"along x", false}, {"along y", false}, {"along z", false},
                {"about x", true},  {"about y", true},  {"about z", true}};
    }
    List operator()(const GearJoint&) const { return {}; }
    List operator()(const RackJoint&) const { return {}; }
    List operator()(const PulleyJoint& joint) const {
        if (!joint.length) return {{"length", false}};
        return {{"length", false, JointRange{0.0f, *joint.length, {}}}};
    }
    List operator()(const GeneralJoint& joint) const { return general_positions(joint); }
};

struct AxisEdits {
    using List = std::vector<JointAxisEdit>;
    List operator()(HingeJoint& joint) const { return {{"angle", true, &joint.angle}}; }
    List operator()(SliderJoint& joint) const { return {{"translation", false, &joint.translation}}; }
    List operator()(CylindricalJoint& joint) const {
        return {{"translation", false, &joint.translation}, {"angle", true, &joint.angle}};
    }
    List operator()(UniversalJoint& joint) const {
        return {{"first", true, &joint.first}, {"second", true, &joint.second}};
    }
    List operator()(DistanceJoint& joint) const { return {{"distance", false, &joint.distance}}; }
    List operator()(WheelJoint& joint) const {
        List list{{"suspension", false, &joint.suspension}};
        if (joint.steering) list.push_back({"steering", true, &*joint.steering});
        list.push_back({"spin", true, &joint.spin});
        return list;
    }
    template <class Other> List operator()(Other&) const { return {}; }
};

} // namespace

const char* name_of(const Joint& joint) {
    constexpr const char* names[] = {"fixed", "ball",  "hinge", "slider", "cylindrical", "universal", "distance",
                                     "wheel", "servo", "gear",  "rack",   "pulley",      "general"};
    static_assert(std::size(names) == std::variant_size_v<Joint>);
    return names[joint.index()];
}

const char* name_of(JointSolver solver) {
    constexpr const char* names[joint_solver_count] = {"automatic", "iterative", "direct"};
    return names[int(solver)];
}

std::vector<JointPosition> joint_positions(const Joint& joint) { return std::visit(Positions{}, joint); }

std::vector<JointAxisEdit> joint_axes(Joint& joint) { return std::visit(AxisEdits{}, joint); }

Swing swing_of(const JointSpring& spring) {
    const float omega = std::sqrt(spring.stiffness);
    return {omega / 6.28318531f, omega > 0.0f ? 0.5f * spring.damping / omega : 0.0f};
}

float joint_load(const JointDef& def, const JointState& state) {
    return std::max(glm::length(state.force) / def.break_force, glm::length(state.torque) / def.break_torque);
}

std::string joint_label(JointId id, const JointDef& def) {
    if (!def.name.empty()) return def.name;
    return std::string(name_of(def.joint)) + " " + std::to_string(id.index());
}

} // namespace cairn::viewer
