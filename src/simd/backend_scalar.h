// Scalar backend: arrays of 8 floats and plain loops. The reference that the other backends must match bit by bit.
#pragma once

#include <cmath>

namespace cairn::CAIRN_ISA {

struct f32x8 {
    float v[8];
};
struct mask8 {
    std::uint32_t v[8];
}; // all ones or zero

template <class F> CAIRN_INLINE f32x8 map_lanes(F f) {
    f32x8 r;
    for (int i = 0; i < 8; ++i) r.v[i] = f(i);
    return r;
}
template <class F> CAIRN_INLINE mask8 map_mask(F f) {
    mask8 r;
    for (int i = 0; i < 8; ++i) r.v[i] = f(i) ? ~0u : 0u;
    return r;
}

CAIRN_INLINE f32x8 splat(float s) {
    return map_lanes([=](int) { return s; });
}
CAIRN_INLINE f32x8 load(const float* p) {
    return map_lanes([=](int i) { return p[i]; });
}
CAIRN_INLINE f32x8 load_halves(const float* p) { return load(p); }
CAIRN_INLINE f32x8 load_unaligned(const float* p) { return load(p); }
CAIRN_INLINE void store(float* p, f32x8 a) { std::memcpy(p, a.v, sizeof a.v); }
CAIRN_INLINE f32x8 operator+(f32x8 a, f32x8 b) {
    return map_lanes([&](int i) { return a.v[i] + b.v[i]; });
}
CAIRN_INLINE f32x8 operator-(f32x8 a, f32x8 b) {
    return map_lanes([&](int i) { return a.v[i] - b.v[i]; });
}
CAIRN_INLINE f32x8 operator*(f32x8 a, f32x8 b) {
    return map_lanes([&](int i) { return a.v[i] * b.v[i]; });
}
CAIRN_INLINE f32x8 operator/(f32x8 a, f32x8 b) {
    return map_lanes([&](int i) { return a.v[i] / b.v[i]; });
}
CAIRN_INLINE f32x8 operator-(f32x8 a) {
    return map_lanes([&](int i) { return -a.v[i]; });
}
CAIRN_INLINE mask8 operator<(f32x8 a, f32x8 b) {
    return map_mask([&](int i) { return a.v[i] < b.v[i]; });
}
CAIRN_INLINE mask8 operator>(f32x8 a, f32x8 b) {
    return map_mask([&](int i) { return a.v[i] > b.v[i]; });
}
CAIRN_INLINE mask8 operator<=(f32x8 a, f32x8 b) {
    return map_mask([&](int i) { return a.v[i] <= b.v[i]; });
}
CAIRN_INLINE mask8 operator>=(f32x8 a, f32x8 b) {
    return map_mask([&](int i) { return a.v[i] >= b.v[i]; });
}
CAIRN_INLINE mask8 operator==(f32x8 a, f32x8 b) {
    return map_mask([&](int i) { return a.v[i] == b.v[i]; });
}
CAIRN_INLINE mask8 operator&(mask8 a, mask8 b) {
    return map_mask([&](int i) { return (a.v[i] & b.v[i]) != 0; });
}
CAIRN_INLINE mask8 operator|(mask8 a, mask8 b) {
    return map_mask([&](int i) { return (a.v[i] | b.v[i]) != 0; });
}
CAIRN_INLINE mask8 operator^(mask8 a, mask8 b) {
    return map_mask([&](int i) { return (a.v[i] ^ b.v[i]) != 0; });
}
CAIRN_INLINE mask8 and_not(mask8 a, mask8 b) {
    return map_mask([&](int i) { return (a.v[i] & ~b.v[i]) != 0; });
}
CAIRN_INLINE f32x8 select(mask8 m, f32x8 a, f32x8 b) {
    return map_lanes([&](int i) { return m.v[i] ? a.v[i] : b.v[i]; });
}
CAIRN_INLINE f32x8 abs(f32x8 a) {
    return map_lanes([&](int i) { return __builtin_fabsf(a.v[i]); });
}
CAIRN_INLINE f32x8 sqrt(f32x8 a) {
    return map_lanes([&](int i) { return std::sqrt(a.v[i]); });
}
CAIRN_INLINE f32x8 max(f32x8 a, f32x8 b) {
    return map_lanes([&](int i) { return a.v[i] > b.v[i] ? a.v[i] : b.v[i]; });
}
CAIRN_INLINE f32x8 min(f32x8 a, f32x8 b) {
    return map_lanes([&](int i) { return a.v[i] < b.v[i] ? a.v[i] : b.v[i]; });
}
CAIRN_INLINE int bits(mask8 m) {
    int r = 0;
    for (int i = 0; i < 8; ++i) r |= int(m.v[i] & 1u) << i;
    return r;
}
CAIRN_INLINE mask8 mask_from_bits(int b) {
    return map_mask([=](int i) { return (b >> i & 1) != 0; });
}

CAIRN_INLINE void gather4(const float* const* p, f32x8& a, f32x8& b, f32x8& c, f32x8& d) {
    f32x8* column[4] = {&a, &b, &c, &d};
    for (int k = 0; k < 4; ++k)
        for (int i = 0; i < 8; ++i) column[k]->v[i] = p[i][k];
}
CAIRN_INLINE void scatter4(float* const* p, f32x8 a, f32x8 b, f32x8 c, f32x8 d) {
    const f32x8* column[4] = {&a, &b, &c, &d};
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 4; ++k) p[i][k] = column[k]->v[i];
}

} // namespace cairn::CAIRN_ISA
