// Picks the kernel table once, at start-up.
#include "kernels/kernels.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace cairn {

#define CAIRN_DECLARE_TABLE(isa)                                                                                       \
    namespace isa {                                                                                                    \
    extern const KernelTable table;                                                                                    \
    }
#ifdef CAIRN_HAS_SCALAR
CAIRN_DECLARE_TABLE(scalar)
#endif
#ifdef CAIRN_HAS_SSE2
CAIRN_DECLARE_TABLE(sse2)
#endif
#ifdef CAIRN_HAS_AVX2
CAIRN_DECLARE_TABLE(avx2)
#endif
#ifdef CAIRN_HAS_AVX512
CAIRN_DECLARE_TABLE(avx512)
#endif
#ifdef CAIRN_HAS_NEON
CAIRN_DECLARE_TABLE(neon)
#endif
#ifdef CAIRN_HAS_SIMD128
CAIRN_DECLARE_TABLE(simd128)
#endif

namespace {

// Best first; only those that this machine can run.
const KernelTable* available(int i) noexcept {
    const KernelTable* tables[5] = {};
    int count = 0;
#ifdef CAIRN_HAS_AVX512
    if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
        tables[count++] = &avx512::table;
#endif
#ifdef CAIRN_HAS_AVX2
    if (__builtin_cpu_supports("avx2")) tables[count++] = &avx2::table;
#endif
#ifdef CAIRN_HAS_SSE2
    tables[count++] = &sse2::table;
#endif
#ifdef CAIRN_HAS_NEON
    tables[count++] = &neon::table;
#endif
#ifdef CAIRN_HAS_SIMD128
    tables[count++] = &simd128::table;
#endif
#ifdef CAIRN_HAS_SCALAR
    tables[count++] = &scalar::table;
#endif
    return i < count ? tables[i] : nullptr;
}

const KernelTable& choose() noexcept {
    const char* wanted = std::getenv("CAIRN_ISA");
    const KernelTable* const table = wanted && *wanted ? kernels_named(wanted) : available(0);
    if (table) return *table;
    std::fprintf(stderr, "cairn: CAIRN_ISA=%s is not available here; the choices are", wanted ? wanted : "");
    for (int i = 0; available(i); ++i) std::fprintf(stderr, " %s", available(i)->name);
    std::fprintf(stderr, "\n");
    std::exit(2);
}

} // namespace

const KernelTable* kernels_named(const char* name) noexcept {
    for (int i = 0; const KernelTable* table = available(i); ++i)
        if (std::strcmp(table->name, name) == 0) return table;
    return nullptr;
}

const KernelTable& kernels() noexcept {
    static const KernelTable& table = choose();
    return table;
}

} // namespace cairn
