// Points stored as columns of x, y and z (structure of arrays), searched four at a time in SIMD lanes.
#pragma once

#include "math/vec.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace cairn {

namespace columns {

using F4 = float __attribute__((vector_size(16)));
using I4 = std::int32_t __attribute__((vector_size(16)));
inline F4 load(const float* p) {
    F4 v;
    std::memcpy(&v, p, sizeof v);
    return v;
}
inline F4 splat(float s) { return F4{s, s, s, s}; }
inline F4 greater(F4 a, F4 b) { return a > b ? a : b; }
inline F4 lesser(F4 a, F4 b) { return a < b ? a : b; }
inline bool any(I4 m) {
    std::int64_t halves[2];
    std::memcpy(halves, &m, sizeof m);
    return (halves[0] | halves[1]) != 0;
}
// One bit per lane.
inline unsigned bits(I4 m) {
#if defined(__SSE2__)
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(m)));
#else
    return static_cast<unsigned>((m[0] & 1) | (m[1] & 2) | (m[2] & 4) | (m[3] & 8));
#endif
}
// The greatest lane, broadcast to all four.
inline F4 spread_greatest(F4 v) {
    const F4 both = greater(v, __builtin_shufflevector(v, v, 2, 3, 0, 1));
    return greater(both, __builtin_shufflevector(both, both, 1, 0, 3, 2));
}
inline float greatest_of(F4 v) { return spread_greatest(v)[0]; }

} // namespace columns

class Columns {
  public:
    Columns() = default;
    explicit Columns(std::span<const math::Vec3> points);

    std::size_t size() const { return size_; }
    math::Vec3 operator[](std::size_t i) const { return {column(0)[i], column(1)[i], column(2)[i]}; }
    bool operator==(const Columns&) const = default;
    // Directions are passed by reference: copying one that was just computed stalls the processor.
    // The support point along d, which may have any length: the index with the greatest dot product in double
    // precision, and of equal ones the first.
    std::size_t farthest(const math::DVec3& d) const;
    // As farthest, by dot products in floats, in a third of the time: the index of a point within 3e-6 of the largest
    // coordinate from the support. The length of d must be such that floats hold the products.
    std::size_t nearly_farthest(const math::DVec3& d) const;
    // The least and the greatest dot product of the points with d, as floats.
    struct Range {
        float least, greatest;
    };
    Range range(const math::Vec3& d) const;

  private:
    std::size_t farthest_of(const math::DVec3& d, double scale, float least) const;

    const float* column(std::size_t i) const { return all_.data() + i * room_; }

    std::size_t size_ = 0, room_ = 0; // room_: size_ padded to whole blocks by repeating the last point
    float largest_ = 0;               // the largest absolute coordinate
    std::vector<float> all_;          // x of every point, then y, then z
};

// Planes n . x = offset, stored as columns.
class PlaneColumns {
  public:
    static constexpr std::size_t width = 4;

    PlaneColumns() = default;
    PlaneColumns(std::span<const math::Vec3> normals, std::span<const float> offsets);

    std::size_t size() const { return size_; }
    // The signed distances of a point above planes i to i + width - 1; minus infinity beyond the last plane. The
    // rounding error is up to 1e-6 of the sizes.
    columns::F4 above(std::size_t i, math::Vec3 p) const {
        using namespace columns;
        const float* const x = all_.data() + i;
        return splat(p.x) * load(x) + splat(p.y) * load(x + room_) + splat(p.z) * load(x + 2 * room_) -
               load(x + 3 * room_);
    }
    // The dot products of d with the normals of planes i to i + width - 1.
    columns::F4 along(std::size_t i, math::Vec3 d) const {
        using namespace columns;
        const float* const x = all_.data() + i;
        return splat(d.x) * load(x) + splat(d.y) * load(x + room_) + splat(d.z) * load(x + 2 * room_);
    }

  private:
    std::size_t size_ = 0, room_ = 0; // room_: size_ padded to a multiple of `width`
    std::vector<float> all_;          // x of every normal, then y, then z, then the offsets
};

} // namespace cairn
