/// \file shape_meshes.h
/// The triangles of shapes that have a form of their own: hulls, meshes, height fields, and what is rounded.
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

/// How a mesh of its own is painted.
enum class MeshLook {
    facets,  ///< A solid: every face flat.
    surface, ///< Ground or wall: with a grid, and seen from behind too.
    terrain, ///< The same, and steep slopes look like rock.
    visual,  ///< Came with the scene for its looks.
};

/// A run of neighboring triangles, which is drawn or left out as a whole.
struct MeshPart {
    std::size_t first = 0, count = 0; ///< Of `TriangleMesh::indices`.
    Vec3 center{0.0f, 0.0f, 0.0f};    ///< A ball that holds it, in the shape's frame ...
    float radius = 0.0f;              ///< ... meters.
};
inline constexpr std::size_t triangles_per_part = 8192;

struct ShapeMesh {
    TriangleMesh triangles; ///< `corner` in meters, in the shape's frame.
    MeshLook look = MeshLook::facets;
    Vec3 center{0.0f, 0.0f, 0.0f}; ///< Of the bounds, in the shape's frame, meters.
    Vec3 extent{0.0f, 0.0f, 0.0f}; ///< Half of the bounds' edges, meters.
    float radius = 0.0f;           ///< A ball around `center` holds everything, meters.
    std::vector<MeshPart> parts;   ///< All triangles, in order.
    /// Null: none. Where in it and the pictures of the finish a vertex lies is in `inset`, x to the right and y down, 0
    /// to 1 across the picture.
    std::shared_ptr<const TexturePicture> texture{};
    std::shared_ptr<const Finish> finish{}; ///< Null: smooth, as of plastic.
    std::vector<BoneWeights> weights{};     ///< Of what bends, one for each vertex; else none.
};

/// The faces of a hull, flat.
TriangleMesh hull_triangles(const Hull& hull);

/// Neighboring triangles that lean by less than this against each other are shaded as one curved surface.
inline constexpr float smooth_cosine = 0.8660254f; // 30 degrees

/// The same triangles, smooth where they meet at less than 30 degrees, with an edge where they meet at more. Indices as
/// in `Mesh`.
TriangleMesh surface_triangles(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices);

/// The triangles of a height field, shaded as one curved surface. Fields of more than `max_heights` heights are drawn
/// with every second (third, ...) row and column, and their last ones. Triangles of one part lie together.
TriangleMesh height_field_triangles(const HeightField& field);
inline constexpr std::size_t max_heights = std::size_t(1) << 22;

/// Triangles with the normals given, one for each vertex, or flat ones if there are none; and places in a texture and
/// colors, one for each vertex, or none. All indices in range.
TriangleMesh visual_triangles(std::span<const Vec3> vertices, std::span<const Vec3> normals,
                              std::span<const std::uint32_t> indices, std::span<const glm::vec2> coordinates = {},
                              std::span<const Vec3> colors = {});

/// A rounded box, cylinder or hull (see `rounding_of`).
TriangleMesh rounded_shape_triangles(const Shape& shape);

/// With bounds and parts.
ShapeMesh make_shape_mesh(TriangleMesh triangles, MeshLook look);

/// The meshes of the hulls, meshes, height fields and rounded shapes of a world, each made once, when it is first asked
/// for. Shapes that share their data, or are alike, share their mesh.
class MeshCache {
  public:
    /// Null for shapes of other types.
    std::shared_ptr<const ShapeMesh> mesh_of(const Shape& shape);
    /// Drops what was not asked for since the last call.
    void drop_unused();
    std::size_t size() const noexcept { return entries_.size(); }

  private:
    struct Entry {
        Shape shape; // keeps the data alive, so that its address stays its own
        std::shared_ptr<const ShapeMesh> mesh;
        bool used = true;
    };
    using Key = std::pair<const void*, std::vector<float>>; // shared data; sizes of what is rounded
    std::map<Key, Entry> entries_;
};

} // namespace cairn::viewer
