// Meshes in files that a model names: only those in its own folder or below it.
#pragma once

#include "scene/mesh_store.h"
#include "scene/scene.h"
#include "scene/xml_file.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cairn::scene {

class ModelMeshes {
  public:
    explicit ModelMeshes(std::optional<std::filesystem::path> folder) : folder_(std::move(folder)) {}

    // The triangles of the .obj or .stl file that `name` means, a path that starts in `subfolder` of the model's
    // folder, times `scale`. Throws Error through `name`: io if it is missing or leads out of the folder, which is the
    // same to a model, invalid_file if it is malformed, unsupported if it is of another kind.
    std::shared_ptr<const Surface> load(const XmlText& name, const std::string& path, const std::string& subfolder,
                                        const glm::dvec3& scale);
    // The same to look at: all of it, or by its materials (scene/mesh_store.h).
    std::shared_ptr<const Surface> look(const XmlText& name, const std::string& path, const std::string& subfolder,
                                        const glm::dvec3& scale);
    const std::vector<MeshLook>& looks(const XmlText& name, const std::string& path, const std::string& subfolder,
                                       const glm::dvec3& scale, std::vector<std::string>& warnings);
    // A picture, with the same rules. Throws Error: unsupported if it is neither PNG nor JPEG.
    std::shared_ptr<const std::string> picture(const XmlText& name, const std::string& path,
                                               const std::string& subfolder);
    // The file itself, with the same rules.
    std::filesystem::path find(const XmlText& name, const std::string& path, const std::string& subfolder) const;

  private:
    NamedFile named(const XmlText& name, const std::string& path, const std::string& subfolder,
                    const glm::dvec3& scale) const;

    std::optional<std::filesystem::path> folder_;
    MeshStore store_;
};

// The corners of a surface times `scale`, with its outside kept outside.
Surface scaled_surface(const std::vector<Vec3>& vertices, std::vector<std::uint32_t> indices, const glm::dvec3& scale);
// Of the corners that triangles use.
std::vector<Vec3> used_vertices(const Surface& surface);
// The ellipsoid with these half axes, of 320 triangles.
Surface ellipsoid_surface(const glm::dvec3& half_axes);

// A solid's mass and inertia (kg m2) about its center of mass, where it stands.
struct SolidMass {
    double mass = 0.0;
    glm::dmat3 inertia{0.0};
    glm::dvec3 center{0.0, 0.0, 0.0};
};
// Of a shape in its own frame, kg/m3; without mass if the shape has none.
SolidMass shape_mass(const Shape& shape, double density);
// Of what closed triangles enclose (Tonon 2004). Nothing if they enclose no volume, as open ones may.
std::optional<SolidMass> surface_mass(const Surface& surface, double density);

} // namespace cairn::scene
