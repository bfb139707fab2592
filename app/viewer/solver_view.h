/// \file solver_view.h
/// What the solver works with, drawn over the picture: contacts with their forces, friction cones, velocities, bounding
/// boxes, axes of inertia, and what is solved together.
#pragma once

#include "viewer/minkowski.h"
#include "viewer/render_frame.h"

#include <cairn/world.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace cairn::viewer {

inline constexpr int greatest_tree_depth = 8;       ///< Eight to the power of that many bodies have no deeper trees.
inline constexpr std::size_t max_wide_boxes = 3000; ///< Of more, each edge is a pixel wide.

/// What of it is shown.
struct SolverShown {
    bool contacts = false, cones = false, velocities = false, bounds = false, axes = false, islands = false;
    bool difference = false, tree = false, colors = false, substeps = false;
    int tree_depth = 2; ///< Down to which boxes of the tree are shown, 0 to `greatest_tree_depth`.
    bool any() const { return *this != SolverShown{.tree_depth = tree_depth}; }
    friend bool operator==(const SolverShown&, const SolverShown&) = default;
};

/// The parts by name, each with a sentence that says how to read it.
struct SolverPart {
    const char* name;
    bool SolverShown::*shown;
    const char* meaning;
    const char* page; ///< Of the documentation, which says more.
};
std::span<const SolverPart> solver_parts();

/// As it was after a step.
struct SolverView {
    struct Point {
        Position place{0.0, 0.0, 0.0};
        Vec3 normal{0.0f, 1.0f, 0.0f};   ///< To what is pushed: it moves, and is the upper one of two.
        float normal_force = 0.0f;       ///< N, mean over the step.
        Vec3 friction{0.0f, 0.0f, 0.0f}; ///< N, on the same body: the share of this point.
        float coefficient = 0.0f;        ///< Of static friction between the two.
    };
    struct Mover {
        Position center{0.0, 0.0, 0.0};
        Vec3 velocity{0.0f, 0.0f, 0.0f}, turning{0.0f, 0.0f, 0.0f}; ///< m/s, rad/s
        Quat axes{1.0f, 0.0f, 0.0f, 0.0f};                          ///< Principal, in the world.
        Vec3 half_axes{0.0f, 0.0f, 0.0f}; ///< Meters, of the ellipsoid with the same mass and inertia.
    };
    struct Link {
        Position a{0.0, 0.0, 0.0}, b{0.0, 0.0, 0.0}; ///< Centers of mass.
        bool is_joint = false;
    };
    /// A contact in the order in which contacts are solved.
    struct Solved {
        Position place{0.0, 0.0, 0.0};          ///< The middle of its points.
        std::optional<Position> from_a, from_b; ///< Centers of mass of its bodies that move by forces.
        int color = 0, substeps = 0;            ///< As `SolverContact` has them.
    };
    SolverShown shown;
    std::vector<Point> points;
    std::vector<Solved> solved;
    std::vector<Mover> movers; ///< Dynamic bodies.
    std::vector<Bounds> bounds;
    std::vector<Link> links;
    std::vector<BroadPhaseNode> nodes; ///< Of the broad phase's trees; with a body selected, those on the way to it.
    std::optional<PairDifference> difference; ///< Of the selected body.
};

/// Of boxes of the broad phase at that depth.
Vec3 tree_color(int depth);

/// Of contacts of that color of the solver's, -1 included; neighbors differ in hue and in lightness.
Vec3 contact_color(int color);
/// Of what is solved in so many substeps: lighter where there are more.
Vec3 substep_color(int substeps);

/// Null where nothing is to be shown. Contacts are those of the `selected` body alone, if there is one.
std::shared_ptr<const SolverView> read_solver(const World& world, const SolverShown& shown, double step_length,
                                              BodyId selected = {});

/// Adds strokes for it to the frame.
void draw_solver(RenderFrame& frame, const SolverView& view);

} // namespace cairn::viewer
