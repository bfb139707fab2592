// The symbolic part of the direct solver: the elimination order of the rows of a set of joints, and the blocks of the
// factor L that fill in.
#pragma once

#include "state/direct_sets.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cairn {

// Minimum-degree ordering, with the lowest number first among equals. Fills `order` with the nodes in their order of
// elimination. Returns false if more than `max_blocks` blocks or `max_products` products of blocks are needed.
bool make_direct_plan(const std::vector<DirectEnds>& nodes, std::size_t max_blocks, std::size_t max_products,
                      DirectPlan& plan, std::vector<std::uint32_t>& order);

} // namespace cairn
