// Assigns the contacts of a batch to lanes of blocks, by color and number of contact points.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Sorts the contacts of a batch by their keys, into SolverScratch::sorted and key_ends. `scratch` provides memory for
// the counts.
void sort_contacts(SolverScratch& solver, const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool);

// Packs the sorted contacts into blocks of 8 lanes, color by color; for a batch that is cut, only the contacts of this
// rank. Dynamic bodies must have their rows already; bodies that forces do not move, and moving surfaces, get theirs
// here.
void fill_lanes(const SolverScratch& solver, const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool);

} // namespace cairn
