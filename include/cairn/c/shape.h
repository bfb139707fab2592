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

/// How the coefficients of two materials in contact are combined into one. If their rules differ, the one with
/// precedence applies, in the order average > minimum > maximum > multiply (KHR_physics_rigid_bodies).
typedef int32_t cairn_combine_rule;
enum {
    CAIRN_COMBINE_RULE_AVERAGE = 0, ///< The mean of both coefficients.
    CAIRN_COMBINE_RULE_MINIMUM = 1, ///< The smaller coefficient.
    CAIRN_COMBINE_RULE_MAXIMUM = 2, ///< The greater coefficient.
    CAIRN_COMBINE_RULE_MULTIPLY = 3 ///< The product of both coefficients.
};

/// A ball around the shape's origin. `radius` in meters, > 0.
typedef struct cairn_sphere {
    float radius; ///< Radius in meters, > 0.
} cairn_sphere;
CAIRN_C_API cairn_sphere cairn_default_sphere(void);

/// A box around the shape's origin. `half_extents` in meters, each > 0. A Box, Cylinder or Hull with `rounding` r > 0
/// is the Minkowski sum of the sharp solid and a ball of radius r: all points within a distance r of the sharp solid.
/// It is larger by r on every side; its faces stay flat, and its edges and corners are rounded with radius r. To keep
/// the outer size, subtract r from the half extents.
typedef struct cairn_box {
    cairn_vec3 half_extents; ///< Half extents of the sharp box, meters, each > 0; the rounding adds to them.
    float rounding; ///< Meters, >= 0: radius of the ball that is added to the sharp box.
} cairn_box;
CAIRN_C_API cairn_box cairn_default_box(void);

/// A plane through the shape's origin, solid on the side opposite to `normal`. Without `half_extents` it is an infinite
/// half-space. With them it is a rectangle: `half_extents[0]` along `tangent`, `half_extents[1]` along normal x
/// tangent. A rectangle is one-sided: it pushes shapes along its normal that are above it, or that have sunk into it
/// and are still partly above. With one infinite half extent it is a strip, without ends along that axis. A
/// double-sided plane is a sheet without thickness that collides on both sides: an infinite one pushes a body to the
/// side on which its center of mass is; a rectangle or strip pushes a shape to the side on which the middle of that
/// shape is. Rays and casts hit a sheet from both sides, and no point is inside of it. Planes have no mass, and may
/// only be added to static and kinematic bodies.
typedef struct cairn_plane {
    cairn_vec3 normal; ///< Any non-zero finite vector; it is normalized.
    /// Direction of `half_extents[0]`; it is made orthogonal to `normal`. Used only by rectangles and strips.
    cairn_vec3 tangent;
    bool has_half_extents; ///< Whether `half_extents` is given.
    cairn_vec2 half_extents; ///< Meters, each > 0; one may be infinite. Absent: an infinite plane.
    bool double_sided; ///< true: the plane is a sheet that collides on both sides.
} cairn_plane;
CAIRN_C_API cairn_plane cairn_default_plane(void);

/// The convex hull of two balls on the shape's y axis, their centers at -half_height and +half_height. Meters, all > 0
/// (`radius_top` >= 0).
typedef struct cairn_capsule {
    float half_height; ///< Half the distance between the centers of the balls, meters, > 0.
    float radius; ///< Radius of both balls, or of the lower one if `radius_top` is given, meters, > 0.
    bool has_radius_top; ///< Whether `radius_top` is given.
    float radius_top; ///< Radius of the upper ball, meters, >= 0, for a tapered capsule; absent: `radius`.
} cairn_capsule;
CAIRN_C_API cairn_capsule cairn_default_capsule(void);

/// A solid cylinder around the shape's y axis, from -half_height to +half_height. Meters, all > 0 (`radius_top` >= 0);
/// the rounding adds to these sizes.
typedef struct cairn_cylinder {
    float half_height; ///< Half the length along the y axis, meters, > 0.
    float radius; ///< Radius at both ends, or at the lower end if `radius_top` is given, meters, > 0.
    bool has_radius_top; ///< Whether `radius_top` is given.
    /// Radius at the upper end, meters, >= 0, for a tapered cylinder, or a cone if it is 0; absent: `radius`.
    float radius_top;
    float rounding; ///< Meters, >= 0: radius of the ball that is added to the sharp cylinder.
} cairn_cylinder;
CAIRN_C_API cairn_cylinder cairn_default_cylinder(void);

/// A convex polyhedron. Its vertices never change.
typedef struct cairn_hull {
    const cairn_geometry* geometry; ///< A hull created by `cairn_geometry_create_hull`.
    float rounding; ///< Meters, >= 0: radius of the ball that is added to the sharp polyhedron.
} cairn_hull;
CAIRN_C_API cairn_hull cairn_default_hull(void);

/// A triangle mesh, for static and kinematic bodies. The solid side of a triangle is the one from which its vertices
/// appear clockwise: a shape that has sunk below a triangle and is still partly above it is pushed out along the
/// normal. Walls may be arbitrarily thin: a sheet that has triangles facing both ways collides on both sides.
typedef struct cairn_mesh {
    const cairn_geometry* geometry; ///< A mesh created by `cairn_geometry_create_mesh`.
} cairn_mesh;
CAIRN_C_API cairn_mesh cairn_default_mesh(void);

/// A surface over a grid in the shape's xz plane, solid below, for static and kinematic bodies.
typedef struct cairn_height_field {
    const cairn_geometry* geometry; ///< A height field created by `cairn_geometry_create_height_field`.
} cairn_height_field;
CAIRN_C_API cairn_height_field cairn_default_height_field(void);

/// Surface properties of a shape.
typedef struct cairn_material {
    float static_friction; ///< Coulomb coefficient while the contact sticks, >= 0.
    float dynamic_friction; ///< Coulomb coefficient while it slides, >= 0.
    float restitution; ///< Ratio of rebound to approach speed, 0 to 1; 0: no bounce, 1: elastic.
    float rolling_friction; ///< Lever arm of the rolling resistance torque in meters, >= 0.
    /// Radius of the contact patch in meters, >= 0: a spinning one-point contact feels a torque of at most friction x
    /// normal force x this radius. With 0, a ball that spins about the contact normal never comes to rest.
    float torsional_friction;
    /// How its friction coefficients are combined with those of the other material.
    cairn_combine_rule friction_combine;
    cairn_combine_rule restitution_combine; ///< How its restitution is combined with that of the other material.
} cairn_material;
CAIRN_C_API cairn_material cairn_default_material(void);

/// Decides which shapes collide: two shapes do if each is in a layer with which the other collides.
typedef struct cairn_collision_filter {
    uint64_t layers; ///< Layers to which the shape belongs, one bit for each.
    uint64_t collides_with; ///< Layers with which the shape collides.
} cairn_collision_filter;
CAIRN_C_API cairn_collision_filter cairn_default_collision_filter(void);

/// How a shape is attached to its body. Begin from `cairn_default_shape_def()`.
typedef struct cairn_shape_def {
    uint32_t struct_size; ///< Bytes, as `cairn_default_shape_def` sets it.
    cairn_vec3 position; ///< Origin of the shape in the body's frame, meters; within 1e15.
    cairn_quat rotation; ///< Orientation in the body's frame; normalized, must not be zero.
    float density; ///< kg/m^3, >= 0; with 0 the shape adds no mass. Not used for planes.
    cairn_material material; ///< Friction and restitution of its surface.
    cairn_collision_filter filter; ///< Decides with which shapes it collides.
    /// true: the shape is a trigger. It has no contacts, and only reports shapes that overlap it
    /// (`World::trigger_events`).
    bool is_trigger;
    /// m/s, in the shape's frame: velocity of the surface relative to the body, as of a conveyor belt. Only its
    /// component along the surface counts. Static and kinematic bodies only.
    cairn_vec3 surface_velocity;
    uint64_t user_data; ///< Stored for the application; the engine does not use it.
    /// A direction in the shape's frame, of any length; zero: none. Otherwise the shape is a one-way platform: it
    /// collides only with shapes that come from that side. A shape that is not entirely on that side when the two meet
    /// passes through until it is, so that one can jump onto the platform from below. Static and kinematic bodies only;
    /// infinite planes, meshes and height fields cannot be one-way. Rays, casts and other queries find the shape from
    /// all sides.
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

/// Any shape. A compound is a body with several shapes.
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
/// The default values of a kind; those of the first kind if `kind` is unknown.
CAIRN_C_API cairn_shape cairn_default_shape(cairn_shape_kind kind);

/// Adds a shape to a body and, unless its mass properties were given, updates these. A dynamic body whose shapes have
/// no mass has its given mass, or 1 kg, at a point, and does not rotate. Planes, meshes and height fields are refused
/// on dynamic bodies (wrong_state). Null for `def`: the default. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_add_shape(cairn_world* world, cairn_body_id body, const cairn_shape* shape,
                                               const cairn_shape_def* def, cairn_shape_id* result);

/// Removes a shape from its body and, unless the mass properties of the body were given, updates these. Errors:
/// invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_remove_shape(cairn_world* world, cairn_shape_id shape);

/// Replaces the geometry of a shape; its handle and its definition stay. The mass of the body is updated as when a
/// shape is added. If the new geometry is of the same type, contacts with shapes that it still touches continue without
/// events; otherwise its contacts end and begin anew. Shapes that overlap the new geometry are pushed out with at most
/// `WorldDef.recovery_speed`. Rising ground therefore carries the bodies on it if it rises more slowly than that, and
/// in one call by less than the height of the body. Wakes the body of the shape, and bodies around the old and the new
/// geometry. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_shape(cairn_world* world, cairn_shape_id shape, const cairn_shape* geometry);

/// Replaces the definition of a shape in the same way as its geometry: its pose on the body, density, material, filter,
/// and so on. To change only a part of it, begin with the present definition. Its contacts end and begin anew if
/// `is_trigger` or `filter` changes. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_shape_def(cairn_world* world, cairn_shape_id shape,
                                                   const cairn_shape_def* def);

/// Whether the handle names a shape that exists.
CAIRN_C_API bool cairn_shape_is_valid(const cairn_world* world, cairn_shape_id shape);

/// The body to which a shape belongs. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_shape_get_body(const cairn_world* world, cairn_shape_id shape, cairn_body_id* result);

/// The geometry of a shape. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_get_shape(const cairn_world* world, cairn_shape_id shape, cairn_shape* result);

/// The present definition of a shape. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_get_shape_def(const cairn_world* world, cairn_shape_id shape,
                                                   cairn_shape_def* shape_def);

/// The pose of a shape in world space. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_get_shape_transform(const cairn_world* world, cairn_shape_id shape,
                                                         cairn_transform* shape_transform);

/// Tight axis-aligned bounds of a shape, meters; infinite for infinite planes. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_get_shape_bounds(const cairn_world* world, cairn_shape_id shape,
                                                      cairn_bounds* shape_bounds);

/// Replaces the material of a shape. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_material(cairn_world* world, cairn_shape_id shape,
                                                  const cairn_material* material);

/// Replaces the collision filter of a shape. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_filter(cairn_world* world, cairn_shape_id shape,
                                                const cairn_collision_filter* filter);

/// Sets `ShapeDef.surface_velocity`, m/s. Refused (wrong_state) for a shape of a dynamic body. Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_surface_velocity(cairn_world* world, cairn_shape_id shape,
                                                          cairn_vec3 velocity);

/// Creates the convex hull of `points`, meters, in the shape's frame: x, y, z each, `stride` bytes apart (0: 12).
/// Refused (invalid_value) when a coordinate is not finite or exceeds 1e6, when there are fewer than 4 points, or when
/// all of them coincide, lie on one line or lie in one plane (within 1e-5 of their extent). Free it with
/// `cairn_geometry_release`; shapes that were created from it keep the data that they need. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_create_hull(const float* points, size_t count, size_t stride,
                                                    cairn_geometry** geometry);

/// Creates a triangle mesh. `vertices`: x, y, z in meters, in the shape's frame, `stride` bytes apart (0: 12).
/// `indices`: three for each triangle, counterclockwise as seen from outside. Vertices at the same place are merged;
/// triangles without area are omitted. Refused (invalid_value) when a coordinate is not finite or exceeds 1e6, when an
/// index is out of range, when the number of indices is not a multiple of three, or when no triangle is left. Errors:
/// invalid_value.
CAIRN_C_API cairn_result cairn_geometry_create_mesh(const float* vertices, size_t vertex_count, size_t stride,
                                                    const uint32_t* indices, size_t index_count,
                                                    cairn_geometry** geometry);

/// Creates a surface over a grid. `heights`: meters along y, row by row, columns x rows of them. The height of column c
/// and row r is at x = (c - (columns - 1) / 2) * spacing.x, z = (r - (rows - 1) / 2) * spacing.y; `spacing` is in
/// meters, > 0. Each cell consists of two triangles, divided by the diagonal from its corner of least x and z.
/// Triangles that have a vertex with the height +infinity are holes. Refused (invalid_value) for fewer than 2 columns
/// or rows, more than 2^28 heights, a count of heights other than columns x rows, a spacing that is not finite and > 0,
/// a height that is NaN or exceeds 1e6 and is not +infinity, or a field that consists of holes only. Errors:
/// invalid_value.
CAIRN_C_API cairn_result cairn_geometry_create_height_field(int columns, int rows, cairn_vec2 spacing,
                                                            const float* heights, size_t height_count,
                                                            cairn_geometry** geometry);

/// Creates a mesh as `cairn_geometry_create_mesh` does, with up to 65,535 materials in addition to that of the shape.
/// `numbers` gives the material of each triangle: 0 for the material of the shape, k for materials[k - 1]. Also refused
/// (invalid_value) for an invalid material, a number out of range, or a count of numbers other than 0 or that of the
/// triangles. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_create_mesh_with_materials(const float* vertices, size_t vertex_count,
                                                                   size_t stride, const uint32_t* indices,
                                                                   size_t index_count, const cairn_material* materials,
                                                                   size_t material_count, const uint16_t* numbers,
                                                                   size_t number_count, cairn_geometry** geometry);

/// Creates a height field as `cairn_geometry_create_height_field` does, with up to 65,535 materials in addition to that
/// of the shape. `numbers` gives the material of each cell, row by row: 0 for the material of the shape, k for
/// materials[k - 1]. Also refused (invalid_value) for an invalid material, a number out of range, or a count of numbers
/// other than 0 or that of the cells. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_create_height_field_with_materials(int columns, int rows, cairn_vec2 spacing,
    const float* heights, size_t height_count, const cairn_material* materials, size_t material_count,
    const uint16_t* numbers, size_t number_count, cairn_geometry** geometry);

/// The materials of a mesh or height field in addition to that of the shape. Refused (invalid_value) for a hull.
/// Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_materials(const cairn_geometry* geometry, cairn_material* materials,
                                                      size_t capacity, size_t* count);

/// The number of the material of each triangle of a mesh, in the order of its indices, or of each cell of a height
/// field, row by row; none if all have the material of the shape. Refused (invalid_value) for a hull. Errors:
/// invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_material_numbers(const cairn_geometry* geometry, uint16_t* numbers,
                                                             size_t capacity, size_t* count);

/// Frees a geometry. No effect on null.
CAIRN_C_API void cairn_geometry_release(cairn_geometry* geometry);

/// The vertices of a hull or mesh, or the points of the grid of a height field with their heights, meters; y of a hole
/// is +infinity. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_vertices(const cairn_geometry* geometry, cairn_vec3* vertices,
                                                     size_t capacity, size_t* count);

/// The triangles of a mesh, or those of a height field that are not holes: three indices of its vertices each,
/// counterclockwise as seen from outside. Refused (invalid_value) for a hull. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_indices(const cairn_geometry* geometry, uint32_t* indices, size_t capacity,
                                                    size_t* count);

/// How many triangles of a mesh were omitted because they have no area. Refused (invalid_value) for other geometries.
/// Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_dropped_triangles(const cairn_geometry* geometry, size_t* count);

/// Number of faces of a hull; adjacent coplanar triangles form one face. Refused (invalid_value) for other geometries.
/// Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_face_count(const cairn_geometry* geometry, size_t* count);

/// Indices of the vertices of a face of a hull, counterclockwise as seen from outside. Refused (invalid_value) for
/// other geometries, and unless `face` is less than the number of faces. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_face(const cairn_geometry* geometry, size_t face, uint32_t* corners,
                                                 size_t capacity, size_t* count);

/// Volume of a hull, m^3. Refused (invalid_value) for other geometries. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_volume(const cairn_geometry* geometry, double* volume);

/// The numbers of columns and rows of a height field, and its spacing along x and z, meters. Refused (invalid_value)
/// for other geometries. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_grid(const cairn_geometry* geometry, int* columns, int* rows,
                                                 cairn_vec2* spacing);

/// The heights of a height field, meters, row by row. Refused (invalid_value) for other geometries. Errors:
/// invalid_value.
CAIRN_C_API cairn_result cairn_geometry_get_heights(const cairn_geometry* geometry, float* heights, size_t capacity,
                                                    size_t* count);

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_SHAPE_H
