// Points as columns of x, y and z, to be searched four at a time.
#pragma once

#include "math/vec.h"

#include <cstddef>
#include <span>
#include <vector>

namespace cairn {

class Columns {
  public:
    Columns() = default;
    explicit Columns(std::span<const math::Vec3> points);

    std::size_t size() const { return size_; }
    // The point farthest along d, which may have any length: exactly that of dot products in double, of equal ones the
    // first.
    std::size_t farthest(math::DVec3 d) const;

  private:
    std::size_t size_ = 0;
    float largest_ = 0;            // of all coordinates
    std::vector<float> x_, y_, z_; // padded to blocks by repeating the last point
};

// Planes n . x = offset, likewise.
class PlaneColumns {
  public:
    static constexpr std::size_t width = 4;
    using Floats = float __attribute__((vector_size(16)));

    PlaneColumns() = default;
    PlaneColumns(std::span<const math::Vec3> normals, std::span<const float> offsets);

    std::size_t size() const { return size_; }
    // How far each of planes i to i + width - 1 is below the lowest of the points, along its normal; beyond the last
    // plane, that of the last. Rounding adds up to 1e-6 of the sizes.
    Floats below(std::size_t i, std::span<const math::Vec3> points) const;

  private:
    std::size_t size_ = 0;
    std::vector<float> x_, y_, z_, offset_; // padded to `width` by repeating the last plane
};

} // namespace cairn
