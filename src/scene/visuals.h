// What a file has for looks: colors, and the meshes of nodes.
#pragma once

#include "scene/scene.h"
#include "scene/surfaces.h"

#include <map>
#include <memory>
#include <tuple>

namespace cairn::scene {

class Visuals {
  public:
    Visuals(const Value& document, Surfaces& surfaces) : document_(document), surfaces_(surfaces) {}

    // Adds the mesh of a node, if it has one, to what the scene shows. `transform` is that of the node, in the body if
    // there is one. What is not supported is left out, with a warning.
    void add(const Value& node, const std::optional<BodyId>& body, const NodeTransform& transform, Scene& scene,
             std::vector<std::string>& warnings);

    // A node's own color, else that of the material of its mesh's first part, if there is any.
    std::optional<Vec3> color(const Value& node) const;
    std::optional<Vec3> own_color(const Value& node) const;

  private:
    std::optional<Vec3> material_color(const Value& index) const;
    void warn_of_texture(const Value& index, std::vector<std::string>& warnings); // once
    std::shared_ptr<const Surface> scaled(const Value& mesh, std::size_t part, const Triangles& triangles,
                                          const glm::dvec3& scale);

    Value document_;
    Surfaces& surfaces_;
    bool has_warned_of_textures_ = false;
    // By mesh, primitive and scale.
    std::map<std::tuple<std::size_t, std::size_t, double, double, double>, std::shared_ptr<const Surface>> shared_;
};

} // namespace cairn::scene
