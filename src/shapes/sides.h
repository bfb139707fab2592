// Sides of flat convex polygons in coordinates of their own plane, tested four at a time.
#pragma once

#include "math/vec.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace cairn {

namespace sides {

using D2 = double __attribute__((vector_size(16)));
using I2 = long long __attribute__((vector_size(16)));
inline D2 load(const double* p) {
    D2 v;
    std::memcpy(&v, p, sizeof v);
    return v;
}
inline void store(double* p, D2 v) { std::memcpy(p, &v, sizeof v); }
inline D2 splat(double s) { return D2{s, s}; }
inline D2 square_root(D2 v) {
#if defined(__SSE2__)
    return reinterpret_cast<D2>(_mm_sqrt_pd(reinterpret_cast<__m128d>(v)));
#else
    return D2{std::sqrt(v[0]), std::sqrt(v[1])};
#endif
}
inline D2 choose(I2 which, D2 yes, D2 no) {
    return reinterpret_cast<D2>((which & reinterpret_cast<I2>(yes)) | (~which & reinterpret_cast<I2>(no)));
}
// One bit per lane that is negative.
inline unsigned negative(D2 v) {
    const I2 is = v < splat(0);
#if defined(__SSE2__)
    return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(is)));
#else
    return static_cast<unsigned>((is[0] & 1) | (is[1] & 2));
#endif
}

} // namespace sides

// Four corners of a counterclockwise polygon, and the side from each to the next: a point is nx x + ny y + offset
// inside of it, m. Lanes beyond the last corner, where the first is repeated, and sides without length contain every
// point.
struct SideBlock {
    static constexpr std::size_t width = 4;

    double x[width], y[width], nx[width], ny[width], offset[width];

    // Writes how far a point is inside of each side, plus `slack`, m. Returns one bit per side of which it is outside.
    unsigned inside(double px, double py, double slack, double* out) const {
        using namespace sides;
        unsigned outside = 0;
        for (std::size_t k = 0; k < width; k += 2) {
            const D2 v = load(nx + k) * splat(px) + load(ny + k) * splat(py) + (load(offset + k) + splat(slack));
            store(out + k, v);
            outside |= negative(v) << k;
        }
        return outside;
    }
};

// The number of side blocks of a polygon.
constexpr std::size_t blocks_of(std::size_t corners) { return (corners + SideBlock::width - 1) / SideBlock::width; }

// Writes the side blocks of a polygon. The corner arrays must have space for one element more than the blocks hold.
inline void make_sides(double* corner_x, double* corner_y, std::size_t n, SideBlock* out) {
    using namespace sides;
    constexpr std::size_t width = SideBlock::width;
    const std::size_t room = width * blocks_of(n);
    for (std::size_t i = n; i <= room; ++i) corner_x[i] = corner_x[0], corner_y[i] = corner_y[0];
    for (std::size_t i = 0; i < room; i += 2) {
        SideBlock& block = out[i / width];
        const std::size_t k = i % width;
        const D2 x = load(corner_x + i), y = load(corner_y + i);
        const D2 dx = load(corner_x + i + 1) - x, dy = load(corner_y + i + 1) - y, square = dx * dx + dy * dy;
        const D2 s = choose(square > splat(0), splat(1) / square_root(square), splat(0));
        store(block.x + k, x), store(block.y + k, y);
        store(block.nx + k, -s * dy), store(block.ny + k, s * dx);
        store(block.offset + k, choose(s > splat(0), s * (dy * x - dx * y), splat(1e300)));
    }
}

// The direction of a polygon's edge, projected into a plane.
inline math::DVec3 direction_in_plane(math::DVec3 edge, math::DVec3 normal) {
    const math::DVec3 along = edge - math::dot(edge, normal) * normal;
    const double length = math::length(along);
    return length > 0 ? (1 / length) * along : math::to_double(math::any_orthogonal(math::to_float(normal)));
}

} // namespace cairn
