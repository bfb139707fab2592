// The solver: islands packed into batches, each batch gathered into dense rows and blocks and solved through all of its
// substeps. docs/solver.md explains the method.
//
// What threads do where. Time runs downwards; every line ends before the next begins, but for the lines of a batch that
// one thread solves alone: those have no barrier among them.
//
//      the calling thread              all threads of the world
//      --------------------------      --------------------------------------------------------------------------------
//      find the direct sets            (waiting)
//      share out the batches
//
//      for each large batch            ("shared": more than its thread's part of all contacts and joints)
//      | gather bodies, lanes    >     fill rows, joint rows, direct rows; prepare blocks
//      | for each substep        >       velocities      chunks of rows
//      |                         >       bounce          color after color, chunks of the blocks of one color
//      |                         >       solve           runs of joint rows, direct sets, then color after color
//      |   impacts               >       poses           chunks of rows
//      |                         >       relax           runs of joint rows, then color after color
//      |   store joints          >     store impulses, move and finalize bodies
//
//      the small batches         >     each batch by whichever thread is free, all of the lines above
//
//      collect, in the order of the indices; tell the broad phase; move kinematic bodies
//
// What a thread may write, while others are at work:
//   - rows (velocity, pose) of bodies in its chunk of rows, or in its blocks of the color at hand: blocks of one color
//     share no body that moves by forces (islands/coloring.h), and rows of bodies that do not are read only. Lanes
//     without a body to write to have a discard row in each block;
//   - the blocks of its chunk, and the records, reports and joints that their lanes are of: each has one lane;
//   - the motion, links and shapes of the dynamic bodies in its batch or chunk: each is in one batch. Kinematic bodies
//     may be in many; no batch writes them, and they move when all batches have ended;
//   - the weight and agitation of the islands of its batch, each of which is in one;
//   - its own entry of SolverScratch::at_work: what others must hear of is gathered there, and `collect` sorts it. Sums
//     over threads are of whole numbers alone, as those of floats would depend on who came first.
// Pairs, contacts that begin or end, members of islands, sleep, events and the broad phase are not touched by any of
// it. Hence the state depends neither on the number of threads nor on which of them took what
// (docs/decisions/threads.md).
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

#include <cairn/communicator.h>

namespace cairn {

// Solves all batches: velocities, poses, impulses; moves kinematic bodies. Finalizes all bodies (finalize.h). Returns
// how often a speed was cut. `ranks`: those that step this world together (rank_cut.h); null: this process alone.
std::uint64_t solve_batches(Bodies& bodies, Shapes& shapes, Contacts& contacts, Islands& islands, Joints& joints,
                            const ForceFields& fields, BroadPhase& broad_phase, const WorldDef& settings,
                            StepScratch& step, Communicator* ranks, float dt);

} // namespace cairn
