// In which order the contacts of a batch are solved.
#pragma once

#include "islands/coloring.h"
#include "state/solver_scratch.h"

#include <cstdint>

namespace cairn {

// Overflow first, one contact after the other; then pairs that move by color; then pairs with what does not move.
// Within a color no two share a body that moves: those that bore nothing in the last step come last, so that whole
// blocks have nothing to do.
inline constexpr std::uint32_t keys_per_color = 4;
static_assert(keys_per_batch == keys_per_color * (overflow_color + 1));

inline std::uint8_t key_of(const ContactInfo& c) {
    const bool has_color = c.color != overflow_color, is_idle = has_color && !(c.force > 0);
    const std::uint32_t rank = has_color ? c.color + 1u : 0u;
    return std::uint8_t(keys_per_color * rank + (is_idle ? 2u : 0u) + (c.point_count == 1 ? 1u : 0u));
}
inline bool has_one_point(std::uint32_t key) { return (key & 1u) != 0; }

} // namespace cairn
