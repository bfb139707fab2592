// Textures and colors of MJCF models.
#include "scene_text.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;
namespace fs = std::filesystem;

const std::string checker = R"(<texture name="t" type="2d" builtin="checker" width="300" height="300" rgb1=".1 .2 .3"
    rgb2=".4 .5 .6" mark="edge" markrgb="1 1 1"/>)";

class MjcfLooks : public testing::Test {
  protected:
    void SetUp() override {
        above_ = fs::canonical(testing::TempDir()) / ("cairn_mjcf_looks_" + std::to_string(::getpid()));
        folder_ = above_ / "model";
        fs::remove_all(above_);
        fs::create_directories(folder_ / "pictures");
    }
    void TearDown() override { fs::remove_all(above_); }
    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
    Scene load(const std::string& assets, const std::string& geom, const std::string& more = "") const {
        write("model.xml",
              "<mujoco>" + more + "<asset>" + assets + "</asset><worldbody>" + geom + "</worldbody></mujoco>");
        return scene::load(folder_ / "model.xml");
    }
    fs::path above_, folder_;
};

// As in MuJoCo: the center of the image is at the origin, and the image is repeated texrepeat times over the geom, or
// over 2 m.
TEST_F(MjcfLooks, TexturesLieOnPlanesAndPrimitivesAsInMuJoCo) {
    struct Case {
        const char *material, *geom;
        glm::dvec2 repeats; // per meter
    };
    const Case cases[] = {
        {R"(texrepeat="3 5")", R"(<geom type="plane" size="4 2 1" material="m"/>)", {3 / 8.0, 5 / 4.0}},
        {R"(texrepeat="3 5" texuniform="true")", R"(<geom type="plane" size="4 2 1" material="m"/>)", {1.5, 2.5}},
        {R"(texrepeat="3 5")", R"(<geom type="plane" size="0 0 1" material="m"/>)", {1.5, 2.5}},
        {R"(texrepeat="2 4")", R"(<geom type="box" size=".5 .25 1" material="m"/>)", {2.0, 8.0}},
        {"", R"(<geom type="sphere" size=".5" material="m"/>)", {1.0, 1.0}},
    };
    for (const Case& given : cases) {
        const Scene scene = load(
            checker + "<material name=\"m\" texture=\"t\" rgba=\"1 .5 .25 1\" " + given.material + "/>", given.geom);
        ASSERT_EQ(scene.visuals.size(), 1u) << given.geom;
        const scene::VisualMesh& visual = scene.visuals[0];
        EXPECT_EQ(visual.color, Vec3(1.0f, 0.5f, 0.25f));
        ASSERT_TRUE(visual.texture) << given.geom;
        EXPECT_EQ(visual.texture->wrap_u, scene::Texture::Wrap::repeat);
        ASSERT_EQ(visual.surface->coordinates.size(), visual.surface->vertices.size());
        for (std::size_t i = 0; i < visual.surface->vertices.size(); ++i) {
            const glm::dvec3 seen = glm::dquat(visual.local.rotation) * glm::dvec3(visual.surface->vertices[i]);
            const glm::dvec2 expected(given.repeats.x * seen.x - 0.5, -given.repeats.y * seen.y - 0.5);
            EXPECT_LT(glm::length(glm::dvec2(visual.surface->coordinates[i]) - expected), 1e-4) << given.geom;
        }
    }
    const Scene plane =
        load(checker + R"(<material name="m" texture="t"/>)", R"(<geom type="plane" size="4 2 1" material="m"/>)");
    double most = 0.0;
    for (const Vec3& vertex : plane.visuals.at(0).surface->vertices) most = std::max(most, double(vertex.x));
    EXPECT_NEAR(most, 4.0, 1e-5) << "it is seen as large as the file says";
    EXPECT_EQ(plane.visuals.at(0).color, Vec3(1.0f)) << "a material is white unless it says another color";
}

// As in MuJoCo, the color of a geom counts unless it is the default one; otherwise the material's color counts.
TEST_F(MjcfLooks, ColorsAreThoseOfTheGeomOrOfTheMaterial) {
    const auto color = [&](const std::string& material, const std::string& geom) {
        return load("<material name=\"m\" " + material + "/>", "<geom size=\".5\" material=\"m\" " + geom + "/>")
            .appearances.at(0)
            .color;
    };
    EXPECT_EQ(color(R"(rgba="1 0 0 1")", ""), Vec3(1, 0, 0));
    EXPECT_EQ(color(R"(rgba="1 0 0 1")", R"(rgba="0 1 0 1")"), Vec3(0, 1, 0));
    EXPECT_EQ(color(R"(rgba="1 0 0 1")", R"(rgba=".5 .5 .5 1")"), Vec3(1, 0, 0));
    EXPECT_EQ(color("", ""), Vec3(1, 1, 1));
}

// Used by the robots of Gym: a cube texture around a geom in a single color, which multiplies the geom's color.
TEST_F(MjcfLooks, FlatCubesTintAndLayersHoldTextures) {
    const Scene tinted = load(R"(<texture name="t" builtin="flat" mark="cross" width="8" height="48" rgb1="1 .5 0"
        rgb2="1 .5 0" random=".01"/><material name="m" texture="t"/>)",
                              R"(<geom size=".5" material="m" rgba="1 1 .5 1"/>)");
    const Vec3 color = tinted.appearances.at(0).color;
    EXPECT_NEAR(color.x, 1.0f, 1e-5f);
    EXPECT_NEAR(color.y, 0.2122f, 1e-3f) << "127 of 255 in sRGB";
    EXPECT_EQ(color.z, 0.0f);
    for (const std::string& line : tinted.warnings) EXPECT_EQ(line.find("left out"), line.npos) << line;
    const Scene layered = load(checker + R"(<material name="m"><layer role="orm" texture="none"/>
        <layer role="rgb" texture="t"/></material>)",
                               R"(<geom size=".5" material="m"/>)");
    ASSERT_EQ(layered.visuals.size(), 1u);
    EXPECT_TRUE(layered.visuals[0].texture);
}

TEST_F(MjcfLooks, MeshesHaveThePlacesOfTheirFile) {
    write("quad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0.25 0.75\n"
                      "f 1/1 3/3 2/2\nf 1/1 2/2 4/3\nf 1/2 4/3 3/1\nf 2/1 3/2 4/3\n");
    write("pictures/a.png", "\x89PNG\r\n\x1A\nand so on");
    const Scene scene = load(R"(<mesh name="q" file="quad.obj" scale="2 2 2"/>
        <texture type="2d" name="t" file="a.png"/><material name="m" texture="t"/>)",
                             R"(<body><freejoint/><geom type="mesh" mesh="q" material="m"/></body>)",
                             R"(<compiler texturedir="pictures"/>)");
    ASSERT_EQ(scene.visuals.size(), 1u);
    const scene::VisualMesh& visual = scene.visuals[0];
    ASSERT_TRUE(visual.texture);
    EXPECT_EQ(*visual.texture->file, "\x89PNG\r\n\x1A\nand so on");
    const scene::Surface& surface = *visual.surface;
    ASSERT_EQ(surface.coordinates.size(), surface.vertices.size());
    EXPECT_GT(surface.vertices.size(), 4u) << "vertices are split where their places in the picture differ";
    EXPECT_EQ(surface.vertices[surface.indices[1]], Vec3(0, 2, 0));
    EXPECT_EQ(surface.coordinates[surface.indices[1]], glm::vec2(0.25f, 0.25f)) << "v counts downward";
    const Shape shape = scene.world.shape(scene.world.body(scene.world.bodies().at(0)).shapes().at(0));
    EXPECT_EQ(std::get<Hull>(shape).vertices().size(), 4u) << "what touches is as it was";
}

TEST_F(MjcfLooks, TexturesThatCannotBeReadAreALineOfWarning) {
    write("text.png", "no picture");
    write("../outside.png", "\x89PNG\r\n\x1A\n");
    struct Case {
        const char *texture, *what;
    };
    for (const Case& wrong : {Case{R"(type="2d" file="none.png")", "file: there is no such file, got \"none.png\""},
                              Case{R"(type="2d" file="text.png")", "must be a picture, PNG or JPEG"},
                              Case{R"(type="2d" file="../outside.png")", "must name a file in the model's folder"},
                              Case{R"(type="cube" builtin="checker")", "must be of type 2d to be shown"},
                              Case{R"(type="2d" builtin="stars")", "builtin"},
                              Case{R"(type="2d" builtin="checker")", "must have the attribute width"},
                              Case{R"(type="2d" builtin="checker" width="8" height="8" rgb1="1 2")", "rgb1"}}) {
        const Scene scene = load(std::string("<texture name=\"t\" ") + wrong.texture +
                                     "/><material name=\"m\" texture=\"t\" rgba=\"1 0 0 1\"/>",
                                 R"(<geom size=".5" material="m"/><geom size=".5" material="m"/>)");
        EXPECT_TRUE(scene.visuals.empty()) << wrong.texture;
        EXPECT_EQ(scene.appearances.at(0).color, Vec3(1, 0, 0));
        ASSERT_FALSE(scene.warnings.empty()) << wrong.texture;
        EXPECT_NE(scene.warnings[0].find(wrong.what), std::string::npos) << scene.warnings[0];
        EXPECT_NE(scene.warnings[0].find("(the texture is left out)"), std::string::npos) << scene.warnings[0];
        for (std::size_t i = 1; i < scene.warnings.size(); ++i)
            EXPECT_EQ(scene.warnings[i].find("left out"), std::string::npos) << "it is said once";
    }
}

TEST_F(MjcfLooks, AreTheSameAfterBeingSaved) {
    const Scene scene = load(checker + R"(<material name="m" texture="t" rgba="1 .5 .25 1"/>)",
                             R"(<geom type="plane" size="4 2 1" material="m"/>)");
    const std::string saved = scene::save_to_string(scene);
    const Scene again = load_text(saved);
    EXPECT_EQ(scene::save_to_string(again), saved);
    ASSERT_EQ(again.visuals.size(), 1u);
    EXPECT_EQ(*again.visuals[0].texture->file, *scene.visuals[0].texture->file);
}

} // namespace
