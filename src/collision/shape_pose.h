// The pose of a shape, as the narrow phase reads it. Plain data, indexed by the shape's slot; no functions, because
// kernel translation units of every instruction set include it.
#pragma once

#include <cstdint>

namespace cairn {

// Pose and size of a shape in the world, one cache line. The world position of the shape's center is high + low: high
// is the position rounded to float, low the remainder. A difference of two positions, (high_b - high_a) + (low_b -
// low_a), then has the precision of a float of the size of that difference, however far from the origin both are.
struct alignas(64) ShapePose {
    float high[4]; // x y z, [3] unused (0)
    float low[4];  // x y z, [3]: unused (0)
    float q[4];    // x y z, [3]: the number of the shape (one_place.h)
    float size[4]; // sphere: {radius, 0, 0, radius}; box: {half extents, bounding radius}; rectangle: {half x, 0, half
                   // z, ..}; infinite plane: {0, 0, 0, 0}; capsule: {lower radius, half height, upper radius, ..}.
                   // Planes and rectangles face along their local +y, capsules stand along it.
};

} // namespace cairn
