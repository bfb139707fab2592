#include "scene/urdf_joints.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace cairn::scene {

namespace {

constexpr int longest_mimic_chain = 16;

std::string place_of(const std::string& name, const urdf::Joint& joint) {
    return name + ": joint \"" + joint.name + "\"";
}

bool turns(const urdf::Joint& joint) {
    return joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
}

glm::dvec3 axis_of(const urdf::Joint& joint, const std::string& name) {
    const glm::dvec3 axis(joint.axis.x, joint.axis.y, joint.axis.z);
    const double length = std::sqrt(glm::dot(axis, axis));
    if (!(length > 1e-9 && length < 1e9)) {
        throw Error(ErrorCode::invalid_file, place_of(name, joint) + ": axis", {}, "must be a vector that is not zero");
    }
    return axis / length;
}

std::optional<JointRange> range_of(const urdf::Joint& joint, const std::string& name) {
    if (joint.type == urdf::Joint::CONTINUOUS || !joint.limits) return std::nullopt;
    const urdf::JointLimits& limits = *joint.limits;
    if (!(limits.lower <= limits.upper)) {
        throw Error(ErrorCode::invalid_file, place_of(name, joint) + ": limit",
                    std::to_string(limits.lower) + " to " + std::to_string(limits.upper), "must have lower <= upper");
    }
    constexpr double unlimited = 1e9; // rad or m: limits beyond this are treated as unlimited
    if (limits.lower < -unlimited && limits.upper > unlimited) return std::nullopt;
    return JointRange{static_cast<float>(std::clamp(limits.lower, -unlimited, unlimited)),
                      static_cast<float>(std::clamp(limits.upper, -unlimited, unlimited)), std::nullopt};
}

float nonnegative(double value, const urdf::Joint& joint, const std::string& name, const char* what) {
    if (!(value >= 0.0 && value <= 1e30)) {
        throw Error(ErrorCode::invalid_file, place_of(name, joint) + ": " + what, std::to_string(value),
                    "must be >= 0, and finite");
    }
    return static_cast<float>(value);
}

// The motor has damping only; a controller may give it a stiffness and a target.
JointControl control_of(const urdf::Joint& joint, const std::string& name) {
    JointControl control;
    control.limits = range_of(joint, name);
    const float effort = joint.limits ? nonnegative(joint.limits->effort, joint, name, "limit effort") : 0.0f;
    float damping = 0.0f;
    if (joint.dynamics) {
        damping = nonnegative(joint.dynamics->damping, joint, name, "dynamics damping");
        control.friction = nonnegative(joint.dynamics->friction, joint, name, "dynamics friction");
    }
    if (effort == 0.0f && damping == 0.0f) return control;
    control.motor.emplace();
    control.motor->spring = JointSpring{0.0f, damping, false};
    if (effort > 0.0f) control.motor->max_force = effort;
    return control;
}

std::optional<Joint> joint_of(const urdf::Joint& joint, const std::string& name) {
    switch (joint.type) {
    case urdf::Joint::REVOLUTE:
    case urdf::Joint::CONTINUOUS:
        return HingeJoint{control_of(joint, name)};
    case urdf::Joint::PRISMATIC:
        return SliderJoint{control_of(joint, name)};
    case urdf::Joint::FLOATING: // only disables collision between the two bodies
        return GeneralJoint{};
    case urdf::Joint::PLANAR: // translates across the axis, and rotates about it
        return GeneralJoint{{JointLimit{JointAxis::linear, {true, false, false}, 0.0f, 0.0f, std::nullopt, 0.0f},
                             JointLimit{JointAxis::angular, {false, true, true}, 0.0f, 0.0f, std::nullopt, 0.0f}},
                            {}};
    default:
        return std::nullopt;
    }
}

} // namespace

double RobotPose::position(const urdf::Joint& joint, int depth) const {
    double at = 0.0;
    if (joint.mimic) {
        const urdf::JointConstSharedPtr other = model_.getJoint(joint.mimic->joint_name);
        const std::string where = place_of(name_, joint) + ": mimic";
        if (!other) {
            throw Error(ErrorCode::invalid_file, where, "\"" + joint.mimic->joint_name + "\"",
                        "must be a joint of the robot");
        }
        if (depth > longest_mimic_chain) {
            throw Error(ErrorCode::invalid_file, where, "\"" + joint.mimic->joint_name + "\"",
                        "must not be circular, or chain more than 16 joints");
        }
        at = joint.mimic->offset + joint.mimic->multiplier * position(*other, depth + 1);
        if (!(std::fabs(at) <= 1e6)) {
            throw Error(ErrorCode::invalid_file, where, std::to_string(at), "must start within 1000000");
        }
    }
    const std::optional<JointRange> range = range_of(joint, name_);
    if (!range) return at;
    return std::clamp(at, static_cast<double>(range->lower), static_cast<double>(range->upper));
}

Rigid RobotPose::motion(const urdf::Joint& joint) const {
    if (!turns(joint) && joint.type != urdf::Joint::PRISMATIC) return {};
    const glm::dvec3 axis = axis_of(joint, name_);
    const double at = position(joint);
    if (at == 0.0) return {};
    if (!turns(joint)) return {axis * at, {1.0, 0.0, 0.0, 0.0}};
    const double sine = std::sin(0.5 * at);
    return {{0.0, 0.0, 0.0}, {std::cos(0.5 * at), sine * axis.x, sine * axis.y, sine * axis.z}};
}

void RobotJoints::add() {
    for (const RobotPart& part : parts_) {
        if (part.joint) add(part);
    }
    for (const RobotPart& part : parts_) {
        if (part.joint && part.joint->mimic) add_mimic(part);
    }
    if (const std::size_t count = scene_.speed_limits.size(); count > 0) {
        scene_.warnings.push_back(name_ + ": the velocity limits of " + std::to_string(count) +
                                  (count == 1 ? " joint hold" : " joints hold") +
                                  " for the targets of motors only; they do not limit other motion");
    }
}

void RobotJoints::add(const RobotPart& part) {
    const urdf::Joint& joint = *part.joint;
    const RobotPart& parent = parts_[part.parent];
    if (joint.type == urdf::Joint::FLOATING && parent.is_world) return; // a floating base needs no joint
    JointDef def;
    const auto made = joint_of(joint, name_);
    if (!made) throw Error(ErrorCode::unsupported, place_of(name_, joint), {}, "must be of a known type");
    def.joint = *made;
    def.name = joint.name;
    def.body_a = parent.body;
    def.body_b = part.body;
    Rigid along;
    if (joint.type != urdf::Joint::FLOATING) along.rotation = turn_from_x(axis_of(joint, name_));
    const Rigid frame = part.frame * along;
    def.frame_a = (parent.body.is_null() ? parent.world * frame : frame).transform();
    def.frame_b = along.transform();
    try {
        const JointId made_joint = scene_.world.create_joint(def);
        const bool is_limited = joint.limits && joint.limits->velocity > 0.0 && joint.limits->velocity <= 1e9;
        if (is_limited && (turns(joint) || joint.type == urdf::Joint::PRISMATIC)) {
            scene_.speed_limits.push_back({made_joint, static_cast<float>(joint.limits->velocity)});
        }
    } catch (const Error& error) {
        throw Error(ErrorCode::invalid_file, place_of(name_, joint), {}, error.what());
    }
}

const RobotPart* RobotJoints::part_of(const std::string& joint) const {
    for (const RobotPart& part : parts_) {
        if (part.joint && part.joint->name == joint) return &part;
    }
    return nullptr;
}

// A gear constrains angular rates relative to the world. These equal the rates relative to the parents if the parents
// do not rotate, or if both joints have the same parent, parallel axes and the same rate, as the parent's rate then
// cancels.
void RobotJoints::add_mimic(const RobotPart& part) {
    const urdf::Joint& joint = *part.joint;
    const urdf::JointMimic& mimic = *joint.mimic;
    const RobotPart* other = part_of(mimic.joint_name);
    const auto without = [&](const char* why) {
        scene_.warnings.push_back(place_of(name_, joint) + ": mimic has no effect: " + why);
    };
    if (other == nullptr || other == &part) return without("the other joint does not move");
    if (!turns(joint) || !turns(*other->joint)) return without("both joints must turn");
    if (mimic.multiplier == 0.0) return without("a multiplier of 0");
    const bool fixed = parts_[part.parent].is_world && parts_[other->parent].is_world;
    if (!fixed) {
        const glm::dvec3 axis = part.frame.rotation * axis_of(joint, name_);
        const glm::dvec3 other_axis = other->frame.rotation * axis_of(*other->joint, name_);
        const bool drops_out = part.parent == other->parent && glm::dot(axis, other_axis) * mimic.multiplier > 0.9999 &&
                               std::fabs(std::fabs(mimic.multiplier) - 1.0) < 1e-6;
        if (!drops_out) {
            return without("the links that carry the two joints can turn, and gears hold only between axles at rest");
        }
    }
    JointDef def;
    def.name = joint.name + " mimics " + mimic.joint_name;
    def.body_a = other->body;
    def.body_b = part.body;
    def.frame_a.rotation = Quat(turn_from_x(axis_of(*other->joint, name_)));
    def.frame_b.rotation = Quat(turn_from_x(axis_of(joint, name_)));
    def.joint = GearJoint{static_cast<float>(-1.0 / mimic.multiplier)};
    def.enable_collision = true; // a mimic does not disable collision between its bodies
    scene_.world.create_joint(def);
}

} // namespace cairn::scene
