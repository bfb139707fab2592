// Mesh files that models name, for collision and for visuals, and the materials that .obj files name in their turn.
#pragma once

#include "scene/mesh_files.h"
#include "scene/pictures.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace cairn::scene {

// A file, with its name and place in the model for messages.
struct NamedFile {
    std::filesystem::path path, root; // both without symbolic links; files that it names must lie in `root`
    std::string place, shown;
};

// The part of a mesh file that has one of its materials.
struct MeshVisual {
    std::shared_ptr<const Surface> surface;
    std::optional<Vec3> color;              // none: the file does not give a color
    std::shared_ptr<const Texture> texture; // none: no texture
};

// Reads each file once and shares it among all users with the same scale.
class MeshStore {
  public:
    // Returns the triangles for collision. Throws Error naming the place: unsupported if the file is neither .obj nor
    // .stl, invalid_file if it is malformed.
    std::shared_ptr<const Surface> surface(const NamedFile& file, const glm::dvec3& scale);
    // Returns the surface for visuals, with its texture coordinates and its normals, if it has any.
    std::shared_ptr<const Surface> look(const NamedFile& file, const glm::dvec3& scale);
    // Returns the surface for visuals, split by material. Textures and materials that cannot be read are left out, with
    // a warning.
    const std::vector<MeshVisual>& looks(const NamedFile& file, const glm::dvec3& scale,
                                         std::vector<std::string>& warnings);
    Pictures& pictures() { return pictures_; }

  private:
    using Key = std::tuple<std::string, double, double, double>;
    struct Scaled {
        std::shared_ptr<const Surface> surface, look;
        std::vector<MeshVisual> looks;
    };
    const MeshFile& read(const NamedFile& file);
    static Key key(const NamedFile& file, const glm::dvec3& scale);

    std::size_t vertices_ = 0;
    std::map<std::filesystem::path, MeshFile> files_;
    std::map<Key, Scaled> scaled_;
    Pictures pictures_;
};

// Gives the body of `scene_of_mesh` visual meshes with the materials that the file names, if any. Pictures must lie in
// the folder of the file or below it.
void add_mesh_looks(const std::filesystem::path& file, double scale, Scene& scene);

} // namespace cairn::scene
