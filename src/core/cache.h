// Memory that is read soon.
#pragma once

namespace cairn {

// Asks the cache for the line that holds `p`. A function that does nothing else would be taken for one without effect,
// and calls of it dropped (GCC does so with __builtin_prefetch alone): the empty statement stands for one.
inline void ask_cache(const void* p) {
    __builtin_prefetch(p);
    asm volatile("");
}

} // namespace cairn
