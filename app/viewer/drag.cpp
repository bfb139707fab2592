#include "viewer/drag.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <variant>
#include <vector>

namespace cairn::viewer {

Position drag_target(const Ray& cursor, const Position& grabbed, const Vec3& forward, DragConstraint constraint,
                     double max_distance) {
    Vec3 normal = forward;
    if (constraint == DragConstraint::ground) normal = {0.0f, 1.0f, 0.0f};
    if (constraint == DragConstraint::vertical) { // the vertical plane most nearly perpendicular to the view direction
        normal = {forward.x, 0.0f, forward.z};
        if (glm::dot(normal, normal) < 1e-8f) return grabbed; // looking straight down, the cursor determines no height
        normal = glm::normalize(normal);
    }
    const double approach = glm::dot(glm::dvec3(cursor.direction), glm::dvec3(normal));
    const double height = glm::dot(grabbed - cursor.origin, glm::dvec3(normal));
    if (std::abs(approach) < 1e-9 || height / approach <= 0.0) return grabbed;
    const double distance = std::min(height / approach, max_distance);
    const Position target = cursor.origin + Position(cursor.direction) * distance;
    if (constraint == DragConstraint::vertical) return {grabbed.x, target.y, grabbed.z};
    if (constraint == DragConstraint::ground) return {target.x, grabbed.y, target.z};
    return target;
}

namespace {

constexpr float max_load = 100.0f; // times the body's own mass; keeps a lever from being torn off its machine

// Total mass of the dynamic bodies that are connected to a body by joints, directly or indirectly, without its own.
float mass_joined_to(const World& world, BodyId body) {
    std::vector<BodyId> found{body};
    std::unordered_set<BodyId> known{body};
    float mass = 0.0f;
    for (std::size_t i = 0; i < found.size(); ++i) {
        for (const JointId joint : world.joints(found[i])) {
            const JointDef& def = world.joint_def(joint);
            const BodyId other = def.body_a == found[i] ? def.body_b : def.body_a;
            if (!other || world.body(other).type() != BodyType::dynamic || !known.insert(other).second) continue;
            found.push_back(other);
            mass += world.body(other).mass();
        }
    }
    return mass;
}

} // namespace

JointDef drag_joint(const World& world, BodyId body_id, const Vec3& local_point, const DragSpring& spring) {
    const Body body = world.body(body_id);
    const Transform pose = body.transform();
    const float mass = body.mass(), load = std::min(mass_joined_to(world, body_id), max_load * mass);
    JointDef def;
    def.body_b = body_id;
    def.frame_a.position = pose.position + Position(pose.rotation * local_point);
    def.frame_b.position = Position(local_point);
    def.enable_collision = true; // the dragged body still collides with static geometry
    ServoJoint servo;
    servo.linear = JointSpring::from_frequency(spring.frequency, 1.0f);
    if (std::isfinite(mass) && std::isfinite(load)) { // the engine scales springs only by the mass of the body itself
        servo.linear.stiffness *= 1.0f + load / mass;
        servo.linear.damping *= 1.0f + load / mass;
    }
    servo.max_force = spring.max_acceleration * mass + spring.max_lift * load;
    // The body rotates about the grabbed point, so its inertia about that point is needed (parallel axis theorem),
    // whereas the joint scales by the inertia about the center of mass.
    const Vec3 arm(def.frame_a.position - body.center_of_mass());
    const Mat3 inertia = body.world_inertia();
    const float trace = inertia[0][0] + inertia[1][1] + inertia[2][2];
    const bool turns = std::isfinite(trace) && trace > 0.0f;
    const float ratio = turns ? 1.0f + 2.0f * body.mass() * glm::dot(arm, arm) / trace : 0.0f;
    servo.angular = {0.0f, spring.spin_damping * ratio, true};
    def.joint = servo;
    return def;
}

Position dragged_point(const World& world, JointId drag) {
    const JointDef& def = world.joint_def(drag);
    const Transform pose = world.body(def.body_b).transform();
    return pose.position + Position(pose.rotation * Vec3(def.frame_b.position));
}

void pull_to(World& world, JointId drag, const Position& target, const DragSpring& spring) {
    const JointDef& def = world.joint_def(drag);
    const Position held = dragged_point(world, drag);
    glm::dvec3 way = target - held;
    const double length = glm::length(way);
    if (length > double(spring.max_stretch)) way *= double(spring.max_stretch) / length;
    ServoJoint servo = std::get<ServoJoint>(def.joint);
    servo.position = Vec3(held + way - def.frame_a.position);
    if (servo.position != std::get<ServoJoint>(def.joint).position) world.set_joint(drag, servo);
}

} // namespace cairn::viewer
