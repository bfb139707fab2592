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

/// The trees of the broad phase. Infinite planes are in none.
typedef int32_t cairn_broad_phase_tree;
enum {
    CAIRN_BROAD_PHASE_TREE_FIXED = 0, ///< Shapes of static bodies.
    CAIRN_BROAD_PHASE_TREE_AWAKE = 1, ///< Awake shapes.
    CAIRN_BROAD_PHASE_TREE_LARGE = 2, ///< Awake shapes that are large compared to the others.
    /// Sleeping shapes: a tree of all sleeping islands, below which each island has a tree of its own.
    CAIRN_BROAD_PHASE_TREE_SLEEPING = 3
};

/// An intersection of a ray with a shape.
typedef struct cairn_ray_hit {
    cairn_shape_id shape;
    cairn_body_id body;
    cairn_position point; ///< On the surface, meters, world space.
    cairn_vec3 normal; ///< Unit outward normal of the surface there.
    double distance; ///< Distance from the ray's origin, meters.
    /// For a mesh: index of the triangle that was hit, in the order of the mesh's indices. For a height field: 2 x
    /// (index of the cell, row by row), plus 1 for the triangle on the side of greater x. For other shapes: -1.
    int triangle;
} cairn_ray_hit;

/// The first contact of a shape that is moved along a line.
typedef struct cairn_shape_cast_hit {
    cairn_shape_id shape;
    cairn_body_id body;
    double fraction; ///< Fraction of the translation before the contact, 0 to 1; 0 if the shapes overlap at the start.
    cairn_position point; ///< Where the two shapes touch, meters, world space.
    cairn_vec3 normal; ///< Unit normal, out of the shape that was hit.
    int triangle; ///< The triangle that was hit; as in RayHit.
} cairn_shape_cast_hit;

/// The point of the nearest shape that is closest to a given point.
typedef struct cairn_closest_point {
    cairn_shape_id shape;
    cairn_body_id body;
    cairn_position point; ///< On the surface, meters, world space; the given point itself if it is inside the shape.
    double distance; ///< Meters; 0 if the given point is inside the shape.
    int triangle; ///< The triangle on which the point lies; as in RayHit.
} cairn_closest_point;

/// A node of a tree of the broad phase. Its box encloses those of its children, of which there are at most eight; the
/// boxes of siblings may overlap.
typedef struct cairn_broad_phase_node {
    cairn_bounds bounds; ///< Meters, world space; the box of a leaf is somewhat larger than its shape.
    cairn_broad_phase_tree tree; ///< The tree to which the node belongs.
    int depth; ///< Levels below the root of the tree; 0: the root.
    int parent; ///< Index of the parent in the list of nodes; -1: the node is a root.
    bool is_leaf; ///< true: the node is the box of a single shape.
    cairn_shape_id shape; ///< The shape of a leaf; null for other nodes.
} cairn_broad_phase_node;

/// How the solver treats a touching pair of shapes, after the last step; for visualization and measurements.
typedef struct cairn_solver_contact {
    cairn_shape_id shape_a;
    cairn_shape_id shape_b;
    cairn_body_id body_a;
    cairn_body_id body_b;
    /// Color in the constraint graph. Contacts of one color share no dynamic body, so that they are solved in parallel.
    /// Colors are solved in turn, lowest first; those of contacts with static and kinematic bodies come last. -1: no
    /// color was free, and the contact is solved on its own, before all others.
    int color;
    /// Substeps of its island in the last step in which the island was awake; 0: it has not been solved yet.
    int substeps;
} cairn_solver_contact;

/// What `World::debug_lines` shows. Begin from `cairn_default_debug_lines_def()`.
typedef struct cairn_debug_lines_def {
    uint32_t struct_size; ///< Bytes, as `cairn_default_debug_lines_def` sets it.
    /// Edges of shapes; an infinite plane is shown as a grid of 20 m. The color tells whether a body is static,
    /// kinematic, awake or asleep; triggers have a color of their own.
    bool shapes;
    bool bounds; ///< Axis-aligned bounding boxes of shapes; infinite planes have none.
    bool centers; ///< Principal axes of inertia at the centers of mass of dynamic bodies: x red, y green, z blue.
    bool velocities; ///< Lines from the center of mass of each moving body to where its velocity brings it in 0.1 s.
    bool contacts; ///< The normal at each contact point.
    /// Lines from the centers of mass of both bodies to their anchors, and the axes of the joint at the anchor of A.
    bool joints;
    float size; ///< m, > 0: length of axes and normals.
    /// m/(N s), >= 0. If > 0, the length of a normal is this times the normal impulse of its contact point in the last
    /// step.
    float impulse_scale;
} cairn_debug_lines_def;
CAIRN_C_API cairn_debug_lines_def cairn_default_debug_lines_def(void);

/// A straight line.
typedef struct cairn_debug_line {
    cairn_position begin; ///< m, in world space.
    cairn_position end; ///< m, in world space.
    cairn_vec3 color; ///< Red, green and blue, 0 to 1.
} cairn_debug_line;

/// Selects the shapes that a query can find. A shape must meet all conditions. Begin from
/// `cairn_default_query_filter()`.
typedef struct cairn_query_filter {
    uint32_t struct_size; ///< Bytes, as `cairn_default_query_filter` sets it.
    uint64_t layers; ///< The shape must be in one of these layers (`CollisionFilter.layers`).
    /// The layers of the query itself: the shape must collide with one of them (`CollisionFilter.collides_with`).
    uint64_t own_layers;
    bool static_bodies; ///< true: shapes of static bodies are included.
    bool kinematic_bodies; ///< true: shapes of kinematic bodies are included.
    bool dynamic_bodies; ///< true: shapes of dynamic bodies are included.
    bool triggers; ///< true: triggers are included, and found like other shapes.
    /// true: the query may return any one result: the first that it finds instead of the nearest, and a single shape
    /// for overlaps. Faster if it only matters whether there is any.
    bool any;
    const cairn_body_id* ignored_bodies; ///< Shapes of these bodies are excluded. Each body must exist.
    size_t ignored_body_count;
} cairn_query_filter;
CAIRN_C_API cairn_query_filter cairn_default_query_filter(void);

/// The nearest intersection of a ray with a shape within `max_distance` (meters). `direction` need not have unit
/// length. A ray that starts inside a shape does not hit that shape; only one that starts below an infinite plane hits
/// it, at distance 0. `found` receives whether there is one. Null for `filter`: the default. Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_cast_ray(const cairn_world* world, cairn_position origin, cairn_vec3 direction,
                                              double max_distance, const cairn_query_filter* filter,
                                              cairn_ray_hit* result, bool* found);

/// The intersections of the ray with all shapes within `max_distance` (meters), nearest first. `count` receives their
/// number; the first `capacity` of them are written. Null for `filter`: the default. Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_cast_ray_all(const cairn_world* world, cairn_position origin, cairn_vec3 direction,
                                                  double max_distance, const cairn_query_filter* filter,
                                                  cairn_ray_hit* result, size_t capacity, size_t* count);

/// The first shape that the given convex shape hits when it moves by `translation` (meters) from `start` without
/// rotation. The accuracy is a millionth of the size of the smaller shape. If they overlap at the start, the fraction
/// is 0, and point and normal are those of the smallest separating translation; if several shapes overlap, the one with
/// the lowest slot index is returned. Planes, meshes and height fields are hit from outside only, and cannot be cast
/// (invalid_value). `found` receives whether there is one. Null for `filter`: the default. Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_cast_shape(const cairn_world* world, const cairn_shape* shape,
                                                cairn_transform start, cairn_vec3 translation,
                                                const cairn_query_filter* filter, cairn_shape_cast_hit* result,
                                                bool* found);

/// The shape nearest to a point, at most `max_distance` (meters, >= 0) away. Points below a plane are inside it; meshes
/// and height fields have no inside. `found` receives whether there is one. Null for `filter`: the default. Errors:
/// invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_closest_point(const cairn_world* world, cairn_position point, double max_distance,
                                                   const cairn_query_filter* filter, cairn_closest_point* result,
                                                   bool* found);

/// All shapes that have a point in common with the given shape at `pose` (touching counts), in order of slot index. A
/// plane is solid below. Rectangles, strips, double-sided planes, meshes and height fields are surfaces without
/// thickness: a shape that touches or crosses them from any side overlaps them; a shape entirely below does not. Two
/// surfaces never overlap. `count` receives their number; the first `capacity` of them are written. Null for `filter`:
/// the default. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_overlap(const cairn_world* world, const cairn_shape* shape, cairn_transform pose,
                                             const cairn_query_filter* filter, cairn_shape_id* result, size_t capacity,
                                             size_t* count);

/// Shapes whose tight bounds overlap the box, in order of slot index. `count` receives their number; the first
/// `capacity` of them are written. Null for `filter`: the default. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_overlap_bounds(const cairn_world* world, cairn_bounds bounds,
                                                    const cairn_query_filter* filter, cairn_shape_id* result,
                                                    size_t capacity, size_t* count);

/// The present nodes of the broad phase down to `max_depth` (>= 0), in order of depth, at most `max_count` (>= 0): for
/// visualization, and to find out why a scene is slow. `count` receives their number; the first `capacity` of them are
/// written. Errors: invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_broad_phase_nodes(const cairn_world* world, int max_depth, int max_count,
                                                       cairn_broad_phase_node* result, size_t capacity, size_t* count);

/// How each touching pair of shapes is solved, in the order of `world_get_contacts`. `count` receives their number; the
/// first `capacity` of them are written. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_solver_contacts(const cairn_world* world, cairn_solver_contact* result,
                                                     size_t capacity, size_t* count);

/// The contents of the world as lines, for programs with their own renderer: bodies in order of slot index, then
/// contacts, then joints. There is a line for each edge, which takes time for large meshes and height fields. `count`
/// receives their number; the first `capacity` of them are written. Null for `what`: the default. Errors:
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_debug_lines(const cairn_world* world, const cairn_debug_lines_def* what,
                                                 cairn_debug_line* result, size_t capacity, size_t* count);

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_QUERY_H
