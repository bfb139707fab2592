/// \file mesh_files.h
/// Triangle meshes from OBJ and STL files, as scenes of one body.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cairn::scene {

/// The triangles of a file, as they stand in it.
struct MeshFile {
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> indices; ///< Three a triangle, counterclockwise as seen from outside.

    /// For looks alone: places in textures, u to the right and v down, and normals, with one of them for each of
    /// `indices`, or none (`nothing`).
    static constexpr std::uint32_t nothing = 0xFFFFFFFF;
    std::vector<glm::vec2> coordinates{};
    std::vector<Vec3> normals{};
    std::vector<std::uint32_t> coordinate_of{}, normal_of{};
    std::vector<std::string> libraries{};     ///< Files of materials.
    std::vector<std::string> materials{};     ///< Names of those in use; the first is that of what has none.
    std::vector<std::uint32_t> material_of{}; ///< Of each triangle, in `materials`.
};

/// What a mesh file has to look at: all of it, or what has one of its materials. Vertices are split where coordinates
/// or normals are.
Surface look_of(const MeshFile& mesh, const glm::dvec3& scale, std::optional<std::uint32_t> material = std::nullopt);

/// Wavefront OBJ: `v` and `f` lines, with indices in any of its forms, also negative; polygons are cut into fans from
/// their first corner. `vt`, `vn`, `usemtl` and `mtllib` lines are for looks. Groups count for nothing, other lines are
/// skipped. `name` stands for the file in messages, which
/// name the line. Throws `Error` (invalid_file).
MeshFile read_obj(std::span<const std::byte> bytes, const std::string& name);

/// STL, binary or ASCII. Normals are not read: the order of the corners says which side is outside. Throws `Error`
/// (invalid_file).
MeshFile read_stl(std::span<const std::byte> bytes, const std::string& name);

/// Whether `load_mesh_file` reads files of that name: `.obj` and `.stl`, in any case.
bool is_mesh_file(const std::filesystem::path& path);
MeshFile load_mesh_file(const std::filesystem::path& path);

/// What becomes of a mesh.
struct MeshImport {
    bool as_hull = true;     ///< A dynamic body with the convex hull; else a static one with the triangles.
    bool decompose = false;  ///< Of `as_hull`: several convex parts instead (scene/decomposition.h).
    double scale = 1.0;      ///< Meters of one unit of the file, > 0.
    float density = 1000.0f; ///< kg/m^3, > 0; of hulls.
};

/// A scene with that mesh as its only body, `name`. Throws `Error`: `invalid_value` for a bad
/// option, `invalid_file` for a mesh that has no such shape.
Scene scene_of_mesh(const MeshFile& mesh, const MeshImport& options, const std::string& name);

} // namespace cairn::scene
