#include "viewer/drag.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace cairn::viewer {

namespace {

// The matrix of the cross product: skew(v) * w = v x w.
Mat3 skew(const Vec3& v) { return {0.0f, v.z, -v.y, -v.z, 0.0f, v.x, v.y, -v.x, 0.0f}; }

} // namespace

Position drag_target(const Ray& cursor, const Position& grabbed, const Vec3& forward, DragConstraint constraint,
                     double max_distance) {
    Vec3 normal = forward;
    if (constraint == DragConstraint::ground) normal = {0.0f, 1.0f, 0.0f};
    if (constraint == DragConstraint::vertical) { // the upright plane that faces the camera best
        normal = {forward.x, 0.0f, forward.z};
        if (glm::dot(normal, normal) < 1e-8f) return grabbed; // looking straight down shows no height
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

// With the stretch x, the point's velocity v, the effective mass M and the force F over a step h, a spring of stiffness
// k = M w^2 and damping c = 2 M w, taken implicitly, asks for
//     F = -(k (x + h v') + c v'),  v' = v + h F / M   =>   F = -M (w^2 x + (w^2 h + 2 w) v) / (1 + 2 w h + w^2 h^2).
// M is the inverse of K = 1/m + the turning part, a matrix, since pushing a body off its center turns it as well.
DragForce drag_force(const Body& body, const Vec3& local_point, const Position& target, float dt,
                     const DragSpring& spring) {
    DragForce result;
    const float mass = body.mass();
    if (!std::isfinite(mass)) return result;
    const Transform pose = body.transform();
    result.point = pose.position + Position(pose.rotation * local_point);
    const Vec3 arm(result.point - body.center_of_mass());
    const Mat3 inertia = body.world_inertia();
    const Mat3 arm_matrix = skew(arm);
    Mat3 response = Mat3(1.0f / mass);
    const float determinant = glm::determinant(inertia);
    const bool turns = std::isfinite(determinant) && determinant > 0.0f; // else its rotation is locked
    if (turns) response = response - arm_matrix * glm::inverse(inertia) * arm_matrix;
    const Mat3 effective_mass = glm::inverse(response);

    Vec3 stretch(result.point - target);
    const float length = glm::length(stretch);
    if (length > spring.max_stretch) stretch *= spring.max_stretch / length;
    const float w = 6.2831853f * spring.frequency;
    const Vec3 wanted = w * w * stretch + (w * w * dt + 2.0f * w) * body.velocity_at(result.point);
    result.force = effective_mass * wanted * (-1.0f / (1.0f + 2.0f * w * dt + w * w * dt * dt));
    if (turns) {
        // The body turns about the grabbed point, so the inertia about it counts (Steiner). The torque acts on the
        // inertia about the center of mass, though: the more they differ, the gentler one step must be.
        const Mat3 about_point = inertia - mass * (arm_matrix * arm_matrix);
        const float ratio = (about_point[0][0] + about_point[1][1] + about_point[2][2]) /
                            (inertia[0][0] + inertia[1][1] + inertia[2][2]);
        const float rate = spring.spin_damping / (1.0f + spring.spin_damping * dt * ratio);
        result.torque = about_point * body.angular_velocity() * -rate;
    }
    return result;
}

} // namespace cairn::viewer
