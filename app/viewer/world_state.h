/// \file world_state.h
/// What drawing needs to know of a world, copied out of it between two steps so that the world may go on.
/// The layout (which bodies and shapes there are) changes only by commands; the motion changes with every step.
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

/// A shape as it sits on its body.
struct ShapeLayout {
    std::size_t body = 0; ///< Index into `WorldLayout::bodies`.
    ShapeType type = ShapeType::sphere;
    Vec3 position{0.0f, 0.0f, 0.0f}; ///< In the body's frame, meters.
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    /// Meters. Planes lie in their own xz, with their normal along y. Capsules and cylinders: lower radius, half
    /// height, upper radius. Shapes with a mesh of their own: factors of its coordinates.
    Vec3 half_size{0.5f, 0.5f, 0.5f};
    std::optional<Vec3> color;       ///< From the scene, linear.
    std::optional<std::size_t> mesh; ///< Index into `WorldLayout::meshes`.
    bool is_trigger = false;
    Vec3 bound_center{0.0f, 0.0f, 0.0f}; ///< A ball around the shape, in the shape's frame ...
    float bound_radius = 0.0f;           ///< ... meters; infinite planes have none.
    Vec3 bound_extent{0.0f, 0.0f, 0.0f}; ///< Half the edges of a box around `bound_center` that holds it, meters.
};

struct BodyLayout {
    BodyId id;
    BodyType type = BodyType::dynamic;
    float mass = 0.0f; ///< kg; infinite for static and kinematic bodies.
    std::string name;
    bool is_enabled = true;
    bool has_visuals = false; ///< Is shown by `WorldLayout::visuals` instead of by its shapes, where those are shown.
};

/// What a body is called where people read it: its name, or `body 7` for its number.
std::string label_of(BodyId body, const std::string& name);

/// A mesh that came with the scene for its looks.
struct VisualLayout {
    std::optional<std::size_t> body; ///< Index into `WorldLayout::bodies`; absent: scenery.
    Transform local;                 ///< In the body's frame; of scenery, in the world.
    std::size_t mesh = 0;            ///< Index into `WorldLayout::meshes`.
    Vec3 color{0.8f, 0.8f, 0.8f};    ///< Linear.
    /// Of what bends: indices into `WorldLayout::bodies` (absent: it stands still), and from the mesh to their frames.
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
    std::vector<std::shared_ptr<const ShapeMesh>> meshes; ///< Of the shapes that have one, and of visuals, each once.
    float min_mass = 1.0f, greatest_mass = 1.0f;          ///< kg, among dynamic bodies of finite mass.
};

struct SolverView;

/// A fluid (`ForceField`).
struct FluidLayout {
    Position center{0.0, 0.0, 0.0}; ///< Of its surface.
    Vec3 half_extents{0.0f, 0.0f, 0.0f};
    glm::dvec3 up{0.0, 0.0, 0.0}; ///< Away from gravity; zero without it.
};

/// How every body of a layout stands and moves at one moment.
struct WorldMotion {
    std::vector<Transform> transforms;
    std::vector<float> speeds;       ///< m/s, of the centers of mass.
    std::vector<std::uint8_t> awake; ///< 1 or 0.
    /// The least index of a dynamic body that each one is joined to by contacts and joints.
    std::vector<std::uint32_t> islands;
    std::shared_ptr<const std::vector<JointLayout>> joints; ///< Null: not asked for.
    std::vector<JointState> joint_states;                   ///< One for each of `joints`.
    std::shared_ptr<const SolverView> solver;               ///< Null: not asked for.
    std::vector<FluidLayout> fluids;
};

/// Copies the layout. `appearances` and `visuals` of what no longer exists are ignored. `meshes` keeps what it has made
/// for the next call, and drops what this world no longer has.
WorldLayout read_layout(const World& world, std::span<const Appearance> appearances, MeshCache& meshes,
                        std::span<const Visual> visuals = {});
/// Copies the motion of the bodies of a layout, and of the joints that are given. Islands are found only if asked for,
/// else `islands` is empty.
WorldMotion read_motion(const World& world, const WorldLayout& layout, bool with_islands = false,
                        std::shared_ptr<const std::vector<JointLayout>> joints = nullptr);

/// A smallest-effort ball around the dynamic bodies (or, without any, around all finite shapes, or, without those,
/// around the scenery).
struct BoundingBall {
    Position center{0.0, 0.0, 0.0};
    float radius = 5.0f; ///< Meters.
};
BoundingBall bounding_ball(const WorldLayout& layout, const WorldMotion& motion);

/// A view of the whole scene, for scenes that do not bring their own camera.
CameraPose fit_camera(const World& world, std::span<const Visual> visuals = {});

} // namespace cairn::viewer
