// Collects the definitions of a file being written, to which its nodes refer by index: shapes, materials, filters,
// meshes. Equal definitions are written once.
#pragma once

#include "scene/look_writer.h"
#include "scene/scene.h"

#include <nlohmann/json.hpp>

#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace cairn::scene {

// Lines of JSON.
// The rotation of a shape as the file measures it: its planes face +y, and are measured along x and z.
Quat file_rotation(const Shape& shape, const Quat& rotation);

class DefinitionWriter {
  public:
    explicit DefinitionWriter(const Scene& scene);

    // Returns the index in KHR_implicit_shapes of a shape that is neither a hull nor a mesh.
    std::size_t shape(const Shape& shape);
    std::size_t material(const Shape& shape, const ShapeDef& def);
    // Returns nothing for a filter that lets everything collide.
    std::optional<std::size_t> filter(const CollisionFilter& filter);
    std::size_t joint(const JointDef& joint);
    // Returns the index of a glTF mesh with the triangles of a Hull or a Mesh.
    std::size_t collider_mesh(const Shape& shape);
    std::size_t visual_mesh(const VisualMesh& visual);

    const Table& shapes() const { return shapes_; }
    const Table& materials() const { return materials_; }
    const Table& filters() const { return filters_; }
    const Table& joints() const { return joints_; }
    const Table& meshes() const { return meshes_; }
    const Table& colors() const { return colors_; } // glTF materials
    LookWriter& look_writer() { return look_writer_; }
    const LookWriter& look_writer() const { return look_writer_; }
    const BufferWriter& buffer() const { return buffer_; }
    bool uses_material_extension() const { return uses_material_extension_; }
    bool uses_joint_extension() const { return uses_joint_extension_; }
    bool uses_shape_extension() const { return uses_shape_extension_; }
    bool uses_height_fields() const { return !height_fields_.empty(); }
    bool uses_mesh_extension() const { return uses_mesh_extension_; }

  private:
    void name_layers(const Scene& scene);
    nlohmann::ordered_json layer_names(std::uint64_t layers) const;
    nlohmann::ordered_json height_field(const HeightField& field);
    void add_materials(const SurfaceMaterials& materials, nlohmann::ordered_json& own);

    Table shapes_, materials_, filters_, joints_, meshes_, colors_;
    BufferWriter buffer_;
    LookWriter look_writer_{buffer_};
    // Keyed by the address of shared data; looked up, never iterated.
    std::unordered_map<const void*, std::size_t> collider_meshes_, height_fields_;
    std::map<std::size_t, std::string> layer_names_; // of the layers in use, by bit
    bool uses_material_extension_ = false, uses_joint_extension_ = false, uses_shape_extension_ = false,
         uses_mesh_extension_ = false;
};

} // namespace cairn::scene
