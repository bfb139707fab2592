// The order in which the contacts of a batch are solved.
#pragma once

#include "islands/coloring.h"
#include "state/solver_scratch.h"

#include <cstdint>

namespace cairn {

// Sort keys per color: loaded or idle contacts, each with one contact point or with several. Overflow contacts come
// first and are solved one at a time; then contacts between two moving bodies, by color; then contacts with bodies that
// do not move. Within a color no two contacts share a moving body; contacts with zero impulse in the last step are
// sorted to the end, so that whole blocks can be skipped.
inline constexpr std::uint32_t keys_per_color = 4;
static_assert(keys_per_batch == keys_per_color * (overflow_color + 1));

inline std::uint8_t key_of(const ContactInfo& c) {
    const bool has_color = c.color != overflow_color, is_idle = has_color && !(c.force > 0);
    const std::uint32_t rank = has_color ? c.color + 1u : 0u;
    return std::uint8_t(keys_per_color * rank + (is_idle ? 2u : 0u) + (c.point_count == 1 ? 1u : 0u));
}
inline bool has_one_point(std::uint32_t key) { return (key & 1u) != 0; }

} // namespace cairn
