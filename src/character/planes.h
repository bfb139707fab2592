// Finds the motion nearest to a wanted one that does not violate a set of plane constraints.
#pragma once

#include "math/vec.h"

#include <array>
#include <cstddef>
#include <optional>

namespace cairn {

struct MotionPlane {
    math::DVec3 normal; // unit
    double least = 0;   // the least displacement along the normal
};

class MotionPlanes {
  public:
    static constexpr std::size_t max_count = 8;
    void clear() { count_ = 0; }
    std::size_t size() const { return count_; }
    // Adds a plane; if there are too many, the oldest except the first is removed.
    void add(const MotionPlane& plane);
    // The nearest allowed motion; nothing if no allowed motion is at most as long as the wanted one plus the sum of all
    // pushes: otherwise a character squeezed between two planes that nearly face each other would shoot out.
    std::optional<math::DVec3> nearest(math::DVec3 wanted) const;

  private:
    bool allows(math::DVec3 motion, double tolerance) const;
    std::array<MotionPlane, max_count> planes_;
    std::size_t count_ = 0;
};

} // namespace cairn
