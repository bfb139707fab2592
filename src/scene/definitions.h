// What the colliders of a file refer to by index: shapes, physics materials and collision filters.
#pragma once

#include "scene/json_value.h"

#include <cairn/shape.h>

#include <set>
#include <string>
#include <vector>

namespace cairn::scene {

inline constexpr std::size_t max_definitions = 1'000'000;
inline constexpr std::size_t max_used_filters = 256; // every two of them are compared

// A physics material: the engine's surface properties, and what Cairn adds in CAIRN_material.
struct Substance {
    Material material;
    float density = 1000.0f; // kg/m^3
};

class Definitions {
  public:
    explicit Definitions(const Value& document);

    // The shape that `index` (a collider's geometry.shape) refers to, its sizes multiplied by |scale|, no component
    // of which is zero.
    Shape shape(const Value& index, const glm::dvec3& scale, std::vector<std::string>& warnings) const;
    Substance substance(const Value& index) const;
    // Notes that a collider has the collision filter `index`, or none.
    void use_filter(const std::optional<Value>& index);
    // Refuses filters that would keep any two of the colliders apart: filters that let everything collide are all
    // that can be honored yet.
    void refuse_separating_filters() const;

  private:
    std::optional<Value> shapes_, materials_, filters_;
    std::set<std::size_t> used_filters_;
    bool some_without_filter_ = false;
};

} // namespace cairn::scene
