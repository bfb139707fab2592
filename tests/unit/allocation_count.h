// Counts the allocations of this program, and simulates memory exhaustion. Link allocation_count.cpp, which replaces
// the global operator new.
#pragma once

#include <cstddef>

namespace cairn {

std::size_t allocation_count();

// From now on `count` allocations succeed and the next one throws std::bad_alloc; then all succeed again.
void fail_allocation_after(std::size_t count);
// Cancels the pending failure; returns whether an allocation has failed since fail_allocation_after.
bool stop_failing();

} // namespace cairn
