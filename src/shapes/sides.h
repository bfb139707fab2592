// Flat convex polygons in coordinates of their own plane, four sides at a time.
#pragma once

#include "math/vec.h"

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
// A bit for each of the two that is less than 0.
inline unsigned negative(D2 v) {
    const I2 is = v < splat(0);
#if defined(__SSE2__)
    return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(is)));
#else
    return static_cast<unsigned>((is[0] & 1) | (is[1] & 2));
#endif
}

} // namespace sides

struct FlatCorner {
    double x, y;
};

// Four corners of a counterclockwise polygon, and the side from each to the next: a point is nx x + ny y + offset
// inside of it, m. Beyond the last corner, which is repeated, and where sides have no length, they hold everything.
struct SideBlock {
    static constexpr std::size_t width = 4;

    double x[width], y[width], nx[width], ny[width], offset[width];

    // Writes how far a point is inside of each side, plus `slack`. A bit for each side of which it is outside.
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

// Calls add(block) for all sides of a polygon of at least one corner, which has x and y.
template <class Corners, class Add> void make_sides(const Corners& corners, Add&& add) {
    const std::size_t n = corners.size(), width = SideBlock::width;
    for (std::size_t first = 0; first < n; first += width) {
        SideBlock block;
        for (std::size_t k = 0; k < width; ++k) {
            const std::size_t i = first + k < n ? first + k : n - 1;
            const auto &a = corners[i], &b = corners[i + 1 < n ? i + 1 : 0];
            const double dx = b.x - a.x, dy = b.y - a.y, square = first + k < n ? dx * dx + dy * dy : 0;
            const double s = square > 0 ? 1 / std::sqrt(square) : 0;
            block.x[k] = a.x, block.y[k] = a.y;
            block.nx[k] = -s * dy, block.ny[k] = s * dx;
            block.offset[k] = s > 0 ? s * (dy * a.x - dx * a.y) : 1e300;
        }
        add(block);
    }
}

// A direction along a plane: that of a polygon's edge, as far as it lies in the plane.
inline math::DVec3 direction_in_plane(math::DVec3 edge, math::DVec3 normal) {
    const math::DVec3 along = edge - math::dot(edge, normal) * normal;
    const double length = math::length(along);
    return length > 0 ? (1 / length) * along : math::to_double(math::any_orthogonal(math::to_float(normal)));
}

} // namespace cairn
