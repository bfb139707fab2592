#include "scene/joints.h"

#include "scene/definitions.h"
#include "scene/document.h"
#include "scene/json_number.h"

namespace cairn::scene {

namespace {

constexpr std::size_t max_rules = 100; // limits, or drives, of one joint

// Three flags from a list of 1 to 3 different axes.
std::array<bool, 3> read_axes(const Value& list) {
    const std::size_t count = list.size(3, "axes");
    if (count == 0) list.fail("must list 1 to 3 axes");
    std::array<bool, 3> axes{};
    for (std::size_t i = 0; i < count; ++i) {
        const auto axis = static_cast<std::size_t>(list[i].integer(0, 2));
        if (axes[axis]) list[i].fail("must not be listed twice");
        axes[axis] = true;
    }
    return axes;
}

JointLimit read_limit(const Value& value) {
    JointLimit limit;
    const auto linear = value.find("linearAxes"), angular = value.find("angularAxes");
    if (linear.has_value() == angular.has_value()) value.fail("must have either linearAxes or angularAxes");
    limit.kind = linear ? JointAxis::linear : JointAxis::angular;
    limit.axes = read_axes(linear ? *linear : *angular);
    if (const auto min = value.find("min")) limit.min = min->real();
    if (const auto max = value.find("max")) {
        limit.max = max->real();
        if (limit.min && *limit.min > *limit.max) max->fail("must be at least min");
    }
    if (const auto stiffness = value.find("stiffness")) limit.stiffness = stiffness->real(nonnegative_float);
    if (const auto damping = value.find("damping")) limit.damping = damping->real(nonnegative_float);
    return limit;
}

JointDrive read_drive(const Value& value) {
    JointDrive drive;
    const Value type = value.require("type"), mode = value.require("mode");
    if (const std::string name = type.text(); name == "angular") {
        drive.kind = JointAxis::angular;
    } else if (name != "linear") {
        type.fail("must be \"linear\" or \"angular\"");
    }
    if (const std::string name = mode.text(); name == "acceleration") {
        drive.is_acceleration = true;
    } else if (name != "force") {
        mode.fail("must be \"force\" or \"acceleration\"");
    }
    drive.axis = value.require("axis").integer(0, 2);
    if (const auto force = value.find("maxForce")) drive.max_force = force->real(nonnegative_float);
    if (const auto target = value.find("positionTarget")) drive.position_target = target->real();
    if (const auto target = value.find("velocityTarget")) drive.velocity_target = target->real();
    if (const auto stiffness = value.find("stiffness")) drive.stiffness = stiffness->real(nonnegative_float);
    if (const auto damping = value.find("damping")) drive.damping = damping->real(nonnegative_float);
    return drive;
}

JointRules read_rules(const Value& value) {
    JointRules rules;
    if (const auto limits = value.find("limits")) {
        const std::size_t count = limits->size(max_rules, "limits");
        for (std::size_t i = 0; i < count; ++i) rules.limits.push_back(read_limit((*limits)[i]));
    }
    if (const auto drives = value.find("drives")) {
        const std::size_t count = drives->size(max_rules, "drives");
        for (std::size_t i = 0; i < count; ++i) rules.drives.push_back(read_drive((*drives)[i]));
    }
    return rules;
}

nlohmann::ordered_json write_limit(const JointLimit& limit) {
    nlohmann::ordered_json json;
    const char* name = limit.kind == JointAxis::linear ? "linearAxes" : "angularAxes";
    for (int i = 0; i < 3; ++i) {
        if (limit.axes[static_cast<std::size_t>(i)]) json[name].push_back(i);
    }
    if (limit.min) json["min"] = shortest(*limit.min);
    if (limit.max) json["max"] = shortest(*limit.max);
    if (limit.stiffness) json["stiffness"] = shortest(*limit.stiffness);
    if (limit.damping != 0.0f) json["damping"] = shortest(limit.damping);
    return json;
}

nlohmann::ordered_json write_drive(const JointDrive& drive) {
    nlohmann::ordered_json json;
    json["type"] = drive.kind == JointAxis::linear ? "linear" : "angular";
    json["mode"] = drive.is_acceleration ? "acceleration" : "force";
    json["axis"] = drive.axis;
    if (drive.max_force) json["maxForce"] = shortest(*drive.max_force);
    // A target and its strength come together, as the draft's schema has it.
    if (drive.position_target != 0.0f || drive.stiffness != 0.0f) {
        json["positionTarget"] = shortest(drive.position_target);
        json["stiffness"] = shortest(drive.stiffness);
    }
    if (drive.velocity_target != 0.0f || drive.damping != 0.0f) {
        json["velocityTarget"] = shortest(drive.velocity_target);
        json["damping"] = shortest(drive.damping);
    }
    return json;
}

} // namespace

JointTable::JointTable(const Value& document) {
    const auto physics = extension(document, "KHR_physics_rigid_bodies");
    entries_ = physics ? physics->find("physicsJoints") : std::nullopt;
    const std::size_t count = entries_ ? entries_->size(max_definitions, "joints") : 0;
    for (std::size_t i = 0; i < count; ++i) rules_.push_back(read_rules((*entries_)[i]));
}

const JointRules& JointTable::rules(const Value& index) const {
    element(entries_, index, max_definitions, "joints");
    return rules_[index.index(rules_.size(), "joints")];
}

nlohmann::ordered_json write_joint_rules(const JointDescription& joint) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const JointLimit& limit : joint.limits) json["limits"].push_back(write_limit(limit));
    for (const JointDrive& drive : joint.drives) json["drives"].push_back(write_drive(drive));
    return json;
}

} // namespace cairn::scene
