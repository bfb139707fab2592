#include "impacts/movers.h"

#include "bodies/bodies.h"
#include "bodies/finalize.h"
#include "bodies/free_body.h"
#include "bodies/integrators.h"
#include "bodies/motion_budget.h"
#include "state/substeps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cairn {

using math::dot;
using math::DQuat;
using math::DVec3;
using math::to_double;

namespace {

// The pose of a body at the start of the step.
CountedPose pose_before(const Bodies& bodies, const Islands& islands, std::int32_t b) {
    if (bodies.settings[b].type == BodyType::kinematic || is_awake(bodies, islands, b)) return bodies.counted[b];
    return {bodies.motion[b].x, bodies.motion[b].q};
}

// Path velocity minus stored velocity at the end of a substep, in units of substep times acceleration: paths are
// parabolas through the poses (kernels/solve/bounce.cpp).
double path_offset(Integrator integrator) {
    switch (integrator) {
    case Integrator::semi_implicit_euler:
        return 0.5;
    case Integrator::rk4:
        return 0;
    case Integrator::explicit_euler:
        return -0.5;
    }
    return 0;
}

// Limits of one part of a path: `max_turn`, the angle (rad) by which a body rotates, and `max_bend`, the deviation
// (rad) of a tumbling body from the single rotation that leads from the first to the last pose of the part.
constexpr double max_turn = 1, max_bend = 1e-4;
// Shortest part, as a fraction of the step. Of a body that turns over within it, only the inner ball is swept.
constexpr double min_part = 1.0 / 64;

constexpr int movers_per_chunk = 32; // for threads

// Scales v so that its square is `square`; a zero vector is returned as it is.
DVec3 with_square(DVec3 v, double square) {
    const double now = dot(v, v);
    return now > 0 ? std::sqrt(std::max(square, 0.0) / now) * v : v;
}

} // namespace

Movers::Movers(const MoverContext& context, SweepScratch& scratch, float dt)
    : s(context), dt_(dt), place_(scratch.place), movers_(scratch.movers) {
    if (place_.size() < s.bodies.links.size()) place_.resize(s.bodies.links.size(), none);
    movers_.clear();
}
Movers::~Movers() {
    for (const Mover& m : movers_) place_[std::size_t(m.body)] = none;
}

double Movers::offset_of_velocity() const {
    return path_offset(s.settings.integrator) * double(dt_) / substeps_of(s.settings, dt_);
}

int Movers::substeps_in(double duration) const {
    return std::max(int(std::ceil(substeps_of(s.settings, dt_) * duration / double(dt_))), 1);
}

// The spin of a free body follows from its angular momentum, which only torque changes.
DVec3 Movers::spin_later(const Mover& m, DVec3 w, DQuat from, DQuat to, double duration) const {
    if (s.bodies.mass[m.body].isotropic && !s.bodies.is_pushed(m.body)) return w;
    const Spin spin = spin_of(s.bodies.mass[m.body]);
    DVec3 momentum = spin.to_world(from, spin.moments, w);
    if (s.bodies.is_pushed(m.body)) momentum += duration * s.bodies.forces[m.body].torque;
    return spin.to_world(to, spin.inverse_moments, momentum);
}

namespace {

// The axis through the center of mass, in the body's frame, about which all shapes of a body are round.
std::optional<math::Vec3> axis_of_symmetry(const Bodies& bodies, const Shapes& shapes, std::int32_t b) {
    constexpr float sine = 1e-3f; // greatest sine of the angle between axes that count as parallel
    std::optional<math::Vec3> axis;
    for (std::int32_t s = bodies.links[b].first_shape; s != none; s = shapes.links[s].next) {
        const Geometry& g = shapes.geometry[s];
        const math::Vec3 place = g.position - bodies.mass[b].center;
        const auto lies_along = [&](math::Vec3 line, float length) {
            return axis && math::length(math::cross(*axis, line)) <= sine * length;
        };
        if (g.type == ShapeType::capsule || g.type == ShapeType::cylinder) {
            const math::Vec3 own = math::rotate(g.rotation, math::Vec3{0, 1, 0});
            if (!axis) axis = own;
            if (!lies_along(own, 1)) return std::nullopt;
        } else if (g.type != ShapeType::sphere) {
            return std::nullopt;
        }
        const float away = math::length(place);
        if (!axis && away > sine * g.bounding_radius) axis = (1 / away) * place;
        if (axis && !lies_along(place, g.bounding_radius)) return std::nullopt;
    }
    return axis;
}

} // namespace

std::optional<DQuat> Movers::end_of_turn(std::int32_t b, DQuat from, DQuat to, DVec3 w, double duration) const {
    if (is_round(b) || math::length(w) * duration <= double(half_turn)) return to;
    const std::optional<math::Vec3> axis = axis_of_symmetry(s.bodies, s.shapes, b);
    if (!axis) return std::nullopt;
    const DVec3 u0 = math::rotate(from, to_double(*axis)), u1 = math::rotate(to, to_double(*axis));
    if (math::length(w - dot(w, u0) * u0) * duration > double(half_turn) || !(dot(u0, u1) > -0.99)) return std::nullopt;
    const DVec3 v = math::cross(u0, u1);
    return math::normalized(DQuat{v.x, v.y, v.z, 1 + dot(u0, u1)}) * from;
}

bool Movers::is_round(std::int32_t b) const {
    const BodyLinks& links = s.bodies.links[b];
    return s.bodies.mass[b].isotropic && links.joint_count == 0 && !(links.radius > links.inner_radius);
}

// Greatest duration (s) of one part of a free body's path for which its two poses determine its rotation.
double Movers::longest_part(std::int32_t b, DVec3 w, DQuat q) const {
    if (is_round(b)) return std::numeric_limits<double>::infinity();
    const double speed = math::length(w);
    double part = speed > 0 ? max_turn / speed : std::numeric_limits<double>::infinity();
    if (const double rate = math::length(spin_change(s.bodies, b, w, q)); rate > 0)
        part = std::min(part, std::sqrt(8 * max_bend / rate));
    return part;
}

// Greatest duration (s) of a chord that deviates from its parabola by less than the depth of a core.
double Movers::longest_chord(const Mover& m) const {
    const double pull = math::length(m.acceleration);
    const double depth = core_depth_of(double(s.bodies.links[m.body].inner_radius));
    return pull > 0 ? std::sqrt(8 * depth / pull) : std::numeric_limits<double>::infinity();
}

std::int32_t Movers::add(std::int32_t b) {
    if (of_body(b) != none) return of_body(b);
    const std::int32_t i = append(b);
    set_out(i);
    return i;
}

void Movers::add(std::span<const std::int32_t> bodies, ThreadPool& thread_pool) {
    const std::int32_t first = count();
    for (const std::int32_t b : bodies)
        if (of_body(b) == none) append(b);
    thread_pool.for_chunks(count() - first, movers_per_chunk, [&](int from, int to, int) {
        for (std::int32_t i = first + from; i < first + to; ++i) set_out(i);
    });
}

std::int32_t Movers::append(std::int32_t b) {
    const std::int32_t i = count();
    place_[std::size_t(b)] = i;
    movers_.emplace_back().body = b;
    return i;
}

// Zero if the body would have exceeded the world's greatest speed: its speed was clamped, and is nearly constant.
DVec3 Movers::acceleration_on(const RigidPath& path, std::int32_t b) const {
    const DVec3 a = acceleration_at(s.bodies, s.fields, s.settings, b, path.start);
    const DVec3 mean = (1 / double(dt_)) * path.translation, change = (0.5 * double(dt_)) * a;
    const double most = 1.001 * double(s.settings.max_linear_speed);
    return math::length(mean - change) <= most && math::length(mean + change) <= most ? a : DVec3{};
}

// Initializes a mover from the poses that the solver has given the body.
void Movers::set_out(std::int32_t i) {
    Mover& m = (*this)[i];
    const std::int32_t b = m.body;
    const CountedPose from = pose_before(s.bodies, s.islands, b);
    const BodyMotion& to = s.bodies.motion[b];
    const BodyLinks& links = s.bodies.links[b];
    m.is_free = links.contact_count + links.joint_count == 0;
    const std::optional<DQuat> end = m.is_free ? to.q : end_of_turn(b, from.q, to.q, to_double(to.w), double(dt_));
    const bool flies_anew = !end && links.joint_count == 0;
    m.turns_over = !end && !flies_anew;
    m.path = RigidPath::between(from.x, from.q, to.x, end.value_or(m.turns_over ? from.q : to.q));
    if (is_awake(s.bodies, s.islands, b)) m.acceleration = acceleration_on(m.path, b);
    // A free body has started at this velocity, which follows from the mean velocity and the change along the path.
    m.velocity = (1 / double(dt_)) * m.path.translation - (0.5 * double(dt_)) * m.acceleration;
    m.spin = spin_later(m, to_double(to.w) + to_double(to.w_rest), to.q, from.q, -double(dt_));
    if (links.joint_count > 0 && !m.turns_over) follow_joint_screw(m, from, to);
    if (m.is_guided) advance_along_arc(i, 0);
    m.gyrates = m.is_free && gyrates(s.bodies, b, m.spin, from.q, double(dt_));
    if (flies_anew) {
        // The poses do not determine how the solver has rotated the body: it moves freely from its first pose, at the
        // velocities that the solver gave it.
        m.is_free = m.is_redirected = true;
        const DVec3 v = to_double(to.v) + to_double(to.v_rest), w = to_double(to.w) + to_double(to.w_rest);
        redirect(i, 0, {from.x, from.q, v - double(dt_) * m.acceleration, w});
    } else if (m.is_free && longest_part(b, m.spin, from.q) < double(dt_)) {
        redirect(i, 0, {from.x, from.q, m.velocity, m.spin});
    }
}

void Movers::follow_parabola(std::int32_t i) {
    const Mover& m = (*this)[i];
    if (!m.is_free || m.is_redirected || m.path.until < 1 || !(longest_chord(m) < double(dt_))) return;
    redirect(i, 0, {m.path.first().x, m.path.rotation, m.velocity, m.spin});
}

// Joints rotate a body about the axis of the screw motion that leads from its first to its last pose (Chasles): an
// imaginary body on that axis guides it. Where the arc deviates from a straight line by less than the depth of a core,
// the path stays straight.
void Movers::follow_joint_screw(Mover& m, const CountedPose& from, const BodyMotion& to) const {
    const DQuat by = RigidPath::between(from.x, from.q, to.x, to.q).by;
    const DVec3 displacement = to.x - from.x;
    const double sine = math::length(by.vector()); // of half the angle
    if (!(sine > 0)) return;
    const DVec3 axis = (1 / sine) * by.vector(), slide = dot(displacement, axis) * axis, across = displacement - slide;
    if (!(math::length(across) * sine > 4 * core_depth_of(double(s.bodies.links[m.body].inner_radius)))) return;
    const DVec3 pivot = from.x + 0.5 * (across + (by.w / sine) * math::cross(axis, across));
    m.is_guided = true;
    m.lead = RigidPath::between(pivot, from.q, pivot + slide, to.q);
    m.arm = math::rotate(math::conjugate(from.q), from.x - pivot);
    m.turned = {0, 0, 0, 1};
}

void Movers::carry(std::int32_t i, double time, std::int32_t carrier, DVec3 axis) {
    Mover& m = (*this)[i];
    const MovingState now = state_at(i, time);
    m.is_guided = m.is_changed = true;
    m.carrier = carrier;
    m.lead = path_of(carrier);
    const RigidPath::Pose there = m.lead.at(time);
    m.arm = math::rotate(math::conjugate(there.q), now.x - there.x);
    m.turned = math::conjugate(there.q) * now.q;
    const RigidPath::Pose end = m.lead.at(1);
    BodyMotion& motion = s.bodies.motion[m.body];
    const BodyMotion& by = s.bodies.motion[carrier];
    const DVec3 arm = math::rotate(end.q, m.arm), w = to_double(by.w);
    motion.x = end.x + arm;
    motion.q = math::normalized(end.q * m.turned);
    DVec3 slide = now.v - to_double(by.v) - math::cross(w, now.x - there.x);
    if (const double square = dot(axis, axis); square > 0) slide = slide - (dot(slide, axis) / square) * axis;
    slide = math::rotate(end.q * math::conjugate(there.q), slide);
    motion.v = math::to_float(to_double(by.v) + math::cross(w, arm) + slide);
    motion.w = math::to_float(now.w);
    motion.v_rest = motion.w_rest = {};
    advance_along_arc(i, time);
}

// Advances along the arc in straight parts that deviate from it by less than the depth of a core. Their number is
// limited to that of arcs that occur in a step of usual length.
void Movers::advance_along_arc(std::int32_t i, double time) {
    Mover& m = (*this)[i];
    const double depth = core_depth_of(double(s.bodies.links[m.body].inner_radius));
    const double bend = dot(m.lead.turn, m.lead.turn) * math::length(m.arm); // m, per square of the time
    const double part = bend > 0 ? std::max(std::sqrt(8 * depth / bend), min_part / 16) : 1;
    const double until = std::min(time + part, 1.0);
    const auto pose_at = [&](double at) {
        const RigidPath::Pose there = m.lead.at(at);
        return RigidPath::Pose{there.x + math::rotate(there.q, m.arm), math::normalized(there.q * m.turned)};
    };
    const RigidPath::Pose first = pose_at(time), last = pose_at(until);
    m.path = RigidPath::between(first.x, first.q, last.x, last.q, time, until);
}

RigidPath Movers::path_of(std::int32_t b) const {
    const CountedPose from = pose_before(s.bodies, s.islands, b);
    const BodyMotion& to = s.bodies.motion[b];
    return RigidPath::between(from.x, from.q, to.x, to.q);
}

MovingState Movers::state_at(std::int32_t i, double time) const {
    const Mover& m = (*this)[i];
    const BodyMotion& end = s.bodies.motion[m.body];
    const RigidPath::Pose pose = m.path.at(std::min(time, m.until));
    MovingState now{pose.x, pose.q, {}, {}};
    if (m.carrier != none) {
        const BodyMotion& by = s.bodies.motion[m.carrier];
        now.w = to_double(by.w);
        now.v = to_double(by.v) + math::cross(now.w, pose.x - m.lead.at(time).x);
        return now;
    }
    if (!m.is_free) {
        const DVec3 end_v = to_double(end.v) + to_double(end.v_rest);
        // Kinetic energy at the end less the work of forces along the remaining path; it is never increased by that.
        const double square = dot(end_v, end_v), left = square - 2 * dot(m.acceleration, end.x - pose.x);
        now.v = with_square(end_v, std::min(left, square));
        now.w = to_double(end.w) + to_double(end.w_rest);
        return now;
    }
    const RigidPath::Pose first = m.path.first();
    const double passed = (time - m.path.begin) * double(dt_), left = (m.path.until - time) * double(dt_);
    // The path is the chord of a parabola. A gyrating body is placed on the parabola itself; its parts are so short
    // that it touches at the same place.
    if (m.gyrates) now.x = pose.x - (0.5 * passed * left) * m.acceleration;
    now.v = with_square(m.velocity + passed * m.acceleration,
                        dot(m.velocity, m.velocity) + 2 * dot(m.acceleration, now.x - first.x));
    if (left <= 0 && !m.turns_over) { // fly has moved it to this pose
        now.q = end.q, now.w = to_double(end.w) + to_double(end.w_rest);
        return now;
    }
    now.q = first.q, now.w = m.spin;
    if (passed > 0) turn_free_body(s.bodies, s.fields, s.settings, m.body, passed, substeps_in(passed), now.q, now.w);
    return now;
}

// Moves the body by the integrator of free bodies.
void Movers::fly(const Mover& m, const MovingState& from, double duration) const {
    BodyMotion& motion = s.bodies.motion[m.body];
    const DVec3 real = acceleration_at(s.bodies, s.fields, s.settings, m.body, from.x);
    // Substeps of the integrator are shorter here; stored and path velocities differ by a fraction of a substep's
    // change.
    const int substeps = substeps_in(duration);
    const double shorter = path_offset(s.settings.integrator) * duration / substeps;
    const DVec3 stored = from.v - shorter * real;
    motion.x = from.x, motion.q = from.q;
    motion.v = math::to_float(stored), motion.v_rest = math::to_float(stored - to_double(motion.v));
    motion.w = math::to_float(from.w), motion.w_rest = math::to_float(from.w - to_double(motion.w));
    if (duration > 0) note_clamped(move_free_body(s.bodies, s.fields, s.settings, m.body, float(duration), substeps));
    // The bodies beneath carry a part of that acceleration. If the integrator has clamped the speed, the two do not add
    // up.
    const DVec3 borne = m.acceleration - real;
    DVec3 path_end = to_double(motion.v) + to_double(motion.v_rest) + duration * borne + shorter * real;
    if (math::length(real) * duration <= double(s.settings.max_linear_speed)) {
        motion.x += (0.5 * duration * duration) * borne;
    } else {
        motion.x = from.x + duration * from.v + (0.5 * duration * duration) * m.acceleration;
        path_end = from.v + duration * m.acceleration;
    }
    const DVec3 end = path_end - offset_of_velocity() * m.acceleration;
    motion.v = math::to_float(end), motion.v_rest = math::to_float(end - to_double(motion.v));
    keep_in_range(m.body, from, duration);
}

// Limits the motion to the world's greatest speeds; a body whose values are not finite stays where it was.
void Movers::keep_in_range(std::int32_t b, const MovingState& from, double duration) const {
    BodyMotion& motion = s.bodies.motion[b];
    const bool is_finite = math::is_finite(motion.x) && math::is_finite(motion.q) && math::is_finite(motion.v) &&
                           math::is_finite(motion.w);
    if (!is_finite) {
        motion.x = from.x, motion.q = from.q;
        motion.v = motion.w = {};
    }
    const DVec3 displacement = motion.x - from.x;
    const double most = double(s.settings.max_linear_speed) * duration, square = dot(displacement, displacement);
    const bool is_far = square > most * most;
    if (is_far) motion.x = from.x + (most / std::sqrt(square)) * displacement;
    const bool was_cut = clamp_velocity(s.settings, motion.v, motion.w);
    if (!is_finite || is_far || was_cut) motion.v_rest = motion.w_rest = {}, note_clamped(1);
}

void Movers::redirect(std::int32_t i, double time, const MovingState& now) {
    Mover& m = (*this)[i];
    BodyMotion& motion = s.bodies.motion[m.body];
    const double left = (1 - time) * double(dt_);
    double until = 1;
    if (m.is_free) {
        const double longest = std::min(longest_part(m.body, now.w, now.q), longest_chord(m));
        const double part = std::max(longest / double(dt_), min_part);
        until = std::min(time + part, 1.0);
        fly(m, now, (until - time) * double(dt_));
        m.velocity = now.v, m.spin = now.w;
    } else if (m.is_guided) { // it leaves its arc
        motion.x = now.x + left * now.v;
        motion.q = turned_by(left * now.w, now.q);
        motion.v = math::to_float(now.v), motion.w = math::to_float(now.w);
        motion.v_rest = motion.w_rest = {};
        keep_in_range(m.body, now, left);
    } else {
        const MovingState before = state_at(i, time);
        const DVec3 dv = now.v - before.v, dw = now.w - before.w;
        motion.v = math::to_float(to_double(motion.v) + dv), motion.w = math::to_float(to_double(motion.w) + dw);
        motion.v_rest = motion.w_rest = {};
        push_end(m.body, now, left, dv, dw);
    }
    m.is_guided = false;
    m.carrier = none;
    lead_to_end(m, now, time, until);
}

// Changes the pose in which a body that the solver has moved ends the step.
void Movers::push_end(std::int32_t b, const MovingState& now, double left, DVec3 dv, DVec3 dw) const {
    BodyMotion& motion = s.bodies.motion[b];
    motion.x += left * dv;
    motion.q = turned_by(left * dw, motion.q);
    keep_in_range(b, now, left);
}

void Movers::lead_to_end(Mover& m, const MovingState& now, double time, double until) const {
    const BodyMotion& motion = s.bodies.motion[m.body];
    const std::optional<DQuat> end =
        end_of_turn(m.body, now.q, motion.q, to_double(motion.w), (until - time) * double(dt_));
    m.turns_over = !end;
    m.path = RigidPath::between(now.x, now.q, motion.x, end.value_or(now.q), time, until);
    m.is_changed = true;
}

void Movers::push_path(std::int32_t i, double time, DVec3 dv, DVec3 dw, bool and_velocity) {
    Mover& m = (*this)[i];
    MovingState now = state_at(i, time);
    if (m.is_free || m.is_guided) {
        now.v += dv, now.w += dw;
        return redirect(i, time, now);
    }
    BodyMotion& motion = s.bodies.motion[m.body];
    if (and_velocity) motion.v += math::to_float(dv), motion.w += math::to_float(dw);
    push_end(m.body, now, (1 - time) * double(dt_), dv, dw);
    lead_to_end(m, now, time, 1);
}

bool Movers::go_straight(std::int32_t i, double time, DVec3 velocity) {
    Mover& m = (*this)[i];
    const MovingState now = state_at(i, time);
    const double left = (1 - time) * double(dt_);
    BodyMotion& motion = s.bodies.motion[m.body];
    if (m.is_free) fly(m, now, left);
    const DVec3 v = to_double(motion.v) + to_double(motion.v_rest), end = now.x + left * velocity;
    const DVec3 slower = with_square(v, dot(v, v) + 2 * std::min(dot(m.acceleration, end - motion.x), 0.0));
    motion.v = math::to_float(slower), motion.v_rest = math::to_float(slower - to_double(motion.v));
    motion.x = end, motion.q = now.q;
    m.path = RigidPath::between(now.x, now.q, end, now.q, time, 1);
    m.is_free = m.gyrates = m.is_guided = m.turns_over = false;
    m.is_changed = true;
    return std::exchange(m.is_straight, true);
}

void Movers::go_on_freely(std::int32_t i, const MovingState& now, DVec3& pull, DVec3& turning) const {
    const Mover& m = (*this)[i];
    if (!m.is_free) return;
    pull = m.acceleration;
    turning = spin_change(s.bodies, m.body, now.w, now.q);
}

DVec3 Movers::arm_of(std::uint32_t shape, DQuat q) const {
    return math::rotate(
        q, to_double(s.shapes.geometry[shape].position - s.bodies.mass[s.shapes.links[shape].body].center));
}

void Movers::rest_on(std::int32_t i, DVec3 down) {
    Mover& m = (*this)[i];
    if (m.gyrates) return; // it stays pressed down, with friction
    m.acceleration = m.acceleration - std::max(dot(m.acceleration, down), 0.0) * down;
}

// Bounds of a path to the end of the step, even where the present part of a free body's path ends before.
DBounds Movers::swept_bounds(const Mover& m, double from) const {
    const DVec3 start = m.path.at(from).x, left = (m.path.until - from) * m.path.translation;
    const double later = (1 - m.path.until) * double(dt_);
    DVec3 end = start + left;
    double r = double(s.bodies.links[m.body].radius);
    if (m.is_guided) {
        end = s.bodies.motion[m.body].x;
        r += m.lead.sagitta(math::length(m.arm));
    } else if (later > 0) {
        const BodyMotion& motion = s.bodies.motion[m.body];
        end += later * (to_double(motion.v) + (offset_of_velocity() + 0.5 * later) * m.acceleration);
    }
    DBounds bounds;
    for (int k = 0; k < 3; ++k)
        bounds.lo[k] = std::min(start[k], end[k]) - r, bounds.hi[k] = std::max(start[k], end[k]) + r;
    return bounds;
}

void Movers::write_final_poses(std::int32_t i) {
    const Mover& m = (*this)[i];
    BodyMotion& motion = s.bodies.motion[m.body];
    if (m.has_stopped()) {
        const MovingState then = state_at(i, m.until);
        const DVec3 v = to_double(motion.v);
        const double square = dot(v, v), left = square - 2 * dot(m.acceleration, motion.x - then.x);
        motion.v = math::to_float(with_square(v, std::min(left, square))); // no gain in speed: it was pushed
        motion.x = then.x;
        if (!m.turns_over) {
            motion.q = then.q;
            motion.w = math::to_float(then.w), motion.w_rest = math::to_float(then.w - to_double(motion.w));
        }
    }
    motion.turned = math::to_float(motion.q * math::conjugate(pose_before(s.bodies, s.islands, m.body).q));
    if (m.impacts > 0) s.bodies.links[m.body].quiet_time = 0;
    spend_budget(s.bodies, m.body); // its contacts were stored for the solver's pose
    place_again(s.bodies, s.shapes, s.broad_phase, m.body, dt_);
}

std::size_t Movers::write_final_poses() {
    std::size_t stopped = 0;
    for (std::int32_t i = 0; i < count(); ++i) {
        stopped += (*this)[i].has_stopped();
        if (is_put_back((*this)[i])) write_final_poses(i);
    }
    return stopped;
}

} // namespace cairn
