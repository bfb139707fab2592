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

/// The triangles of a file as written in it.
struct MeshFile {
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> indices; ///< Three per triangle, counterclockwise as seen from outside.

    /// For visuals only: texture coordinates, u to the right and v down, and normals. `coordinate_of` and `normal_of`
    /// have one entry for each of `indices`, or are empty; an entry may be `nothing`.
    static constexpr std::uint32_t nothing = 0xFFFFFFFF;
    std::vector<glm::vec2> coordinates{};
    std::vector<Vec3> normals{};
    std::vector<std::uint32_t> coordinate_of{}, normal_of{};
    std::vector<std::string> libraries{}; ///< Names of material library files.
    /// Names of the materials in use; the first stands for triangles without a material.
    std::vector<std::string> materials{};
    std::vector<std::uint32_t> material_of{}; ///< For each triangle, an index into `materials`.
};

/// Returns the visual surface of a mesh file: all of its triangles, or those with one of its materials. Vertices are
/// split where texture coordinates or normals differ.
Surface visual_surface(const MeshFile& mesh, const glm::dvec3& scale,
                       std::optional<std::uint32_t> material = std::nullopt);

/// Wavefront OBJ: `v` and `f` lines with indices in any form, also negative; polygons are cut into fans from their
/// first corner. `vt`, `vn`, `usemtl` and `mtllib` lines are read for visuals. Groups are ignored, other lines are
/// skipped. `name` stands for the file in messages, which name the line. Throws `Error` (invalid_file).
MeshFile read_obj(std::span<const std::byte> bytes, const std::string& name);

/// STL, binary or ASCII. Normals are not read: the order of the vertices tells which side is outside. Throws `Error`
/// (invalid_file).
MeshFile read_stl(std::span<const std::byte> bytes, const std::string& name);

/// Whether `load_mesh_file` reads files of that name: `.obj` and `.stl`, in any case.
bool is_mesh_file(const std::filesystem::path& path);
MeshFile load_mesh_file(const std::filesystem::path& path);

/// How a mesh is imported.
struct MeshImport {
    bool as_hull = true;     ///< True: a dynamic body with the convex hull; false: a static body with the triangles.
    bool decompose = false;  ///< With `as_hull`: several convex parts instead of one hull (scene/decomposition.h).
    double scale = 1.0;      ///< Meters of one unit of the file, > 0.
    float density = 1000.0f; ///< kg/m^3, > 0; for hulls only.
};

/// Returns a scene with the mesh as its only body, called `name`. Throws `Error`: `invalid_value` for a bad option,
/// `invalid_file` for a mesh that has no such shape.
Scene scene_of_mesh(const MeshFile& mesh, const MeshImport& options, const std::string& name);

} // namespace cairn::scene
