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

struct Choice {
    const KernelTable* table;
    bool runs; // whether this machine's processor can run it
};

// The tables of this build, best first, terminated by null.
Choice choice(int i) noexcept {
    const Choice choices[] = {
#ifdef CAIRN_HAS_AVX512
        {&avx512::table, __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
                             __builtin_cpu_supports("avx512bw")},
#endif
#ifdef CAIRN_HAS_AVX2
        {&avx2::table, bool(__builtin_cpu_supports("avx2"))},
#endif
#ifdef CAIRN_HAS_SSE2
        {&sse2::table, true},
#endif
#ifdef CAIRN_HAS_NEON
        {&neon::table, true},
#endif
#ifdef CAIRN_HAS_SIMD128
        {&simd128::table, true},
#endif
#ifdef CAIRN_HAS_SCALAR
        {&scalar::table, true},
#endif
        {nullptr, false},
    };
    return choices[i];
}

// The best table that this processor can run, with that name if `name` is given; null: there is none.
const KernelTable* find(const char* name) noexcept {
    for (int i = 0; choice(i).table; ++i)
        if (choice(i).runs && (!name || std::strcmp(choice(i).table->name, name) == 0)) return choice(i).table;
    return nullptr;
}

[[noreturn]] void refuse(const char* wanted) noexcept {
    if (wanted)
        std::fprintf(stderr, "cairn: CAIRN_ISA=%s cannot be had:", wanted);
    else
        std::fprintf(stderr, "cairn: no kernels for this processor:");
    std::fprintf(stderr, " this program was built with");
    for (int i = 0; choice(i).table; ++i)
        std::fprintf(stderr, "%s %s%s", i > 0 ? "," : "", choice(i).table->name,
                     choice(i).runs ? "" : " (which this processor lacks)");
    std::fprintf(stderr, ". CMake's CAIRN_KERNELS chooses; left empty, it takes all.\n");
    std::exit(2);
}

const KernelTable& choose() noexcept {
    const char* wanted = std::getenv("CAIRN_ISA");
    if (wanted && !*wanted) wanted = nullptr;
    const KernelTable* const table = find(wanted);
    if (!table) refuse(wanted);
    return *table;
}

} // namespace

const KernelTable* kernels_named(const char* name) noexcept { return find(name); }

const KernelTable& kernels() noexcept {
    static const KernelTable& table = choose();
    return table;
}

} // namespace cairn
