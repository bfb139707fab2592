// 3x3 blocks of doubles in row-major order, for the factorization of joints.
#pragma once

#include "math/vec.h"

namespace cairn::math {

struct Block {
    double m[9] = {};
};

inline Block identity_block() { return {{1, 0, 0, 0, 1, 0, 0, 0, 1}}; }
inline Block to_block(const DSym3& s) { return {{s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz}}; }
// The matrix [r] with [r] v = r x v.
inline Block cross_block(DVec3 r) { return {{0, -r.z, r.y, r.z, 0, -r.x, -r.y, r.x, 0}}; }
// 1 - a a^T.
inline Block across_block(DVec3 a) {
    return {{1 - a.x * a.x, -(a.x * a.y), -(a.x * a.z), -(a.x * a.y), 1 - a.y * a.y, -(a.y * a.z), -(a.x * a.z),
             -(a.y * a.z), 1 - a.z * a.z}};
}
// a a^T.
inline Block outer_block(DVec3 a) {
    return {{a.x * a.x, a.x * a.y, a.x * a.z, a.x * a.y, a.y * a.y, a.y * a.z, a.x * a.z, a.y * a.z, a.z * a.z}};
}
// A block with r as its first row, and zeros.
inline Block row_block(DVec3 r) { return {{r.x, r.y, r.z, 0, 0, 0, 0, 0, 0}}; }

inline Block operator-(const Block& a) {
    Block r;
    for (int i = 0; i < 9; ++i) r.m[i] = -a.m[i];
    return r;
}
inline Block& operator+=(Block& a, const Block& b) {
    for (int i = 0; i < 9; ++i) a.m[i] += b.m[i];
    return a;
}
inline Block operator*(const Block& a, const Block& b) {
    Block r;
    for (int i = 0; i < 9; i += 3)
        for (int j = 0; j < 3; ++j) r.m[i + j] = a.m[i] * b.m[j] + (a.m[i + 1] * b.m[3 + j] + a.m[i + 2] * b.m[6 + j]);
    return r;
}
inline Block operator*(double s, const Block& a) {
    Block r;
    for (int i = 0; i < 9; ++i) r.m[i] = s * a.m[i];
    return r;
}
// a b^T.
inline Block times_transposed(const Block& a, const Block& b) {
    Block r;
    for (int i = 0; i < 9; i += 3)
        for (int j = 0; j < 9; j += 3)
            r.m[i + j / 3] = a.m[i] * b.m[j] + (a.m[i + 1] * b.m[j + 1] + a.m[i + 2] * b.m[j + 2]);
    return r;
}
inline void subtract_times_transposed(Block& t, const Block& a, const Block& b) {
    for (int i = 0; i < 9; i += 3)
        for (int j = 0; j < 9; j += 3)
            t.m[i + j / 3] -= a.m[i] * b.m[j] + (a.m[i + 1] * b.m[j + 1] + a.m[i + 2] * b.m[j + 2]);
}
inline DVec3 operator*(const Block& a, DVec3 v) {
    return {a.m[0] * v.x + (a.m[1] * v.y + a.m[2] * v.z), a.m[3] * v.x + (a.m[4] * v.y + a.m[5] * v.z),
            a.m[6] * v.x + (a.m[7] * v.y + a.m[8] * v.z)};
}
// a^T v.
inline DVec3 transposed_times(const Block& a, DVec3 v) {
    return {a.m[0] * v.x + (a.m[3] * v.y + a.m[6] * v.z), a.m[1] * v.x + (a.m[4] * v.y + a.m[7] * v.z),
            a.m[2] * v.x + (a.m[5] * v.y + a.m[8] * v.z)};
}

// Inverse of a symmetric positive semidefinite block by L D L^T factorization. A row whose pivot is below `least` times
// the original diagonal entry is redundant, and is left out.
inline Block inverse_of_rows(const Block& k, DVec3 first_diagonal, double least) {
    auto inverse_pivot = [&](double pivot, double first) { return pivot > least * first ? 1 / pivot : 0.0; };
    const double i0 = inverse_pivot(k.m[0], first_diagonal.x), l10 = k.m[3] * i0, l20 = k.m[6] * i0;
    const double i1 = inverse_pivot(k.m[4] - l10 * k.m[3], first_diagonal.y), l21 = (k.m[7] - l20 * k.m[3]) * i1;
    const double left = k.m[8] - (l20 * k.m[6] + l21 * (k.m[7] - l20 * k.m[3]));
    const double i2 = inverse_pivot(left, first_diagonal.z);
    // Rows of L^-1: (1 0 0), (-l10 1 0), (b -l21 1).
    const double b = l10 * l21 - l20;
    const double xy = -(l10 * i1) - b * (l21 * i2), yz = -(l21 * i2);
    return {{i0 + (l10 * (l10 * i1) + b * (b * i2)), xy, b * i2, xy, i1 + l21 * (l21 * i2), yz, b * i2, yz, i2}};
}

// The same inverse, by cofactors if the block is far from singular.
inline Block inverse_of(const Block& k, DVec3 first_diagonal) {
    constexpr double healthy = 1e-7, least = 1e-12;
    const double xx = k.m[4] * k.m[8] - k.m[5] * k.m[7], xy = k.m[2] * k.m[7] - k.m[1] * k.m[8],
                 xz = k.m[1] * k.m[5] - k.m[2] * k.m[4];
    const double determinant = k.m[0] * xx + (k.m[3] * xy + k.m[6] * xz);
    if (!(k.m[0] > healthy * first_diagonal.x && k.m[4] > healthy * first_diagonal.y &&
          k.m[8] > healthy * first_diagonal.z && determinant > healthy * (k.m[0] * (k.m[4] * k.m[8]))))
        return inverse_of_rows(k, first_diagonal, least);
    const double s = 1 / determinant;
    const double yy = k.m[0] * k.m[8] - k.m[2] * k.m[6], yz = k.m[2] * k.m[3] - k.m[0] * k.m[5],
                 zz = k.m[0] * k.m[4] - k.m[1] * k.m[3];
    return {{s * xx, s * xy, s * xz, s * xy, s * yy, s * yz, s * xz, s * yz, s * zz}};
}

} // namespace cairn::math
