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

} // namespace cairn
