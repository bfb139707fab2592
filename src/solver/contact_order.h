// The order in which the contacts of a batch are solved.
#pragma once

#include "islands/coloring.h"
#include "state/solver_scratch.h"

#include <cstdint>

namespace cairn {

// Sort keys per color: loaded or idle contacts, each with several contact points, one, or one of two round surfaces.
// Overflow contacts come first and are solved one at a time; then contacts between two moving bodies, by color; then
// contacts with bodies that do not move. Within a color no two contacts share a moving body, so their order changes no
// result, and contacts that need the same work are put into the same blocks: those with zero impulse in the last step
// at the end, so that whole blocks can be skipped, and those of two round surfaces, whose normals are followed, beside
// each other.
inline constexpr std::uint32_t keys_per_color = 8;
static_assert(keys_per_batch == keys_per_color * (overflow_color + 1));

inline std::uint16_t key_of(const ContactInfo& c) {
    if (c.color == overflow_color) return c.point_count == 1 ? 1 : 0;
    const bool has_one_point = c.point_count == 1, is_idle = !(c.force > 0);
    return std::uint16_t(keys_per_color * (c.color + 1u) + (is_idle ? 4u : 0u) +
                         (has_one_point && c.is_round_touch ? 2u : 0u) + (has_one_point ? 1u : 0u));
}
inline bool has_one_point(std::uint32_t key) { return (key & 1u) != 0; }

} // namespace cairn
