// Graph coloring of contacts: no two contacts of one color share a moving body, so that 8 of them can be solved side by
// side. A contact gets its color in the step in which it begins, the lowest that is free at both bodies, and keeps it
// (docs/decisions/colors.md). Contacts with bodies that do not move have colors of their own, which are solved last, so
// that no later contact undoes what the ground requires. Contacts without a free color are solved first, one by one.
#pragma once

#include "state/state.h"

namespace cairn {

inline constexpr int first_fixed_color = 40, overflow_color = 63, no_color = 255;

// Counts a contact that begins to be solved at its bodies.
inline void count_contact(Bodies& bodies, const ContactInfo& contact) {
    ++bodies.links[contact.body_a].contact_count;
    ++bodies.links[contact.body_b].contact_count;
}

inline void assign_color(Bodies& bodies, ContactInfo& contact) {
    std::uint64_t used = bodies.links[contact.body_a].colors;
    if (contact.b_moves) used |= bodies.links[contact.body_b].colors;
    const std::uint64_t low = (std::uint64_t(1) << first_fixed_color) - 1;
    const std::uint64_t choice = contact.b_moves ? low : ~low & ~(std::uint64_t(1) << overflow_color);
    const std::uint64_t free = ~used & choice;
    contact.color = free ? std::uint8_t(__builtin_ctzll(free)) : overflow_color;
    if (!free) return;
    const std::uint64_t bit = std::uint64_t(1) << contact.color;
    bodies.links[contact.body_a].colors |= bit;
    if (contact.b_moves) bodies.links[contact.body_b].colors |= bit;
}

// Removes a contact that ceases to be solved from its bodies' counts, and frees its color.
inline void release_contact(Bodies& bodies, ContactInfo& contact) {
    --bodies.links[contact.body_a].contact_count;
    --bodies.links[contact.body_b].contact_count;
    if (contact.color < overflow_color) {
        const std::uint64_t bit = std::uint64_t(1) << contact.color;
        bodies.links[contact.body_a].colors &= ~bit;
        if (contact.b_moves) bodies.links[contact.body_b].colors &= ~bit;
    }
    contact.color = no_color;
}

} // namespace cairn
