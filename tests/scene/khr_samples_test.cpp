// The samples and conformance files of the Khronos drafts. They are not part of this project: the environment
// variable CAIRN_KHR_SAMPLES names the folder that holds them.
#include "scene/scene.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace cairn;
namespace fs = std::filesystem;

fs::path samples_folder() {
    const char* chosen = std::getenv("CAIRN_KHR_SAMPLES");
    return chosen != nullptr ? fs::path(chosen) : fs::path();
}

std::vector<fs::path> sample_files() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(samples_folder())) {
        if (entry.path().extension() == ".gltf") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

// Whether the file needs nothing but spheres, boxes and planes, found without the loader.
bool is_within_reach(const fs::path& path) {
    std::ifstream stream(path);
    const nlohmann::json json = nlohmann::json::parse(stream);
    const auto extensions = json.value("extensions", nlohmann::json::object());
    for (const auto& shape : extensions.value("/KHR_implicit_shapes/shapes"_json_pointer, nlohmann::json::array())) {
        const std::string type = shape["type"];
        if (type != "sphere" && type != "box" && type != "plane") return false;
    }
    for (const auto& node : json["nodes"]) {
        const auto own = node.value("extensions", nlohmann::json::object());
        const auto physics = own.value("KHR_physics_rigid_bodies", nlohmann::json::object());
        if (physics.contains("trigger") || physics.contains("joint")) return false;
        if (physics.contains("/collider/geometry/node"_json_pointer)) return false;
    }
    const auto filters =
        extensions.value("/KHR_physics_rigid_bodies/collisionFilters"_json_pointer, nlohmann::json::array());
    const bool separates = filters.size() > 1 || (filters.size() == 1 && filters[0].contains("notCollideWithSystems"));
    return !separates;
}

TEST(KhrSamples, LoadOrAreRefusedAsUnsupported) {
    if (!fs::is_directory(samples_folder())) {
        GTEST_SKIP() << "set CAIRN_KHR_SAMPLES to a folder with the drafts' samples";
    }
    const std::vector<fs::path> files = sample_files();
    ASSERT_FALSE(files.empty());
    int loaded = 0, refused = 0;
    for (const fs::path& file : files) {
        SCOPED_TRACE(file.filename().string());
        try {
            scene::Scene scene = scene::load(file);
            for (int i = 0; i < 60; ++i) scene.world.step(scene.info.time_step);
            for (const BodyId id : scene.world.bodies()) {
                const Position p = scene.world.body(id).position();
                EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
            }
            ++loaded;
            std::printf("%-44s %3zu bodies\n", file.filename().c_str(), scene.world.bodies().size());
        } catch (const Error& error) {
            ++refused;
            std::printf("%-44s refused: %s\n", file.filename().c_str(), error.what());
            EXPECT_EQ(error.code(), ErrorCode::unsupported) << error.what();
            EXPECT_FALSE(is_within_reach(file)) << error.what();
        }
    }
    std::printf("%d loaded, %d refused\n", loaded, refused);
    EXPECT_GT(loaded, 0);
}

} // namespace
