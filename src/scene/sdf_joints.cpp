// Joints of SDF files.
#include "scene/sdf_model.h"

#include <cairn/error.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn::scene {

namespace {

constexpr double endless = 1e6; // m or rad: limits beyond this are treated as unlimited
constexpr double most_double = std::numeric_limits<double>::max();

class SdfJointMaker {
  public:
    SdfJointMaker(const SdfModel& model, const SdfBodies& bodies, std::vector<std::string>& warnings, Scene& scene)
        : model_(model), bodies_(bodies), warnings_(warnings), scene_(scene) {}

    void add(const SdfJoint& joint) {
        const XmlElement& element = joint.element;
        const auto type = element.require("type");
        const std::size_t kind = type.choice(
            {"revolute", "continuous", "prismatic", "fixed", "ball", "universal", "revolute2", "screw", "gearbox"});
        const std::size_t a = body(joint, "parent"), b = body(joint, "child");
        if (kind == 3 && (a == b || !(is_dynamic(a) || is_dynamic(b)))) return; // already one body, or already fixed
        if (a == b) return without(element, "it joins no bodies that can move relative to each other");
        if (!is_dynamic(a) && !is_dynamic(b)) return without(element, "neither of its links moves");
        JointDef def;
        def.name = model_.scopes[joint.scope].prefix + element.text_of("name");
        Rigid frame = model_.world(joint.frame);
        speed_ = 0.0;
        if (kind <= 2) {
            const auto axis = element.child("axis");
            frame.rotation = turn_from_x(axis_of(joint, axis, "axis"));
            const JointControl control = axis ? control_of(*axis, kind == 1) : JointControl();
            if (kind == 2) {
                def.joint = SliderJoint{control};
            } else {
                def.joint = HingeJoint{control};
            }
        } else if (kind == 3) {
            def.joint = FixedJoint{};
        } else if (kind == 4) {
            def.joint = BallJoint{};
        } else if (kind == 5 || kind == 6) {
            if (!make_universal(joint, def, frame)) return;
        } else {
            throw Error(ErrorCode::unsupported, type.place, "\"" + printable(type.text) + "\"",
                        "must be revolute, continuous, prismatic, fixed, ball, universal or revolute2");
        }
        place(a, frame, def.body_a, def.frame_a);
        place(b, frame, def.body_b, def.frame_b);
        try {
            const JointId made = scene_.world.create_joint(def);
            if (speed_ > 0.0) scene_.speed_limits.push_back({made, static_cast<float>(speed_)});
        } catch (const Error& error) {
            throw Error(ErrorCode::invalid_file, element.place(), {}, error.what());
        }
    }

  private:
    void without(const XmlElement& element, const char* why) {
        warnings_.push_back(element.place() + ": has no effect: " + why);
    }

    // Returns the index of a body; sdf_none: the world.
    std::size_t body(const SdfJoint& joint, const char* which) const {
        const auto name = joint.element.child_text(which);
        if (!name) joint.element.fail(std::string("must have the element ") + which);
        const std::size_t link = model_.link_of(model_.find(joint.scope, *name));
        return link == sdf_none ? sdf_none : bodies_.body_of_link[link];
    }

    bool is_dynamic(std::size_t body) const {
        return body != sdf_none && scene_.world.body(bodies_.ids[body]).type() == BodyType::dynamic;
    }

    void place(std::size_t body, const Rigid& frame, BodyId& id, Transform& at) const {
        if (body != sdf_none) id = bodies_.ids[body];
        at = (body == sdf_none ? upright * frame : inverse(bodies_.worlds[body]) * (upright * frame)).transform();
    }

    // Returns the axis in the world of the file.
    glm::dvec3 axis_of(const SdfJoint& joint, const std::optional<XmlElement>& axis, const char* name) const {
        const auto xyz = axis ? axis->child("xyz") : std::nullopt;
        Rigid in = model_.world(joint.frame);
        const SdfScope& scope = model_.scopes[joint.scope];
        glm::dvec3 direction(0.0, 0.0, 1.0);
        if (xyz) {
            XmlText text = xyz->text();
            text.place = joint.element.place() + ": " + name + " xyz";
            direction = text.vector3();
            const double length = std::sqrt(glm::dot(direction, direction));
            if (!(length > 1e-9 && length < 1e9)) text.fail("must be a vector that is not zero");
            direction /= length;
            if (const auto frame = xyz->attribute("expressed_in"); frame && !frame->text.empty()) {
                in = model_.world(model_.find(joint.scope, *frame));
            }
        }
        const auto in_model = axis ? axis->child_text("use_parent_model_frame") : std::nullopt;
        if (scope.has_old_axes || (in_model && in_model->boolean())) in = model_.world(scope.frame);
        return in.rotation * direction;
    }

    JointControl control_of(const XmlElement& axis, bool is_endless) {
        JointControl control;
        JointMotor motor;
        motor.spring = JointSpring{};
        bool has_motor = false;
        if (const auto limit = axis.child("limit")) {
            const auto lower = limit->child_text("lower"), upper = limit->child_text("upper");
            const double low = lower ? bound(*lower) : -endless, high = upper ? bound(*upper) : endless;
            if (!is_endless && (low > -endless || high < endless)) {
                if (!(low <= high)) (lower ? *lower : *upper).fail("must be at most the upper bound");
                const float infinite = std::numeric_limits<float>::infinity();
                control.limits = JointRange{low > -endless ? static_cast<float>(low) : -infinite,
                                            high < endless ? static_cast<float>(high) : infinite, std::nullopt};
            }
            if (const auto effort = limit->child_text("effort")) {
                const double most = bound(*effort);
                if (most > 0.0 && most < endless) motor.max_force = static_cast<float>(most), has_motor = true;
            }
            if (const auto speed = limit->child_text("velocity")) {
                const double most = bound(*speed);
                if (most > 0.0 && most < endless) speed_ = most;
            }
        }
        if (const auto dynamics = axis.child("dynamics")) {
            const auto value = [&](const char* name) {
                const auto text = dynamics->child_text(name);
                return text ? static_cast<float>(text->number(0.0, 1e30)) : 0.0f;
            };
            motor.spring->damping = value("damping");
            motor.spring->stiffness = value("spring_stiffness");
            if (const auto rest = dynamics->child_text("spring_reference")) {
                motor.position = static_cast<float>(rest->number(-1e9, 1e9));
            }
            control.friction = value("friction");
            has_motor = has_motor || motor.spring->damping > 0.0f || motor.spring->stiffness > 0.0f;
            if (motor.spring->stiffness > 0.0f) motor.max_force = std::numeric_limits<float>::infinity();
        }
        if (has_motor) control.motor = motor;
        return control;
    }

    // Reads a limit, which may be any number; the format writes 1e16 or inf for unlimited.
    static double bound(const XmlText& text) {
        if (text.text == "inf" || text.text == "+inf") return endless;
        if (text.text == "-inf") return -endless;
        return std::clamp(text.number(-most_double, most_double), -endless, endless);
    }

    bool make_universal(const SdfJoint& joint, JointDef& def, Rigid& frame) {
        const auto first = joint.element.child("axis"), second = joint.element.child("axis2");
        if (!first || !second) joint.element.fail("must have the elements axis and axis2");
        const glm::dvec3 x = axis_of(joint, first, "axis"), given = axis_of(joint, second, "axis2");
        const glm::dvec3 across = given - glm::dot(given, x) * x;
        const double length = std::sqrt(glm::dot(across, across));
        if (length < 0.5) {
            throw Error(ErrorCode::unsupported, joint.element.place(), {}, "must have two axes across each other");
        }
        if (length < 0.999) {
            warnings_.push_back(joint.element.place() + ": axis2 is taken at a right angle to axis");
        }
        const glm::dvec3 y = across / length;
        frame.rotation = glm::normalize(glm::quat_cast(glm::dmat3(x, y, glm::cross(x, y))));
        def.joint = UniversalJoint{control_of(*first, false), control_of(*second, false)};
        return true;
    }

    const SdfModel& model_;
    const SdfBodies& bodies_;
    std::vector<std::string>& warnings_;
    Scene& scene_;
    double speed_ = 0.0;
};

} // namespace

void add_sdf_joints(const SdfModel& model, const SdfBodies& bodies, std::vector<std::string>& warnings, Scene& scene) {
    SdfJointMaker maker(model, bodies, warnings, scene);
    for (const SdfJoint& joint : model.joints) maker.add(joint);
}

} // namespace cairn::scene
