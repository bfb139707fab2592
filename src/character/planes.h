// The motion that comes nearest to a wanted one and leads into none of some planes.
#pragma once

#include "math/vec.h"

#include <array>
#include <cstddef>
#include <optional>

namespace cairn {

struct MotionPlane {
    math::DVec3 normal; // unit
    double least = 0;   // along the normal: how far the motion must lead at least
};

class MotionPlanes {
  public:
    static constexpr std::size_t max_count = 8;
    void clear() { count_ = 0; }
    std::size_t size() const { return count_; }
    // The oldest but the first goes if there are too many.
    void add(const MotionPlane& plane);
    // Nothing if no motion satisfies all that is no longer than the wanted one and all that pushes together: what is
    // squeezed between two that nearly face each other would shoot out.
    std::optional<math::DVec3> nearest(math::DVec3 wanted) const;

  private:
    bool allows(math::DVec3 motion, double tolerance) const;
    std::array<MotionPlane, max_count> planes_;
    std::size_t count_ = 0;
};

} // namespace cairn
