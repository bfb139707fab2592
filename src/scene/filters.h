// Collision filters: the names of the drafts' collision systems, and the bits that the engine has for them.
#pragma once

#include "scene/json_value.h"

#include <cairn/shape.h>

#include <cstdint>
#include <string>
#include <vector>

namespace cairn::scene {

// The lowest bit is for colliders that are in no system: it is the layer that shapes are in by themselves.
inline constexpr std::uint64_t unnamed_layer = 1;
inline constexpr std::size_t max_collision_systems = 63;

class Filters {
  public:
    explicit Filters(const Value& document);

    // The filter that `index` (a collider's collisionFilter) refers to.
    CollisionFilter filter(const Value& index) const;
    // The systems in use, by name; the i-th has the bit i + 1.
    const std::vector<std::string>& names() const { return names_; }

  private:
    std::uint64_t bits(const Value& list) const;

    std::optional<Value> filters_;
    std::vector<std::string> names_;
};

} // namespace cairn::scene
