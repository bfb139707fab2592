#include "contacts/round_touch.h"

#include "bodies/bodies.h"
#include "bodies/integrators.h"

#include <algorithm>
#include <optional>

namespace cairn {

using math::to_vec;

namespace {

constexpr float squared_rounding = 1e-10f; // of the difference of a unit vector that is computed twice, squared

// Whether a normal is that of a flat end of a cylinder, rather than that of its side, tapered or not.
bool is_end(const ShapePose& pose, math::Vec3 normal) {
    const math::Vec3 around = math::cross(axis_of(pose, 1), normal);
    return math::dot(around, around) < squared_rounding;
}

// The axis that a surface is round about where it is touched with that normal, or 0 if it is round about a point;
// nothing if it is neither, or if the solver does not track it.
std::optional<math::Vec3> round_about(const Geometry& g, const ShapePose& pose, math::Vec3 outwards) {
    if (g.type == ShapeType::sphere) return math::Vec3{};
    const bool is_straight = g.size.x == g.size.z && g.rounding == 0;
    if (!is_straight || (g.type != ShapeType::capsule && g.type != ShapeType::cylinder)) return {};
    const math::Vec3 axis = axis_of(pose, 1);
    const float cosine = math::dot(axis, outwards);
    if (cosine * cosine < squared_rounding) return axis;
    if (g.type == ShapeType::capsule) return math::Vec3{};
    return {};
}

} // namespace

math::Vec3 axis_of(const ShapePose& pose, int i) {
    const float* q = pose.q;
    return math::rotate(math::Quat{q[0], q[1], q[2], q[3]}, math::Vec3{float(i == 0), float(i == 1), float(i == 2)});
}

bool is_flat(const Geometry& g, const ShapePose& pose, math::Vec3 normal) {
    const bool is_rectangle = g.type == ShapeType::rectangle;
    if (g.type == ShapeType::plane) return true;
    if (!is_rectangle && (g.type != ShapeType::box || g.rounding > 0)) return false;
    const float* q = pose.q;
    const math::Vec3 n = math::rotate(math::Quat{-q[0], -q[1], -q[2], q[3]}, normal);
    const float x = n.x * n.x, y = n.y * n.y, z = n.z * n.z, off_y = x + z;
    return (is_rectangle ? off_y : std::min({y + z, off_y, x + y})) < squared_rounding;
}

bool touches_by_face(PairKind kind, const Manifold& m, bool is_second) {
    const bool is_told = kind == PairKind::convex_convex || kind == PairKind::group || kind == PairKind::patch;
    return is_told && (m.features[0] & (is_second ? on_second_face : on_first_face)) != 0;
}

bool has_corners(const Geometry& g) {
    return g.rounding == 0 && g.type != ShapeType::sphere && g.type != ShapeType::capsule &&
           g.type != ShapeType::cylinder;
}

TouchingFace touching_face(const Shapes& shapes, const ContactInfo& c, const Manifold& m, math::Vec3 normal,
                           const ShapePose& pose_a, const ShapePose& pose_b) {
    const Geometry &a = shapes.geometry[c.shape_a], &b = shapes.geometry[c.shape_b];
    // Points of hulls on hulls stay in place, as those of boxes on boxes do, which never get here.
    const bool is_smooth = !has_corners(a) || !has_corners(b);
    const auto by_face = [&](bool second) { return is_smooth && touches_by_face(c.kind, m, second); };
    if (is_flat(a, pose_a, normal) || by_face(c.flipped)) return TouchingFace::of_a;
    if (is_flat(b, pose_b, normal) || by_face(!c.flipped)) return TouchingFace::of_b;
    return TouchingFace::none;
}

bool has_own_normal(const Shapes& shapes, const ContactInfo& c, const ContactRecord& r) {
    const bool on_a = r.radius_a == on_face;
    if (!on_a && r.radius_b != on_face) return r.radius_a == 0 && r.radius_b == 0;
    const std::uint32_t shape = on_a ? c.shape_a : c.shape_b;
    const ShapeType type = shapes.geometry[shape].type;
    if (type != ShapeType::cylinder) return type != ShapeType::sphere && type != ShapeType::capsule;
    return is_end(shapes.poses[shape], to_vec(r.normal));
}

bool leaves_face(const Shapes& shapes, const ContactInfo& c, const ContactRecord& last, const Manifold& m,
                 const ShapePose& pose_a, const ShapePose& pose_b) {
    if (!may_be_round(c.kind) || (last.radius_a != on_face && last.radius_b != on_face)) return false;
    const math::Vec3 normal = c.flipped ? -to_vec(m.normal) : to_vec(m.normal), turn = normal - to_vec(last.normal);
    return math::dot(turn, turn) >= squared_rounding &&
           touching_face(shapes, c, m, normal, pose_a, pose_b) == TouchingFace::none;
}

bool is_followed(PairKind kind, const Geometry& g, const Geometry& other, const ShapePose& pose, const Manifold& m,
                 bool other_is_second) {
    const bool has_axis = g.type == ShapeType::sphere || g.type == ShapeType::capsule || g.type == ShapeType::cylinder;
    return m.count == 1 && has_axis &&
           (touches_by_face(kind, m, other_is_second) || is_flat(other, pose, to_vec(m.normal)));
}

math::Vec3 tilting_part(const Geometry& g, const ShapePose& pose, math::Vec3 w, math::Vec3 n) {
    if (g.type == ShapeType::sphere) return {};
    if (g.type != ShapeType::capsule && g.type != ShapeType::cylinder) return w;
    const math::Vec3 t = math::cross(axis_of(pose, 1), n);
    const float square = math::dot(t, t);
    return square > 0 ? (math::dot(w, t) / square) * t : w;
}

RoundPair round_pair(const Geometry& a, const ShapePose& pose_a, const Geometry& b, const ShapePose& pose_b,
                     math::Vec3 normal) {
    const std::optional<math::Vec3> about_a = round_about(a, pose_a, normal), about_b = round_about(b, pose_b, -normal);
    if (!about_a || !about_b) return {};
    const bool axis_a = *about_a != math::Vec3{}, axis_b = *about_b != math::Vec3{};
    if (axis_a && axis_b) return {}; // the normal is perpendicular to both axes and rotates with these alone
    if (axis_a) return {round_about_axis_of_a, *about_a};
    return {axis_b ? round_about_axis_of_b : round_about_points, *about_b};
}

void drop_separated_points(const NarrowInput& in, const ContactInfo& c, bool touches, const PosedShape& a,
                           const PosedShape& b, float dt, Manifold& m) {
    const auto is_round = [](const Geometry& g) {
        return g.type == ShapeType::cylinder || g.type == ShapeType::capsule;
    };
    if (m.count < 2 || (!is_round(a.geometry) && !is_round(b.geometry))) return;
    // The pose in which a falling body that touches nothing else will land is not known.
    if (!touches && in.bodies.links[c.body_a].contact_count <= (c.point_count > 0 ? 1 : 0)) return;
    const BodyMotion &motion_a = in.bodies.motion[c.body_a], &motion_b = in.bodies.motion[c.body_b];
    const math::Vec3 n = to_vec(m.normal),
                     pull = math::to_float(acceleration_at(in.bodies, in.fields, in.settings, c.body_a, motion_a.x));
    const math::Vec3 w_a = tilting_part(a.geometry, a.pose, motion_a.w, n),
                     w_b = tilting_part(b.geometry, b.pose, motion_b.w, n), w = w_b - w_a;
    const float turn = predicted_rotation(dt * math::length(w));
    const float bend = 0.5f * (turn * turn + dt * dt * math::length(pull) / in.bodies.links[c.body_a].radius);
    int lowest = 0, kept = 0;
    for (int i = 1; i < m.count; ++i)
        if (m.points[i][3] < m.points[lowest][3]) lowest = i;
    const std::uint32_t faces = m.features[0] & (on_first_face | on_second_face | on_flat_side);
    const math::Vec3 bearing = to_vec(m.points[lowest]);
    const math::Vec3 arm_a = a.arm + bearing, arm_b = arm_a + math::to_float(motion_a.x - motion_b.x);
    const float approach =
        math::dot(n, (motion_a.v + math::cross(w_a, arm_a)) - (motion_b.v + math::cross(w_b, arm_b)));
    // A body that meets another by one end rotates so that its other end comes down faster than the approach: for a
    // rod, 1.5 times as fast.
    const float tipping = touches ? 0.0f : 2 * dt * std::max(approach, 0.0f), least = m.points[lowest][3];
    for (int i = 0; i < m.count; ++i) {
        const math::Vec3 beside = to_vec(m.points[i]) - bearing;
        const float closing = std::max(-dt * math::dot(n, math::cross(w, beside)), 0.0f);
        if (m.points[i][3] - least > c.base_margin + closing + tipping + bend * math::length(beside)) continue;
        std::copy_n(m.points[i], 4, m.points[kept]);
        m.features[kept++] = m.features[i];
    }
    m.features[0] |= faces;
    for (int i = kept; i < m.count; ++i) m.points[i][3] = 1e30f;
    m.count = kept;
}

} // namespace cairn
