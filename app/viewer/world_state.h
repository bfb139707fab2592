/// \file world_state.h
/// The data of a world that drawing needs, copied between two steps so that the world may continue. The layout (which
/// bodies and shapes exist) changes only by commands; the motion changes with every step.
#pragma once

#include "viewer/joint_layout.h"
#include "viewer/scene_source.h"
#include "viewer/shape_meshes.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cairn::viewer {

/// A shape and its pose on its body.
struct ShapeLayout {
    std::size_t body = 0; ///< Index into `WorldLayout::bodies`.
    ShapeType type = ShapeType::sphere;
    Vec3 position{0.0f, 0.0f, 0.0f}; ///< In the body's frame, meters.
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    /// Meters. Planes span their local xz, with their normal along y. Capsules and cylinders: lower radius, half
    /// height, upper radius. Shapes with a mesh of their own: scale factors of the mesh coordinates.
    Vec3 half_size{0.5f, 0.5f, 0.5f};
    std::optional<Vec3> color;       ///< From the scene, linear RGB.
    std::optional<std::size_t> mesh; ///< Index into `WorldLayout::meshes`.
    bool is_trigger = false;
    Vec3 bound_center{0.0f, 0.0f, 0.0f}; ///< Center of a bounding sphere, in the shape's frame ...
    float bound_radius = 0.0f;           ///< ... and its radius, meters; 0 for infinite planes.
    Vec3 bound_extent{0.0f, 0.0f, 0.0f}; ///< Half extents of a bounding box around `bound_center`, meters.
};

struct BodyLayout {
    BodyId id;
    BodyType type = BodyType::dynamic;
    float mass = 0.0f; ///< kg; infinite for static and kinematic bodies.
    std::string name;
    bool is_enabled = true;
    /// While visuals are shown, the body is drawn by `WorldLayout::visuals` instead of by its shapes.
    bool has_visuals = false;
};

/// The display label of a body: its name, or for example `body 7` from its number.
std::string label_of(BodyId body, const std::string& name);

/// A visual mesh: a mesh of the scene that does not collide.
struct VisualLayout {
    std::optional<std::size_t> body; ///< Index into `WorldLayout::bodies`; absent: static scenery.
    Transform local;                 ///< Pose in the body's frame, or of scenery in the world.
    std::size_t mesh = 0;            ///< Index into `WorldLayout::meshes`.
    Vec3 color{0.8f, 0.8f, 0.8f};    ///< Linear.
    /// A bone of a skinned mesh: an index into `WorldLayout::bodies` (absent: fixed in the world), and the map from
    /// mesh coordinates to the frame of that body.
    struct Part {
        std::optional<std::size_t> body;
        glm::dmat3 linear{1.0};
        glm::dvec3 translation{0.0, 0.0, 0.0};
    };
    std::vector<Part> parts{};
};

struct WorldLayout {
    std::vector<BodyLayout> bodies;
    std::vector<ShapeLayout> shapes;
    std::vector<VisualLayout> visuals;
    std::vector<std::shared_ptr<const ShapeMesh>> meshes; ///< Meshes of shapes and visuals, without duplicates.
    float min_mass = 1.0f, greatest_mass = 1.0f;          ///< kg, among dynamic bodies of finite mass.
};

struct SolverView;

/// A fluid (`ForceField`).
struct FluidLayout {
    Position center{0.0, 0.0, 0.0}; ///< Center of the surface.
    Vec3 half_extents{0.0f, 0.0f, 0.0f};
    glm::dvec3 up{0.0, 0.0, 0.0}; ///< Unit vector against gravity; zero without gravity.
};

/// The poses and motion of all bodies of a layout at one moment.
struct WorldMotion {
    std::vector<Transform> transforms;
    std::vector<float> speeds;       ///< m/s, of the centers of mass.
    std::vector<std::uint8_t> awake; ///< 1 or 0.
    /// Island label of each body: the least index of a dynamic body of its island.
    std::vector<std::uint32_t> islands;
    std::shared_ptr<const std::vector<JointLayout>> joints; ///< Null: not requested.
    std::vector<JointState> joint_states;                   ///< One for each of `joints`.
    std::shared_ptr<const SolverView> solver;               ///< Null: not requested.
    std::vector<FluidLayout> fluids;
};

/// Copies the layout. `appearances` and `visuals` of objects that no longer exist are ignored. `meshes` caches meshes
/// for the next call, and drops those that this world does not use.
WorldLayout read_layout(const World& world, std::span<const Appearance> appearances, MeshCache& meshes,
                        std::span<const Visual> visuals = {});
/// Copies the motion of the bodies of a layout, and of the given joints. Islands are found only on request; else
/// `islands` is empty.
WorldMotion read_motion(const World& world, const WorldLayout& layout, bool with_islands = false,
                        std::shared_ptr<const std::vector<JointLayout>> joints = nullptr);

/// A bounding sphere, not the smallest, of the dynamic bodies (or, without any, of all finite shapes, or, without
/// those, of the scenery).
struct BoundingBall {
    Position center{0.0, 0.0, 0.0};
    float radius = 5.0f; ///< Meters.
};
BoundingBall bounding_ball(const WorldLayout& layout, const WorldMotion& motion);

/// A view of the whole scene, for scenes that do not bring their own camera.
CameraPose fit_camera(const World& world, std::span<const Visual> visuals = {});

} // namespace cairn::viewer
