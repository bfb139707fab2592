// Materials and textures of models in URDF, SDF and USD, and of the .obj files they refer to.
#include "scene_text.h"

#include "scene/mesh_store.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;
namespace fs = std::filesystem;

const std::string png = "\x89PNG\r\n\x1A\n and so on", other_png = "\x89PNG\r\n\x1A\n something else";
// A square of two triangles, each with its own material.
const std::string two_materials = "mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                  "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 2\nvn 1 0 0\n"
                                  "usemtl red\nf 1/1/1 2/2/1 3/3/1\nusemtl wood\nf 1/1/1 3/3/1 4/4/1\n";
const std::string paint = "# materials\nnewmtl red\nKd 1 0.25 0\nNs 10\nnewmtl wood\nKd 1 1 1\n"
                          "map_Kd -s 1 1 1 ..\\textures\\wood.png\n";

class ModelLooks : public testing::Test {
  protected:
    void SetUp() override {
        above_ = fs::canonical(testing::TempDir()) / ("cairn_model_looks_" + std::to_string(::getpid()));
        folder_ = above_ / "model";
        fs::remove_all(above_);
        fs::create_directories(folder_ / "meshes");
        fs::create_directories(folder_ / "textures");
        write("meshes/part.obj", two_materials);
        write("meshes/paint.mtl", paint);
        write("textures/wood.png", png);
        write("textures/other.png", other_png);
        write("../outside.png", png);
    }
    void TearDown() override { fs::remove_all(above_); }
    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
    Scene load(const std::string& name, const std::string& text) const {
        write(name, text);
        return scene::load(folder_ / name);
    }
    // `material`: XML inside the visual. The collision shape is a different one.
    Scene urdf(const std::string& material, const std::string& mesh = "meshes/part.obj") const {
        return load("robot.urdf", "<robot name=\"r\"><link name=\"a\"><collision><geometry><sphere radius=\"1\"/>"
                                  "</geometry></collision><visual><geometry><mesh filename=\"" +
                                      mesh + "\"/></geometry>" + material + "</visual></link></robot>");
    }
    Scene sdf(const std::string& material) const {
        return load("model.sdf",
                    "<sdf version=\"1.9\"><model name=\"m\"><link name=\"a\"><visual name=\"v\"><geometry><mesh><uri>"
                    "meshes/part.obj</uri></mesh></geometry>" +
                        material + "</visual></link></model></sdf>");
    }
    Scene usd(const std::string& shaders, const std::string& mesh) const {
        return load("world.usda", "#usda 1.0\n(\n metersPerUnit = 1\n)\ndef Mesh \"m\" " + mesh +
                                      "\ndef Material \"paint\" {\n token outputs:surface.connect = "
                                      "</paint/surface.outputs:surface>\n" +
                                      shaders + "}\n");
    }
    fs::path above_, folder_;
};

void expect_two_materials(const Scene& scene) {
    ASSERT_EQ(scene.visuals.size(), 2u);
    const scene::VisualMesh &red = scene.visuals[0], &wood = scene.visuals[1];
    EXPECT_EQ(red.color, Vec3(1.0f, 0.25f, 0.0f));
    EXPECT_FALSE(red.texture);
    EXPECT_EQ(wood.color, Vec3(1.0f));
    ASSERT_TRUE(wood.texture);
    EXPECT_EQ(*wood.texture->file, png);
    EXPECT_EQ(red.surface->indices.size(), 3u);
    ASSERT_EQ(wood.surface->vertices.size(), 3u);
    ASSERT_EQ(wood.surface->normals.size(), 3u);
    EXPECT_EQ(wood.surface->normals[0], Vec3(0, 0, 1)) << "the mesh's own, as long as 1";
    EXPECT_EQ(wood.surface->coordinates[2], glm::vec2(0, 0)) << "v counts downward";
}

TEST_F(ModelLooks, OfObjFilesAreThoseOfTheirMaterials) {
    for (const Scene& scene : {urdf(""), sdf("")}) {
        expect_two_materials(scene);
        EXPECT_TRUE(std::none_of(scene.warnings.begin(), scene.warnings.end(),
                                 [](const std::string& line) { return line.find("left out") != std::string::npos; }));
    }
    const std::string saved = scene::save_to_string(urdf(""));
    EXPECT_EQ(scene::save_to_string(load_text(saved)), saved);
}

TEST_F(ModelLooks, OfTheModelStandForThoseOfTheMesh) {
    const std::string of_urdf = R"(<material name="w"><texture filename="package://model/textures/other.png"/>)";
    const std::string of_sdf = R"(<pbr><metal><albedo_map>textures/other.png</albedo_map></metal></pbr>)";
    write("package.xml", "<package/>");
    for (const Scene& scene : {urdf(of_urdf + "</material>"), sdf("<material>" + of_sdf + "</material>")}) {
        ASSERT_EQ(scene.visuals.size(), 2u);
        for (const scene::VisualMesh& visual : scene.visuals) {
            EXPECT_EQ(visual.color, Vec3(1.0f)) << "white unless it says another color";
            ASSERT_TRUE(visual.texture);
            EXPECT_EQ(*visual.texture->file, other_png);
        }
    }
    for (const Scene& scene : {urdf(of_urdf + "<color rgba=\".5 .25 1 1\"/></material>"),
                               sdf("<material><diffuse>.5 .25 1 1</diffuse>" + of_sdf + "</material>")}) {
        EXPECT_EQ(scene.visuals.at(0).color, Vec3(0.5f, 0.25f, 1.0f));
        EXPECT_TRUE(scene.visuals.at(0).texture);
    }
    const Scene plain = urdf("<material name=\"w\"><color rgba=\".5 .25 1 1\"/></material>");
    for (const scene::VisualMesh& visual : plain.visuals) {
        EXPECT_EQ(visual.color, Vec3(0.5f, 0.25f, 1.0f));
        EXPECT_FALSE(visual.texture);
    }
}

TEST_F(ModelLooks, ThatCannotBeReadAreALineOfWarning) {
    struct Case {
        const char *materials, *what;
    };
    for (const Case& wrong :
         {Case{"newmtl wood\nmap_Kd none.png", "paint.mtl:2: map_Kd: there is no such file, got \"none.png\""},
          Case{"newmtl wood\nmap_Kd ../../outside.png", "must name a file in the model's folder or below it"},
          Case{"newmtl wood\nmap_Kd part.obj", "must be a picture, PNG or JPEG"},
          Case{"newmtl wood\nKd red", "paint.mtl:2: Kd: must be three numbers >= 0, got \"red\""}}) {
        write("meshes/paint.mtl", wrong.materials);
        for (const Scene& scene : {urdf(""), sdf("")}) {
            EXPECT_EQ(scene.visuals.size(), 2u) << wrong.materials;
            EXPECT_EQ(std::count_if(scene.warnings.begin(), scene.warnings.end(),
                                    [&](const std::string& line) { return line.find(wrong.what) != line.npos; }),
                      1)
                << wrong.what;
        }
    }
    fs::remove(folder_ / "meshes/paint.mtl");
    const Scene scene = urdf("");
    EXPECT_EQ(scene.visuals.size(), 1u);
    EXPECT_EQ(std::count(scene.warnings.begin(), scene.warnings.end(),
                         "part.obj: mtllib: there is no such file, got \"paint.mtl\" (its materials are left out)"),
              1);
    for (const char* name : {"../outside.png", "textures/none.png", "meshes/part.obj"}) {
        const Scene robot = urdf("<material name=\"w\"><texture filename=\"" + std::string(name) +
                                 "\"/><color rgba=\"1 0 0 1\"/></material>");
        EXPECT_EQ(robot.visuals.at(0).color, Vec3(1, 0, 0));
        EXPECT_FALSE(robot.visuals.at(0).texture);
        EXPECT_NE(robot.warnings.back().find("material \"w\": texture filename: "), std::string::npos)
            << robot.warnings.back();
        const Scene model =
            sdf("<material><pbr><metal><albedo_map>" + std::string(name) + "</albedo_map></metal></pbr></material>");
        EXPECT_FALSE(model.visuals.at(0).texture);
        EXPECT_TRUE(std::any_of(model.warnings.begin(), model.warnings.end(), [](const std::string& line) {
            return line.find("albedo_map: ") != line.npos && line.find("(the texture is left out)") != line.npos;
        })) << name;
    }
}

TEST_F(ModelLooks, OfAnObjFileAloneAreThoseOfItsMaterials) {
    const fs::path file = folder_ / "meshes/part.obj";
    write("meshes/paint.mtl", "newmtl red\nKd 1 0.25 0\nnewmtl wood\nKd 1 1 1\nmap_Kd wood.png\n");
    write("meshes/wood.png", png);
    scene::MeshImport import;
    import.as_hull = false;
    import.scale = 2.0;
    Scene scene = scene::scene_of_mesh(scene::load_mesh_file(file), import, "part");
    scene::add_mesh_looks(file, import.scale, scene);
    expect_two_materials(scene);
    EXPECT_EQ(scene.visuals.at(0).surface->vertices[1], Vec3(2, 0, 0));
    EXPECT_EQ(scene.visuals.at(0).body, scene.world.bodies().at(0));
    write("meshes/plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    Scene plain = scene::scene_of_mesh(scene::load_mesh_file(folder_ / "meshes/plain.obj"), import, "plain");
    scene::add_mesh_looks(folder_ / "meshes/plain.obj", import.scale, plain);
    EXPECT_TRUE(plain.visuals.empty()) << "it is shown as what touches";
}

// A mesh that is only a collider causes no warnings about its materials.
TEST_F(ModelLooks, AreNotLookedForWhereNothingIsSeen) {
    fs::remove(folder_ / "meshes/paint.mtl");
    const Scene scene =
        load("model.sdf", "<sdf version=\"1.9\"><model name=\"m\"><static>1</static><link name=\"a\"><collision "
                          "name=\"c\"><geometry><mesh><uri>meshes/part.obj</uri></mesh></geometry></collision></link>"
                          "</model></sdf>");
    EXPECT_EQ(scene.world.bodies().size(), 1u);
    for (const std::string& line : scene.warnings) EXPECT_EQ(line.find("mtllib"), line.npos) << line;
}

// Invalid texture coordinates or normals in an .obj file never keep it from being used as a collider.
TEST_F(ModelLooks, OfObjFilesThatMakeNoSenseChangeNoTriangles) {
    const std::string start = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (const char* rest : {"vt\nvn x y\nf 1/1/1 2/1/1 3/1/1\n", "vt 1 2\nf 1/7/9 2/-5/ 3/x\n", "f 1/1 2/2 3/3\n",
                             "vt nan inf\nvt 0.5\nf 1/1 2/2 3\n"}) {
        const std::string text = start + rest;
        const scene::MeshFile mesh = scene::read_obj(std::as_bytes(std::span(text)), "a.obj");
        EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2})) << rest;
        const scene::Surface look = scene::visual_surface(mesh, glm::dvec3(1.0));
        EXPECT_EQ(look.vertices.size(), 3u) << rest;
        EXPECT_TRUE(look.coordinates.empty() || look.coordinates.size() == 3) << rest;
        for (const glm::vec2& at : look.coordinates) EXPECT_TRUE(std::isfinite(at.x) && std::isfinite(at.y)) << rest;
    }
}

const std::string square_prim = R"((prepend apiSchemas = ["MaterialBindingAPI"]) {
    point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0, 0)]
    int[] faceVertexCounts = [4]
    int[] faceVertexIndices = [0, 1, 2, 3]
    rel material:binding = </paint>
)";

TEST_F(ModelLooks, OfUsdAreThoseOfPreviewSurfaces) {
    const Scene plain = usd(R"(def Shader "surface" { uniform token info:id = "UsdPreviewSurface"
        color3f inputs:diffuseColor = (1, 0.5, 0.25)
        float inputs:roughness = 0.125
        float inputs:metallic = 1
        color3f inputs:emissiveColor = (0, 0, 0.5)
        token outputs:surface })",
                            square_prim + "}");
    ASSERT_EQ(plain.visuals.size(), 1u);
    EXPECT_EQ(plain.visuals[0].color, Vec3(1.0f, 0.5f, 0.25f));
    ASSERT_TRUE(plain.visuals[0].finish);
    EXPECT_EQ(plain.visuals[0].finish->roughness, 0.125f);
    EXPECT_EQ(plain.visuals[0].finish->metalness, 1.0f);
    EXPECT_EQ(plain.visuals[0].finish->glow, Vec3(0, 0, 0.5f));

    const auto covered = [&](const std::string& file, const std::string& places) {
        return usd(R"(def Shader "surface" { uniform token info:id = "UsdPreviewSurface"
            color3f inputs:diffuseColor.connect = </paint/picture.outputs:rgb>
            token outputs:surface }
            def Shader "picture" { uniform token info:id = "UsdUVTexture"
            asset inputs:file = @)" +
                       file +
                       R"(@
            token inputs:wrapS = "mirror"
            float3 outputs:rgb })",
                   square_prim + places + "}");
    };
    // One per vertex of the face, one per point of the mesh, and by indices.
    for (const char* places : {"texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 0.75)]",
                               "texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 0.75), (9, 9)]",
                               "texCoord2f[] primvars:st = [(0, 0.75), (1, 1), (1, 0), (0, 0)]\n"
                               "int[] primvars:st:indices = [3, 2, 1, 0]"}) {
        const Scene scene = covered("./textures/wood.png", places);
        ASSERT_EQ(scene.visuals.size(), 1u);
        const scene::VisualMesh& visual = scene.visuals[0];
        ASSERT_TRUE(visual.texture) << places;
        EXPECT_EQ(*visual.texture->file, png);
        EXPECT_EQ(visual.texture->wrap_u, scene::Texture::Wrap::mirror);
        EXPECT_EQ(visual.texture->wrap_v, scene::Texture::Wrap::repeat);
        EXPECT_EQ(visual.color, Vec3(1.0f));
        ASSERT_EQ(visual.surface->coordinates.size(), visual.surface->vertices.size());
        for (std::size_t i = 0; i < visual.surface->vertices.size(); ++i) {
            const Vec3& v = visual.surface->vertices[i];
            const float up = v.x == 0.0f && v.y == 1.0f ? 0.75f : v.y;
            EXPECT_EQ(visual.surface->coordinates[i], glm::vec2(v.x, 1.0f - up)) << places;
        }
    }
    for (const auto& [file, places, what] :
         {std::tuple("none.png", "texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)]",
                     "there is no such file"),
          std::tuple("../outside.png", "", "must name a file in the model's folder or below it"),
          std::tuple("textures/wood.png", "", "has no primvars:st"),
          std::tuple("textures/wood.png", "texCoord2f[] primvars:st = [(0, 0)]", "primvars:st"),
          std::tuple("textures/wood.png",
                     "texCoord2f[] primvars:st = [(0, 0)]\nint[] primvars:st:indices = [0, 1, 0, 0]",
                     "primvars:st:indices")}) {
        const Scene scene = covered(file, places);
        ASSERT_EQ(scene.visuals.size(), 1u);
        EXPECT_FALSE(scene.visuals[0].texture) << what;
        EXPECT_TRUE(std::any_of(scene.warnings.begin(), scene.warnings.end(), [&, w = what](const std::string& line) {
            return line.find(w) != line.npos && line.find("left out)") != line.npos;
        })) << what;
    }
}

// A USD body with a collider is shown with its texture, and collides as before.
TEST_F(ModelLooks, OfUsdBodiesAreShownInPlaceOfTheirShapes) {
    std::string body = square_prim;
    body.replace(body.find("\"MaterialBindingAPI\""), 20, "\"PhysicsCollisionAPI\"");
    const Scene scene = usd(R"(def Shader "surface" { uniform token info:id = "UsdPreviewSurface"
        color3f inputs:diffuseColor.connect = </paint/picture.outputs:rgb>
        token outputs:surface }
        def Shader "picture" { uniform token info:id = "UsdUVTexture"
        asset inputs:file = @textures/wood.png@ })",
                            body + "texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] }");
    ASSERT_EQ(scene.visuals.size(), 1u);
    EXPECT_FALSE(scene.visuals[0].body.is_null());
    EXPECT_TRUE(scene.visuals[0].texture);
    const Body made = scene.world.body(scene.world.bodies().at(0));
    EXPECT_EQ(std::get<Mesh>(scene.world.shape(made.shapes().at(0))).indices().size(), 6u);
}

} // namespace
