// Prefetching of memory that is read soon.
#pragma once

namespace cairn {

// Prefetches the cache line that contains `p`. A compiler may treat a function that only prefetches as one without
// effect, and drop calls of it (GCC does so with __builtin_prefetch alone): the empty asm statement counts as an
// effect.
inline void prefetch(const void* p) {
    __builtin_prefetch(p);
    asm volatile("");
}

} // namespace cairn
