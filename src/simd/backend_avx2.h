// AVX2 backend: one 256-bit register per vector. With AVX-512 (CAIRN_SIMD_AVX512) there are 32 registers, and masks
// have registers of their own.
#pragma once

#include <immintrin.h>

namespace cairn::CAIRN_ISA {

struct f32x8 {
    __m256 v;
};
struct mask8 {
#if defined(CAIRN_SIMD_AVX512)
    __mmask8 v;
#else
    __m256 v;
#endif
};

CAIRN_INLINE f32x8 splat(float s) { return {_mm256_set1_ps(s)}; }
CAIRN_INLINE f32x8 load(const float* p) { return {_mm256_load_ps(p)}; }
CAIRN_INLINE f32x8 load_unaligned(const float* p) { return {_mm256_loadu_ps(p)}; }
// Loads two halves separately, for data that may just have been stored as halves: a processor cannot forward two
// pending stores to one load.
CAIRN_INLINE f32x8 load_halves(const float* p) {
    __m128 low = _mm_load_ps(p), high = _mm_load_ps(p + 4);
    __asm__("" : "+x"(low)); // prevents the compiler from merging the loads
    return {_mm256_insertf128_ps(_mm256_castps128_ps256(low), high, 1)};
}
CAIRN_INLINE void store(float* p, f32x8 a) { _mm256_store_ps(p, a.v); }
CAIRN_INLINE f32x8 operator+(f32x8 a, f32x8 b) { return {_mm256_add_ps(a.v, b.v)}; }
CAIRN_INLINE f32x8 operator-(f32x8 a, f32x8 b) { return {_mm256_sub_ps(a.v, b.v)}; }
CAIRN_INLINE f32x8 operator*(f32x8 a, f32x8 b) { return {_mm256_mul_ps(a.v, b.v)}; }
CAIRN_INLINE f32x8 operator/(f32x8 a, f32x8 b) { return {_mm256_div_ps(a.v, b.v)}; }
CAIRN_INLINE f32x8 operator-(f32x8 a) { return {_mm256_xor_ps(a.v, _mm256_set1_ps(-0.0f))}; }
CAIRN_INLINE f32x8 abs(f32x8 a) { return {_mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v)}; }
CAIRN_INLINE f32x8 sqrt(f32x8 a) { return {_mm256_sqrt_ps(a.v)}; }
CAIRN_INLINE f32x8 max(f32x8 a, f32x8 b) { return {_mm256_max_ps(a.v, b.v)}; }
CAIRN_INLINE f32x8 min(f32x8 a, f32x8 b) { return {_mm256_min_ps(a.v, b.v)}; }
#if defined(CAIRN_SIMD_AVX512)
CAIRN_INLINE mask8 operator<(f32x8 a, f32x8 b) { return {_mm256_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ)}; }
CAIRN_INLINE mask8 operator>(f32x8 a, f32x8 b) { return {_mm256_cmp_ps_mask(a.v, b.v, _CMP_GT_OQ)}; }
CAIRN_INLINE mask8 operator<=(f32x8 a, f32x8 b) { return {_mm256_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ)}; }
CAIRN_INLINE mask8 operator>=(f32x8 a, f32x8 b) { return {_mm256_cmp_ps_mask(a.v, b.v, _CMP_GE_OQ)}; }
CAIRN_INLINE mask8 operator==(f32x8 a, f32x8 b) { return {_mm256_cmp_ps_mask(a.v, b.v, _CMP_EQ_OQ)}; }
CAIRN_INLINE mask8 operator&(mask8 a, mask8 b) { return {_kand_mask8(a.v, b.v)}; }
CAIRN_INLINE mask8 operator|(mask8 a, mask8 b) { return {_kor_mask8(a.v, b.v)}; }
CAIRN_INLINE mask8 operator^(mask8 a, mask8 b) { return {_kxor_mask8(a.v, b.v)}; }
CAIRN_INLINE mask8 and_not(mask8 a, mask8 b) { return {_kandn_mask8(b.v, a.v)}; } // a and not b
CAIRN_INLINE f32x8 select(mask8 m, f32x8 a, f32x8 b) { return {_mm256_mask_blend_ps(m.v, b.v, a.v)}; }
CAIRN_INLINE int bits(mask8 m) { return static_cast<int>(_cvtmask8_u32(m.v)); }
CAIRN_INLINE mask8 mask_from_bits(int b) { return {_cvtu32_mask8(static_cast<unsigned>(b) & 255u)}; }
#else
CAIRN_INLINE mask8 operator<(f32x8 a, f32x8 b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)}; }
CAIRN_INLINE mask8 operator>(f32x8 a, f32x8 b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_GT_OQ)}; }
CAIRN_INLINE mask8 operator<=(f32x8 a, f32x8 b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)}; }
CAIRN_INLINE mask8 operator>=(f32x8 a, f32x8 b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_GE_OQ)}; }
CAIRN_INLINE mask8 operator==(f32x8 a, f32x8 b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_EQ_OQ)}; }
CAIRN_INLINE mask8 operator&(mask8 a, mask8 b) { return {_mm256_and_ps(a.v, b.v)}; }
CAIRN_INLINE mask8 operator|(mask8 a, mask8 b) { return {_mm256_or_ps(a.v, b.v)}; }
CAIRN_INLINE mask8 operator^(mask8 a, mask8 b) { return {_mm256_xor_ps(a.v, b.v)}; }
CAIRN_INLINE mask8 and_not(mask8 a, mask8 b) { return {_mm256_andnot_ps(b.v, a.v)}; } // a and not b
CAIRN_INLINE f32x8 select(mask8 m, f32x8 a, f32x8 b) { return {_mm256_blendv_ps(b.v, a.v, m.v)}; }
CAIRN_INLINE int bits(mask8 m) { return _mm256_movemask_ps(m.v); }
CAIRN_INLINE mask8 mask_from_bits(int b) {
    const __m256i bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    return {_mm256_castsi256_ps(_mm256_cmpeq_epi32(_mm256_and_si256(_mm256_set1_epi32(b), bit), bit))};
}
#endif

// Transposes rows of 4 floats (16-byte aligned) at p[0..7] to 4 columns of 8 lanes, and back.
CAIRN_INLINE void gather4(const float* const* p, f32x8& a, f32x8& b, f32x8& c, f32x8& d) {
    auto row = [](const float* low, const float* high) {
        return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(low)), _mm_load_ps(high), 1);
    };
    const __m256 r0 = row(p[0], p[4]), r1 = row(p[1], p[5]), r2 = row(p[2], p[6]), r3 = row(p[3], p[7]);
    const __m256 t0 = _mm256_unpacklo_ps(r0, r1), t2 = _mm256_unpacklo_ps(r2, r3);
    const __m256 t1 = _mm256_unpackhi_ps(r0, r1), t3 = _mm256_unpackhi_ps(r2, r3);
    a.v = _mm256_shuffle_ps(t0, t2, 0x44);
    b.v = _mm256_shuffle_ps(t0, t2, 0xEE);
    c.v = _mm256_shuffle_ps(t1, t3, 0x44);
    d.v = _mm256_shuffle_ps(t1, t3, 0xEE);
}
CAIRN_INLINE void scatter4(float* const* p, f32x8 a, f32x8 b, f32x8 c, f32x8 d) {
    const __m256 t0 = _mm256_unpacklo_ps(a.v, b.v), t1 = _mm256_unpackhi_ps(a.v, b.v);
    const __m256 t2 = _mm256_unpacklo_ps(c.v, d.v), t3 = _mm256_unpackhi_ps(c.v, d.v);
    const __m256 r0 = _mm256_shuffle_ps(t0, t2, 0x44), r1 = _mm256_shuffle_ps(t0, t2, 0xEE);
    const __m256 r2 = _mm256_shuffle_ps(t1, t3, 0x44), r3 = _mm256_shuffle_ps(t1, t3, 0xEE);
    _mm_store_ps(p[0], _mm256_castps256_ps128(r0));
    _mm_store_ps(p[1], _mm256_castps256_ps128(r1));
    _mm_store_ps(p[2], _mm256_castps256_ps128(r2));
    _mm_store_ps(p[3], _mm256_castps256_ps128(r3));
    _mm_store_ps(p[4], _mm256_extractf128_ps(r0, 1));
    _mm_store_ps(p[5], _mm256_extractf128_ps(r1, 1));
    _mm_store_ps(p[6], _mm256_extractf128_ps(r2, 1));
    _mm_store_ps(p[7], _mm256_extractf128_ps(r3, 1));
}

} // namespace cairn::CAIRN_ISA
