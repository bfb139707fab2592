// Assigns the contacts of a batch to lanes of blocks, by color and number of contact points.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

#include <cstddef>
#include <cstdint>

namespace cairn {

// Sorts the contacts of a batch by their keys, into SolverScratch::sorted and key_ends. `scratch` provides memory for
// the counts.
void sort_contacts(SolverScratch& solver, const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool);

// Packs the sorted contacts into blocks of 8 lanes, color by color; for a batch that is cut, only the contacts of this
// rank. Dynamic bodies must have their rows already; bodies that forces do not move, and moving surfaces, get theirs
// here.
void fill_lanes(const SolverScratch& solver, const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool);

// Calls `f(block, bits)` for each block with contacts of bodies whose rows are meant; `bits`: of their lanes.
template <class IsMeant, class F> void for_lanes_of(const LaneLists& lanes, IsMeant&& is_meant, F&& f) {
    for (std::size_t begin = 0; begin < lanes.record.size(); begin += 8) {
        std::uint8_t bits = 0;
        for (std::size_t lane = begin; lane < begin + 8; ++lane)
            if (lanes.record[lane] >= 0 && (is_meant(lanes.row_a[lane]) || is_meant(lanes.row_b[lane])))
                bits = std::uint8_t(bits | 1u << (lane - begin));
        if (bits != 0) f(begin / 8, bits);
    }
}

} // namespace cairn
