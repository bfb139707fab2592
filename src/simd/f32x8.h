// One logical width, 8 floats, on every machine: f32x8 and mask8 with ordinary operators, so that a kernel
// reads like the scalar formula. Every operation is one IEEE-754 operation per lane, in the order written, so
// all backends give the same bits. There are no fused, approximate or cross-lane operations.
//
// A kernel translation unit is compiled once per instruction set with CAIRN_ISA set to its name and one of
// CAIRN_SIMD_AVX2, CAIRN_SIMD_PAIR, CAIRN_SIMD_SCALAR defined. Everything lives in a namespace of that name,
// so no code compiled for one instruction set can be linked into another.
#pragma once

#include <cstdint>
#include <cstring>

#if defined(CAIRN_SIMD_SCALAR)
#define CAIRN_INLINE static inline // the compiler decides: with all loops inlined, gcc takes ten times as long
#else
#define CAIRN_INLINE static inline __attribute__((always_inline))
#endif

#if defined(CAIRN_SIMD_AVX2)
#include "simd/backend_avx2.h"
#elif defined(CAIRN_SIMD_PAIR)
#include "simd/backend_pair.h"
#elif defined(CAIRN_SIMD_SCALAR)
#include "simd/backend_scalar.h"
#else
#error "define CAIRN_SIMD_AVX2, CAIRN_SIMD_PAIR or CAIRN_SIMD_SCALAR for a kernel translation unit"
#endif

namespace cairn::CAIRN_ISA {

CAIRN_INLINE f32x8& operator+=(f32x8& a, f32x8 b) { return a = a + b; }
CAIRN_INLINE f32x8& operator-=(f32x8& a, f32x8 b) { return a = a - b; }
CAIRN_INLINE f32x8& operator*=(f32x8& a, f32x8 b) { return a = a * b; }

// a > b ? a : b, lane by lane: the second operand where the comparison fails, as for +0 against -0.
// (Backends define max and min so; they must never see NaN.)
CAIRN_INLINE f32x8 clamp(f32x8 x, f32x8 low, f32x8 high) { return min(max(x, low), high); }

CAIRN_INLINE bool any(mask8 m) { return bits(m) != 0; }
CAIRN_INLINE bool all(mask8 m) { return bits(m) == 255; }

CAIRN_INLINE f32x8 zero() { return splat(0.0f); }
CAIRN_INLINE f32x8 one() { return splat(1.0f); }

} // namespace cairn::CAIRN_ISA
