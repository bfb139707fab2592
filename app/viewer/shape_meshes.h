/// \file shape_meshes.h
/// Triangle meshes of shapes with individual geometry: hulls, meshes, height fields, and rounded shapes.
#pragma once

#include "viewer/bending.h"
#include "viewer/meshes.h"
#include "viewer/textures.h"

#include <cairn/shape.h>

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace cairn::viewer {

/// Drawing style of an individual mesh.
enum class MeshVisual {
    facets,  ///< A solid, flat-shaded.
    surface, ///< Ground or wall: with a grid, two-sided.
    terrain, ///< As `surface`, with steep slopes colored like rock.
    visual,  ///< A visual mesh of the scene.
};

/// A range of neighboring triangles, drawn or culled as a whole.
struct MeshPart {
    std::size_t first = 0, count = 0; ///< Range of `TriangleMesh::indices`.
    Vec3 center{0.0f, 0.0f, 0.0f};    ///< Center of a bounding sphere, in the shape's frame ...
    float radius = 0.0f;              ///< ... and its radius, meters.
};
inline constexpr std::size_t triangles_per_part = 8192;

struct ShapeMesh {
    TriangleMesh triangles; ///< `corner` in meters, in the shape's frame.
    MeshVisual look = MeshVisual::facets;
    Vec3 center{0.0f, 0.0f, 0.0f}; ///< Center of the bounding box, in the shape's frame, meters.
    Vec3 extent{0.0f, 0.0f, 0.0f}; ///< Half extents of the bounding box, meters.
    float radius = 0.0f;           ///< Radius of a bounding sphere around `center`, meters.
    std::vector<MeshPart> parts;   ///< Parts of all triangles, in order.
    /// Null: none. Texture coordinates, also for the finish, are in `inset`: x to the right and y down, 0 to 1 across
    /// the texture.
    std::shared_ptr<const TexturePicture> texture{};
    std::shared_ptr<const Finish> finish{}; ///< Null: glossy, like plastic.
    std::vector<BoneWeights> weights{};     ///< One for each vertex of a skinned mesh; else empty.
};

/// The faces of a hull, flat-shaded.
TriangleMesh hull_triangles(const Hull& hull);

/// Cosine of the angle between neighboring triangles below which they are smooth-shaded.
inline constexpr float smooth_cosine = 0.8660254f; // 30 degrees

/// The same triangles, smooth-shaded across edges of less than 30 degrees, with a sharp crease at others. Indices as in
/// `Mesh`.
TriangleMesh surface_triangles(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices);

/// The triangles of a height field, smooth-shaded. Fields of more than `max_heights` heights are drawn with every
/// second (third, ...) row and column, and their last ones. Triangles of one part are contiguous.
TriangleMesh height_field_triangles(const HeightField& field);
inline constexpr std::size_t max_heights = std::size_t(1) << 22;

/// Triangles with the given normals, one for each vertex, or flat-shaded without any; and texture coordinates and
/// colors, one for each vertex, or none. All indices must be in range.
TriangleMesh visual_triangles(std::span<const Vec3> vertices, std::span<const Vec3> normals,
                              std::span<const std::uint32_t> indices, std::span<const glm::vec2> coordinates = {},
                              std::span<const Vec3> colors = {});

/// A rounded box, cylinder or hull (see `rounding_of`).
TriangleMesh rounded_shape_triangles(const Shape& shape);

/// Computes bounds and parts.
ShapeMesh make_shape_mesh(TriangleMesh triangles, MeshVisual look);

/// The meshes of the hulls, meshes, height fields and rounded shapes of a world, each generated on first use. Shapes
/// that share their data, or are equal, share their mesh.
class MeshCache {
  public:
    /// Null for shapes of other types.
    std::shared_ptr<const ShapeMesh> mesh_of(const Shape& shape);
    /// Drops meshes that were not requested since the last call.
    void drop_unused();
    std::size_t size() const noexcept { return entries_.size(); }

  private:
    struct Entry {
        Shape shape; // kept alive so that the address of its data stays unique
        std::shared_ptr<const ShapeMesh> mesh;
        bool used = true;
    };
    using Key = std::pair<const void*, std::vector<float>>; // address of shared data; sizes of rounded shapes
    std::map<Key, Entry> entries_;
};

} // namespace cairn::viewer
