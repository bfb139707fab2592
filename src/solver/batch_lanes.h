// The contacts of a batch, by color and number of points, in lanes of blocks.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Sorts the contacts of a batch by their keys: SolverScratch::sorted and key_ends. What is counted is left in
// `scratch`.
void sort_contacts(SolverScratch& solver, const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool);

// Lays the sorted contacts into blocks of 8 lanes, color by color; of a batch that is cut, those of this rank. Bodies
// have their rows, but for those that move by no forces, and for surfaces that move: these get theirs here.
void fill_lanes(const SolverScratch& solver, const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool);

} // namespace cairn
