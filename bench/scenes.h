// Scenes as plain data, so that every engine is given exactly the same bodies. SI units, +y is up. A scene is the
// same on every machine: all randomness comes from fixed seeds.
#pragma once

#include <cairn/math.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::bench {

enum class PartShape { sphere, box, capsule, cylinder, hull, mesh };

enum class Motion {
    fixed,     // never moves
    kinematic, // moves with the velocity it starts with
    dynamic,
};

// One shape of a body.
struct Part {
    PartShape shape = PartShape::box;
    Vec3 half_extents{0.5f, 0.5f, 0.5f};   // box, m
    float radius = 0.5f;                   // sphere, capsule, cylinder, m
    float half_height = 0.5f;              // cylinder, and capsule up to the centers of its balls; along y, m
    std::size_t index = 0;                 // hull: in Scene::hulls; mesh: in Scene::meshes
    Vec3 position{0.0f, 0.0f, 0.0f};       // in the body's frame, m
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f}; // in the body's frame
    // Box: not zero where it is a wall that only its face of this normal is needed of. A saved scene has that face
    // alone, which one sees through from behind.
    Vec3 inner_face{0.0f, 0.0f, 0.0f};
};

// A convex polyhedron; the center of its mass is the origin.
struct ConvexHull {
    std::vector<Vec3> points;                            // all are corners, no four in one plane
    std::vector<std::array<std::uint32_t, 3>> triangles; // counterclockwise as seen from outside
};

// A surface of triangles over a grid in the xz plane, solid below. Vertex r * columns + c stands at
// x = (c - (columns - 1) / 2) * spacing, z = (r - (rows - 1) / 2) * spacing.
struct SurfaceMesh {
    int columns = 0, rows = 0;
    float spacing = 0.0f; // m
    std::vector<Vec3> vertices;
    // Three a triangle, counterclockwise as seen from above; two triangles a cell, row after row.
    std::vector<std::uint32_t> indices;
};

struct SceneBody {
    Motion motion = Motion::dynamic;
    std::size_t first_part = 0, part_count = 1; // of Scene::parts; parts may overlap, and each has its mass
    float density = 1000.0f;                    // kg/m^3
    float mass = 0.0f;                          // kg; 0 unless dynamic
    Vec3 center_of_mass{0.0f, 0.0f, 0.0f};      // in the body's frame, m; of dynamic bodies
    Mat3 inertia{0.0f};                         // about the center of mass, in the body's axes, kg m^2; likewise
    Vec3 position{0.0f, 0.0f, 0.0f};            // of the origin of its frame, m
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    Vec3 linear_velocity{0.0f, 0.0f, 0.0f};  // of the center of mass, m/s
    Vec3 angular_velocity{0.0f, 0.0f, 0.0f}; // rad/s
};

enum class JointKind { ball, hinge };

// How far a ball joint lets B turn against A, rad.
struct SwingTwist {
    float swing = 0; // greatest angle between the x axes of the two frames, less than pi / 2
    float twist = 0; // greatest angle about the x axis, to either side
};

struct AngleRange {
    float lower = 0, upper = 0; // rad
};

// Holds two bodies together, one of them dynamic; they do not collide with each other. It has a frame on each body,
// whose x axis is that of a hinge. The frames coincide where the scene begins: all angles are 0 there.
struct SceneJoint {
    JointKind kind = JointKind::ball;
    std::size_t body_a = 0, body_b = 0;
    Vec3 anchor_a{0.0f, 0.0f, 0.0f}, anchor_b{0.0f, 0.0f, 0.0f}; // in the bodies' frames, m
    Quat axes_a{1.0f, 0.0f, 0.0f, 0.0f}, axes_b{1.0f, 0.0f, 0.0f, 0.0f};
    std::optional<SwingTwist> reach; // ball; absent: it turns freely
    std::optional<AngleRange> angle; // hinge: of B against A about the x axis; likewise
};

struct Scene {
    std::string name;
    int steps = 600;
    float time_step = 1.0f / 60.0f;   // s
    Vec3 gravity{0.0f, -10.0f, 0.0f}; // m/s^2
    float friction = 0.6f;            // of every pair
    float restitution = 0.0f;         // of every pair
    bool stands = false;              // what is built should stay where it is
    bool collides = true;             // false: nothing collides with anything
    std::size_t dynamic_count = 0;
    std::vector<Part> parts;
    std::vector<SceneBody> bodies;
    std::vector<SceneJoint> joints;
    std::vector<ConvexHull> hulls;
    std::vector<SurfaceMesh> meshes;
    // A body whose origin leaves these bounds, or this distance from the line through `axis_point` along z, is lost.
    Vec3 lower_bound{-1e9f, -0.5f, -1e9f}, upper_bound{1e9f, 1e9f, 1e9f};
    float axis_distance = 1e9f;
    Vec3 axis_point{0.0f, 0.0f, 0.0f};
};

struct SceneKind {
    std::string_view name;
    std::string_view description;
    std::string_view size_meaning; // what `size` is in make_scene
    int default_size;
    int greatest_size;
};

// Every scene there is.
std::span<const SceneKind> scene_kinds();

// A wrong name or size.
struct SceneError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Throws SceneError if make_scene would.
void check_size(std::string_view name, int size);

// Builds a scene. `size` is what SceneKind::size_meaning says, from 1 to greatest_size; 0 stands for default_size.
// Throws SceneError.
Scene make_scene(std::string_view name, int size = 0);

} // namespace cairn::bench
