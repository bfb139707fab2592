// Converts the actuators of MJCF models to drives of their joints.
#include "scene/mjcf_model.h"

#include <algorithm>
#include <cmath>

namespace cairn::scene {

namespace {

constexpr const char* kinds[] = {"motor", "position", "velocity", "intvelocity", "damper", "general"};

class ActuatorReader {
  public:
    ActuatorReader(MjcfModel& model) : model_(model) {}

    void read(const XmlElement& child, std::optional<double> control) {
        const MjcfElement element(child, model_.defaults, 0);
        const bool in_parent = !element.attribute("joint");
        const auto name = in_parent ? element.attribute("jointinparent") : element.attribute("joint");
        if (!name) {
            model_.warnings.push_back(element.place() + ": has no effect: it acts on no joint");
            return;
        }
        const MjcfJoint* found = model_.joint(*name);
        if (found == nullptr) {
            model_.warnings.push_back(element.place() + ": has no effect: its joint is not supported");
            return;
        }
        if (!found->is_scalar()) {
            model_.warnings.push_back(element.place() +
                                      ": has no effect: it acts on a joint that is not a hinge or slide");
            return;
        }
        MjcfJoint& joint = model_.joints[static_cast<std::size_t>(found - model_.joints.data())];
        const auto gear_text = element.attribute("gear");
        const double gear = gear_text ? gear_text->numbers(1, 6)[0] : 1.0;
        if (!(std::fabs(gear) <= 1e9)) gear_text->fail("must be within 1e9");
        double value = control.value_or(0.0);
        const std::optional<double> most_control = bound(element, "ctrllimited", "ctrlrange", &value);
        const std::optional<double> most_force = bound(element, "forcelimited", "forcerange", nullptr);
        Law law = law_of(element, joint, gear);
        if (child.tag() == "intvelocity") value = 0.0; // the integrated target starts at 0
        MjcfDrive& drive = joint.drive;
        drive.is_driven = true;
        const double k = law.stiffness * gear * gear, d = law.damping * gear * gear;
        // Joint force: gear times (gain x control + bias - stiffness gear q - damping gear q').
        drive.stiffness += k;
        drive.damping += d;
        const double push = gear * (law.gain * value + law.bias);
        if (law.stiffness > 0.0) {
            drive.stiffness_position += push;
        } else if (law.damping > 0.0) {
            drive.damping_velocity += push;
        } else {
            drive.force += push;
        }
        std::optional<double> most = most_force;
        if (!most && law.stiffness == 0.0 && law.damping == 0.0 && most_control) {
            most = std::fabs(law.gain) * *most_control;
        }
        if (most) {
            drive.most += std::fabs(gear) * *most;
        } else {
            drive.is_bounded = false;
        }
    }

  private:
    // force = gain x control + bias - stiffness x length - damping x rate of length
    struct Law {
        double gain = 1.0, bias = 0.0, stiffness = 0.0, damping = 0.0;
    };

    // Returns the greatest absolute value of a range, if there is one, and clamps `value` to the range.
    std::optional<double> bound(const MjcfElement& element, const char* limited, const char* name,
                                double* value) const {
        const bool is_on = element.is_on(limited, name, model_.settings.autolimits);
        const auto range = element.attribute(name);
        if (!is_on || !range) return std::nullopt;
        const std::vector<double> bounds = range->numbers(2, 2);
        if (!(bounds[0] <= bounds[1])) range->fail("must be two bounds, the lower first");
        if (value != nullptr) *value = std::clamp(*value, bounds[0], bounds[1]);
        return std::max(std::fabs(bounds[0]), std::fabs(bounds[1]));
    }

    Law law_of(const MjcfElement& element, const MjcfJoint& joint, double gear) const {
        Law law;
        const std::string_view kind = element.xml().tag();
        if (kind == "position" || kind == "intvelocity") {
            law.stiffness = law.gain = element.number("kp", 1.0, 0.0, 1e30);
            law.damping = element.number("kv", 0.0, 0.0, 1e30);
            const double ratio = element.number("dampratio", 0.0, 0.0, 1e6);
            if (ratio > 0.0) {
                // The damping is per unit of the actuator's length, which is gear times the joint coordinate.
                const double mass = moved_inertia(joint) / std::max(gear * gear, 1e-30);
                law.damping = 2.0 * ratio * std::sqrt(law.stiffness * mass);
            }
        } else if (kind == "velocity") {
            law.damping = law.gain = element.number("kv", 1.0, 0.0, 1e30);
        } else if (kind == "damper") {
            law.gain = 0.0; // its damping is proportional to its control, which is 0 initially
        } else if (kind == "general") {
            const auto first = [&](const char* name, std::vector<double> otherwise) {
                const auto text = element.attribute(name);
                if (!text) return otherwise;
                std::vector<double> values = text->numbers(0, 10);
                values.resize(std::max<std::size_t>(values.size(), 3), 0.0);
                return values;
            };
            const std::vector<double> gain = first("gainprm", {1.0, 0.0, 0.0}),
                                      bias = first("biasprm", {0.0, 0.0, 0.0});
            const std::string gain_type = element.word("gaintype", "fixed"),
                              bias_type = element.word("biastype", "none");
            if ((gain_type != "fixed" && gain_type != "affine") || (bias_type != "none" && bias_type != "affine")) {
                model_.warnings.push_back(element.place() +
                                          ": has no effect: only fixed and affine laws are supported");
                return {0.0, 0.0, 0.0, 0.0};
            }
            law.gain = gain[0];
            if (bias_type == "affine") law = {gain[0], bias[0], -bias[1], -bias[2]};
            if (law.stiffness < 0.0 || law.damping < 0.0) {
                model_.warnings.push_back(element.place() + ": drives away from its target, which is ignored");
                law.stiffness = std::max(law.stiffness, 0.0);
                law.damping = std::max(law.damping, 0.0);
            }
        }
        return law;
    }

    // Returns the inertia that a joint moves if all other joints are locked: the mass, or the moment of inertia about
    // its axis, in the pose of the model file.
    double moved_inertia(const MjcfJoint& joint) const {
        const MjcfPart& own = model_.parts[joint.part];
        const glm::dvec3 axis = own.drawn.rotation * joint.axis;
        const glm::dvec3 point = own.drawn.position + own.drawn.rotation * joint.anchor;
        std::vector<bool> moves(model_.parts.size(), false);
        double sum = joint.armature;
        for (std::size_t i = joint.part; i < model_.parts.size(); ++i) {
            const MjcfPart& part = model_.parts[i];
            moves[i] = i == joint.part || (i != 0 && moves[part.parent]);
            if (!moves[i]) continue;
            for (const ModelMass& mass : part.body.masses) {
                const Rigid at = part.drawn * mass.at;
                const glm::dvec3 own_axis = glm::conjugate(at.rotation) * axis;
                const glm::dvec3 across = glm::cross(axis, at.position - point);
                sum += joint.kind == MjcfJoint::Kind::slide
                           ? mass.mass
                           : glm::dot(own_axis, mass.inertia * own_axis) + mass.mass * glm::dot(across, across);
            }
        }
        return sum;
    }

    MjcfModel& model_;
};

} // namespace

void read_mjcf_actuators(const XmlElement& root, const std::vector<double>& control, MjcfModel& model) {
    for (MjcfJoint& joint : model.joints) {
        joint.drive.stiffness = joint.stiffness;
        joint.drive.stiffness_position = joint.stiffness * joint.rest;
        joint.drive.damping = joint.damping;
    }
    ActuatorReader reader(model);
    for (const XmlElement& section : root.children("actuator")) {
        for (const char* kind : kinds) section.mark_read(kind);
        std::size_t index = 0;
        for (const XmlElement& child : section.children()) {
            const std::string_view tag = child.tag();
            const bool is_known = std::find(std::begin(kinds), std::end(kinds), tag) != std::end(kinds);
            const std::optional<double> value = index < control.size() ? std::optional(control[index]) : std::nullopt;
            ++index;
            if (is_known && model.settings.actuators) reader.read(child, value);
        }
    }
}

} // namespace cairn::scene
