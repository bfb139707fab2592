// Collision filters: maps the names of the drafts' collision systems to the layer bits of the engine.
#pragma once

#include "scene/json_value.h"

#include <cairn/shape.h>

#include <cstdint>
#include <string>
#include <vector>

namespace cairn::scene {

// The layer bit of colliders that are in no collision system: the lowest, which is also the default layer of shapes.
inline constexpr std::uint64_t unnamed_layer = 1;
inline constexpr std::size_t max_collision_systems = 63;

class Filters {
  public:
    explicit Filters(const Value& document);

    // Returns the filter that `index` (a collider's collisionFilter) refers to.
    CollisionFilter filter(const Value& index) const;
    // The names of the collision systems in use; system i has bit i + 1.
    const std::vector<std::string>& names() const { return names_; }

  private:
    std::uint64_t bits(const Value& list) const;

    std::optional<Value> filters_;
    std::vector<std::string> names_;
};

} // namespace cairn::scene
