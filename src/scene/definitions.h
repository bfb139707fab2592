// What the colliders of a file refer to by index: implicit shapes and physics materials.
#pragma once

#include "scene/accessors.h"
#include "scene/json_value.h"

#include <cairn/shape.h>

#include <string>
#include <vector>

namespace cairn::scene {

inline constexpr std::size_t max_definitions = 1'000'000;

// A physics material: the engine's surface properties, and what Cairn adds in CAIRN_material.
struct Substance {
    Material material;
    float density = 1000.0f; // kg/m^3
    Vec3 surface_velocity{0.0f, 0.0f, 0.0f};
    Vec3 one_way{0.0f, 0.0f, 0.0f};
};

// A shape, and how it is turned in the node's frame.
struct TurnedShape {
    Shape shape;
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
};

// The rounding that CAIRN_shape on `place` (a box, a cylinder, the geometry of a hull) gives, scaled; 0 without.
float read_rounding(const Value& place, const glm::dvec3& scale, std::vector<std::string>& warnings);

class Definitions {
  public:
    explicit Definitions(const Value& document);

    // The shape that `index` (a collider's geometry.shape) refers to, its sizes multiplied by |scale|, no component
    // of which is zero. `accessors` has the heights of height fields.
    TurnedShape shape(const Value& index, const glm::dvec3& scale, Accessors& accessors,
                      std::vector<std::string>& warnings) const;
    Substance substance(const Value& index) const;
    // What `own`, the extension of a primitive or a height field, says of the materials of its parts, triangles or
    // cells. Without numbers all have its first material.
    SurfaceMaterials surface_materials(const Value& own, std::size_t parts, Accessors& accessors) const;

  private:
    Shape height_field(const Value& shape, const glm::dvec3& scale, Accessors& accessors) const;

    std::optional<Value> shapes_, materials_;
};

} // namespace cairn::scene
