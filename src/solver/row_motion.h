// The free motion of the bodies in a batch: what changes their velocities beside contacts and joints. `thread_pool`
// helps where it is not null.
#pragma once

#include "jobs/thread_pool.h"
#include "state/solver_scratch.h"
#include "state/state.h"

namespace cairn {

// Fills drive, damping and correction of the batch's rows for substeps of h seconds. `bounces`: there must be
// corrections, because something else will add to them.
void prepare_free_motion(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings,
                         BatchScratch& scratch, ThreadPool* thread_pool, float h, bool bounces);
// At the start of each substep: what of them depends on the pose or the velocity.
void update_free_motion(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings,
                        BatchScratch& scratch, ThreadPool* thread_pool, const SolverBodies& solver_bodies, float h,
                        bool first);
// Contacts and joints hold what moves the poses. Of a body that turns freely that is its angular velocity in the middle
// of the substep, half a substep behind that of its end: between these two calls the rows have that one. As long as the
// other was held, a taut chain with a link that spins gained energy, and tops on their tips nutated.
void hold_what_turns(BatchScratch& scratch, ThreadPool* thread_pool);
void release_what_turns(BatchScratch& scratch, ThreadPool* thread_pool);
// After the poses of a substep: the rotations of what turns by many radians in it, or has moments a millionth of
// others, where single precision and a series for small angles do not do.
void turn_spinning_rows(const Bodies& bodies, BatchScratch& scratch, float h);
// After that: the inertia of what has joints, whose anchors turn with it.
void renew_inertia(const Bodies& bodies, BatchScratch& scratch, ThreadPool* thread_pool);
// After the last substep: the angular velocities that go with the angular momenta and rotations at its end.
void finish_free_motion(BatchScratch& scratch);
// What the free motion of a body in contact asks for (RowTrait).
std::uint8_t row_traits(const Bodies& bodies, const WorldDef& settings, std::int32_t body);

} // namespace cairn
