// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#ifndef CAIRN_C_QUERY_H
#define CAIRN_C_QUERY_H

#include <cairn/c/joint.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// The trees of the broad phase. Planes are in none.
typedef int32_t cairn_broad_phase_tree;
enum {
    CAIRN_BROAD_PHASE_TREE_FIXED = 0, ///< Of what is fixed.
    CAIRN_BROAD_PHASE_TREE_AWAKE = 1, ///< Of what is awake.
    CAIRN_BROAD_PHASE_TREE_LARGE = 2, ///< Of what is awake and large beside the others.
    CAIRN_BROAD_PHASE_TREE_SLEEPING = 3 ///< Of what sleeps, with a tree for each island below that of all islands.
};

/// The nearest thing that a ray met.
typedef struct cairn_ray_hit {
    cairn_shape_id shape;
    cairn_body_id body;
    cairn_position point; ///< On the surface, meters.
    cairn_vec3 normal; ///< Unit outward normal of the surface there.
    double distance; ///< From the ray's origin, meters.
    /// Of a mesh: the one of its triangles that the ray met, in the order of its indices; of a height field: twice the
    /// number of its cell, row after row, and 1 more for the half on the side of greatest x. Of other shapes -1.
    int triangle;
} cairn_ray_hit;

/// The first thing that a moving shape met.
typedef struct cairn_shape_cast_hit {
    cairn_shape_id shape;
    cairn_body_id body;
    double fraction; ///< Of the translation, 0 to 1; 0 if they overlapped from the start.
    cairn_position point; ///< Where they meet, meters.
    cairn_vec3 normal; ///< Unit, out of the shape that was met.
    int triangle; ///< That was met; as in RayHit.
} cairn_shape_cast_hit;

/// The surface point nearest to a given one.
typedef struct cairn_closest_point {
    cairn_shape_id shape;
    cairn_body_id body;
    cairn_position point; ///< On the surface, meters; the given point itself if that lies inside.
    double distance; ///< Meters; 0 inside.
    int triangle; ///< That it is on; as in RayHit.
} cairn_closest_point;

/// A box of a tree of the broad phase. It holds the boxes below it, up to eight; those of nodes side by side may
/// overlap.
typedef struct cairn_broad_phase_node {
    cairn_bounds bounds; ///< Meters; of a shape, somewhat larger than the shape.
    cairn_broad_phase_tree tree; ///< The one that it is in.
    int depth; ///< 0: the root of the tree.
    int parent; ///< Its place in the list; -1: it is a root.
    bool is_leaf; ///< It is the box of one shape.
    cairn_shape_id shape; ///< Of a leaf; else null.
} cairn_broad_phase_node;

/// How the solver works on a touching pair of shapes, as it stood after the last step; for pictures and measurements.
typedef struct cairn_solver_contact {
    cairn_shape_id shape_a;
    cairn_shape_id shape_b;
    cairn_body_id body_a;
    cairn_body_id body_b;
    /// Contacts of one color share no body that moves by forces, so they are solved side by side; colors take turns,
    /// the lowest first, and those with what does not move by forces come last. -1: no color was free; solved one by
    /// one, before all others.
    int color;
    int substeps; ///< Of its island in the last step in which that was awake; 0: not solved yet.
} cairn_solver_contact;

/// What debug lines show. Begin from `cairn_default_debug_lines_def()`.
typedef struct cairn_debug_lines_def {
    uint32_t struct_size; ///< Bytes, as `cairn_default_debug_lines_def` sets it.
    /// Edges of shapes; of infinite planes a grid of 20 m. Bodies that are static, kinematic, awake and asleep, and
    /// triggers, have colors of their own.
    bool shapes;
    bool bounds; ///< Boxes around shapes, along the axes of the world.
    bool centers; ///< The axes of inertia at the centers of mass of dynamic bodies: x red, y green, z blue.
    bool velocities; ///< From each center of mass of what moves to where it is in a tenth of a second.
    bool contacts; ///< At each point that touches, the normal.
    bool joints; ///< From both centers of mass to the anchors, and the axes of the joint there.
    float size; ///< The length of axes, and of normals. (> 0)
    float impulse_scale; ///< Not 0: a normal is as long as this times the impulse at its point. (m/(N s), >= 0)
} cairn_debug_lines_def;
CAIRN_C_API cairn_debug_lines_def cairn_default_debug_lines_def(void);

/// A straight line.
typedef struct cairn_debug_line {
    cairn_position begin; ///< In world space. (m)
    cairn_position end; ///< In world space. (m)
    cairn_vec3 color; ///< Red, green and blue, 0 to 1.
} cairn_debug_line;

/// Which shapes a query sees: those that pass all of it. Begin from `cairn_default_query_filter()`.
typedef struct cairn_query_filter {
    uint32_t struct_size; ///< Bytes, as `cairn_default_query_filter` sets it.
    uint64_t layers; ///< Those that are in any of these layers (`CollisionFilter.layers`).
    uint64_t own_layers; ///< Those that collide with any of these, in which the query itself is.
    bool static_bodies; ///< Those of static bodies.
    bool kinematic_bodies; ///< Those of kinematic bodies.
    bool dynamic_bodies; ///< Those of dynamic bodies.
    bool triggers; ///< Triggers as well; they are seen like any other shape then.
    /// Any one is enough: the first that is found, rather than the nearest, and of overlaps a single one. Faster, where
    /// only the question is whether there is any.
    bool any;
    const cairn_body_id* ignored_bodies; ///< Shapes of these are not seen. Each must exist.
    size_t ignored_body_count;
} cairn_query_filter;
CAIRN_C_API cairn_query_filter cairn_default_query_filter(void);

/// The nearest shape that the ray meets within `max_distance`. `direction` need not be unit length. A ray that starts
/// inside a shape does not meet that shape's surface from within, except planes' solid side. `found` gets whether there
/// is any. Null for `filter`: the default. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_cast_ray(const cairn_world* world, cairn_position origin, cairn_vec3 direction,
                                              double max_distance, const cairn_query_filter* filter,
                                              cairn_ray_hit* result, bool* found);

/// Every shape that the ray meets, nearest first. `count` gets how many there are; the first `capacity` of them are
/// written. Null for `filter`: the default. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_cast_ray_all(const cairn_world* world, cairn_position origin, cairn_vec3 direction,
                                                  double max_distance, const cairn_query_filter* filter,
                                                  cairn_ray_hit* result, size_t capacity, size_t* count);

/// The first shape that the given convex one meets when it moves by `translation` (meters) from `start` without
/// turning. Planes, meshes and height fields are met from outside only, and cannot be cast themselves (invalid_value).
/// `found` gets whether there is any. Null for `filter`: the default. Errors: invalid_handle, invalid_value,
/// wrong_state.
CAIRN_C_API cairn_result cairn_world_cast_shape(const cairn_world* world, const cairn_shape* shape,
                                                cairn_transform start, cairn_vec3 translation,
                                                const cairn_query_filter* filter, cairn_shape_cast_hit* result,
                                                bool* found);

/// The shape nearest to a point, up to `max_distance` (meters, >= 0) away. What is below a plane is inside it; meshes
/// and height fields have no inside. `found` gets whether there is any. Null for `filter`: the default. Errors:
/// invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_closest_point(const cairn_world* world, cairn_position point, double max_distance,
                                                   const cairn_query_filter* filter, cairn_closest_point* result,
                                                   bool* found);

/// Shapes that overlap the given shape posed in the world, in order of slot index. `count` gets how many there are; the
/// first `capacity` of them are written. Null for `filter`: the default. Errors: invalid_handle, invalid_value,
/// wrong_state.
CAIRN_C_API cairn_result cairn_world_overlap(const cairn_world* world, const cairn_shape* shape, cairn_transform pose,
                                             const cairn_query_filter* filter, cairn_shape_id* result, size_t capacity,
                                             size_t* count);

/// Shapes whose tight bounds overlap the box, in order of slot index. `count` gets how many there are; the first
/// `capacity` of them are written. Null for `filter`: the default. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_overlap_bounds(const cairn_world* world, cairn_bounds bounds,
                                                    const cairn_query_filter* filter, cairn_shape_id* result,
                                                    size_t capacity, size_t* count);

/// The boxes of the broad phase as they stand, down to that depth, for pictures and for who wants to know why a scene
/// is slow: those of least depth first, and no more than `max_count`. Both >= 0. `count` gets how many there are; the
/// first `capacity` of them are written. Errors: invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_broad_phase_nodes(const cairn_world* world, int max_depth, int max_count,
                                                       cairn_broad_phase_node* result, size_t capacity, size_t* count);

/// How each touching pair of shapes is solved, in the order of `world_get_contacts`. `count` gets how many there are;
/// the first `capacity` of them are written. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_solver_contacts(const cairn_world* world, cairn_solver_contact* result,
                                                     size_t capacity, size_t* count);

/// What the world consists of as lines, for programs that draw it themselves: bodies in order of slot index, then
/// contacts, then joints. As many as there are edges: of large meshes and height fields that takes its time. `count`
/// gets how many there are; the first `capacity` of them are written. Null for `what`: the default. Errors:
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_debug_lines(const cairn_world* world, const cairn_debug_lines_def* what,
                                                 cairn_debug_line* result, size_t capacity, size_t* count);

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_QUERY_H
