// Joints of MJCF models. A body may have several joints in a chain, each of which moves the axes of the later ones:
// they become one joint where a joint type of the engine matches, else several with light bodies between them.
#include "scene/json_number.h"
#include "scene/mjcf_model.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cairn::scene {

namespace {

constexpr double between_share = 0.05; // mass of a light body between two joints, as a share of the mass of the body
// Target speed, m/s or rad/s, that is never reached, so that the motor exerts its force at all times.
constexpr float fast = 1000.0f;

bool are_parallel(const glm::dvec3& a, const glm::dvec3& b) { return std::fabs(glm::dot(a, b)) > 1.0 - 1e-6; }
bool are_square(const glm::dvec3& a, const glm::dvec3& b) { return std::fabs(glm::dot(a, b)) < 1e-4; }

float single(double value) { return static_cast<float>(std::clamp(value, -1e30, 1e30)); }

// Returns the motor of an engine coordinate that is `sign` times the joint coordinate minus `offset`.
std::optional<JointMotor> motor_of(const MjcfJoint& joint, double sign, double offset) {
    const MjcfDrive& drive = joint.drive;
    const double k = drive.stiffness, d = drive.damping;
    if (!drive.is_driven && k == 0.0 && d == 0.0) return std::nullopt;
    JointMotor motor;
    motor.spring = JointSpring{single(k), single(d), false};
    double push = drive.force;
    if (k > 0.0) {
        motor.position = single(sign * ((drive.stiffness_position + push) / k - offset));
        push = 0.0;
    }
    if (d > 0.0) {
        motor.velocity = single(sign * (drive.damping_velocity + push) / d);
        push = 0.0;
    }
    // A spring of the joint is not limited by the force of an actuator.
    if (drive.is_driven && drive.is_bounded && joint.stiffness == 0.0) motor.max_force = single(drive.most);
    if (drive.is_driven && joint.effort) motor.max_force = std::min(motor.max_force, single(*joint.effort));
    if (push != 0.0) {
        motor.spring.reset();
        motor.velocity = push * sign > 0.0 ? fast : -fast;
        motor.max_force = std::min(motor.max_force, single(std::fabs(push)));
    }
    return motor;
}

std::optional<JointRange> range_of(const MjcfJoint& joint, double sign, double offset) {
    if (!joint.range) return std::nullopt;
    const double a = sign * (joint.range->first - offset), b = sign * (joint.range->second - offset);
    return JointRange{single(std::min(a, b)), single(std::max(a, b)), std::nullopt};
}

JointControl control_of(const MjcfJoint& joint) {
    return {range_of(joint, 1.0, 0.0), motor_of(joint, 1.0, 0.0), single(joint.friction)};
}

// Returns a frame with that x axis, and a y axis as near to `y` as possible.
glm::dquat frame_with(const glm::dvec3& x, const glm::dvec3& y) {
    const glm::dvec3 across = glm::normalize(y - glm::dot(x, y) * x);
    return glm::normalize(glm::quat_cast(glm::dmat3(x, across, glm::cross(x, across))));
}

const glm::dvec3 x_axis(1.0, 0.0, 0.0), y_axis(0.0, 1.0, 0.0);

class MjcfJointMaker {
  public:
    MjcfJointMaker(MjcfModel& model, Scene& scene) : model_(model), scene_(scene) {}

    void add(const MjcfPart& part) {
        if (part.kind != MjcfPart::Kind::moving) return;
        const MjcfPart& parent = model_.parts[part.parent];
        part_ = &part;
        joints_.clear();
        for (const std::size_t index : part.joints) {
            if (model_.joints[index].kind != MjcfJoint::Kind::free) joints_.push_back(&model_.joints[index]);
        }
        if (joints_.empty()) return;
        above_ = parent.id;
        frame_ = (parent.id.is_null() ? parent.body.world : Rigid()) * part.frame;
        pose_ = parent.body.world * part.frame;
        collides_ = parent.kind != MjcfPart::Kind::moving || !model_.settings.filters_parents;
        const bool parent_collides = collides_;
        for (std::size_t first = 0; first < joints_.size();) {
            std::size_t count = joints_.size() - first;
            std::optional<JointDef> def = joined(first, count);
            while (!def) def = joined(first, --count); // a single joint always has a match
            if (first + count < joints_.size()) {
                step_between(first, count, *def);
            } else {
                def->body_b = part.id;
                create(*def, first, count);
                if (first > 0 && !parent_collides) disable_collision(parent.id);
            }
            first += count;
        }
    }

  private:
    JointDef def_at(const Rigid& along_a, const Rigid& along_b) const {
        JointDef def;
        def.body_a = above_;
        def.frame_a = (frame_ * along_a).transform();
        def.frame_b = along_b.transform();
        def.enable_collision = collides_;
        return def;
    }

    void create(JointDef& def, std::size_t first, std::size_t count) {
        for (std::size_t i = first; i < first + count; ++i) {
            const std::string& name = joints_[i]->name;
            if (!name.empty()) def.name += (def.name.empty() ? "" : "+") + name;
        }
        try {
            const JointId id = scene_.world.create_joint(def);
            if (count == 1) joints_[first]->id = id;
        } catch (const Error& error) {
            throw Error(ErrorCode::invalid_file, joints_[first]->place, {}, error.what());
        }
    }

    // With a light body between them, a body and its parent share no joint that would disable their collision.
    void disable_collision(BodyId parent) {
        JointDef def;
        def.body_a = parent;
        def.body_b = part_->id;
        def.joint = GeneralJoint{}; // without limits; it only disables collision
        def.name = "exclude " + part_->body.name;
        scene_.world.create_joint(def);
    }

    // The light body takes a share of the mass of the body that these joints move.
    void step_between(std::size_t first, std::size_t count, JointDef& def) {
        Body body = scene_.world.body(part_->id);
        MassProperties share = body.mass_properties(), rest = share;
        const float part = static_cast<float>(between_share);
        share.mass *= part, share.inertia_diagonal *= part;
        rest.mass *= 1.0f - part, rest.inertia_diagonal *= 1.0f - part;
        for (std::size_t i = first; i < first + count; ++i) {
            const MjcfJoint& joint = *joints_[i];
            const Rigid there{joint.anchor, {1.0, 0.0, 0.0, 0.0}};
            pose_ = pose_ * (joint.is_scalar() ? joint.motion(joint.start - joint.reference)
                                               : there * Rigid{{0, 0, 0}, joint.start_turn} * inverse(there));
        }
        BodyDef between;
        between.position = pose_.position;
        between.rotation = Quat(pose_.rotation);
        between.name = part_->body.name + " between joints";
        between.gravity_scale = body.gravity_scale();
        between.mass_properties = share;
        const BodyId id = scene_.world.create_body(between);
        body.set_mass_properties(rest);
        def.body_b = id;
        create(def, first, count);
        model_.warnings.push_back(part_->body.place + ": its joints become several, with " +
                                  short_number(static_cast<double>(share.mass)) + " kg of its " +
                                  short_number(static_cast<double>(share.mass + rest.mass)) + " kg between them");
        above_ = id;
        frame_ = {};
        collides_ = false;
    }

    std::optional<JointDef> joined(std::size_t first, std::size_t count) {
        if (count == 1) return one(*joints_[first]);
        if (count == 2) {
            if (auto def = cylindrical(*joints_[first], *joints_[first + 1])) return def;
            if (auto def = universal(*joints_[first], *joints_[first + 1])) return def;
        }
        return general(first, count);
    }

    // Frame A is the pose of the joint at coordinate 0, relative to the pose in the model file.
    JointDef one(const MjcfJoint& joint) const {
        Rigid along{joint.anchor, {1.0, 0.0, 0.0, 0.0}};
        if (joint.kind == MjcfJoint::Kind::ball) {
            JointDef def = def_at(along, along);
            def.joint = ball(joint);
            return def;
        }
        along.rotation = turn_from_x(joint.axis);
        const bool turns = joint.kind == MjcfJoint::Kind::hinge;
        const Rigid back = turns ? Rigid{{0, 0, 0}, turn_about(x_axis, -joint.reference)}
                                 : Rigid{-joint.reference * x_axis, {1.0, 0.0, 0.0, 0.0}};
        JointDef def = def_at(along * back, along);
        if (turns) {
            def.joint = HingeJoint{control_of(joint)};
        } else {
            def.joint = SliderJoint{control_of(joint)};
        }
        return def;
    }

    static Joint ball(const MjcfJoint& joint) {
        const bool is_plain = !joint.range && joint.stiffness == 0.0 && joint.damping == 0.0;
        if (is_plain) return BallJoint{std::nullopt, std::nullopt, single(joint.friction)};
        GeneralJoint made;
        made.limits.push_back({JointAxis::linear, {true, true, true}, 0.0f, 0.0f, std::nullopt, 0.0f});
        if (joint.range) {
            made.limits.push_back({JointAxis::angular,
                                   {true, true, true},
                                   std::nullopt,
                                   single(joint.range->second),
                                   std::nullopt,
                                   0.0f});
        }
        for (int axis = 0; axis < 3 && (joint.stiffness > 0.0 || joint.damping > 0.0); ++axis) {
            made.drives.push_back({JointAxis::angular, false, axis, std::nullopt, 0.0f, 0.0f, single(joint.stiffness),
                                   single(joint.damping)});
        }
        return made;
    }

    std::optional<JointDef> cylindrical(const MjcfJoint& first, const MjcfJoint& second) const {
        if (!first.is_scalar() || !second.is_scalar() || first.kind == second.kind) return std::nullopt;
        const MjcfJoint& slide = first.kind == MjcfJoint::Kind::slide ? first : second;
        const MjcfJoint& hinge = &slide == &first ? second : first;
        if (glm::dot(slide.axis, hinge.axis) < 1.0 - 1e-6) return std::nullopt;
        const Rigid along{hinge.anchor, turn_from_x(hinge.axis)};
        JointDef def = def_at(along * Rigid{-slide.reference * x_axis, turn_about(x_axis, -hinge.reference)}, along);
        def.joint = CylindricalJoint{control_of(slide), control_of(hinge)};
        return def;
    }

    std::optional<JointDef> universal(const MjcfJoint& first, const MjcfJoint& second) const {
        using Kind = MjcfJoint::Kind;
        if (first.kind != Kind::hinge || second.kind != Kind::hinge) return std::nullopt;
        if (!are_square(first.axis, second.axis) || !is_near(first.anchor, second.anchor)) return std::nullopt;
        const Rigid along{first.anchor, frame_with(first.axis, second.axis)};
        JointDef def = def_at(along * Rigid{{0, 0, 0}, turn_about(x_axis, -first.reference)},
                              along * Rigid{{0, 0, 0}, turn_about(y_axis, second.reference)});
        def.joint = UniversalJoint{control_of(first), control_of(second)};
        return def;
    }

    static bool is_near(const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a - b, a - b) < 1e-12; }

    // Combines slides at right angles, followed by at most one hinge along or across them.
    std::optional<JointDef> general(std::size_t first, std::size_t count) {
        std::array<glm::dvec3, 3> axes{};
        int known = 0;
        std::array<const MjcfJoint*, 6> at{}; // by axis: three slides, three hinges
        std::array<double, 6> signs{};
        std::optional<glm::dvec3> anchor;
        for (std::size_t i = first; i < first + count; ++i) {
            const MjcfJoint& joint = *joints_[i];
            const bool turns = joint.kind == MjcfJoint::Kind::hinge;
            if (!joint.is_scalar() || anchor) return std::nullopt;
            if (turns) anchor = joint.anchor;
            int axis = 0;
            while (axis < known && !are_parallel(axes[static_cast<std::size_t>(axis)], joint.axis)) {
                if (!are_square(axes[static_cast<std::size_t>(axis++)], joint.axis)) return std::nullopt;
            }
            if (axis == known) axes[static_cast<std::size_t>(known++)] = joint.axis;
            const std::size_t slot = static_cast<std::size_t>(axis) + (turns ? 3 : 0);
            if (at[slot] != nullptr) return std::nullopt;
            at[slot] = &joint;
            signs[slot] = glm::dot(axes[static_cast<std::size_t>(axis)], joint.axis) > 0.0 ? 1.0 : -1.0;
        }
        if (known == 1) axes[1] = turn_from_x(axes[0]) * y_axis;
        const Rigid along{anchor.value_or(joints_[first]->anchor), frame_with(axes[0], axes[1])};
        const double third = glm::dot(along.rotation * glm::dvec3(0, 0, 1), axes[2]);
        for (const std::size_t slot : {std::size_t{2}, std::size_t{5}}) signs[slot] *= known == 3 && third < 0 ? -1 : 1;
        GeneralJoint made = rows_of(at, signs);
        if (rows(made) > 8) return std::nullopt; // the engine's limit for a joint
        JointDef def = def_at(along, along);
        def.joint = std::move(made);
        return def;
    }

    static std::size_t rows(const GeneralJoint& joint) {
        std::size_t count = joint.drives.size();
        for (const JointLimit& limit : joint.limits) count += limit.min != 0.0f || limit.max != 0.0f;
        return count;
    }

    GeneralJoint rows_of(const std::array<const MjcfJoint*, 6>& at, const std::array<double, 6>& signs) {
        GeneralJoint made;
        for (int kind = 0; kind < 2; ++kind) {
            const JointAxis type = kind == 0 ? JointAxis::linear : JointAxis::angular;
            JointLimit locked{type, {}, 0.0f, 0.0f, std::nullopt, 0.0f};
            for (int axis = 0; axis < 3; ++axis) {
                const std::size_t slot = static_cast<std::size_t>(3 * kind + axis),
                                  index = static_cast<std::size_t>(axis);
                if (at[slot] == nullptr) {
                    locked.axes[index] = true;
                    continue;
                }
                const MjcfJoint& joint = *at[slot];
                if (const auto range = range_of(joint, signs[slot], joint.reference)) {
                    JointLimit limit{type, {}, range->lower, range->upper, std::nullopt, 0.0f};
                    limit.axes[index] = true;
                    made.limits.push_back(limit);
                }
                if (const auto motor = motor_of(joint, signs[slot], joint.reference))
                    add_drive(*motor, type, axis, made);
                if (joint.friction > 0.0) {
                    model_.warnings.push_back(joint.place +
                                              ": frictionloss is left out, as of several joints that are one");
                }
            }
            if (locked.axes[0] || locked.axes[1] || locked.axes[2]) made.limits.push_back(locked);
        }
        return made;
    }

    static void add_drive(const JointMotor& motor, JointAxis type, int axis, GeneralJoint& made) {
        JointDrive drive{type, false, axis, std::nullopt, motor.position, motor.velocity, 0.0f, 0.0f};
        if (std::isfinite(motor.max_force)) drive.max_force = motor.max_force;
        if (motor.spring) drive.stiffness = motor.spring->stiffness, drive.damping = motor.spring->damping;
        if (!motor.spring) drive.damping = 1e6f; // high damping, to hold the velocity stiffly
        if (drive.stiffness > 0.0f || drive.damping > 0.0f) made.drives.push_back(drive);
    }

    MjcfModel& model_;
    Scene& scene_;
    const MjcfPart* part_ = nullptr;
    std::vector<MjcfJoint*> joints_;
    BodyId above_; // the body that the next joint attaches to
    Rigid frame_;  // pose of the part in the frame of `above_`, in the pose of the model file
    Rigid pose_;   // pose of the part in the world, moved by the joints so far
    bool collides_ = false;
};

} // namespace

void add_mjcf_joints(MjcfModel& model, Scene& scene) {
    MjcfJointMaker maker(model, scene);
    for (const MjcfPart& part : model.parts) maker.add(part);
}

} // namespace cairn::scene
