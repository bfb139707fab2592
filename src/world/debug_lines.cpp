// Debug lines: a drawing of the bodies, contacts and joints of a world.
#include "world/impl.h"
#include "world/validate.h"
#include "world/wireframe.h"

#include <glm/gtc/quaternion.hpp>

#include <cmath>

namespace cairn {

namespace {

constexpr Vec3 static_color{0.6f, 0.6f, 0.6f}, kinematic_color{0.3f, 0.8f, 0.9f}, awake_color{0.95f, 0.75f, 0.3f},
    asleep_color{0.45f, 0.5f, 0.75f}, trigger_color{0.4f, 0.85f, 0.4f}, bounds_color{0.8f, 0.35f, 0.8f},
    velocity_color{1.0f, 1.0f, 0.4f}, contact_color{1.0f, 0.25f, 0.2f}, joint_color{1.0f, 1.0f, 1.0f};
constexpr Vec3 axis_colors[3] = {{0.9f, 0.2f, 0.2f}, {0.2f, 0.8f, 0.2f}, {0.3f, 0.4f, 1.0f}};
constexpr float shown_time = 0.1f; // A velocity is drawn as the distance covered in this time, s.

Position at(const Transform& frame, const Vec3& point) {
    return frame.position + Position(glm::dquat(frame.rotation) * glm::dvec3(point));
}
Transform in_world(const World& world, BodyId body, const Transform& frame) {
    if (body.is_null()) return frame;
    const Transform outer = world.body(body).transform();
    const glm::dquat turn(outer.rotation);
    return {outer.position + Position(turn * glm::dvec3(frame.position)),
            glm::normalize(outer.rotation * frame.rotation)};
}

class LineWriter {
  public:
    LineWriter(const World& world, const DebugLinesDef& what, std::vector<DebugLine>& lines)
        : world_(world), what_(what), lines_(lines) {}

    void body(const Body& body) {
        for (const ShapeId shape : body.shapes()) {
            if (what_.shapes) edges(shape, color_of(body, shape));
            if (what_.bounds) box(world_.shape_bounds(shape));
        }
        if (what_.centers && body.type() == BodyType::dynamic) {
            const MassProperties mass = body.mass_properties();
            axes({body.center_of_mass(), glm::normalize(body.rotation() * mass.inertia_orientation)});
        }
        if (const Vec3 v = body.linear_velocity(); what_.velocities && v != Vec3(0.0f))
            line(body.center_of_mass(), body.center_of_mass() + Position(shown_time * v), velocity_color);
    }
    void contact(const Contact& contact) {
        for (int i = 0; i < contact.point_count; ++i) {
            const ContactPoint& point = contact.points[i];
            const float length = what_.impulse_scale > 0.0f ? what_.impulse_scale * point.normal_impulse : what_.size;
            line(point.point, point.point + Position(length * contact.normal), contact_color);
        }
    }
    void joint(const JointDef& def) {
        const Transform a = in_world(world_, def.body_a, def.frame_a), b = in_world(world_, def.body_b, def.frame_b);
        if (!def.body_a.is_null()) line(world_.body(def.body_a).center_of_mass(), a.position, joint_color);
        if (!def.body_b.is_null()) line(world_.body(def.body_b).center_of_mass(), b.position, joint_color);
        line(a.position, b.position, joint_color);
        axes(a);
    }

  private:
    static Vec3 color(BodyType type, bool is_awake) {
        if (type == BodyType::static_) return static_color;
        if (type == BodyType::kinematic) return kinematic_color;
        return is_awake ? awake_color : asleep_color;
    }
    Vec3 color_of(const Body& body, ShapeId shape) const {
        return world_.shape_def(shape).is_trigger ? trigger_color : color(body.type(), body.is_awake());
    }
    void line(const Position& from, const Position& to, const Vec3& color) { lines_.push_back({from, to, color}); }
    void axes(const Transform& frame) {
        for (int i = 0; i < 3; ++i) {
            Vec3 tip(0.0f);
            tip[i] = what_.size;
            line(frame.position, at(frame, tip), axis_colors[i]);
        }
    }
    void edges(ShapeId shape, const Vec3& color) {
        const Transform pose = world_.shape_transform(shape);
        list_edges(world_.shape(shape), edges_);
        for (const Edge& edge : edges_) line(at(pose, edge.from), at(pose, edge.to), color);
    }
    void box(const Bounds& bounds) {
        if (!std::isfinite(bounds.min.x) || !std::isfinite(bounds.max.x)) return; // an infinite plane
        const auto corner = [&](int i) {
            return Position(i & 1 ? bounds.max.x : bounds.min.x, i & 2 ? bounds.max.y : bounds.min.y,
                            i & 4 ? bounds.max.z : bounds.min.z);
        };
        for (int i = 0; i < 8; ++i)
            for (const int side : {1, 2, 4})
                if (!(i & side)) line(corner(i), corner(i | side), bounds_color);
    }

    const World& world_;
    const DebugLinesDef& what_;
    std::vector<DebugLine>& lines_;
    std::vector<Edge> edges_;
};

} // namespace

std::vector<DebugLine> World::debug_lines(const DebugLinesDef& what) const {
    impl_->require_usable("World::debug_lines");
    require_above("DebugLinesDef.size", what.size, 0);
    require_at_least("DebugLinesDef.impulse_scale", what.impulse_scale, 0);
    std::vector<DebugLine> lines;
    LineWriter writer(*this, what, lines);
    const auto is_there = [&](BodyId id) { return id.is_null() || body(id).enabled(); };
    for (const BodyId id : bodies())
        if (is_there(id)) writer.body(body(id));
    if (what.contacts)
        for (const Contact& contact : contacts()) writer.contact(contact);
    if (what.joints)
        for (const JointId id : joints())
            if (const JointDef& def = joint_def(id); def.enabled && is_there(def.body_a) && is_there(def.body_b))
                writer.joint(def);
    return lines;
}

} // namespace cairn
