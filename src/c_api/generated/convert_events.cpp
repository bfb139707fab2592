// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "c_api/generated/convert.h"

#include <string>

namespace cairn::c_api {

cairn_contact_begin to_c(const ContactBegin& x) {
    cairn_contact_begin c{};
    c.shape_a = to_c(x.shape_a);
    c.shape_b = to_c(x.shape_b);
    c.body_a = to_c(x.body_a);
    c.body_b = to_c(x.body_b);
    return c;
}

cairn_contact_end to_c(const ContactEnd& x) {
    cairn_contact_end c{};
    c.shape_a = to_c(x.shape_a);
    c.shape_b = to_c(x.shape_b);
    c.body_a = to_c(x.body_a);
    c.body_b = to_c(x.body_b);
    return c;
}

cairn_contact_hit to_c(const ContactHit& x) {
    cairn_contact_hit c{};
    c.shape_a = to_c(x.shape_a);
    c.shape_b = to_c(x.shape_b);
    c.body_a = to_c(x.body_a);
    c.body_b = to_c(x.body_b);
    c.point = to_c(x.point);
    c.normal = to_c(x.normal);
    c.approach_speed = x.approach_speed;
    c.time = x.time;
    c.surface_material = x.surface_material;
    return c;
}

cairn_trigger_event to_c(const TriggerEvent& x) {
    cairn_trigger_event c{};
    c.trigger = to_c(x.trigger);
    c.other = to_c(x.other);
    c.trigger_body = to_c(x.trigger_body);
    c.other_body = to_c(x.other_body);
    c.inside = x.inside;
    c.time = x.time;
    return c;
}

cairn_joint_event to_c(const JointEvent& x) {
    cairn_joint_event c{};
    c.joint = to_c(x.joint);
    c.body_a = to_c(x.body_a);
    c.body_b = to_c(x.body_b);
    c.broke = x.broke;
    c.force = x.force;
    c.torque = x.torque;
    c.user_data = x.user_data;
    return c;
}

cairn_sleep_event to_c(const SleepEvent& x) {
    cairn_sleep_event c{};
    c.body = to_c(x.body);
    c.asleep = x.asleep;
    return c;
}

cairn_contact_point to_c(const ContactPoint& x) {
    cairn_contact_point c{};
    c.point = to_c(x.point);
    c.separation = x.separation;
    c.normal_impulse = x.normal_impulse;
    return c;
}

cairn_contact to_c(const Contact& x) {
    cairn_contact c{};
    c.shape_a = to_c(x.shape_a);
    c.shape_b = to_c(x.shape_b);
    c.body_a = to_c(x.body_a);
    c.body_b = to_c(x.body_b);
    c.normal = to_c(x.normal);
    c.friction_impulse = to_c(x.friction_impulse);
    c.point_count = x.point_count;
    for (std::size_t i = 0; i < 4; ++i) c.points[i] = to_c(x.points[i]);
    c.surface_material = x.surface_material;
    return c;
}

} // namespace cairn::c_api
