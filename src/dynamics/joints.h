// Joints: their place in the lists of bodies, islands and colors, and their rows in a solver bin.
#pragma once

#include "dynamics/state.h"

namespace cairn {

// Islands with joints take so many substeps, unless they have many (substeps.cpp): the error of soft rows falls with
// their square.
inline constexpr int joint_substeps = 11;

// The body that a joint counts to, in whose island it is; none if neither is dynamic.
inline std::int32_t joint_owner(const State& s, const JointInfo& joint) {
    if (joint.body_a != none && s.is_dynamic(joint.body_a)) return joint.body_a;
    return joint.body_b != none && s.is_dynamic(joint.body_b) ? joint.body_b : none;
}
// Calls f(joint, side) for the joints of a body, oldest first. f may not remove any.
template <class F> void for_each_joint(const State& s, std::int32_t body, F&& f) {
    for (std::int32_t end = s.bodies[std::size_t(body)].first_joint; end != none;
         end = s.joints[std::size_t(end / 2)].next[end % 2])
        f(std::uint32_t(end / 2), end % 2);
}
inline std::int32_t other_body(const JointInfo& joint, int side) { return side == 0 ? joint.body_b : joint.body_a; }

// A joint that is filled in joins the lists of its bodies; and leaves them.
void link_joint(State& state, std::uint32_t joint);
void unlink_joint(State& state, std::uint32_t joint);
// It begins and ceases to be solved, as bodies become dynamic or cease to be: color, counts, islands.
void activate_joint(State& state, std::uint32_t joint);
void deactivate_joint(State& state, std::uint32_t joint);

// Whether some joint of two bodies keeps them from colliding.
bool joint_forbids_contact(const State& state, std::int32_t body_a, std::int32_t body_b);

// What hangs on a kinematic body that moves is awake, and stays so.
void wake_driven_joints(State& state);

// --- rows in a bin (joint_rows.cpp)

// Joints of the bin's islands, laid into blocks of 8 lanes color by color.
void fill_joint_lanes(State& state, const Bin& bin, BinScratch& scratch, Crew* crew, float dt);
// Positions, axes and impulses of the lanes; `h`: the substep.
void fill_joint_blocks(State& state, BinScratch& scratch, Crew* crew, float h);
// After the last substep: impulses and forces back to the joints.
void store_joints(State& state, BinScratch& scratch, float dt);
JointSoftness joint_softness(const State& state, const Bin& bin, float h);

// --- what falls side by side (flight.cpp)

// After a pass in which the joints of an island were solved: whether they bore anything.
void note_flight(const State& state, Island& island, const std::uint32_t* joints);
inline std::int32_t solved_joints(const Island& island) { return island.flies ? 0 : island.joint_count; }
// Whether an island with so many contacts can do without its joints in this pass.
bool flies(const State& state, const Island& island, std::int32_t contacts);
// A joint in the island of that body has changed, or what it holds has been put elsewhere.
void end_flight(State& state, std::int32_t body);

// --- limits that are out of reach (joint_idle.cpp)

// By how much the position of an axis changes, at most, by the angle that the bodies turn by against each other. Of
// mere limits of an angle; 0: of all else, that is not looked at.
float reach_by_turn(const JointLocks& locks, const JointAxes& axes, const JointAxisRule& rule);
// Once in a pass. True if other rows than before are left out of the solver.
bool update_idle_rows(State& state, JointLayout& layout, Crew* crew, float dt);
// The body has been put elsewhere.
void forget_slack(State& state, std::int32_t body);

// The positions of a joint's axes, the gap between its anchors and the rotation error, as the bodies stand.
struct JointPositions {
    float axes[most_joint_axes];
    math::Vec3 gap, turn; // of what it locks
};
JointPositions joint_positions(const State& state, std::uint32_t joint);

} // namespace cairn
