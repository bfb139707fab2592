// Joints in the viewer: on the stage, by keys and mouse, as text, and as strokes.
#include "viewer/controller.h"
#include "viewer/joint_drawing.h"
#include "viewer/joint_info.h"
#include "viewer/palette.h"

#include "test_scene.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace {

using namespace cairn;
using namespace cairn::viewer;

using test::aspect;
constexpr float infinity = std::numeric_limits<float>::infinity();

// A box that hangs 3 m above the ground from a hinge to the world, and swings about z; beside it a free box.
LoadedScene hanging_box(const std::string& path) {
    LoadedScene scene = test::boxes_on_plane(0);
    const BodyId door = scene.world.create_body(test::body_at({0.0, 2.5, 0.0}));
    scene.world.add_shape(door, Box{});
    scene.world.add_shape(scene.world.create_body(test::body_at({3.0, 0.5, 0.0})), Box{});
    HingeJoint hinge;
    hinge.angle.limits = JointRange{-1.0f, 0.5f, {}};
    JointDef def = scene.world.joint_at({}, door, {0.0, 3.0, 0.0}, {0.0f, 0.0f, 1.0f}, hinge);
    def.name = "door";
    if (path == "weak") def.break_force = 50.0f;
    scene.world.create_joint(def);
    return scene;
}

const Ray at_hanging{{0.0, 2.5, 10.0}, {0.0f, 0.0f, -1.0f}};
const Ray at_free{{3.0, 0.5, 10.0}, {0.0f, 0.0f, -1.0f}};
const Ray at_ground{{1.5, 5.0, 0.0}, {0.0f, -1.0f, 0.0f}};
const Ray at_sky{{0.0, 5.0, 0.0}, {0.0f, 1.0f, 0.0f}};

const std::vector<JointLayout>& joints_of(const StageState& state) { return *state.current->joints; }

TEST(StageJoints, AreListedWithTheirStates) {
    Stage stage(hanging_box, "");
    for (int i = 0; i < 30; ++i) stage.step();
    const StageState state = stage.state();
    ASSERT_EQ(joints_of(state).size(), 1u);
    EXPECT_EQ(joints_of(state)[0].def.name, "door");
    EXPECT_FALSE(joints_of(state)[0].body_a);
    EXPECT_EQ(state.layout->bodies.at(joints_of(state)[0].body_b.value()).id, joints_of(state)[0].def.body_b);
    ASSERT_EQ(state.current->joint_states.size(), 1u);
    EXPECT_NEAR(state.current->joint_states[0].force.y, 9810.0f, 200.0f); // carries the weight of one ton
}

TEST(StageJoints, TheDragIsNoJointOfTheSceneAndGoesWithTheRelease) {
    Stage stage(hanging_box, "");
    stage.apply(command::GrabBody{at_free, 1});
    ASSERT_TRUE(stage.state().grab.holding);
    EXPECT_EQ(stage.world().joints().size(), 2u);
    stage.apply(command::MoveGrab{{3.0, 2.0, 0.5}});
    for (int i = 0; i < 60; ++i) stage.step();
    EXPECT_GT(stage.state().current->transforms[2].position.y, 1.5);
    EXPECT_EQ(joints_of(stage.state()).size(), 1u);
    EXPECT_EQ(stage.state().current->joint_states.size(), 1u);
    stage.apply(command::ReleaseGrab{});
    EXPECT_EQ(stage.world().joints().size(), 1u);
    stage.apply(command::GrabBody{at_hanging, 2});
    stage.apply(command::GrabBody{at_hanging, 3}); // the previous release was not reported
    EXPECT_EQ(stage.world().joints().size(), 2u);
    stage.apply(command::ResetScene{});
    EXPECT_EQ(stage.world().joints().size(), 1u);
    stage.step();
    EXPECT_EQ(stage.state().message.text, "");
}

TEST(StageJoints, ADraggedBodyPullsOnItsJoints) {
    Stage stage(hanging_box, "");
    stage.apply(command::GrabBody{at_hanging, 1});
    stage.apply(command::MoveGrab{{1.5, 3.0, 0.5}});
    for (int i = 0; i < 120; ++i) stage.step();
    const JointState door = stage.state().current->joint_states.at(0);
    EXPECT_NEAR(door.positions[0], 0.5f, 0.05f); // at its limit
    EXPECT_LT(door.linear_error, 0.01f);
    EXPECT_GT(door.force.x, -1e6f);
    EXPECT_LT(std::abs(door.force.x), 1e6f); // the force of a drag is bounded
}

TEST(StageJoints, ValuesAreChangedWhileItRuns) {
    Stage stage(hanging_box, "");
    const JointId door = joints_of(stage.state())[0].id;
    HingeJoint hinge;
    hinge.angle.motor = JointMotor{1.0f, 0.0f, {}, infinity};
    stage.apply(command::SetJoint{door, hinge});
    for (int i = 0; i < 60; ++i) stage.step();
    EXPECT_NEAR(stage.state().current->joint_states[0].positions[0], 1.0f, 0.05f);
    const auto& def = joints_of(stage.state())[0].def;
    EXPECT_FALSE(std::get<HingeJoint>(def.joint).angle.limits);
    hinge.angle.limits = JointRange{1.0f, -1.0f, {}};
    stage.apply(command::SetJoint{door, hinge});
    EXPECT_NE(stage.state().message.text.find("lower"), std::string::npos); // rejected with the reason
    EXPECT_FALSE(std::get<HingeJoint>(joints_of(stage.state())[0].def.joint).angle.limits);
}

TEST(StageJoints, SolverAndStrengthAreChangedToo) {
    Stage stage(hanging_box, "");
    const JointId door = joints_of(stage.state())[0].id;
    stage.apply(command::SelectJoint{door});
    stage.apply(command::SetJointSolver{door, JointSolver::iterative});
    const StageState state = stage.state();
    ASSERT_EQ(joints_of(state).size(), 1u);
    EXPECT_EQ(joints_of(state)[0].def.solver, JointSolver::iterative);
    EXPECT_EQ(state.selected_joint, joints_of(state)[0].id); // the joint that replaces the first one
    EXPECT_EQ(joints_of(state)[0].def.name, "door");
    stage.apply(command::SetJointStrength{joints_of(state)[0].id, 100.0f, infinity});
    for (int i = 0; i < 10; ++i) stage.step();
    EXPECT_TRUE(joints_of(stage.state()).empty());
    EXPECT_FALSE(stage.state().selected_joint);
}

TEST(StageJoints, AreDisabledAndEnabledAgain) {
    Stage stage(hanging_box, "");
    const JointId door = joints_of(stage.state())[0].id;
    stage.apply(command::SetJointEnabled{door, false});
    for (int i = 0; i < 30; ++i) stage.step();
    StageState state = stage.state();
    EXPECT_FALSE(joints_of(state)[0].def.enabled);
    const WorldMotion& now = *state.current;
    EXPECT_GT(now.joint_states[0].linear_error, 0.3f);                                  // the body fell
    EXPECT_EQ(joint_color(joints_of(state)[0], now.joint_states[0]), disabled_color()); // no error color
    stage.apply(command::SetJointSolver{door, JointSolver::direct});
    EXPECT_FALSE(joints_of(stage.state())[0].def.enabled);
    stage.apply(command::SetJointEnabled{joints_of(stage.state())[0].id, true});
    for (int i = 0; i < 240; ++i) stage.step();
    EXPECT_LT(stage.state().current->joint_states[0].linear_error, 1e-3f);
}

TEST(StageJoints, ABrokenJointIsReportedByName) {
    Stage stage(hanging_box, "weak");
    for (int i = 0; i < 10; ++i) stage.step();
    const StageState state = stage.state();
    EXPECT_EQ(state.message.text.find("door broke at"), 0u) << state.message.text;
    EXPECT_TRUE(joints_of(state).empty());
    EXPECT_TRUE(state.current->joint_states.empty());
}

TEST(StageJoints, GoWithTheirBodiesAndByCommand) {
    Stage stage(hanging_box, "");
    const JointId door = joints_of(stage.state())[0].id;
    stage.apply(command::SelectJoint{door});
    EXPECT_EQ(stage.state().selected_joint, door);
    stage.apply(command::RemoveJoint{door});
    EXPECT_TRUE(joints_of(stage.state()).empty());
    EXPECT_FALSE(stage.state().selected_joint);
    EXPECT_EQ(stage.state().message.text, "");
    stage.apply(command::RemoveJoint{door});
    EXPECT_NE(stage.state().message.text, "");
    stage.apply(command::ResetScene{});
    stage.apply(command::GrabBody{at_hanging, 1});
    stage.apply(command::RemoveSelected{});
    EXPECT_TRUE(joints_of(stage.state()).empty());
    stage.step();
}

TEST(StageJoints, AreMadeWithTheWorldAndWithTheSelectedBody) {
    Stage stage(hanging_box, "");
    stage.apply(command::MakeJoint{at_free, command::JoinKind::fixed});
    ASSERT_EQ(joints_of(stage.state()).size(), 2u);
    EXPECT_TRUE(joints_of(stage.state())[1].def.body_a.is_null());
    EXPECT_EQ(stage.state().selected_joint, joints_of(stage.state())[1].id);

    stage.apply(command::GrabBody{at_hanging, 1});
    stage.apply(command::ReleaseGrab{true});
    stage.apply(command::MakeJoint{at_free, command::JoinKind::hinge});
    const StageState state = stage.state();
    ASSERT_EQ(joints_of(state).size(), 3u);
    const JointLayout& hinge = joints_of(state)[2];
    EXPECT_EQ(hinge.def.body_a, state.selected);
    EXPECT_EQ(hinge.body_b, 2u);
    const JointFrames frames = frames_of(hinge, state.current->transforms);
    EXPECT_LT(glm::distance(frames.a.position, Position(3.0, 0.5, 0.5)), 1e-4); // where the ray hit the box
    EXPECT_LT(glm::distance(frames.b.position, Position(3.0, 0.5, 0.5)), 1e-4);
    EXPECT_NEAR((frames.a.rotation * Vec3(1.0f, 0.0f, 0.0f)).z, 1.0f, 1e-4f); // about the surface normal

    stage.apply(command::MakeJoint{at_ground, command::JoinKind::ball}); // between the selected body and the ground
    ASSERT_EQ(joints_of(stage.state()).size(), 4u);
    EXPECT_EQ(joints_of(stage.state())[3].def.body_b, state.selected);
    EXPECT_EQ(joints_of(stage.state())[3].body_a, 0u);
}

TEST(StageJoints, NothingToJoinLeavesAMessage) {
    Stage stage(hanging_box, "");
    for (const Ray& ray : {at_ground, at_sky}) {
        const std::uint64_t before = stage.state().message.serial;
        stage.apply(command::MakeJoint{ray, command::JoinKind::ball});
        EXPECT_EQ(stage.state().message.serial, before + 1);
        EXPECT_EQ(joints_of(stage.state()).size(), 1u);
    }
}

TEST(StageJoints, ShowAsOneIsland) {
    Stage stage(test::load_boxes, "2");
    stage.apply(command::ShowIslands{true});
    EXPECT_NE(stage.state().current->islands[1], stage.state().current->islands[2]);
    stage.apply(command::GrabBody{{{0.0, 0.6, 10.0}, {0.0f, 0.0f, -1.0f}}, 1});
    stage.apply(command::ReleaseGrab{true});
    stage.apply(command::MakeJoint{{{2.0, 0.6, 10.0}, {0.0f, 0.0f, -1.0f}}, command::JoinKind::ball});
    EXPECT_EQ(stage.state().current->islands[1], stage.state().current->islands[2]);
}

struct JointDesk {
    Stage stage{hanging_box, ""};
    Controller controller{[this](Command command) { stage.apply(command); }, {}};
    JointDesk() { controller.update(stage.state()); }
    void click(const Position& point) {
        controller.move_cursor(*controller.camera.project(point, aspect), aspect);
        controller.button_down(MouseButton::left);
        controller.update(stage.state());
        controller.button_up(MouseButton::left);
        controller.update(stage.state());
    }
};

TEST(ControllerJoints, AClickOnAnAnchorSelectsTheJoint) {
    JointDesk desk;
    desk.click({0.0, 3.0, 0.0}); // its joint is not drawn yet
    EXPECT_FALSE(desk.stage.state().selected_joint);
    desk.click({0.0, 2.5, 0.5}); // the body
    EXPECT_TRUE(desk.stage.state().selected);
    desk.click({0.0, 3.0, 0.0});
    EXPECT_EQ(desk.stage.state().selected_joint, joints_of(desk.stage.state())[0].id);
    desk.click({-3.0, 4.5, 0.0}); // no body there
    EXPECT_FALSE(desk.stage.state().selected_joint);
    desk.controller.key_down("", "T"); // draws all joints
    desk.click({0.0, 3.0, 0.0});
    EXPECT_TRUE(desk.stage.state().selected_joint);
    desk.click({-3.0, 4.5, 0.0});
    desk.controller.key_down("", "T"); // joints that are not drawn cannot be picked
    desk.click({0.0, 3.0, 0.0});
    EXPECT_FALSE(desk.stage.state().selected_joint);
}

TEST(ControllerJoints, KeysMakeRemoveAndHide) {
    JointDesk desk;
    desk.click({3.0, 0.5, 0.5});
    desk.controller.key_down("", "B");
    EXPECT_EQ(name_of(joints_of(desk.stage.state()).back().def.joint), std::string("ball"));
    desk.controller.key_down("", "Y");
    EXPECT_EQ(name_of(joints_of(desk.stage.state()).back().def.joint), std::string("hinge"));
    desk.controller.key_down("", "W");
    EXPECT_EQ(name_of(joints_of(desk.stage.state()).back().def.joint), std::string("fixed"));
    EXPECT_EQ(joints_of(desk.stage.state()).size(), 4u);
    desk.controller.update(desk.stage.state());
    desk.controller.key_down("", "D");
    EXPECT_EQ(joints_of(desk.stage.state()).size(), 3u);
    for (const JointsShown shown : {JointsShown::some, JointsShown::all, JointsShown::none, JointsShown::some}) {
        EXPECT_EQ(desk.controller.frame_options(desk.stage.state()).joints, shown);
        desk.controller.key_down("", "T");
    }
}

// One joint of every kind between two bodies at a distance from each other.
std::vector<Joint> all_kinds() {
    GeneralJoint general;
    general.limits.push_back({JointAxis::linear, {true, true, true}, 0.0f, 0.0f, {}, 0.0f});
    general.limits.push_back({JointAxis::angular, {true, false, false}, -0.5f, 0.5f, {}, 0.0f});
    general.limits.push_back({JointAxis::angular, {false, true, true}, {}, 0.7f, {}, 0.0f});
    general.drives.push_back({JointAxis::angular, false, 0, {}, 0.2f, 0.0f, 10.0f, 1.0f});
    BallJoint ball{0.5f, JointRange{-0.3f, 0.3f, {}}, 0.0f};
    WheelJoint wheel;
    wheel.steering = JointControl{};
    return {FixedJoint{},
            ball,
            HingeJoint{},
            SliderJoint{},
            CylindricalJoint{},
            UniversalJoint{},
            DistanceJoint{},
            wheel,
            ServoJoint{},
            GearJoint{},
            RackJoint{},
            PulleyJoint{{0.0, 5.0, 0.0}, {2.0, 5.0, 0.0}, 1.0f, {}},
            general};
}

struct Pair {
    World world;
    BodyId a, b;
    Pair() {
        a = world.create_body(test::body_at({0.0, 2.0, 0.0}));
        b = world.create_body(test::body_at({2.0, 2.0, 0.0}));
        for (const BodyId body : {a, b}) world.add_shape(body, Box{});
    }
    JointId join(const Joint& joint) {
        return world.create_joint(world.joint_at(a, b, {1.0, 2.0, 0.0}, {0.0f, 0.0f, 1.0f}, joint));
    }
    RenderFrame frame(JointId selected = {}) const {
        FrameOptions options;
        options.joints = JointsShown::all;
        options.selected_joint = selected;
        return make_frame(world, {}, {{1.0, 3.0, 8.0}, {1.0, 2.0, 0.0}}, options);
    }
};

TEST(JointInfo, NamesEveryPositionOfEveryKind) {
    std::set<std::string> names;
    for (const Joint& joint : all_kinds()) {
        Pair pair;
        const JointState state = pair.world.joint_state(pair.join(joint));
        EXPECT_EQ(joint_positions(joint).size(), std::size_t(state.position_count)) << name_of(joint);
        names.insert(name_of(joint));
    }
    EXPECT_EQ(names.size(), std::variant_size_v<Joint>);
}

TEST(JointInfo, DrivesShareThePositionOfTheirLimit) {
    GeneralJoint slider;
    slider.limits.push_back({JointAxis::linear, {true, false, false}, -1.0f, 1.0f, {}, 0.0f});
    slider.limits.push_back({JointAxis::linear, {false, true, true}, 0.0f, 0.0f, {}, 0.0f});
    slider.limits.push_back({JointAxis::angular, {false, true, true}, 0.0f, 0.0f, {}, 0.0f});
    slider.limits.push_back({JointAxis::angular, {true, false, false}, -1.0f, 1.0f, {}, 0.0f});
    slider.drives.push_back({JointAxis::linear, false, 0, {}, 0.0f, 1.0f, 0.0f, 10.0f});
    slider.drives.push_back({JointAxis::linear, false, 1, {}, 0.0f, 1.0f, 0.0f, 10.0f});
    slider.drives.push_back({JointAxis::angular, false, 0, {}, 0.0f, 1.0f, 0.0f, 10.0f});
    Pair pair;
    const JointState state = pair.world.joint_state(pair.join(slider));
    const auto positions = joint_positions(slider);
    ASSERT_EQ(positions.size(), std::size_t(state.position_count));
    EXPECT_EQ(positions.size(), 3u);
}

TEST(JointInfo, SpringsKeepTheirFrequencyAndDamping) {
    for (const float hertz : {0.1f, 2.0f, 60.0f}) {
        const Swing swing = swing_of(JointSpring::from_frequency(hertz, 0.7f));
        EXPECT_NEAR(swing.hertz, hertz, 1e-4f * hertz);
        EXPECT_NEAR(swing.damping_ratio, 0.7f, 1e-4f);
    }
    EXPECT_EQ(swing_of({0.0f, 3.0f, true}).damping_ratio, 0.0f);
}

TEST(JointInfo, AxesChangeTheJointTheyCameFrom) {
    Joint joint = WheelJoint{};
    EXPECT_EQ(joint_axes(joint).size(), 2u);
    std::get<WheelJoint>(joint).steering = JointControl{};
    const auto axes = joint_axes(joint);
    ASSERT_EQ(axes.size(), 3u);
    axes[2].control->friction = 3.0f;
    EXPECT_EQ(std::get<WheelJoint>(joint).spin.friction, 3.0f);
}

TEST(JointDrawing, EveryKindIsDrawnNearItsBodies) {
    for (const Joint& joint : all_kinds()) {
        Pair pair;
        const JointId id = pair.join(joint);
        const RenderFrame frame = pair.frame();
        EXPECT_GE(frame.strokes.size(), 4u) << name_of(joint);
        for (const Stroke& stroke : frame.strokes)
            for (const Vec3& end : {stroke.from, stroke.to}) {
                const Position at = frame.origin + Position(end);
                EXPECT_LT(glm::distance(at, Position(1.0, 2.0, 0.0)), 3.5) << name_of(joint); // also excludes NaN
            }
        // The selected joint stands out.
        const RenderFrame selected = pair.frame(id);
        EXPECT_EQ(selected.strokes[0].color, Vec3(1.0f)) << name_of(joint);
        EXPECT_GT(selected.strokes[0].width, frame.strokes[0].width) << name_of(joint);
    }
}

TEST(JointDrawing, IsAbsentUnlessAskedFor) {
    Pair pair;
    pair.join(HingeJoint{});
    const RenderFrame frame = make_frame(pair.world, {}, {});
    EXPECT_TRUE(frame.strokes.empty() && frame.veils.empty());
}

TEST(JointDrawing, OnlyWhatIsSelectedOrLoadedIsDrawnUnlessAllAreAskedFor) {
    Stage stage(hanging_box, "");
    for (int i = 0; i < 10; ++i) stage.step();
    StageState state = stage.state();
    FrameOptions options;
    const auto is_drawn = [&] {
        const RenderFrame frame =
            make_frame(*state.layout, *state.current, *state.current, 1.0f, state.scene_camera, options);
        return std::any_of(frame.strokes.begin(), frame.strokes.end(),
                           [](const Stroke& stroke) { return stroke.color != selection_color(); });
    };
    options.joints = JointsShown::some;
    EXPECT_FALSE(is_drawn());                      // it carries an ordinary load
    options.selected = state.layout->bodies[2].id; // the free box
    EXPECT_FALSE(is_drawn());
    options.selected = state.layout->bodies[1].id;
    EXPECT_TRUE(is_drawn());
    options.selected = {};
    options.selected_joint = joints_of(state)[0].id;
    EXPECT_TRUE(is_drawn());
    options.selected_joint = {};
    const float weight = glm::length(state.current->joint_states[0].force);
    stage.apply(command::SetJointStrength{joints_of(state)[0].id, 4.0f * weight, infinity});
    state = stage.state();
    EXPECT_FALSE(is_drawn());
    stage.apply(command::SetJointStrength{joints_of(state)[0].id, 1.5f * weight, infinity});
    state = stage.state();
    EXPECT_TRUE(is_drawn()); // near its breaking force
    options.joints = JointsShown::none;
    EXPECT_FALSE(is_drawn());
    stage.apply(command::SetJointStrength{joints_of(state)[0].id, infinity, infinity});
    state = stage.state();
    options.joints = JointsShown::all;
    EXPECT_TRUE(is_drawn());
}

TEST(JointDrawing, AHingesSectorReachesFromLimitToLimit) {
    Pair pair;
    HingeJoint hinge;
    hinge.angle.limits = JointRange{-0.4f, 1.1f, {}};
    const JointId id = pair.join(hinge);
    const RenderFrame frame = pair.frame();
    ASSERT_FALSE(frame.veils.empty());
    // Angles of the rim as the engine measures them: those of frame B's y axis about A's x axis.
    const JointDef& def = pair.world.joint_def(id);
    const Quat a = pair.world.body(pair.a).rotation() * def.frame_a.rotation;
    float least = infinity, greatest = -infinity;
    for (const Veil& veil : frame.veils)
        for (const Vec3& rim : {veil.b, veil.c}) {
            const Vec3 arm = glm::inverse(a) * (rim - veil.a);
            const float angle = std::atan2(arm.z, arm.y);
            least = std::min(least, angle);
            greatest = std::max(greatest, angle);
        }
    EXPECT_NEAR(least, -0.4f, 1e-3f);
    EXPECT_NEAR(greatest, 1.1f, 1e-3f);
}

TEST(JointDrawing, ColorsTellLoadAndError) {
    JointLayout joint;
    JointState state;
    state.force = {0.0f, 80.0f, 0.0f};
    EXPECT_EQ(joint_color(joint, state), joint_ramp(0.0f)); // the joint cannot break
    joint.def.break_force = 100.0f;
    EXPECT_EQ(joint_color(joint, state), joint_ramp(0.8f));
    state.linear_error = 0.2f;
    EXPECT_EQ(joint_color(joint, state), joint_error_color());
    state.linear_error = 0.0f;
    state.angular_error = 0.3f;
    EXPECT_EQ(joint_color(joint, state), joint_error_color());
}

TEST(JointDrawing, BandsHaveTheirWidthInPixels) {
    StrokeView view{Vec3(0.0f), {0.0f, 0.0f, -1.0f}, 0.001f, {}};
    const Stroke line{{-1.0f, 0.0f, -5.0f}, {1.0f, 0.0f, -5.0f}, Vec3(1.0f), 4.0f};
    std::vector<Vec3> band;
    add_band(band, line, view);
    ASSERT_EQ(band.size(), 6u);
    EXPECT_NEAR(glm::distance(band[0], band[1]), 4.0f * view.pixel * 5.0f, 1e-5f);
    band.clear();
    add_band(band, {{0.0f, 0.0f, -5.0f}, {0.0f, 0.0f, -5.0f}, Vec3(1.0f), 6.0f}, view);
    for (const Vec3& corner : band)
        EXPECT_LE(glm::distance(corner, Vec3(0.0f, 0.0f, -5.0f)), 3.01f * view.pixel * 5.0f);
    EXPECT_FALSE(band.empty());
    view.parallel_distance = 20.0f; // at any depth, also behind the eye
    for (const float z : {0.0f, 10.0f}) {
        band.clear();
        add_band(band, {line.from + Vec3(0.0f, 0.0f, z), line.to + Vec3(0.0f, 0.0f, z), Vec3(1.0f), 4.0f}, view);
        ASSERT_EQ(band.size(), 6u);
        EXPECT_NEAR(glm::distance(band[0], band[1]), 4.0f * view.pixel * 20.0f, 1e-5f);
        EXPECT_FLOAT_EQ(band[0].z, band[1].z);
    }
}

} // namespace
