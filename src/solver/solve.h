// The solver packs islands into batches; each batch is gathered into dense body rows and blocks of contacts, and solved
// through all of its substeps. docs/solver.md explains the method.
//
// Division of work among threads. Time runs downwards; there is a barrier after every line, except within a batch that
// is solved by a single thread.
//
//      the calling thread              all threads of the world
//      --------------------------      --------------------------------------------------------------------------------
//      find the direct sets            (waiting)
//      share out the batches
//
//      for each large batch            ("shared": larger than one thread's share of all contacts and joints)
//      | gather bodies, lanes    >     fill rows, joint rows, direct rows; prepare blocks
//      | for each substep        >       velocities      chunks of rows
//      |                         >       bounce          color after color, chunks of the blocks of one color
//      |                         >       solve           runs of joint rows, direct sets, then color after color
//      |   impacts               >       poses           chunks of rows
//      |                         >       relax           runs of joint rows, then color after color
//      |   store joints          >     store impulses, move and finalize bodies
//
//      the small batches         >     each batch by whichever thread is free, through all of the stages above
//
//      collect, in the order of the indices; update the broad phase; move kinematic bodies
//
// Memory that a thread may write while other threads are running:
//   - rows (velocity, pose) of bodies in its chunk of rows, or in its blocks of the current color: blocks of one color
//     share no dynamic body (islands/coloring.h), and rows of other bodies are only read. Lanes without a body to
//     write to have a discard row in each block;
//   - the blocks of its chunk, and the records, reports and joints of their lanes: each of these has exactly one lane;
//   - the motion, links and shapes of the dynamic bodies in its batch or chunk: each body is in one batch. Kinematic
//     bodies may be in several; no batch writes them, and they move after all batches have ended;
//   - the weight and agitation of the islands of its batch: each island is in one batch;
//   - its own entry of SolverScratch::at_work, which gathers the results for other stages; `collect` sorts them.
//     Only integers are summed over threads, since floating-point sums would depend on the order of arrival.
// Pairs, beginning and ending contacts, island membership, sleeping, events and the broad phase are not touched by any
// of these stages. Hence the state depends neither on the number of threads nor on the assignment of work to threads
// (docs/decisions/threads.md).
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

#include <cairn/communicator.h>

namespace cairn {

// Solves all batches (velocities, poses, impulses), moves kinematic bodies and finalizes all bodies (finalize.h).
// Returns how many times a speed was clamped. `ranks`: the ranks that step this world together (rank_cut.h); null: this
// process alone.
std::uint64_t solve_batches(Bodies& bodies, Shapes& shapes, Contacts& contacts, Islands& islands, Joints& joints,
                            const ForceFields& fields, BroadPhase& broad_phase, const WorldDef& settings,
                            StepScratch& step, Communicator* ranks, float dt);

} // namespace cairn
