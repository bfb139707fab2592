// The direct solver of joints: solves all constraint rows of a set at once, by a block L D L^T factorization in each
// substep.
//
// With the rows' Jacobian J, the matrix is A = J M^-1 J^T (Baraff 1996, "Linear-time dynamics using Lagrange
// multipliers", does this for trees; here for any graph, in an elimination order of low fill). Velocities satisfy J v =
// -rate x error. Light bodies under great tension also need geometric stiffness, which docs/decisions/direct_joints.md
// derives.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Lists the sets whose joints are in the batch, and creates rows for their bodies. Called before body rows are filled.
// `h`: the substep.
void list_direct_sets(const Joints& joints, const DirectSets& direct, BatchScratch& scratch, float h);
// Lists the limits and drives that the sets solve. Called after the joint rows have their lanes.
void list_direct_limits(const Joints& joints, const DirectSets& direct, BatchScratch& scratch);
// Fills positions, axes and impulses of the sets' rows. Called after the body rows are filled.
void fill_direct_rows(const Bodies& bodies, const Joints& joints, const DirectSets& direct, BatchScratch& scratch,
                      ThreadPool* thread_pool, float h);

// Called in each substep, after the free motion of velocities: assembles and factorizes the matrix for the present
// poses, and applies the impulses of the last substep, which are not carried over through the reference velocities.
void begin_direct_substep(const Joints& joints, const DirectSets& direct, BatchScratch& scratch,
                          ThreadPool* thread_pool, float h, bool first);
// Called next, once the axis rows are up to date: applies the impulses of the limits.
void begin_direct_limits(const DirectSets& direct, BatchScratch& scratch, ThreadPool* thread_pool);
// Called next, once per substep: solves for the missing impulses.
void solve_direct_rows(const Joints& joints, const DirectSets& direct, BatchScratch& scratch, ThreadPool* thread_pool,
                       float h);
// While poses are integrated, bodies that contacts have pushed get velocities that the joints allow. Otherwise a foot
// that is light compared to the body standing on it would move independently in each substep, and the joints would pull
// it back. The stored velocities stay as the contacts left them, so that speeds that correct penetration are not passed
// on.
void hold_direct_bodies(const Joints& joints, const DirectSets& direct, BatchScratch& scratch, ThreadPool* thread_pool,
                        float h);
void release_direct_bodies(const DirectSets& direct, BatchScratch& scratch, ThreadPool* thread_pool);

// In an impact: gives the bodies of a set, with the index `place` in DirectWork::sets, velocities that its joints
// allow.
void join_velocities(const Joints& joints, const DirectSets& direct, BatchScratch& scratch, std::size_t place, float h);

// After the last substep: stores impulses and forces (as impulses over the whole step) in the joints.
void store_direct_rows(Joints& joints, const DirectSets& direct, BatchScratch& scratch);

} // namespace cairn
