// The symbolic part of the direct solver: in which order the rows of a set of joints are eliminated, and which blocks
// of the factor L that fills.
#pragma once

#include "state/direct_sets.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cairn {

// Minimum degree, the lowest number first among equals. Fills `order` with the nodes in their order of elimination.
// Returns false where that takes more than so many blocks or products.
bool make_direct_plan(const std::vector<DirectEnds>& nodes, std::size_t max_blocks, std::size_t max_products,
                      DirectPlan& plan, std::vector<std::uint32_t>& order);

} // namespace cairn
