// How often this program has allocated memory. Link allocation_count.cpp, which replaces the global operator new.
#pragma once

#include <cstddef>

namespace cairn {

std::size_t allocation_count();

} // namespace cairn
