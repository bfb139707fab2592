// SSE2, NEON and WASM SIMD128 backend: a pair of 16-byte compiler vectors. Only square roots, mask bits and selections
// need intrinsics. (32-byte compiler vectors would be three to five times slower with gcc 12 on SSE2.)
#pragma once

#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

namespace cairn::CAIRN_ISA {

using f32x4 = float __attribute__((vector_size(16)));
using i32x4 = std::int32_t __attribute__((vector_size(16)));

struct f32x8 {
    f32x4 a, b;
};
struct mask8 {
    i32x4 a, b;
};

CAIRN_INLINE f32x4 sqrt_half(f32x4 x) {
#if defined(__SSE2__)
    return (f32x4)_mm_sqrt_ps((__m128)x);
#elif defined(__wasm_simd128__)
    return (f32x4)wasm_f32x4_sqrt((v128_t)x);
#else
    return f32x4{__builtin_sqrtf(x[0]), __builtin_sqrtf(x[1]), __builtin_sqrtf(x[2]), __builtin_sqrtf(x[3])};
#endif
}
CAIRN_INLINE int bits_half(i32x4 m) {
#if defined(__SSE2__)
    return _mm_movemask_ps((__m128)m);
#elif defined(__wasm_simd128__)
    return int(wasm_i32x4_bitmask((v128_t)m));
#else
    return (m[0] & 1) | (m[1] & 2) | (m[2] & 4) | (m[3] & 8);
#endif
}
CAIRN_INLINE f32x4 select_half(i32x4 m, f32x4 x, f32x4 y) {
#if defined(__wasm_simd128__)
    return (f32x4)wasm_v128_bitselect((v128_t)x, (v128_t)y, (v128_t)m);
#else
    return (f32x4)((m & (i32x4)x) | (~m & (i32x4)y));
#endif
}

CAIRN_INLINE f32x8 splat(float s) {
    const f32x4 t = {s, s, s, s};
    return {t, t};
}
CAIRN_INLINE f32x8 load(const float* p) { return {*(const f32x4*)p, *(const f32x4*)(p + 4)}; }
CAIRN_INLINE f32x8 load_halves(const float* p) { return load(p); }
CAIRN_INLINE f32x8 load_unaligned(const float* p) {
    f32x8 r;
    std::memcpy(&r.a, p, 16);
    std::memcpy(&r.b, p + 4, 16);
    return r;
}
CAIRN_INLINE void store(float* p, f32x8 x) {
    *(f32x4*)p = x.a;
    *(f32x4*)(p + 4) = x.b;
}
CAIRN_INLINE f32x8 operator+(f32x8 x, f32x8 y) { return {x.a + y.a, x.b + y.b}; }
CAIRN_INLINE f32x8 operator-(f32x8 x, f32x8 y) { return {x.a - y.a, x.b - y.b}; }
CAIRN_INLINE f32x8 operator*(f32x8 x, f32x8 y) { return {x.a * y.a, x.b * y.b}; }
CAIRN_INLINE f32x8 operator/(f32x8 x, f32x8 y) { return {x.a / y.a, x.b / y.b}; }
CAIRN_INLINE f32x8 operator-(f32x8 x) {
    const i32x4 s = {INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN};
    return {(f32x4)((i32x4)x.a ^ s), (f32x4)((i32x4)x.b ^ s)};
}
CAIRN_INLINE mask8 operator<(f32x8 x, f32x8 y) { return {(i32x4)(x.a < y.a), (i32x4)(x.b < y.b)}; }
CAIRN_INLINE mask8 operator>(f32x8 x, f32x8 y) { return {(i32x4)(x.a > y.a), (i32x4)(x.b > y.b)}; }
CAIRN_INLINE mask8 operator<=(f32x8 x, f32x8 y) { return {(i32x4)(x.a <= y.a), (i32x4)(x.b <= y.b)}; }
CAIRN_INLINE mask8 operator>=(f32x8 x, f32x8 y) { return {(i32x4)(x.a >= y.a), (i32x4)(x.b >= y.b)}; }
CAIRN_INLINE mask8 operator==(f32x8 x, f32x8 y) { return {(i32x4)(x.a == y.a), (i32x4)(x.b == y.b)}; }
CAIRN_INLINE mask8 operator&(mask8 x, mask8 y) { return {x.a & y.a, x.b & y.b}; }
CAIRN_INLINE mask8 operator|(mask8 x, mask8 y) { return {x.a | y.a, x.b | y.b}; }
CAIRN_INLINE mask8 operator^(mask8 x, mask8 y) { return {x.a ^ y.a, x.b ^ y.b}; }
CAIRN_INLINE mask8 and_not(mask8 x, mask8 y) { return {x.a & ~y.a, x.b & ~y.b}; }
CAIRN_INLINE f32x8 select(mask8 m, f32x8 x, f32x8 y) {
    return {select_half(m.a, x.a, y.a), select_half(m.b, x.b, y.b)};
}
CAIRN_INLINE f32x8 abs(f32x8 x) {
    const i32x4 s = {INT32_MAX, INT32_MAX, INT32_MAX, INT32_MAX};
    return {(f32x4)((i32x4)x.a & s), (f32x4)((i32x4)x.b & s)};
}
CAIRN_INLINE f32x8 sqrt(f32x8 x) { return {sqrt_half(x.a), sqrt_half(x.b)}; }
#if defined(__wasm_simd128__) // the same selection in one instruction, also for NaN and zeros
CAIRN_INLINE f32x8 max(f32x8 x, f32x8 y) {
    return {(f32x4)wasm_f32x4_pmax((v128_t)y.a, (v128_t)x.a), (f32x4)wasm_f32x4_pmax((v128_t)y.b, (v128_t)x.b)};
}
CAIRN_INLINE f32x8 min(f32x8 x, f32x8 y) {
    return {(f32x4)wasm_f32x4_pmin((v128_t)y.a, (v128_t)x.a), (f32x4)wasm_f32x4_pmin((v128_t)y.b, (v128_t)x.b)};
}
#else
CAIRN_INLINE f32x8 max(f32x8 x, f32x8 y) { return select(x > y, x, y); }
CAIRN_INLINE f32x8 min(f32x8 x, f32x8 y) { return select(x < y, x, y); }
#endif
CAIRN_INLINE int bits(mask8 m) { return bits_half(m.a) | (bits_half(m.b) << 4); }
CAIRN_INLINE mask8 mask_from_bits(int b) {
    const i32x4 low = {1, 2, 4, 8}, high = {16, 32, 64, 128}, all = {b, b, b, b};
    return {(i32x4)((all & low) == low), (i32x4)((all & high) == high)};
}

// Shuffles lanes of x (0 to 3) and y (4 to 7). In WebAssembly by an intrinsic, which is opaque to the compiler:
// otherwise it replaces unused lanes by lane 0, and then engines do not recognize that one instruction of the processor
// suffices.
template <int A, int B, int C, int D> CAIRN_INLINE f32x4 lanes_of(f32x4 x, f32x4 y) {
#if defined(__wasm_simd128__)
    return (f32x4)wasm_i32x4_shuffle((v128_t)x, (v128_t)y, A, B, C, D);
#else
    return __builtin_shufflevector(x, y, A, B, C, D);
#endif
}
CAIRN_INLINE void transpose4(f32x4& a, f32x4& b, f32x4& c, f32x4& d) {
    const f32x4 t0 = lanes_of<0, 4, 1, 5>(a, b), t1 = lanes_of<2, 6, 3, 7>(a, b);
    const f32x4 t2 = lanes_of<0, 4, 1, 5>(c, d), t3 = lanes_of<2, 6, 3, 7>(c, d);
    a = lanes_of<0, 1, 4, 5>(t0, t2);
    b = lanes_of<2, 3, 6, 7>(t0, t2);
    c = lanes_of<0, 1, 4, 5>(t1, t3);
    d = lanes_of<2, 3, 6, 7>(t1, t3);
}
// Transposes rows of 4 floats (16-byte aligned) at p[0..7] to 4 columns of 8 lanes, and back.
CAIRN_INLINE void gather4(const float* const* p, f32x8& x, f32x8& y, f32x8& z, f32x8& w) {
    f32x4 a = *(const f32x4*)p[0], b = *(const f32x4*)p[1], c = *(const f32x4*)p[2], d = *(const f32x4*)p[3];
    f32x4 e = *(const f32x4*)p[4], f = *(const f32x4*)p[5], g = *(const f32x4*)p[6], h = *(const f32x4*)p[7];
    transpose4(a, b, c, d);
    transpose4(e, f, g, h);
    x = {a, e};
    y = {b, f};
    z = {c, g};
    w = {d, h};
}
CAIRN_INLINE void scatter4(float* const* p, f32x8 x, f32x8 y, f32x8 z, f32x8 w) {
    f32x4 a = x.a, b = y.a, c = z.a, d = w.a, e = x.b, f = y.b, g = z.b, h = w.b;
    transpose4(a, b, c, d);
    transpose4(e, f, g, h);
    *(f32x4*)p[0] = a;
    *(f32x4*)p[1] = b;
    *(f32x4*)p[2] = c;
    *(f32x4*)p[3] = d;
    *(f32x4*)p[4] = e;
    *(f32x4*)p[5] = f;
    *(f32x4*)p[6] = g;
    *(f32x4*)p[7] = h;
}

} // namespace cairn::CAIRN_ISA
