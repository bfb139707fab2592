// Builds scene files with meshes, with all their buffers and accessors.
#pragma once

#include "scene_text.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace cairn::scene_test {

inline std::string base64(const std::string& bytes) {
    static const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    unsigned buffer = 0;
    int bits = 0;
    for (const char c : bytes) {
        buffer = buffer << 8 | static_cast<unsigned char>(c);
        for (bits += 8; bits >= 6; bits -= 6) text += digits[buffer >> (bits - 6) & 63];
    }
    if (bits > 0) text += digits[buffer << (6 - bits) & 63];
    while (text.size() % 4 != 0) text += '=';
    return text;
}

template <class T> std::string packed(const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

// A document with meshes. Members of its arrays are added as text; `view` fills the buffer.
struct MeshParts {
    std::string nodes, roots = "0", meshes, accessors, views, shapes, filters, joints, buffer, more;
    int view_count = 0, accessor_count = 0;

    // Each of these functions returns the index of the element that it adds.
    int view(const std::string& bytes, const std::string& members = "") {
        buffer.resize((buffer.size() + 3) / 4 * 4);
        views += (views.empty() ? "" : ",") + std::string(R"({"buffer":0,"byteOffset":)") +
                 std::to_string(buffer.size()) + R"(,"byteLength":)" + std::to_string(bytes.size()) + members + "}";
        buffer += bytes;
        return view_count++;
    }
    int accessor(int view, int component_type, std::size_t count, const std::string& type,
                 const std::string& members = "") {
        accessors += (accessors.empty() ? "" : ",") + std::string(R"({"bufferView":)") + std::to_string(view) +
                     R"(,"componentType":)" + std::to_string(component_type) + R"(,"count":)" + std::to_string(count) +
                     R"(,"type":")" + type + "\"" + members + "}";
        return accessor_count++;
    }
    int positions(const std::vector<float>& values) {
        return accessor(view(packed(values)), 5126, values.size() / 3, "VEC3");
    }
    int indices(const std::vector<std::uint16_t>& values) {
        return accessor(view(packed(values)), 5123, values.size(), "SCALAR");
    }
    void mesh(int positions, int indices, const std::string& members = "") {
        meshes += (meshes.empty() ? "" : ",") + std::string(R"({"primitives":[{"attributes":{"POSITION":)") +
                  std::to_string(positions) + "}" +
                  (indices >= 0 ? R"(,"indices":)" + std::to_string(indices) : std::string()) + members + "}]}";
    }

    std::string json(const std::string& buffer_entry) const {
        return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + roots + R"(]}],"nodes":[)" + nodes +
               R"(],"meshes":[)" + meshes + R"(],"accessors":[)" + accessors + R"(],"bufferViews":[)" + views +
               R"(],"buffers":[)" + buffer_entry + R"(],"extensions":{"KHR_implicit_shapes":{"shapes":[)" + shapes +
               R"(]},"KHR_physics_rigid_bodies":{"collisionFilters":[)" + filters + R"(],"physicsJoints":[)" + joints +
               "]}}" + more + "}";
    }
    std::string text() const { return text(R"("data:application/octet-stream;base64,)" + base64(buffer) + "\""); }
    std::string text(const std::string& uri) const {
        return json(R"({"byteLength":)" + std::to_string(buffer.size()) + R"(,"uri":)" + uri + "}");
    }
    std::string container() const {
        std::string text = json(R"({"byteLength":)" + std::to_string(buffer.size()) + "}"), data = buffer;
        text.resize((text.size() + 3) / 4 * 4, ' ');
        data.resize((data.size() + 3) / 4 * 4, '\0');
        const auto word = [](std::size_t value) { return packed(std::vector<std::uint32_t>{std::uint32_t(value)}); };
        return "glTF" + word(2) + word(28 + text.size() + data.size()) + word(text.size()) + "JSON" + text +
               word(data.size()) + std::string("BIN\0", 4) + data;
    }
};

// Vertices and triangles of a tetrahedron with one vertex at the origin and legs of 1, 2 and 3 m along the axes.
inline const std::vector<float> tetrahedron_corners{0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3};
inline const std::vector<std::uint16_t> tetrahedron_triangles{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

// A static body with that tetrahedron; node 1, which is not in the scene, has the mesh.
inline MeshParts tetrahedron(const std::string& physics, const std::string& members = "") {
    MeshParts parts;
    const int positions = parts.positions(tetrahedron_corners);
    parts.mesh(positions, parts.indices(tetrahedron_triangles));
    parts.nodes = node(members, physics) + R"(,{"mesh":0})";
    return parts;
}

inline const std::string hull_of_node_1 = R"("collider":{"geometry":{"node":1,"convexHull":true}})";
inline const std::string mesh_of_node_1 = R"("collider":{"geometry":{"node":1}})";

// A height field with 3 columns and 2 rows, spacing 1 and 2 m, heights 0 to 5 m: shape 0.
inline MeshParts height_field() {
    MeshParts parts;
    const int heights = parts.accessor(parts.view(packed(std::vector<float>{0, 1, 2, 3, 4, 5})), 5126, 6, "SCALAR");
    parts.mesh(heights, -1); // no node uses it: it only makes the array of meshes valid
    parts.shapes = R"({"type":"CAIRN_height_field","extensions":{"CAIRN_height_field":{"columns":3,"rows":2,)"
                   R"("spacing":[1,2],"heights":)" +
                   std::to_string(heights) + "}}}";
    parts.nodes = node("", R"("collider":{"geometry":{"shape":0}})");
    return parts;
}

} // namespace cairn::scene_test
