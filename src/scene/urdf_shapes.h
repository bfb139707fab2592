// Collision shapes and visuals of the links of a robot.
#pragma once

#include "scene/decomposition.h"
#include "scene/mesh_store.h"
#include "scene/rigid.h"
#include "scene/scene.h"

#include <urdf_model/link.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cairn::scene {

// Returns the pose of an `origin`. Throws Error naming `place` if it is not finite.
Rigid rigid(const urdf::Pose& pose, const std::string& place);

class RobotShapes {
  public:
    RobotShapes(std::string name, std::optional<std::filesystem::path> folder, bool decomposes, Scene& scene)
        : name_(std::move(name)), folder_(std::move(folder)), decomposes_(decomposes), scene_(scene) {}

    // Adds the collision shapes of a link with the pose `at` in the frame of `body`. With `may_lack`, shapes whose
    // meshes are missing, may not be read or are of an unknown format are left out, with a warning.
    void add_shapes(const urdf::Link& link, BodyId body, const Rigid& at, bool may_lack);
    // Adds the visuals of a link; returns false if one of them cannot be shown, which is warned of.
    bool add_visuals(const urdf::Link& link, BodyId body, const Rigid& at);

  private:
    struct Turned {
        Shape shape;
        glm::dquat rotation{1.0, 0.0, 0.0, 0.0}; // of the shape in the frame of the geometry
        std::vector<Hull> parts{};               // convex parts instead of the shape, if there are any
    };
    // Returns the shape of one collision element; nothing if it is left out.
    std::optional<Turned> collision_shape(const urdf::Collision& collision, const std::string& place, bool is_static,
                                          bool may_lack);
    Turned shape(const urdf::Geometry& geometry, const std::string& place, bool is_static);
    NamedFile file_of(const std::string& filename, const std::string& place);
    std::shared_ptr<const Surface> triangles(const urdf::Mesh& mesh, const std::string& place);
    // Returns the meshes of a visual, in the frame `local`, which is adjusted where the shape needs a rotation.
    std::vector<MeshVisual> looks(const urdf::Geometry& geometry, const std::string& place, Rigid& local);
    // Returns the texture of a visual's material; null if there is none, or if it cannot be shown, which is warned of.
    std::shared_ptr<const Texture> texture_of(const urdf::Visual& visual, const std::string& place);

    std::string name_;
    std::optional<std::filesystem::path> folder_;
    bool decomposes_;
    Scene& scene_;
    SurfaceParts surface_parts_;
    bool has_warned_of_slashes_ = false;
    MeshStore meshes_;
};

} // namespace cairn::scene
