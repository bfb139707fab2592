#include "viewer/inspect.h"
#include "viewer/solver_view.h"
#include "viewer/stage.h"

#include "test_scene.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace {

using namespace cairn;
using namespace cairn::viewer;

const Ray at_first_box{{0.0, 0.6, 10.0}, {0.0f, 0.0f, -1.0f}};

void select_first(Stage& stage) {
    stage.apply(command::GrabBody{at_first_box, 1});
    stage.apply(command::ReleaseGrab{true});
}

BodyFacts facts_of(const Stage& stage) { return stage.state().inspected.value_or(BodyFacts{}); }

TEST(Inspect, TellsAllAboutABodyThatLies) {
    Stage stage(test::load_boxes, "1");
    for (int i = 0; i < 30; ++i) stage.step();
    EXPECT_FALSE(stage.state().inspected);
    select_first(stage);
    const BodyFacts facts = facts_of(stage);
    EXPECT_EQ(facts.type, BodyType::dynamic);
    EXPECT_FLOAT_EQ(facts.mass.mass, 1000.0f);
    ASSERT_EQ(facts.touches.size(), 1u);
    EXPECT_EQ(facts.touches[0].name, "body 0");
    EXPECT_NEAR(facts.touches[0].normal_force, 9810.0f, 50.0f);
    ASSERT_EQ(facts.shapes.size(), 1u);
    EXPECT_STREQ(facts.shapes[0].kind, "box");
    EXPECT_NEAR(facts.potential_energy, 1000.0 * 9.81 * 0.5, 10.0);
}

TEST(Inspect, WhatIsChangedIsUndoneByItsName) {
    Stage stage(test::load_boxes, "1");
    stage.apply(command::SetPaused{true});
    select_first(stage);
    const BodyId body = facts_of(stage).id;
    const std::uint64_t before = stage.world().state_hash();
    stage.apply(command::EditBody{body, edit::Name{"crate"}});
    stage.apply(command::EditBody{body, edit::Mass{5.0f}});
    stage.apply(command::EditBody{body, edit::Velocity{{1.0f, 2.0f, 3.0f}}});
    stage.apply(command::EditBody{body, edit::Turning{{0.0f, 4.0f, 0.0f}}});
    stage.apply(command::EditBody{body, edit::Place{{0.0, 7.0, 0.0}}});
    stage.apply(command::EditBody{body, edit::Type{BodyType::kinematic}});
    EXPECT_EQ(facts_of(stage).name, "crate");
    EXPECT_EQ(facts_of(stage).type, BodyType::kinematic);
    EXPECT_EQ(facts_of(stage).position.y, 7.0);
    EXPECT_EQ(stage.state().layout->bodies[1].name, "crate");
    for (const char* name : {"type of a body", "position of a body", "angular velocity of a body", "velocity of a body",
                             "mass of a body", "name of a body"}) {
        EXPECT_EQ(stage.state().timeline.undoable, name);
        stage.apply(command::Undo{});
    }
    EXPECT_EQ(facts_of(stage).name, "");
    EXPECT_FLOAT_EQ(facts_of(stage).mass.mass, 1000.0f);
    EXPECT_EQ(stage.world().state_hash(), before);
}

TEST(Inspect, ASliderIsUndoneAsOne) {
    Stage stage(test::load_boxes, "1");
    select_first(stage);
    for (int i = 1; i <= 20; ++i) {
        stage.apply(command::EditBody{facts_of(stage).id, edit::Mass{float(i)}});
        stage.step();
    }
    stage.apply(command::Undo{});
    EXPECT_FLOAT_EQ(facts_of(stage).mass.mass, 1000.0f);
}

// On a slope of 30 degrees, rubber on concrete sticks (tan 30 = 0.577 < 1) and oiled steel slides.
TEST(Inspect, PresetsDecideWhatSlides) {
    for (const MaterialPreset& preset : material_presets()) {
        Stage stage(
            [](const std::string&) {
                LoadedScene scene;
                BodyDef slope = test::static_body();
                scene.world.add_shape(scene.world.create_body(slope), Plane{{0.5f, 0.8660254f, 0.0f}});
                BodyDef box = test::body_at({0.25, 0.4330127, 0.0});
                box.rotation = glm::angleAxis(-0.5235988f, Vec3(0.0f, 0.0f, 1.0f));
                scene.world.add_shape(scene.world.create_body(box), Box{});
                return scene;
            },
            "");
        for (int i = 0; i < 20; ++i) stage.step(); // until it rests: friction does not hold a box that still slides
        const BodyId box = stage.world().bodies().back();
        stage.apply(command::SelectBody{box});
        stage.apply(command::EditBody{box, edit::Surface{with_preset({}, preset), true}});
        for (int i = 0; i < 60; ++i) stage.step();
        EXPECT_EQ(glm::length(facts_of(stage).velocity) > 0.1f, preset.static_friction < 0.5773f) << preset.name;
    }
}

TEST(Inspect, ADuplicateLiesBesideAndIsRemovedByUndo) {
    Stage stage(test::load_boxes, "1");
    stage.apply(command::DuplicateSelected{});
    EXPECT_EQ(stage.state().message.text, "Select a body first, by clicking it.");
    select_first(stage);
    const BodyId original = facts_of(stage).id;
    stage.apply(command::EditBody{original, edit::Mass{12.0f}});
    stage.apply(command::DuplicateSelected{});
    const BodyFacts copy = facts_of(stage);
    EXPECT_NE(copy.id, original);
    EXPECT_FLOAT_EQ(copy.mass.mass, 12.0f);
    EXPECT_GT(copy.position.x, 1.0);
    EXPECT_TRUE(copy.touches.empty());
    EXPECT_EQ(stage.state().layout->shapes.back().color, Vec3(1.0f, 0.0f, 0.0f));
    stage.apply(command::Undo{});
    EXPECT_EQ(stage.state().layout->bodies.size(), 2u);
    EXPECT_FALSE(stage.state().inspected) << "the copy is gone";
}

TEST(Inspect, TheSceneIsSavedAsItStandsWithoutTheMouse) {
    LoadedScene saved;
    Savers savers;
    savers.scene = [&](const std::filesystem::path&, LoadedScene& scene) { std::swap(saved, scene); };
    Stage stage(test::load_boxes, "1", savers);
    stage.apply(command::GrabBody{at_first_box, 1});
    stage.apply(command::MoveGrab{{0.0, 3.0, 0.0}});
    for (int i = 0; i < 30; ++i) stage.step();
    stage.apply(command::SaveScene{"there.gltf", {}});
    EXPECT_EQ(stage.state().message.text, "Saved there.gltf");
    EXPECT_EQ(saved.world.state_hash(), stage.world().state_hash());
    EXPECT_EQ(stage.world().joints().size(), 1u);
    EXPECT_EQ(saved.world.joints().size(), 0u);
    EXPECT_EQ(saved.appearances.size(), 1u);
}

// Without the fix a saved scene was shown with its shapes instead of its visual meshes.
TEST(Inspect, ASavedSceneHasTheMeshesOfItsFile) {
    LoadedScene saved;
    Savers savers;
    savers.scene = [&](const std::filesystem::path&, LoadedScene& scene) { std::swap(saved, scene); };
    const std::vector<Vec3> corners{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<std::uint32_t> triangle{0, 1, 2};
    const auto mesh =
        std::make_shared<const ShapeMesh>(make_shape_mesh(visual_triangles(corners, {}, triangle), MeshVisual::visual));
    const auto load = [&](const std::string& path) {
        LoadedScene scene = test::load_boxes(path);
        scene.visuals.push_back({scene.world.bodies().back(), {}, mesh, {1, 0, 0}});
        return scene;
    };
    Stage stage(load, "1", savers);
    for (int i = 0; i < 5; ++i) stage.step();
    stage.apply(command::SaveScene{"there.gltf", {}});
    ASSERT_EQ(saved.visuals.size(), 1u);
    EXPECT_EQ(saved.visuals[0].mesh, mesh);
    EXPECT_TRUE(saved.world.is_valid(saved.visuals[0].body));
}

TEST(Inspect, ATriggerLetsBodiesThroughAndIsUndone) {
    Stage stage(test::load_boxes, "2");
    select_first(stage);
    const BodyId body = facts_of(stage).id;
    stage.apply(command::EditBody{body, edit::Type{BodyType::static_}});
    EXPECT_FALSE(facts_of(stage).is_trigger);
    stage.apply(command::EditBody{body, edit::Trigger{true}});
    EXPECT_TRUE(facts_of(stage).is_trigger);
    SpawnSettings ball;
    ball.kind = SpawnSettings::Kind::sphere;
    ball.size = 0.4f;
    stage.apply(command::Spawn{ball, {0.0, 3.0, 0.0}});
    for (int i = 0; i < 120; ++i) stage.step();
    const Position fallen = stage.world().body(stage.world().bodies().back()).position();
    EXPECT_LT(fallen.y, 0.5) << "through the box, onto the ground";
    while (stage.state().timeline.undoable) stage.apply(command::Undo{});
    EXPECT_FALSE(stage.world().shape_def(stage.world().body(body).shapes().front()).is_trigger);
}

TEST(Inspect, WhatIsDisabledLetsBodiesThroughAndIsUndone) {
    Stage stage(test::load_boxes, "2");
    select_first(stage);
    const BodyId body = facts_of(stage).id;
    stage.apply(command::EditBody{body, edit::Enabled{false}});
    EXPECT_FALSE(facts_of(stage).is_enabled);
    EXPECT_EQ(facts_of(stage).linear_energy + facts_of(stage).angular_energy, 0.0);
    SpawnSettings ball;
    ball.kind = SpawnSettings::Kind::sphere;
    ball.size = 0.4f;
    stage.apply(command::Spawn{ball, {0.0, 3.0, 0.0}});
    for (int i = 0; i < 120; ++i) stage.step();
    EXPECT_LT(stage.world().body(stage.world().bodies().back()).position().y, 0.5) << "through the box";
    while (stage.state().timeline.undoable) stage.apply(command::Undo{});
    EXPECT_TRUE(std::as_const(stage.world()).body(body).enabled());
}

TEST(Inspect, ForceFieldsAreAddedChangedRemovedAndUndone) {
    Stage stage(test::load_boxes, "1");
    const BodyId box = stage.world().bodies().back();
    ForceField wind;
    wind.direction = Vec3(9.0f, 0.0f, 0.0f); // more than friction can resist
    stage.apply(command::AddField{wind});
    ASSERT_EQ(stage.state().fields.size(), 1u);
    const ForceFieldId id = stage.state().fields[0].first;
    for (int i = 0; i < 30; ++i) stage.step();
    const double blown = stage.world().body(box).position().x;
    EXPECT_GT(blown, 0.1);
    stage.apply(command::SetForce{{0.0f, 1.0f, 0.0f}});
    EXPECT_EQ(stage.state().fields.size(), 1u) << "a held key is none of the scene's";
    stage.apply(command::SetForce{});
    wind.direction = Vec3(-20.0f, 0.0f, 0.0f);
    stage.apply(command::SetField{id, wind});
    EXPECT_EQ(stage.state().fields[0].second.direction.x, -20.0f);
    for (int i = 0; i < 60; ++i) stage.step();
    EXPECT_LT(stage.world().body(box).position().x, blown);
    stage.apply(command::RemoveField{id});
    EXPECT_TRUE(stage.state().fields.empty());
    EXPECT_EQ(stage.state().timeline.undoable, "remove a force field");
    stage.apply(command::Undo{});
    ASSERT_EQ(stage.state().fields.size(), 1u);
    EXPECT_EQ(stage.state().fields[0].second.direction.x, -20.0f);
    while (stage.state().timeline.undoable) stage.apply(command::Undo{});
    EXPECT_TRUE(stage.state().fields.empty());
}

TEST(SolverView, IsReadOnlyWhereItIsAskedFor) {
    LoadedScene scene = test::boxes_on_plane(2);
    EXPECT_EQ(read_solver(scene.world, {}, 1.0 / 60.0), nullptr);
}

TEST(SolverView, ForcesHoldTheWeightAndConesAreAsWideAsTheFriction) {
    LoadedScene scene = test::boxes_on_plane(1);
    for (int i = 0; i < 30; ++i) scene.world.step(1.0f / 60.0f);
    SolverShown shown;
    shown.contacts = shown.cones = true;
    const auto view = read_solver(scene.world, shown, 1.0 / 60.0);
    ASSERT_EQ(view->points.size(), 4u);
    float sum = 0.0f;
    for (const SolverView::Point& point : view->points) sum += point.normal_force;
    EXPECT_NEAR(sum, 9810.0f, 50.0f);
    EXPECT_FLOAT_EQ(view->points[0].coefficient, 0.6f);
    EXPECT_GT(view->points[0].normal.y, 0.99f) << "on the box, not on the ground";
    RenderFrame frame;
    frame.camera = scene.camera;
    draw_solver(frame, *view);
    EXPECT_FALSE(frame.veils.empty());
    const auto dots = std::count_if(frame.strokes.begin(), frame.strokes.end(),
                                    [](const Stroke& stroke) { return stroke.from == stroke.to; });
    EXPECT_EQ(dots, 4);
}

TEST(SolverView, WithABodySelectedOnlyWhatActsOnItIsShown) {
    LoadedScene scene = test::boxes_on_plane(0);
    for (int i = 0; i < 3; ++i)
        scene.world.add_shape(scene.world.create_body(test::body_at({0.0, 0.5 + i, 0.0})), Box{});
    for (int i = 0; i < 30; ++i) scene.world.step(1.0f / 60.0f);
    SolverShown shown;
    shown.contacts = true;
    EXPECT_EQ(read_solver(scene.world, shown, 1.0 / 60.0)->points.size(), 12u);
    const auto view = read_solver(scene.world, shown, 1.0 / 60.0, scene.world.bodies()[2]);
    ASSERT_EQ(view->points.size(), 8u);
    float sum = 0.0f;
    for (const SolverView::Point& point : view->points) sum += point.normal_force * point.normal.y;
    EXPECT_NEAR(sum, 9810.0f, 100.0f) << "from below less from above: its weight";
}

TEST(SolverView, AxesOfInertiaAreThoseOfTheEllipsoid) {
    World world;
    const BodyId id = world.create_body(test::body_at({0.0, 5.0, 0.0}));
    world.add_shape(id, Sphere{0.7f});
    SolverShown shown;
    shown.axes = shown.velocities = true;
    const auto view = read_solver(world, shown, 1.0 / 60.0);
    ASSERT_EQ(view->movers.size(), 1u);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(view->movers[0].half_axes[i], 0.7f, 1e-4f);
}

TEST(SolverView, IslandsAreLinkedAndPlanesHaveNoBox) {
    LoadedScene scene = test::boxes_on_plane(0);
    for (int i = 0; i < 3; ++i)
        scene.world.add_shape(scene.world.create_body(test::body_at({0.0, 0.5 + i, 0.0})), Box{});
    for (int i = 0; i < 5; ++i) scene.world.step(1.0f / 60.0f);
    SolverShown shown;
    shown.islands = shown.bounds = true;
    const auto view = read_solver(scene.world, shown, 1.0 / 60.0);
    EXPECT_EQ(view->links.size(), 2u) << "the ground joins nothing";
    EXPECT_EQ(view->bounds.size(), 3u);
}

TEST(SolverView, TheTreeIsDrawnDownToADepthAndOfOneBodyTheWayToIt) {
    LoadedScene scene = test::boxes_on_plane(0);
    for (int i = 0; i < 100; ++i)
        scene.world.add_shape(scene.world.create_body(test::body_at({3.0 * (i % 10), 5.0, 3.0 * (i / 10)})), Box{});
    scene.world.step(1.0f / 60.0f);
    SolverShown shown;
    shown.tree = true;
    const auto depths = [&](BodyId selected) {
        std::vector<int> count(greatest_tree_depth + 1);
        const auto view = read_solver(scene.world, shown, 1.0 / 60.0, selected);
        for (const BroadPhaseNode& node : view->nodes) ++count[std::size_t(node.depth)];
        count.resize(4);
        return count;
    };
    shown.tree_depth = 1;
    EXPECT_EQ(depths({}), (std::vector{1, 2, 0, 0})) << "two nodes hold 64 and 36 boxes";
    shown.tree_depth = greatest_tree_depth;
    EXPECT_EQ(depths({}), (std::vector{1, 2, 13, 100}));
    const BodyId body = scene.world.bodies()[57];
    EXPECT_EQ(depths(body), (std::vector{1, 1, 1, 1}));
    const auto view = read_solver(scene.world, shown, 1.0 / 60.0, body);
    EXPECT_EQ(scene.world.body_of(view->nodes.back().shape), body);
    RenderFrame frame;
    frame.camera = scene.camera;
    draw_solver(frame, *view);
    EXPECT_EQ(frame.strokes.size(), 4u * 12u);
    EXPECT_EQ(frame.strokes.front().color, tree_color(0));
    EXPECT_EQ(frame.strokes.back().color, tree_color(3));
}

TEST(SolverView, AllBoxesOfALargeTreeAreDrawn) {
    LoadedScene scene = test::boxes_on_plane(0);
    constexpr int count = 4000;
    for (int i = 0; i < count; ++i)
        scene.world.add_shape(scene.world.create_body(test::body_at({3.0 * (i % 64), 5.0, 3.0 * (i / 64)})), Box{});
    scene.world.step(1.0f / 60.0f);
    SolverShown shown;
    shown.tree = true;
    shown.tree_depth = greatest_tree_depth;
    RenderFrame frame;
    frame.camera = scene.camera;
    frame.origin = {10.0, 0.0, 0.0};
    const auto view = read_solver(scene.world, shown, 1.0 / 60.0);
    EXPECT_EQ(std::count_if(view->nodes.begin(), view->nodes.end(), [](const auto& node) { return node.is_leaf; }),
              count);
    draw_solver(frame, *view);
    EXPECT_TRUE(frame.strokes.empty());
    ASSERT_EQ(frame.line_boxes.size(), view->nodes.size());
    EXPECT_EQ(frame.line_boxes.back().min, Vec3(view->nodes.back().bounds.min - frame.origin));
    EXPECT_EQ(frame.line_boxes.back().max, Vec3(view->nodes.back().bounds.max - frame.origin));
    EXPECT_EQ(frame.line_boxes.back().color, tree_color(view->nodes.back().depth));
}

TEST(SolverView, ContactsHaveTheColorsAndSubstepsInWhichTheyAreSolved) {
    LoadedScene scene = test::boxes_on_plane(1);
    for (int i = 1; i < 8; ++i)
        scene.world.add_shape(scene.world.create_body(test::body_at({0.0, 0.5 + i, 0.0})), Box{});
    for (int i = 0; i < 10; ++i) scene.world.step(1.0f / 60.0f);
    SolverShown shown;
    shown.colors = true;
    auto view = read_solver(scene.world, shown, 1.0 / 60.0);
    ASSERT_EQ(view->solved.size(), 8u);
    RenderFrame frame;
    frame.camera = scene.camera;
    draw_solver(frame, *view);
    ASSERT_EQ(frame.strokes.size(), 8u + 7u * 2u + 1u) << "a dot each, and a line to each center but the ground's";
    EXPECT_EQ(frame.strokes[0].color, contact_color(view->solved[0].color));
    EXPECT_EQ(read_solver(scene.world, shown, 1.0 / 60.0, scene.world.bodies().back())->solved.size(), 1u);
    shown.colors = false;
    shown.substeps = true;
    view = read_solver(scene.world, shown, 1.0 / 60.0);
    draw_solver(frame = {}, *view);
    EXPECT_EQ(view->solved[0].substeps, scene.world.statistics().max_substeps);
    EXPECT_EQ(frame.strokes[0].color, substep_color(view->solved[0].substeps));
}

TEST(SolverView, EachPartHasAPageOfTheDocumentation) {
    for (const SolverPart& part : solver_parts())
        EXPECT_TRUE(std::filesystem::is_regular_file(std::string(CAIRN_TEST_SCENES "/../docs/") + part.page))
            << part.name;
}

TEST(SolverView, TheStageShowsIt) {
    Stage stage(test::load_boxes, "1");
    SolverShown shown;
    shown.velocities = true;
    stage.apply(command::ShowSolver{shown});
    ASSERT_TRUE(stage.state().current->solver);
    const RenderFrame frame = make_frame(*stage.state().layout, *stage.state().previous, *stage.state().current, 1.0f,
                                         stage.state().scene_camera);
    stage.step();
    EXPECT_EQ(stage.state().current->solver->movers.size(), 1u);
    stage.apply(command::ShowSolver{});
    EXPECT_FALSE(stage.state().current->solver);
    EXPECT_TRUE(frame.strokes.empty()) << "at rest there is no velocity to show";
}

} // namespace
