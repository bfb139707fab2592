// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "module/containers.h"

namespace cairn::python {

void read(py::handle o, JointAxis& x, const Where& where) {
    x = JointAxis(read_enum(o, "JointAxis", where));
}
py::object write(JointAxis x) { return write_enum("JointAxis", int(x)); }

void read(py::handle o, JointSolver& x, const Where& where) {
    x = JointSolver(read_enum(o, "JointSolver", where));
}
py::object write(JointSolver x) { return write_enum("JointSolver", int(x)); }

void read(py::handle o, JointSpring& x, const Where& where) {
    if (!is_a(o, "JointSpring")) refuse_type(where, "a JointSpring", o);
    read(o.attr("stiffness"), x.stiffness, {"JointSpring", "stiffness"});
    read(o.attr("damping"), x.damping, {"JointSpring", "damping"});
    read(o.attr("is_acceleration"), x.is_acceleration, {"JointSpring", "is_acceleration"});
}
py::object write(const JointSpring& x) {
    return make("JointSpring", py::make_tuple(write(x.stiffness), write(x.damping), write(x.is_acceleration)));
}

void read(py::handle o, JointRange& x, const Where& where) {
    if (!is_a(o, "JointRange")) refuse_type(where, "a JointRange", o);
    read(o.attr("lower"), x.lower, {"JointRange", "lower"});
    read(o.attr("upper"), x.upper, {"JointRange", "upper"});
    read(o.attr("spring"), x.spring, {"JointRange", "spring"});
}
py::object write(const JointRange& x) {
    return make("JointRange", py::make_tuple(write(x.lower), write(x.upper), write(x.spring)));
}

void read(py::handle o, JointMotor& x, const Where& where) {
    if (!is_a(o, "JointMotor")) refuse_type(where, "a JointMotor", o);
    read(o.attr("velocity"), x.velocity, {"JointMotor", "velocity"});
    read(o.attr("position"), x.position, {"JointMotor", "position"});
    read(o.attr("spring"), x.spring, {"JointMotor", "spring"});
    read(o.attr("max_force"), x.max_force, {"JointMotor", "max_force"});
}
py::object write(const JointMotor& x) {
    return make("JointMotor", py::make_tuple(write(x.velocity), write(x.position), write(x.spring),
        write(x.max_force)));
}

void read(py::handle o, JointControl& x, const Where& where) {
    if (!is_a(o, "JointControl")) refuse_type(where, "a JointControl", o);
    read(o.attr("limits"), x.limits, {"JointControl", "limits"});
    read(o.attr("motor"), x.motor, {"JointControl", "motor"});
    read(o.attr("friction"), x.friction, {"JointControl", "friction"});
}
py::object write(const JointControl& x) {
    return make("JointControl", py::make_tuple(write(x.limits), write(x.motor), write(x.friction)));
}

void read(py::handle o, [[maybe_unused]] FixedJoint& x, const Where& where) {
    if (!is_a(o, "FixedJoint")) refuse_type(where, "a FixedJoint", o);
}
py::object write([[maybe_unused]] const FixedJoint& x) {
    return make("FixedJoint", py::make_tuple());
}

void read(py::handle o, BallJoint& x, const Where& where) {
    if (!is_a(o, "BallJoint")) refuse_type(where, "a BallJoint", o);
    read(o.attr("cone_angle"), x.cone_angle, {"BallJoint", "cone_angle"});
    read(o.attr("twist"), x.twist, {"BallJoint", "twist"});
    read(o.attr("friction"), x.friction, {"BallJoint", "friction"});
}
py::object write(const BallJoint& x) {
    return make("BallJoint", py::make_tuple(write(x.cone_angle), write(x.twist), write(x.friction)));
}

void read(py::handle o, HingeJoint& x, const Where& where) {
    if (!is_a(o, "HingeJoint")) refuse_type(where, "a HingeJoint", o);
    read(o.attr("angle"), x.angle, {"HingeJoint", "angle"});
}
py::object write(const HingeJoint& x) {
    return make("HingeJoint", py::make_tuple(write(x.angle)));
}

void read(py::handle o, SliderJoint& x, const Where& where) {
    if (!is_a(o, "SliderJoint")) refuse_type(where, "a SliderJoint", o);
    read(o.attr("translation"), x.translation, {"SliderJoint", "translation"});
}
py::object write(const SliderJoint& x) {
    return make("SliderJoint", py::make_tuple(write(x.translation)));
}

void read(py::handle o, CylindricalJoint& x, const Where& where) {
    if (!is_a(o, "CylindricalJoint")) refuse_type(where, "a CylindricalJoint", o);
    read(o.attr("translation"), x.translation, {"CylindricalJoint", "translation"});
    read(o.attr("angle"), x.angle, {"CylindricalJoint", "angle"});
}
py::object write(const CylindricalJoint& x) {
    return make("CylindricalJoint", py::make_tuple(write(x.translation), write(x.angle)));
}

void read(py::handle o, UniversalJoint& x, const Where& where) {
    if (!is_a(o, "UniversalJoint")) refuse_type(where, "a UniversalJoint", o);
    read(o.attr("first"), x.first, {"UniversalJoint", "first"});
    read(o.attr("second"), x.second, {"UniversalJoint", "second"});
}
py::object write(const UniversalJoint& x) {
    return make("UniversalJoint", py::make_tuple(write(x.first), write(x.second)));
}

void read(py::handle o, DistanceJoint& x, const Where& where) {
    if (!is_a(o, "DistanceJoint")) refuse_type(where, "a DistanceJoint", o);
    read(o.attr("distance"), x.distance, {"DistanceJoint", "distance"});
}
py::object write(const DistanceJoint& x) {
    return make("DistanceJoint", py::make_tuple(write(x.distance)));
}

void read(py::handle o, WheelJoint& x, const Where& where) {
    if (!is_a(o, "WheelJoint")) refuse_type(where, "a WheelJoint", o);
    read(o.attr("suspension"), x.suspension, {"WheelJoint", "suspension"});
    read(o.attr("steering"), x.steering, {"WheelJoint", "steering"});
    read(o.attr("spin"), x.spin, {"WheelJoint", "spin"});
}
py::object write(const WheelJoint& x) {
    return make("WheelJoint", py::make_tuple(write(x.suspension), write(x.steering), write(x.spin)));
}

void read(py::handle o, ServoJoint& x, const Where& where) {
    if (!is_a(o, "ServoJoint")) refuse_type(where, "a ServoJoint", o);
    read(o.attr("position"), x.position, {"ServoJoint", "position"});
    read(o.attr("rotation"), x.rotation, {"ServoJoint", "rotation"});
    read(o.attr("linear"), x.linear, {"ServoJoint", "linear"});
    read(o.attr("angular"), x.angular, {"ServoJoint", "angular"});
    read(o.attr("max_force"), x.max_force, {"ServoJoint", "max_force"});
    read(o.attr("max_torque"), x.max_torque, {"ServoJoint", "max_torque"});
}
py::object write(const ServoJoint& x) {
    return make("ServoJoint", py::make_tuple(write(x.position), write(x.rotation), write(x.linear), write(x.angular),
        write(x.max_force), write(x.max_torque)));
}

void read(py::handle o, GearJoint& x, const Where& where) {
    if (!is_a(o, "GearJoint")) refuse_type(where, "a GearJoint", o);
    read(o.attr("ratio"), x.ratio, {"GearJoint", "ratio"});
}
py::object write(const GearJoint& x) {
    return make("GearJoint", py::make_tuple(write(x.ratio)));
}

void read(py::handle o, RackJoint& x, const Where& where) {
    if (!is_a(o, "RackJoint")) refuse_type(where, "a RackJoint", o);
    read(o.attr("radius"), x.radius, {"RackJoint", "radius"});
}
py::object write(const RackJoint& x) {
    return make("RackJoint", py::make_tuple(write(x.radius)));
}

void read(py::handle o, PulleyJoint& x, const Where& where) {
    if (!is_a(o, "PulleyJoint")) refuse_type(where, "a PulleyJoint", o);
    read(o.attr("ground_a"), x.ground_a, {"PulleyJoint", "ground_a"});
    read(o.attr("ground_b"), x.ground_b, {"PulleyJoint", "ground_b"});
    read(o.attr("ratio"), x.ratio, {"PulleyJoint", "ratio"});
    read(o.attr("length"), x.length, {"PulleyJoint", "length"});
}
py::object write(const PulleyJoint& x) {
    return make("PulleyJoint", py::make_tuple(write(x.ground_a), write(x.ground_b), write(x.ratio), write(x.length)));
}

void read(py::handle o, JointLimit& x, const Where& where) {
    if (!is_a(o, "JointLimit")) refuse_type(where, "a JointLimit", o);
    read(o.attr("kind"), x.kind, {"JointLimit", "kind"});
    read(o.attr("axes"), x.axes, {"JointLimit", "axes"});
    read(o.attr("min"), x.min, {"JointLimit", "min"});
    read(o.attr("max"), x.max, {"JointLimit", "max"});
    read(o.attr("stiffness"), x.stiffness, {"JointLimit", "stiffness"});
    read(o.attr("damping"), x.damping, {"JointLimit", "damping"});
}
py::object write(const JointLimit& x) {
    return make("JointLimit", py::make_tuple(write(x.kind), write(x.axes), write(x.min), write(x.max),
        write(x.stiffness), write(x.damping)));
}

void read(py::handle o, JointDrive& x, const Where& where) {
    if (!is_a(o, "JointDrive")) refuse_type(where, "a JointDrive", o);
    read(o.attr("kind"), x.kind, {"JointDrive", "kind"});
    read(o.attr("is_acceleration"), x.is_acceleration, {"JointDrive", "is_acceleration"});
    read(o.attr("axis"), x.axis, {"JointDrive", "axis"});
    read(o.attr("max_force"), x.max_force, {"JointDrive", "max_force"});
    read(o.attr("position_target"), x.position_target, {"JointDrive", "position_target"});
    read(o.attr("velocity_target"), x.velocity_target, {"JointDrive", "velocity_target"});
    read(o.attr("stiffness"), x.stiffness, {"JointDrive", "stiffness"});
    read(o.attr("damping"), x.damping, {"JointDrive", "damping"});
}
py::object write(const JointDrive& x) {
    return make("JointDrive", py::make_tuple(write(x.kind), write(x.is_acceleration), write(x.axis), write(x.max_force),
        write(x.position_target), write(x.velocity_target), write(x.stiffness), write(x.damping)));
}

void read(py::handle o, GeneralJoint& x, const Where& where) {
    if (!is_a(o, "GeneralJoint")) refuse_type(where, "a GeneralJoint", o);
    read(o.attr("limits"), x.limits, {"GeneralJoint", "limits"});
    read(o.attr("drives"), x.drives, {"GeneralJoint", "drives"});
}
py::object write(const GeneralJoint& x) {
    return make("GeneralJoint", py::make_tuple(write(x.limits), write(x.drives)));
}

void read(py::handle o, JointDef& x, const Where& where) {
    if (!is_a(o, "JointDef")) refuse_type(where, "a JointDef", o);
    read(o.attr("body_a"), x.body_a, {"JointDef", "body_a"});
    read(o.attr("body_b"), x.body_b, {"JointDef", "body_b"});
    read(o.attr("frame_a"), x.frame_a, {"JointDef", "frame_a"});
    read(o.attr("frame_b"), x.frame_b, {"JointDef", "frame_b"});
    read(o.attr("joint"), x.joint, {"JointDef", "joint"});
    read(o.attr("enable_collision"), x.enable_collision, {"JointDef", "enable_collision"});
    read(o.attr("break_force"), x.break_force, {"JointDef", "break_force"});
    read(o.attr("break_torque"), x.break_torque, {"JointDef", "break_torque"});
    read(o.attr("solver"), x.solver, {"JointDef", "solver"});
    read(o.attr("name"), x.name, {"JointDef", "name"});
    read(o.attr("user_data"), x.user_data, {"JointDef", "user_data"});
    read(o.attr("enabled"), x.enabled, {"JointDef", "enabled"});
}
py::object write(const JointDef& x) {
    return make("JointDef", py::make_tuple(write(x.body_a), write(x.body_b), write(x.frame_a), write(x.frame_b),
        write(x.joint), write(x.enable_collision), write(x.break_force), write(x.break_torque), write(x.solver),
        write(x.name), write(x.user_data), write(x.enabled)));
}

py::object write(const JointState& x) {
    return make("JointState", py::make_tuple(write(x.force), write(x.torque),
        write_list(std::span(x.positions).first(std::size_t(x.position_count))), write(x.position_count),
        write(x.linear_error), write(x.angular_error)));
}

void read(py::handle o, Joint& x, const Where& where) {
    if (is_a(o, "FixedJoint")) {
        read(o, x.emplace<FixedJoint>(), where);
        return;
    }
    if (is_a(o, "BallJoint")) {
        read(o, x.emplace<BallJoint>(), where);
        return;
    }
    if (is_a(o, "HingeJoint")) {
        read(o, x.emplace<HingeJoint>(), where);
        return;
    }
    if (is_a(o, "SliderJoint")) {
        read(o, x.emplace<SliderJoint>(), where);
        return;
    }
    if (is_a(o, "CylindricalJoint")) {
        read(o, x.emplace<CylindricalJoint>(), where);
        return;
    }
    if (is_a(o, "UniversalJoint")) {
        read(o, x.emplace<UniversalJoint>(), where);
        return;
    }
    if (is_a(o, "DistanceJoint")) {
        read(o, x.emplace<DistanceJoint>(), where);
        return;
    }
    if (is_a(o, "WheelJoint")) {
        read(o, x.emplace<WheelJoint>(), where);
        return;
    }
    if (is_a(o, "ServoJoint")) {
        read(o, x.emplace<ServoJoint>(), where);
        return;
    }
    if (is_a(o, "GearJoint")) {
        read(o, x.emplace<GearJoint>(), where);
        return;
    }
    if (is_a(o, "RackJoint")) {
        read(o, x.emplace<RackJoint>(), where);
        return;
    }
    if (is_a(o, "PulleyJoint")) {
        read(o, x.emplace<PulleyJoint>(), where);
        return;
    }
    if (is_a(o, "GeneralJoint")) {
        read(o, x.emplace<GeneralJoint>(), where);
        return;
    }
    refuse_type(where, "a Joint", o);
}
py::object write(const Joint& x) {
    return std::visit([](const auto& y) { return write(y); }, x);
}

} // namespace cairn::python
