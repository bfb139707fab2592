/// \file joint_rig.h
/// A rig for the tests of joints: two bodies with a joint between them, and access to its controls.
#pragma once

#include "test_world.h"

#include <array>
#include <functional>

namespace cairn::test {

/// A fixed base at the origin and a dynamic box of unequal sides beside it, joined at the base's origin. There is no
/// gravity: only the test moves the box.
struct Rig {
    World world;
    BodyId base, body;
    JointId joint;

    explicit Rig(const Joint& type, const Vec3& axis = {1, 0, 0}, const WorldDef& def = weightless()) : world(def) {
        base = world.create_body(body_at({0, 0, 0}, BodyType::static_));
        body = add_body(world, body_at({0, 0, 0}), Box{{0.3f, 0.2f, 0.1f}});
        joint = world.create_joint(world.joint_at(base, body, {0, 0, 0}, axis, type));
    }
    void run(
        float seconds, const std::function<void(Body)>& push = [](Body) {}) {
        for (int i = 0; i < int(seconds / frame + 0.5f); ++i) {
            push(world.body(body));
            world.step(frame);
        }
    }
    float position(int i = 0) const { return world.joint_state(joint).positions[std::size_t(i)]; }
    JointState state() const { return world.joint_state(joint); }
    float mass() { return world.body(body).mass(); }
};

inline JointControl limited(float lower, float upper) { return {JointRange{lower, upper, {}}, {}, 0}; }
inline JointControl driven(float velocity, float cap = infinity) {
    JointMotor motor;
    motor.velocity = velocity;
    motor.max_force = cap;
    return {{}, motor, 0};
}

/// A general joint that locks the given linear and angular axes.
inline GeneralJoint locked(std::array<bool, 3> linear, std::array<bool, 3> angular) {
    GeneralJoint joint;
    if (linear[0] || linear[1] || linear[2]) joint.limits.push_back({JointAxis::linear, linear, 0.0f, 0.0f, {}, 0});
    if (angular[0] || angular[1] || angular[2])
        joint.limits.push_back({JointAxis::angular, angular, 0.0f, 0.0f, {}, 0});
    return joint;
}

} // namespace cairn::test
