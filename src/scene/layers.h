// Collision filters for shapes of a few kinds, where each pair of kinds either collides or does not.
#pragma once

#include <cairn/shape.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cairn::scene {

inline constexpr std::size_t max_kinds = 63; // the number of layers beside the first

// Returns one filter per kind: each kind has a layer of its own and collides with the layers for which `meet` is true,
// and with the first layer, which shapes that are added later, such as a floor, are in. `meet` must be symmetric; there
// may be at most `max_kinds` kinds.
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
