// How the rows of the joints of a batch lie in blocks of 8 lanes.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Joints of the batch's islands, laid into blocks of 8 lanes color by color. `h`: the substep.
void fill_joint_lanes(const Bodies& bodies, Joints& joints, SolverScratch& solver, const DirectSets& direct,
                      const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool, float h);

// Whether no run before it has lanes of its blocks.
inline bool opens_blocks(const JointRun& run) { return run.first_lane == 0; }

// Of the key of a row or run: the form of its rows, and whether they may have ends that do not move by forces.
std::uint32_t joint_form_of(std::uint32_t key);
// In the form of a point: its joint has a turn as well.
inline constexpr std::uint32_t form_with_turn = 4;
bool may_be_fixed(std::uint32_t key);

} // namespace cairn
