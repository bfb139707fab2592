// How far bodies have moved. What was found out about bodies is valid until they have moved by so much: no event has to
// take it back.
#pragma once

#include "math/vec.h"

#include <algorithm>
#include <cstdint>

namespace cairn {

// Lengths as whole numbers of 2^-32 m: sums are exact, so that no motion, however small, is lost beside a long one.
// They run over and begin anew; what counts are differences.
using Travel = std::uint64_t;

inline constexpr double travel_units = 4294967296.0; // per meter
inline constexpr double max_leap = 8192;             // m: a longer motion counts as that, which spends every budget

// How far off what was computed in single precision may be, as a share of the size of what it is about: several of its
// roundings. What may be left out by a bound is looked at that much farther, so that rounding decides nothing.
inline constexpr double rounding = 1e-6;

// At least that length, m. Of NaN, the longest.
inline Travel travelled(double length) {
    return static_cast<Travel>(static_cast<std::int64_t>((length < max_leap ? length : max_leap) * travel_units) + 1);
}
// At most that length, m, and less than what a leap spends.
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
