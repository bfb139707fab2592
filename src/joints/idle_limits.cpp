// Joint limits that are out of reach. Most limits in a heap of ragdolls have zero impulse: their rows are left out of
// the solver until the bodies may have rotated far enough relative to each other to come near the limits.
#include "joints/idle_limits.h"

#include "collision/core_sweep.h"

#include "core/cache.h"
#include "math/rotation.h"
#include "state/joint_links.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace cairn {

namespace {

constexpr int joints_per_chunk = 128; // for threads

const JointAxisRule* swing_rule(const JointLocks& locks, const JointAxes& axes) {
    for (int i = 0; i < locks.axis_count; ++i)
        if (axes.rules[i].kind == AxisKind::swing) return &axes.rules[i];
    return nullptr;
}

// The total travel of the bodies of a joint up to now, its greatest value after this step, and the radius of the
// smaller body: a body rotates (rad) by at most its travel over its radius.
struct JointTravel {
    Travel now = 0, ahead = 0;
    float radius = std::numeric_limits<float>::infinity();
};
JointTravel travel_of(const Bodies& bodies, const JointInfo& joint) {
    JointTravel travel;
    for (const std::int32_t body : {joint.body_a, joint.body_b}) {
        if (body == none || bodies.settings[body].type == BodyType::static_) continue;
        travel.now += bodies.travel[body], travel.ahead += bodies.ahead[body];
        travel.radius = std::min(travel.radius, bodies.links[body].radius);
    }
    return travel;
}

// Prefetches the data of a joint that are needed here.
void prefetch(const Joints& joints, std::uint32_t joint) {
    prefetch(&joints.info[joint]);
    const JointAxes& axes = joints.axes[joint];
    prefetch(&axes.states[0]);
    prefetch(&axes.states[max_joint_axes - 1]);
}

// Whether the row need not be solved in this step.
bool is_out_of_reach(const JointAxisRule& rule, JointAxisState& state, float by_turn, const JointTravel& travel) {
    if (state.is_idle) {
        state.is_idle = is_before(travel.ahead, state.until);
        if (!state.is_idle) state.until = travel.now; // solved in this step
        return state.is_idle;
    }
    const Travel known_at = state.until;
    state.until = travel.now;
    const bool is_known = is_before(travel.now, known_at + budget_of(max_leap / 2)); // else the bodies were teleported
    if (!is_known || state.lower != 0 || state.upper != 0) return false;
    // A twist angle is counted from the last known one, which must be less than half a turn away.
    const float room = std::min({state.position - rule.lower, rule.upper - state.position, half_turn});
    const Travel until = travel.now + budget_of(double(room) * double(travel.radius) / double(by_turn));
    // Requires a margin, so that rows are not left out and solved in turns.
    if (!is_before(travel.ahead + (travel.ahead - travel.now), until)) return false;
    state.until = until;
    state.is_idle = 1;
    return true;
}

// Greatest change of the position per angle by which the bodies rotate relative to each other; 0: not bounded.
float change_by_turn(const JointLocks& locks, const JointAxes& axes, const JointAxisRule& rule) {
    if (rule.kind == AxisKind::swing || rule.kind == AxisKind::turn) return 1;
    if (rule.kind != AxisKind::twist) return 0;
    // The twist of a swinging joint changes faster than the bodies rotate, by 1 / cos of half the swing.
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

bool update_idle_rows(const Bodies& bodies, Joints& joints, JointLayout& layout, ThreadPool* thread_pool) {
    if (!layout.may_idle) return false;
    std::atomic<bool> any_changed = false;
    for_chunks(thread_pool, int(layout.joints.size()), joints_per_chunk, [&](int begin, int end, int) {
        bool changed = false;
        for (std::size_t k = std::size_t(begin); k < std::size_t(end); ++k) {
            if (k + joints_ahead < std::size_t(end)) prefetch(joints, layout.joints[k + joints_ahead]);
            const JointInfo& joint = joints.info[layout.joints[k]];
            const JointTravel travel = travel_of(bodies, joint);
            for (std::uint32_t i = layout.first_row[k]; i < layout.first_row[k + 1]; ++i) {
                JointRow& row = layout.rows[i];
                if (row.reach_by_turn == 0) continue;
                JointAxes& axes = joints.axes[row.joint];
                const bool idle =
                    is_out_of_reach(axes.rules[row.axis], axes.states[row.axis], row.reach_by_turn, travel);
                changed |= idle != bool(row.idle);
                row.idle = idle;
            }
        }
        if (changed) any_changed = true;
    });
    return any_changed;
}

} // namespace cairn
