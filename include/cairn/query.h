/// \file query.h
/// Results and filters of queries: ray casts, shape casts, closest points and overlap tests. Queries use the exact
/// shapes, do not change the world, and may run on several threads at once while no step runs.
#pragma once

#include <cairn/handle.h>
#include <cairn/math.h>

#include <cstdint>
#include <vector>

namespace cairn {

/// An intersection of a ray with a shape.
struct RayHit {
    ShapeId shape;
    BodyId body;
    Position point;  ///< On the surface, meters, world space.
    Vec3 normal;     ///< Unit outward normal of the surface there.
    double distance; ///< From the ray's origin, meters.
    /// For a mesh: index of the triangle that was hit, in `Mesh::indices()`. For a height field: 2 x (index of the
    /// cell, row by row), plus 1 for the triangle on the side of greater x. For other shapes: -1.
    int triangle = -1;
};

/// The first contact of a shape that is moved along a line.
struct ShapeCastHit {
    ShapeId shape;
    BodyId body;
    double fraction; ///< Fraction of the translation before the contact, 0 to 1; 0 if the shapes overlap at the start.
    Position point;  ///< Where the two shapes touch, meters, world space.
    Vec3 normal;     ///< Unit normal, out of the shape that was hit.
    int triangle = -1; ///< The triangle that was hit; as in RayHit.
};

/// The point of the nearest shape that is closest to a given point.
struct ClosestPoint {
    ShapeId shape;
    BodyId body;
    Position point;    ///< On the surface, meters, world space; the given point itself if it is inside the shape.
    double distance;   ///< Meters; 0 if the given point is inside the shape.
    int triangle = -1; ///< The triangle on which the point lies; as in RayHit.
};

/// The trees of the broad phase: `fixed` for shapes of static bodies, `awake` for awake shapes, `large` for awake
/// shapes that are large compared to the others, `sleeping` for sleeping shapes: a tree of all sleeping islands, below
/// which each island has a tree of its own. Infinite planes are in none.
enum class BroadPhaseTree : std::uint8_t { fixed, awake, large, sleeping };

/// A node of a tree of the broad phase. Its box encloses those of its children, of which there are at most eight; the
/// boxes of siblings may overlap.
struct BroadPhaseNode {
    Bounds bounds;        ///< Meters, world space; the box of a leaf is somewhat larger than its shape.
    BroadPhaseTree tree;  ///< The tree to which the node belongs.
    int depth;            ///< Levels below the root of the tree; 0: the root.
    int parent;           ///< Index of the parent in the list of nodes; -1: the node is a root.
    bool is_leaf = false; ///< true: the node is the box of a single shape.
    ShapeId shape;        ///< The shape of a leaf; null for other nodes.
};

/// How the solver treats a touching pair of shapes, after the last step; for visualization and measurements.
struct SolverContact {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
    /// Color in the constraint graph. Contacts of one color share no dynamic body, so that they are solved in parallel.
    /// Colors are solved in turn, lowest first; those of contacts with static and kinematic bodies come last. -1: no
    /// color was free, and the contact is solved on its own, before all others.
    int color;
    /// Substeps of its island in the last step in which the island was awake; 0: it has not been solved yet.
    int substeps;
};

inline constexpr std::uint64_t all_layers = ~std::uint64_t{}; ///< All layers: the default of queries.

/// Selects the shapes that a query can find. A shape must meet all conditions.
struct QueryFilter {
    std::uint64_t layers = all_layers; ///< The shape must be in one of these layers (CollisionFilter::layers).
    /// The layers of the query itself: the shape must collide with one of them (CollisionFilter::collides_with).
    std::uint64_t own_layers = all_layers;
    bool static_bodies = true;    ///< true: shapes of static bodies are included.
    bool kinematic_bodies = true; ///< true: shapes of kinematic bodies are included.
    bool dynamic_bodies = true;   ///< true: shapes of dynamic bodies are included.
    bool triggers = false;        ///< true: triggers are included, and found like other shapes.
    /// true: the query may return any one result: the first that it finds instead of the nearest, and a single shape
    /// for overlaps. Faster if it only matters whether there is any.
    bool any = false;
    std::vector<BodyId> ignored_bodies{}; ///< Shapes of these bodies are excluded. Each body must exist.
};

} // namespace cairn
