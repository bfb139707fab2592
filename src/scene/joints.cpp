#include "scene/joints.h"

#include "scene/definitions.h"
#include "scene/document.h"
#include "scene/joint_types.h"
#include "scene/json_number.h"

#include <array>
#include <cmath>
#include <utility>

namespace cairn::scene {

namespace {

constexpr std::size_t max_rules = 100; // maximum number of limits, or of drives, of one joint

// Reads a list of 1 to 3 different axes into flags.
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

GeneralJoint read_general(const Value& value) {
    GeneralJoint joint;
    if (const auto limits = value.find("limits")) {
        const std::size_t count = limits->size(max_rules, "limits");
        for (std::size_t i = 0; i < count; ++i) joint.limits.push_back(read_limit((*limits)[i]));
    }
    if (const auto drives = value.find("drives")) {
        const std::size_t count = drives->size(max_rules, "drives");
        for (std::size_t i = 0; i < count; ++i) joint.drives.push_back(read_drive((*drives)[i]));
    }
    return joint;
}

struct NamedSolver {
    const char* name;
    JointSolver solver;
};
constexpr std::array<NamedSolver, 3> solvers{{
    {"automatic", JointSolver::automatic},
    {"iterative", JointSolver::iterative},
    {"direct", JointSolver::direct},
}};

JointSolver read_solver(const Value& value) {
    const std::string name = value.text();
    for (const NamedSolver& known : solvers) {
        if (name == known.name) return known.solver;
    }
    value.fail("must be \"automatic\", \"iterative\" or \"direct\"");
}

JointDef read_joint(const Value& value, std::vector<std::string>& warnings) {
    JointDef def;
    def.joint = read_general(value); // validated even if CAIRN_joint replaces it with another type
    const auto own = extension(value, "CAIRN_joint");
    if (!own) return def;
    warn_of_unknown_joint_members(*own, warnings);
    if (const auto type = own->find("type"); type && !(type->is_string() && type->text() == "general")) {
        def.joint = read_typed_joint(*own);
    }
    if (const auto force = own->find("break_force")) def.break_force = force->real(positive_float);
    if (const auto torque = own->find("break_torque")) def.break_torque = torque->real(positive_float);
    if (const auto solver = own->find("solver")) def.solver = read_solver(*solver);
    if (const auto enabled = own->find("enabled")) def.enabled = enabled->boolean();
    return def;
}

nlohmann::ordered_json write_limit(const JointLimit& limit) {
    nlohmann::ordered_json json;
    const char* name = limit.kind == JointAxis::linear ? "linearAxes" : "angularAxes";
    for (int i = 0; i < 3; ++i) {
        if (limit.axes[static_cast<std::size_t>(i)]) json[name].push_back(i);
    }
    if (limit.min && std::isfinite(*limit.min)) json["min"] = shortest(*limit.min);
    if (limit.max && std::isfinite(*limit.max)) json["max"] = shortest(*limit.max);
    if (limit.stiffness) json["stiffness"] = shortest(*limit.stiffness);
    if (limit.damping != 0.0f) json["damping"] = shortest(limit.damping);
    return json;
}

nlohmann::ordered_json write_drive(const JointDrive& drive) {
    nlohmann::ordered_json json;
    json["type"] = drive.kind == JointAxis::linear ? "linear" : "angular";
    json["mode"] = drive.is_acceleration ? "acceleration" : "force";
    json["axis"] = drive.axis;
    if (drive.max_force && std::isfinite(*drive.max_force)) json["maxForce"] = shortest(*drive.max_force);
    // The draft's schema requires a target together with its stiffness or damping.
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

int free_rows(const GeneralJoint& joint) {
    std::array<std::array<bool, 3>, 2> locked{};
    int rows = static_cast<int>(joint.drives.size());
    for (const JointLimit& limit : joint.limits) {
        const bool is_lock = !limit.stiffness && limit.min == 0.0f && limit.max == 0.0f;
        if (!is_lock) ++rows;
        for (std::size_t i = 0; is_lock && i < 3; ++i) {
            if (limit.axes[i]) locked[static_cast<std::size_t>(limit.kind)][i] = true;
        }
    }
    // Two or three locked axes form one constraint; a single locked axis takes a row of its own.
    for (const auto& axes : locked) {
        if (axes[0] + axes[1] + axes[2] == 1) ++rows;
    }
    return rows;
}

JointTable::JointTable(const Value& document, std::vector<std::string>& warnings) {
    const auto physics = extension(document, "KHR_physics_rigid_bodies");
    entries_ = physics ? physics->find("physicsJoints") : std::nullopt;
    const std::size_t count = entries_ ? entries_->size(max_definitions, "joints") : 0;
    for (std::size_t i = 0; i < count; ++i) joints_.push_back(read_joint((*entries_)[i], warnings));
}

const JointDef& JointTable::joint(const Value& index) const {
    element(entries_, index, max_definitions, "joints");
    return joints_[index.index(joints_.size(), "joints")];
}

nlohmann::ordered_json write_joint(const JointDef& joint) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    const GeneralJoint general = nearest_general_joint(joint.joint);
    for (const JointLimit& limit : general.limits) json["limits"].push_back(write_limit(limit));
    for (const JointDrive& drive : general.drives) json["drives"].push_back(write_drive(drive));
    nlohmann::ordered_json own = write_typed_joint(joint.joint);
    if (std::isfinite(joint.break_force)) own["break_force"] = shortest(joint.break_force);
    if (std::isfinite(joint.break_torque)) own["break_torque"] = shortest(joint.break_torque);
    if (joint.solver != JointSolver::automatic) own["solver"] = solvers[static_cast<std::size_t>(joint.solver)].name;
    if (!joint.enabled) own["enabled"] = false;
    if (!own.empty()) json["extensions"]["CAIRN_joint"] = std::move(own);
    return json;
}

} // namespace cairn::scene
