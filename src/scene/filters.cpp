#include "scene/filters.h"

#include "scene/definitions.h"
#include "scene/document.h"

#include <algorithm>
#include <set>

namespace cairn::scene {

namespace {

constexpr const char* lists[] = {"collisionSystems", "collideWithSystems", "notCollideWithSystems"};
constexpr std::size_t max_listed = 1000;

} // namespace

Filters::Filters(const Value& document) {
    const auto physics = extension(document, "KHR_physics_rigid_bodies");
    filters_ = physics ? physics->find("collisionFilters") : std::nullopt;
    const std::size_t count = filters_ ? filters_->size(max_definitions, "collision filters") : 0;
    std::set<std::string> names; // sorted, so that systems keep their bits when a file is saved and loaded
    for (std::size_t i = 0; i < count; ++i) {
        const Value filter = (*filters_)[i];
        for (const char* member : lists) {
            const auto list = filter.find(member);
            const std::size_t listed = list ? list->size(max_listed, "systems") : 0;
            for (std::size_t k = 0; k < listed; ++k) {
                names.insert((*list)[k].text());
                if (names.size() > max_collision_systems) {
                    (*list)[k].fail("must be one of at most " + std::to_string(max_collision_systems) +
                                    " different systems in a file");
                }
            }
        }
        if (const auto both = filter.find(lists[2]); both && filter.find(lists[1])) {
            both->fail("must not stand beside collideWithSystems");
        }
    }
    names_.assign(names.begin(), names.end());
}

std::uint64_t Filters::bits(const Value& list) const {
    std::uint64_t result = 0;
    const std::size_t count = list.size(max_listed, "systems");
    for (std::size_t i = 0; i < count; ++i) {
        const auto found = std::lower_bound(names_.begin(), names_.end(), list[i].text());
        result |= std::uint64_t{2} << (found - names_.begin());
    }
    return result;
}

CollisionFilter Filters::filter(const Value& index) const {
    const Value found = element(filters_, index, max_definitions, "collision filters");
    CollisionFilter result;
    if (const auto systems = found.find(lists[0])) {
        if (const std::uint64_t layers = bits(*systems); layers != 0) result.layers = layers;
    }
    if (const auto with = found.find(lists[1])) result.collides_with = bits(*with);
    if (const auto without = found.find(lists[2])) result.collides_with = ~bits(*without);
    return result;
}

} // namespace cairn::scene
