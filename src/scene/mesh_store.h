// Mesh files that models name, to touch and to look at, and the materials that .obj files name in their turn.
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

// A file, and what the model calls it, and where.
struct NamedFile {
    std::filesystem::path path, root; // without links; what it names must lie in `root`
    std::string place, shown;
};

// What a mesh file shows with one of its materials.
struct MeshLook {
    std::shared_ptr<const Surface> surface;
    std::optional<Vec3> color;              // none: the file does not say
    std::shared_ptr<const Texture> texture; // none: not covered
};

// Each file is read once, and shared by all that use it with the same scale.
class MeshStore {
  public:
    // The triangles as they touch. Throws Error naming the place: unsupported if it is no .obj or .stl file,
    // invalid_file if it is malformed.
    std::shared_ptr<const Surface> surface(const NamedFile& file, const glm::dvec3& scale);
    // The same to look at, with its places in textures and its normals, if it has any.
    std::shared_ptr<const Surface> look(const NamedFile& file, const glm::dvec3& scale);
    // The same by its materials. What of those cannot be read is left out, with a warning.
    const std::vector<MeshLook>& looks(const NamedFile& file, const glm::dvec3& scale,
                                       std::vector<std::string>& warnings);
    Pictures& pictures() { return pictures_; }

  private:
    using Key = std::tuple<std::string, double, double, double>;
    struct Scaled {
        std::shared_ptr<const Surface> surface, look;
        std::vector<MeshLook> looks;
    };
    const MeshFile& read(const NamedFile& file);
    static Key key(const NamedFile& file, const glm::dvec3& scale);

    std::size_t vertices_ = 0;
    std::map<std::filesystem::path, MeshFile> files_;
    std::map<Key, Scaled> scaled_;
    Pictures pictures_;
};

// Gives the body of `scene_of_mesh` the looks that the file has by its materials, if it names any. Pictures lie in the
// folder of the file or below it.
void add_mesh_looks(const std::filesystem::path& file, double scale, Scene& scene);

} // namespace cairn::scene
