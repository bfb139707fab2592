#include "viewer/joint_drawing.h"

#include "viewer/joint_info.h"
#include "viewer/palette.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>

namespace cairn::viewer {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
// Size limits of a drawing, as shares of its distance from the camera.
constexpr float min_size = 0.008f, greatest_size = 0.08f;
constexpr float size_of_reach = 0.55f;     // size of a drawing, as a share of the body's reach
constexpr std::size_t max_strokes = 30000; // beyond which joints are drawn as dots
constexpr float free_linear_error = 0.05f; // tolerated position error, as a share of the reach
constexpr float free_angular_error = 0.1f; // tolerated angular error, rad

constexpr float heavy_load = 0.5f; // share of the breaking force or torque

bool fails(const JointLayout& joint, const JointState& state) {
    if (!joint.def.enabled) return false;
    return state.linear_error > free_linear_error * joint.reach || state.angular_error > free_angular_error;
}

// A joint frame, relative to the frame's origin.
struct Axes {
    Vec3 at, x, y, z;

    const Vec3& axis(int i) const { return i == 0 ? x : i == 1 ? y : z; }
};

Axes axes_at(const Vec3& at, const Quat& rotation) {
    return {at, rotation * Vec3(1, 0, 0), rotation * Vec3(0, 1, 0), rotation * Vec3(0, 0, 1)};
}

// Draws the parts of one joint. Angles about an axis are measured from its first side vector to its second.
class JointPen {
  public:
    JointPen(RenderFrame& frame, const JointFrames& frames, float size, const Vec3& color, float width)
        : a(axes_at(Vec3(frames.a.position - frame.origin), frames.a.rotation)),
          b(axes_at(Vec3(frames.b.position - frame.origin), frames.b.rotation)), frame_(frame), size_(size),
          color_(color), width_(width) {}

    const Axes a, b;

    void line(const Vec3& from, const Vec3& to, float width_factor = 1.0f) {
        frame_.strokes.push_back({from, to, color_, width_ * width_factor});
    }
    void dot(const Vec3& at, float width_factor = 3.5f) {
        frame_.strokes.push_back({at, at, color_, width_ * width_factor});
    }
    void axis_line(const Vec3& at, const Vec3& axis) { line(at - axis * size_, at + axis * size_); }

    void arc(const Vec3& at, const Vec3& u, const Vec3& v, float from, float to, float radius) {
        const int pieces = std::max(int(std::ceil(std::abs(to - from) / (pi / 24.0f))), 1);
        Vec3 last = at + around(u, v, from) * radius;
        for (int i = 1; i <= pieces; ++i) {
            const Vec3 next = at + around(u, v, from + (to - from) * float(i) / float(pieces)) * radius;
            line(last, next, 0.75f);
            last = next;
        }
    }
    void circle(const Vec3& at, const Vec3& u, const Vec3& v, float radius) { arc(at, u, v, 0.0f, 2.0f * pi, radius); }

    // A sector between the limits, or a circle without limits, and a hand at the present angle.
    void angle(const Vec3& at, const Vec3& u, const Vec3& v, const std::optional<JointRange>& limits,
               const Vec3& hand) {
        const float radius = 0.8f * size_;
        line(at, at + hand * radius, 1.25f);
        const bool bounded = limits && std::isfinite(limits->lower) && std::isfinite(limits->upper);
        if (!bounded || limits->upper - limits->lower >= 2.0f * pi) {
            circle(at, u, v, radius);
            if (!limits || bounded) return;
            const float bound = std::isfinite(limits->lower) ? limits->lower : limits->upper;
            if (std::isfinite(bound)) line(at, at + around(u, v, bound) * radius);
            return;
        }
        arc(at, u, v, limits->lower, limits->upper, radius);
        for (const float bound : {limits->lower, limits->upper}) line(at, at + around(u, v, bound) * radius, 0.75f);
        fan(at, u, v, limits->lower, limits->upper, radius);
    }

    // The translation axis from `at` with a stop at each limit, up to the present position.
    void way(const Vec3& at, const Axes& frame, const Vec3& axis, const std::optional<JointRange>& limits, float now) {
        float lower = std::min(-size_, now), upper = std::max(size_, now);
        if (limits && std::isfinite(limits->lower)) lower = limits->lower, stop(at + axis * lower, frame, axis);
        if (limits && std::isfinite(limits->upper)) upper = limits->upper, stop(at + axis * upper, frame, axis);
        line(at + axis * std::min(lower, now), at + axis * std::max(upper, now));
    }

    // A cone with that half angle about an axis.
    void cone(const Vec3& at, const Vec3& axis, const Vec3& u, const Vec3& v, float half_angle) {
        constexpr int sides = 24;
        const Vec3 middle = axis * (size_ * std::cos(half_angle));
        const float radius = size_ * std::sin(half_angle);
        for (int i = 0; i < sides; ++i) {
            const auto rim = [&](int k) { return at + middle + around(u, v, 2.0f * pi * float(k) / sides) * radius; };
            line(rim(i), rim(i + 1), 0.75f);
            if (i % 6 == 0) line(at, rim(i), 0.5f);
            frame_.veils.push_back({at, rim(i), rim(i + 1), color_});
        }
    }

    void cross(const Axes& at) {
        for (int i = 0; i < 3; ++i) line(at.at - at.axis(i) * (0.3f * size_), at.at + at.axis(i) * (0.3f * size_));
    }
    // A coil between two points.
    void coil(const Vec3& from, const Vec3& to) {
        constexpr int turns = 10, pieces_per_turn = 10;
        const Vec3 way = to - from;
        const float length = glm::length(way);
        if (!(length > 1e-6f)) return;
        const Vec3 axis = way / length;
        const Vec3 u = glm::normalize(glm::cross(axis, std::abs(axis.y) < 0.9f ? Vec3(0, 1, 0) : Vec3(1, 0, 0)));
        const Vec3 v = glm::cross(axis, u);
        constexpr int pieces = turns * pieces_per_turn;
        const float radius = std::min(0.2f * size_, 0.15f * length);
        Vec3 last = from;
        for (int i = 1; i <= pieces; ++i) {
            const float part = float(i) / pieces;
            // The coil's ends lie on its axis.
            const float grown = radius * std::min(1.0f, 8.0f * std::min(part, 1.0f - part));
            const Vec3 next = from + way * part + around(u, v, 2.0f * pi * turns * part) * grown;
            line(last, next, 0.75f);
            last = next;
        }
    }
    float size() const { return size_; }

  private:
    static Vec3 around(const Vec3& u, const Vec3& v, float angle) { return u * std::cos(angle) + v * std::sin(angle); }
    void stop(const Vec3& at, const Axes& frame, const Vec3& axis) {
        for (int i = 0; i < 3; ++i)
            if (std::abs(glm::dot(frame.axis(i), axis)) < 0.5f)
                line(at - frame.axis(i) * (0.3f * size_), at + frame.axis(i) * (0.3f * size_), 1.25f);
    }
    void fan(const Vec3& at, const Vec3& u, const Vec3& v, float from, float to, float radius) {
        const int pieces = std::max(int(std::ceil((to - from) / (pi / 24.0f))), 1);
        const auto rim = [&](int i) {
            return at + around(u, v, from + (to - from) * float(i) / float(pieces)) * radius;
        };
        for (int i = 0; i < pieces; ++i) frame_.veils.push_back({at, rim(i), rim(i + 1), color_});
    }

    RenderFrame& frame_;
    float size_;
    Vec3 color_;
    float width_;
};

float along(const Vec3& axis, const JointPen& pen) { return glm::dot(axis, pen.b.at - pen.a.at); }

// The normalized projection of a vector onto the plane perpendicular to an axis; zero if it is parallel to the axis.
Vec3 across(const Vec3& v, const Vec3& axis) {
    const Vec3 flat = v - axis * glm::dot(v, axis);
    const float length = glm::length(flat);
    return length > 1e-6f ? flat / length : Vec3(0.0f);
}

struct JointShape {
    JointPen& pen;
    const Position& origin; // of the frame

    void operator()(const FixedJoint&) const {
        const Axes& a = pen.a;
        const float half = 0.2f * pen.size();
        const auto corner = [&](int i) {
            return a.at + (a.x * (i & 1 ? half : -half) + a.y * (i & 2 ? half : -half) + a.z * (i & 4 ? half : -half));
        };
        for (int i = 0; i < 8; ++i)
            for (const int axis : {1, 2, 4})
                if (!(i & axis)) pen.line(corner(i), corner(i | axis), 0.75f);
    }
    void operator()(const BallJoint& joint) const {
        const Axes &a = pen.a, &b = pen.b;
        if (joint.cone_angle) {
            pen.cone(b.at, a.x, a.y, a.z, *joint.cone_angle);
            pen.line(b.at, b.at + b.x * pen.size(), 1.25f);
        } else {
            for (int i = 0; i < 3; ++i) pen.circle(b.at, a.axis(i), a.axis((i + 1) % 3), 0.3f * pen.size());
        }
        if (!joint.twist) return;
        // The twist is the angle about B's x axis, measured from A's y axis after the shortest rotation that takes A's
        // x axis to B's.
        const Vec3 swing = glm::cross(a.x, b.x);
        const float halfway = std::max(1.0f + glm::dot(a.x, b.x), 1e-6f);
        const Vec3 swung =
            across(a.y + glm::cross(swing, a.y) + glm::cross(swing, glm::cross(swing, a.y)) / halfway, b.x);
        pen.angle(b.at, swung, glm::cross(b.x, swung), joint.twist, b.y);
    }
    void operator()(const HingeJoint& joint) const {
        pen.axis_line(pen.a.at, pen.a.x);
        pen.angle(pen.a.at, pen.a.y, pen.a.z, joint.angle.limits, across(pen.b.y, pen.a.x));
    }
    void operator()(const SliderJoint& joint) const {
        pen.way(pen.a.at, pen.a, pen.a.x, joint.translation.limits, along(pen.a.x, pen));
    }
    void operator()(const CylindricalJoint& joint) const {
        pen.way(pen.a.at, pen.a, pen.a.x, joint.translation.limits, along(pen.a.x, pen));
        pen.angle(pen.b.at, pen.a.y, pen.a.z, joint.angle.limits, across(pen.b.y, pen.a.x));
    }
    void operator()(const UniversalJoint& joint) const {
        const Axes &a = pen.a, &b = pen.b;
        pen.axis_line(a.at, a.x);
        pen.axis_line(a.at, b.y);
        pen.angle(a.at, a.y, a.z, joint.first.limits, across(b.y, a.x));
        if (!joint.second.limits) return;
        const Vec3 zero = glm::cross(a.x, b.y); // zero direction for the rotation of B's z axis about its y axis
        pen.angle(a.at, zero, a.x, joint.second.limits, across(b.z, b.y));
    }
    void operator()(const DistanceJoint& joint) const {
        const Vec3 &from = pen.a.at, &to = pen.b.at;
        const JointControl& distance = joint.distance;
        if (distance.motor && distance.motor->spring) return pen.coil(from, to);
        const float length = glm::length(to - from);
        const bool is_slack = distance.limits && length < 0.99f * distance.limits->upper && distance.limits->lower <= 0;
        pen.line(from, to, is_slack ? 0.5f : 1.25f);
    }
    void operator()(const WheelJoint& joint) const {
        const Axes &a = pen.a, &b = pen.b;
        pen.way(a.at, a, a.x, joint.suspension.limits, along(a.x, pen));
        pen.axis_line(b.at, b.y);
        if (joint.steering) pen.angle(b.at, a.y, a.z, joint.steering->limits, across(b.y, a.x));
        pen.circle(b.at, b.z, b.x, 0.5f * pen.size());
        pen.line(b.at, b.at + b.x * (0.5f * pen.size()));
    }
    void operator()(const ServoJoint& joint) const {
        const Axes local = axes_at(joint.position, joint.rotation);
        const Vec3 at = pen.a.at + turned(local.at);
        pen.cross({at, turned(local.x), turned(local.y), turned(local.z)});
        pen.line(at, pen.b.at, 0.75f);
    }
    void operator()(const GearJoint& joint) const {
        const float distance = glm::length(pen.b.at - pen.a.at), ratio = std::abs(joint.ratio);
        const float radius = distance > 0.0f ? distance / (1.0f + ratio) : pen.size();
        pen.circle(pen.a.at, pen.a.y, pen.a.z, radius);
        pen.circle(pen.b.at, pen.b.y, pen.b.z, radius * ratio);
        pen.line(pen.a.at, pen.a.at + pen.a.y * radius);
        pen.line(pen.b.at, pen.b.at + pen.b.y * (radius * ratio));
    }
    void operator()(const RackJoint& joint) const {
        pen.circle(pen.a.at, pen.a.y, pen.a.z, std::abs(joint.radius));
        pen.line(pen.a.at, pen.a.at + pen.a.y * std::abs(joint.radius));
        pen.axis_line(pen.b.at, pen.b.x);
    }
    void operator()(const PulleyJoint& joint) const {
        const Vec3 over_a(joint.ground_a - origin), over_b(joint.ground_b - origin);
        pen.line(pen.a.at, over_a);
        pen.line(over_a, over_b, 0.75f);
        pen.line(over_b, pen.b.at);
        pen.dot(over_a);
        pen.dot(over_b);
    }
    void operator()(const GeneralJoint& joint) const {
        const Axes &a = pen.a, &b = pen.b;
        for (const JointLimit& limit : joint.limits) draw_limit(limit);
        for (const JointDrive& drive : joint.drives) {
            const Vec3& axis = a.axis(drive.axis);
            if (drive.kind == JointAxis::angular)
                pen.circle(b.at, a.axis((drive.axis + 1) % 3), a.axis((drive.axis + 2) % 3), 0.5f * pen.size());
            else
                pen.line(b.at, b.at + axis * (drive.position_target - glm::dot(axis, b.at - a.at)), 0.75f);
        }
    }

  private:
    // Rotates a vector from frame A to the world.
    Vec3 turned(const Vec3& v) const { return pen.a.x * v.x + pen.a.y * v.y + pen.a.z * v.z; }

    void draw_limit(const JointLimit& limit) const {
        if (limit.min == 0.0f && limit.max == 0.0f) return; // a lock permits no motion, so nothing is drawn
        constexpr float infinity = std::numeric_limits<float>::infinity();
        const Axes &a = pen.a, &b = pen.b;
        const JointRange range{limit.min.value_or(-infinity), limit.max.value_or(infinity), {}};
        const int count = int(limit.axes[0]) + int(limit.axes[1]) + int(limit.axes[2]);
        const bool is_angle = limit.kind == JointAxis::angular;
        const bool wanted = count != 2; // flag value that singles out one axis
        const int axis = limit.axes[0] == wanted ? 0 : limit.axes[1] == wanted ? 1 : 2;
        const Vec3 &x = a.axis(axis), &u = a.axis((axis + 1) % 3), &v = a.axis((axis + 2) % 3);
        if (count == 1 && is_angle) {
            pen.axis_line(b.at, x);
            pen.angle(b.at, u, v, range, across(b.axis((axis + 1) % 3), x));
        } else if (count == 1) {
            pen.way(a.at, a, x, range, along(x, pen));
        } else if (count == 2 && is_angle) {
            if (limit.max) pen.cone(b.at, x, u, v, std::min(*limit.max, pi));
            pen.line(b.at, b.at + b.axis(axis) * pen.size(), 1.25f);
        } else if (!is_angle) {
            for (const std::optional<float>& radius : {limit.min, limit.max})
                if (radius && *radius > 0.0f) pen.circle(a.at, u, v, *radius);
            pen.line(a.at, b.at);
        }
    }
};

} // namespace

Vec3 joint_color(const JointLayout& joint, const JointState& state) {
    if (!joint.def.enabled) return disabled_color();
    if (fails(joint, state)) return joint_error_color();
    return joint_ramp(joint_load(joint.def, state));
}

bool is_shown(const JointLayout& joint, const JointState& state, const WorldLayout& layout,
              const FrameOptions& options) {
    if (options.joints != JointsShown::some) return options.joints == JointsShown::all;
    if (joint.id == options.selected_joint) return true;
    const auto is_selected = [&](const std::optional<std::size_t>& body) {
        return body && options.selected && layout.bodies[*body].id == options.selected;
    };
    if (is_selected(joint.body_a) || is_selected(joint.body_b)) return true;
    return fails(joint, state) || joint_load(joint.def, state) >= heavy_load;
}

void draw_joints(RenderFrame& frame, const WorldLayout& layout, const WorldMotion& motion,
                 std::span<const Transform> bodies, const FrameOptions& options) {
    constexpr float width = 2.0f, bold = 3.2f; // pixels
    const Vec3 eye(frame.camera.position - frame.origin), to_target(frame.camera.target - frame.camera.position);
    const Vec3 forward = glm::normalize(to_target);
    const bool is_parallel = frame.camera.is_parallel;
    for (std::size_t i = 0; i < motion.joints->size(); ++i) {
        const JointLayout& joint = (*motion.joints)[i];
        if (!is_shown(joint, motion.joint_states[i], layout, options)) continue;
        const JointFrames frames = frames_of(joint, bodies);
        const bool is_selected = joint.id == options.selected_joint;
        const Vec3 color = is_selected ? Vec3(1.0f) : joint_color(joint, motion.joint_states[i]);
        const Vec3 offset = Vec3(frames.b.position - frame.origin) - eye;
        const float distance = lens_of(frame.camera) * glm::length(is_parallel ? to_target : offset);
        const bool is_behind = !is_parallel && glm::dot(offset, forward) < -joint.reach;
        const float size = std::clamp(size_of_reach * joint.reach, min_size * distance, greatest_size * distance);
        JointPen pen(frame, frames, size, color, is_selected ? bold : width);
        const bool is_tiny = size_of_reach * joint.reach < min_size * distance || frame.strokes.size() > max_strokes;
        if (!is_selected && (is_tiny || is_behind)) { // keeps thousands of joints cheap
            pen.dot(pen.b.at, 1.5f);
            if (std::holds_alternative<DistanceJoint>(joint.def.joint)) pen.line(pen.a.at, pen.b.at, 0.5f);
            continue;
        }
        for (const auto& [body, at] : {std::pair{joint.body_a, pen.a.at}, std::pair{joint.body_b, pen.b.at}})
            if (body && layout.bodies[*body].type != BodyType::static_)
                pen.line(Vec3(bodies[*body].position - frame.origin), at, 0.5f);
        pen.dot(pen.a.at);
        pen.dot(pen.b.at);
        const bool is_together = motion.joint_states[i].linear_error > 0.0f && glm::length(pen.b.at - pen.a.at) > 0.0f;
        if (is_together && color == joint_error_color()) pen.line(pen.a.at, pen.b.at); // the gap
        std::visit(JointShape{pen, frame.origin}, joint.def.joint);
    }
}

void add_band(std::vector<Vec3>& triangles, const Stroke& stroke, const StrokeView& view) {
    constexpr float nearest = 0.01f; // m, minimum depth; keeps the band of a point behind the camera from flipping
    const auto half_width = [&](const Vec3& at) {
        const float depth = view.parallel_distance.value_or(glm::dot(at - view.eye, view.forward));
        return 0.5f * stroke.width * view.pixel * std::max(depth, nearest);
    };
    const Vec3 way = stroke.to - stroke.from;
    if (glm::dot(way, way) > 0.0f) {
        const Vec3 side = glm::cross(way, view.parallel_distance ? view.forward : stroke.from - view.eye);
        const float length = glm::length(side);
        if (!(length > 0.0f)) return; // seen end-on
        const Vec3 at_from = side * (half_width(stroke.from) / length), at_to = side * (half_width(stroke.to) / length);
        const Vec3 a = stroke.from - at_from, b = stroke.from + at_from, c = stroke.to - at_to, d = stroke.to + at_to;
        triangles.insert(triangles.end(), {a, b, c, c, b, d});
        return;
    }
    const int sides = stroke.width > 5.5f ? 12 : 4;
    const Vec3 other = std::abs(view.forward.y) < 0.9f ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    const Vec3 u = glm::normalize(glm::cross(view.forward, other)), v = glm::cross(u, view.forward);
    const float radius = half_width(stroke.from);
    const auto rim = [&](int i) {
        const float angle = 2.0f * pi * float(i) / float(sides);
        return stroke.from + (u * std::cos(angle) + v * std::sin(angle)) * radius;
    };
    for (int i = 0; i < sides; ++i) triangles.insert(triangles.end(), {stroke.from, rim(i), rim(i + 1)});
}

} // namespace cairn::viewer
