// The shapes that colliders and triggers ask for. What has the same mesh and scale shares its data.
#pragma once

#include "scene/definitions.h"
#include "scene/surfaces.h"

#include <cairn/body.h>

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace cairn::scene {

class Colliders {
  public:
    Colliders(const Value& document, Surfaces& surfaces) : definitions_(document), surfaces_(surfaces) {}

    // The shape of `geometry` on a body of that type, scaled; no component of `scale` is zero. Surfaces on dynamic
    // bodies become their hulls, or are refused. Throws Error naming the place.
    TurnedShape shape(const Value& geometry, const glm::dvec3& scale, BodyType type,
                      std::vector<std::string>& warnings);
    Substance substance(const Value& index) const { return definitions_.substance(index); }

  private:
    Shape mesh_shape(const Value& geometry, const Value& node, const glm::dvec3& scale, bool is_hull,
                     std::vector<std::string>& warnings);
    TurnedShape implicit_shape(const Value& index, const glm::dvec3& scale, std::vector<std::string>& warnings);

    Definitions definitions_;
    Surfaces& surfaces_;
    // By node or shape, whether it is a hull, and scale.
    using Key = std::tuple<std::size_t, bool, double, double, double>;
    std::map<Key, Shape> meshes_;
    std::map<Key, Shape> height_fields_;
};

} // namespace cairn::scene
