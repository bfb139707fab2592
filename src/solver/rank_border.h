// Where the parts of a batch that is cut meet (solver/rank_cut.h): which ranks need which bodies, and what they tell
// each other after each color.
#pragma once

#include "solver/rank_cut.h"

#include <span>

namespace cairn {

// Finds the bodies that other ranks than their own need, and lists the messages of a batch by bodies.
void find_border(const Bodies& bodies, const IslandBatch& batch, const SolverScratch& solver, RankBorder& border);

// Whether this rank needs the body: its own, and ghosts.
bool is_needed(const RankBorder& border, std::int32_t body);

// Once bodies have their rows.
void number_border_rows(RankBorder& border, const BatchScratch& scratch);

// After the contacts of a color have been solved: the rows of the bodies that they changed, of these arrays.
void exchange_border(RankBorder& border, Communicator& ranks, std::size_t color, std::span<void* const> arrays);

} // namespace cairn
