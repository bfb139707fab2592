#include "viewer/stage.h"

#include "test_scene.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace {

using namespace cairn;
using namespace cairn::viewer;

using test::frame;

std::size_t body_count(const Stage& stage) { return stage.state().layout->bodies.size(); }

// The position of body i of the layout; body 0 is the ground.
Position position_of(const Stage& stage, std::size_t i) { return stage.state().current->transforms[i].position; }

const Ray at_first_box{{0.0, 0.6, 10.0}, {0.0f, 0.0f, -1.0f}};
const Ray at_nothing{{0.0, 0.6, 10.0}, {0.0f, 1.0f, 0.0f}};

TEST(Stage, AddsAndRemovesBodies) {
    Stage stage(test::load_boxes, "1");
    EXPECT_EQ(body_count(stage), 2u);
    stage.apply(command::Spawn{box_preset(), {0.0, 5.0, 0.0}});
    stage.apply(command::Spawn{small_sphere_preset(), {3.0, 5.0, 0.0}});
    EXPECT_EQ(body_count(stage), 4u);
    EXPECT_EQ(stage.state().layout->shapes.back().type, ShapeType::sphere);
    stage.apply(command::RemoveLast{});
    EXPECT_EQ(body_count(stage), 3u);
    EXPECT_EQ(stage.state().layout->shapes.back().type, ShapeType::box);
    stage.apply(command::RemoveLast{});
    stage.apply(command::RemoveLast{}); // the scene's own box
    EXPECT_EQ(body_count(stage), 1u);
    EXPECT_EQ(stage.state().message.serial, 0u);
    stage.apply(command::RemoveLast{}); // the ground stays
    EXPECT_EQ(body_count(stage), 1u);
    EXPECT_EQ(stage.state().message.serial, 1u);
}

TEST(Stage, ThereIsNoLimitOnTheNumberOfBodies) {
    Stage stage(test::load_boxes, "0");
    for (int i = 0; i < 500; ++i)
        stage.apply(command::Spawn{small_sphere_preset(), {double(i % 20), 2.0, double(i / 20)}});
    EXPECT_EQ(body_count(stage), 501u);
    EXPECT_EQ(stage.state().message.text, "");
}

TEST(Stage, NewBodiesOverlapNothing) {
    Stage stage(test::load_boxes, "1");
    for (int i = 0; i < 10; ++i) stage.apply(command::Spawn{box_preset(), {0.0, 0.5, 0.0}});
    for (std::size_t i = 1; i < body_count(stage); ++i)
        for (std::size_t k = 1; k < i; ++k)
            EXPECT_GT(std::abs(position_of(stage, i).y - position_of(stage, k).y), 0.55) << i << " " << k;
}

TEST(Stage, BadSpawnSettingsLeaveAMessageAndNoBody) {
    Stage stage(test::load_boxes, "1");
    SpawnSettings settings;
    settings.size = -1.0f;
    stage.apply(command::Spawn{settings, {0.0, 5.0, 0.0}});
    EXPECT_EQ(body_count(stage), 2u);
    EXPECT_NE(stage.state().message.text, "");
}

TEST(Stage, SpawnsEveryKindInEverySizeWithMass) {
    Stage stage(test::load_boxes, "0");
    for (const float size : {0.05f, 0.6f, 5.0f}) {
        for (int kind = 0; kind < spawn_kind_count; ++kind) {
            SpawnSettings settings = preset_of(SpawnSettings::Kind(kind));
            settings.size = size;
            stage.apply(command::Spawn{settings, {0.0, 5.0, 0.0}});
            ASSERT_EQ(stage.state().message.text, "") << name_of(settings.kind);
            const float mass = stage.state().layout->bodies.back().mass, cube = size * size * size * settings.density;
            EXPECT_GT(mass, 0.1f * cube) << name_of(settings.kind);
            EXPECT_LE(mass, 1.001f * cube) << name_of(settings.kind);
            EXPECT_NE(std::string(name_of(settings.kind)), "");
        }
    }
    EXPECT_EQ(body_count(stage), 1u + 3u * std::size_t(spawn_kind_count));
}

TEST(Stage, BadSizesOfPolyhedraAreRefusedToo) {
    Stage stage(test::load_boxes, "0");
    for (const float size : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()}) {
        SpawnSettings settings = preset_of(SpawnSettings::Kind::rock);
        settings.size = size;
        const std::uint64_t before = stage.state().message.serial;
        stage.apply(command::Spawn{settings, {0.0, 5.0, 0.0}});
        EXPECT_EQ(stage.state().message.serial, before + 1);
        EXPECT_EQ(body_count(stage), 1u);
    }
}

TEST(Stage, MeshesAreMadeOnceAndLeaveWithTheirBodies) {
    Stage stage(test::load_boxes, "0");
    const SpawnSettings rock = preset_of(SpawnSettings::Kind::rock);
    stage.apply(command::Spawn{rock, {0.0, 5.0, 0.0}});
    const auto mesh = stage.state().layout->meshes.at(0);
    stage.apply(command::Spawn{rock, {3.0, 5.0, 0.0}});
    stage.apply(command::Spawn{box_preset(), {6.0, 5.0, 0.0}});
    ASSERT_EQ(stage.state().layout->meshes.size(), 1u);
    EXPECT_EQ(stage.state().layout->meshes[0], mesh);
    for (int i = 0; i < 3; ++i) stage.apply(command::RemoveLast{});
    EXPECT_TRUE(stage.state().layout->meshes.empty());
    EXPECT_EQ(mesh.use_count(), 1); // only this test holds it
}

TEST(Stage, EveryShapeIsPickedWhereItIs) {
    Stage stage(test::load_boxes, "0");
    for (int kind = 0; kind < spawn_kind_count; ++kind)
        stage.apply(command::Spawn{preset_of(SpawnSettings::Kind(kind)), {2.0 * kind, 5.0, 0.0}});
    for (int kind = 0; kind < spawn_kind_count; ++kind) {
        stage.apply(command::GrabBody{{{2.0 * kind, 5.0, 10.0}, {0.0f, 0.0f, -1.0f}}, 1});
        ASSERT_TRUE(stage.state().grab.holding) << name_of(SpawnSettings::Kind(kind));
        EXPECT_EQ(stage.state().selected, stage.state().layout->bodies[std::size_t(kind) + 1].id);
        EXPECT_LT(std::abs(stage.state().grab.start.z), 0.4);
        stage.apply(command::ReleaseGrab{});
    }
}

TEST(Stage, ShotBodiesFlyAlongTheRay) {
    Stage stage(test::load_boxes, "0");
    stage.apply(command::Shoot{small_sphere_preset(), {{0.0, 5.0, 0.0}, {1.0f, 0.0f, 0.0f}}});
    stage.step();
    EXPECT_NEAR(stage.state().current->speeds[1], small_sphere_preset().speed, 0.2);
    EXPECT_GT(position_of(stage, 1).x, 0.5);
}

// Also from a distance: a straight shot would fall to the ground before it arrives.
TEST(Stage, ShotBodiesHitWhatIsAimedAt) {
    for (const float speed : {60.0f, 20.0f, 4.0f}) {
        Stage stage(test::load_boxes, "1");
        const Position target(0.0, 0.9, 0.45), from(0.0, 8.0, 30.0);
        SpawnSettings ball = small_sphere_preset();
        ball.speed = speed;
        stage.apply(command::Shoot{ball, {from, Vec3(glm::normalize(target - from))}});
        double nearest = 1e9;
        for (int i = 0; i < 300; ++i) {
            stage.step();
            nearest = std::min(nearest, glm::distance(position_of(stage, 2), target));
        }
        EXPECT_LT(nearest, 0.5) << speed << " m/s";
    }
}

TEST(Spawn, TheVelocityToReachAPlaceLeadsThere) {
    const Vec3 gravity(0.0f, -9.81f, 0.0f);
    for (const Vec3 way : {Vec3(20.0f, 0.0f, 0.0f), Vec3(-5.0f, 8.0f, 3.0f), Vec3(1.0f, -30.0f, 0.0f)}) {
        const Vec3 velocity = velocity_to_reach(way, 20.0f, gravity);
        EXPECT_NEAR(glm::length(velocity), 20.0f, 1e-3f);
        const float time = glm::length(Vec3(way.x, 0.0f, way.z)) / glm::length(Vec3(velocity.x, 0.0f, velocity.z));
        EXPECT_NEAR(velocity.y * time - 0.5f * 9.81f * time * time, way.y, 1e-3f);
    }
    EXPECT_EQ(velocity_to_reach({0.0f, 0.0f, -6.0f}, 3.0f, Vec3(0.0f)), Vec3(0.0f, 0.0f, -3.0f)) << "without gravity";
    const float least = glm::length(velocity_to_reach({40.0f, 0.0f, 0.0f}, 3.0f, gravity));
    EXPECT_NEAR(least, std::sqrt(40.0f * 9.81f), 1e-3f) << "the least that flies 40 m";
}

TEST(Stage, ResetBringsTheSceneBack) {
    Stage stage(test::load_boxes, "2");
    const Position before = position_of(stage, 1);
    stage.apply(command::SetForce{{40.0f, 0.0f, 0.0f}});
    stage.apply(command::Spawn{box_preset(), {0.0, 5.0, 0.0}});
    for (int i = 0; i < 30; ++i) stage.step();
    EXPECT_GT(position_of(stage, 1).x, 1.0);
    stage.apply(command::ResetScene{});
    EXPECT_EQ(body_count(stage), 3u);
    EXPECT_EQ(position_of(stage, 1), before);
    EXPECT_EQ(stage.state().force, Vec3(0.0f));
    EXPECT_EQ(stage.state().scene_serial, 2u);
}

TEST(Stage, ASceneThatCannotBeLoadedLeavesThePresentOne) {
    Stage stage(test::load_boxes, "2");
    stage.apply(command::LoadScene{"missing"});
    EXPECT_EQ(stage.state().path, "2");
    EXPECT_EQ(body_count(stage), 3u);
    EXPECT_NE(stage.state().message.text.find("missing"), std::string::npos);
    stage.apply(command::LoadScene{"5"});
    EXPECT_EQ(body_count(stage), 6u);
}

TEST(Stage, WhereThereIsACharacterTheKeysOfForcesWalkIt) {
    const auto load = [](const std::string&) {
        LoadedScene scene = test::load_boxes("1");
        BodyDef def;
        def.type = BodyType::kinematic;
        def.position = {0.0, 0.82, 5.0};
        const BodyId walker = scene.world.create_body(def);
        scene.world.add_shape(walker, Capsule{0.5f, 0.3f});
        scene.world.body(walker).set_character({});
        return scene;
    };
    Stage stage(load, "walk");
    const double before = position_of(stage, 1).x;
    stage.apply(command::SetForce{{-40.0f, 0.0f, 0.0f}});
    for (int i = 0; i < 60; ++i) stage.step();
    EXPECT_NEAR(position_of(stage, 2).x, -3.0, 0.1);
    EXPECT_NEAR(position_of(stage, 1).x, before, 1e-3) << "boxes are left alone";
    stage.apply(command::SetForce{{0.0f, 40.0f, 0.0f}});
    for (int i = 0; i < 20; ++i) stage.step();
    EXPECT_GT(position_of(stage, 2).y, 1.5);
    stage.apply(command::SetForce{});
    for (int i = 0; i < 90; ++i) stage.step();
    EXPECT_NEAR(position_of(stage, 2).x, -3.0, 0.1) << "and stands when it is let go";
    EXPECT_NEAR(position_of(stage, 2).y, 0.82, 0.01);
}

TEST(Stage, ForceAcceleratesEveryBodyAlike) {
    Stage stage(test::load_boxes, "0");
    stage.apply(command::Spawn{large_sphere_preset(), {0.0, 50.0, 0.0}});
    stage.apply(command::Spawn{small_sphere_preset(), {5.0, 50.0, 0.0}});
    stage.apply(command::SetForce{{0.0f, 0.0f, -40.0f}});
    for (int i = 0; i < 60; ++i) stage.step();
    EXPECT_NEAR(position_of(stage, 1).z, -20.0, 0.5); // a t^2 / 2
    EXPECT_NEAR(position_of(stage, 2).z, -20.0, 0.5);
    stage.apply(command::SetForce{});
    const double speed = stage.world().linear_momentum().z;
    for (int i = 0; i < 10; ++i) stage.step();
    EXPECT_NEAR(stage.world().linear_momentum().z, speed, std::abs(speed) * 1e-4);
}

TEST(Stage, PullDrawsRestingBodiesToTheCenter) {
    Stage stage(test::load_boxes, "2");
    for (int i = 0; i < 120; ++i) stage.step(); // the boxes fall asleep
    const double before = position_of(stage, 2).x;
    stage.apply(command::SetPull{true});
    for (int i = 0; i < 20; ++i) stage.step();
    EXPECT_LT(position_of(stage, 2).x, before - 0.2);
}

TEST(Stage, FreezeHoldsEverythingStill) {
    Stage stage(test::load_boxes, "0");
    stage.apply(command::Spawn{box_preset(), {0.0, 50.0, 0.0}});
    for (int i = 0; i < 30; ++i) stage.step();
    stage.apply(command::SetFreeze{true});
    const double height = position_of(stage, 1).y;
    for (int i = 0; i < 60; ++i) stage.step();
    EXPECT_NEAR(position_of(stage, 1).y, height, 0.2); // it can fall for one step at a time
    stage.apply(command::SetFreeze{false});
    for (int i = 0; i < 60; ++i) stage.step();
    EXPECT_LT(position_of(stage, 1).y, height - 4.0);
}

TEST(Stage, GrabSelectsAndDragsTheBodyUnderTheRay) {
    Stage stage(test::load_boxes, "2");
    stage.apply(command::GrabBody{at_first_box, 7});
    const StageState grabbed = stage.state();
    EXPECT_EQ(grabbed.grab.serial, 7u);
    ASSERT_TRUE(grabbed.grab.holding);
    EXPECT_EQ(grabbed.selected, grabbed.layout->bodies[1].id);
    EXPECT_NEAR(grabbed.grab.start.z, 0.5, 1e-4); // on the surface, not at the center
    stage.apply(command::MoveGrab{{0.0, 2.0, 0.5}});
    for (int i = 0; i < 60; ++i) stage.step();
    EXPECT_GT(position_of(stage, 1).y, 1.5);
    stage.apply(command::ReleaseGrab{});
    for (int i = 0; i < 90; ++i) stage.step();
    EXPECT_LT(position_of(stage, 1).y, 0.8);
    EXPECT_EQ(stage.state().selected, grabbed.selected); // a drag keeps the selection
}

TEST(Stage, ClickBesideAllBodiesSelectsNothing) {
    Stage stage(test::load_boxes, "1");
    stage.apply(command::GrabBody{at_first_box, 1});
    stage.apply(command::ReleaseGrab{true});
    EXPECT_TRUE(stage.state().selected);
    stage.apply(command::GrabBody{at_nothing, 2});
    EXPECT_FALSE(stage.state().grab.holding);
    EXPECT_EQ(stage.state().grab.serial, 2u);
    stage.apply(command::ReleaseGrab{false}); // an orbit keeps the selection
    EXPECT_TRUE(stage.state().selected);
    stage.apply(command::ReleaseGrab{true});
    EXPECT_FALSE(stage.state().selected);
}

TEST(Stage, TheGroundIsNotGrabbed) {
    Stage stage(test::load_boxes, "1");
    stage.apply(command::GrabBody{{{8.0, 5.0, 0.0}, {0.0f, -1.0f, 0.0f}}, 1});
    EXPECT_FALSE(stage.state().grab.holding);
    EXPECT_FALSE(stage.state().selected);
}

TEST(Stage, RemovingTheDraggedBodyEndsTheDrag) {
    Stage stage(test::load_boxes, "1");
    stage.apply(command::GrabBody{at_first_box, 1});
    stage.apply(command::RemoveSelected{});
    EXPECT_EQ(body_count(stage), 1u);
    EXPECT_FALSE(stage.state().grab.holding);
    EXPECT_FALSE(stage.state().selected);
    EXPECT_NE(stage.state().message.text, "");
    stage.step();
    stage.apply(command::MoveGrab{{0.0, 2.0, 0.0}});
    stage.step();
    EXPECT_EQ(body_count(stage), 1u);
}

TEST(Stage, PauseStopsAndSingleStepAdvancesByOne) {
    Stage stage(test::load_boxes, "1");
    stage.apply(command::TogglePause{});
    EXPECT_EQ(stage.advance(1.0), 0);
    stage.apply(command::SingleStep{});
    EXPECT_EQ(stage.advance(1.0), 1);
    EXPECT_EQ(stage.world().step_count(), 1u);
    EXPECT_TRUE(stage.state().paused);
    stage.apply(command::TogglePause{});
    EXPECT_EQ(stage.advance(1.01 * frame), 1);
}

TEST(Stage, SlowFramesDoNotChangeTheSimulation) {
    Stage even(test::load_boxes, "3"), uneven(test::load_boxes, "3");
    for (Stage* stage : {&even, &uneven}) stage->apply(command::Spawn{box_preset(), {0.3, 3.0, 0.0}});
    while (even.world().step_count() < 120) even.advance(frame);
    for (int i = 0; uneven.world().step_count() < 120; ++i) {
        uneven.apply(command::SetSpeed{i % 3 == 0 ? 0.25 : 1.0});
        uneven.advance(120 - uneven.world().step_count() > 6 && i % 5 == 0 ? 3600.0 : 0.013);
    }
    ASSERT_EQ(uneven.world().step_count(), 120u);
    EXPECT_EQ(even.world().state_hash(), uneven.world().state_hash());
}

TEST(Stage, RefusedSettingsLeaveAMessage) {
    Stage stage(test::load_boxes, "1");
    WorldDef settings = stage.state().settings;
    settings.substeps = -1;
    stage.apply(command::SetSettings{settings});
    EXPECT_NE(stage.state().message.text.find("substeps"), std::string::npos);
    settings.substeps = 3;
    stage.apply(command::SetSettings{settings});
    EXPECT_EQ(stage.state().settings.substeps, 3);
}

} // namespace
