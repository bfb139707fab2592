// Reads the visuals of a file: colors, and the meshes of nodes.
#pragma once

#include "scene/scene.h"
#include "scene/surfaces.h"
#include "scene/textures.h"

#include <map>
#include <memory>
#include <set>
#include <span>
#include <tuple>

namespace cairn::scene {

// The pose of a node that may be a bone: the body it moves with, if any, and its map to the world, which may be skewed.
struct BonePlace {
    std::optional<BodyId> body;
    Affine map;
};

class Visuals {
  public:
    Visuals(const Value& document, Surfaces& surfaces)
        : document_(document), surfaces_(surfaces), textures_(document, surfaces) {}

    // Adds the mesh of a node, if it has one, to the visual meshes of the scene. `transform` is that of the node,
    // relative to the body if there is one. Unsupported features are left out, with a warning.
    void add(const Value& node, const std::optional<BodyId>& body, const NodeTransform& transform, Scene& scene,
             std::vector<std::string>& warnings);

    // Adds the mesh of a node with a skin, whose joints are nodes. `places` has an entry for each node that the scene
    // shows. To be called after all bodies have been added.
    void add_skinned(const Value& node, std::span<const std::optional<BonePlace>> places, Scene& scene,
                     std::vector<std::string>& warnings);

    // `color` returns a node's own color, else that of the material of its mesh's first primitive, if there is any.
    std::optional<Vec3> color(const Value& node) const;
    std::optional<Vec3> own_color(const Value& node) const;

  private:
    // The triangles of a primitive, scaled, with their texture and finish.
    struct Dressed {
        std::shared_ptr<const Surface> surface;
        std::shared_ptr<const Texture> texture;
        std::shared_ptr<const Finish> finish;
    };
    void add_parts(const Value& node, const VisualMesh& like, const glm::dvec3& scale, Scene& scene,
                   std::vector<std::string>& warnings);
    std::vector<Bone> read_bones(const Value& skin, std::span<const std::optional<BonePlace>> places,
                                 const World& world);
    Value material(const Value& index) const;
    static std::optional<Vec3> base_color(const Value& material);
    static std::optional<Vec3> plain_color(const Value& material);
    const Dressed& dressed(const Value& mesh, std::size_t part, const Triangles& triangles, const glm::dvec3& scale,
                           std::size_t bones, std::vector<std::string>& warnings);
    std::vector<BoneWeights> read_weights(const Triangles& triangles, std::size_t bones);
    std::vector<Vec3> vertex_colors(const Triangles& triangles, const Textures::Warn& warn);

    Value document_;
    Surfaces& surfaces_;
    Textures textures_;
    std::set<std::string> warned_; // texture warnings that were already given
    // Keyed by mesh, primitive, scale and number of bones.
    std::map<std::tuple<std::size_t, std::size_t, double, double, double, std::size_t>, Dressed> shared_;
};

} // namespace cairn::scene
