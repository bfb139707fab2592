// Vectors of four doubles, for the few kernels that need double precision: as in f32x8.h, every operation is one
// IEEE-754 operation per lane, in the order written.
#pragma once

#include "simd/f32x8.h"

namespace cairn::CAIRN_ISA {

using f64x4 = double __attribute__((vector_size(32)));
using mask4 = long long __attribute__((vector_size(32))); // all bits of a lane are set, or none

CAIRN_INLINE f64x4 splat4(double s) { return f64x4{s, s, s, s}; }
CAIRN_INLINE f64x4 load4(const double* p) {
    f64x4 v;
    std::memcpy(&v, p, sizeof v);
    return v;
}
CAIRN_INLINE f64x4 load4(const float* p) {
    float __attribute__((vector_size(16))) v;
    std::memcpy(&v, p, sizeof v);
    return __builtin_convertvector(v, f64x4);
}
CAIRN_INLINE void store4(double* p, f64x4 v) { std::memcpy(p, &v, sizeof v); }
CAIRN_INLINE void store4(std::int64_t* p, mask4 v) { std::memcpy(p, &v, sizeof v); }
CAIRN_INLINE f64x4 select(mask4 m, f64x4 a, f64x4 b) { return m ? a : b; }
CAIRN_INLINE f64x4 max(f64x4 a, f64x4 b) { return a > b ? a : b; }
CAIRN_INLINE f64x4 min(f64x4 a, f64x4 b) { return a < b ? a : b; }
CAIRN_INLINE f64x4 abs(f64x4 a) {
    constexpr long long digits = 0x7fffffffffffffffLL; // all bits except the sign
    return reinterpret_cast<f64x4>(reinterpret_cast<mask4>(a) & mask4{digits, digits, digits, digits});
}
#if defined(CAIRN_SIMD_AVX2)
CAIRN_INLINE f64x4 sqrt(f64x4 a) { return reinterpret_cast<f64x4>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(a))); }
#else
CAIRN_INLINE f64x4 sqrt(f64x4 a) {
    return f64x4{__builtin_sqrt(a[0]), __builtin_sqrt(a[1]), __builtin_sqrt(a[2]), __builtin_sqrt(a[3])};
}
#endif

} // namespace cairn::CAIRN_ISA
