// Makes the shapes of colliders and triggers. Colliders with the same mesh and scale share their data.
#pragma once

#include "scene/decomposition.h"
#include "scene/definitions.h"
#include "scene/surfaces.h"

#include <cairn/body.h>

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace cairn::scene {

class Colliders {
  public:
    Colliders(const Value& document, Surfaces& surfaces) : definitions_(document), surfaces_(surfaces) {}

    // Returns the shapes of `geometry` on a body of that type, scaled; no component of `scale` is zero. On a dynamic
    // body a mesh is split into several convex parts if it is a collider, and becomes its convex hull if it is a
    // trigger; other surfaces are refused there. Throws Error naming the place.
    std::vector<TurnedShape> shapes(const Value& geometry, const glm::dvec3& scale, BodyType type, bool is_trigger,
                                    std::vector<std::string>& warnings);
    PhysicsMaterial substance(const Value& index) const { return definitions_.substance(index); }

  private:
    const std::vector<Hull>& parts_of(const Value& geometry, const Value& node, const glm::dvec3& scale,
                                      std::vector<std::string>& warnings);
    Shape mesh_shape(const Value& geometry, const Value& node, const glm::dvec3& scale, bool is_hull,
                     std::vector<std::string>& warnings);
    SurfaceMaterials materials_of(const GatheredTriangles& triangles);
    TurnedShape implicit_shape(const Value& index, const glm::dvec3& scale, std::vector<std::string>& warnings);

    Definitions definitions_;
    Surfaces& surfaces_;
    // The index of the node or shape, whether the shape is a hull, and the scale.
    using Key = std::tuple<std::size_t, bool, double, double, double>;
    std::map<Key, Shape> meshes_;
    std::map<Key, std::shared_ptr<const Surface>> surfaces_in_parts_;
    SurfaceParts surface_parts_;
    std::map<Key, Shape> height_fields_;
};

} // namespace cairn::scene
