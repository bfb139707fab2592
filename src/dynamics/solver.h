// The solver: islands packed into bins, each bin gathered into dense rows and blocks and solved through all of its
// substeps. docs/solver.md explains the method.
#pragma once

#include "dynamics/state.h"
#include "jobs/crew.h"

namespace cairn {

// Decides how many substeps each awake island takes, packs islands into bins and sorts State::solved by bin, color
// and number of points. Impulses of contacts whose substeps have another length than in the last step are scaled.
void pack_bins(State& state, float dt);

// --- contacts without anything to do (idle_contacts.cpp)

// Lists what moves fast. False if that is so much that no contact is left out in this step.
bool find_fast(State& state, float dt);
// Of a contact that bore nothing: how much farther apart its points are than they may come in the step, m; or 0.
float spare_gap(const State& state, const SortedContact& contact, float dt);
// Marks those of SolverScratch::unsorted that stay apart, however their bodies and those around them move in the step.
void leave_out_idle(State& state, float dt);

// ---

// Solves all bins: velocities, poses, impulses; moves kinematic bodies. Finalizes all bodies (finalize.h).
void solve_bins(State& state, float dt);

// --- one bin (bin_rows.cpp)

// Lays out the rows and lanes of a bin, and fills them.
void fill_bin(State& state, const Bin& bin, BinScratch& scratch, Crew* crew, float dt);
// The row of a body. Bodies get theirs when a contact or joint first names them, so that contacts side by side have
// rows side by side.
std::int32_t row_of_body(BinScratch& scratch, std::int32_t body);
// Moves the bodies by what their rows have moved, and finalizes them.
void empty_bin(State& state, BinScratch& scratch, Crew* crew, float dt);

// --- free motion (free_motion.cpp); `crew` helps where it is not null

// Fills drive, damping and correction of the bin's rows for substeps of h seconds. `bounces`: there must be
// corrections, because something else will add to them.
void prepare_free_motion(const State& state, BinScratch& scratch, Crew* crew, float h, bool bounces);
// What is slow in a bin that `rests`, or in another.
SlowTurns slow_turns(bool rests);
// At the start of each substep: what of them depends on the pose or the velocity.
void update_free_motion(const State& state, BinScratch& scratch, Crew* crew, const SolverBodies& bodies, float h,
                        bool first);
// After the poses of a substep: the rotations of what turns by many radians in it, or has moments a millionth of
// others, where single precision and a series for small angles do not do.
void turn_spinning_rows(const State& state, BinScratch& scratch, float h);
// After that: the inertia of what has joints, whose anchors turn with it.
void renew_inertia(const State& state, BinScratch& scratch, Crew* crew);
// The tensor that contacts and joints act on.
math::Sym3 contact_inverse_inertia(const BodyMotion& motion, const BodyMass& mass);
// After the last substep: the angular velocities that go with the angular momenta and rotations at its end.
void finish_free_motion(BinScratch& scratch);
// Contacts on a needle, with a moment a millionth of the others, would spin it up without end in single precision: for
// them no moment is less than this share of the greatest. (A rod 20 times as long as thick has 0.5 %.)
inline constexpr float least_contact_moment = 0.005f;
// What the free motion of a body in contact asks for (RowTrait).
std::uint8_t row_traits(const State& state, std::int32_t body);
// A body that nothing touches: a whole step, in double. What the rounding of its velocities leaves over is kept.
// Returns how often a speed was cut.
std::uint64_t move_free_body(State& state, std::int32_t body, float dt);
bool any_field(const State& state);
// Gravity and fields at a point, m/s^2 (for a body of that mass and gravity scale).
math::DVec3 field_acceleration(const State& state, math::DVec3 x, float gravity_scale, double inverse_mass);

inline constexpr int most_substeps = 256;

// Substeps of an island with so many contacts in this pass, by what it carried in the last steps (substeps.cpp).
int island_substeps(const State& state, Island& island, std::int32_t contacts);
// After a step: takes note of what the joints of the bin's islands bore.
void note_joint_loads(State& state, const Bin& bin, const BinScratch& scratch);
// What a contact that begins may have to carry: the weight of the body above. Normal from A to B.
float first_load(const State& state, const ContactInfo& contact, math::Vec3 normal);
// After a step: the normal force that a contact carried, and the sum of the inverse masses that bore it. Others may be
// at work on other contacts of the island.
void note_load(Island& island, ContactInfo& contact, float force, float inverse_mass);

} // namespace cairn
