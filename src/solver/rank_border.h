// The border between the parts of a batch that is cut (solver/rank_cut.h): which ranks need which bodies, and the data
// that they exchange after each color.
#pragma once

#include "solver/rank_cut.h"

#include <span>

namespace cairn {

// Finds the bodies that are needed by ranks other than their owners, and lists the messages of a batch, with bodies as
// their entries.
void find_border(const Bodies& bodies, const IslandBatch& batch, const SolverScratch& solver, RankBorder& border);

// Whether this rank needs the body, as its owner or as a ghost.
bool is_needed(const RankBorder& border, std::int32_t body);

// Replaces body indices in the messages by row numbers. Called once bodies have their rows.
void number_border_rows(RankBorder& border, const BatchScratch& scratch);

// Exchanges the rows, in these arrays, of the border bodies that the contacts of a color have changed.
void exchange_border(RankBorder& border, Communicator& ranks, std::size_t color, std::span<void* const> arrays);

} // namespace cairn
