#include "contacts/touch.h"

#include "bodies/bodies.h"
#include "bodies/integrators.h"
#include "collision/core_sweep.h"
#include "contacts/convex_tests.h"
#include "contacts/pairs.h"
#include "math/rotation.h"

namespace cairn {

using math::DQuat;
using math::DVec3;

namespace {

constexpr float half_turn = 3.1f; // rad in a step: beyond, two poses do not tell how a body turned

// As velocities and forces say, which act in substeps: nearly as all the time.
RigidPath expected_path(const State& s, std::int32_t b, float dt) {
    const BodyMotion& m = s.motion[b];
    if (s.body_settings[b].type == BodyType::static_ || (s.is_dynamic(b) && !s.is_awake(b)))
        return RigidPath::between(m.x, m.q, m.x, m.q);
    const double t = double(dt);
    DVec3 way = t * math::to_double(m.v);
    if (s.is_dynamic(b)) {
        const double inverse_mass = double(s.mass[b].inverse_mass);
        DVec3 a = field_acceleration(s, m.x, s.body_settings[b].gravity_scale, inverse_mass);
        if (s.is_pushed(b)) a += inverse_mass * s.forces[b].force;
        way += (0.5 * t * t) * a;
    }
    return RigidPath::between(m.x, m.q, m.x + way, math::from_rotation_vector(t * math::to_double(m.w)) * m.q);
}

SweptShape swept(const State& s, std::uint32_t shape, const RigidPath& path) {
    const Geometry& g = s.geometry[shape];
    return {g, s.shape_data[shape], math::to_double(g.position - s.mass[s.shapes[shape].body].center), path};
}

struct PosedBody {
    DVec3 moved;
    DQuat turned;
    math::Vec3 arm;
    ShapePose pose;
};
PosedBody posed_at(const State& s, std::uint32_t shape, const RigidPath& path, double time) {
    const RigidPath::Pose body = path.at(time);
    const Geometry& g = s.geometry[shape];
    const math::Quat q = math::to_float(body.q);
    PosedBody p{body.x - path.start, body.q * math::conjugate(path.rotation), {}, s.shape_poses[shape]};
    p.arm = math::rotate(q, g.position - s.mass[s.shapes[shape].body].center);
    pose_shape(p.pose, g, body.x + math::to_double(p.arm), q);
    return p;
}

} // namespace

bool moves_far(const State& s, const ContactInfo& c, const Manifold& m, float dt) {
    if (c.is_trigger || m.count == 0) return false;
    for (int i = 0; i < m.count; ++i)
        if (m.points[i][3] <= 0) return false;
    float turns = 0;
    for (const std::int32_t b : {c.body_a, c.body_b}) {
        if (s.bodies[b].first_joint != none) return false;
        const float turn = dt * math::length(s.motion[b].w);
        if (turn > half_turn) return false;
        turns += turn * s.bodies[b].radius;
    }
    return dt * math::length(s.motion[c.body_b].v - s.motion[c.body_a].v) + turns > c.base_margin;
}

Approach find_touch(const State& s, const ContactInfo& c, float dt, Touch& touch) {
    const RigidPath a = expected_path(s, c.body_a, dt), b = expected_path(s, c.body_b, dt);
    const double time = time_of_touch(swept(s, c.shape_a, a), swept(s, c.shape_b, b));
    if (!(time <= 1)) return Approach::passes;
    if (!(time > 0)) return Approach::touches_now;
    const PosedBody at_a = posed_at(s, c.shape_a, a, time), at_b = posed_at(s, c.shape_b, b, time);
    touch = {dt * float(time), at_a.pose,  at_b.pose,   at_a.arm,   at_b.arm,
             at_a.moved,       at_b.moved, at_a.turned, at_b.turned};
    return Approach::touches_later;
}

Manifold manifold_at(const State& s, const ContactInfo& c, const Touch& touch) {
    if (int(c.kind) < wide_kinds) {
        const ShapePose poses[2] = {c.flipped ? touch.pose_b : touch.pose_a, c.flipped ? touch.pose_a : touch.pose_b};
        std::uint32_t first[8], second[8], features[8];
        float margins[8];
        for (int i = 0; i < 8; ++i) first[i] = 0, second[i] = 1, margins[i] = c.base_margin, features[i] = no_features;
        Manifold manifolds[8];
        wide_kernel(c.kind)(poses, first, second, margins, features, 8, manifolds);
        return manifolds[0];
    }
    const PosedShape a{s.geometry[c.shape_a], s.shape_data[c.shape_a], touch.pose_a, touch.arm_a};
    const PosedShape b{s.geometry[c.shape_b], s.shape_data[c.shape_b], touch.pose_b, touch.arm_b};
    ContactMemory memory = nothing_met;
    return test_convex_pair(c.kind, a, b, {}, c.base_margin, memory);
}

} // namespace cairn
