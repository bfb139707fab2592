#include "scene/joint_types.h"

#include "scene/json_number.h"
#include "scene/spelling.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace cairn::scene {

namespace {

using Json = nlohmann::ordered_json;

constexpr float unbounded = std::numeric_limits<float>::infinity();

const std::array<std::pair<const char*, Joint>, 13>& types() {
    static const std::array<std::pair<const char*, Joint>, 13> all{{{"fixed", FixedJoint{}},
                                                                    {"ball", BallJoint{}},
                                                                    {"hinge", HingeJoint{}},
                                                                    {"slider", SliderJoint{}},
                                                                    {"cylindrical", CylindricalJoint{}},
                                                                    {"universal", UniversalJoint{}},
                                                                    {"distance", DistanceJoint{}},
                                                                    {"wheel", WheelJoint{}},
                                                                    {"servo", ServoJoint{}},
                                                                    {"gear", GearJoint{}},
                                                                    {"rack", RackJoint{}},
                                                                    {"pulley", PulleyJoint{}},
                                                                    {"general", GeneralJoint{}}}};
    return all;
}

// --- One list of the members of each joint type, for both reading and writing

template <class Io, class Spring>
requires std::is_same_v<std::remove_const_t<Spring>, JointSpring>
void members(Io& io, Spring& spring) {
    io("stiffness", spring.stiffness, 0.0f);
    io("damping", spring.damping, 0.0f);
    io("is_acceleration", spring.is_acceleration);
}
template <class Io, class Range>
requires std::is_same_v<std::remove_const_t<Range>, JointRange>
void members(Io& io, Range& range) {
    io("lower", range.lower, -unbounded);
    io("upper", range.upper, unbounded);
    io("spring", range.spring);
}
template <class Io, class Motor>
requires std::is_same_v<std::remove_const_t<Motor>, JointMotor>
void members(Io& io, Motor& motor) {
    io("velocity", motor.velocity, 0.0f);
    io("position", motor.position, 0.0f);
    io("spring", motor.spring);
    io("max_force", motor.max_force, unbounded);
}
template <class Io, class Control>
requires std::is_same_v<std::remove_const_t<Control>, JointControl>
void members(Io& io, Control& control) {
    io("limits", control.limits);
    io("motor", control.motor);
    io("friction", control.friction, 0.0f);
}

template <class Io, class T> struct Members {
    Io& io;
    T& joint;
    template <class J> static constexpr bool is = std::is_same_v<std::remove_const_t<T>, J>;

    void list() const {
        if constexpr (is<BallJoint>) {
            io("cone_angle", joint.cone_angle);
            io("twist", joint.twist);
            io("friction", joint.friction, 0.0f);
        } else if constexpr (is<HingeJoint>) {
            io("angle", joint.angle);
        } else if constexpr (is<SliderJoint>) {
            io("translation", joint.translation);
        } else if constexpr (is<CylindricalJoint>) {
            io("translation", joint.translation);
            io("angle", joint.angle);
        } else if constexpr (is<UniversalJoint>) {
            io("first", joint.first);
            io("second", joint.second);
        } else if constexpr (is<DistanceJoint>) {
            io("distance", joint.distance);
        } else if constexpr (is<WheelJoint>) {
            io("suspension", joint.suspension);
            io("steering", joint.steering);
            io("spin", joint.spin);
        } else if constexpr (is<ServoJoint>) {
            io("position", joint.position);
            io("rotation", joint.rotation);
            io("linear", joint.linear);
            io("angular", joint.angular);
            io("max_force", joint.max_force, unbounded);
            io("max_torque", joint.max_torque, unbounded);
        } else if constexpr (is<GearJoint>) {
            io("ratio", joint.ratio, GearJoint{}.ratio);
        } else if constexpr (is<RackJoint>) {
            io("radius", joint.radius, RackJoint{}.radius);
        } else if constexpr (is<PulleyJoint>) {
            io("ground_a", joint.ground_a);
            io("ground_b", joint.ground_b);
            io("ratio", joint.ratio, PulleyJoint{}.ratio);
            io("length", joint.length);
        }
    }
};
template <class Io, class T> void members_of_joint(Io& io, T& joint) { Members<Io, T>{io, joint}.list(); }

class Reader {
  public:
    explicit Reader(const Value& value) : value_(value) { value.must_be_object(); }

    void operator()(const char* name, float& number, float absent) const {
        const auto found = value_.find(name);
        number = found ? found->real() : absent;
    }
    void operator()(const char* name, bool& flag) const {
        if (const auto found = value_.find(name)) flag = found->boolean();
    }
    void operator()(const char* name, Vec3& vector) const {
        if (const auto found = value_.find(name)) vector = found->float_vector3();
    }
    void operator()(const char* name, Position& position) const {
        if (const auto found = value_.find(name)) position = found->vector3();
    }
    void operator()(const char* name, Quat& rotation) const {
        if (const auto found = value_.find(name)) rotation = Quat(found->rotation());
    }
    void operator()(const char* name, std::optional<float>& number) const {
        if (const auto found = value_.find(name)) number = found->real();
    }
    template <class T> void operator()(const char* name, std::optional<T>& part) const {
        const auto found = value_.find(name);
        if (!found) return;
        part.emplace();
        const Reader reader(*found);
        members(reader, *part);
    }
    template <class T> void operator()(const char* name, T& part) const {
        const auto found = value_.find(name);
        if (!found) return;
        part = {};
        const Reader reader(*found);
        members(reader, part);
    }

  private:
    const Value& value_;
};

// Warns of members that the joint type does not have.
class JointSpeller {
  public:
    JointSpeller(const Value& value, std::vector<std::string> known, std::vector<std::string>& warnings)
        : value_(value), known_(std::move(known)), warnings_(warnings) {}

    template <class T> void operator()(const char* name, T& part, float = 0.0f) {
        known_.emplace_back(name);
        if constexpr (is_object<T>) {
            const auto found = value_.find(name);
            if (!found || !found->is_object()) return;
            JointSpeller inside(*found, {}, warnings_);
            members(inside, part);
            inside.finish();
        }
    }
    template <class T> void operator()(const char* name, std::optional<T>& part) {
        T inside = part.value_or(T{});
        (*this)(name, inside);
    }
    void finish() { warn_of_unknown_members(value_, known_, warnings_); }

  private:
    template <class T>
    static constexpr bool is_object = std::is_same_v<T, JointSpring> || std::is_same_v<T, JointRange> ||
                                      std::is_same_v<T, JointMotor> || std::is_same_v<T, JointControl>;
    const Value& value_;
    std::vector<std::string> known_;
    std::vector<std::string>& warnings_;
};

class JointTypeWriter {
  public:
    Json json = Json::object();

    void operator()(const char* name, float number, float absent) {
        if (number != absent && std::isfinite(number)) json[name] = shortest(number);
    }
    void operator()(const char* name, bool flag) {
        if (flag) json[name] = true;
    }
    void operator()(const char* name, const Vec3& vector) {
        if (vector != Vec3(0.0f)) json[name] = number_array(vector);
    }
    void operator()(const char* name, const Position& position) {
        if (position != Position(0.0)) json[name] = number_array(position);
    }
    void operator()(const char* name, const Quat& rotation) {
        if (rotation != Quat(1.0f, 0.0f, 0.0f, 0.0f)) json[name] = number_array(rotation);
    }
    void operator()(const char* name, const std::optional<float>& number) {
        if (number) json[name] = shortest(*number);
    }
    template <class T> void operator()(const char* name, const std::optional<T>& part) {
        if (part) write(name, *part);
    }
    template <class T> void operator()(const char* name, const T& part) { write(name, part); }

  private:
    template <class T> void write(const char* name, const T& part) {
        JointTypeWriter writer;
        members(writer, part);
        json[name] = std::move(writer.json);
    }
};

// --- Conversion to the nearest joint of the draft

struct Nearest {
    GeneralJoint made;

    void lock(JointAxis kind, std::array<bool, 3> axes) {
        made.limits.push_back({kind, axes, 0.0f, 0.0f, std::nullopt, 0.0f});
    }
    void lock_point() { lock(JointAxis::linear, {true, true, true}); }
    void lock_turn() { lock(JointAxis::angular, {true, true, true}); }

    void range(JointAxis kind, std::array<bool, 3> axes, const JointRange& range) {
        JointLimit limit{kind, axes, std::nullopt, std::nullopt, std::nullopt, 0.0f};
        if (std::isfinite(range.lower)) limit.min = range.lower;
        if (std::isfinite(range.upper)) limit.max = range.upper;
        // The draft's limits have force springs only; a rigid limit is a better approximation of an acceleration spring
        // than no limit.
        if (range.spring && !range.spring->is_acceleration) {
            limit.stiffness = range.spring->stiffness;
            limit.damping = range.spring->damping;
        }
        made.limits.push_back(limit);
    }
    void spring(JointAxis kind, int axis, const JointSpring& spring, float most, float position, float velocity) {
        JointDrive drive;
        drive.kind = kind;
        drive.axis = axis;
        drive.is_acceleration = spring.is_acceleration;
        if (std::isfinite(most)) drive.max_force = most;
        drive.position_target = position;
        drive.velocity_target = velocity;
        drive.stiffness = spring.stiffness;
        drive.damping = spring.damping;
        made.drives.push_back(drive);
    }
    // The draft has neither friction nor a motor that holds a velocity with unlimited force.
    void control(JointAxis kind, int axis, const JointControl& control) {
        std::array<bool, 3> axes{};
        axes[static_cast<std::size_t>(axis)] = true;
        if (control.limits) range(kind, axes, *control.limits);
        if (!control.motor || !control.motor->spring) return;
        const JointMotor& motor = *control.motor;
        spring(kind, axis, *motor.spring, motor.max_force, motor.position, motor.velocity);
    }

    void operator()(const FixedJoint&) {
        lock_point();
        lock_turn();
    }
    void operator()(const BallJoint& joint) {
        lock_point();
        if (joint.cone_angle) {
            made.limits.push_back(
                {JointAxis::angular, {false, true, true}, std::nullopt, *joint.cone_angle, std::nullopt, 0.0f});
        }
        if (joint.twist) range(JointAxis::angular, {true, false, false}, *joint.twist);
    }
    void operator()(const HingeJoint& joint) {
        lock_point();
        lock(JointAxis::angular, {false, true, true});
        control(JointAxis::angular, 0, joint.angle);
    }
    void operator()(const SliderJoint& joint) {
        lock(JointAxis::linear, {false, true, true});
        lock_turn();
        control(JointAxis::linear, 0, joint.translation);
    }
    void operator()(const CylindricalJoint& joint) {
        lock(JointAxis::linear, {false, true, true});
        lock(JointAxis::angular, {false, true, true});
        control(JointAxis::linear, 0, joint.translation);
        control(JointAxis::angular, 0, joint.angle);
    }
    void operator()(const UniversalJoint& joint) {
        lock_point();
        lock(JointAxis::angular, {false, false, true});
        control(JointAxis::angular, 0, joint.first);
        control(JointAxis::angular, 1, joint.second);
    }
    void operator()(const DistanceJoint& joint) {
        if (joint.distance.limits) range(JointAxis::linear, {true, true, true}, *joint.distance.limits);
    }
    void operator()(const WheelJoint& joint) {
        lock(JointAxis::linear, {false, true, true});
        lock(JointAxis::angular, {!joint.steering, false, true});
        control(JointAxis::linear, 0, joint.suspension);
        if (joint.steering) control(JointAxis::angular, 0, *joint.steering);
        control(JointAxis::angular, 1, joint.spin);
    }
    void operator()(const ServoJoint& joint) {
        for (int i = 0; i < 3; ++i) {
            spring(JointAxis::linear, i, joint.linear, joint.max_force, joint.position[i], 0.0f);
        }
        // Decomposing a rotation target into several angles has no agreed convention, so only the identity is
        // converted.
        if (joint.rotation != Quat(1.0f, 0.0f, 0.0f, 0.0f)) return;
        for (int i = 0; i < 3; ++i) spring(JointAxis::angular, i, joint.angular, joint.max_torque, 0.0f, 0.0f);
    }
    void operator()(const GearJoint&) {} // the draft has no equivalent of gear, rack and pulley joints
    void operator()(const RackJoint&) {}
    void operator()(const PulleyJoint&) {}
    void operator()(const GeneralJoint& joint) { made = joint; }
};

} // namespace

Joint read_typed_joint(const Value& own) {
    const Value type = own.require("type");
    const std::string name = type.text();
    std::string known;
    for (const auto& [candidate, blank] : types()) {
        if (name == candidate) {
            Joint joint = blank;
            const Reader reader(own);
            std::visit([&](auto& j) { members_of_joint(reader, j); }, joint);
            return joint;
        }
        known += (known.empty() ? "\"" : ", \"") + std::string(candidate) + "\"";
    }
    type.fail("must be one of " + known);
}

void warn_of_unknown_joint_members(const Value& own, std::vector<std::string>& warnings) {
    const auto type = own.find("type");
    const std::string name = type && type->is_string() ? type->text() : "general";
    for (const auto& [candidate, blank] : types()) {
        if (name != candidate) continue;
        JointSpeller speller(own, {"type", "break_force", "break_torque", "solver", "enabled"}, warnings);
        Joint joint = blank;
        std::visit([&](auto& j) { members_of_joint(speller, j); }, joint);
        speller.finish();
    }
}

Json write_typed_joint(const Joint& joint) {
    JointTypeWriter writer;
    if (std::holds_alternative<GeneralJoint>(joint)) return writer.json;
    writer.json["type"] = types()[joint.index()].first;
    std::visit([&](const auto& j) { members_of_joint(writer, j); }, joint);
    return std::move(writer.json);
}

GeneralJoint nearest_general_joint(const Joint& joint) {
    Nearest nearest;
    std::visit(nearest, joint);
    return std::move(nearest.made);
}

} // namespace cairn::scene
