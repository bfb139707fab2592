// How often this program has allocated memory, and memory that runs out. Link
// allocation_count.cpp, which replaces the global operator new.
#pragma once

#include <cstddef>

namespace cairn {

std::size_t allocation_count();

// From now on `count` allocations succeed and the one after them throws std::bad_alloc; then all succeed again.
void fail_allocation_after(std::size_t count);
// Takes that back; whether an allocation has failed since.
bool stop_failing();

} // namespace cairn
