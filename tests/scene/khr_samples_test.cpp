// The samples and conformance files of the Khronos drafts. They are not part of this project: the environment variable
// CAIRN_KHR_SAMPLES names their folder.
#include "khr_samples.h"

#include "scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace {

using namespace cairn;
namespace fs = std::filesystem;

class KhrSamples : public KhrSampleTest {};

void run_sample(
    scene::Scene& scene, float seconds, const std::function<void()>& after_step = [] {}) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / dt)); ++i) {
        scene.world.step(dt);
        after_step();
    }
}

std::vector<BodyId> bodies_of(const scene::Scene& scene, BodyType type) {
    std::vector<BodyId> result;
    for (const BodyId id : scene.world.bodies()) {
        if (scene.world.body(id).type() == type) result.push_back(id);
    }
    return result;
}

double height(const scene::Scene& scene, BodyId id) { return scene.world.body(id).position().y; }

TEST_F(KhrSamples, AllLoadAndRunForASecond) {
    constexpr std::array<const char*, 8> names{"sph", "box", "pla", "cap", "cyl", "hull", "mesh", "hf"};
    std::printf("%-36s bodies ", "file");
    for (const char* name : names) std::printf("%5s", name);
    std::printf("  triggers systems joints visuals warnings\n");
    for (const fs::path& file : files_) {
        SCOPED_TRACE(file.filename().string());
        scene::Scene scene = scene::load(file);
        std::array<int, 8> shapes{};
        int triggers = 0;
        for (const BodyId id : scene.world.bodies()) {
            for (const ShapeId shape : scene.world.body(id).shapes()) {
                ++shapes[scene.world.shape(shape).index()];
                triggers += scene.world.shape_def(shape).is_trigger;
            }
        }
        std::printf("%-36s %6zu ", file.filename().c_str(), scene.world.bodies().size());
        for (const int count : shapes) std::printf("%5d", count);
        std::printf("  %8d %7zu %6zu %7zu %8zu\n", triggers, scene.collision_systems.size(),
                    scene.world.joints().size(), scene.visuals.size(), scene.warnings.size());
        for (const std::string& warning : scene.warnings) std::printf("    %s\n", warning.c_str());
        run_sample(scene, 1.0f);
        for (const BodyId id : scene.world.bodies()) {
            const Position p = scene.world.body(id).position();
            EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        }
    }
}

TEST_F(KhrSamples, ListsCountTheBodiesThatLoadingMakes) {
    for (const fs::path& file : files_) {
        for (const scene::SceneEntry& entry : scene::list_scenes(file.parent_path())) {
            if (entry.path != file) continue;
            EXPECT_EQ(entry.bodies, scene::load(file).world.bodies().size()) << file;
        }
    }
}

TEST_F(KhrSamples, AreTheSameAfterBeingSaved) {
    for (const fs::path& file : files_) {
        SCOPED_TRACE(file.filename().string());
        const scene::Scene scene = scene::load(file);
        const std::string first = scene::save_to_string(scene);
        const scene::Scene again =
            scene::load_from_memory(std::as_bytes(std::span(first.data(), first.size())), "saved");
        EXPECT_TRUE(scene::save_to_string(again) == first);
        EXPECT_EQ(again.world.bodies().size(), scene.world.bodies().size());
        EXPECT_EQ(again.visuals.size(), scene.visuals.size());
        EXPECT_EQ(again.world.joints().size(), scene.world.joints().size());
    }
}

// "The dynamic body stays above the XZ plane, supported by the static one."
TEST_F(KhrSamples, ColliderMatrix) {
    int files = 0;
    for (const fs::path& file : files_) {
        if (file.stem().string().find("ColliderTypeMatrix") == std::string::npos) continue;
        SCOPED_TRACE(file.filename().string());
        ++files;
        scene::Scene scene = scene::load(file);
        const std::vector<BodyId> moving = bodies_of(scene, BodyType::dynamic);
        ASSERT_EQ(moving.size(), 1u);
        // The height of the support: the top of the static shape, which is the XZ plane or half a meter or a meter off
        // it. The origins of the dynamic shapes are inside them; those of tetrahedra are in their bases.
        double top = -1e9;
        for (const RayHit& hit : scene.world.cast_ray_all({0, 50, 0}, {0, -1, 0}, 100)) {
            if (hit.body != moving[0]) top = std::max(top, hit.point.y);
        }
        ASSERT_GT(top, -1.1);
        double least = 1e9;
        const auto fastest_in = [&](float seconds) {
            float fastest = 0;
            run_sample(scene, seconds, [&] {
                least = std::min(least, height(scene, moving[0]));
                fastest = std::max(fastest, glm::length(scene.world.body(moving[0]).linear_velocity()));
            });
            return fastest;
        };
        fastest_in(4.0f); // it falls and comes to rest
        const float before = fastest_in(3.0f), after = fastest_in(3.0f);
        std::printf("%-36s top %7.4f, least height %7.4f, at the end %7.4f, fastest %.3f then %.3f\n",
                    file.filename().c_str(), top, least, height(scene, moving[0]), double(before), double(after));
        EXPECT_GT(least, top - 0.02); // a shape that slides a little on a ball of 10 m radius descends with the surface
        // On that ball a tetrahedron rocks without damping. All other shapes come to rest.
        const std::string name = file.stem().string();
        EXPECT_LT(after, name.ends_with("_05") || name.ends_with("_17") ? 0.2f : 0.01f);
        EXPECT_LT(after, 1.1f * before + 0.01f);
    }
    EXPECT_GT(files, 0);
}

TEST_F(KhrSamples, CollisionFilters) {
    for (const char* name : {"RigidBodies_CollisionFilter_00", "RigidBodies_CollisionFilter_02"}) {
        SCOPED_TRACE(name);
        scene::Scene scene = load(name);
        const std::vector<BodyId> moving = bodies_of(scene, BodyType::dynamic);
        ASSERT_EQ(moving.size(), 2u);
        run_sample(scene, 4.0f);
        std::printf("%s: heights %.3f and %.3f\n", name, height(scene, moving[0]), height(scene, moving[1]));
        if (std::string(name).back() == '0') { // the first collides with the ground, the second falls through it
            EXPECT_NEAR(height(scene, moving[0]), 1.0, 0.02);
            EXPECT_LT(height(scene, moving[1]), -10.0);
        } else { // one part of each collides: the first stands on its lower part, the other sinks to its upper part
            EXPECT_NEAR(height(scene, moving[0]), 1.5, 0.02);
            EXPECT_LT(height(scene, moving[1]), 0.5);
            EXPECT_GT(height(scene, moving[1]), -1.5);
        }
    }
}

TEST_F(KhrSamples, Restitution) {
    scene::Scene scene = load("RigidBodies_Materials_00");
    const std::vector<BodyId> moving = bodies_of(scene, BodyType::dynamic);
    std::array<double, 2> rebound{};
    run_sample(scene, 3.0f, [&] {
        if (scene.world.time() < 1.0) return; // both have hit the ground by then
        for (std::size_t i = 0; i < 2; ++i) rebound[i] = std::max(rebound[i], height(scene, moving[i]));
    });
    // They fall from 4 m above rest: the ground's combine rule "average" takes precedence, (0 + 0.5) / 2 and (1 + 0.5)
    // / 2, and the rebound height is proportional to the square.
    EXPECT_NEAR(rebound[0], 1.0 + 4.0 * 0.25 * 0.25, 0.1);
    EXPECT_NEAR(rebound[1], 1.0 + 4.0 * 0.75 * 0.75, 0.1);
}

TEST_F(KhrSamples, Friction) {
    scene::Scene scene = load("RigidBodies_Materials_02");
    const std::vector<BodyId> moving = bodies_of(scene, BodyType::dynamic);
    const Position slides = scene.world.body(moving[0]).position(), sticks = scene.world.body(moving[1]).position();
    run_sample(scene, 1.0f);
    // On a slope of 45 degrees a friction of 0.3 leaves the acceleration g sin 45 (1 - 0.3).
    EXPECT_NEAR(glm::length(scene.world.body(moving[0]).position() - slides), 0.5 * 9.81 * 0.7071 * 0.7, 0.2);
    EXPECT_LT(glm::length(scene.world.body(moving[1]).position() - sticks), 0.05);
}

TEST_F(KhrSamples, MotionProperties) {
    scene::Scene hovers = load("RigidBodies_MotionProperties_00");
    const BodyId still = hovers.world.bodies().at(0);
    const Position start = hovers.world.body(still).position();
    run_sample(hovers, 2.0f);
    EXPECT_EQ(hovers.world.body(still).position(), start);

    // The second file's velocity is in the frame of a parent that is rotated by 90 degrees: both bodies rotate about x.
    for (const char* name : {"RigidBodies_MotionProperties_02", "RigidBodies_MotionProperties_04"}) {
        SCOPED_TRACE(name);
        scene::Scene spins = load(name);
        const BodyId body = spins.world.bodies().at(0);
        run_sample(spins, 2.0f);
        const Vec3 w = spins.world.body(body).angular_velocity();
        EXPECT_NEAR(w.x, 1.0f, 1e-3f);
        EXPECT_NEAR(w.y, 0.0f, 1e-3f);
        EXPECT_NEAR(w.z, 0.0f, 1e-3f);
    }

    scene::Scene kinematic = load("RigidBodies_MotionProperties_05");
    const BodyId unmoved = bodies_of(kinematic, BodyType::kinematic).at(0);
    run_sample(kinematic, 2.0f);
    EXPECT_EQ(kinematic.world.body(unmoved).position(), Position(0.0, 0.5, 0.0));

    scene::Scene masses = load("RigidBodies_MotionProperties_06");
    const std::vector<BodyId> hit = masses.world.bodies();
    run_sample(masses, 1.0f);
    const float light = masses.world.body(hit.at(2)).linear_velocity().x;
    const float heavy = masses.world.body(hit.at(3)).linear_velocity().x;
    EXPECT_GT(heavy, 1.5f * light); // hit by a body of 100 times its mass, and by one of its own
    EXPECT_GT(light, 0.0f);

    scene::Scene rigid = load("RigidBodies_MotionProperties_07");
    const BodyId upright = bodies_of(rigid, BodyType::dynamic).at(0);
    run_sample(rigid, 2.0f);
    EXPECT_EQ(rigid.world.body(upright).rotation(), Quat(1.0f, 0.0f, 0.0f, 0.0f));
    EXPECT_NEAR(height(rigid, upright), 1.0, 0.02);
}

// Compounds whose parts collide with different systems, and triggers, which let every body through.
TEST_F(KhrSamples, FilteringAndTriggersSamples) {
    scene::Scene triggers = load("Triggers");
    std::size_t events = 0;
    run_sample(triggers, 3.0f, [&] { events += triggers.world.trigger_events().size(); });
    EXPECT_GT(events, 0u);

    scene::Scene filtering = load("Filtering");
    run_sample(filtering, 5.0f);
    for (const BodyId id : bodies_of(filtering, BodyType::dynamic)) {
        EXPECT_GT(height(filtering, id), -5.0) << filtering.world.body(id).name();
    }
}

} // namespace
