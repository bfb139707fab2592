// Vectors, quaternions and symmetric matrices of 8 lanes each.
#pragma once

#include "simd/f32x8.h"

namespace cairn::CAIRN_ISA {

struct Vec3x8 {
    f32x8 x, y, z;
};
struct Quatx8 {
    Vec3x8 v;
    f32x8 w;
};
struct Sym3x8 {
    f32x8 xx, xy, xz, yy, yz, zz;
};
struct Mat3x8 {
    Vec3x8 c0, c1, c2;
}; // columns

CAIRN_INLINE Vec3x8 operator+(Vec3x8 a, Vec3x8 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
CAIRN_INLINE Vec3x8 operator-(Vec3x8 a, Vec3x8 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
CAIRN_INLINE Vec3x8 operator-(Vec3x8 a) { return {-a.x, -a.y, -a.z}; }
CAIRN_INLINE Vec3x8 operator*(f32x8 s, Vec3x8 a) { return {s * a.x, s * a.y, s * a.z}; }
CAIRN_INLINE f32x8 dot(Vec3x8 a, Vec3x8 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
CAIRN_INLINE Vec3x8 cross(Vec3x8 a, Vec3x8 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
CAIRN_INLINE Vec3x8 operator*(const Sym3x8& m, Vec3x8 b) {
    return {m.xx * b.x + (m.xy * b.y + m.xz * b.z), m.xy * b.x + (m.yy * b.y + m.yz * b.z),
            m.xz * b.x + (m.yz * b.y + m.zz * b.z)};
}
CAIRN_INLINE Vec3x8 select(mask8 m, Vec3x8 a, Vec3x8 b) {
    return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}
CAIRN_INLINE Sym3x8 select(mask8 m, const Sym3x8& a, const Sym3x8& b) {
    return {select(m, a.xx, b.xx), select(m, a.xy, b.xy), select(m, a.xz, b.xz),
            select(m, a.yy, b.yy), select(m, a.yz, b.yz), select(m, a.zz, b.zz)};
}
CAIRN_INLINE Vec3x8 zero3() { return {zero(), zero(), zero()}; }

// Loads and stores of structure-of-arrays members: float name[3][8], float name[6][8] and float name[9][8].
CAIRN_INLINE Vec3x8 load3(const float (*p)[8]) { return {load(p[0]), load(p[1]), load(p[2])}; }
CAIRN_INLINE void store3(float (*p)[8], Vec3x8 a) {
    store(p[0], a.x);
    store(p[1], a.y);
    store(p[2], a.z);
}
CAIRN_INLINE Sym3x8 load6(const float (*p)[8]) {
    return {load(p[0]), load(p[1]), load(p[2]), load(p[3]), load(p[4]), load(p[5])};
}
CAIRN_INLINE void store6(float (*p)[8], const Sym3x8& m) {
    store(p[0], m.xx);
    store(p[1], m.xy);
    store(p[2], m.xz);
    store(p[3], m.yy);
    store(p[4], m.yz);
    store(p[5], m.zz);
}

CAIRN_INLINE Mat3x8 load9(const float (*p)[8]) { return {load3(p), load3(p + 3), load3(p + 6)}; }
CAIRN_INLINE void store9(float (*p)[8], const Mat3x8& m) {
    store3(p, m.c0);
    store3(p + 3, m.c1);
    store3(p + 6, m.c2);
}

// R(q) - 1 for unit quaternions, which has no cancellation; and R(q).
CAIRN_INLINE Mat3x8 turn_of(Quatx8 q) {
    const f32x8 x2 = q.v.x + q.v.x, y2 = q.v.y + q.v.y, z2 = q.v.z + q.v.z;
    const f32x8 xx = q.v.x * x2, yy = q.v.y * y2, zz = q.v.z * z2;
    const f32x8 xy = q.v.x * y2, xz = q.v.x * z2, yz = q.v.y * z2;
    const f32x8 wx = q.w * x2, wy = q.w * y2, wz = q.w * z2;
    return {{-(yy + zz), xy + wz, xz - wy}, {xy - wz, -(xx + zz), yz + wx}, {xz + wy, yz - wx, -(xx + yy)}};
}
CAIRN_INLINE Mat3x8 to_matrix(Quatx8 q) {
    Mat3x8 m = turn_of(q);
    m.c0.x = one() + m.c0.x, m.c1.y = one() + m.c1.y, m.c2.z = one() + m.c2.z;
    return m;
}
CAIRN_INLINE Mat3x8 operator+(const Mat3x8& a, const Mat3x8& b) { return {a.c0 + b.c0, a.c1 + b.c1, a.c2 + b.c2}; }
CAIRN_INLINE Mat3x8 operator*(f32x8 s, const Mat3x8& m) { return {s * m.c0, s * m.c1, s * m.c2}; }
CAIRN_INLINE Vec3x8 operator*(const Mat3x8& m, Vec3x8 b) { return b.x * m.c0 + (b.y * m.c1 + b.z * m.c2); }
CAIRN_INLINE Vec3x8 transposed_times(const Mat3x8& m, Vec3x8 v) { return {dot(m.c0, v), dot(m.c1, v), dot(m.c2, v)}; }
// R(q) v and R(q)^T v.
CAIRN_INLINE Vec3x8 rotate(Quatx8 q, Vec3x8 v) {
    const Vec3x8 t = splat(2.0f) * cross(q.v, v);
    return v + q.w * t + cross(q.v, t);
}
CAIRN_INLINE Vec3x8 rotate_back(Quatx8 q, Vec3x8 v) {
    const Vec3x8 t = splat(2.0f) * cross(q.v, v);
    return v - q.w * t + cross(q.v, t);
}

} // namespace cairn::CAIRN_ISA
