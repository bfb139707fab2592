// Unsupported requests, and errors with only one plausible meaning: the file is loaded, and a warning says how.
#include "scene_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;

std::string motion(const std::string& members) { return node("", "\"motion\":{" + members + "}," + box); }

bool warns(const Scene& scene, const std::string& text) {
    return std::any_of(scene.warnings.begin(), scene.warnings.end(),
                       [&](const std::string& warning) { return warning.find(text) != std::string::npos; });
}
std::string all(const Scene& scene) {
    std::string text;
    for (const std::string& warning : scene.warnings) text += warning + "\n";
    return text;
}

TEST(SceneWarnings, AFileWithoutPhysicsSaysSo) {
    const char* text = R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"name":"looks"}]})";
    const Scene scene = load_text(text);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("test.gltf: has no body"), std::string::npos) << scene.warnings[0];
    EXPECT_TRUE(warns(load_text(R"({"asset":{"version":"2.0"}})"), "has no body"));
}

TEST(SceneWarnings, MisspelledMembersAreNamedWithTheNearestKnownOne) {
    const std::string at = "extensions.KHR_physics_rigid_bodies";
    const auto expect = [](const Scene& scene, const std::string& where, const std::string& given,
                           const std::string& meant) {
        ASSERT_EQ(scene.warnings.size(), 1u) << all(scene);
        EXPECT_EQ(scene.warnings[0], "test.gltf: " + where + ": the member \"" + given +
                                         "\" is not known and has no effect; did you mean \"" + meant + "\"?");
    };
    expect(load_nodes(motion(R"("gravity_factor":0)")), "nodes[0]." + at + ".motion", "gravity_factor",
           "gravityFactor");
    expect(load_nodes(motion(R"("Mass":3)")), "nodes[0]." + at + ".motion", "Mass", "mass");
    expect(load_nodes(node("", box + R"(,"motoin":{})")), "nodes[0]." + at, "motoin", "motion");
    expect(load_nodes(node("", R"("collider":{"geometry":{"shape":1},"physicMaterial":0})")),
           "nodes[0]." + at + ".collider", "physicMaterial", "physicsMaterial");
    expect(load_nodes(node(R"("extras":{"cairn_colour":[1,0,0],"mine":1},)", box)), "nodes[0].extras", "cairn_colour",
           "cairn_color");
    Parts parts;
    parts.nodes = node("", box);
    parts.shapes = R"({"type":"sphere","sphere":{"radus":2}},{"type":"box"})";
    expect(load_text(document(parts)), "extensions.KHR_implicit_shapes.shapes[0].sphere", "radus", "radius");
    parts = {};
    parts.nodes = node("", box);
    parts.materials = R"({"extensions":{"CAIRN_material":{"densty":7}}})";
    expect(load_text(document(parts)), at + ".physicsMaterials[0].extensions.CAIRN_material", "densty", "density");
    parts.materials = "";
    parts.world = R"("camera":{"position":[1,1,1],"target":[0,0,0],"fov":40})";
    EXPECT_EQ(load_text(document(parts)).warnings.at(0),
              "test.gltf: scenes[0].extensions.CAIRN_world.camera: the member \"fov\" is not known and has no effect; "
              "known are position, target, vertical_fov_degrees, orthographic");
}

TEST(SceneWarnings, MisspelledMembersOfJointsAreThoseOfTheirType) {
    const auto joint = [](const std::string& own) {
        return load_text(R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0,1]}],"nodes":[)" +
                         node("\"children\":[2],", "\"motion\":{}," + sphere) + "," +
                         node("", R"("joint":{"joint":0,"connectedNode":2})") +
                         R"(,{}],"extensions":{"KHR_implicit_shapes":{"shapes":[{"type":"sphere"}]},)"
                         R"("KHR_physics_rigid_bodies":{"physicsJoints":[{"extensions":{"CAIRN_joint":{)" +
                         own + "}}}]}}}");
    };
    EXPECT_TRUE(
        joint(R"("type":"hinge","angle":{"limits":{"lower":0},"motor":{"spring":{"stiffness":1}}})").warnings.empty());
    EXPECT_TRUE(warns(joint(R"("type":"hinge","angle":{"limit":{"lower":0}})"), "did you mean \"limits\"?"));
    EXPECT_TRUE(warns(joint(R"("type":"hinge","angle":{"motor":{"spring":{"stifness":1}}})"), "\"stiffness\"?"));
    EXPECT_TRUE(warns(joint(R"("type":"slider","angle":{})"), "the member \"angle\" is not known"));
    EXPECT_TRUE(warns(joint(R"("type":"ball","cone":1,"break_fource":3)"), "did you mean \"break_force\"?"));
}

TEST(SceneWarnings, MisspelledExtensionsAreNamed) {
    const Scene scene = load_nodes(R"({"extensions":{"KHR_physics_rigid_body":{"motion":{}},"EXT_other":{}}})");
    ASSERT_EQ(scene.warnings.size(), 1u) << all(scene);
    EXPECT_EQ(scene.warnings[0],
              "test.gltf: nodes[0].extensions: the extension \"KHR_physics_rigid_body\" is not known "
              "and has no effect; did you mean \"KHR_physics_rigid_bodies\"?");
}

TEST(SceneWarnings, OfMillionsOfMistakesSomeAreTold) {
    std::string members = "\"mass\":1";
    for (int i = 0; i < 100000; ++i) members += ",\"m" + std::to_string(i) + "\":0";
    EXPECT_LE(load_nodes(motion(members)).warnings.size(), 101u);
}

TEST(SceneWarnings, ASpeedThatIsCutSaysSo) {
    const Scene scene = load_nodes(motion(R"("linearVelocity":[0,3000,0],"angularVelocity":[0,0,-999])"));
    ASSERT_EQ(scene.warnings.size(), 1u) << all(scene);
    EXPECT_NE(scene.warnings[0].find("linearVelocity is reduced to the world's limit of 2000 m/s"), std::string::npos);
    EXPECT_TRUE(warns(load_nodes(motion(R"("angularVelocity":[0,0,-2000])")), "limit of 1000 rad/s"));
}

TEST(SceneWarnings, AnInertiaThatNoBodyHasBecomesTheNearestOne) {
    const Scene scene = load_nodes(motion(R"("mass":2,"inertiaDiagonal":[1,2,6])"));
    ASSERT_EQ(scene.warnings.size(), 1u) << all(scene);
    EXPECT_NE(scene.warnings[0].find("the nearest possible moments are used: 2, 3, 5"), std::string::npos)
        << scene.warnings[0];
    const Vec3 moments = scene.world.body(scene.world.bodies().at(0)).mass_properties().inertia_diagonal;
    for (int i = 0; i < 3; ++i) EXPECT_FLOAT_EQ(moments[i], Vec3(2, 3, 5)[i]);
    for (const char* possible : {"[1,2,3]", "[1,2,0]", "[0,0,0]", "[1,2,3.00001]", "[5,5,5]"}) {
        EXPECT_TRUE(load_nodes(motion(R"("mass":2,"inertiaDiagonal":)" + std::string(possible))).warnings.empty());
    }
    EXPECT_EQ(load_nodes(motion(R"("mass":2,"inertiaDiagonal":[1e-30,1e-30,1])")).warnings.size(), 1u);
    EXPECT_EQ(load_nodes(motion(R"("mass":2,"inertiaDiagonal":[1e-30,1e38,3e38])")).warnings.size(), 1u);
}

TEST(SceneWarnings, AnInertiaOfARobotToo) {
    const std::string robot = R"(<robot name="r"><link name="a"><inertial><mass value="1"/>)"
                              R"(<inertia ixx="1" ixy="0" ixz="0" iyy="6" iyz="0" izz="2"/></inertial></link></robot>)";
    const Scene scene = load_text(robot, "r.urdf");
    EXPECT_TRUE(warns(scene, "the nearest possible moments are used")) << all(scene);
    const Mat3 inertia = scene.world.body(scene.world.bodies().at(0)).world_inertia();
    const Vec3 found(inertia[0][0], inertia[1][1], inertia[2][2]); // the robot's z axis is the world's y axis
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], Vec3(2, 3, 5)[i], 1e-5f);
}

// Node 0 is the ball, with the frame in node 1; node 2 has a non-uniform scale, and its rotated child, node 3, is the
// frame in the world.
std::string skewed_joint(const std::string& scale) {
    return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0,2],"extensions":{"CAIRN_world":{}}}],"nodes":[)" +
           node(R"("name":"ball","translation":[0,6,0],"children":[1],)", "\"motion\":{}," + sphere) +
           R"(,{},{"scale":)" + scale + R"(,"children":[3]},)" +
           node(R"("translation":[1,2,0],"rotation":[0,0,0.38268343,0.92387953],)",
                R"("joint":{"joint":0,"connectedNode":1})") +
           R"(],"extensions":{"KHR_implicit_shapes":{"shapes":[{"type":"sphere"}]},"KHR_physics_rigid_bodies":{)"
           R"("physicsJoints":[{"limits":[{"linearAxes":[0,1,2],"max":9}]}]}}})";
}

TEST(SceneWarnings, AJointsFrameUnderAnUnevenScaleHasNoShapeToBend) {
    const Scene scene = load_text(skewed_joint("[1,3,1]"));
    ASSERT_EQ(scene.warnings.size(), 1u) << all(scene);
    EXPECT_NE(scene.warnings[0].find("nodes[3]: is the frame of a joint below a nonuniform scale"), std::string::npos);
    ASSERT_EQ(scene.world.joints().size(), 1u);
    const Transform frame = scene.world.joint_def(scene.world.joints()[0]).frame_a;
    EXPECT_EQ(frame.position, Position(1, 6, 0));
    const Vec3 x = frame.rotation * Vec3(1, 0, 0);
    EXPECT_NEAR(x.x, 1 / std::sqrt(10.0), 1e-6);
    EXPECT_NEAR(x.y, 3 / std::sqrt(10.0), 1e-6);
    EXPECT_THROW(load_text(skewed_joint("[1,0,1]")), Error); // flattened, so that two of its axes coincide
}

TEST(SceneWarnings, SuchAFrameMayStandOnABodyThatIsTurned) {
    const std::string text =
        R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0,3],"extensions":{"CAIRN_world":{}}}],"nodes":[)" +
        node(R"("translation":[5,0,0],"rotation":[0,0,0.70710678,0.70710678],"children":[1],)",
             "\"motion\":{}," + sphere) +
        R"(,{"scale":[2,1,1],"children":[2]},)" +
        node(R"("translation":[1,1,0],"rotation":[0,0,0.38268343,0.92387953],)",
             R"("joint":{"joint":0,"connectedNode":3})") +
        R"(,{}],"extensions":{"KHR_implicit_shapes":{"shapes":[{"type":"sphere"}]},"KHR_physics_rigid_bodies":{)"
        R"("physicsJoints":[{"limits":[{"linearAxes":[0,1,2],"max":9}]}]}}})";
    const Scene scene = load_text(text);
    ASSERT_EQ(scene.world.joints().size(), 1u) << all(scene);
    // In body coordinates: not rotated with the body.
    const Transform frame = scene.world.joint_def(scene.world.joints()[0]).frame_a;
    EXPECT_NEAR(frame.position.x, 2, 1e-6);
    EXPECT_NEAR(frame.position.y, 1, 1e-6);
    const Vec3 x = frame.rotation * Vec3(1, 0, 0);
    EXPECT_NEAR(x.x, 2 / std::sqrt(5.0), 1e-6);
    EXPECT_NEAR(x.y, 1 / std::sqrt(5.0), 1e-6);
}

} // namespace
