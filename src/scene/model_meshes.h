// Mesh files that a model names; they must lie in its own folder or below it.
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

    // Returns the triangles of the .obj or .stl file that `name` refers to, times `scale`. `path` is relative to
    // `subfolder` of the model's folder. Throws Error through `name`: io if the file is missing or leads out of the
    // folder (the message does not tell these apart), invalid_file if it is malformed, unsupported if it is of another
    // kind.
    std::shared_ptr<const Surface> load(const XmlText& name, const std::string& path, const std::string& subfolder,
                                        const glm::dvec3& scale);
    // Returns the mesh for visuals: all of it, or split by material (scene/mesh_store.h).
    std::shared_ptr<const Surface> look(const XmlText& name, const std::string& path, const std::string& subfolder,
                                        const glm::dvec3& scale);
    const std::vector<MeshVisual>& looks(const XmlText& name, const std::string& path, const std::string& subfolder,
                                         const glm::dvec3& scale, std::vector<std::string>& warnings);
    // Returns the content of a picture file under the same rules. Throws Error: unsupported if it is neither PNG nor
    // JPEG.
    std::shared_ptr<const std::string> picture(const XmlText& name, const std::string& path,
                                               const std::string& subfolder);
    // Returns the path of a file under the same rules.
    std::filesystem::path find(const XmlText& name, const std::string& path, const std::string& subfolder) const;

  private:
    NamedFile named(const XmlText& name, const std::string& path, const std::string& subfolder,
                    const glm::dvec3& scale) const;

    std::optional<std::filesystem::path> folder_;
    MeshStore store_;
};

// The vertices of a surface times `scale`; a mirroring scale reverses the triangles, so that their outside stays
// outside.
Surface scaled_surface(const std::vector<Vec3>& vertices, std::vector<std::uint32_t> indices, const glm::dvec3& scale);
// The vertices that triangles of the surface use.
std::vector<Vec3> used_vertices(const Surface& surface);
// An ellipsoid with these semi-axes, as 320 triangles.
Surface ellipsoid_surface(const glm::dvec3& half_axes);

// Mass and inertia (kg m2) of a solid; the inertia is about its center of mass, which is at `center`.
struct SolidMass {
    double mass = 0.0;
    glm::dmat3 inertia{0.0};
    glm::dvec3 center{0.0, 0.0, 0.0};
};
// The mass properties of a shape in its own frame, with `density` in kg/m3; no mass if the shape has none.
SolidMass shape_mass(const Shape& shape, double density);
// The mass properties of the solid that closed triangles enclose (Tonon 2004). Nothing if they enclose no volume, which
// is possible for open surfaces.
std::optional<SolidMass> surface_mass(const Surface& surface, double density);

} // namespace cairn::scene
