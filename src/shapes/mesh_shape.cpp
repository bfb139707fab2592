// The public class Mesh.
#include "shapes/mesh.h"

#include <cairn/shape.h>

namespace cairn {

static_assert(sizeof(math::Vec3) == sizeof(Vec3), "the public vertices are the engine's own, seen as GLM's");

namespace {

MeshData build(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices,
               const SurfaceMaterials& materials) {
    std::vector<math::Vec3> own;
    own.reserve(vertices.size());
    for (const Vec3& v : vertices) own.push_back({v.x, v.y, v.z});
    return build_mesh(own, indices, materials);
}

} // namespace

Mesh::Mesh(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices, const SurfaceMaterials& materials)
    : data_(std::make_shared<const MeshData>(build(vertices, indices, materials))) {}

std::span<const Vec3> Mesh::vertices() const {
    return {reinterpret_cast<const Vec3*>(data_->vertices.data()), data_->vertices.size()};
}
std::span<const std::uint32_t> Mesh::indices() const { return data_->indices; }
const SurfaceMaterials& Mesh::materials() const { return data_->materials; }
std::size_t Mesh::dropped_triangles() const { return std::size_t(data_->dropped); }

} // namespace cairn
