// The benchmark program as a user runs it.
#include "scene/scene.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>

#include <sys/wait.h>

namespace {

struct Outcome {
    int exit_code = -1;
    std::string output;
};

Outcome run_bench(const std::string& arguments) {
    Outcome outcome;
    std::FILE* pipe = popen((std::string(CAIRN_TEST_BENCH) + " " + arguments).c_str(), "r");
    if (!pipe) return outcome;
    char buffer[4096];
    for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) outcome.output.append(buffer, n);
    const int status = pclose(pipe);
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
}

TEST(BenchProgram, reports_every_engine_on_every_scene) {
    const Outcome outcome = run_bench("--scenes tower,pile_mixed --n 30 --steps 40 --rounds 2 --json 2>/dev/null");
    ASSERT_EQ(outcome.exit_code, 0);
    const auto results = nlohmann::json::parse(outcome.output).at("results");
    bool has_cairn_tower = false;
    for (const auto& result : results) {
        EXPECT_EQ(result.at("bodies"), 30);
        EXPECT_EQ(result.at("rounds"), 2);
        EXPECT_GT(result.at("mean_ms"), 0);
        EXPECT_LE(result.at("median_ms"), result.at("p99_ms"));
        EXPECT_GT(result.at("points"), 0);
        EXPECT_EQ(result.at("lost"), 0);
        EXPECT_EQ(result.at("drift").is_null(), result.at("scene") == "pile_mixed");
        if (result.at("engine") != "cairn" || result.at("scene") != "tower") continue;
        has_cairn_tower = true;
        EXPECT_TRUE(result.at("repeatable"));
        EXPECT_LT(result.at("drift"), 0.01);
        EXPECT_LT(result.at("penetration_max"), 0.02);
        EXPECT_GT(result.at("stages_ms").at("solve"), 0);
    }
    EXPECT_TRUE(has_cairn_tower);
}

TEST(BenchProgram, reports_how_far_the_anchors_of_joints_come_apart) {
    const Outcome outcome =
        run_bench("--scenes joint_swing,ragdolls,tower --n 5 --steps 60 --rounds 1 --threads 1 --json 2>/dev/null");
    ASSERT_EQ(outcome.exit_code, 0);
    const auto results = nlohmann::json::parse(outcome.output).at("results");
    for (const auto& result : results) {
        EXPECT_EQ(result.at("lost"), 0);
        if (result.at("scene") == "tower") {
            EXPECT_TRUE(result.at("joint_error_peak").is_null());
            continue;
        }
        EXPECT_GT(result.at("joint_error_peak"), 0);
        EXPECT_GE(result.at("joint_error_peak"), result.at("joint_error_max"));
        EXPECT_GE(result.at("joint_error_max"), result.at("joint_error_mean"));
        EXPECT_LT(result.at("joint_error_peak"), result.at("engine") == "cairn" ? 0.01 : 0.5);
    }
}

TEST(BenchProgram, saves_what_joints_hold_with_all_its_bodies) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "cairn_bench_saved_joints";
    std::filesystem::remove_all(folder);
    ASSERT_EQ(run_bench("--scenes joint_grid,ragdolls --n 3 --save " + folder.string()).exit_code, 0);
    cairn::scene::Scene net = cairn::scene::load(folder / "joint_grid.gltf");
    EXPECT_EQ(net.world.bodies().size(), 9u);
    // The bodies do not collide even when they overlap.
    net.world.body(net.world.bodies().back()).set_position(net.world.body(net.world.bodies()[4]).position());
    net.world.step(net.info.time_step);
    EXPECT_TRUE(net.world.contacts().empty());
    EXPECT_EQ(cairn::scene::load(folder / "ragdolls.gltf").world.bodies().size(), 5u + 33);
    std::filesystem::remove_all(folder);
}

TEST(BenchProgram, refuses_what_it_does_not_know) {
    EXPECT_EQ(run_bench("--scenes nowhere 2>/dev/null").exit_code, 2);
    EXPECT_EQ(run_bench("--engines nobody 2>/dev/null").exit_code, 2);
    EXPECT_EQ(run_bench("--rounds 0 2>/dev/null").exit_code, 2);
    EXPECT_EQ(run_bench("--scenes tumbler --n 5000 2>/dev/null").exit_code, 2);
}

TEST(BenchProgram, lists_scenes_and_engines) {
    const Outcome outcome = run_bench("--list");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.output.find("many_pyramids"), std::string::npos);
    EXPECT_NE(outcome.output.find("cairn"), std::string::npos);
}

TEST(BenchProgram, saves_scenes_that_load_again_with_all_their_bodies) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "cairn_bench_saved";
    std::filesystem::remove_all(folder);
    const Outcome outcome =
        run_bench("--scenes pile_mixed,tumbler,convex,terrain,props,capsules --n 20 --save " + folder.string());
    ASSERT_EQ(outcome.exit_code, 0);
    for (const char* name : {"pile_mixed", "tumbler", "convex", "terrain", "props", "capsules"}) {
        const cairn::scene::Scene scene = cairn::scene::load(folder / (std::string(name) + ".gltf"));
        std::size_t dynamic = 0;
        for (const cairn::BodyId id : scene.world.bodies())
            dynamic += scene.world.body(id).type() == cairn::BodyType::dynamic;
        EXPECT_EQ(dynamic, 20u) << name;
        const bool in_room = name != std::string("tumbler") && name != std::string("terrain");
        // A floor and four walls, or a single piece.
        EXPECT_EQ(scene.world.bodies().size(), in_room ? 25u : 21u) << name;
        EXPECT_TRUE(scene.warnings.empty()) << name;
        EXPECT_EQ(scene.world.settings().gravity.y, -10.0f);
        EXPECT_FALSE(scene.info.title.empty());
        ASSERT_TRUE(scene.info.camera) << name;
        // All dynamic bodies are in the picture: within the angle of view around its center.
        const cairn::Position eye = scene.info.camera->position;
        const glm::dvec3 forward = glm::normalize(scene.info.camera->target - eye);
        const double half_angle = 0.5 * double(scene.info.camera->vertical_fov_degrees) * 3.14159265 / 180;
        for (const cairn::BodyId id : scene.world.bodies()) {
            const cairn::Body body = std::as_const(scene.world).body(id);
            if (body.type() == cairn::BodyType::static_) continue;
            EXPECT_GT(glm::dot(glm::normalize(body.position() - eye), forward), std::cos(half_angle)) << name;
        }
    }
    std::filesystem::remove_all(folder);
}

TEST(BenchProgram, says_in_one_line_that_a_folder_cannot_be_used) {
    const Outcome outcome = run_bench("--scenes tower --save /dev/null/scenes 2>&1");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.output.find("/dev/null/scenes"), std::string::npos);
    EXPECT_EQ(outcome.output.find('\n'), outcome.output.size() - 1);
}

} // namespace
