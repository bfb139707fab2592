// Meshes, hulls and height fields: from accessors and buffers to shapes.
#include "mesh_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;
namespace fs = std::filesystem;

const Shape& only_shape(const Scene& scene) {
    EXPECT_EQ(scene.world.bodies().size(), 1u);
    const std::vector<ShapeId> shapes = scene.world.body(scene.world.bodies().at(0)).shapes();
    EXPECT_EQ(shapes.size(), 1u);
    return scene.world.shape(shapes.at(0));
}

// Vertices in an order that does not depend on how a shape stores them.
std::multiset<std::array<float, 3>> corners(std::span<const Vec3> vertices) {
    std::multiset<std::array<float, 3>> result;
    for (const Vec3& v : vertices) result.insert({v.x, v.y, v.z});
    return result;
}
using Corners = std::multiset<std::array<float, 3>>;
const Corners tetrahedron_set{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};

// The signed volume enclosed by the triangles: positive if they face outward.
double volume(const Mesh& mesh) {
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.indices().size(); i += 3) {
        const glm::dvec3 a(mesh.vertices()[mesh.indices()[i]]), b(mesh.vertices()[mesh.indices()[i + 1]]),
            c(mesh.vertices()[mesh.indices()[i + 2]]);
        sum += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return sum;
}

TEST(SceneMeshes, HullOfAMesh) {
    const Scene scene = load_text(tetrahedron(R"("motion":{},)" + hull_of_node_1).text());
    const Hull& hull = std::get<Hull>(only_shape(scene));
    EXPECT_EQ(corners(hull.vertices()), tetrahedron_set);
    EXPECT_NEAR(hull.volume(), 1.0, 1e-6);
    EXPECT_NEAR(scene.world.body(scene.world.bodies()[0]).mass(), 1000.0f, 1e-2f);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(SceneMeshes, MeshOfAMesh) {
    const Scene scene = load_text(tetrahedron(mesh_of_node_1).text());
    const Mesh& mesh = std::get<Mesh>(only_shape(scene));
    EXPECT_EQ(corners(mesh.vertices()), tetrahedron_set);
    EXPECT_EQ(mesh.indices().size(), 12u);
    EXPECT_NEAR(volume(mesh), 1.0, 1e-6);
}

TEST(SceneMeshes, DynamicMeshIsItsHullAndAWarning) {
    const Scene scene = load_text(tetrahedron(R"("motion":{},)" + mesh_of_node_1).text());
    EXPECT_TRUE(std::holds_alternative<Hull>(only_shape(scene)));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "test.gltf: nodes[0].extensions.KHR_physics_rigid_bodies.collider.geometry: a mesh on "
                                 "a dynamic body is taken as its convex hull");
}

TEST(SceneMeshes, KinematicMeshStaysAMesh) {
    const Scene scene = load_text(tetrahedron(R"("motion":{"isKinematic":true},)" + mesh_of_node_1).text());
    EXPECT_TRUE(std::holds_alternative<Mesh>(only_shape(scene)));
}

TEST(SceneMeshes, ScaleOfTheColliderIsBakedInAndMirrorsKeepTheOutsideOutside) {
    const Scene scene = load_text(tetrahedron(mesh_of_node_1, R"("scale":[-2,1,1],)").text());
    const Mesh& mesh = std::get<Mesh>(only_shape(scene));
    EXPECT_EQ(corners(mesh.vertices()), (Corners{{0, 0, 0}, {-2, 0, 0}, {0, 2, 0}, {0, 0, 3}}));
    EXPECT_NEAR(volume(mesh), 2.0, 1e-6);
}

TEST(SceneMeshes, TransformOfTheMeshNodeItselfCountsOnlyBelowIt) {
    MeshParts parts = tetrahedron(hull_of_node_1);
    // The mesh is on a child of node 1, which is translated, rotated by 90 degrees about z, and scaled.
    parts.nodes = node("", hull_of_node_1) + R"(,{"translation":[9,9,9],"children":[2]},)" +
                  R"({"mesh":0,"translation":[10,0,0],"rotation":[0,0,0.70710678118,0.70710678118],"scale":[2,1,1]})";
    const Hull hull = std::get<Hull>(only_shape(load_text(parts.text())));
    const glm::dvec3 expected[] = {{10, 0, 0}, {10, 2, 0}, {8, 0, 0}, {10, 0, 3}};
    for (const glm::dvec3& corner : expected) {
        double nearest = 1e9;
        for (const Vec3& v : hull.vertices()) nearest = std::min(nearest, glm::length(glm::dvec3(v) - corner));
        EXPECT_LT(nearest, 1e-5);
    }
}

TEST(SceneMeshes, NodesBelowWithAMotionAreBodiesOfTheirOwn) {
    MeshParts parts = tetrahedron("");
    parts.nodes =
        node(R"("mesh":0,"children":[1],)", R"("motion":{},"collider":{"geometry":{"node":0,"convexHull":true}})") +
        "," + node(R"("mesh":0,"translation":[50,0,0],)", R"("motion":{"mass":1})");
    const Scene scene = load_text(parts.text());
    ASSERT_EQ(scene.world.bodies().size(), 2u);
    const ShapeId shape = scene.world.body(scene.world.bodies()[0]).shapes().at(0);
    EXPECT_EQ(std::get<Hull>(scene.world.shape(shape)).vertices().size(), 4u);
}

TEST(SceneMeshes, EqualGeometryIsShared) {
    MeshParts parts = tetrahedron("");
    parts.nodes = node("", hull_of_node_1) + R"(,{"mesh":0},)" + node(R"("translation":[5,0,0],)", hull_of_node_1) +
                  "," + node(R"("translation":[9,0,0],"scale":[2,2,2],)", hull_of_node_1);
    parts.roots = "0,2,3";
    const Scene scene = load_text(parts.text());
    std::vector<const HullData*> data;
    for (const BodyId body : scene.world.bodies()) {
        data.push_back(std::get<Hull>(scene.world.shape(scene.world.body(body).shapes().at(0))).data().get());
    }
    ASSERT_EQ(data.size(), 3u);
    EXPECT_EQ(data[0], data[1]);
    EXPECT_NE(data[0], data[2]);
}

// Two triangles of a square, in every representation that the format has.
MeshParts square_parts(const std::string& members, int type, const std::string& indices, std::size_t count) {
    MeshParts parts;
    const int positions = parts.positions({0, 0, 0, 1, 0, 0, 1, 0, -1, 0, 0, -1});
    parts.mesh(positions, count == 0 ? -1 : parts.accessor(parts.view(indices), type, count, "SCALAR"), members);
    parts.nodes = node("", mesh_of_node_1) + R"(,{"mesh":0})";
    return parts;
}

void expect_square_facing_up(const MeshParts& parts) {
    const Mesh mesh = std::get<Mesh>(only_shape(load_text(parts.text())));
    ASSERT_EQ(mesh.indices().size(), 6u);
    double area = 0.0;
    for (std::size_t i = 0; i < 6; i += 3) {
        const glm::dvec3 a(mesh.vertices()[mesh.indices()[i]]), b(mesh.vertices()[mesh.indices()[i + 1]]),
            c(mesh.vertices()[mesh.indices()[i + 2]]);
        area += glm::cross(b - a, c - a).y / 2.0;
    }
    EXPECT_NEAR(area, 1.0, 1e-6);
}

TEST(SceneMeshes, TrianglesWithIndicesOfAllSizes) {
    expect_square_facing_up(square_parts("", 5121, packed(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3}), 6));
    expect_square_facing_up(square_parts("", 5123, packed(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}), 6));
    expect_square_facing_up(square_parts("", 5125, packed(std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}), 6));
}

TEST(SceneMeshes, StripsAndFans) {
    expect_square_facing_up(square_parts(R"(,"mode":5)", 5121, packed(std::vector<std::uint8_t>{0, 1, 3, 2}), 4));
    expect_square_facing_up(square_parts(R"(,"mode":6)", 5121, packed(std::vector<std::uint8_t>{0, 1, 2, 3}), 4));
    expect_square_facing_up(square_parts(R"(,"mode":6)", 0, "", 0)); // without indices
}

TEST(SceneMeshes, InterleavedVertices) {
    MeshParts parts;
    std::vector<float> values;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, -1), Vec3(0, 0, -1)}) {
        values.insert(values.end(), {99, p.x, p.y, p.z, 99});
    }
    const int view = parts.view(packed(values), R"(,"byteStride":20)");
    const int positions = parts.accessor(view, 5126, 4, "VEC3", R"(,"byteOffset":4)");
    parts.mesh(positions, parts.indices({0, 1, 2, 0, 2, 3}));
    parts.nodes = node("", mesh_of_node_1) + R"(,{"mesh":0})";
    expect_square_facing_up(parts);
}

TEST(SceneMeshes, SparseAccessorsReplaceElements) {
    MeshParts parts;
    const int view = parts.view(packed(std::vector<float>{0, 0, 0, 7, 7, 7, 1, 0, -1, 7, 7, 7}));
    const int which = parts.view(packed(std::vector<std::uint16_t>{1, 3}));
    const int with = parts.view(packed(std::vector<float>{1, 0, 0, 0, 0, -1}));
    const int positions =
        parts.accessor(view, 5126, 4, "VEC3",
                       R"(,"sparse":{"count":2,"indices":{"bufferView":)" + std::to_string(which) +
                           R"(,"componentType":5123},"values":{"bufferView":)" + std::to_string(with) + "}}");
    parts.mesh(positions, parts.indices({0, 1, 2, 0, 2, 3}));
    parts.nodes = node("", mesh_of_node_1) + R"(,{"mesh":0})";
    expect_square_facing_up(parts);
}

TEST(SceneMeshes, QuantizedPositions) {
    MeshParts parts;
    const std::vector<std::int8_t> values{0, 0, 0, 0, 127, 0, 0, 0, 127, 0, -127, 0, 0, 0, -127, 0};
    const int view = parts.view(packed(values), R"(,"byteStride":4)");
    const int positions = parts.accessor(view, 5120, 4, "VEC3", R"(,"normalized":true)");
    parts.mesh(positions, parts.indices({0, 1, 2, 0, 2, 3}));
    parts.nodes = node("", mesh_of_node_1) + R"(,{"mesh":0})";
    expect_square_facing_up(parts);
}

TEST(SceneMeshes, SeveralPrimitivesAreOneSurface) {
    MeshParts parts;
    const int positions = parts.positions({0, 0, 0, 1, 0, 0, 1, 0, -1, 0, 0, -1});
    const int first = parts.indices({0, 1, 2}), second = parts.indices({0, 2, 3});
    parts.mesh(positions, first);
    const std::string primitive = R"({"attributes":{"POSITION":0},"indices":)";
    parts.meshes = R"({"primitives":[)" + primitive + std::to_string(first) + "}," + primitive +
                   std::to_string(second) + R"(},{"attributes":{"POSITION":0},"mode":0},{"attributes":{}}]})";
    parts.nodes = node("", mesh_of_node_1) + R"(,{"mesh":0})";
    expect_square_facing_up(parts);
    const Scene scene = load_text(parts.text());
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("primitives[2]: has points or lines"), std::string::npos);
}

TEST(SceneMeshes, VerticesThatNoTriangleUsesAreNoPartOfAHull) {
    MeshParts parts;
    std::vector<float> corners = tetrahedron_corners;
    corners.insert(corners.end(), {100, 100, 100});
    const int positions = parts.positions(corners);
    parts.mesh(positions, parts.indices(tetrahedron_triangles));
    parts.nodes = node("", hull_of_node_1) + R"(,{"mesh":0})";
    EXPECT_EQ(std::get<Hull>(only_shape(load_text(parts.text()))).vertices().size(), 4u);
}

TEST(SceneMeshes, BinaryChunkOfAContainer) {
    const Scene scene = load_text(tetrahedron(hull_of_node_1).container(), "test.glb");
    EXPECT_EQ(corners(std::get<Hull>(only_shape(scene)).vertices()), tetrahedron_set);
}

TEST(SceneMeshes, HeightFields) {
    const Scene scene = load_text(height_field().text());
    const HeightField& field = std::get<HeightField>(only_shape(scene));
    EXPECT_EQ(field.columns(), 3);
    EXPECT_EQ(field.rows(), 2);
    EXPECT_EQ(field.spacing(), glm::vec2(1, 2));
    EXPECT_EQ(std::vector<float>(field.heights().begin(), field.heights().end()),
              (std::vector<float>{0, 1, 2, 3, 4, 5}));
}

TEST(SceneMeshes, HeightFieldsAreScaled) {
    MeshParts parts = height_field();
    parts.nodes = node(R"("scale":[2,-3,4],)", R"("collider":{"geometry":{"shape":0}})");
    const HeightField field = std::get<HeightField>(only_shape(load_text(parts.text())));
    EXPECT_EQ(field.spacing(), glm::vec2(2, 8));
    EXPECT_EQ(field.heights()[5], 15.0f);
}

// Holes are kept by saving; an index outside the grid is rejected, and so is a field that consists of holes.
TEST(SceneMeshes, HeightFieldsHaveHoles) {
    const auto with_holes = [](const std::string& places) {
        MeshParts parts = height_field();
        const std::size_t end = parts.shapes.find(R"("heights")");
        parts.shapes.insert(end, "\"holes\":" + places + ",");
        parts.nodes = node(R"("scale":[2,-3,4],)", R"("collider":{"geometry":{"shape":0}})");
        return load_text(parts.text());
    };
    const Scene scene = with_holes("[2,1,2]");
    const std::vector<float> heights{0, HeightField::hole, HeightField::hole, 9, 12, 15};
    const auto heights_of = [](const Scene& read) {
        const HeightField field = std::get<HeightField>(only_shape(read));
        return std::vector<float>(field.heights().begin(), field.heights().end());
    };
    EXPECT_EQ(heights_of(scene), heights);
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_EQ(heights_of(load_text(scene::save_to_string(scene))), heights);
    for (const char* wrong : {"[6]", "[-1]", "[0.5]", "2", "[0,1,2,3,4,5]", "[[1]]"})
        EXPECT_THROW(with_holes(wrong), Error) << wrong;
}

// A mesh of two primitives: one has materials per triangle, the other a single material.
TEST(SceneMeshes, TrianglesHaveMaterials) {
    const auto with_materials = [](const std::string& first, const std::string& second) {
        MeshParts parts;
        const int positions = parts.positions(tetrahedron_corners);
        const int indices = parts.indices(tetrahedron_triangles);
        const int numbers =
            parts.accessor(parts.view(packed(std::vector<std::uint16_t>{2, 0, 1, 2})), 5123, 4, "SCALAR");
        const auto primitive = [&](const std::string& own) {
            return R"({"attributes":{"POSITION":)" + std::to_string(positions) + R"(},"indices":)" +
                   std::to_string(indices) + (own.empty() ? own : R"(,"extensions":{"CAIRN_mesh":{)" + own + "}}") +
                   "}";
        };
        parts.meshes = R"({"primitives":[)" + primitive(first.empty() ? first : first + std::to_string(numbers)) + "," +
                       primitive(second) + "]}";
        parts.nodes = node("", mesh_of_node_1) + R"(,{"mesh":0})";
        std::string text = parts.text();
        const std::string materials =
            R"("physicsMaterials":[{"restitution":0.25},{"restitution":0.5},{"restitution":0.75}],)";
        text.insert(text.find("\"collisionFilters\""), materials);
        return load_text(text);
    };
    // The restitution of each triangle, by its position, and how often it occurs.
    const auto materials_of = [](const Scene& scene) {
        const Mesh mesh = std::get<Mesh>(only_shape(scene));
        std::map<float, int> result;
        for (std::size_t i = 0; i < mesh.indices().size() / 3; ++i) {
            const SurfaceMaterials& own = mesh.materials();
            const int number = own.numbers.empty() ? 0 : own.numbers[i];
            ++result[number == 0 ? 0.0f : own.materials[std::size_t(number) - 1].restitution];
        }
        return result;
    };
    using Counts = std::map<float, int>;
    const std::string of_triangles = R"("materials":[2,0],"numbers":)";
    const Scene both = with_materials(of_triangles, R"("materials":[1])");
    EXPECT_EQ(materials_of(both), (Counts{{0.0f, 1}, {0.25f, 2}, {0.5f, 4}, {0.75f, 1}}));
    EXPECT_TRUE(both.warnings.empty());
    EXPECT_EQ(materials_of(with_materials(of_triangles, "")), (Counts{{0.0f, 5}, {0.25f, 2}, {0.75f, 1}}));
    EXPECT_EQ(materials_of(with_materials("", "")), (Counts{{0.0f, 8}}));
    const std::string saved = scene::save_to_string(both);
    EXPECT_EQ(materials_of(load_text(saved)), materials_of(both));
    EXPECT_EQ(scene::save_to_string(load_text(saved)), saved);
    EXPECT_EQ(with_materials(R"("material":[0],"materials":[2,0],"numbers":)", "").warnings.size(), 1u);
    for (const char* wrong : {R"("materials":[1],"numbers":)", R"("materials":[3,0],"numbers":)", R"("numbers":)"})
        EXPECT_THROW(with_materials(wrong, ""), Error) << wrong;
    // The same list on many bodies, each with another scale: 7 x 65,535 numbers each time, while a file may have 2^26.
    std::string many = "0";
    for (int i = 1; i < 65535; ++i) many += ",0";
    MeshParts parts;
    const int positions = parts.positions(tetrahedron_corners), indices = parts.indices(tetrahedron_triangles);
    parts.mesh(positions, indices, R"(,"extensions":{"CAIRN_mesh":{"materials":[)" + many + "]}}");
    parts.nodes = R"({"mesh":0})";
    parts.roots = "";
    for (int i = 1; i <= 200; ++i) {
        parts.nodes +=
            "," + node("\"scale\":[1,1," + std::to_string(i) + "],", R"("collider":{"geometry":{"node":0}})");
        parts.roots += (i == 1 ? "" : ",") + std::to_string(i);
    }
    std::string text = parts.text();
    text.insert(text.find("\"collisionFilters\""), R"("physicsMaterials":[{}],)");
    EXPECT_THROW(load_text(text), Error);
    for (const char* wrong : {R"("materials":1)", R"("materials":[0],"numbers":1)", R"("materials":[0],"numbers":99)"})
        EXPECT_THROW(with_materials("", wrong), Error) << wrong;
}

TEST(SceneMeshes, CellsOfHeightFieldsHaveMaterials) {
    const auto with_numbers = [](std::vector<std::uint8_t> list) {
        MeshParts parts = height_field();
        const auto count = list.size();
        const int numbers =
            parts.accessor(parts.view(std::string(list.begin(), list.end())), 5121, int(count), "SCALAR");
        const std::size_t end = parts.shapes.find(R"("heights")");
        parts.shapes.insert(end, R"("materials":[0],"numbers":)" + std::to_string(numbers) + ",");
        std::string text = parts.text();
        text.insert(text.find("\"collisionFilters\""), R"("physicsMaterials":[{"restitution":0.25}],)");
        return load_text(text);
    };
    const Scene scene = with_numbers({1, 0});
    const auto expect_materials = [](const Scene& read) {
        const SurfaceMaterials materials = std::get<HeightField>(only_shape(read)).materials();
        EXPECT_EQ(materials.numbers, (std::vector<std::uint16_t>{1, 0}));
        ASSERT_EQ(materials.materials.size(), 1u);
        EXPECT_EQ(materials.materials[0].restitution, 0.25f);
    };
    expect_materials(scene);
    expect_materials(load_text(scene::save_to_string(scene)));
    EXPECT_THROW(with_numbers({2, 0}), Error);
    EXPECT_THROW(with_numbers({1, 0, 0}), Error);
}

class SceneFolder : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) /
                  (std::string("cairn_files_") + testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "scenes" / "data");
        const MeshParts parts = tetrahedron(hull_of_node_1);
        write("scenes/data/mesh 1.bin", parts.buffer);
        write("outside.bin", parts.buffer);
    }
    void TearDown() override { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
    }
    // Loads the scene with its buffer in the file at that URI.
    Scene load(const std::string& uri) const {
        write("scenes/test.gltf", tetrahedron(hull_of_node_1).text("\"" + uri + "\""));
        return scene::load(folder_ / "scenes" / "test.gltf");
    }
    void expect_refused(const std::string& uri, const std::string& part) const {
        try {
            load(uri);
            FAIL() << uri;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    }

    fs::path folder_;
};

TEST_F(SceneFolder, BuffersInFilesBesideTheScene) {
    EXPECT_EQ(corners(std::get<Hull>(only_shape(load("data/mesh%201.bin"))).vertices()), tetrahedron_set);
    EXPECT_EQ(corners(std::get<Hull>(only_shape(load("./data/mesh 1.bin"))).vertices()), tetrahedron_set);
    fs::create_directory_symlink(folder_ / "scenes", folder_ / "link"); // the folder itself may be a symbolic link
    EXPECT_EQ(scene::load(folder_ / "link" / "test.gltf").world.bodies().size(), 1u);
}

TEST_F(SceneFolder, FilesOutsideOfItAreOutOfReach) {
    const std::string expected = "test.gltf: buffers[0].uri: must name a file in the folder of the scene or below it";
    for (const char* uri : {"../outside.bin", "data/../../outside.bin", "%2e%2e/outside.bin",
                            "data/%2E%2E/%2e./outside.bin", "/etc/hostname", "file:///etc/hostname",
                            "http://example.org/a.bin", "C:\\\\a.bin", "..\\\\outside.bin", "", "data/mesh%00.bin"}) {
        expect_refused(uri, expected);
    }
    fs::create_symlink(folder_ / "outside.bin", folder_ / "scenes" / "data" / "link.bin");
    expect_refused("data/link.bin", expected + ", also where links lead");
    fs::create_directory_symlink(folder_, folder_ / "scenes" / "up");
    expect_refused("up/outside.bin", expected + ", also where links lead");
    fs::create_symlink("/dev/zero", folder_ / "scenes" / "zero");
    expect_refused("zero", expected);
    expect_refused("data", "must name a file, not a folder or a device");
    expect_refused("missing.bin", "missing.bin: cannot be read: No such file");
    expect_refused("a%2", "must have two hexadecimal digits after each %");
    // A link to a file inside the folder is accepted.
    fs::create_symlink("data/mesh 1.bin", folder_ / "scenes" / "inside.bin");
    EXPECT_EQ(load("inside.bin").world.bodies().size(), 1u);
}

TEST_F(SceneFolder, ScenesFromMemoryHaveNoFiles) {
    expect_refused("data/none.bin", "cannot be read");
    EXPECT_THROW(load_text(tetrahedron(hull_of_node_1).text("\"a.bin\"")), Error);
}

} // namespace
