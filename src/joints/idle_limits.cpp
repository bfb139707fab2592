// Limits that are out of reach. Most limits of a heap of ragdolls bear nothing: their rows are left out of the solver
// as long as the bodies have not turned far enough against each other to come near them.
#include "joints/idle_limits.h"

#include "collision/core_sweep.h"

#include "core/cache.h"
#include "math/rotation.h"
#include "state/joint_links.h"

#include <algorithm>
#include <atomic>

namespace cairn {

namespace {

constexpr int joints_per_chunk = 128; // for threads

// How far bodies may turn against each other in a pass: more than their angular velocities at its start say, rad; and
// what flies at something is turned by the impact, by a share of its speed over its radius. Who is hit harder gets
// beyond the limit by a little, and is brought back in the next pass.
constexpr float more_turn = 1.5f, min_reach = 0.03f, impact_share = 0.25f;

const JointAxisRule* swing_rule(const JointLocks& locks, const JointAxes& axes) {
    for (int i = 0; i < locks.axis_count; ++i)
        if (axes.rules[i].kind == AxisKind::swing) return &axes.rules[i];
    return nullptr;
}

// An upper bound of the angle by which the bodies of a joint turned against each other in the last pass.
float turned_against_each_other(const Bodies& bodies, const JointInfo& joint) {
    const auto turned = [&](std::int32_t body) { return body == none ? math::Quat{} : bodies.motion[body].turned; };
    const math::Quat q = math::conjugate(turned(joint.body_a)) * turned(joint.body_b);
    const float sine = std::sqrt((q.x * q.x + q.y * q.y) + q.z * q.z); // of half the angle
    return (sine < 0.5f ? 2.1f : 3.1416f) * sine + 1e-6f;
}
// rad/s.
float turning_speed(const Bodies& bodies, const JointInfo& joint) {
    const auto w = [&](std::int32_t body) { return body == none ? math::Vec3{} : bodies.motion[body].w; };
    float by_impact = 0;
    for (const std::int32_t body : {joint.body_a, joint.body_b}) {
        if (body == none) continue;
        const float radius = bodies.links[body].radius, speed = math::length(bodies.motion[body].v);
        if (radius > 0) by_impact = std::max(by_impact, speed / radius);
    }
    return more_turn * math::length(w(joint.body_b) - w(joint.body_a)) + impact_share * by_impact;
}

// Asks the cache for what is looked at of a joint here.
void prefetch(const Joints& joints, std::uint32_t joint) {
    ask_cache(&joints.info[joint]);
    const JointAxes& axes = joints.axes[joint];
    ask_cache(&axes.states[0]);
    ask_cache(&axes.states[max_joint_axes - 1]);
}

// Whether the row need not be solved; keeps its slack.
bool is_out_of_reach(const JointAxisRule& rule, JointAxisState& state, float by_turn, float turned, float speed,
                     float dt) {
    const float reach = by_turn * (dt * speed + min_reach);
    if (state.slack > 0) {
        state.slack -= by_turn * turned;
        if (!(state.slack > reach)) state.slack = 0;
    } else if (state.slack < 0) {
        state.slack = 0; // known again after this pass
    } else if (state.lower == 0 && state.upper == 0) {
        const float room = std::min(state.position - rule.lower, rule.upper - state.position);
        // Some more room, so that rows do not come and go. And a twist is counted on from the last known one, which
        // must be less than half a turn away.
        if (room > 2 * reach) state.slack = std::min(room, half_turn);
    }
    return state.slack > 0;
}

// How much its position changes at most, by the angle that the bodies turn by against each other; 0: by no such bound.
float change_by_turn(const JointLocks& locks, const JointAxes& axes, const JointAxisRule& rule) {
    if (rule.kind == AxisKind::swing || rule.kind == AxisKind::turn) return 1;
    if (rule.kind != AxisKind::twist) return 0;
    // The twist of what swings changes faster than the bodies turn, by 1 / cos of half the swing.
    const JointAxisRule* swing = swing_rule(locks, axes);
    const bool is_held = locks.turn == JointLock::across;
    if (!is_held && !(swing && swing->has_limits && swing->rigid_limit)) return 0;
    const double most = is_held ? 0 : double(swing->upper);
    const double cosine = math::from_rotation_vector(math::DVec3{most, 0, 0}).w;
    return most < double(half_turn) && cosine > 0 ? float(1 / cosine) : 0;
}

} // namespace

float reach_by_turn(const JointLocks& locks, const JointAxes& axes, const JointAxisRule& rule) {
    const bool has_more = rule.has_drive || rule.friction > 0 || rule.is_equation;
    return rule.has_limits && !has_more ? change_by_turn(locks, axes, rule) : 0;
}

bool update_idle_rows(const Bodies& bodies, Joints& joints, JointLayout& layout, ThreadPool* thread_pool, float dt) {
    if (!layout.may_idle) return false;
    std::atomic<bool> any_changed = false;
    for_chunks(thread_pool, int(layout.joints.size()), joints_per_chunk, [&](int begin, int end, int) {
        bool changed = false;
        for (std::size_t k = std::size_t(begin); k < std::size_t(end); ++k) {
            if (k + joints_ahead < std::size_t(end)) prefetch(joints, layout.joints[k + joints_ahead]);
            const JointInfo& joint = joints.info[layout.joints[k]];
            float turned = -1, speed = 0;
            for (std::uint32_t i = layout.first_row[k]; i < layout.first_row[k + 1]; ++i) {
                JointRow& row = layout.rows[i];
                if (row.reach_by_turn == 0) continue;
                if (turned < 0) turned = turned_against_each_other(bodies, joint), speed = turning_speed(bodies, joint);
                JointAxes& axes = joints.axes[row.joint];
                const bool idle =
                    is_out_of_reach(axes.rules[row.axis], axes.states[row.axis], row.reach_by_turn, turned, speed, dt);
                changed |= idle != bool(row.idle);
                row.idle = idle;
            }
        }
        if (changed) any_changed = true;
    });
    return any_changed;
}

void forget_slack(const Bodies& bodies, Joints& joints, std::int32_t body) {
    for_each_joint(bodies, joints, body, [&](std::uint32_t joint, int) {
        for (JointAxisState& axis : joints.axes[joint].states) axis.slack = -1;
    });
}

} // namespace cairn
