// Collision filters for shapes of a few kinds, any two of which meet or not.
#pragma once

#include <cairn/shape.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cairn::scene {

inline constexpr std::size_t max_kinds = 63; // as many as there are layers beside the first

// A layer for each kind, which collides with those that it meets, and with whatever is in the first layer: what is
// added later, a floor for example. `meet` must be symmetric; at most `max_kinds`.
template <class Kind, class Meet>
std::vector<CollisionFilter> filters_of_kinds(const std::vector<Kind>& kinds, Meet&& meet) {
    std::vector<CollisionFilter> filters(kinds.size());
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        filters[i].layers = std::uint64_t{1} << (i + 1);
        filters[i].collides_with = 1;
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            if (meet(kinds[i], kinds[k])) filters[i].collides_with |= std::uint64_t{1} << (k + 1);
        }
    }
    return filters;
}

} // namespace cairn::scene
