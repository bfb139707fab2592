// Points as columns of x, y and z, to be searched four at a time.
#pragma once

#include "math/vec.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

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
inline float greatest_of(F4 v) {
    const float low = v[0] > v[1] ? v[0] : v[1], high = v[2] > v[3] ? v[2] : v[3];
    return low > high ? low : high;
}

} // namespace columns

class Columns {
  public:
    Columns() = default;
    explicit Columns(std::span<const math::Vec3> points);

    std::size_t size() const { return size_; }
    // Directions come by reference: a copy of one that was just computed stalls the processor.
    // The point farthest along d, which may have any length: exactly that of dot products in double, of equal ones the
    // first.
    std::size_t farthest(const math::DVec3& d) const;
    // Likewise by dot products in floats, in half the time: one of those points that are within 3e-6 of the largest
    // coordinate of the farthest. `unit`: of length 1.
    std::size_t nearly_farthest(const math::DVec3& unit) const;

  private:
    std::size_t farthest_of(const math::DVec3& d, double scale, float least) const;

    std::size_t size_ = 0;
    float largest_ = 0;            // of all coordinates
    std::vector<float> x_, y_, z_; // padded to blocks by repeating the last point
};

// Planes n . x = offset, likewise.
class PlaneColumns {
  public:
    static constexpr std::size_t width = 4;

    PlaneColumns() = default;
    PlaneColumns(std::span<const math::Vec3> normals, std::span<const float> offsets);

    std::size_t size() const { return size_; }
    // How far a point is above each of planes i to i + width - 1; beyond the last plane infinitely far below. Rounding
    // adds up to 1e-6 of the sizes.
    columns::F4 above(std::size_t i, math::Vec3 p) const {
        using namespace columns;
        return splat(p.x) * load(&x_[i]) + splat(p.y) * load(&y_[i]) + splat(p.z) * load(&z_[i]) - load(&offset_[i]);
    }

  private:
    std::size_t size_ = 0;
    std::vector<float> x_, y_, z_, offset_; // padded to `width`
};

} // namespace cairn
