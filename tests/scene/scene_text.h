// Builds scene files for tests from their parts.
#pragma once

#include "scene/scene.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <string>

namespace cairn::scene_test {

inline scene::Scene load_text(const std::string& text, const std::string& name = "test.gltf") {
    return scene::load_from_memory(std::as_bytes(std::span(text.data(), text.size())), name);
}

// Parts of a document; each is the text inside its brackets.
struct Parts {
    std::string nodes = "{}";
    std::string roots = "0";
    std::string shapes =
        R"({"type":"sphere","sphere":{"radius":0.5}},{"type":"box","box":{"size":[1,2,3]}},{"type":"plane"})";
    std::string materials = R"({"staticFriction":0.5,"dynamicFriction":0.4,"restitution":0.3})";
    std::string filters;
    std::string world;
    std::string more; // members of the document, with a leading comma
};

inline std::string document(const Parts& parts) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + parts.roots +
           R"(],"extensions":{"CAIRN_world":{)" + parts.world + R"(}}}],"nodes":[)" + parts.nodes +
           R"(],"extensions":{"KHR_implicit_shapes":{"shapes":[)" + parts.shapes +
           R"(]},"KHR_physics_rigid_bodies":{"physicsMaterials":[)" + parts.materials + R"(],"collisionFilters":[)" +
           parts.filters + "]}}" + parts.more + "}";
}

// A node with the given members (with a trailing comma) and members of its KHR_physics_rigid_bodies.
inline std::string node(const std::string& members, const std::string& physics) {
    return "{" + members + R"("extensions":{"KHR_physics_rigid_bodies":{)" + physics + "}}}";
}

// The body of that name in a scene that was loaded from a model.
inline Body body(const scene::Scene& scene, const char* name) {
    return scene.world.body(scene.world.find_body(name).value());
}
inline JointState joint_state(const scene::Scene& scene, const char* name) {
    return scene.world.joint_state(scene.world.find_joint(name).value());
}
inline void run(scene::Scene& scene, double seconds) {
    const int steps = static_cast<int>(std::lround(seconds / static_cast<double>(scene.info.time_step)));
    for (int i = 0; i < steps; ++i) scene.world.step(scene.info.time_step);
}
// A vector of the file, where z is up, in the axes of the world, where y is up.
inline glm::dvec3 seen(const glm::dvec3& v) { return {v.x, v.z, -v.y}; }
inline void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-5) {
    EXPECT_LT(glm::length(a - b), tolerance)
        << a.x << " " << a.y << " " << a.z << ", and " << b.x << " " << b.y << " " << b.z;
}

inline const std::string sphere = R"("collider":{"geometry":{"shape":0}})";
inline const std::string box = R"("collider":{"geometry":{"shape":1}})";
inline const std::string plane = R"("collider":{"geometry":{"shape":2}})";

// The text of an OBJ file.
inline const std::string tetrahedron_file = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

inline scene::Scene load_nodes(const std::string& nodes, const std::string& roots = "0") {
    Parts parts;
    parts.nodes = nodes;
    parts.roots = roots;
    return load_text(document(parts));
}

} // namespace cairn::scene_test
