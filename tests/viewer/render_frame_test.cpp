#include "viewer/render_frame.h"

#include "viewer/palette.h"

#include "test_scene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <set>
#include <span>
#include <tuple>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;

TEST(RenderFrame, ShowsEveryShapeInItsPlace) {
    LoadedScene scene = test::boxes_on_plane(2);
    const BodyId ball = scene.world.create_body(test::body_at({0.0, 4.0, -1.0}));
    ShapeDef beside;
    beside.position = {0.5f, 0.0f, 0.0f};
    scene.world.add_shape(ball, Sphere{0.25f}, beside);
    const RenderFrame frame = make_frame(scene.world, scene.appearances, scene.camera);
    ASSERT_EQ(frame.boxes.size(), 2u);
    ASSERT_EQ(frame.spheres.size(), 1u);
    ASSERT_EQ(frame.grounds.size(), 1u);
    EXPECT_TRUE(frame.rectangles.empty());
    EXPECT_EQ(frame.boxes[1].position, Vec3(Position(2.0, 0.5, 0.0) - frame.origin));
    EXPECT_EQ(frame.boxes[1].color, Vec3(1.0f, 0.0f, 0.0f)); // the scene's own color
    EXPECT_EQ(frame.spheres[0].position, Vec3(Position(0.5, 4.0, -1.0) - frame.origin));
    EXPECT_EQ(frame.spheres[0].half_size, Vec3(0.25f));
}

TEST(RenderFrame, RoundShapesComeWithTheirSizes) {
    World world;
    const BodyId body = world.create_body(test::body_at({0.0, 4.0, 0.0}));
    world.add_shape(body, Capsule{0.5f, 0.25f, {}});
    world.add_shape(body, Capsule{0.5f, 0.25f, 0.1f});
    world.add_shape(body, Cylinder{0.3f, 0.6f, {}});
    world.add_shape(body, cone(0.4f, 0.7f));
    const RenderFrame frame = make_frame(world, {}, CameraPose{});
    ASSERT_EQ(frame.capsules.size(), 2u);
    ASSERT_EQ(frame.cylinders.size(), 2u);
    EXPECT_EQ(frame.capsules[0].half_size, Vec3(0.25f, 0.5f, 0.25f)); // lower radius, half height, upper radius
    EXPECT_EQ(frame.capsules[1].half_size, Vec3(0.25f, 0.5f, 0.1f));
    EXPECT_EQ(frame.cylinders[0].half_size, Vec3(0.6f, 0.3f, 0.6f));
    EXPECT_EQ(frame.cylinders[1].half_size, Vec3(0.4f, 0.7f, 0.0f));
    EXPECT_FLOAT_EQ(frame.capsules[1].bound_radius, 0.75f);
    EXPECT_FLOAT_EQ(frame.cylinders[0].bound_radius, std::hypot(0.3f, 0.6f));
}

TEST(RenderFrame, ShapesOfTheSameDataAreInstancesOfOneMesh) {
    World world;
    const Hull hull(test::cube_corners());
    const cairn::Mesh surface = test::cube_surface();
    const HeightField field = test::hills(5, 1.0f);
    for (int i = 0; i < 3; ++i) world.add_shape(world.create_body(test::body_at({3.0 * i, 4.0, 0.0})), hull);
    for (int i = 0; i < 2; ++i) world.add_shape(world.create_body(test::static_body()), surface);
    world.add_shape(world.create_body(test::static_body()), field);
    MeshCache meshes;
    const RenderFrame frame = make_frame(world, {}, CameraPose{}, {}, meshes);
    ASSERT_EQ(frame.meshes.size(), 3u);
    EXPECT_EQ(frame.meshes[0].instances.size(), 3u);
    EXPECT_EQ(frame.meshes[0].mesh->look, MeshVisual::facets);
    EXPECT_EQ(frame.meshes[0].instances[1].position, Vec3(Position(3.0, 4.0, 0.0) - frame.origin));
    EXPECT_EQ(frame.meshes[1].instances.size(), 2u);
    EXPECT_EQ(frame.meshes[1].mesh->look, MeshVisual::surface);
    EXPECT_EQ(frame.meshes[1].instances[0].color, surface_color());
    EXPECT_EQ(frame.meshes[2].mesh->look, MeshVisual::terrain);
    EXPECT_EQ(frame.meshes[2].instances[0].color, terrain_color());
    EXPECT_EQ(frame.meshes[2].instances[0].pattern, 1.0f);

    // The next frame shares the same meshes instead of copying them.
    const RenderFrame next = make_frame(world, {}, CameraPose{}, {}, meshes);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(next.meshes[i].mesh, frame.meshes[i].mesh);
}

TEST(RenderFrame, SlopesAreNotTintedWhereColorsMeanSomething) {
    World world;
    const ShapeId field = world.add_shape(world.create_body(test::static_body()), test::hills(5, 1.0f));
    FrameOptions options;
    options.colors = ColorMode::mass;
    EXPECT_EQ(make_frame(world, {}, CameraPose{}, options).meshes[0].instances[0].pattern, 0.0f);
    const Appearance own{field, {0.1f, 0.2f, 0.3f}};
    const Instance colored = make_frame(world, std::span(&own, 1), CameraPose{}).meshes[0].instances[0];
    EXPECT_EQ(colored.pattern, 0.0f);
    EXPECT_EQ(colored.color, own.color);
}

// A triangle as a visual.
std::shared_ptr<const ShapeMesh> some_visual() {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<std::uint32_t> triangle{0, 1, 2};
    return std::make_shared<const ShapeMesh>(
        make_shape_mesh(visual_triangles(points, {}, triangle), MeshVisual::visual));
}

// Corners distinguish the selected body even from one that has the highlight color.
TEST(RenderFrame, CornersAreDrawnAroundTheSelectedBody) {
    LoadedScene scene = test::boxes_on_plane(3);
    const auto corners = [&](const FrameOptions& options) {
        const RenderFrame frame = make_frame(scene.world, scene.appearances, scene.camera, options);
        std::vector<Position> places;
        for (const Stroke& stroke : frame.strokes) places.push_back(Position(stroke.from) + frame.origin);
        return places;
    };
    FrameOptions options;
    EXPECT_TRUE(corners(options).empty());
    options.selected = scene.world.bodies()[0]; // the ground, which is infinite
    EXPECT_TRUE(corners(options).empty());
    options.selected = scene.world.bodies()[2];
    const std::vector<Position> one = corners(options);
    ASSERT_EQ(one.size(), 24u); // three edges begin at each of eight corners
    for (const Position& place : one) {
        const Position away = glm::abs(place - Position(2.0, 0.5, 0.0));
        EXPECT_LT(glm::distance(away, Position(0.5)), 1e-4);
    }
    options.selection = {scene.world.bodies()[2], scene.world.bodies()[3]};
    EXPECT_TRUE(corners(options).empty()) << "many would hide what they are around";
    // A second shape above the first: one box encloses both.
    ShapeDef above;
    above.position = {0.0f, 1.0f, 0.0f};
    scene.world.add_shape(scene.world.bodies()[2], Sphere{0.25f}, above);
    options.selection.clear();
    const std::vector<Position> both = corners(options);
    ASSERT_EQ(both.size(), 24u);
    for (const Position& place : both) EXPECT_NEAR(std::abs(place.y - 0.875), 0.875, 1e-4) << "from 0 to 1.75 m";
}

TEST(RenderFrame, VisualsStandForTheShapesOfTheirBodies) {
    LoadedScene scene = test::boxes_on_plane(2);
    const BodyId body = scene.world.bodies()[2];
    scene.world.body(body).set_rotation(Quat(0.0f, 0.0f, 1.0f, 0.0f)); // half a turn about y
    const auto mesh = some_visual();
    const std::vector<Visual> visuals{
        {body, {{0.25, 0.5, 0.0}, Quat(1.0f, 0.0f, 0.0f, 0.0f)}, mesh, {0.1f, 0.2f, 0.3f}},
        {{}, {{7.0, 8.0, 9.0}, Quat(1.0f, 0.0f, 0.0f, 0.0f)}, mesh, {1.0f, 0.0f, 0.0f}}};
    MeshCache meshes;
    FrameOptions options;
    options.selected = body;
    const RenderFrame frame = make_frame(scene.world, {}, scene.camera, options, meshes, visuals);
    EXPECT_EQ(frame.boxes.size(), 1u); // the other body has no visual
    ASSERT_EQ(frame.meshes.size(), 1u);
    ASSERT_EQ(frame.meshes[0].instances.size(), 2u);
    const Instance& moving = frame.meshes[0].instances[0];
    EXPECT_LT(glm::distance(Position(moving.position) + frame.origin, Position(1.75, 1.0, 0.0)), 1e-5);
    EXPECT_NEAR(std::abs(moving.rotation.y), 1.0f, 1e-6f);
    EXPECT_EQ(moving.color, Vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(moving.emphasis, 1.0f);
    const Instance& scenery = frame.meshes[0].instances[1];
    EXPECT_EQ(Position(scenery.position) + frame.origin, Position(7.0, 8.0, 9.0));
    EXPECT_EQ(scenery.emphasis, 0.0f);

    options.visuals = false;
    const RenderFrame shapes = make_frame(scene.world, {}, scene.camera, options, meshes, visuals);
    EXPECT_EQ(shapes.boxes.size(), 2u);
    EXPECT_TRUE(shapes.meshes.at(0).instances.empty());

    options.visuals = true;
    options.colors = ColorMode::mass;
    EXPECT_EQ(make_frame(scene.world, {}, scene.camera, options, meshes, visuals).meshes[0].instances[0].color,
              mass_ramp(0.5f));

    scene.world.destroy_body(body); // removes its visual too
    EXPECT_EQ(make_frame(scene.world, {}, scene.camera, {}, meshes, visuals).meshes[0].instances.size(), 1u);
}

TEST(RenderFrame, TriggersAreOutlinesAndNothingSolid) {
    World world;
    ShapeDef trigger;
    trigger.is_trigger = true;
    trigger.position = {1.0f, 0.0f, 0.0f};
    const BodyId gate = world.create_body(test::static_body());
    world.add_shape(gate, Box{{0.5f, 2.0f, 3.0f}}, trigger);
    const RenderFrame frame = make_frame(world, {}, CameraPose{});
    EXPECT_TRUE(frame.boxes.empty());
    ASSERT_EQ(frame.lines.size(), 12u); // the edges of a box
    float length = 0.0f;
    Vec3 least(1e9f), greatest(-1e9f);
    for (const Line& line : frame.lines) {
        length += glm::distance(line.from, line.to);
        least = glm::min(least, glm::min(line.from, line.to));
        greatest = glm::max(greatest, glm::max(line.from, line.to));
    }
    EXPECT_NEAR(length, 4.0f * (1.0f + 4.0f + 6.0f), 1e-4f);
    EXPECT_LT(glm::distance(least + Vec3(frame.origin), Vec3(0.5f, -2.0f, -3.0f)), 1e-5f);
    EXPECT_LT(glm::distance(greatest + Vec3(frame.origin), Vec3(1.5f, 2.0f, 3.0f)), 1e-5f);
}

TEST(RenderFrame, WhatIsDisabledIsAnOutline) {
    World world;
    const BodyId box = world.create_body(test::body_at({0.0, 1.0, 0.0}));
    world.add_shape(box, Box{});
    EXPECT_EQ(make_frame(world, {}, CameraPose{}).boxes.size(), 1u);
    world.body(box).set_enabled(false);
    const RenderFrame frame = make_frame(world, {}, CameraPose{});
    EXPECT_TRUE(frame.boxes.empty());
    ASSERT_EQ(frame.lines.size(), 12u);
    EXPECT_EQ(frame.lines[0].color, disabled_color());
}

TEST(RenderFrame, EveryKindOfShapeHasAColorOfItsOwn) {
    World world;
    const BodyId body = world.create_body(test::body_at({0.0, 4.0, 0.0}));
    for (const Shape& shape :
         {Shape(Sphere{}), Shape(Box{}), Shape(Capsule{}), Shape(Cylinder{}), Shape(Hull(test::cube_corners()))})
        world.add_shape(body, shape);
    FrameOptions options;
    options.colors = ColorMode::shape;
    const RenderFrame frame = make_frame(world, {}, CameraPose{}, options);
    std::set<std::tuple<float, float, float>> colors;
    for (const auto* list :
         {&frame.spheres, &frame.boxes, &frame.capsules, &frame.cylinders, &frame.meshes.at(0).instances}) {
        ASSERT_EQ(list->size(), 1u);
        const Vec3 color = list->front().color;
        colors.insert({color.x, color.y, color.z});
    }
    EXPECT_EQ(colors.size(), 5u);
}

TEST(RenderFrame, RectangleLiesAlongItsTangent) {
    LoadedScene scene = test::boxes_on_plane(0);
    const BodyId wall = scene.world.create_body(test::static_body());
    scene.world.add_shape(wall, Plane{{1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, glm::vec2(3.0f, 2.0f)});
    const RenderFrame frame = make_frame(scene.world, {}, scene.camera);
    ASSERT_EQ(frame.rectangles.size(), 1u);
    const Instance& rectangle = frame.rectangles[0];
    const Quat turn(rectangle.rotation.w, rectangle.rotation.x, rectangle.rotation.y, rectangle.rotation.z);
    EXPECT_LT(glm::distance(turn * Vec3(0.0f, 1.0f, 0.0f), Vec3(1.0f, 0.0f, 0.0f)), 1e-5f);
    EXPECT_LT(glm::distance(turn * Vec3(1.0f, 0.0f, 0.0f), Vec3(0.0f, 0.0f, 1.0f)), 1e-5f);
    EXPECT_EQ(rectangle.half_size.x, 3.0f);
    EXPECT_EQ(rectangle.half_size.z, 2.0f);
}

TEST(RenderFrame, MassColorsRunFromBlueToRed) {
    LoadedScene scene = test::boxes_on_plane(0);
    for (int i = 0; i < 3; ++i) {
        const BodyId body = scene.world.create_body(test::body_at({2.0 * i, 1.0, 0.0}));
        scene.world.add_shape(body, Sphere{0.5f}, test::with_density(i == 0 ? 10.0f : i == 1 ? 100.0f : 1000.0f));
    }
    FrameOptions options;
    options.colors = ColorMode::mass;
    const RenderFrame frame = make_frame(scene.world, {}, scene.camera, options);
    EXPECT_EQ(frame.spheres[0].color, mass_ramp(0.0f));
    EXPECT_EQ(frame.spheres[2].color, mass_ramp(1.0f));
}

TEST(RenderFrame, IslandsJoinTouchingBodiesOnly) {
    LoadedScene scene = test::boxes_on_plane(2);
    const BodyId upper = scene.world.create_body(test::body_at({0.0, 1.5, 0.0}));
    scene.world.add_shape(upper, Box{});
    for (int i = 0; i < 3; ++i) scene.world.step(1.0f / 60.0f);
    MeshCache meshes;
    const WorldLayout layout = read_layout(scene.world, {}, meshes);
    const WorldMotion motion = read_motion(scene.world, layout, true);
    EXPECT_EQ(motion.islands[1], motion.islands[3]); // one is on the other
    EXPECT_NE(motion.islands[1], motion.islands[2]); // both are on the ground, which does not connect islands
}

TEST(RenderFrame, InterpolatesBetweenTwoStates) {
    const LoadedScene scene = test::boxes_on_plane(1);
    MeshCache meshes;
    const WorldLayout layout = read_layout(scene.world, {}, meshes);
    const WorldMotion before = read_motion(scene.world, layout);
    WorldMotion after = before;
    after.transforms[1].position.x += 1.0;
    after.transforms[1].rotation = -before.transforms[1].rotation; // the same rotation with the opposite sign
    const RenderFrame frame = make_frame(layout, before, after, 0.25f, scene.camera);
    EXPECT_NEAR(frame.boxes[0].position.x + frame.origin.x, 0.25, 1e-6);
    EXPECT_NEAR(glm::length(frame.boxes[0].rotation), 1.0f, 1e-5f);
}

TEST(RenderFrame, StaysExactFarFromTheOrigin) {
    World world;
    const Position far(4.0e6, 10.0, -7.0e6);
    for (int i = 0; i < 2; ++i) {
        const BodyId body = world.create_body(test::body_at(far + Position(0.001 * i, 0.0, 0.0)));
        world.add_shape(body, Sphere{0.5f});
    }
    const RenderFrame frame = make_frame(world, {}, {far + Position(0.0, 0.0, 5.0), far});
    EXPECT_NEAR(frame.spheres[1].position.x - frame.spheres[0].position.x, 0.001f, 1e-5f);
}

TEST(RenderFrame, GroundGridStandsStillWhenTheOriginMoves) {
    LoadedScene scene = test::boxes_on_plane(0);
    const RenderFrame near = make_frame(scene.world, {}, {{0.0, 3.0, 5.0}, {0.0, 0.0, 0.0}});
    const RenderFrame far = make_frame(scene.world, {}, {{730.0, 3.0, 5.0}, {730.0, 0.0, 0.0}});
    ASSERT_NE(near.origin, far.origin);
    const double step = (far.origin.x + far.grounds[0].position.x - far.grounds[0].grid_offset.x) -
                        (near.origin.x + near.grounds[0].position.x - near.grounds[0].grid_offset.x);
    EXPECT_NEAR(step / 10.0, std::round(step / 10.0), 1e-4); // a whole number of cells
}

TEST(RenderFrame, AGroundThatParallelRaysSeeFromItsEdgeIsALine) {
    const LoadedScene scene = test::boxes_on_plane(1);
    CameraPose camera{{0.0, 1.0, 10.0}, {0.0, 1.0, 0.0}, 0.785398f, true};
    const RenderFrame frame = make_frame(scene.world, {}, camera);
    ASSERT_EQ(frame.lines.size(), 1u);
    for (const Vec3& end : {frame.lines[0].from, frame.lines[0].to}) {
        EXPECT_NEAR(frame.origin.y + double(end.y), 0.0, 1e-5);
        EXPECT_GT(std::abs(end.x), 100.0f);
    }
    camera.position.y = 2.0;
    EXPECT_TRUE(make_frame(scene.world, {}, camera).lines.empty()) << "it is seen from above";
    camera = {{0.0, 1.0, 10.0}, {0.0, 1.0, 0.0}};
    EXPECT_TRUE(make_frame(scene.world, {}, camera).lines.empty()) << "what is far is seen from above";
}

TEST(RenderFrame, AllThatIsSelectedIsHighlighted) {
    const LoadedScene scene = test::boxes_on_plane(3);
    FrameOptions options;
    options.selection = {scene.world.bodies()[1], scene.world.bodies()[3]};
    const RenderFrame frame = make_frame(scene.world, {}, scene.camera, options);
    ASSERT_EQ(frame.boxes.size(), 3u);
    for (const Instance& box : frame.boxes)
        EXPECT_EQ(box.emphasis, std::abs(double(box.position.x) + frame.origin.x - 2.0) < 0.1 ? 0.0f : 1.0f);
}

TEST(RenderFrame, SelectedBodyIsHighlighted) {
    const LoadedScene scene = test::boxes_on_plane(2);
    FrameOptions options;
    options.selected = scene.world.bodies()[2];
    const RenderFrame frame = make_frame(scene.world, {}, scene.camera, options);
    EXPECT_EQ(frame.boxes[0].emphasis, 0.0f);
    EXPECT_EQ(frame.boxes[1].emphasis, 1.0f);
}

TEST(FitCamera, LooksAtTheDynamicBodies) {
    const LoadedScene scene = test::boxes_on_plane(3);
    const OrbitCamera camera(fit_camera(scene.world));
    for (const double x : {-0.5, 2.0, 4.5}) {
        const auto device = camera.project({x, 0.5, 0.0}, 1.6f);
        ASSERT_TRUE(device);
        EXPECT_LT(std::abs(device->x), 0.9f);
        EXPECT_LT(std::abs(device->y), 0.9f);
    }
}

TEST(FitCamera, StaysWithTheBodiesOnAHugeField) {
    World world;
    world.add_shape(world.create_body(test::static_body()), Plane{});
    const BodyId ground = world.create_body(test::static_body());
    world.add_shape(ground, test::hills(300, 100.0f)); // 30 km
    const BodyId body = world.create_body(test::body_at({4.0, 4.0, 0.0}));
    world.add_shape(body, Capsule{0.5f, 0.25f, {}});
    const CameraPose pose = fit_camera(world);
    EXPECT_LT(glm::distance(pose.target, Position(4.0, 2.375, 0.0)), 0.1); // the body falls to the plane
    EXPECT_LT(glm::distance(pose.target, pose.position), 20.0);

    world.destroy_body(body);
    const CameraPose wide = fit_camera(world); // frames all that is left
    EXPECT_LT(glm::distance(wide.target, Position(0.0)), 10.0);
    EXPECT_GT(glm::distance(wide.target, wide.position), 1.0e4);
    EXPECT_TRUE(std::isfinite(glm::distance(wide.target, wide.position)));

    world.destroy_body(ground);
    const CameraPose alone = fit_camera(world); // only an infinite plane
    EXPECT_LT(glm::distance(alone.target, alone.position), 100.0);
}

// Without the fix falling bodies left the picture.
TEST(FitCamera, ShowsWhereBodiesFallTo) {
    World world;
    world.add_shape(world.create_body(test::static_body()), Plane{});
    const BodyId high = world.create_body(test::body_at({3.0, 20.0, 0.0}));
    world.add_shape(high, Sphere{0.5f});
    const OrbitCamera camera(fit_camera(world));
    for (const double height : {20.0, 10.0, 0.5}) {
        const auto device = camera.project({3.0, height, 0.0}, 1.5f);
        ASSERT_TRUE(device) << height;
        EXPECT_LT(std::abs(device->x), 0.95f) << height;
        EXPECT_LT(std::abs(device->y), 0.95f) << height;
    }
}

TEST(FitCamera, LooksAtTheSceneryWhenThereIsNothingElse) {
    const std::vector<Visual> visuals{{{}, {{70.0, 8.0, 9.0}, Quat(1.0f, 0.0f, 0.0f, 0.0f)}, some_visual(), {}}};
    const World world;
    EXPECT_LT(glm::distance(fit_camera(world, visuals).target, Position(70.5, 8.5, 9.0)), 0.1);
    MeshCache meshes;
    const WorldLayout layout = read_layout(world, {}, meshes, visuals);
    EXPECT_LT(glm::distance(bounding_ball(layout, read_motion(world, layout)).center, Position(70.5, 8.5, 9.0)), 0.1);
}

TEST(BoundingBall, HoldsEveryShape) {
    World world;
    const BodyId body = world.create_body(test::body_at({1.0, 2.0, 3.0}));
    ShapeDef aside;
    aside.position = {2.0f, 0.0f, 0.0f};
    std::vector<Vec3> corners = test::cube_corners();
    for (Vec3& corner : corners) corner += Vec3(0.0f, 5.0f, 0.0f); // far from the shape's origin
    world.add_shape(body, Hull(corners), aside);
    MeshCache meshes;
    const WorldLayout layout = read_layout(world, {}, meshes);
    const BoundingBall ball = bounding_ball(layout, read_motion(world, layout));
    EXPECT_LT(glm::distance(ball.center, Position(3.0, 7.0, 3.0)), 1e-5);
    EXPECT_GE(ball.radius, std::sqrt(3.0f) - 1e-5f);
    EXPECT_LT(ball.radius, 3.1f);
}

// The string goes from its upper to its lower end, whichever way it hangs, and disappears with the joint.
TEST(RenderFrame, AJointThatTheSceneShowsIsAString) {
    World world;
    BodyDef def;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-3.0, 3.0);
    for (int i = 0; i < 50; ++i) {
        def.position = i == 0 ? Position(0.0, 1.0, 0.0) : Position(place(random), place(random), place(random));
        def.rotation = glm::normalize(Quat(1.0f, float(i % 3), -float(i % 2), 0.3f));
        JointDef joint;
        joint.body_b = world.create_body(def);
        world.add_shape(joint.body_b, Sphere{0.1f});
        joint.frame_a.position = i == 1 ? def.position + Position(0.0, 2.0, 0.0) : Position(0.0, 3.0, 0.0);
        joint.joint = DistanceJoint{};
        const JointAppearance shown{world.create_joint(joint), {0.2f, 0.4f, 0.6f}};
        MeshCache meshes;
        const RenderFrame frame = make_frame(world, {}, {}, {}, meshes, {}, std::span(&shown, 1));
        ASSERT_EQ(frame.cylinders.size(), 1u);
        const Instance& string = frame.cylinders[0];
        const Quat turn(string.rotation.w, string.rotation.x, string.rotation.y, string.rotation.z);
        const Position middle = frame.origin + Position(string.position);
        const Position along(turn * Vec3(0.0f, string.half_size.y, 0.0f));
        EXPECT_LT(glm::distance(middle - along, joint.frame_a.position), 1e-4);
        EXPECT_LT(glm::distance(middle + along, def.position), 1e-4);
        EXPECT_EQ(string.color, shown.color);
        world.destroy_body(joint.body_b);
        EXPECT_TRUE(make_frame(world, {}, {}, {}, meshes, {}, std::span(&shown, 1)).cylinders.empty());
    }
}

} // namespace
