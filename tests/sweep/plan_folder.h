// Plans and scenes in a temporary folder of the test.
#pragma once

#include "sweep/plan.h"
#include "sweep/runner.h"

#include "scene/scene.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace cairn::test {

namespace fs = std::filesystem;

// The values of one row, by the names of its columns.
using Row = std::map<std::string, double>;

class PlanFolder : public testing::Test {
  protected:
    void SetUp() override {
        const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) / (std::string("cairn_sweep_") + test->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return folder_ / name;
    }

    // A ball above a floor; optionally also a crate on it, and a door on a hinge.
    void write_scene(float restitution = 0.0f, double height = 2.0, bool has_more = true) const {
        scene::Scene scene;
        World& world = scene.world;
        Material material;
        material.restitution = restitution;
        material.friction_combine = CombineRule::minimum;
        material.torsional_friction = 0.0f;
        ShapeDef def;
        def.material = material;
        const BodyId floor = world.create_body({.type = BodyType::static_, .name = "floor"});
        world.add_shape(floor, Plane{}, def);
        const BodyId ball = world.create_body({.position = {0.0, height, 0.0}, .name = "ball"});
        world.add_shape(ball, Sphere{0.1f}, def);
        if (has_more) add_crate_and_door(world, def);
        scene.info.time_step = 1.0f / 240.0f;
        scene::save(scene, folder_ / "scene.gltf");
    }

    static void add_crate_and_door(World& world, const ShapeDef& def) {
        const BodyId crate = world.create_body({.position = {5.0, 0.5, 0.0}, .name = "wide crate"});
        world.add_shape(crate, Box{}, def);
        HingeJoint hinge;
        hinge.angle.limits = JointRange{-1.0f, 1.0f, {}};
        const BodyId door = world.create_body({.position = {-5.0, 3.0, 0.0}, .name = "door"});
        world.add_shape(door, Box{{0.5f, 1.0f, 0.05f}}, def);
        JointDef joint = world.joint_at(BodyId{}, door, {-5.5, 3.0, 0.0}, {0.0f, 1.0f, 0.0f}, hinge);
        joint.name = "hinge";
        world.create_joint(joint);
    }

    sweep::Plan plan(const std::string& members, sweep::Purpose purpose = sweep::Purpose::sweep) const {
        return sweep::read_plan(write("plan.json", "{\"scene\": \"scene.gltf\", " + members + "}"), purpose);
    }

    static std::vector<Row> rows_of(const sweep::Plan& plan) {
        const sweep::Start start = sweep::load_start(plan);
        sweep::Runner runner(plan, start);
        const std::vector<std::string> names = plan.columns();
        std::vector<Row> rows;
        const std::atomic<bool> never{false};
        for (std::uint64_t i = 0; i < plan.design.rows(); ++i) {
            std::vector<double> numbers(plan.numbers());
            EXPECT_TRUE(runner.run(i, numbers, never));
            EXPECT_EQ(runner.failure(), "");
            Row& row = rows.emplace_back();
            for (std::size_t k = 0; k < numbers.size(); ++k) row[names[k + 1]] = numbers[k];
        }
        return rows;
    }

    fs::path folder_;
};

} // namespace cairn::test
