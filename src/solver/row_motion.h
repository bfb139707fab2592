// The free motion of the bodies in a batch: all changes of velocity that contacts and joints do not cause.
// `thread_pool`: null, or the threads that share the work.
#pragma once

#include "jobs/thread_pool.h"
#include "state/solver_scratch.h"
#include "state/state.h"

namespace cairn {

// Fills drive, damping and correction of the batch's rows for substeps of h seconds. `bounces`: allocates corrections
// in any case, because bounces will add to them.
void prepare_free_motion(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings,
                         BatchScratch& scratch, ThreadPool* thread_pool, float h, bool bounces);
// At the start of each substep, updates the parts of these that depend on the pose or the velocity.
void update_free_motion(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings,
                        BatchScratch& scratch, ThreadPool* thread_pool, const SolverBodies& solver_bodies, float h,
                        bool first);
// Contacts and joints must constrain the velocity that moves the poses. For a freely rotating body this is the angular
// velocity in the middle of the substep, half a substep before that at its end: between these two calls, rows hold the
// angular velocity of the middle. With that of the end constrained instead, a taut chain with a spinning link gained
// energy, and tops on their tips nutated.
void use_midpoint_spin(BatchScratch& scratch, ThreadPool* thread_pool);
void restore_end_spin(BatchScratch& scratch, ThreadPool* thread_pool);
// After the poses of a substep: computes the rotations of bodies that turn by many radians per substep, or whose
// moments of inertia differ by a factor of a million, for which single precision and a series for small angles are not
// accurate enough.
void turn_spinning_rows(const Bodies& bodies, BatchScratch& scratch, float h);
// After turn_spinning_rows: updates the inertia of bodies with joints, whose anchors rotate with the body.
void renew_inertia(const Bodies& bodies, BatchScratch& scratch, ThreadPool* thread_pool);
// After the last substep: computes the angular velocities from the angular momenta and rotations at its end.
void finish_free_motion(BatchScratch& scratch);
// The traits (RowTrait) that the free motion of a body in contact requires.
std::uint8_t row_traits(const Bodies& bodies, const WorldDef& settings, std::int32_t body);

} // namespace cairn
