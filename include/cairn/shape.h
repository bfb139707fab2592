/// \file shape.h
/// Shapes and surface materials.
#pragma once

#include <cairn/handle.h>
#include <cairn/math.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace cairn {

struct HullData;
struct MeshData;
struct HeightFieldData;

/// A ball around the shape's origin. `radius` in meters, > 0.
struct Sphere {
    float radius = 0.5f;
};

/// A box around the shape's origin. `half_extents` in meters, each > 0.
///
/// A Box, Cylinder or Hull with `rounding` r > 0 is the Minkowski sum of the sharp solid and a ball of radius r: all
/// points within a distance r of the sharp solid. It is larger by r on every side; its faces stay flat, and its edges
/// and corners are rounded with radius r. To keep the outer size, subtract r from the half extents.
struct Box {
    /// Half extents of the sharp box, meters, each > 0; the rounding adds to them.
    Vec3 half_extents{0.5f, 0.5f, 0.5f};
    float rounding = 0.0f; ///< Meters, >= 0: radius of the ball that is added to the sharp box.
};

/// A plane through the shape's origin, solid on the side opposite to `normal`. Without `half_extents` it is an infinite
/// half-space. With them it is a rectangle: `half_extents[0]` along `tangent`, `half_extents[1]` along normal x
/// tangent. A rectangle is one-sided: it pushes shapes along its normal that are above it, or that have sunk into it
/// and are still partly above. With one infinite half extent it is a strip, without ends along that axis. A
/// double-sided plane is a sheet without thickness that collides on both sides: an infinite one pushes a body to the
/// side on which its center of mass is; a rectangle or strip pushes a shape to the side on which the middle of that
/// shape is. Rays and casts hit a sheet from both sides, and no point is inside of it. Planes have no mass, and may
/// only be added to static and kinematic bodies.
struct Plane {
    Vec3 normal{0.0f, 1.0f, 0.0f}; ///< Any non-zero finite vector; it is normalized.
    /// Direction of `half_extents[0]`; it is made orthogonal to `normal`. Used only by rectangles and strips.
    Vec3 tangent{1.0f, 0.0f, 0.0f};
    std::optional<glm::vec2> half_extents{}; ///< Meters, each > 0; one may be infinite. Absent: an infinite plane.
    bool double_sided = false;
};

/// The convex hull of two balls on the shape's y axis, their centers at -half_height and +half_height. Meters, all > 0
/// (`radius_top` >= 0).
struct Capsule {
    float half_height = 0.5f;
    float radius = 0.25f;              ///< Radius of both balls, or of the lower one if `radius_top` is given.
    std::optional<float> radius_top{}; ///< Radius of the upper ball, >= 0, for a tapered capsule; absent: `radius`.
};

/// A solid cylinder around the shape's y axis, from -half_height to +half_height. Meters, all > 0 (`radius_top` >= 0);
/// the rounding adds to these sizes.
struct Cylinder {
    float half_height = 0.5f;
    float radius = 0.5f; ///< Radius at both ends, or at the lower end if `radius_top` is given.
    /// Radius at the upper end, >= 0, for a tapered cylinder, or a cone if it is 0; absent: `radius`.
    std::optional<float> radius_top{};
    float rounding = 0.0f; ///< Meters, >= 0: radius of the ball that is added to the sharp cylinder.
};

/// A cone around the shape's y axis, with its base at -half_height and its tip at +half_height. Meters, both > 0.
constexpr Cylinder cone(float radius, float half_height) { return {half_height, radius, 0.0f}; }

/// A convex polyhedron. Its vertices never change, so that copies share their data and are cheap.
class Hull {
  public:
    /// The convex hull of `points`, meters, in the shape's frame. Throws `Error` (invalid_value) when a coordinate is
    /// not finite or exceeds 1e6, when there are fewer than 4 points, or when all of them coincide, lie on one line or
    /// lie in one plane (within 1e-5 of their extent).
    explicit Hull(std::span<const Vec3> points);

    /// Meters, >= 0: radius of the ball that is added to the sharp polyhedron. Each copy has its own. The functions
    /// below describe the sharp polyhedron, without rounding.
    float rounding = 0.0f;

    /// Vertices, meters, in a fixed order; points inside the hull or on its faces are omitted.
    std::span<const Vec3> vertices() const;
    std::size_t face_count() const; ///< Number of faces; adjacent coplanar triangles form one face.
    /// Indices of the vertices of a face, counterclockwise as seen from outside. Throws `Error` unless index <
    /// face_count().
    std::span<const std::uint32_t> face(std::size_t index) const;
    double volume() const; ///< Volume, m^3.

    /// For the engine.
    const std::shared_ptr<const HullData>& data() const { return data_; }
    explicit Hull(std::shared_ptr<const HullData> data) : data_(std::move(data)) {}

  private:
    std::shared_ptr<const HullData> data_;
};

/// How the coefficients of two materials in contact are combined into one. If their rules differ, the one with
/// precedence applies, in the order average > minimum > maximum > multiply (KHR_physics_rigid_bodies).
enum class CombineRule : std::uint8_t { average, minimum, maximum, multiply };

/// Surface properties of a shape.
struct Material {
    float static_friction = 0.6f;  ///< Coulomb coefficient while the contact sticks, >= 0.
    float dynamic_friction = 0.6f; ///< Coulomb coefficient while it slides, >= 0.
    float restitution = 0.0f;      ///< Ratio of rebound to approach speed, 0 (no bounce) to 1 (elastic).
    float rolling_friction = 0.0f; ///< Lever arm of the rolling resistance torque in meters, >= 0.
    /// Radius of the contact patch in meters, >= 0: a spinning one-point contact feels a torque of at most friction x
    /// normal force x this radius. With 0, a ball that spins about the contact normal never comes to rest.
    float torsional_friction = 0.001f;
    CombineRule friction_combine = CombineRule::average;
    CombineRule restitution_combine = CombineRule::average;
};

/// Materials of parts of a mesh or height field, in addition to that of the shape (`ShapeDef::material`).
struct SurfaceMaterials {
    std::vector<Material> materials{}; ///< At most 65,535 materials.
    /// Material of each triangle of a mesh, or of each cell of a height field, row by row: 0 for the material of the
    /// shape, k for materials[k - 1]. Empty: all have the material of the shape.
    std::vector<std::uint16_t> numbers{};
};

/// A triangle mesh, for static and kinematic bodies. The solid side of a triangle is the one from which its vertices
/// appear clockwise: a shape that has sunk below a triangle and is still partly above it is pushed out along the
/// normal. Walls may be arbitrarily thin: a sheet that has triangles facing both ways collides on both sides. A mesh
/// never changes, so that copies share their data and are cheap.
class Mesh {
  public:
    /// `vertices`: meters, in the shape's frame. `indices`: three for each triangle, counterclockwise as seen from
    /// outside. Vertices at the same place are merged; triangles without area are omitted (see `dropped_triangles`).
    /// Throws `Error` (invalid_value) when a coordinate is not finite or exceeds 1e6, when an index is out of range,
    /// when the number of indices is not a multiple of three, when no triangle is left, or when `materials` has an
    /// invalid material, a number out of range, or a count of numbers other than 0 or that of the triangles.
    Mesh(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices,
         const SurfaceMaterials& materials = {});

    std::span<const Vec3> vertices() const;         ///< Meters, in the shape's frame.
    std::span<const std::uint32_t> indices() const; ///< Three for each triangle.
    std::size_t dropped_triangles() const;          ///< How many triangles were omitted because they have no area.
    const SurfaceMaterials& materials() const; ///< Its `numbers` are one for each triangle of `indices()`, or empty.

    /// For the engine.
    const std::shared_ptr<const MeshData>& data() const { return data_; }
    explicit Mesh(std::shared_ptr<const MeshData> data) : data_(std::move(data)) {}

  private:
    std::shared_ptr<const MeshData> data_;
};

/// A surface over a grid in the shape's xz plane, solid below, for static and kinematic bodies. It never changes, so
/// that copies share their data and are cheap.
class HeightField {
  public:
    /// The height (+infinity) of a missing sample: the triangles that have a vertex there are holes.
    static constexpr float hole = std::numeric_limits<float>::infinity();

    /// `heights`: meters along y, row by row. The height of column c and row r is heights[r * columns + c], at x = (c -
    /// (columns - 1) / 2) * spacing.x, z = (r - (rows - 1) / 2) * spacing.y; `spacing` is in meters, > 0. Each cell
    /// consists of two triangles, divided by the diagonal from its corner of least x and z. Throws `Error`
    /// (invalid_value) for fewer than 2 columns or rows, more than 2^28 heights, a count of heights other than columns
    /// x rows, a spacing that is not finite and > 0, a height that is NaN or exceeds 1e6 and is not `hole`, a field
    /// that consists of holes only, or `materials` with an invalid material, a number out of range, or a count of
    /// numbers other than 0 or that of the cells.
    HeightField(int columns, int rows, const glm::vec2& spacing, std::span<const float> heights,
                const SurfaceMaterials& materials = {});

    int columns() const;
    int rows() const;
    glm::vec2 spacing() const; ///< Meters along x and z.
    std::span<const float> heights() const;
    const SurfaceMaterials& materials() const; ///< Its `numbers` are one for each cell, or empty.
    std::vector<Vec3> vertices() const; ///< The points of the grid with their heights, meters; y of a hole is `hole`.
    std::vector<std::uint32_t> indices() const; ///< Three for each triangle that is not a hole, as for a mesh.

    /// For the engine.
    const std::shared_ptr<const HeightFieldData>& data() const { return data_; }
    explicit HeightField(std::shared_ptr<const HeightFieldData> data) : data_(std::move(data)) {}

  private:
    std::shared_ptr<const HeightFieldData> data_;
};

/// Any shape. A compound is a body with several shapes.
using Shape = std::variant<Sphere, Box, Plane, Capsule, Cylinder, Hull, Mesh, HeightField>;

enum class ShapeType : std::uint8_t { sphere, box, plane, rectangle, capsule, cylinder, hull, mesh, height_field };

/// Decides which shapes collide: two shapes do if each is in a layer with which the other collides.
struct CollisionFilter {
    std::uint64_t layers = 1;                       ///< Layers to which the shape belongs, one bit for each.
    std::uint64_t collides_with = ~std::uint64_t{}; ///< Layers with which the shape collides.
};

/// How a shape is attached to its body.
struct ShapeDef {
    Vec3 position{0.0f, 0.0f, 0.0f};       ///< Origin of the shape in the body's frame, meters; within 1e15.
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f}; ///< Orientation in the body's frame; normalized, must not be zero.
    float density = 1000.0f;               ///< kg/m^3, >= 0; with 0 the shape adds no mass. Not used for planes.
    Material material{};
    CollisionFilter filter{};
    /// true: the shape is a trigger. It has no contacts, and only reports shapes that overlap it
    /// (`World::trigger_events`).
    bool is_trigger = false;
    /// m/s, in the shape's frame: velocity of the surface relative to the body, as of a conveyor belt. Only its
    /// component along the surface counts. Static and kinematic bodies only.
    Vec3 surface_velocity{0.0f, 0.0f, 0.0f};
    std::uint64_t user_data = 0; ///< Stored for the application; the engine does not use it.
    /// A direction in the shape's frame, of any length; zero: none. Otherwise the shape is a one-way platform: it
    /// collides only with shapes that come from that side. A shape that is not entirely on that side when the two meet
    /// passes through until it is, so that one can jump onto the platform from below. Static and kinematic bodies only;
    /// infinite planes, meshes and height fields cannot be one-way. Rays, casts and other queries find the shape from
    /// all sides.
    Vec3 one_way{0.0f, 0.0f, 0.0f};
};

} // namespace cairn
