// Scenes as plain data, so that every engine gets exactly the same bodies. SI units, +y is up. A scene is the same on
// every machine: all random numbers have fixed seeds.
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
    kinematic, // moves with its initial velocity
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
    // Nonzero for a box that is a wall: the normal of the only face that matters. A saved scene has only that face,
    // which is transparent from behind.
    Vec3 inner_face{0.0f, 0.0f, 0.0f};
};

// A convex polyhedron whose center of mass is the origin.
struct ConvexHull {
    std::vector<Vec3> points;                            // all points are vertices, no four are coplanar
    std::vector<std::array<std::uint32_t, 3>> triangles; // counterclockwise as seen from outside
};

// A triangle surface over a grid in the xz plane, solid below. Vertex r * columns + c is at x = (c - (columns - 1) / 2)
// * spacing, z = (r - (rows - 1) / 2) * spacing.
struct SurfaceMesh {
    int columns = 0, rows = 0;
    float spacing = 0.0f; // m
    std::vector<Vec3> vertices;
    // Three per triangle, counterclockwise as seen from above; two triangles per cell, row after row.
    std::vector<std::uint32_t> indices;
};

struct SceneBody {
    Motion motion = Motion::dynamic;
    std::size_t first_part = 0, part_count = 1; // in Scene::parts; parts may overlap, and each has its own mass
    float density = 1000.0f;                    // kg/m^3
    float mass = 0.0f;                          // kg; 0 unless dynamic
    Vec3 center_of_mass{0.0f, 0.0f, 0.0f};      // in the body's frame, m; for dynamic bodies
    // About the center of mass, in the body's axes, kg m^2; for dynamic bodies.
    Mat3 inertia{0.0f};
    Vec3 position{0.0f, 0.0f, 0.0f}; // of the origin of its frame, m
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    Vec3 linear_velocity{0.0f, 0.0f, 0.0f};  // of the center of mass, m/s
    Vec3 angular_velocity{0.0f, 0.0f, 0.0f}; // rad/s
};

enum class JointKind { ball, hinge };

// The range of a ball joint's rotation of B relative to A, rad.
struct SwingTwist {
    float swing = 0; // greatest angle between the x axes of the two frames, less than pi / 2
    float twist = 0; // greatest angle about the x axis in either direction
};

struct AngleRange {
    float lower = 0, upper = 0; // rad
};

// Connects two bodies, at least one of them dynamic, which do not collide with each other. The joint has a frame on
// each body; the x axis of a hinge's frames is its rotation axis. The frames coincide in the initial state: all angles
// are 0 there.
struct SceneJoint {
    JointKind kind = JointKind::ball;
    std::size_t body_a = 0, body_b = 0;
    Vec3 anchor_a{0.0f, 0.0f, 0.0f}, anchor_b{0.0f, 0.0f, 0.0f}; // in the bodies' frames, m
    Quat axes_a{1.0f, 0.0f, 0.0f, 0.0f}, axes_b{1.0f, 0.0f, 0.0f, 0.0f};
    std::optional<SwingTwist> reach; // of a ball joint; absent: unlimited
    std::optional<AngleRange> angle; // of a hinge, B relative to A about the x axis; absent: unlimited
};

struct Scene {
    std::string name;
    int steps = 600;
    float time_step = 1.0f / 60.0f;   // s
    Vec3 gravity{0.0f, -10.0f, 0.0f}; // m/s^2
    float friction = 0.6f;            // of every pair
    float restitution = 0.0f;         // of every pair
    bool stands = false;              // whether the bodies should stay at their initial positions
    bool collides = true;             // false: nothing collides with anything
    std::size_t dynamic_count = 0;
    std::vector<Part> parts;
    std::vector<SceneBody> bodies;
    std::vector<SceneJoint> joints;
    std::vector<ConvexHull> hulls;
    std::vector<SurfaceMesh> meshes;
    // A body whose origin leaves these bounds, or exceeds this distance from the line through `axis_point` along z, is
    // lost.
    Vec3 lower_bound{-1e9f, -0.5f, -1e9f}, upper_bound{1e9f, 1e9f, 1e9f};
    float axis_distance = 1e9f;
    Vec3 axis_point{0.0f, 0.0f, 0.0f};
};

struct SceneKind {
    std::string_view name;
    std::string_view description;
    std::string_view size_meaning; // meaning of the `size` argument of make_scene
    int default_size;
    int greatest_size;
};

// All scenes.
std::span<const SceneKind> scene_kinds();

// An unknown name or an invalid size.
struct SceneError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Throws SceneError if make_scene would throw it.
void check_size(std::string_view name, int size);

// Builds a scene. `size` has the meaning SceneKind::size_meaning, from 1 to greatest_size; 0 stands for default_size.
// Throws SceneError.
Scene make_scene(std::string_view name, int size = 0);

} // namespace cairn::bench
