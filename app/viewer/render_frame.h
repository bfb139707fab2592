/// \file render_frame.h
/// A description of one picture: everything that a renderer needs and nothing else. `make_frame` makes one from a
/// world:
///
///     HeadlessRenderer renderer(1280, 720);
///     renderer.draw(make_frame(world, appearances, camera));
///     renderer.save_picture("out.png");
#pragma once

#include "viewer/lights.h"
#include "viewer/side_run.h"
#include "viewer/world_state.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace cairn::viewer {

/// The property that the color of a body shows.
enum class ColorMode { scene, mass, speed, island, shape };
inline constexpr int color_mode_count = 5;
const char* name_of(ColorMode mode);

/// One shape instance. Laid out as the renderer's instance buffer expects it: 16 floats.
struct Instance {
    Vec3 position{0.0f, 0.0f, 0.0f};            ///< Relative to `RenderFrame::origin`, meters.
    float emphasis = 0.0f;                      ///< 0 plain, 1 highlighted.
    glm::vec4 rotation{0.0f, 0.0f, 0.0f, 1.0f}; ///< Quaternion x, y, z, w.
    Vec3 half_size{0.5f, 0.5f, 0.5f};           ///< See `ShapeLayout::half_size`.
    float pattern = 1.0f;                       ///< Strength of the pattern that shows rotation or slope, 0 to 1.
    Vec3 color{0.8f, 0.8f, 0.8f};               ///< Linear.
    float bound_radius = 0.0f;                  ///< Radius of a bounding sphere around `position`, meters.
};
static_assert(sizeof(Instance) == 64);

/// All instances of one mesh.
struct MeshInstances {
    std::shared_ptr<const ShapeMesh> mesh;
    std::vector<Instance> instances;
};

/// An infinite plane, drawn as a ground with a grid that fades.
struct GroundPlane {
    Vec3 position{0.0f, 0.0f, 0.0f};       ///< A point of the plane near the origin, relative to `RenderFrame::origin`.
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f}; ///< From the plane's frame (normal along y) to the world.
    /// Position of `position` on the grid, meters, along x and z of the plane's frame.
    glm::vec2 grid_offset{0.0f, 0.0f};
    Vec3 color{0.6f, 0.6f, 0.6f}; ///< Linear.
};

/// A line segment, relative to `RenderFrame::origin`.
struct Line {
    Vec3 from, to;
    Vec3 color{1.0f, 1.0f, 1.0f};
};

/// A stroke of constant width that is visible through all surfaces, fainter where it is hidden. `from` = `to`: a dot.
/// Relative to `RenderFrame::origin`.
struct Stroke {
    Vec3 from, to;
    Vec3 color{1.0f, 1.0f, 1.0f};
    float width = 2.0f; ///< Pixels of a picture 720 pixels high; for a dot, its diameter.
};

/// A translucent colored triangle, visible from both sides. Relative to `RenderFrame::origin`.
struct Veil {
    Vec3 a, b, c;
    Vec3 color{1.0f, 1.0f, 1.0f};
};

/// The twelve edges of a box, each a pixel wide. Relative to `RenderFrame::origin`.
struct LineBox {
    Vec3 min, max;
    Vec3 color{1.0f, 1.0f, 1.0f};
};

/// Solid bodies.
struct ShapeInstances {
    std::vector<Instance> spheres, boxes, rectangles, capsules, cylinders;
    std::vector<MeshInstances> meshes;
};

struct RenderFrame : ShapeInstances {
    Position origin{0.0, 0.0, 0.0}; ///< World position to which all coordinates are relative.
    CameraPose camera;
    ShapeInstances ghosts; ///< Transparent, without shadows.
    std::vector<GroundPlane> grounds;
    std::vector<Line> lines;
    std::vector<LineBox> line_boxes;
    std::vector<Stroke> strokes;
    std::vector<Veil> veils;
    std::vector<Veil> fluids; ///< Surfaces of fluids: hidden by objects in front of them, and less transparent.
    bool grid = true;         ///< Draw the lines of the ground.
    bool shadows = true;
    Lighting lighting; ///< In world coordinates.
};

/// Which joints are drawn. `some`: the selected joint, those of the selected body, those loaded to at least half of
/// their breaking force or torque, and those with a large position or angular error.
enum class JointsShown { some, all, none };
inline constexpr int joints_shown_count = 3;
const char* name_of(JointsShown shown);

/// A body that is dragged by one of its points.
struct DragLine {
    BodyId body;
    Vec3 local_point{0.0f, 0.0f, 0.0f}; ///< The grabbed point in the body's frame, meters.
    Position target{0.0, 0.0, 0.0};     ///< World position that the point is pulled toward.
};

struct FrameOptions {
    ColorMode colors = ColorMode::scene;
    bool grid = true;
    bool shadows = true;
    bool visuals = true;                    ///< Bodies with visual meshes are drawn by these; else by their shapes.
    BodyId selected;                        ///< Highlighted; null for none.
    std::vector<BodyId> selection;          ///< All selected bodies, highlighted, in ascending order.
    JointsShown joints = JointsShown::none; ///< Which are drawn (joint_drawing.h).
    JointId selected_joint;
    Lighting lighting;
    std::optional<DragLine> drag; ///< Shown as a line with a dot at both ends.
};

/// The picture between two motions of one layout: `fraction` 0 shows `previous`, 1 shows `current`; between them it
/// interpolates.
RenderFrame make_frame(const WorldLayout& layout, const WorldMotion& previous, const WorldMotion& current,
                       float fraction, const CameraPose& camera, const FrameOptions& options = {});

/// Adds the bodies of another run as ghosts, except those in the same pose as in the displayed run, and infinite
/// shapes.
void add_ghosts(RenderFrame& frame, const WorldLayout& layout, const WorldMotion& current, const RunPicture& other,
                float fraction, const FrameOptions& options);

/// The picture of a world in its present state. `meshes` caches the triangles of its hulls, meshes and height fields
/// for the next picture; without it they are generated each time.
RenderFrame make_frame(const World& world, std::span<const Appearance> appearances, const CameraPose& camera,
                       const FrameOptions& options, MeshCache& meshes, std::span<const Visual> visuals = {},
                       std::span<const JointAppearance> strings = {});
RenderFrame make_frame(const World& world, std::span<const Appearance> appearances, const CameraPose& camera,
                       const FrameOptions& options = {});

} // namespace cairn::viewer
