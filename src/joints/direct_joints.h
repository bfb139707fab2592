// The direct solver of joints: all rows of a set at once, by a block L D L^T factorization in each substep.
//
// With the rows' Jacobian J, the matrix is A = J M^-1 J^T (Baraff 1996, "Linear-time dynamics using Lagrange
// multipliers", has the idea for trees; here any graph in an order of least fill). Velocities come from J v = -rate x
// error. Light bodies under great tension need more: docs/decisions/direct_joints.md derives the geometric stiffness.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// The sets whose joints are in the batch, and rows for their bodies. Before the rows are filled. `h`: the
// substep.
void list_direct_sets(const Joints& joints, const DirectSets& direct, BatchScratch& scratch, float h);
// The limits and drives that they solve. After the joints' rows have their lanes.
void list_direct_limits(const Joints& joints, const DirectSets& direct, BatchScratch& scratch);
// Positions, axes and impulses of their rows. After the rows are filled.
void fill_direct_rows(const Bodies& bodies, const Joints& joints, const DirectSets& direct, BatchScratch& scratch,
                      ThreadPool* thread_pool, float h);

// In each substep, after the free motion of its velocities: the matrix of the poses now and its factors, and the
// impulses of the last substep. They are not carried through the reference.
void begin_direct_substep(const Joints& joints, const DirectSets& direct, BatchScratch& scratch,
                          ThreadPool* thread_pool, float h, bool first);
// Then, where the axis rows are placed: those of the limits.
void begin_direct_limits(const DirectSets& direct, BatchScratch& scratch, ThreadPool* thread_pool);
// Then, once: what is missing of the impulses.
void solve_direct_rows(const Joints& joints, const DirectSets& direct, BatchScratch& scratch, ThreadPool* thread_pool,
                       float h);
// While poses are integrated: bodies that contacts have pushed have velocities that the joints allow. A foot that is
// light beside what stands on it would else go its own way in each substep, and the joints pull it back. Their
// velocities themselves stay as the contacts left them, so that nothing that takes overlaps back is passed on.
void hold_direct_bodies(const Joints& joints, const DirectSets& direct, BatchScratch& scratch, ThreadPool* thread_pool,
                        float h);
void release_direct_bodies(const DirectSets& direct, BatchScratch& scratch, ThreadPool* thread_pool);

// In an impact: gives the bodies of a set, `place` in DirectWork::sets, velocities that its joints allow.
void join_velocities(const Joints& joints, const DirectSets& direct, BatchScratch& scratch, std::size_t place, float h);

// After the last substep: impulses and forces (as impulses of the whole step) back to the joints.
void store_direct_rows(Joints& joints, const DirectSets& direct, BatchScratch& scratch);

} // namespace cairn
