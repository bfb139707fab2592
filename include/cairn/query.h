/// \file query.h
/// Ray casts, shape casts, closest points and overlap tests. Exact against the shapes, read-only, and safe from several
/// threads at a time while no step runs.
#pragma once

#include <cairn/handle.h>
#include <cairn/math.h>

#include <cstdint>
#include <vector>

namespace cairn {

/// The nearest thing that a ray met.
struct RayHit {
    ShapeId shape;
    BodyId body;
    Position point;  ///< On the surface, meters.
    Vec3 normal;     ///< Unit outward normal of the surface there.
    double distance; ///< From the ray's origin, meters.
    /// Of a mesh: the one of the triangles of `Mesh::indices()` that it met; of a height field: twice the number of its
    /// cell, row after row, and 1 more for the half on the side of greatest x. Of other shapes -1.
    int triangle = -1;
};

/// The first thing that a moving shape met.
struct ShapeCastHit {
    ShapeId shape;
    BodyId body;
    double fraction;   ///< Of the translation, 0 to 1; 0 if they overlapped from the start.
    Position point;    ///< Where they meet, meters.
    Vec3 normal;       ///< Unit, out of the shape that was met.
    int triangle = -1; ///< That was met; as in RayHit.
};

/// The surface point nearest to a given one.
struct ClosestPoint {
    ShapeId shape;
    BodyId body;
    Position point;    ///< On the surface, meters; the given point itself if that lies inside.
    double distance;   ///< Meters; 0 inside.
    int triangle = -1; ///< That it is on; as in RayHit.
};

/// The trees of the broad phase: those of what is fixed, of what is awake, of shapes that are awake and large beside
/// the others, and of what sleeps, with a tree for each island below that of all islands. Planes are in none.
enum class BroadPhaseTree : std::uint8_t { fixed, awake, large, sleeping };

/// A box of a tree of the broad phase. It holds the boxes below it, up to eight; those of nodes side by side may
/// overlap.
struct BroadPhaseNode {
    Bounds bounds;        ///< Meters; of a shape, somewhat larger than the shape.
    BroadPhaseTree tree;  ///< The one that it is in.
    int depth;            ///< 0: the root of the tree.
    int parent;           ///< Its place in the list; -1: it is a root.
    bool is_leaf = false; ///< It is the box of one shape.
    ShapeId shape;        ///< Of a leaf; else null.
};

/// How the solver works on a touching pair of shapes, as it stood after the last step; for pictures and measurements.
struct SolverContact {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
    /// Contacts of one color share no body that moves by forces, so they are solved side by side; colors take turns,
    /// the lowest first, and those with what does not move by forces come last. -1: no color was free; solved one by
    /// one, before all others.
    int color;
    int substeps; ///< Of its island in the last step in which that was awake; 0: not solved yet.
};

inline constexpr std::uint64_t all_layers = ~std::uint64_t{}; ///< As they are by default.

/// Which shapes a query sees: those that pass all of it.
struct QueryFilter {
    std::uint64_t layers = all_layers;     ///< Those that are in any of these layers (CollisionFilter::layers).
    std::uint64_t own_layers = all_layers; ///< Those that collide with any of these, in which the query itself is.
    bool static_bodies = true;             ///< Those of static bodies.
    bool kinematic_bodies = true;          ///< Those of kinematic bodies.
    bool dynamic_bodies = true;            ///< Those of dynamic bodies.
    bool triggers = false;                 ///< Triggers as well; they are seen like any other shape then.
    /// Any one is enough: the first that is found, rather than the nearest, and of overlaps a single one. Faster, where
    /// only the question is whether there is any.
    bool any = false;
    std::vector<BodyId> ignored_bodies{}; ///< Shapes of these are not seen. Each must exist.
};

} // namespace cairn
