// Scene files with buffers that are truncated, have flipped bits, or declare wrong sizes: each is rejected with an
// error, or loads as a scene that runs. Nothing else may happen.
#include "mesh_text.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <functional>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;

// A file that contains everything that uses buffers.
MeshParts everything() {
    MeshParts parts = height_field();
    const int positions = parts.positions(tetrahedron_corners);
    parts.mesh(positions, parts.indices(tetrahedron_triangles));
    const int sparse_indices = parts.view(packed(std::vector<std::uint16_t>{1, 3}));
    const int sparse_values = parts.view(packed(std::vector<float>{1, 0, 0, 0, 0, 3}));
    const int sparse = parts.accessor(
        parts.view(packed(std::vector<float>{0, 0, 0, 9, 9, 9, 0, 2, 0, 9, 9, 9}), R"(,"byteStride":12)"), 5126, 4,
        "VEC3",
        R"(,"sparse":{"count":2,"indices":{"bufferView":)" + std::to_string(sparse_indices) +
            R"(,"componentType":5123},"values":{"bufferView":)" + std::to_string(sparse_values) + "}}");
    parts.mesh(sparse, parts.indices({0, 2, 1, 3}), R"(,"mode":5)");
    parts.filters = R"({"collisionSystems":["a"],"notCollideWithSystems":["b"]})";
    parts.joints = R"({"limits":[{"linearAxes":[0,1,2],"min":0,"max":0}],"drives":[{"type":"angular","mode":"force",)"
                   R"("axis":1,"velocityTarget":1,"damping":2}]})";
    parts.nodes = node("", R"("collider":{"geometry":{"shape":0},"collisionFilter":0})") +
                  R"(,{"mesh":1},{"mesh":2},)" +
                  node(R"("name":"a","translation":[0,9,0],"children":[4],"mesh":1,)",
                       R"("motion":{},"collider":{"geometry":{"node":1,"convexHull":true}})") +
                  "," + node("", R"("joint":{"joint":0,"connectedNode":0})") + "," +
                  node(R"("scale":[1,-2,1],)", R"("collider":{"geometry":{"node":2}})") + "," +
                  node("", R"("trigger":{"geometry":{"node":1}})");
    parts.roots = "0,3,5,6";
    return parts;
}

// Loads the file and runs a step, if it can be loaded. Returns whether it could.
bool survives(const std::string& bytes) {
    try {
        Scene scene = load_text(bytes, "test.glb");
        scene.world.step(1.0f / 60.0f);
        return true;
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find("test.glb: "), 0u) << error.what();
        EXPECT_TRUE(error.code() == ErrorCode::invalid_file || error.code() == ErrorCode::unsupported) << error.what();
        return false;
    }
}

TEST(SceneDamage, TheWholeFileLoads) {
    for (const std::string& file : {everything().container(), everything().text()}) {
        const Scene scene = load_text(file);
        EXPECT_EQ(scene.world.bodies().size(), 4u);
        EXPECT_EQ(scene.world.joints().size(), 1u);
        EXPECT_EQ(scene.visuals.size(), 1u);
    }
}

TEST(SceneDamage, CutOffAtEveryByte) {
    for (const std::string& file : {everything().container(), everything().text()}) {
        for (std::size_t length = 0; length < file.size(); ++length) {
            EXPECT_FALSE(survives(file.substr(0, length))) << length;
        }
    }
}

TEST(SceneDamage, ChunksThatEndEarly) {
    const std::string whole = everything().container();
    // The container's own length is adjusted: the truncated part is the binary chunk, or its header.
    for (std::size_t length = 12; length < whole.size(); ++length) {
        std::string cut = whole.substr(0, length);
        for (std::size_t i = 0; i < 4; ++i) cut[8 + i] = static_cast<char>(length >> (8 * i) & 0xFF);
        EXPECT_FALSE(survives(cut)) << length;
    }
}

TEST(SceneDamage, EveryBitFlipped) {
    const std::string whole = everything().container();
    int loaded = 0, refused = 0;
    for (std::size_t bit = 0; bit < whole.size() * 8; ++bit) {
        std::string file = whole;
        file[bit / 8] = static_cast<char>(file[bit / 8] ^ (1 << bit % 8));
        ++(survives(file) ? loaded : refused);
    }
    EXPECT_GT(loaded, 1000);
    EXPECT_GT(refused, 1000);
}

// Expects the tetrahedron's file to be rejected after the first `from` has been replaced by `to`.
void expect_refused(const std::string& from, const std::string& to, const std::string& message) {
    std::string text = tetrahedron(hull_of_node_1).text();
    const std::size_t place = text.find(from);
    ASSERT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    try {
        load_text(text);
        FAIL() << "loaded with " << to;
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), "test.gltf: " + message);
    }
}

TEST(SceneDamage, CountsAndOffsetsThatLie) {
    const std::string positions = R"("componentType":5126,"count":4)", indices = R"("componentType":5123,"count":12)";
    const std::string whole_count = "must be a whole number from 1 to 67108864, got ";
    expect_refused(positions, R"("componentType":5126,"count":4294967295)",
                   "accessors[0].count: " + whole_count + "4294967295");
    expect_refused(positions, R"("componentType":5126,"count":0)", "accessors[0].count: " + whole_count + "0");
    expect_refused(positions, R"("componentType":5126,"count":-4)", "accessors[0].count: " + whole_count + "-4");
    expect_refused(positions, R"("componentType":5126,"count":3.5)", "accessors[0].count: " + whole_count + "3.5");
    expect_refused(positions, R"("componentType":5126,"count":67108864)",
                   "accessors[0].count: must not raise the total of numbers in the file above 67108864, got 67108864");
    expect_refused(positions, R"("componentType":5126,"count":5)",
                   "accessors[0]: must end in its buffer view of 48 bytes, and reaches to 60, got an object");
    expect_refused(positions, R"("componentType":5126,"byteOffset":1,"count":4)",
                   "accessors[0]: must end in its buffer view of 48 bytes, and reaches to 49, got an object");
    expect_refused(positions, R"("componentType":5126,"byteOffset":536870912,"count":4)",
                   "accessors[0]: must end in its buffer view of 48 bytes, and reaches to 536870960, got an object");
    expect_refused(positions, R"("componentType":5126,"byteOffset":18446744073709551615,"count":4)",
                   "accessors[0].byteOffset: must be a whole number from 0 to 536870912, got 18446744073709551615");
    expect_refused(positions, R"("componentType":5124,"count":4)",
                   "accessors[0].componentType: must be 5120, 5121, 5122, 5123, 5125 or 5126, got 5124");
    expect_refused(indices, R"("componentType":5123,"count":10)",
                   "meshes[0].primitives[0]: must have three corners for each triangle, and has 10, got an object");
    expect_refused(indices, R"("componentType":5126,"count":6)",
                   "accessors[1].componentType: must be 5121, 5123 or 5125 here, got 5126");
    const std::string view = R"("byteOffset":0,"byteLength":48)";
    expect_refused(view, R"("byteOffset":0,"byteLength":4294967295)",
                   "bufferViews[0].byteLength: must be a whole number from 1 to 536870912, got 4294967295");
    expect_refused(view, R"("byteOffset":0,"byteLength":0)",
                   "bufferViews[0].byteLength: must be a whole number from 1 to 536870912, got 0");
    expect_refused(view, R"("byteOffset":48,"byteLength":48)",
                   "bufferViews[0].byteLength: must end in the buffer, which has 24 bytes from the offset on, got 48");
    expect_refused(view, R"("byteOffset":73,"byteLength":48)",
                   "bufferViews[0].byteOffset: must lie in the buffer, which has 72 bytes, got 73");
    expect_refused(view, R"("byteOffset":18446744073709551600,"byteLength":48)",
                   "bufferViews[0].byteOffset: must be a whole number from 0 to 536870912, got 18446744073709551600");
    expect_refused(view, view + R"(,"byteStride":3)",
                   "bufferViews[0].byteStride: must be a whole number from 4 to 252, got 3");
    expect_refused(view, view + R"(,"byteStride":8)",
                   "accessors[0]: must not have elements of 12 bytes in a view with a stride of 8, got an object");
    expect_refused(R"("byteLength":72,"uri")", R"("byteLength":73,"uri")",
                   "buffers[0].byteLength: must be at most the 72 bytes that there are, got 73");
    expect_refused(R"({"buffer":0)", R"({"buffer":1)",
                   "bufferViews[0].buffer: must be the index of one of the 1 buffers, got 1");
    expect_refused(R"("POSITION":0)", R"("POSITION":1)", "accessors[1].type: must be \"VEC3\" here, got \"SCALAR\"");
    expect_refused(R"("POSITION":0)", R"("POSITION":2)",
                   "meshes[0].primitives[0].attributes.POSITION: must be the index of one of the 2 accessors, got 2");
    expect_refused(R"("geometry":{"node":1)", R"("geometry":{"node":2)",
                   "nodes[0].extensions.KHR_physics_rigid_bodies.collider.geometry.node: must be the index of one of "
                   "the 2 nodes, got 2");
    expect_refused(";base64,", ";base32,",
                   "buffers[0].uri: must be a data URI in base64, got "
                   "\"data:application/octet-stream;base32,AAAAAAAAAAAAAAAAAACAPwA\"...");
}

TEST(SceneDamage, IndicesBeyondTheVertices) {
    MeshParts parts;
    const int positions = parts.positions(tetrahedron_corners);
    parts.mesh(positions, parts.indices({0, 1, 4}));
    parts.nodes = node("", hull_of_node_1) + R"(,{"mesh":0})";
    try {
        load_text(parts.text());
        FAIL() << "loaded";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "test.gltf: meshes[0].primitives[0].indices: must stay below the 4 vertices, and has "
                     "4 at 2, got 1");
    }
}

TEST(SceneDamage, SparseIndicesThatDoNotIncrease) {
    for (const std::vector<std::uint16_t>& which : {std::vector<std::uint16_t>{3, 1}, {1, 1}, {1, 4}}) {
        MeshParts parts;
        const int indices = parts.view(packed(which)), values = parts.view(packed(std::vector<float>(6, 1.0f)));
        const int positions =
            parts.accessor(parts.view(packed(tetrahedron_corners)), 5126, 4, "VEC3",
                           R"(,"sparse":{"count":2,"indices":{"bufferView":)" + std::to_string(indices) +
                               R"(,"componentType":5123},"values":{"bufferView":)" + std::to_string(values) + "}}");
        parts.mesh(positions, parts.indices(tetrahedron_triangles));
        parts.nodes = node("", mesh_of_node_1) + R"(,{"mesh":0})";
        EXPECT_THROW(load_text(parts.text()), Error);
    }
}

TEST(SceneDamage, NumbersThatAreNone) {
    for (const float bad : {std::nanf(""), INFINITY, -INFINITY}) {
        MeshParts parts;
        std::vector<float> corners = tetrahedron_corners;
        corners[4] = bad;
        const int positions = parts.positions(corners);
        parts.mesh(positions, parts.indices(tetrahedron_triangles));
        parts.nodes = R"({"mesh":0})"; // also if it is only a visual
        try {
            load_text(parts.text());
            FAIL() << "loaded";
        } catch (const Error& error) {
            EXPECT_STREQ(error.what(),
                         "test.gltf: accessors[0]: must hold finite numbers, and element 1 does not, got an object");
        }
    }
}

TEST(SceneDamage, DegenerateMeshesAreNamed) {
    for (const bool is_hull : {false, true}) {
        MeshParts parts;
        const int positions = parts.positions({0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0}); // collinear
        parts.mesh(positions, parts.indices(tetrahedron_triangles));
        parts.nodes = node("", is_hull ? hull_of_node_1 : mesh_of_node_1) + R"(,{"mesh":0})";
        try {
            load_text(parts.text());
            FAIL() << "loaded";
        } catch (const Error& error) {
            const std::string place = "test.gltf: nodes[0].extensions.KHR_physics_rigid_bodies.collider.geometry: " +
                                      std::string(is_hull ? "Hull points: " : "Mesh ");
            EXPECT_EQ(std::string(error.what()).substr(0, place.size()), place);
        }
    }
}

TEST(SceneDamage, SmallFilesCannotAskForEndlessMemory) {
    MeshParts parts; // 1,000 nodes use one mesh of zeros, each with its own scale
    parts.accessors = R"({"componentType":5126,"count":1000000,"type":"VEC3"})";
    parts.accessor_count = 1;
    parts.mesh(0, -1, R"(,"mode":6)");
    parts.nodes = R"({"mesh":0})";
    for (int i = 1; i <= 1000; ++i) {
        const std::string number = std::to_string(i);
        parts.nodes.append(R"(,{"mesh":0,"scale":[1,1,)").append(number).append("]}");
        parts.roots.append(",").append(number);
    }
    try {
        load_text(parts.text());
        FAIL() << "loaded";
    } catch (const Error& error) {
        EXPECT_NE(
            std::string(error.what()).find("must not raise the number of vertices of all meshes in use above 67108864"),
            std::string::npos)
            << error.what();
    }
}

TEST(SceneDamage, OddTexts) {
    const std::string whole = document({});
    EXPECT_TRUE(survives(std::string("\xEF\xBB\xBF").append(whole))); // a byte order mark
    EXPECT_FALSE(survives(std::string("\xFE\xFF").append(whole)));
    EXPECT_FALSE(survives(whole + std::string(1, '\0')));
    EXPECT_FALSE(survives(whole + std::string("\0 ", 2)));
    EXPECT_FALSE(survives(std::string(100, '\0')));
    EXPECT_FALSE(survives("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"name\":\"\xC3\x28\"}]}"));
    EXPECT_FALSE(survives(std::string(10'000'000, '7')));
    EXPECT_FALSE(survives(R"({"asset":{"version":"2.0"},"scene":)" + std::string(10'000'000, '7') + "}"));
    EXPECT_TRUE(survives(R"({"asset":{"version":"2.0"},"extras":")" + std::string(10'000'000, 'x') + "\"}"));
}

// In a locale with a decimal comma, files are read and written as in any other.
TEST(SceneDamage, LocalesDoNotMatter) {
    const char* found = nullptr;
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE"}) {
        if (found == nullptr) found = std::setlocale(LC_ALL, name);
    }
    if (found == nullptr) GTEST_SKIP() << "no locale with a decimal comma is installed";
    Parts parts;
    parts.nodes = node(R"("translation":[0.5,1.25,0],)", box);
    const Scene scene = load_text(document(parts));
    const std::string text = scene::save_to_string(scene);
    std::setlocale(LC_ALL, "C");
    EXPECT_EQ(scene.world.body(scene.world.bodies().at(0)).position(), Position(0.5, 1.25, 0));
    EXPECT_EQ(scene::save_to_string(load_text(text)), text);
}

} // namespace
