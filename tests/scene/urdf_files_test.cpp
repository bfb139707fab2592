// Files that robots of URDF name: where they are looked for, and what is refused.
#include "scene_text.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace cairn;
using scene::Scene;
namespace fs = std::filesystem;

// A robot of one link with these elements. It weighs what its shapes do, so that none may be missing.
std::string robot(const std::string& elements) {
    return "<robot name=\"r\"><link name=\"a\">" + elements + "</link></robot>";
}

TEST(UrdfFiles, MeshesAreFoundInTheirPackage) {
    const fs::path package = fs::path(testing::TempDir()) / "cairn_urdf_test" / "my_robot";
    fs::remove_all(package.parent_path());
    fs::create_directories(package / "urdf");
    fs::create_directories(package / "meshes");
    std::ofstream(package / "package.xml") << "<package/>";
    std::ofstream(package / "meshes" / "part.obj")
        << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
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
    expect_refused("../../outside.obj", ErrorCode::invalid_file, "or below it");
    expect_refused("package://my_robot/meshes/none.stl", ErrorCode::io, "there is no such file");
    std::ofstream(package / "meshes" / "part.dae") << "<COLLADA/>";
    expect_refused("../meshes/part.dae", ErrorCode::unsupported, "must be an .stl or .obj file");
    fs::remove_all(package.parent_path());
}

// "package:///etc" and "package://NAME" with the name of any folder above the robot made that folder its package.
TEST(UrdfFiles, NothingOutsideOfThePackageOrTheFolderIsReadWhateverTheNameSays) {
    const fs::path above = fs::canonical(testing::TempDir()) / "cairn_urdf_escape";
    const fs::path robots = above / "robots";
    fs::remove_all(above);
    fs::create_directories(robots / "meshes");
    const std::string secret = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    std::ofstream(above / "secret.obj") << secret;
    std::ofstream(robots / "meshes" / "own.obj") << secret;
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
                EXPECT_EQ(error.code(), ErrorCode::invalid_file) << error.what();
            }
        }
        // The name of a folder above is no key to it.
        EXPECT_THROW(load("package://" + above.filename().string() + "/secret.obj"), Error);
        EXPECT_THROW(load("package://way_out/secret.obj"), Error);
        const std::vector<std::string> inside{"meshes/own.obj", "package://robots/meshes/own.obj",
                                              "package://meshes/own.obj", "./meshes/../meshes/own.obj",
                                              "file://" + (robots / "meshes" / "own.obj").string()};
        for (const std::string& name : inside) {
            if (is_package && name == "package://meshes/own.obj") continue; // of the package, there is none
            EXPECT_EQ(load(name), 1u) << name;
        }
    }
    fs::remove_all(above);
}

} // namespace
