// The definitions that colliders of a file refer to by index: implicit shapes and physics materials.
#pragma once

#include "scene/accessors.h"
#include "scene/json_value.h"

#include <cairn/shape.h>

#include <string>
#include <vector>

namespace cairn::scene {

inline constexpr std::size_t max_definitions = 1'000'000;

// A physics material: the engine's surface properties, and those that Cairn adds in CAIRN_material.
struct PhysicsMaterial {
    Material material;
    float density = 1000.0f; // kg/m^3
    Vec3 surface_velocity{0.0f, 0.0f, 0.0f};
    Vec3 one_way{0.0f, 0.0f, 0.0f};
};

// A shape and its rotation in the frame of the node.
struct TurnedShape {
    Shape shape;
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
};

// Returns the rounding radius that CAIRN_shape gives on `place` (a box, a cylinder, the geometry of a hull), scaled; 0
// without the extension.
float read_rounding(const Value& place, const glm::dvec3& scale, std::vector<std::string>& warnings);

class Definitions {
  public:
    explicit Definitions(const Value& document);

    // Returns the shape that `index` (a collider's geometry.shape) refers to, with its sizes multiplied by |scale|, no
    // component of which is zero. `accessors` provides the heights of height fields.
    TurnedShape shape(const Value& index, const glm::dvec3& scale, Accessors& accessors,
                      std::vector<std::string>& warnings) const;
    PhysicsMaterial substance(const Value& index) const;
    // Returns the materials of triangles (of a primitive) or cells (of a height field), as `own`, its extension object,
    // lists them. Without material indices all parts have the first material.
    SurfaceMaterials surface_materials(const Value& own, std::size_t parts, Accessors& accessors) const;

  private:
    Shape height_field(const Value& shape, const glm::dvec3& scale, Accessors& accessors) const;

    std::optional<Value> shapes_, materials_;
};

} // namespace cairn::scene
