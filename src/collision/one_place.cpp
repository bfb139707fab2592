#include "collision/one_place.h"

#include <cstdint>

namespace cairn {

namespace {

constexpr float displacement = 1e-4f; // share of the size

// A coordinate of a point of a low-discrepancy sequence, which fills a cube evenly for any number of points (Roberts,
// "The Unreasonable Effectiveness of Quasirandom Sequences", 2018): from -1/2 to 1/2, by steps of the powers of 1 /
// 1.2207 of the range.
float coordinate(float number, int axis) {
    constexpr std::uint32_t steps[] = {0xd1b54a33u, 0xabc98388u, 0x8cb92ba7u};
    return float(std::int32_t(std::uint32_t(number) * steps[axis])) * 0x1p-32f;
}

} // namespace

void coincident_center_offset(float number_a, float number_b, float size, float offset[3]) {
    for (int axis = 0; axis < 3; ++axis)
        offset[axis] = displacement * size * (coordinate(number_b, axis) - coordinate(number_a, axis));
}

} // namespace cairn
