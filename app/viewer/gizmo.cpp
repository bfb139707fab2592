#include "viewer/gizmo.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace cairn::viewer {

namespace {

constexpr float reach = 0.34f;        // of half the view's height: distance of the handles' ends from the center
constexpr float inner = 0.4f;         // of `reach`: where axis handles begin
constexpr float cursor_slack = 0.02f; // of the view's height
constexpr int ring_pieces = 48;
constexpr float least_factor = 0.02f, greatest_factor = 50.0f; // scale factors of one drag
constexpr float uniform_rate = 3.0f; // doublings of the size for a drag over the height of the view
constexpr std::array axis_colors{Vec3(0.85f, 0.08f, 0.06f), Vec3(0.10f, 0.60f, 0.05f), Vec3(0.05f, 0.20f, 0.90f)};
constexpr Vec3 uniform_color{0.9f, 0.9f, 0.9f};

float length_of(const Position& center, const OrbitCamera& camera) {
    return reach * camera.scale_at(center) * std::tan(0.5f * camera.vertical_fov());
}

// Two unit vectors perpendicular to an axis and to each other.
std::array<Vec3, 2> across(const Vec3& axis) {
    const Vec3 other = std::abs(axis.y) < 0.9f ? Vec3(0.0f, 1.0f, 0.0f) : Vec3(1.0f, 0.0f, 0.0f);
    const Vec3 first = glm::normalize(glm::cross(other, axis));
    return {first, glm::cross(axis, first)};
}

Position on_ring(const Position& center, const Vec3& axis, float radius, int piece) {
    const auto [a, b] = across(axis);
    const float angle = 6.2831853f * float(piece) / float(ring_pieces);
    return center + Position((a * std::cos(angle) + b * std::sin(angle)) * radius);
}

// Coordinate along an axis of the point nearest to a ray; empty if they are parallel.
std::optional<double> along_axis(const Position& center, const Vec3& axis, const Ray& ray) {
    const glm::dvec3 d(ray.direction), a(axis), offset = ray.origin - center;
    const double cosine = glm::dot(d, a), sine2 = 1.0 - cosine * cosine;
    if (sine2 < 1e-6) return std::nullopt;
    return (glm::dot(offset, a) - cosine * glm::dot(offset, d)) / sine2;
}

// The vector from the center to the intersection of a ray with a ring's plane.
std::optional<Vec3> arm_on_ring(const Position& center, const Vec3& axis, const Ray& ray) {
    const double slope = glm::dot(glm::dvec3(ray.direction), glm::dvec3(axis));
    if (std::abs(slope) < 0.02) return std::nullopt;
    const double way = glm::dot(center - ray.origin, glm::dvec3(axis)) / slope;
    if (way <= 0.0) return std::nullopt;
    return Vec3(ray.origin + glm::dvec3(ray.direction) * way - center);
}

} // namespace

const char* name_of(GizmoMode mode) {
    constexpr std::array names{"none", "move", "turn", "scale"};
    return names[std::size_t(mode)];
}

std::vector<GizmoHandle> Gizmo::handles(const BodyFacts& facts) const {
    std::vector<GizmoHandle> handles;
    if (mode == GizmoMode::none) return handles;
    if (mode != GizmoMode::scale || facts.can_be_stretched) handles = {GizmoHandle::x, GizmoHandle::y, GizmoHandle::z};
    if (mode == GizmoMode::scale) handles.push_back(GizmoHandle::all);
    return handles;
}

// The axis of a handle in the world; for scaling, an axis of the body.
Vec3 Gizmo::axis(const BodyFacts& facts, GizmoHandle handle) const {
    if (handle == GizmoHandle::all) return {0.0f, 1.0f, 0.0f};
    Vec3 axis(0.0f);
    axis[int(handle)] = 1.0f;
    return mode == GizmoMode::scale ? facts.rotation * axis : axis;
}

Position Gizmo::grip(const BodyFacts& facts, const OrbitCamera& camera, GizmoHandle handle) const {
    if (handle == GizmoHandle::all) return facts.center;
    const float length = length_of(facts.center, camera);
    const Vec3 along = axis(facts, handle);
    if (mode != GizmoMode::turn) return facts.center + Position(along * (0.9f * length));
    // Halfway between the other two rings, on the side that faces the camera.
    const auto [first, second] = across(along);
    const float right = glm::dot(first, camera.forward()) < 0.0f ? 1.0f : -1.0f;
    const float left = glm::dot(second, camera.forward()) < 0.0f ? 1.0f : -1.0f;
    return facts.center + Position(glm::normalize(first * right + second * left) * length);
}

std::optional<GizmoHandle> Gizmo::handle_at(const BodyFacts& facts, const OrbitCamera& camera, const glm::vec2& cursor,
                                            float aspect) const {
    std::optional<GizmoHandle> nearest;
    float least = cursor_slack;
    const auto flat = [&](const Position& point) -> std::optional<glm::vec2> {
        const auto device = camera.project(point, aspect);
        if (!device) return std::nullopt;
        return (*device - cursor) * glm::vec2(aspect, 1.0f) * 0.5f;
    };
    const auto consider = [&](GizmoHandle handle, const Position& from, const Position& to) {
        const auto a = flat(from), b = flat(to);
        if (!a || !b) return;
        const glm::vec2 way = *b - *a;
        const float along = std::clamp(-glm::dot(*a, way) / std::max(glm::dot(way, way), 1e-12f), 0.0f, 1.0f);
        const float distance = glm::length(*a + way * along);
        if (distance >= least) return;
        least = distance;
        nearest = handle;
    };
    const float length = length_of(facts.center, camera);
    for (const GizmoHandle handle : handles(facts)) {
        const Vec3 along = axis(facts, handle);
        if (handle == GizmoHandle::all) {
            consider(handle, facts.center, facts.center);
        } else if (mode == GizmoMode::turn) {
            for (int i = 0; i < ring_pieces; ++i)
                consider(handle, on_ring(facts.center, along, length, i), on_ring(facts.center, along, length, i + 1));
        } else {
            consider(handle, facts.center + Position(along * (inner * length)),
                     facts.center + Position(along * length));
        }
    }
    return nearest;
}

void Gizmo::draw(RenderFrame& frame, const BodyFacts& facts, const OrbitCamera& camera) const {
    const float length = length_of(facts.center, camera);
    const auto at = [&](const Position& point) { return Vec3(point - frame.origin); };
    constexpr float line_width = 3.0f, dot_width = 13.0f; // pixels
    for (const GizmoHandle handle : handles(facts)) {
        const bool is_held = start_ && start_->handle == handle;
        if (start_ && !is_held) continue;
        const Vec3 color = handle == GizmoHandle::all ? uniform_color : axis_colors[std::size_t(handle)];
        const Vec3 along = axis(facts, handle);
        const Vec3 middle = at(facts.center), end = at(facts.center + Position(along * length));
        if (handle == GizmoHandle::all) {
            frame.strokes.push_back({middle, middle, color, dot_width});
        } else if (mode == GizmoMode::turn) {
            for (int i = 0; i < ring_pieces; ++i)
                frame.strokes.push_back({at(on_ring(facts.center, along, length, i)),
                                         at(on_ring(facts.center, along, length, i + 1)), color, line_width});
        } else {
            frame.strokes.push_back({middle + along * (inner * length), end, color, line_width});
            if (mode == GizmoMode::scale) {
                frame.strokes.push_back({end, end, color, dot_width});
                continue;
            }
            for (const Vec3& side : across(along)) // an arrowhead, visible from any side
                for (const float sign : {-1.0f, 1.0f})
                    frame.strokes.push_back(
                        {end, end - (along + side * (0.5f * sign)) * (0.14f * length), color, line_width});
        }
    }
}

void Gizmo::begin(const BodyFacts& facts, const OrbitCamera& camera, GizmoHandle handle, const glm::vec2& cursor,
                  float aspect) {
    Start start;
    start.handle = handle;
    start.center = facts.center;
    start.pose = {facts.position, facts.rotation};
    start.axis = axis(facts, handle);
    start.cursor = cursor;
    const Ray ray = camera.pick_ray(cursor, aspect);
    start.along = along_axis(start.center, start.axis, ray).value_or(double(length_of(start.center, camera)));
    const Vec3 fallback = across(start.axis)[0];
    start.arm = arm_on_ring(start.center, start.axis, ray).value_or(fallback);
    start_ = start;
}

std::optional<BodyEdit> Gizmo::drag(const OrbitCamera& camera, const glm::vec2& cursor, float aspect) {
    if (!start_) return std::nullopt;
    Start& start = *start_;
    const Ray ray = camera.pick_ray(cursor, aspect);
    const std::optional<double> along = along_axis(start.center, start.axis, ray);
    if (mode == GizmoMode::move) {
        if (!along) return std::nullopt;
        return edit::Pose{start.pose.position + Position(start.axis) * (*along - start.along), start.pose.rotation};
    }
    if (mode == GizmoMode::turn) {
        const std::optional<Vec3> arm = arm_on_ring(start.center, start.axis, ray);
        if (!arm) return std::nullopt;
        const float angle = std::atan2(glm::dot(start.axis, glm::cross(start.arm, *arm)), glm::dot(start.arm, *arm));
        const Quat turn = glm::angleAxis(angle, start.axis);
        const Vec3 offset(start.pose.position - start.center);
        return edit::Pose{start.center + Position(turn * offset), glm::normalize(turn * start.pose.rotation)};
    }
    Vec3 wanted(1.0f);
    if (start.handle == GizmoHandle::all) {
        const glm::vec2 moved = (cursor - start.cursor) * glm::vec2(aspect, 1.0f) * 0.5f;
        wanted = Vec3(std::exp2(uniform_rate * (moved.x + moved.y)));
    } else if (along && std::abs(start.along) > 1e-6) {
        wanted[int(start.handle)] = float(*along / start.along);
    }
    for (int i = 0; i < 3; ++i) wanted[i] = std::clamp(wanted[i], least_factor, greatest_factor);
    const Vec3 factors = wanted / start.scaled;
    if (factors == Vec3(1.0f)) return std::nullopt;
    start.scaled = wanted;
    return edit::Scale{factors};
}

} // namespace cairn::viewer
