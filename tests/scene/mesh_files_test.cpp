// OBJ and STL files: every variant of the formats, and a one-line message for every error.
#include "mesh_text.h"

#include "scene/decimal.h"
#include "scene/mesh_files.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace {

using namespace cairn;
using namespace cairn::scene_test;

std::span<const std::byte> bytes_of(const std::string& text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}
scene::MeshFile obj(const std::string& text) { return scene::read_obj(bytes_of(text), "test.obj"); }
scene::MeshFile stl(const std::string& text) { return scene::read_stl(bytes_of(text), "test.stl"); }

template <class Call> void expect_refused(Call call, const std::string& message) {
    try {
        call();
        FAIL() << "read: " << message;
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), message);
        EXPECT_EQ(error.code(), ErrorCode::invalid_file);
    }
}

using Indices = std::vector<std::uint32_t>;
const std::string square_points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ObjFiles, CornersInAllForms) {
    EXPECT_EQ(obj(square_points + "f 1 2 3\n").indices, (Indices{0, 1, 2}));
    EXPECT_EQ(obj(square_points + "f 1/1 2/7 3/2\n").indices, (Indices{0, 1, 2}));
    EXPECT_EQ(obj(square_points + "f 1//1 2//2 3//3\n").indices, (Indices{0, 1, 2}));
    EXPECT_EQ(obj(square_points + "f 1/1/1 2/2/2 3/3/3\n").indices, (Indices{0, 1, 2}));
    EXPECT_EQ(obj(square_points + "f -4 -3/1 -1//2\n").indices, (Indices{0, 1, 3}));
}

TEST(ObjFiles, PolygonsAreFans) { EXPECT_EQ(obj(square_points + "f 1 2 3 4").indices, (Indices{0, 1, 2, 0, 2, 3})); }

TEST(ObjFiles, EverythingElseIsSkipped) {
    const scene::MeshFile mesh = obj("\xEF\xBB\xBF# a comment\r\nmtllib a.mtl\r\no thing\r\ng part\r\n"
                                     "v\t+1.5e0 -.25 1. 1.0\r\nv 1e-3 0 0 0.5 0.5 0.5\r\nvt 0 0\nvn 0 0 1\ns off\n\n"
                                     "v 0 1 0\r\nusemtl x\nl 1 2\nf 1 2 3\r\n");
    ASSERT_EQ(mesh.vertices.size(), 3u);
    EXPECT_EQ(mesh.vertices[0], Vec3(1.5f, -0.25f, 1.0f));
    EXPECT_EQ(mesh.vertices[1], Vec3(0.001f, 0, 0));
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2}));
}

TEST(ObjFiles, MistakesAreNamedWithTheirLine) {
    expect_refused([] { obj(""); }, "test.obj: must have at least one triangle");
    expect_refused([] { obj("v 1 2\n"); }, "test.obj:1: must have a number that fits a float, got \"\"");
    expect_refused([] { obj("v 0 0 0\nv 1 2,5 0\n"); },
                   "test.obj:2: must have a number that fits a float, got \"2,5\"");
    expect_refused([] { obj("v 1 nan 0\n"); }, "test.obj:1: must have a number that fits a float, got \"nan\"");
    expect_refused([] { obj("v 1e999 0 0\n"); }, "test.obj:1: must have a number that fits a float, got \"1e999\"");
    expect_refused([] { obj("v 1e39 0 0\n"); }, "test.obj:1: must have a number that fits a float, got \"1e39\"");
    expect_refused([] { obj(square_points + "f 1 2\n"); },
                   "test.obj:5: must have at least three corners in a face, got \"f\"");
    expect_refused([] { obj(square_points + "f 1 2 5\n"); },
                   "test.obj:5: must have the index of one of the 4 vertices so far, got \"5\"");
    expect_refused([] { obj(square_points + "f 0 1 2\n"); },
                   "test.obj:5: must have the index of one of the 4 vertices so far, got \"0\"");
    expect_refused([] { obj(square_points + "f -5 1 2\n"); },
                   "test.obj:5: must have the index of one of the 4 vertices so far, got \"-5\"");
    expect_refused([] { obj(square_points + "f 1 x 2\n"); }, "test.obj:5: must have the index of a vertex, got \"x\"");
    expect_refused([] { obj(square_points + "f 1 - 2\n"); }, "test.obj:5: must have the index of a vertex, got \"-\"");
    expect_refused([] { obj(square_points + "f 1 18446744073709551617 2\n"); },
                   "test.obj:5: must have the index of a vertex, got \"18446744073709551617\"");
    expect_refused([] { obj(std::string("v 0 0 \0\xff\n", 9)); },
                   "test.obj:1: must have a number that fits a float, got \"??\"");
}

std::string binary_stl(std::uint32_t count, const std::vector<float>& numbers) {
    std::string text = std::string("solid though it is binary").append(55, ' ');
    text += packed(std::vector<std::uint32_t>{count});
    for (std::size_t i = 0; i < numbers.size(); i += 12) {
        text += packed(std::vector<float>(numbers.begin() + long(i), numbers.begin() + long(i) + 12)) + "ab";
    }
    return text;
}

const std::string facet = "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  VERTEX 1 0 0\n  vertex 0 1 0\n endloop\n"
                          "endfacet\n";

TEST(StlFiles, BinaryAndAscii) {
    const scene::MeshFile binary = stl(binary_stl(1, {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}));
    const scene::MeshFile ascii = stl("solid name of it\n" + facet + "endsolid name of it\n");
    for (const scene::MeshFile& mesh : {binary, ascii}) {
        EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
        EXPECT_EQ(mesh.indices, (Indices{0, 1, 2}));
    }
}

TEST(StlFiles, MistakesAreNamed) {
    expect_refused([] { stl(""); }, "test.stl: is empty");
    expect_refused([] { stl("abc"); }, "test.stl: is neither an ASCII STL file nor a whole binary one");
    expect_refused([] { stl("solid\n"); }, "test.stl: must have at least one triangle");
    expect_refused([] { stl(binary_stl(0, {})); }, "test.stl: must have at least one triangle");
    const std::string cut = "x" + binary_stl(2, {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}).substr(1);
    expect_refused([&] { stl(cut); }, "test.stl: must have 84 bytes and 50 for each of its 2 triangles, got 134 bytes");
    const std::string huge = "x" + binary_stl(0xFFFFFFFFu, {}).substr(1);
    expect_refused([&] { stl(huge); },
                   "test.stl: must have 84 bytes and 50 for each of its 4294967295 triangles, got 84 bytes");
    expect_refused(
        [] {
            stl(binary_stl(1, {0, 0, 1, 0, 0, std::nanf(""), 1, 0, 0, 0, 1, 0}));
        },
        "test.stl: must have finite numbers, and triangle 0 does not");
    expect_refused([] { stl("solid\nvertex 0 0 0\n"); },
                   "test.stl:2: must have vertices only between \"outer loop\" and \"endloop\", got \"vertex\"");
    expect_refused([] { stl("solid\nouter loop\nvertex 0 0 0\nendloop\n"); },
                   "test.stl:4: must have three vertices in a loop, got \"endloop\"");
    expect_refused([] { stl("solid\nouter loop\nvertex 0 0 inf\n"); },
                   "test.stl:3: must have a number that fits a float, got \"inf\"");
    expect_refused([] { stl("solid\nouter loop\nouter loop\n"); },
                   "test.stl:3: must close a loop before it opens the next, got \"outer\"");
    expect_refused([] { stl("solid\nouter loop\n"); }, "test.stl:2: must close its last loop, got \"\"");
    expect_refused([] { stl("solid\nbanana\n"); }, "test.stl:2: must be a line of an STL file, got \"banana\"");
}

TEST(StlFiles, CutOffAtEveryByte) {
    const std::string binary = binary_stl(2, std::vector<float>(24, 1.0f)), ascii = "solid\n" + facet + facet;
    for (std::size_t length = 0; length < binary.size(); ++length) {
        EXPECT_THROW(stl(binary.substr(0, length)), Error) << length;
    }
    for (std::size_t length = 0; length < ascii.size(); ++length) {
        try {
            EXPECT_GE(stl(ascii.substr(0, length)).indices.size(), 3u) << length;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::invalid_file);
        }
    }
}

const std::string cube = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\nv 9 9 9\n"
                         "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";

TEST(MeshImport, AHullIsADynamicBody) {
    scene::MeshImport options;
    options.scale = 0.5;
    options.density = 500.0f;
    const scene::Scene scene = scene::scene_of_mesh(obj(cube), options, "cube");
    const Body body = scene.world.body(scene.world.bodies().at(0));
    EXPECT_EQ(body.type(), BodyType::dynamic);
    EXPECT_EQ(body.name(), "cube");
    EXPECT_NEAR(body.mass(), 500.0f, 1e-2f); // a vertex without a face does not count
    EXPECT_TRUE(std::holds_alternative<Hull>(scene.world.shape(body.shapes().at(0))));
}

TEST(MeshImport, AMeshIsAStaticBody) {
    scene::MeshImport options;
    options.as_hull = false;
    const scene::Scene scene = scene::scene_of_mesh(obj(cube + "f 1 1 2\n"), options, "cube");
    const Body body = scene.world.body(scene.world.bodies().at(0));
    EXPECT_EQ(body.type(), BodyType::static_);
    EXPECT_EQ(std::get<Mesh>(scene.world.shape(body.shapes().at(0))).indices().size(), 36u);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "cube: 1 triangles without area are left out");
}

TEST(MeshImport, FlatMeshesHaveNoHull) {
    EXPECT_THROW(scene::scene_of_mesh(obj(square_points + "f 1 2 3 4\n"), {}, "flat"), Error);
    scene::MeshImport options;
    options.scale = -1.0;
    EXPECT_THROW(scene::scene_of_mesh(obj(cube), options, "cube"), Error);
}

TEST(Decimals, AreReadAsTheNearestDouble) {
    EXPECT_EQ(scene::parse_decimal("0"), 0.0);
    EXPECT_EQ(scene::parse_decimal("-.5"), -0.5);
    EXPECT_EQ(scene::parse_decimal("+5."), 5.0);
    EXPECT_EQ(scene::parse_decimal("000123.4560E+2"), 12345.6);
    EXPECT_EQ(scene::parse_decimal("0e999"), 0.0);
    EXPECT_EQ(scene::parse_decimal("1e-400"), 0.0);
    for (const char* text :
         {"", ".", "-", "+-1", "1e", "1e+", "1.2.3", "0x10", "1,5", " 1", "1 ", "inf", "nan", "1e400"}) {
        EXPECT_FALSE(scene::parse_decimal(text).has_value()) << text;
    }
    std::mt19937 random(7);
    for (int i = 0; i < 20000; ++i) {
        char text[64];
        const double value = std::ldexp(double(random()) / 4294967296.0, int(random() % 200) - 100);
        std::snprintf(text, sizeof text, "%.*g", int(random() % 17) + 1, value);
        EXPECT_EQ(scene::parse_decimal(text), std::strtod(text, nullptr)) << text;
    }
}

} // namespace
