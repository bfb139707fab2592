// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#ifndef CAIRN_C_SHAPE_H
#define CAIRN_C_SHAPE_H

#include <cairn/c/math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// How the coefficients of two touching materials become one. Where the two materials disagree on the rule, the
/// stronger one counts, in the order average > minimum > maximum > multiply (KHR_physics_rigid_bodies).
typedef int32_t cairn_combine_rule;
enum {
    CAIRN_COMBINE_RULE_AVERAGE = 0, ///< The mean of both.
    CAIRN_COMBINE_RULE_MINIMUM = 1, ///< The smaller one.
    CAIRN_COMBINE_RULE_MAXIMUM = 2, ///< The greater one.
    CAIRN_COMBINE_RULE_MULTIPLY = 3 ///< The product of both.
};

/// A ball around the shape's origin. `radius` in meters, > 0.
typedef struct cairn_sphere {
    float radius; ///< Meters, > 0.
} cairn_sphere;
CAIRN_C_API cairn_sphere cairn_default_sphere(void);

/// A box around the shape's origin. `half_extents` in meters, each > 0. A Box, a Cylinder or a Hull with `rounding` r >
/// 0 is that solid plus a ball of radius r: all that is within r of the sharp solid (its Minkowski sum with the ball).
/// It is larger by r on every side, its faces stay flat, and its edges and corners are round with radius r. To keep the
/// outer size, take r off the half extents.
typedef struct cairn_box {
    cairn_vec3 half_extents; ///< Meters, each > 0, of the sharp box: the rounding comes on top.
    float rounding; ///< Meters, >= 0: radius of the ball that is added to the sharp box.
} cairn_box;
CAIRN_C_API cairn_box cairn_default_box(void);

/// A plane through the shape's origin; solid is the side away from `normal`. Without `half_extents` it is an infinite
/// half-space. With them it is a rectangle, `half_extents[0]` along the shape's `tangent` and `half_extents[1]` along
/// normal x tangent; the rectangle is one-sided, and pushes along its normal whatever is above it or has sunk in so
/// that a part of it is still above. Where one half extent is infinite, it is a strip: without ends along that axis.
/// Double-sided, it is a sheet without thickness that holds things on both sides: an infinite one pushes a body to the
/// side where its center of mass is, a rectangle or strip pushes a shape to the side where the shape's middle is. Rays
/// and casts meet a sheet from either side, and nothing is inside of it. Planes have no mass: they may only be added to
/// static and kinematic bodies.
typedef struct cairn_plane {
    cairn_vec3 normal; ///< Any non-zero finite vector; it is normalized.
    cairn_vec3 tangent; ///< Only for the rectangle; made orthogonal to `normal`.
    bool has_half_extents; ///< Whether `half_extents` is given.
    cairn_vec2 half_extents; ///< Meters, each > 0, one may be infinite; absent for an infinite plane.
    bool double_sided; ///< A sheet that holds things on both sides.
} cairn_plane;
CAIRN_C_API cairn_plane cairn_default_plane(void);

/// The convex hull of two balls on the shape's y axis, their centers at -half_height and +half_height. Meters, all > 0
/// (`radius_top` >= 0).
typedef struct cairn_capsule {
    float half_height; ///< Meters, > 0, along the y axis.
    float radius; ///< Of both balls, or of the lower one if `radius_top` is given. (m, > 0)
    bool has_radius_top; ///< Whether `radius_top` is given.
    float radius_top; ///< Of the upper ball: a tapered capsule. (m, >= 0)
} cairn_capsule;
CAIRN_C_API cairn_capsule cairn_default_capsule(void);

/// A solid cylinder around the shape's y axis, from -half_height to +half_height. Meters, all > 0 (`radius_top` >= 0);
/// without its rounding.
typedef struct cairn_cylinder {
    float half_height; ///< Meters, > 0, along the y axis.
    float radius; ///< At both ends, or at the lower end if `radius_top` is given. (m, > 0)
    bool has_radius_top; ///< Whether `radius_top` is given.
    float radius_top; ///< At the upper end: a tapered cylinder, or with 0 a cone. (m, >= 0)
    float rounding; ///< Meters, >= 0: radius of the ball that is added to the sharp cylinder.
} cairn_cylinder;
CAIRN_C_API cairn_cylinder cairn_default_cylinder(void);

/// A convex polyhedron.
typedef struct cairn_hull {
    const cairn_geometry* geometry; ///< Made by `cairn_geometry_create_hull`.
    float rounding; ///< Meters, >= 0: radius of the ball that is added to the sharp polyhedron.
} cairn_hull;
CAIRN_C_API cairn_hull cairn_default_hull(void);

/// A surface of triangles, for static and kinematic bodies. Solid is the side that sees the corners clockwise.
typedef struct cairn_mesh {
    const cairn_geometry* geometry; ///< Made by `cairn_geometry_create_mesh`.
} cairn_mesh;
CAIRN_C_API cairn_mesh cairn_default_mesh(void);

/// A surface over a grid in the shape's xz plane, solid below, for static and kinematic bodies.
typedef struct cairn_height_field {
    const cairn_geometry* geometry; ///< Made by `cairn_geometry_create_height_field`.
} cairn_height_field;
CAIRN_C_API cairn_height_field cairn_default_height_field(void);

/// Surface properties of a shape.
typedef struct cairn_material {
    float static_friction; ///< Coulomb coefficient while the contact sticks, >= 0.
    float dynamic_friction; ///< Coulomb coefficient while it slides, >= 0.
    float restitution; ///< Ratio of rebound to approach speed, 0 (no bounce) to 1 (elastic). (0 to 1)
    float rolling_friction; ///< Lever arm of the rolling resistance torque in meters, >= 0.
    /// Radius of the contact patch in meters, >= 0: a spinning one-point contact feels a torque of at most friction x
    /// normal force x this radius. Without any, a ball that spins upright never comes to rest.
    float torsional_friction;
    cairn_combine_rule friction_combine; ///< How its friction and the other material's become one.
    cairn_combine_rule restitution_combine; ///< How its restitution and the other material's become one.
} cairn_material;
CAIRN_C_API cairn_material cairn_default_material(void);

/// Which shapes meet: two do if each is in a layer that the other collides with.
typedef struct cairn_collision_filter {
    uint64_t layers; ///< The layers that the shape is in, one bit each.
    uint64_t collides_with; ///< The layers that it collides with.
} cairn_collision_filter;
CAIRN_C_API cairn_collision_filter cairn_default_collision_filter(void);

/// How a shape is attached to its body. Begin from `cairn_default_shape_def()`.
typedef struct cairn_shape_def {
    uint32_t struct_size; ///< Bytes, as `cairn_default_shape_def` sets it.
    cairn_vec3 position; ///< Origin of the shape in the body's frame, meters; within 1e15.
    cairn_quat rotation; ///< Orientation in the body's frame; normalized, must not be zero.
    float density; ///< kg/m^3, >= 0; 0 adds no mass. Ignored by planes.
    cairn_material material; ///< Of its surface.
    cairn_collision_filter filter; ///< What it meets.
    bool is_trigger; ///< A trigger touches nothing: it only reports what overlaps it (trigger events).
    /// m/s, in the shape's frame: the surface moves with it like a conveyor belt, beside the motion of the body. Only
    /// its part along the surface counts. Static and kinematic bodies only.
    cairn_vec3 surface_velocity;
    uint64_t user_data; ///< Not touched by the engine.
    /// A direction in the shape's frame, of any length. Not zero: the shape holds only what came from there. What is
    /// not wholly beyond it in that direction when the two meet goes through it, until it is: onto such a platform one
    /// jumps from below. Static and kinematic bodies only; infinite planes, meshes and height fields have none. Rays,
    /// casts and other queries meet it from all sides.
    cairn_vec3 one_way;
} cairn_shape_def;
CAIRN_C_API cairn_shape_def cairn_default_shape_def(void);

typedef int32_t cairn_shape_kind;
enum {
    CAIRN_SHAPE_SPHERE = 0,
    CAIRN_SHAPE_BOX = 1,
    CAIRN_SHAPE_PLANE = 2,
    CAIRN_SHAPE_CAPSULE = 3,
    CAIRN_SHAPE_CYLINDER = 4,
    CAIRN_SHAPE_HULL = 5,
    CAIRN_SHAPE_MESH = 6,
    CAIRN_SHAPE_HEIGHT_FIELD = 7
};

/// Any shape. A compound is a body with several of them.
typedef struct cairn_shape {
    cairn_shape_kind kind;
    union {
        cairn_sphere sphere;
        cairn_box box;
        cairn_plane plane;
        cairn_capsule capsule;
        cairn_cylinder cylinder;
        cairn_hull hull;
        cairn_mesh mesh;
        cairn_height_field height_field;
        unsigned char reserved[96];
    } as; ///< The member that `kind` names.
} cairn_shape;
/// The default of a kind; of an unknown one the first.
CAIRN_C_API cairn_shape cairn_default_shape(cairn_shape_kind kind);

/// Adds a shape to a body and, unless its mass properties were given, updates them. A dynamic body whose shapes have no
/// mass at all is a point of its given mass, or of 1 kg, that does not turn. Planes are refused on dynamic bodies. Null
/// for `def`: the default. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_add_shape(cairn_world* world, cairn_body_id body, const cairn_shape* shape,
                                               const cairn_shape_def* def, cairn_shape_id* result);

/// Takes a shape off its body, whose mass properties follow unless they were given. Errors: invalid_handle,
/// wrong_state.
CAIRN_C_API cairn_result cairn_world_remove_shape(cairn_world* world, cairn_shape_id shape);

/// Gives a shape another geometry, in place: its handle and all that its definition says stay. The mass of the body
/// follows as when a shape is added. What it touches then goes on touching it, without events, as long as it is of the
/// same type; else its contacts end and begin anew. What overlaps it then is pushed out, no faster than
/// `WorldDef.recovery_speed`: ground that rises carries what is on it if it rises more slowly than that, and by less
/// than the height of that in one call. Wakes its body and what is around the shape, before and after. Errors:
/// invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_shape(cairn_world* world, cairn_shape_id shape, const cairn_shape* geometry);

/// Gives a shape another definition, in place: place on its body, density, material, filter, and what else that says;
/// to change a part of it, begin with the one that it has. Its contacts end and begin anew where `is_trigger` or
/// `filter` is not what it was; else as when its geometry is set. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_shape_def(cairn_world* world, cairn_shape_id shape,
                                                   const cairn_shape_def* def);

/// Whether the handle names a shape that exists.
CAIRN_C_API bool cairn_shape_is_valid(const cairn_world* world, cairn_shape_id shape);

/// The body that a shape is on. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_shape_get_body(const cairn_world* world, cairn_shape_id shape, cairn_body_id* result);

/// What was added. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_get_shape(const cairn_world* world, cairn_shape_id shape, cairn_shape* result);

/// How it is attached to its body, as it is now. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_get_shape_def(const cairn_world* world, cairn_shape_id shape,
                                                   cairn_shape_def* shape_def);

/// In world space. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_get_shape_transform(const cairn_world* world, cairn_shape_id shape,
                                                         cairn_transform* shape_transform);

/// Tight; infinite for infinite planes. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_get_shape_bounds(const cairn_world* world, cairn_shape_id shape,
                                                      cairn_bounds* shape_bounds);

/// Replaces the material. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_material(cairn_world* world, cairn_shape_id shape,
                                                  const cairn_material* material);

/// Replaces the collision filter. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_filter(cairn_world* world, cairn_shape_id shape,
                                                const cairn_collision_filter* filter);

/// See `ShapeDef.surface_velocity`. Refused (wrong_state) for a shape of a dynamic body. Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_surface_velocity(cairn_world* world, cairn_shape_id shape,
                                                          cairn_vec3 velocity);

/// The convex hull of any points, meters, in the shape's frame: x, y, z each, `stride` bytes apart (0: 12). Refused
/// (invalid_value) when a coordinate is not finite or exceeds 1e6, when there are fewer than 4 points, or when they all
/// lie in one point, on one line or in one plane. `cairn_geometry_release` when it is no longer needed: shapes that
/// were made of it keep what they need. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_create_hull(const float* points, size_t count, size_t stride,
                                                    cairn_geometry** geometry);

/// A surface of triangles: three indices each, counterclockwise as seen from outside; vertices are x, y, z in meters,
/// `stride` bytes apart (0: 12). Triangles without area are left out. Refused (invalid_value) when a coordinate is not
/// finite or exceeds 1e6, when an index is out of range or their number is no multiple of three, or when no triangle is
/// left. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_create_mesh(const float* vertices, size_t vertex_count, size_t stride,
                                                    const uint32_t* indices, size_t index_count,
                                                    cairn_geometry** geometry);

/// A surface over a grid: `heights`, meters along y, row after row, columns x rows of them; that of column c and row r
/// stands at x = (c - (columns - 1) / 2) * spacing.x, z = (r - (rows - 1) / 2) * spacing.y. Triangles of which a corner
/// has the height +infinity are holes. Refused (invalid_value) for fewer than 2 columns or rows, more than 2^28
/// heights, another number of heights, a spacing that is no size, a height that is no number or exceeds 1e6 and is not
/// +infinity, or holes alone. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_create_height_field(int columns, int rows, cairn_vec2 spacing,
                                                            const float* heights, size_t height_count,
                                                            cairn_geometry** geometry);

/// The same with materials beside that of the shape, at most 65,535, and the number of each triangle's: 0 for that of
/// the shape, k for materials[k - 1]. Refused (invalid_value) as well for a material that is none, a number beyond
/// them, or numbers that are not as many as the triangles (or none). Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_create_mesh_with_materials(const float* vertices, size_t vertex_count,
                                                                   size_t stride, const uint32_t* indices,
                                                                   size_t index_count, const cairn_material* materials,
                                                                   size_t material_count, const uint16_t* numbers,
                                                                   size_t number_count, cairn_geometry** geometry);

/// A height field with materials beside that of the shape, at most 65,535, and the number of each cell's, row after
/// row: 0 for that of the shape, k for materials[k - 1]. Refused (invalid_value) as well for a material that is none, a
/// number beyond them, or numbers that are not as many as the cells (or none). Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_create_height_field_with_materials(int columns, int rows, cairn_vec2 spacing,
    const float* heights, size_t height_count, const cairn_material* materials, size_t material_count,
    const uint16_t* numbers, size_t number_count, cairn_geometry** geometry);

/// The materials of a mesh or height field beside that of the shape. Refused (invalid_value) for a hull. Errors:
/// invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_materials(const cairn_geometry* geometry, cairn_material* materials,
                                                      size_t capacity, size_t* count);

/// The number of the material of each triangle of a mesh, in the order of its indices, or of each cell of a height
/// field, row after row; none if all have that of the shape. Refused (invalid_value) for a hull. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_material_numbers(const cairn_geometry* geometry, uint16_t* numbers,
                                                             size_t capacity, size_t* count);

/// Gives a geometry back. Null: nothing happens.
CAIRN_C_API void cairn_geometry_release(cairn_geometry* geometry);

/// The corners of a hull, the vertices of a mesh, or where the heights of a height field stand, meters; y of a hole is
/// +infinity. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_vertices(const cairn_geometry* geometry, cairn_vec3* vertices,
                                                     size_t capacity, size_t* count);

/// The triangles of a mesh, or of a height field that are no holes, three indices of its vertices each,
/// counterclockwise as seen from outside. Refused (invalid_value) for a hull. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_indices(const cairn_geometry* geometry, uint32_t* indices, size_t capacity,
                                                    size_t* count);

/// How many triangles of a mesh had no area. Refused (invalid_value) for others. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_dropped_triangles(const cairn_geometry* geometry, size_t* count);

/// The number of faces of a hull; neighboring triangles of one plane are one face. Refused (invalid_value) for others.
/// Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_face_count(const cairn_geometry* geometry, size_t* count);

/// Indices of the corners of a face of a hull, counterclockwise as seen from outside. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_face(const cairn_geometry* geometry, size_t face, uint32_t* corners,
                                                 size_t capacity, size_t* count);

/// m^3, of a hull. Refused (invalid_value) for others. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_volume(const cairn_geometry* geometry, double* volume);

/// The grid of a height field. Refused (invalid_value) for others. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_grid(const cairn_geometry* geometry, int* columns, int* rows,
                                                 cairn_vec2* spacing);

/// The heights of a height field, meters, row after row. Refused (invalid_value) for others. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_heights(const cairn_geometry* geometry, float* heights, size_t capacity,
                                                    size_t* count);

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_SHAPE_H
