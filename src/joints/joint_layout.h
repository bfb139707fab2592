// The layout of a batch's joint rows in blocks of 8 lanes.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Packs the joints of the batch's islands into blocks of 8 lanes, color by color. `h`: the substep.
void fill_joint_lanes(const Bodies& bodies, Joints& joints, SolverScratch& solver, const DirectSets& direct,
                      const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool, float h);

// Whether no earlier run has lanes in the blocks of this run.
inline bool opens_blocks(const JointRun& run) { return run.first_lane == 0; }

// Parts of the key of a row or run: the form of its rows, and whether some of their ends may not move by forces.
std::uint32_t joint_form_of(std::uint32_t key);
// Flag in the form of a point row: its joint has a turn as well.
inline constexpr std::uint32_t form_with_turn = 4;
bool may_be_fixed(std::uint32_t key);

} // namespace cairn
