// Files that URDF robots refer to: how they are searched, and what is rejected.
#include "scene_text.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace cairn;
using scene::Scene;
namespace fs = std::filesystem;

// A robot of one link with these elements. Its mass is computed from its shapes, so that none of them may be omitted.
std::string robot(const std::string& elements) {
    return "<robot name=\"r\"><link name=\"a\">" + elements + "</link></robot>";
}

TEST(UrdfFiles, MeshesAreFoundInTheirPackage) {
    const fs::path package = fs::path(testing::TempDir()) / "cairn_urdf_test" / "my_robot";
    fs::remove_all(package.parent_path());
    fs::create_directories(package / "urdf");
    fs::create_directories(package / "meshes");
    std::ofstream(package / "package.xml") << "<package/>";
    std::ofstream(package / "meshes" / "part.obj") << tetrahedron_file;
    std::ofstream(package.parent_path() / "outside.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const auto load = [&](const std::string& filename) {
        const std::string mesh = "<geometry><mesh filename=\"" + filename + "\" scale=\"2 2 -2\"/></geometry>";
        std::ofstream(package / "urdf" / "robot.urdf")
            << robot("<collision>" + mesh + "</collision><visual>" + mesh + "</visual>");
        return scene::load(package / "urdf" / "robot.urdf");
    };
    for (const char* name : {"package://my_robot/meshes/part.obj", "../meshes/part.obj"}) {
        const Scene scene = load(name);
        const ShapeId shape = scene.world.body(scene.world.bodies().at(0)).shapes().at(0);
        EXPECT_NEAR(std::get<Hull>(scene.world.shape(shape)).volume(), 8.0 / 6.0, 1e-5);
        EXPECT_NEAR(scene.world.shape_bounds(shape).min.y, -2.0, 1e-5);
        EXPECT_EQ(scene.visuals.size(), 1u);
    }
    const auto expect_refused = [&](const char* name, ErrorCode code, const std::string& part) {
        try {
            load(name);
            FAIL() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), code) << error.what();
            EXPECT_EQ(std::string(error.what()).find("robot.urdf: link \"a\": collision 1: mesh filename: "), 0u)
                << error.what();
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    };
    expect_refused("../../outside.obj", ErrorCode::io, "or below it");
    expect_refused("package://my_robot/meshes/none.stl", ErrorCode::io, "there is no such file");
    std::ofstream(package / "meshes" / "part.dae") << "<COLLADA/>";
    expect_refused("../meshes/part.dae", ErrorCode::unsupported, "must be an .stl or .obj file");
    fs::remove_all(package.parent_path());
}

// Without the fix "package:///etc", and "package://NAME" with the name of any folder above the robot, made that folder
// the package.
TEST(UrdfFiles, NothingOutsideOfThePackageOrTheFolderIsReadWhateverTheNameSays) {
    const fs::path above = fs::canonical(testing::TempDir()) / "cairn_urdf_escape";
    const fs::path robots = above / "robots";
    fs::remove_all(above);
    fs::create_directories(robots / "meshes");
    std::ofstream(above / "secret.obj") << tetrahedron_file;
    std::ofstream(robots / "meshes" / "own.obj") << tetrahedron_file;
    fs::create_symlink(above / "secret.obj", robots / "link.obj");
    fs::create_directory_symlink(above, robots / "way_out");
    const auto load = [&](const std::string& filename) {
        std::ofstream(robots / "robot.urdf")
            << robot("<collision><geometry><mesh filename=\"" + filename + "\"/></geometry></collision>");
        const Scene scene = scene::load(robots / "robot.urdf");
        return scene.world.body(scene.world.bodies().at(0)).shapes().size();
    };
    const std::string absolute = (above / "secret.obj").string();
    for (const bool is_package : {false, true}) {
        if (is_package) std::ofstream(robots / "package.xml") << "<package/>";
        const std::vector<std::string> leading_out{"package://" + absolute,
                                                   "package:////" + absolute,
                                                   "package://../secret.obj",
                                                   "package://./../secret.obj",
                                                   "package://robots/../secret.obj",
                                                   "package://robots/" + absolute,

                                                   "file://" + absolute,
                                                   "../secret.obj",
                                                   "meshes/../../secret.obj",
                                                   "way_out/secret.obj",
                                                   "link.obj",
                                                   "package://robots/link.obj",
                                                   absolute};
        for (const std::string& name : leading_out) {
            SCOPED_TRACE(name);
            try {
                load(name);
                ADD_FAILURE() << "was read";
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), ErrorCode::io) << error.what();
            }
        }
        // The name of a parent folder does not give access to it.
        EXPECT_THROW(load("package://" + above.filename().string() + "/secret.obj"), Error);
        EXPECT_THROW(load("package://way_out/secret.obj"), Error);
        const std::vector<std::string> inside{"meshes/own.obj",
                                              "package://robots/meshes/own.obj",
                                              "package:///robots/meshes/own.obj",
                                              "package:////robots/meshes/own.obj",
                                              "package://meshes/own.obj",
                                              "./meshes/../meshes/own.obj",
                                              "file://" + (robots / "meshes" / "own.obj").string()};
        for (const std::string& name : inside) {
            // The name "meshes" would be that of another package.
            if (is_package && name == "package://meshes/own.obj") continue;
            EXPECT_EQ(load(name), 1u) << name;
        }
    }
    fs::remove_all(above);
}

class UrdfPackage : public testing::Test {
  protected:
    void SetUp() override {
        above_ = fs::canonical(testing::TempDir()) / ("cairn_urdf_" + std::to_string(::getpid()));
        fs::remove_all(above_);
        fs::create_directories(above_ / "own" / "meshes");
        std::ofstream(above_ / "own" / "package.xml") << "<package/>";
        std::ofstream(above_ / "own" / "meshes" / "part.obj") << tetrahedron_file;
        std::ofstream(above_ / "own" / "meshes" / "torn.stl") << "solid torn\nfacet\n";
        std::ofstream(above_ / "secret.obj") << tetrahedron_file;
    }
    void TearDown() override { fs::remove_all(above_); }
    static std::string mesh(const std::string& name) {
        return "<geometry><mesh filename=\"" + name + "\"/></geometry>";
    }
    Scene load(const std::string& elements) const {
        std::ofstream(above_ / "own" / "robot.urdf") << robot(elements);
        return scene::load(above_ / "own" / "robot.urdf");
    }
    fs::path above_;
    const std::string inertial_ =
        "<inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" "
        "izz=\"1\"/></inertial>";
};

// talos_full_v2 writes its packages like this. Without the fix the whole robot was rejected.
TEST_F(UrdfPackage, ThreeSlashesBeforeItsNameAreTakenAsTwoAndOneWarningSaysSo) {
    const std::string part = mesh("package:///own/meshes/part.obj");
    const Scene scene = load("<collision>" + part + "</collision><visual>" + part + "</visual>" + inertial_);
    EXPECT_EQ(scene.world.body(scene.world.bodies().at(0)).shapes().size(), 1u);
    EXPECT_EQ(scene.visuals.size(), 1u);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(
        scene.warnings[0].find("\"package:///own/meshes/part.obj\" has slashes in place of the name of its package; it "
                               "is read as \"package://own/meshes/part.obj\", and so are all other file names"),
        std::string::npos)
        << scene.warnings[0];
    EXPECT_THROW(load("<collision>" + mesh("package:///") + "</collision>"), Error);
}

// romeo_laas_small uses an absolute path of an installation. Without the fix the whole robot was rejected.
TEST_F(UrdfPackage, MeshesOutsideOfItAreLeftOutAndNotRead) {
    const std::string outside = mesh("file://" + (above_ / "secret.obj").string());
    const Scene scene = load("<collision>" + outside + "</collision><collision>" + mesh("meshes/part.obj") +
                             "</collision><visual>" + outside + "</visual>" + inertial_);
    EXPECT_EQ(scene.world.body(scene.world.bodies().at(0)).shapes().size(), 1u);
    EXPECT_TRUE(scene.visuals.empty());
    ASSERT_EQ(scene.warnings.size(), 2u);
    EXPECT_NE(scene.warnings[0].find("or below it, also where links lead"), std::string::npos) << scene.warnings[0];
    EXPECT_NE(scene.warnings[0].find("(the shape is left out)"), std::string::npos) << scene.warnings[0];
    EXPECT_NE(scene.warnings[1].find("(it is not shown)"), std::string::npos) << scene.warnings[1];
    EXPECT_THROW(load("<collision>" + outside + "</collision>"), Error); // the mass would be unknown
}

// Without the fix a damaged mesh of a visual made the robot invalid; that of a collider still does.
TEST_F(UrdfPackage, AVisualWithATornMeshIsNotShown) {
    const std::string torn = mesh("meshes/torn.stl");
    const Scene scene = load("<visual>" + torn + "</visual>" + inertial_);
    EXPECT_TRUE(scene.visuals.empty());
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("torn.stl"), std::string::npos) << scene.warnings[0];
    EXPECT_NE(scene.warnings[0].find("(it is not shown)"), std::string::npos) << scene.warnings[0];
    EXPECT_THROW(load("<collision>" + torn + "</collision>" + inertial_), Error);
}

} // namespace
