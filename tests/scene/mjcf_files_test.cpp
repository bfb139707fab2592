// MJCF models that refer to other files, and models that are rejected or loaded with a warning.
#include "scene_text.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;
namespace fs = std::filesystem;

class MjcfFiles : public testing::Test {
  protected:
    void SetUp() override {
        above_ = fs::canonical(testing::TempDir()) / ("cairn_mjcf_" + std::to_string(::getpid()));
        folder_ = above_ / "model";
        fs::remove_all(above_);
        fs::create_directories(folder_ / "parts");
    }
    void TearDown() override { fs::remove_all(above_); }
    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
    Scene load(const std::string& elements) const {
        write("model.xml", "<mujoco>" + elements + "</mujoco>");
        return scene::load(folder_ / "model.xml");
    }
    void expect_refused(const std::string& elements, ErrorCode code, const std::string& part) const {
        SCOPED_TRACE(elements);
        try {
            load(elements);
            ADD_FAILURE() << "was read";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), code) << error.what();
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
    }
    fs::path above_, folder_;
};

const std::string ball_body = "<body name=\"b\"><freejoint/><geom size=\".1\"/></body>";

TEST_F(MjcfFiles, IncludedElementsStandWhereTheIncludeStands) {
    write("parts/bodies.xml", "<mujocoinclude><body name=\"c\" pos=\"0 0 5\"><freejoint/><geom class=\"k\"/></body>"
                              "<include file=\"parts/more.xml\"/></mujocoinclude>");
    write("parts/more.xml", "<mujoco>" + ball_body + "</mujoco>");
    write("defaults.xml", "<mujoco><default><default class=\"k\"><geom size=\".3\"/></default></default></mujoco>");
    const Scene scene =
        load("<include file=\"defaults.xml\"/><worldbody><include file=\"parts/bodies.xml\"/></worldbody>");
    EXPECT_EQ(scene.world.bodies().size(), 2u);
    const BodyId c = scene.world.find_body("c").value();
    EXPECT_NEAR(scene.world.shape_bounds(scene.world.body(c).shapes().at(0)).max.y, 5.3, 1e-5);
}

TEST_F(MjcfFiles, NothingOutsideOfTheFolderIsRead) {
    std::ofstream(above_ / "secret.xml") << "<mujoco>" + ball_body + "</mujoco>";
    std::ofstream(above_ / "secret.obj") << tetrahedron_file;
    fs::create_symlink(above_ / "secret.xml", folder_ / "link.xml");
    fs::create_symlink(above_ / "secret.obj", folder_ / "link.obj");
    fs::create_directory_symlink(above_, folder_ / "way_out");
    const std::string absolute = above_.string();
    for (const std::string& name : {std::string("../secret"), absolute + "/secret", std::string("parts/../../secret"),
                                    std::string("way_out/secret"), std::string("link")}) {
        expect_refused("<worldbody><include file=\"" + name + ".xml\"/></worldbody>", ErrorCode::invalid_file,
                       "in the model's folder or below it");
        expect_refused("<asset><mesh name=\"m\" file=\"" + name +
                           ".obj\"/></asset><worldbody><body><freejoint/><geom type=\"mesh\" mesh=\"m\"/></body>"
                           "</worldbody>",
                       ErrorCode::io, "in the model's folder or below it");
    }
    expect_refused("<compiler meshdir=\"..\"/><asset><mesh name=\"m\" file=\"secret.obj\"/></asset><worldbody>"
                   "<body><freejoint/><geom type=\"mesh\" mesh=\"m\"/></body></worldbody>",
                   ErrorCode::io, "in the model's folder or below it");
    // A geom is omitted if its body has its mass without it, or if it is only a visual.
    const Scene scene = load("<asset><mesh name=\"m\" file=\"../secret.obj\"/></asset><worldbody>" + ball_body +
                             "<geom type=\"mesh\" mesh=\"m\"/></worldbody>");
    EXPECT_EQ(scene.world.bodies().size(), 1u);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("(the geom is left out)"), std::string::npos) << scene.warnings[0];
}

TEST_F(MjcfFiles, IncludesThatGoRoundAreRefused) {
    write("round.xml", "<mujoco><include file=\"round.xml\"/></mujoco>");
    expect_refused("<include file=\"round.xml\"/>", ErrorCode::invalid_file, "must not be included twice");
    expect_refused("<include file=\"none.xml\"/>", ErrorCode::io, "there is no such file");
    expect_refused("<include/>", ErrorCode::invalid_file, "must have the attribute file");
}

TEST_F(MjcfFiles, MissingMeshesAreLeftOutWhereTheBodyHasItsMass) {
    write("parts/part.obj", tetrahedron_file);
    const std::string mesh = "<compiler meshdir=\"parts\"/><asset><mesh file=\"part.obj\"/><mesh name=\"gone\" "
                             "file=\"gone.stl\"/></asset>";
    const std::string geoms =
        "<geom type=\"mesh\" mesh=\"part\"/><geom type=\"mesh\" mesh=\"gone\"/></body></worldbody>";
    const Scene scene = load(mesh +
                             "<worldbody><body name=\"b\"><freejoint/><inertial mass=\"1\" pos=\"0 0 0\" "
                             "diaginertia=\"1 1 1\"/>" +
                             geoms);
    EXPECT_EQ(scene.world.body(scene.world.find_body("b").value()).shapes().size(), 1u);
    ASSERT_FALSE(scene.warnings.empty());
    EXPECT_NE(scene.warnings[0].find("there is no such file, got \"parts/gone.stl\" (the geom is left out)"),
              std::string::npos)
        << scene.warnings[0];
    expect_refused(mesh + "<worldbody><body><freejoint/>" + geoms, ErrorCode::io, "there is no such file");
    // Visuals need no mass if the format says that they have none, nor do static bodies. Without the fix both were
    // rejected.
    const std::string look = "<geom type=\"mesh\" mesh=\"gone\" ";
    EXPECT_EQ(load(mesh + "<worldbody><body><freejoint/><geom size=\".1\"/>" + look + "mass=\"0\"/>" + look +
                   "density=\"0\"/></body>" + look + "/></worldbody>")
                  .warnings.size(),
              3u);
}

// Without the fix a damaged mesh file of a visual made the whole model invalid; that of a collider still does.
TEST_F(MjcfFiles, AGeomWithATornMeshIsLeftOutIfItIsOnlyLookedAt) {
    write("parts/torn.stl", "solid torn\nfacet\n");
    const auto model = [](const std::string& attributes) {
        return "<asset><mesh name=\"m\" file=\"parts/torn.stl\"/></asset><worldbody>" + ball_body +
               "<geom type=\"mesh\" mesh=\"m\"" + attributes + "/></worldbody>";
    };
    const Scene scene = load(model(" contype=\"0\" conaffinity=\"0\""));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("torn.stl"), std::string::npos) << scene.warnings[0];
    EXPECT_NE(scene.warnings[0].find("(the geom is left out)"), std::string::npos) << scene.warnings[0];
    expect_refused(model(""), ErrorCode::invalid_file, "torn.stl");
}

TEST_F(MjcfFiles, MistakesNameElementAttributeAndValue) {
    struct Case {
        const char* elements;
        const char* message;
    };
    for (const Case& c : {
             Case{"<worldbody><body>\n<geom size=\"-1\"/></body></worldbody>",
                  "model.xml:2: geom: size: must have sizes from 0.000001 to 1000000, got \"-1\""},
             Case{"<worldbody><geom type=\"bax\" size=\"1\"/></worldbody>",
                  "geom: type: must be one of sphere, plane, hfield, capsule, ellipsoid, cylinder, box, mesh, sdf, got "
                  "\"bax\""},
             Case{"<worldbody><geom name=\"g\" size=\"1\" pos=\"0 nan 1\"/></worldbody>",
                  "geom \"g\": pos: must have numbers only, which fit a float, got \"0 nan 1\""},
             Case{"<worldbody><geom size=\"1\" pos=\"0 1\"/></worldbody>", "pos: must have 3 numbers, got \"0 1\""},
             Case{"<worldbody><geom size=\"1\" class=\"none\"/></worldbody>",
                  "class: must be the class of a default element, got \"none\""},
             Case{"<worldbody><body><joint axis=\"0 0 0\"/><geom size=\"1\"/></body></worldbody>",
                  "joint: axis: must have a direction that is not zero, got \"0 0 0\""},
             Case{"<worldbody><body><joint range=\"2 1\"/><geom size=\"1\"/></body></worldbody>",
                  "joint: range: must be two bounds, the lower first, got \"2 1\""},
             Case{"<worldbody><body name=\"x\"><joint/></body></worldbody>",
                  "body \"x\": must have a mass, by an inertial or by geoms, as every body with joints"},
             Case{"<worldbody><body><body><freejoint/><geom size=\"1\"/></body><joint/><geom "
                  "size=\"1\"/></body></worldbody>",
                  "freejoint: must belong to a body directly in the world"},
             Case{"<worldbody/><actuator><motor joint=\"none\"/></actuator>",
                  "motor: joint: must be the name of a joint, got \"none\""},
             Case{"<worldbody/><equality><weld body1=\"none\"/></equality>",
                  "weld: body1: must be the name of a body, got \"none\""},
             Case{"<worldbody><geom type=\"mesh\" mesh=\"none\"/></worldbody>",
                  "geom: mesh: must be the name of an asset, got \"none\""},
             Case{"<compiler coordinate=\"global\"/>", "compiler: coordinate: must be local, got \"global\""},
             Case{"<option timestep=\"0\"/>", "option: timestep: must be from 0.0001 to 1, got \"0\""},
             Case{"<worldbody><body><freejoint/><geom size=\"1\"/></body></worldbody><keyframe><key qpos=\"1 "
                  "2\"/></keyframe>",
                  "key: qpos: must have 7 numbers, as the model has coordinates, got \"1 2\""},
             Case{"<worldbody><geom size=\"1\" size=\"2\"/></worldbody>",
                  "model.xml:1: is not valid XML: parsing attribute"},
             Case{"<worldbody><geom size=\"1\"></worldbody>", "is not valid XML"},
         }) {
        SCOPED_TRACE(c.elements);
        try {
            load(c.elements);
            ADD_FAILURE() << "was read";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(c.message), std::string::npos) << error.what();
            EXPECT_EQ(std::string(error.what()).find("model.xml"), 0u) << error.what();
        }
    }
}

TEST_F(MjcfFiles, WhatHasNoEffectIsNamed) {
    const Scene scene = load("<worldbody><light/>" + ball_body +
                             "<geom size=\".1\" pos=\"3 0 0\" solref=\".02 1\" sise=\"2\"/></worldbody><tendon/>");
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0],
              "model.xml: has no effect here: elements mujoco/tendon, worldbody/light; attributes geom "
              "sise, geom solref");
    EXPECT_TRUE(load("<worldbody>" + ball_body + "</worldbody>").warnings.empty());
}

} // namespace
