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
/// A Box, a Cylinder or a Hull with `rounding` r > 0 is that solid plus a ball of radius r: all that is within r of the
/// sharp solid (its Minkowski sum with the ball). It is larger by r on every side, its faces stay flat, and its edges
/// and corners are round with radius r. To keep the outer size, take r off the half extents.
struct Box {
    Vec3 half_extents{0.5f, 0.5f, 0.5f}; ///< Of the sharp box: the rounding comes on top.
    float rounding = 0.0f;               ///< Meters, >= 0: radius of the ball that is added to the sharp box.
};

/// A plane through the shape's origin; solid is the side away from `normal`.
/// Without `half_extents` it is an infinite half-space. With them it is a rectangle, `half_extents[0]` along the
/// shape's `tangent` and `half_extents[1]` along normal x tangent; the rectangle is one-sided, and pushes along its
/// normal whatever is above it or has sunk in so that a part of it is still above. Where one half extent is infinite,
/// it is a strip: without ends along that axis.
/// Double-sided, it is a sheet without thickness that holds things on both sides: an infinite one pushes a body to the
/// side where its center of mass is, a rectangle or strip pushes a shape to the side where the shape's middle is. Rays
/// and casts meet a sheet from either side, and nothing is inside of it.
/// Planes have no mass: they may only be added to static and kinematic bodies.
struct Plane {
    Vec3 normal{0.0f, 1.0f, 0.0f};           ///< Any non-zero finite vector; it is normalized.
    Vec3 tangent{1.0f, 0.0f, 0.0f};          ///< Only for the rectangle; made orthogonal to `normal`.
    std::optional<glm::vec2> half_extents{}; ///< Meters, each > 0, one may be infinite; absent for an infinite plane.
    bool double_sided = false;
};

/// The convex hull of two balls on the shape's y axis, their centers at -half_height and +half_height. Meters, all > 0
/// (`radius_top` >= 0).
struct Capsule {
    float half_height = 0.5f;
    float radius = 0.25f;              ///< Of both balls, or of the lower one if `radius_top` is given.
    std::optional<float> radius_top{}; ///< Of the upper ball: a tapered capsule.
};

/// A solid cylinder around the shape's y axis, from -half_height to +half_height. Meters, all > 0 (`radius_top` >= 0);
/// without its rounding.
struct Cylinder {
    float half_height = 0.5f;
    float radius = 0.5f;               ///< At both ends, or at the lower end if `radius_top` is given.
    std::optional<float> radius_top{}; ///< At the upper end: a tapered cylinder, or with 0 a cone.
    float rounding = 0.0f;             ///< Meters, >= 0: radius of the ball that is added to the sharp cylinder.
};

/// A cone around the shape's y axis: base at -half_height, tip at +half_height.
constexpr Cylinder cone(float radius, float half_height) { return {half_height, radius, 0.0f}; }

/// A convex polyhedron. Its corners never change, so that copies share their data, and it is cheap to copy.
class Hull {
  public:
    /// The convex hull of any points, meters, in the shape's frame. Throws `Error` (invalid_value) when a coordinate
    /// is not finite or exceeds 1e6, when there are fewer than 4 points, or when they all lie in one point, on one
    /// line or in one plane (within a thousandth of a percent of their extent).
    explicit Hull(std::span<const Vec3> points);

    /// Meters, >= 0: radius of the ball that is added to the sharp polyhedron. Not shared by copies. What the functions
    /// below say is without it.
    float rounding = 0.0f;

    std::span<const Vec3> vertices() const; ///< Corners, in a fixed order; points inside and on faces are left out.
    std::size_t face_count() const;         ///< Neighboring triangles of one plane are one face.
    /// Indices of the corners of a face, counterclockwise as seen from outside. Throws `Error` beyond face_count().
    std::span<const std::uint32_t> face(std::size_t index) const;
    double volume() const; ///< m^3.

    /// For the engine.
    const std::shared_ptr<const HullData>& data() const { return data_; }
    explicit Hull(std::shared_ptr<const HullData> data) : data_(std::move(data)) {}

  private:
    std::shared_ptr<const HullData> data_;
};

/// How the coefficients of two touching materials become one. Where the two materials disagree on the rule,
/// the stronger one counts, in the order average > minimum > maximum > multiply (KHR_physics_rigid_bodies).
enum class CombineRule : std::uint8_t { average, minimum, maximum, multiply };

/// Surface properties of a shape.
struct Material {
    float static_friction = 0.6f;      ///< Coulomb coefficient while the contact sticks, >= 0.
    float dynamic_friction = 0.6f;     ///< Coulomb coefficient while it slides, >= 0.
    float restitution = 0.0f;          ///< Ratio of rebound to approach speed, 0 (no bounce) to 1 (elastic).
    float rolling_friction = 0.0f;     ///< Lever arm of the rolling resistance torque in meters, >= 0.
    float torsional_friction = 0.001f; ///< Radius of the contact patch in meters, >= 0: a spinning one-point contact
                                       ///< feels a torque of at most friction x normal force x this radius. Without
                                       ///< any, a ball that spins upright never comes to rest.
    CombineRule friction_combine = CombineRule::average;
    CombineRule restitution_combine = CombineRule::average;
};

/// Materials of the parts of a mesh or height field, beside that of the shape (`ShapeDef::material`).
struct SurfaceMaterials {
    std::vector<Material> materials{}; ///< At most 65,535.
    /// Which one each triangle of a mesh has, or each cell of a height field, row after row: 0 for that of the shape,
    /// k for materials[k - 1]. Empty: all have that of the shape.
    std::vector<std::uint16_t> numbers{};
};

/// A surface of triangles, for static and kinematic bodies. Solid is the side that sees the corners clockwise: what
/// has sunk below a triangle so that a part of it is still above is pushed out along its normal. Walls may be as thin
/// as you like: sheets whose triangles have others on their backs hold on both sides. It never changes, so that copies
/// share their data, and is cheap to copy.
class Mesh {
  public:
    /// Three indices a triangle, counterclockwise as seen from outside. Corners at the same place count as one;
    /// triangles without area are left out (see `dropped_triangles`). Throws `Error` (invalid_value) when a coordinate
    /// is not finite or exceeds 1e6, when an index is out of range or their number is no multiple of three, when no
    /// triangle is left, or when `materials` has a material that is none, a number beyond them, or numbers that are not
    /// as many as the triangles.
    Mesh(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices,
         const SurfaceMaterials& materials = {});

    std::span<const Vec3> vertices() const;         ///< Meters, in the shape's frame.
    std::span<const std::uint32_t> indices() const; ///< Three a triangle.
    std::size_t dropped_triangles() const;          ///< How many had no area.
    const SurfaceMaterials& materials() const;      ///< A number for each triangle of `indices()`, or none.

    /// For the engine.
    const std::shared_ptr<const MeshData>& data() const { return data_; }
    explicit Mesh(std::shared_ptr<const MeshData> data) : data_(std::move(data)) {}

  private:
    std::shared_ptr<const MeshData> data_;
};

/// A surface over a grid in the shape's xz plane, solid below, for static and kinematic bodies. It never changes, so
/// that copies share their data, and is cheap to copy.
class HeightField {
  public:
    /// A height that is none: the triangles that would have a corner there are holes. +infinity.
    static constexpr float hole = std::numeric_limits<float>::infinity();

    /// `heights`, meters along y, row after row: that of column c and row r is heights[r * columns + c], and stands at
    /// x = (c - (columns - 1) / 2) * spacing.x, z = (r - (rows - 1) / 2) * spacing.y. Each cell is two triangles, cut
    /// from its corner of least x and z to the opposite one. Throws `Error` (invalid_value) for fewer than 2 columns
    /// or rows, more than 2^28 heights, a number of heights that is not columns x rows, a spacing that is no size, a
    /// height that is no number or exceeds 1e6 and is not `hole`, holes alone, or `materials` with a material that is
    /// none, a number beyond them, or numbers that are not as many as the cells.
    HeightField(int columns, int rows, const glm::vec2& spacing, std::span<const float> heights,
                const SurfaceMaterials& materials = {});

    int columns() const;
    int rows() const;
    glm::vec2 spacing() const; ///< Meters along x and z.
    std::span<const float> heights() const;
    const SurfaceMaterials& materials() const;  ///< A number for each cell, or none.
    std::vector<Vec3> vertices() const;         ///< Where the heights stand, meters; y of a hole is `hole`.
    std::vector<std::uint32_t> indices() const; ///< Of the triangles that are no holes; three each, as those of a mesh.

    /// For the engine.
    const std::shared_ptr<const HeightFieldData>& data() const { return data_; }
    explicit HeightField(std::shared_ptr<const HeightFieldData> data) : data_(std::move(data)) {}

  private:
    std::shared_ptr<const HeightFieldData> data_;
};

/// Any shape. A compound is a body with several of them.
using Shape = std::variant<Sphere, Box, Plane, Capsule, Cylinder, Hull, Mesh, HeightField>;

enum class ShapeType : std::uint8_t { sphere, box, plane, rectangle, capsule, cylinder, hull, mesh, height_field };

/// Which shapes meet: two do if each is in a layer that the other collides with.
struct CollisionFilter {
    std::uint64_t layers = 1;                       ///< The layers that the shape is in, one bit each.
    std::uint64_t collides_with = ~std::uint64_t{}; ///< The layers that it collides with.
};

/// How a shape is attached to its body.
struct ShapeDef {
    Vec3 position{0.0f, 0.0f, 0.0f};       ///< Origin of the shape in the body's frame, meters; within 1e15.
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f}; ///< Orientation in the body's frame; normalized, must not be zero.
    float density = 1000.0f;               ///< kg/m^3, >= 0; 0 adds no mass. Ignored by planes.
    Material material{};
    CollisionFilter filter{};
    /// A trigger touches nothing: it only reports what overlaps it (`World::trigger_events`).
    bool is_trigger = false;
    /// m/s, in the shape's frame: the surface moves with it like a conveyor belt, beside the motion of the body. Only
    /// its part along the surface counts. Static and kinematic bodies only.
    Vec3 surface_velocity{0.0f, 0.0f, 0.0f};
    std::uint64_t user_data = 0; ///< Not touched by the engine.
    /// A direction in the shape's frame, of any length. Not zero: the shape holds only what came from there. What is
    /// not wholly beyond it in that direction when the two meet goes through it, until it is: onto such a platform one
    /// jumps from below. Static and kinematic bodies only; infinite planes, meshes and height fields have none. Rays,
    /// casts and other queries meet it from all sides.
    Vec3 one_way{0.0f, 0.0f, 0.0f};
};

} // namespace cairn
