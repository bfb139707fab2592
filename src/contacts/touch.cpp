#include "contacts/touch.h"

#include "bodies/bodies.h"
#include "bodies/integrators.h"
#include "bodies/motion_budget.h"
#include "collision/core_sweep.h"
#include "contacts/contact_record.h"
#include "contacts/contact_update.h"
#include "contacts/convex_tests.h"
#include "contacts/pairs.h"
#include "contacts/round_touch.h"
#include "math/rotation.h"
#include "state/joint_links.h"

#include <algorithm>
#include <optional>

namespace cairn {

using math::DQuat;
using math::DVec3;

namespace {

// s: the time that contacts of this step must cover. The last substep looks ahead at the next one as well.
float looked_at(const NarrowInput& in, float dt) { return dt * (1 + 1.0f / float(in.substeps)); }

// Whether joints constrain a body, so that it does not move exactly as its velocities predict: less so if it is fast,
// or passes the other body.
bool has_joints(const Bodies& bodies, std::int32_t b) { return bodies.links[b].joint_count > 0; }

// A jointed body is expected to rotate about the anchor of the joint to its heaviest neighbor, provided that this
// neighbor is at least as heavy as the body: a door rotates about its hinge, a shin about the knee. A heavier body is
// expected to move as if it had no joints.
struct Lead {
    std::int32_t body; // the neighbor; `none`: the world
    DVec3 arm;         // of the anchor from the center of mass, in the body's frame
};
std::optional<Lead> lead_of(const NarrowInput& in, std::int32_t b) {
    const auto weight_of = [&](std::int32_t body) {
        return body == none || !in.bodies.is_dynamic(body) ? unlimited : in.bodies.mass[body].mass;
    };
    std::optional<Lead> lead;
    float least = weight_of(b);
    for_each_joint(in.bodies, in.joints, b, [&](std::uint32_t joint, int side) {
        const JointInfo& info = in.joints.info[joint];
        const std::int32_t other = other_body(info, side);
        const float weight = weight_of(other);
        const bool holds = info.rules.point == JointLock::full && joint_owner(in.bodies, info) != none;
        if (!holds || !(lead ? weight > least : weight >= least)) return;
        least = weight;
        lead = {other, (side == 0 ? info.anchor_a : info.anchor_b) - math::to_double(in.bodies.mass[b].center)};
    });
    return lead;
}

// The expected path of a body, of which one point moves in a straight line: for a free body, its center of mass.
struct ExpectedPath {
    DVec3 point; // m from the center of mass, in the body's frame
    RigidPath path;
    // The pose with the position of the center of mass.
    RigidPath::Pose at(double time) const {
        const RigidPath::Pose there = path.at(time);
        return {there.x - math::rotate(there.q, point), there.q};
    }
};

// The path that velocities and forces predict. Forces act in substeps, which is close enough to continuously. Positions
// are relative to `origin`, for precision far from the world's origin.
ExpectedPath expected_path(const NarrowInput& in, std::int32_t b, DVec3 origin, float dt) {
    const Bodies& bodies = in.bodies;
    const BodyMotion& m = bodies.motion[b];
    const DVec3 from = m.x - origin;
    if (bodies.settings[b].type == BodyType::static_ || (bodies.is_dynamic(b) && !is_awake(bodies, in.islands, b)))
        return {{}, RigidPath::between(from, m.q, from, m.q)};
    const double t = double(dt);
    const std::optional<Lead> lead = lead_of(in, b);
    const DVec3 point = lead ? lead->arm : DVec3{}, arm = math::rotate(m.q, point), w = math::to_double(m.w);
    DVec3 way = t * (math::to_double(m.v) + math::cross(w, arm));
    const auto lies = [&](std::int32_t body) { return bodies.links[body].contact_count > 0; };
    const bool is_held =
        lies(b) || (lead && (lead->body == none || !bodies.is_dynamic(lead->body) || lies(lead->body)));
    if (!is_held) way += (0.5 * t * t) * acceleration_at(bodies, in.fields, in.settings, b, m.x);
    return {point, RigidPath::between(from + arm, m.q, from + arm + way, math::from_rotation_vector(t * w) * m.q)};
}

SweptShape swept(const Bodies& bodies, const Shapes& shapes, std::uint32_t shape, const ExpectedPath& way) {
    const Geometry& g = shapes.geometry[shape];
    const math::Vec3 center = bodies.mass[shapes.links[shape].body].center;
    return {g, shapes.data[shape], math::to_double(g.position - center) - way.point, way.path};
}

struct PosedBody {
    DVec3 moved;
    math::Vec3 arm;
    ShapePose pose;
};
// `from`: the position of the body relative to the origin of the path.
PosedBody posed_at(const Bodies& bodies, const Shapes& shapes, std::uint32_t shape, const ExpectedPath& way, DVec3 from,
                   double time) {
    const RigidPath::Pose body = way.at(time);
    const Geometry& g = shapes.geometry[shape];
    const math::Quat q = math::to_float(body.q);
    PosedBody p{body.x - from, {}, shapes.poses[shape]};
    p.arm = math::rotate(q, g.position - bodies.mass[shapes.links[shape].body].center);
    pose_shape(p.pose, g, bodies.motion[shapes.links[shape].body].x + (p.moved + math::to_double(p.arm)), q);
    return p;
}

// The manifold at given poses. `margin`: up to which points may come to touch in the rest of the step. `normal`: from A
// to B at the touch.
Manifold manifold_at(const Shapes& shapes, const ContactInfo& c, const PosedBody& at_a, const PosedBody& at_b,
                     DVec3 normal, float margin) {
    const PosedShape a{shapes.geometry[c.shape_a], shapes.data[c.shape_a], at_a.pose, at_a.arm};
    const PosedShape b{shapes.geometry[c.shape_b], shapes.data[c.shape_b], at_b.pose, at_b.arm};
    const math::Vec3 n = math::to_float(normal);
    return c.flipped ? test_posed_pair(c.kind, b, a, -n, margin) : test_posed_pair(c.kind, a, b, n, margin);
}

// Removes the part of a normal along the relative velocity: where two shapes are nearest on their paths, nothing
// approaches along the normal. The normal's precision is a share of the distance, not enough for shapes that move on
// for meters within the step.
DVec3 clear_of_approach(DVec3 normal, DVec3 velocity) {
    const double square = math::dot(velocity, velocity), along = math::dot(normal, velocity);
    if (!(square > 0) || !(along * along < 0.01 * square)) return normal; // nearest at an end of the paths
    const DVec3 clear = normal - (along / square) * velocity;
    return (1 / math::length(clear)) * clear;
}

// The displacement of the contact point per change of the unit normal, m, by which the normal impulse on a round shape
// keeps passing through its center; for two round shapes, the difference of both radii.
double shift_per_normal(const Shapes& shapes, const ContactInfo& c, const PosedBody& at_a, const PosedBody& at_b,
                        const Nearness& found) {
    const math::Vec3 normal = math::to_float(found.normal);
    const float apart = float(found.distance);
    return double(contact_radius(shapes.geometry[c.shape_a], at_a.pose, normal, apart)) -
           double(contact_radius(shapes.geometry[c.shape_b], at_b.pose, -normal, apart));
}

// A manifold of one point, where two shapes are nearest on their paths. The normal of two round shapes that the solver
// updates is kept as found.
Manifold nearest_point_manifold(const Bodies& bodies, const Shapes& shapes, const ContactInfo& c, const PosedBody& at_a,
                                const PosedBody& at_b, const Nearness& found) {
    const BodyMotion &a = bodies.motion[c.body_a], &b = bodies.motion[c.body_b];
    const DVec3 velocity_a = math::to_double(a.v) + math::cross(math::to_double(a.w), found.on_a - at_a.moved);
    const DVec3 velocity_b =
        math::to_double(b.v) + math::cross(math::to_double(b.w), found.on_a - ((b.x - a.x) + at_b.moved));
    const bool is_followed = round_pair(shapes.geometry[c.shape_a], at_a.pose, shapes.geometry[c.shape_b], at_b.pose,
                                        math::to_float(found.normal))
                                 .about > 0;
    const DVec3 normal = is_followed ? found.normal : clear_of_approach(found.normal, velocity_b - velocity_a);
    const DVec3 midway = found.on_a + (0.5 * found.distance) * found.normal +
                         shift_per_normal(shapes, c, at_a, at_b, found) * (normal - found.normal);
    Manifold m{};
    math::put(m.normal, math::to_float(c.flipped ? -normal : normal));
    m.count = 1;
    // The position of the first shape, relative to A's center of mass at the start of the step.
    const DVec3 first =
        c.flipped ? (b.x - a.x) + (at_b.moved + math::to_double(at_b.arm)) : at_a.moved + math::to_double(at_a.arm);
    math::put(m.points[0], math::to_float(midway - first));
    m.points[0][3] = float(found.distance);
    for (int i = 1; i < 4; ++i) m.points[i][3] = 1e30f;
    return m;
}

// The expected paths of a pair, relative to A.
class ExpectedWays {
  public:
    ExpectedWays(const NarrowInput& in, const ContactInfo& c, float dt, DVec3 lift = {})
        : in(in), c_(c), dt_(dt), a_(expected_path(in, c.body_a, in.bodies.motion[c.body_a].x - lift, dt)),
          b_(expected_path(in, c.body_b, in.bodies.motion[c.body_a].x, dt)), from_a_(a_.at(0).x - lift),
          from_b_(b_.at(0).x) {}
    SweptShape of_a() const { return swept(in.bodies, in.shapes, c_.shape_a, a_); }
    SweptShape of_b() const { return swept(in.bodies, in.shapes, c_.shape_b, b_); }

    // Evaluates what the search has found. For shapes that touch, the manifold is left out.
    Approach take(const Nearness& found, Touch& touch) const {
        if (!(found.distance <= double(c_.base_margin))) return Approach::passes;
        touch.is_beside = found.distance > 0;
        const bool any_led = has_joints(in.bodies, c_.body_a) || has_joints(in.bodies, c_.body_b);
        const bool is_now = !(found.time > 0) || (any_led && !touch.is_beside);
        const PosedBody at_a = posed_a(found), at_b = posed_b(found);
        touch.passed = at_a.moved - at_b.moved;
        const DVec3 from_b = (in.bodies.motion[c_.body_a].x - in.bodies.motion[c_.body_b].x) + touch.passed;
        touch.moment = {dt_ * float(found.time), c_.flipped ? at_b.arm : at_a.arm, math::to_float(from_b), nullptr,
                        nullptr};
        touch.pose_a = at_a.pose, touch.pose_b = at_b.pose;
        touch.arm_a = at_a.arm;
        if (touch.is_beside) touch.manifold = nearest_point_manifold(in.bodies, in.shapes, c_, at_a, at_b, found);
        return is_now ? Approach::now : Approach::later;
    }
    Manifold manifold_at_touch(const Nearness& found, float margin) const {
        return manifold_at(in.shapes, c_, posed_a(found), posed_b(found), found.normal, margin);
    }

  private:
    PosedBody posed_a(const Nearness& found) const {
        return posed_at(in.bodies, in.shapes, c_.shape_a, a_, from_a_, found.time);
    }
    PosedBody posed_b(const Nearness& found) const {
        return posed_at(in.bodies, in.shapes, c_.shape_b, b_, from_b_, found.time);
    }
    const NarrowInput& in;
    const ContactInfo& c_;
    const float dt_;
    const ExpectedPath a_, b_;
    const DVec3 from_a_, from_b_; // the positions of the bodies at the start of the step
};

// Whether two shapes are nearest within their paths. If at an end of these, they may touch all the same once A is
// lowered.
bool passes_within(const Nearness& found) { return found.distance > 0 && found.time > 0 && found.time < 1; }

// Converts the separations of a manifold found with A displaced by `lift` to those without the displacement.
void lower(const ContactInfo& c, DVec3 lift, Manifold& m) {
    const math::Vec3 normal = math::to_vec(m.normal);
    const float nearer = math::dot(c.flipped ? -normal : normal, math::to_float(lift));
    for (int i = 0; i < m.count; ++i) m.points[i][3] += nearer;
}

float bounding_radius_of(const Geometry& g) { return is_surface(g.type) ? unlimited_extent : g.bounding_radius; }

} // namespace

double half_width_between(const Shapes& shapes, const ContactInfo& c) {
    return half_width_of(shapes.geometry[c.shape_a], shapes.data[c.shape_a], shapes.geometry[c.shape_b],
                         shapes.data[c.shape_b]);
}

bool moves_far(const NarrowInput& in, const ContactInfo& c, const Manifold& m, float dt) {
    if (c.is_trigger || m.count == 0) return false;
    bool any_led = false;
    float turn = 0, unknown = 0; // rad/s: of both bodies; of those whose rotation moves their surfaces
    for (const std::int32_t b : {c.body_a, c.body_b}) {
        any_led = any_led || has_joints(in.bodies, b);
        const float own = math::length(in.bodies.motion[b].w);
        turn += own;
        if (!turns_on_the_spot(in.bodies.links[b])) unknown += own;
    }
    if (unknown * dt > half_turn) return false;
    const std::int32_t first = c.flipped ? c.body_b : c.body_a, second = c.flipped ? c.body_a : c.body_b;
    const BodyMotion &a = in.bodies.motion[first], &b = in.bodies.motion[second];
    const math::Vec3 n = math::to_vec(m.normal), center = in.shapes.links[c.flipped ? c.shape_b : c.shape_a].arm;
    const math::Vec3 d = math::to_float(a.x - b.x);
    const float horizon = looked_at(in, dt);
    const float size =
        std::min(in.shapes.geometry[c.shape_a].bounding_radius, bounding_radius_of(in.shapes.geometry[c.shape_b]));
    for (int i = 0; i < m.count; ++i) {
        const float separation = m.points[i][3];
        if (separation <= 0) return false;
        const math::Vec3 arm = center + math::to_vec(m.points[i]);
        const math::Vec3 v = (b.v + math::cross(b.w, arm + d)) - (a.v + math::cross(a.w, arm));
        const float closing = -math::dot(n, v);
        if (!(closing * horizon > separation)) continue;
        const float time = separation / closing;
        // Sliding up to the tolerance for touching is allowed before the touch: a face may end farther on.
        const float speed = math::length(v + closing * n) + turn * size;
        if (any_led && horizon * speed <= c.base_margin) continue;
        if (time * speed > float(touch_tolerance(half_width_between(in.shapes, c)))) return true;
    }
    return false;
}

Approach find_touch(const NarrowInput& in, const ContactInfo& c, DVec3 axis, float pass, float margin, Touch& touch) {
    const ExpectedWays ways(in, c, looked_at(in, pass));
    const Nearness found = nearness_of(ways.of_a(), ways.of_b(), double(c.base_margin), axis);
    const Approach approach = ways.take(found, touch);
    if (approach == Approach::later && !touch.is_beside) touch.manifold = ways.manifold_at_touch(found, margin);
    return approach;
}

Approach find_lifted_touch(const NarrowInput& in, const ContactInfo& c, DVec3 lift, DVec3 axis, float pass,
                           float margin, Touch& touch) {
    const ExpectedWays ways(in, c, looked_at(in, pass), lift);
    const Nearness found = nearness_of(ways.of_a(), ways.of_b(), double(c.base_margin), axis);
    const Approach approach = ways.take(found, touch);
    if (approach == Approach::passes) return approach;
    if (!passes_within(found)) touch.manifold = ways.manifold_at_touch(found, margin);
    lower(c, lift, touch.manifold);
    return approach;
}

Approach find_lifted_touch(const NarrowInput& in, const ContactInfo& group, DVec3 lift, float pass, float margin,
                           NarrowBatch& own, Touch& touch) {
    const ExpectedWays ways(in, group, looked_at(in, pass), lift);
    const PosedShape a = posed_shape(in.shapes, group.shape_a), b = posed_shape(in.shapes, group.shape_b);
    ShapePose lifted = a.pose;
    for (int i = 0; i < 3; ++i) lifted.low[i] += float(lift[i]);
    find_patches({a.geometry, a.data, lifted, a.arm}, b, margin, margin, own.surface, own.hits);
    own.triangles.clear();
    for (const TriangleHit& hit : own.surface.hits) own.triangles.push_back(hit.triangle);
    if (own.triangles.empty()) return Approach::passes;
    const std::span<const std::uint32_t> triangles = own.triangles;
    const Nearness found = nearness_of(ways.of_a(), ways.of_b(), triangles, double(group.base_margin));
    const Approach approach = ways.take(found, touch);
    if (approach == Approach::passes) return approach;
    if (!passes_within(found)) {
        find_patches({a.geometry, a.data, touch.pose_a, touch.arm_a}, {b.geometry, b.data, touch.pose_b, b.arm}, margin,
                     margin, own.surface, own.hits);
        if (own.hits.empty()) return Approach::passes;
        touch.manifold = own.hits.front(); // the deepest one
    }
    lower(group, lift, touch.manifold);
    return approach;
}

Approach find_touch(const NarrowInput& in, const ContactInfo& group, std::span<const std::uint32_t> triangles,
                    float pass, Touch& touch) {
    const ExpectedWays ways(in, group, looked_at(in, pass));
    return ways.take(nearness_of(ways.of_a(), ways.of_b(), triangles, double(group.base_margin)), touch);
}

std::uint8_t take_test(const NarrowInput& in, Contacts& contacts, const NarrowScratch& narrow, std::uint32_t id,
                       const Manifold& m, float dt) {
    const ContactInfo& c = contacts.info[id];
    if (!moves_far(in, c, m, dt)) return take_manifold(in.bodies, in.shapes, contacts, in.islands, id, m);
    Touch touch;
    const DVec3 n = math::to_double(math::to_vec(m.normal));
    const Approach approach = find_touch(in, c, c.flipped ? -n : n, dt, contact_margin(narrow, c, dt), touch);
    if (approach == Approach::now) return take_manifold(in.bodies, in.shapes, contacts, in.islands, id, m);
    if (approach == Approach::passes) return take_distance(in.bodies, contacts, id, 0);
    return take_manifold(in.bodies, in.shapes, contacts, in.islands, id, touch.manifold, &touch);
}

} // namespace cairn
