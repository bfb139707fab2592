/// \file solver_view.h
/// The data of the solver, drawn over the view: contacts with their forces, friction cones, velocities, bounding boxes,
/// principal axes, islands, colors and substeps.
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

/// Greatest displayed depth of the broad phase's trees; 8^8 bodies need no deeper ones.
inline constexpr int greatest_tree_depth = 8;
inline constexpr std::size_t max_wide_boxes = 3000; ///< Number of boxes beyond which edges are drawn one pixel wide.

/// Which parts of the solver's data are shown.
struct SolverShown {
    bool contacts = false, cones = false, velocities = false, bounds = false, axes = false, islands = false;
    bool difference = false, tree = false, colors = false, substeps = false;
    int tree_depth = 2; ///< Depth down to which boxes of the broad phase's tree are shown, 0 to `greatest_tree_depth`.
    bool any() const { return *this != SolverShown{.tree_depth = tree_depth}; }
    friend bool operator==(const SolverShown&, const SolverShown&) = default;
};

/// A displayable part with its name and a sentence on how to read it.
struct SolverPart {
    const char* name;
    bool SolverShown::*shown;
    const char* meaning;
    const char* page; ///< Documentation page with details.
};
std::span<const SolverPart> solver_parts();

/// The solver's data after a step.
struct SolverView {
    struct Point {
        Position place{0.0, 0.0, 0.0};
        Vec3 normal{0.0f, 1.0f, 0.0f}; ///< Points to the body that is pushed: a dynamic one, and the upper one of two.
        float normal_force = 0.0f;     ///< N, mean over the step.
        Vec3 friction{0.0f, 0.0f, 0.0f}; ///< N, on the same body: this point's share of the contact's friction force.
        float coefficient = 0.0f;        ///< Coefficient of static friction of the pair.
    };
    struct Mover {
        Position center{0.0, 0.0, 0.0};
        Vec3 velocity{0.0f, 0.0f, 0.0f},
            angular_velocity{0.0f, 0.0f, 0.0f}; ///< Linear and angular velocity, m/s and rad/s.
        Quat axes{1.0f, 0.0f, 0.0f, 0.0f};      ///< Rotation from the principal axes to the world.
        /// Half axes of the homogeneous ellipsoid with the same mass and inertia, meters.
        Vec3 half_axes{0.0f, 0.0f, 0.0f};
    };
    struct Link {
        Position a{0.0, 0.0, 0.0}, b{0.0, 0.0, 0.0}; ///< Centers of mass.
        bool is_joint = false;
    };
    /// A contact in solving order.
    struct Solved {
        Position place{0.0, 0.0, 0.0};          ///< Mean of its contact points.
        std::optional<Position> from_a, from_b; ///< Centers of mass of those of its bodies that forces can move.
        int color = 0, substeps = 0;            ///< As in `SolverContact`.
    };
    SolverShown shown;
    std::vector<Point> points;
    std::vector<Solved> solved;
    std::vector<Mover> movers; ///< Dynamic bodies.
    std::vector<Bounds> bounds;
    std::vector<Link> links;
    /// Nodes of the broad phase's trees; with a selected body, those on the path to it.
    std::vector<BroadPhaseNode> nodes;
    std::optional<PairDifference> difference; ///< Minkowski difference of the selected body and its nearest neighbor.
};

/// The color of broad-phase boxes at that depth.
Vec3 tree_color(int depth);

/// The color in which contacts of a solver graph color are drawn, -1 included; neighboring colors differ in hue and
/// lightness.
Vec3 contact_color(int color);
/// The color for that number of substeps: lighter for more.
Vec3 substep_color(int substeps);

/// Null if nothing is to be shown. Contacts are limited to those of the `selected` body, if there is one.
std::shared_ptr<const SolverView> read_solver(const World& world, const SolverShown& shown, double step_length,
                                              BodyId selected = {});

/// Adds the view's strokes to the frame.
void draw_solver(RenderFrame& frame, const SolverView& view);

} // namespace cairn::viewer
