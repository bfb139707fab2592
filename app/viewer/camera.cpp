#include "viewer/camera.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cairn::viewer {

namespace {

constexpr float max_pitch = 1.55f;       // radians, just short of the pole
constexpr float min_distance = 0.05f;    // meters
constexpr float max_distance = 20000.0f; // meters
constexpr float zoom_per_notch = 0.9f;
constexpr double origin_lattice = 100.0; // meters; a multiple of the 10 m spacing of the ground grid
constexpr float near_per_distance = 0.02f;
constexpr float least_fov = 0.01f; // radians
// Depth range of an orthographic projection before and behind the target: meters, and multiples of the camera's
// distance. The resolution of the depth buffer is then a ten-thousandth of the distance, a tenth of a pixel.
constexpr float least_reach = 200.0f, reach_per_distance = 500.0f;
constexpr float least_scale = 0.01f;            // meters
constexpr double clearance_per_distance = 0.03; // height of the eye above a ground plane, per distance and `lens_of`
constexpr double min_clearance = 0.01;          // meters
constexpr double rounding = 0.1;                // share of the clearance; a smaller deficit does not lift the target
constexpr float far_per_near = 2.0e5f;
constexpr float widest_aspect = 16.0f / 9.0f; // of a view; narrower ones keep this horizontal field of view

} // namespace

float lens_of(const CameraPose& camera) {
    constexpr float usual_slope = 0.4142136f; // for a field of view of 45 degrees
    return std::min(std::tan(0.5f * camera.vertical_fov) / usual_slope, 1.0f);
}

void OrbitCamera::set_pose(const CameraPose& pose) {
    const glm::dvec3 offset = pose.position - pose.target;
    const double length = glm::length(offset);
    target_ = pose.target;
    distance_ = std::clamp(float(length), min_distance, 100.0f * max_distance); // allows the distance of a long lens
    if (length > 0.0) {
        yaw_ = float(std::atan2(offset.x, offset.z));
        pitch_ = std::clamp(float(std::asin(offset.y / length)), -max_pitch, max_pitch);
    }
    vertical_fov_ = std::clamp(pose.vertical_fov, least_fov, 2.8f);
    is_parallel_ = pose.is_parallel;
}

CameraPose OrbitCamera::pose() const { return {position(), target_, vertical_fov_, is_parallel_}; }

void OrbitCamera::orbit(float yaw, float pitch) {
    yaw_ = std::remainder(yaw_ + yaw, 6.2831853f);
    pitch_ = std::clamp(pitch_ + pitch, -max_pitch, max_pitch);
    stay_above();
}

void OrbitCamera::zoom(float notches) {
    distance_ = std::clamp(distance_ * std::pow(zoom_per_notch, notches), min_distance, max_distance);
    stay_above();
}

void OrbitCamera::pan(float right_amount, float up_amount, float aspect) {
    const float picture_height = 2.0f * distance_ * half_height(aspect);
    target_ += Position((right() * right_amount + up() * up_amount) * picture_height);
    stay_above();
}

void OrbitCamera::look(float yaw, float pitch) {
    yaw_ = yaw;
    pitch_ = std::clamp(pitch, -max_pitch, max_pitch);
    stay_above();
}

void OrbitCamera::follow(const Position& target) {
    target_ = target;
    stay_above();
}

void OrbitCamera::set_parallel(bool on) {
    is_parallel_ = on;
    stay_above();
}

// Minimum height of the eye above a ground plane, so that the near plane does not cut it.
double OrbitCamera::clearance() const {
    return std::max(min_clearance, clearance_per_distance * double(distance_) * double(lens_of(pose())));
}

void OrbitCamera::frame(const Position& center, float radius) {
    target_ = center;
    distance_ = std::clamp(2.2f * radius / std::tan(0.5f * vertical_fov_), min_distance, max_distance);
    stay_above();
}

double OrbitCamera::height(const Ground& ground, const Position& point) const {
    return glm::dot(point - ground.point, glm::dvec3(ground.normal));
}

void OrbitCamera::stay_above() {
    // The target is raised first, because points under a ground plane cannot be seen from above.
    for (const Ground& ground : grounds_) {
        const double depth = -height(ground, target_);
        if (depth > 0.0) target_.y += depth / double(ground.normal.y);
    }
    for (const Ground& ground : grounds_) turn_above(ground);
    if (is_parallel_) return;
    // Where orbiting about the target is not enough, as in a narrow valley, the target is raised too.
    for (const Ground& ground : grounds_) {
        const double missing = clearance() - height(ground, position());
        if (missing > rounding * clearance()) target_.y += missing / double(ground.normal.y);
    }
}

// Raises the eye by increasing the pitch. Its height above the plane, minus that of the target and divided by the
// distance, is A cos(pitch) + B sin(pitch) = R cos(pitch - steepest). An orthographic camera may look along a ground
// plane, but not from below it.
void OrbitCamera::turn_above(const Ground& ground) {
    if (!is_parallel_ && height(ground, position()) >= clearance()) return;
    const double a =
        double(ground.normal.x) * std::sin(double(yaw_)) + double(ground.normal.z) * std::cos(double(yaw_));
    const double b = double(ground.normal.y), reach = std::hypot(a, b), steepest = std::atan2(b, a);
    if (is_parallel_) {
        pitch_ = std::min(std::max(pitch_, float(steepest) - 0.5f * std::numbers::pi_v<float>), max_pitch);
        return;
    }
    const double wanted = (clearance() - height(ground, target_)) / (double(distance_) * reach);
    const double pitch = wanted < 1.0 ? steepest - std::acos(std::max(wanted, -1.0)) : steepest;
    if (pitch > double(pitch_)) pitch_ = std::min(float(pitch), max_pitch);
}

Vec3 OrbitCamera::forward() const {
    return {-std::sin(yaw_) * std::cos(pitch_), -std::sin(pitch_), -std::cos(yaw_) * std::cos(pitch_)};
}

Vec3 OrbitCamera::right() const { return {std::cos(yaw_), 0.0f, -std::sin(yaw_)}; }

Vec3 OrbitCamera::up() const { return glm::cross(right(), forward()); }

Position OrbitCamera::position() const { return target_ - Position(forward()) * double(distance_); }

Position OrbitCamera::render_origin() const {
    return {std::round(target_.x / origin_lattice) * origin_lattice,
            std::round(target_.y / origin_lattice) * origin_lattice,
            std::round(target_.z / origin_lattice) * origin_lattice};
}

glm::mat4 OrbitCamera::view(const Position& origin) const {
    const Vec3 eye(position() - origin);
    return glm::lookAt(eye, eye + forward(), up());
}

float OrbitCamera::half_height(float aspect) const {
    return std::tan(0.5f * vertical_fov_) * std::max(widest_aspect / aspect, 1.0f);
}

float OrbitCamera::scale_at(const Position& point) const {
    if (is_parallel_) return distance_;
    return std::max(glm::dot(Vec3(point - position()), forward()), least_scale);
}

glm::mat4 OrbitCamera::projection(float aspect) const {
    if (is_parallel_) {
        const float height = distance_ * half_height(aspect), behind = float(reach_behind());
        return glm::ortho(-height * aspect, height * aspect, -height, height, -behind, behind + 2.0f * distance_);
    }
    const float near_plane = std::max(0.005f, near_per_distance * distance_), top = near_plane * half_height(aspect);
    return glm::frustum(-top * aspect, top * aspect, -top, top, near_plane, near_plane * far_per_near);
}

Ray OrbitCamera::cursor_ray(const glm::vec2& device, float aspect) const {
    const float height = half_height(aspect);
    const Vec3 aside = right() * (device.x * height * aspect) + up() * (device.y * height);
    if (is_parallel_) return {position() + Position(aside) * double(distance_), forward()};
    return {position(), glm::normalize(forward() + aside)};
}

Ray OrbitCamera::pick_ray(const glm::vec2& device, float aspect) const {
    Ray ray = cursor_ray(device, aspect);
    ray.origin -= Position(ray.direction) * reach_behind();
    return ray;
}

double OrbitCamera::reach_behind() const {
    return is_parallel_ ? double(least_reach + (reach_per_distance - 1.0f) * distance_) : 0.0;
}

std::optional<glm::vec2> OrbitCamera::project(const Position& point, float aspect) const {
    const Vec3 offset(point - position());
    if (!is_parallel_ && glm::dot(offset, forward()) <= 1e-6f) return std::nullopt;
    const float depth = is_parallel_ ? distance_ : glm::dot(offset, forward()), height = depth * half_height(aspect);
    return glm::vec2(glm::dot(offset, right()) / (height * aspect), glm::dot(offset, up()) / height);
}

} // namespace cairn::viewer
