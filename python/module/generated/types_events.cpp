// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "module/containers.h"

namespace cairn::python {

py::object write(const ContactBegin& x) {
    return make("ContactBegin", py::make_tuple(write(x.shape_a), write(x.shape_b), write(x.body_a), write(x.body_b)));
}

py::object write(const ContactEnd& x) {
    return make("ContactEnd", py::make_tuple(write(x.shape_a), write(x.shape_b), write(x.body_a), write(x.body_b)));
}

py::object write(const ContactHit& x) {
    return make("ContactHit", py::make_tuple(write(x.shape_a), write(x.shape_b), write(x.body_a), write(x.body_b),
        write(x.point), write(x.normal), write(x.approach_speed), write(x.time), write(x.surface_material)));
}

py::object write(const TriggerEvent& x) {
    return make("TriggerEvent", py::make_tuple(write(x.trigger), write(x.other), write(x.trigger_body),
        write(x.other_body), write(x.inside), write(x.time)));
}

py::object write(const JointEvent& x) {
    return make("JointEvent", py::make_tuple(write(x.joint), write(x.body_a), write(x.body_b), write(x.broke),
        write(x.force), write(x.torque), write(x.user_data)));
}

py::object write(const SleepEvent& x) {
    return make("SleepEvent", py::make_tuple(write(x.body), write(x.asleep)));
}

py::object write(const ContactPoint& x) {
    return make("ContactPoint", py::make_tuple(write(x.point), write(x.separation), write(x.normal_impulse)));
}

py::object write(const Contact& x) {
    return make("Contact", py::make_tuple(write(x.shape_a), write(x.shape_b), write(x.body_a), write(x.body_b),
        write(x.normal), write(x.friction_impulse), write(x.point_count),
        write_list(std::span(x.points).first(std::size_t(x.point_count))), write(x.surface_material)));
}

} // namespace cairn::python
