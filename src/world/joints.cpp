// Joints: making, changing, reading and removing them. Every argument is checked before anything changes.
#include "joints/joints.h"
#include "bodies/bodies.h"
#include "islands/islands.h"
#include "joints/joint_positions.h"
#include "state/joint_links.h"

#include "world/impl.h"
#include "world/joint_rules.h"
#include "world/validate.h"

#include <algorithm>
#include <iterator>

namespace cairn {

namespace {

void fill_frames(JointInfo& info, const JointDef& def) {
    auto rotation = [](const Quat& q) { return math::normalized(math::to_double(to_math(q))); };
    info.anchor_a = to_math(def.frame_a.position);
    info.anchor_b = to_math(def.frame_b.position);
    info.frame_a = rotation(def.frame_a.rotation);
    info.frame_b = rotation(def.frame_b.rotation);
    if (const auto* servo = std::get_if<ServoJoint>(&def.joint)) { // its target pose is folded into frame A
        info.anchor_a += math::rotate(info.frame_a, math::to_double(to_math(servo->position)));
        info.frame_a = math::normalized(info.frame_a * rotation(servo->rotation));
    }
    if (const auto* pulley = std::get_if<PulleyJoint>(&def.joint)) {
        info.ground_a = to_math(pulley->ground_a);
        info.ground_b = to_math(pulley->ground_b);
    }
}

math::DVec3 anchor_in_world(const Bodies& bodies, std::int32_t body, math::DVec3 anchor) {
    if (body == none) return anchor;
    const BodyMotion& motion = bodies.motion[body];
    return motion.x + math::rotate(motion.q, anchor - math::to_double(bodies.mass[body].center));
}

float pulley_length(const Bodies& bodies, const JointInfo& info, const Joint& joint) {
    const auto* pulley = std::get_if<PulleyJoint>(&joint);
    if (!pulley) return 0;
    const double a = math::length(anchor_in_world(bodies, info.body_a, info.anchor_a) - info.ground_a);
    const double b = math::length(anchor_in_world(bodies, info.body_b, info.anchor_b) - info.ground_b);
    return float(a + double(pulley->ratio) * b);
}

// Pairs of shapes of these two bodies are filtered again at the next step.
void refilter_pairs(const Bodies& bodies, const Shapes& shapes, BroadPhase& broad_phase, const JointInfo& info) {
    if (!info.enabled || info.enable_collision || info.body_a == none || info.body_b == none) return;
    for (std::int32_t i = bodies.links[info.body_a].first_shape; i != none; i = shapes.links[i].next)
        broad_phase.refilter(std::uint32_t(i));
}

void forget_impulses(JointInfo& info, JointAxes& axes) {
    info.substep_time = 0;
    info.point_impulse = info.turn_impulse = {};
    for (JointAxisState& axis : axes.states) axis = {};
}

// If the kinds of the constraint rows change, their impulses are reset.
void set_rules(const Bodies& bodies, Joints& joints, std::uint32_t index, const JointRules& rules) {
    JointInfo& info = joints.info[index];
    JointAxes& axes = joints.axes[index];
    const JointLocks& locks = rules.locks;
    bool same =
        info.rules.point == locks.point && info.rules.turn == locks.turn && info.rules.axis_count == locks.axis_count;
    for (int i = 0; same && i < locks.axis_count; ++i) same = axes.rules[i].kind == rules.axes[i].kind;
    info.rules = locks;
    std::copy(std::begin(rules.axes), std::end(rules.axes), axes.rules);
    ++joints.changes;
    if (!same) forget_impulses(info, axes);
    if (locks.turn == JointLock::none && locks.axis_count == 0) info.torque = {}; // no row measures the torque then
    for (int i = 0; i < locks.axis_count; ++i) { // impulses of removed rows must not act in a warm start
        JointAxisState& axis = axes.states[i];
        if (!rules.axes[i].has_limits) axis.lower = axis.upper = 0;
        if (!rules.axes[i].has_drive) axis.drive = 0;
        if (!(rules.axes[i].friction > 0)) axis.friction = 0;
    }
    const JointPositions positions = joint_positions(bodies, joints, index);
    for (int i = 0; i < locks.axis_count; ++i) axes.states[i].position = positions.axes[i], axes.states[i].is_idle = 0;
}

// Stores the rope length measured at creation in the definition too, so that changes of the joint and saved files keep
// it.
void keep_pulley_length(Joint& joint, float length) {
    auto* pulley = std::get_if<PulleyJoint>(&joint);
    if (pulley && !pulley->length && length > 0) pulley->length = length;
}

math::DQuat turn_from_x(math::DVec3 axis) {
    if (axis.x < -0.999999) return {0, 0, 1, 0};
    return math::normalized(math::DQuat{0, -axis.z, axis.y, 1 + axis.x});
}

} // namespace

void World::Impl::retire_joint(std::uint32_t index, const std::optional<JointEvent>& event) {
    State& s = state;
    are_definitions_known = false; // needed here because joints also break within a step
    refilter_pairs(s.bodies, s.shapes, s.broad_phase, s.joints.info[index]);
    deactivate_joint(s.bodies, s.islands, s.joints, s.events, index);
    unlink_joint(s.bodies, s.joints, index);
    if (event) s.events.joints.next.push_back(*event);
    s.joints.info[index] = {};
    joint_defs[index] = {};
    s.joints.slots.kill(index);
    s.joints.slots.recycle(index);
}

JointEvent World::Impl::joint_event(std::uint32_t index, bool broke) const {
    const JointInfo& info = state.joints.info[index];
    const JointDef& def = joint_defs[index];
    JointEvent event{state.joints.slots.id(index), def.body_a, def.body_b, broke, 0, 0, def.user_data};
    if (broke) event.force = math::length(info.force), event.torque = math::length(info.torque);
    return event;
}

void World::Impl::retire_joints_of(std::int32_t body) {
    std::vector<std::uint32_t> joints;
    for_each_joint(state.bodies, state.joints, body, [&](std::uint32_t joint, int) { joints.push_back(joint); });
    for (const std::uint32_t joint : joints) retire_joint(joint, joint_event(joint, false));
}

void World::Impl::break_joints() {
    for (const std::uint32_t joint : step.solver.overloaded) retire_joint(joint, joint_event(joint, true));
    step.solver.overloaded.clear();
}

JointId World::create_joint(const JointDef& def) {
    Impl::Change change(*impl_, commands::world_create_joint, def);
    State& s = impl_->state;
    JointInfo info;
    if (!def.body_a.is_null()) info.body_a = impl_->index_of(def.body_a);
    if (!def.body_b.is_null()) info.body_b = impl_->index_of(def.body_b);
    if (info.body_a == info.body_b)
        refuse("JointDef.body_b", def.body_b.is_null() ? "null" : "that of body_a", "must be another body than body_a");
    const auto is_dynamic = [&](std::int32_t b) {
        return b != none && s.bodies.settings[b].own_type == BodyType::dynamic;
    };
    if (!is_dynamic(info.body_a) && !is_dynamic(info.body_b))
        throw Error(ErrorCode::wrong_state, "World::create_joint", "", "one of the two bodies must be dynamic");
    validate(def);
    require_slot(s.joints.slots, "World::create_joint");
    JointDef given(def); // `def` may refer to an element of joint_defs, which grows
    given.frame_a.rotation = checked_rotation("JointDef.frame_a.rotation", def.frame_a.rotation);
    given.frame_b.rotation = checked_rotation("JointDef.frame_b.rotation", def.frame_b.rotation);
    change.begin();
    const std::uint32_t index = s.joints.slots.create();
    make_room(s.joints.info, index), make_room(s.joints.axes, index), make_room(impl_->joint_defs, index);
    JointDef& own = impl_->joint_defs[index] = std::move(given);
    fill_frames(info, own);
    info.in_use = 1;
    info.enable_collision = own.enable_collision;
    info.enabled = own.enabled;
    info.solver = std::uint8_t(own.solver);
    info.break_force = own.break_force;
    info.break_torque = own.break_torque;
    s.joints.info[index] = info;
    s.joints.axes[index] = {};
    const float length = pulley_length(s.bodies, info, own.joint);
    keep_pulley_length(own.joint, length);
    set_rules(s.bodies, s.joints, index, make_rules(own.joint, length));
    link_joint(s.bodies, s.joints, index);
    activate_joint(s.bodies, s.islands, s.joints, s.events, index);
    refilter_pairs(s.bodies, s.shapes, s.broad_phase, info);
    return s.joints.slots.id(index);
}

JointDef World::joint_at(BodyId body_a, BodyId body_b, const Position& anchor, const Vec3& axis,
                         const Joint& joint) const {
    require_position("World::joint_at anchor", anchor);
    require_finite("World::joint_at axis", axis);
    const math::DVec3 along = math::to_double(to_math(axis));
    if (!(math::dot(along, along) > 0)) refuse("World::joint_at axis", to_text(axis), "must not be zero");
    const State& s = impl_->state;
    const math::DQuat world = turn_from_x(math::normalized(along));
    auto frame = [&](BodyId id) {
        Transform t{anchor, to_public(math::to_float(world))};
        if (id.is_null()) return t;
        const std::int32_t body = impl_->index_of(id);
        const math::DQuat& q = s.bodies.motion[body].q;
        t.position = to_public(math::rotate_back(q, to_math(anchor) - body_origin(s.bodies, body)));
        t.rotation = to_public(math::to_float(math::normalized(math::conjugate(q) * world)));
        return t;
    };
    JointDef def;
    def.body_a = body_a, def.body_b = body_b;
    def.frame_a = frame(body_a), def.frame_b = frame(body_b);
    def.joint = joint;
    return def;
}

void World::destroy_joint(JointId id) {
    Impl::Change change(*impl_, commands::world_destroy_joint, id);
    const std::uint32_t index = impl_->index_of(id);
    change.begin();
    impl_->retire_joint(index, std::nullopt);
}

bool World::is_valid(JointId id) const noexcept { return impl_ && impl_->state.joints.slots.holds(id); }

const JointDef& World::joint_def(JointId id) const { return impl_->joint_defs[impl_->index_of(id)]; }

void World::set_joint(JointId id, const Joint& joint) {
    Impl::Change change(*impl_, commands::world_set_joint, id, joint);
    const std::uint32_t index = impl_->index_of(id);
    validate(joint);
    State& s = impl_->state;
    change.begin();
    JointInfo& info = s.joints.info[index];
    Joint& own = impl_->joint_defs[index].joint = joint;
    fill_frames(info, impl_->joint_defs[index]);
    const float length = pulley_length(s.bodies, info, own);
    keep_pulley_length(own, length);
    set_rules(s.bodies, s.joints, index, make_rules(own, length));
    if (const std::int32_t owner = joint_owner(s.bodies, info); owner != none)
        wake_body(s.bodies, s.islands, s.events, owner);
}

void World::set_joint_strength(JointId id, float break_force, float break_torque) {
    Impl::Change change(*impl_, commands::world_set_joint_strength, id, break_force, break_torque);
    const std::uint32_t index = impl_->index_of(id);
    JointDef& def = impl_->joint_defs[index];
    JointDef changed = def;
    changed.break_force = break_force;
    changed.break_torque = break_torque;
    validate(changed);
    change.begin();
    def = changed;
    impl_->state.joints.info[index].break_force = break_force;
    impl_->state.joints.info[index].break_torque = break_torque;
    if (const std::int32_t owner = joint_owner(impl_->state.bodies, impl_->state.joints.info[index]); owner != none)
        wake_body(impl_->state.bodies, impl_->state.islands, impl_->state.events, owner);
}

void World::set_joint_enabled(JointId id, bool enabled) {
    Impl::Change change(*impl_, commands::world_set_joint_enabled, id, enabled);
    const std::uint32_t index = impl_->index_of(id);
    State& s = impl_->state;
    JointInfo& info = s.joints.info[index];
    if ((info.enabled != 0) == enabled) return;
    change.begin();
    impl_->joint_defs[index].enabled = enabled;
    if (enabled) {
        info.enabled = 1;
        // Angles are counted from the current pose of the bodies.
        const Joint& own = impl_->joint_defs[index].joint;
        set_rules(s.bodies, s.joints, index, make_rules(own, pulley_length(s.bodies, info, own)));
        activate_joint(s.bodies, s.islands, s.joints, s.events, index);
        refilter_pairs(s.bodies, s.shapes, s.broad_phase, info);
    } else {
        refilter_pairs(s.bodies, s.shapes, s.broad_phase, info);
        deactivate_joint(s.bodies, s.islands, s.joints, s.events, index);
        info.enabled = 0;
        info.force = info.torque = {};
        forget_impulses(info, s.joints.axes[index]);
    }
}

JointState World::joint_state(JointId id) const {
    const std::uint32_t index = impl_->index_of(id);
    const JointInfo& info = impl_->state.joints.info[index];
    const JointPositions positions = joint_positions(impl_->state.bodies, impl_->state.joints, index);
    JointState state;
    state.force = to_public(info.force);
    state.torque = to_public(info.torque);
    float linear = math::dot(positions.gap, positions.gap), angular = math::dot(positions.turn, positions.turn);
    for (int i = 0; i < info.rules.axis_count; ++i) {
        const JointAxisRule& rule = impl_->state.joints.axes[index].rules[i];
        if (!rule.is_lock) {
            state.positions[state.position_count++] = positions.axes[i];
        } else if (rule.has_limits) {
            const float error = positions.axes[i] - rule.lower;
            (rule.kind == AxisKind::linear || rule.kind == AxisKind::rack ? linear : angular) += error * error;
        }
    }
    state.linear_error = std::sqrt(linear);
    state.angular_error = std::sqrt(angular);
    return state;
}

std::vector<JointId> World::joints() const {
    const State& s = impl_->intact("World::joints");
    std::vector<JointId> ids;
    ids.reserve(s.joints.slots.live_count());
    for (std::uint32_t i = 0; i < s.joints.slots.size(); ++i)
        if (s.joints.slots.is_live(i)) ids.push_back(s.joints.slots.id(i));
    return ids;
}

std::vector<JointId> World::joints(BodyId id) const {
    std::vector<JointId> ids;
    for_each_joint(impl_->state.bodies, impl_->state.joints, impl_->index_of(id),
                   [&](std::uint32_t joint, int) { ids.push_back(impl_->state.joints.slots.id(joint)); });
    return ids;
}

std::optional<JointId> World::find_joint(std::string_view name) const {
    const State& s = impl_->intact("World::find_joint");
    for (std::uint32_t i = 0; i < s.joints.slots.size(); ++i)
        if (s.joints.slots.is_live(i) && impl_->joint_defs[i].name == name) return s.joints.slots.id(i);
    return std::nullopt;
}

std::span<const JointEvent> World::joint_events() const { return impl_->state.events.joints.now; }

} // namespace cairn
