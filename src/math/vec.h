// Vectors, quaternions and matrices of scalars. Plain IEEE operations in the order written, so that results are the
// same on every compiler and machine (GLM's functions do not guarantee this).
#pragma once

#include <cmath>

namespace cairn::math {

template <class T> struct TVec3 {
    T x = 0, y = 0, z = 0;
    constexpr T& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
    constexpr T operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
};
using Vec3 = TVec3<float>;
using DVec3 = TVec3<double>;

template <class T> constexpr TVec3<T> operator+(TVec3<T> a, TVec3<T> b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
template <class T> constexpr TVec3<T> operator-(TVec3<T> a, TVec3<T> b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
template <class T> constexpr TVec3<T> operator-(TVec3<T> a) { return {-a.x, -a.y, -a.z}; }
template <class T> constexpr TVec3<T> operator*(T s, TVec3<T> a) { return {s * a.x, s * a.y, s * a.z}; }
template <class T> constexpr TVec3<T>& operator+=(TVec3<T>& a, TVec3<T> b) { return a = a + b; }
template <class T> constexpr TVec3<T>& operator-=(TVec3<T>& a, TVec3<T> b) { return a = a - b; }
template <class T> constexpr bool operator==(TVec3<T> a, TVec3<T> b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
template <class T> constexpr T dot(TVec3<T> a, TVec3<T> b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <class T> constexpr TVec3<T> cross(TVec3<T> a, TVec3<T> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T> constexpr TVec3<T> scaled(TVec3<T> a, TVec3<T> b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
template <class T> T length(TVec3<T> a) { return std::sqrt(dot(a, a)); }
template <class T> TVec3<T> normalized(TVec3<T> a) { return (T(1) / length(a)) * a; }
template <class T> constexpr TVec3<T> min(TVec3<T> a, TVec3<T> b) {
    return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z};
}
template <class T> constexpr TVec3<T> max(TVec3<T> a, TVec3<T> b) {
    return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z};
}
template <class T> inline TVec3<T> abs(TVec3<T> a) { return {std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}; }
constexpr DVec3 to_double(Vec3 a) { return {a.x, a.y, a.z}; }
constexpr Vec3 to_float(DVec3 a) { return {float(a.x), float(a.y), float(a.z)}; }

// Conversions from and to three consecutive floats.
inline Vec3 to_vec(const float* p) { return {p[0], p[1], p[2]}; }
inline void put(float* p, Vec3 v) { p[0] = v.x, p[1] = v.y, p[2] = v.z; }

// A unit vector orthogonal to the unit vector n.
inline Vec3 any_orthogonal(Vec3 n) {
    const Vec3 axis = std::fabs(n.x) < 0.5f ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    return normalized(cross(axis, n));
}

template <class T> struct TQuat {
    T x = 0, y = 0, z = 0, w = 1;
    constexpr TVec3<T> vector() const { return {x, y, z}; }
};
using Quat = TQuat<float>;
using DQuat = TQuat<double>;

template <class T> constexpr TQuat<T> operator*(TQuat<T> a, TQuat<T> b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
template <class T> constexpr TQuat<T> conjugate(TQuat<T> q) { return {-q.x, -q.y, -q.z, q.w}; }
template <class T> TQuat<T> normalized(TQuat<T> q) {
    const T s = T(1) / std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    return {q.x * s, q.y * s, q.z * s, q.w * s};
}
template <class T> constexpr TVec3<T> rotate(TQuat<T> q, TVec3<T> v) {
    const TVec3<T> t = T(2) * cross(q.vector(), v);
    return v + q.w * t + cross(q.vector(), t);
}
template <class T> constexpr TVec3<T> rotate_back(TQuat<T> q, TVec3<T> v) { return rotate(conjugate(q), v); }
constexpr DQuat to_double(Quat q) { return {q.x, q.y, q.z, q.w}; }
constexpr Quat to_float(DQuat q) { return {float(q.x), float(q.y), float(q.z), float(q.w)}; }

// Symmetric 3x3 matrix.
template <class T> struct TSym3 { T xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0; };
using Sym3 = TSym3<float>;
using DSym3 = TSym3<double>;

template <class T> constexpr TSym3<T> operator+(const TSym3<T>& a, const TSym3<T>& b) {
    return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
}
template <class T> constexpr TVec3<T> operator*(const TSym3<T>& m, TVec3<T> v) {
    return {m.xx * v.x + (m.xy * v.y + m.xz * v.z), m.xy * v.x + (m.yy * v.y + m.yz * v.z),
            m.xz * v.x + (m.yz * v.y + m.zz * v.z)};
}

template <class T> struct TMat3 { // columns
    TVec3<T> c0{1, 0, 0}, c1{0, 1, 0}, c2{0, 0, 1};
    constexpr const TVec3<T>& column(int i) const { return i == 0 ? c0 : i == 1 ? c1 : c2; }
};
using Mat3 = TMat3<float>;
using DMat3 = TMat3<double>;

template <class T> constexpr TMat3<T> to_matrix(TQuat<T> q) {
    const T x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
    const T xx = q.x * x2, yy = q.y * y2, zz = q.z * z2, xy = q.x * y2, xz = q.x * z2, yz = q.y * z2;
    const T wx = q.w * x2, wy = q.w * y2, wz = q.w * z2;
    return {{1 - (yy + zz), xy + wz, xz - wy}, {xy - wz, 1 - (xx + zz), yz + wx}, {xz + wy, yz - wx, 1 - (xx + yy)}};
}
template <class T> constexpr TVec3<T> operator*(const TMat3<T>& m, TVec3<T> v) {
    return v.x * m.c0 + v.y * m.c1 + v.z * m.c2;
}
// R diag(d) R^T.
template <class T> constexpr TSym3<T> rotated_diagonal(const TMat3<T>& r, TVec3<T> d) {
    const TVec3<T> a = d.x * r.c0, b = d.y * r.c1, c = d.z * r.c2;
    auto entry = [&](int i, int j) { return a[i] * r.c0[j] + b[i] * r.c1[j] + c[i] * r.c2[j]; };
    return {entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
}

template <class T> bool is_finite(TVec3<T> v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
template <class T> bool is_finite(TQuat<T> q) {
    return std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z) && std::isfinite(q.w);
}

} // namespace cairn::math
