// The travel of bodies: a result about bodies is valid until they have traveled a certain distance, so no event must
// invalidate it.
#pragma once

#include "math/vec.h"

#include <algorithm>
#include <cstdint>

namespace cairn {

// Lengths in units of 2^-32 m: sums of integers are exact, so that small motions are not lost next to long ones. They
// wrap around; only differences matter.
using Travel = std::uint64_t;

inline constexpr double travel_units = 4294967296.0; // units per meter
inline constexpr double max_leap = 8192;             // m: longer motions count as this, which exceeds every budget

// Error of single precision results, relative to the size of their operands: several roundings. Bounds that exclude
// something are widened by this, so that rounding decides nothing.
inline constexpr double rounding = 1e-6;

// The length, m, rounded up. NaN counts as the longest.
inline Travel travelled(double length) {
    return static_cast<Travel>(static_cast<std::int64_t>((length < max_leap ? length : max_leap) * travel_units) + 1);
}
// The length, m, rounded down, and less than max_leap.
inline Travel budget_of(double length) {
    return static_cast<Travel>(static_cast<std::int64_t>(std::clamp(length, 0.0, max_leap / 2) * travel_units));
}
inline bool is_before(Travel now, Travel end) { return static_cast<std::int64_t>(end - now) > 0; }

// The pose up to which the travel of a body is counted.
struct CountedPose {
    math::DVec3 x;
    math::DQuat q;
};

} // namespace cairn
