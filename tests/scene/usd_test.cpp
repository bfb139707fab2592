// Worlds in USD text layers.
#include "scene_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;

Scene load_usd(const std::string& prims, const std::string& metadata = "metersPerUnit = 1\n upAxis = \"Z\"") {
    std::string text = "#usda 1.0\n(\n ";
    text.append(metadata).append("\n)\n").append(prims);
    return load_text(text, "test.usda");
}
const std::string rigid = R"((prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsCollisionAPI"]))";

TEST(Usd, TransformsAndUnitsAreTakenInTheirOrder) {
    Scene scene = load_usd(R"(def Xform "World" {
        double3 xformOp:translate = (100, 0, 0)
        float xformOp:rotateZ:turn = 90
        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateZ:turn"]
        def Cube "box" )" + rigid +
                               R"( {
            double size = 50
            float3 xformOp:scale = (1, 2, 3)
            double3 xformOp:translate = (0, 0, 10)
            quatf xformOp:orient = (1, 0, 0, 0)
            uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:orient", "xformOp:scale"]
        }
        def Sphere "reset" )" + rigid +
                               R"( {
            matrix4d xformOp:transform = ((2, 0, 0, 0), (0, 2, 0, 0), (0, 0, 2, 0), (300, 0, 0, 1))
            uniform token[] xformOpOrder = ["!resetXformStack!", "xformOp:transform"]
            double radius = 25
        } })",
                           "metersPerUnit = 0.01\n upAxis = \"Z\"");
    expect_near(body(scene, "box").position(), seen({1, 0, 0.1}));
    const Bounds box = scene.world.shape_bounds(body(scene, "box").shapes().at(0));
    expect_near(box.max - box.min, glm::abs(seen({1.0, 0.5, 1.5})), 1e-4); // rotated: its y axis is along x
    EXPECT_NEAR(body(scene, "box").mass(), 1000.0f * 0.75f, 0.1f);
    expect_near(body(scene, "reset").position(), seen({3, 0, 0}));
    const Bounds ball = scene.world.shape_bounds(body(scene, "reset").shapes().at(0));
    EXPECT_NEAR(ball.max.y - ball.min.y, 1.0, 1e-5);
}

TEST(Usd, MassGravityAndSpeedAreThoseOfTheFile) {
    Scene scene = load_usd(R"(def PhysicsScene "scene" {
            vector3f physics:gravityDirection = (1, 0, 0)
            float physics:gravityMagnitude = 3
        }
        def Cube "a" (prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsCollisionAPI", "PhysicsMassAPI"]) {
            float physics:mass = 5
            point3f physics:centerOfMass = (0.5, 0, 0)
            float3 physics:diagonalInertia = (1, 2, 2.5)
            vector3f physics:velocity = (0, 2, 0)
            vector3f physics:angularVelocity = (0, 0, 90)
        }
        def Cube "b" (prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsCollisionAPI", "PhysicsMassAPI"]) {
            double size = 1
            float physics:density = 70
            double3 xformOp:translate = (9, 0, 0)
            uniform token[] xformOpOrder = ["xformOp:translate"]
        })");
    EXPECT_LT(glm::length(scene.world.settings().gravity - Vec3(3.0f, 0.0f, 0.0f)), 1e-5f);
    const MassProperties a = body(scene, "a").mass_properties();
    EXPECT_FLOAT_EQ(a.mass, 5.0f);
    EXPECT_FLOAT_EQ(a.center_of_mass.x, 0.5f);
    EXPECT_NEAR(a.inertia_diagonal.z, 2.5f, 1e-6f);
    EXPECT_NEAR(body(scene, "b").mass(), 70.0f, 1e-3f);
    EXPECT_NEAR(body(scene, "a").angular_velocity().y, std::acos(-1.0f) / 2.0f, 1e-5f);
    expect_near(glm::dvec3(body(scene, "a").velocity_at(body(scene, "a").position())), seen({0, 2, 0}));
}

TEST(Usd, JointsHaveTheirFramesLimitsAndDrives) {
    Scene scene = load_usd(R"(def Xform "w" {
        def Cube "a" )" + rigid +
                           R"( {}
        def Cube "b" )" + rigid +
                           R"( { double3 xformOp:translate = (0, 0, 3)
            uniform token[] xformOpOrder = ["xformOp:translate"] }
        def PhysicsFixedJoint "f" { rel physics:body1 = </w/a> }
        def PhysicsRevoluteJoint "j" (prepend apiSchemas = ["PhysicsDriveAPI:angular"]) {
            rel physics:body0 = </w/a>
            rel physics:body1 = </w/b>
            uniform token physics:axis = "Y"
            point3f physics:localPos0 = (0, 0, 1)
            point3f physics:localPos1 = (0, 0, -2)
            float physics:lowerLimit = -90
            float physics:upperLimit = 45
            float drive:angular:physics:stiffness = 1e6
            float drive:angular:physics:damping = 1e5
            float drive:angular:physics:targetPosition = 30
        } })");
    const JointId id = scene.world.find_joint("j").value();
    const HingeJoint hinge = std::get<HingeJoint>(scene.world.joint_def(id).joint);
    const float degree = std::acos(-1.0f) / 180.0f;
    EXPECT_FLOAT_EQ(hinge.angle.limits->lower, -90.0f * degree);
    EXPECT_FLOAT_EQ(hinge.angle.limits->upper, 45.0f * degree);
    EXPECT_NEAR(hinge.angle.motor->spring->stiffness, 1e6f / degree, 100.0f);
    run(scene, 4.0);
    EXPECT_NEAR(scene.world.joint_state(id).positions[0], 30.0f * degree, 0.01f);
    // Rotated by 30 degrees about y, and therefore leaning towards x.
    expect_near(body(scene, "b").position(), seen({2.0 * std::sin(0.5236), 0.0, 1.0 + 2.0 * std::cos(0.5236)}), 0.03);
}

TEST(Usd, MeshesAreTrianglesWhereTheyStandAndHullsWhereTheyMove) {
    const std::string dent = R"( { int[] faceVertexCounts = [4, 4, 4, 4, 4, 3, 3, 3, 3]
        int[] faceVertexIndices = [0, 3, 2, 1, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7,
                                  4, 5, 8, 5, 6, 8, 6, 7, 8, 7, 4, 8]
        point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1),
                            (0.5, 0.5, 0.5)]
    })";
    Scene scene = load_usd("def Mesh \"moves\" " + rigid + dent +
                           "def Mesh \"stands\" (prepend apiSchemas = "
                           "[\"PhysicsCollisionAPI\"])" +
                           dent + "def Mesh \"looks\" " + dent);
    EXPECT_TRUE(std::holds_alternative<Hull>(scene.world.shape(body(scene, "moves").shapes().at(0))));
    EXPECT_NEAR(body(scene, "moves").mass(), 1000.0 * 5.0 / 6.0, 0.1); // the enclosed volume, not that of the hull
    EXPECT_TRUE(std::holds_alternative<Mesh>(scene.world.shape(body(scene, "stands").shapes().at(0))));
    EXPECT_EQ(scene.world.bodies().size(), 2u);
    EXPECT_EQ(scene.visuals.size(), 1u); // a visual without a body
}

TEST(Usd, GroupsAndPairsThatAreFilteredDoNotTouch) {
    const auto parted = [](const std::string& more, const std::string& schemas, const std::string& of_a) {
        Scene scene =
            load_usd("def PhysicsScene \"s\" { float physics:gravityMagnitude = 0 }\n"
                     "def Sphere \"a\" (prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsCollisionAPI\"" +
                     schemas + "]) { double radius = 0.5\n" + of_a + "}\ndef Sphere \"b\" " + rigid +
                     " { double radius = 0.5\n double3 xformOp:translate = (0.9, 0, 0)\n"
                     " uniform token[] xformOpOrder = [\"xformOp:translate\"] }\n" +
                     more);
        run(scene, 1.0);
        return body(scene, "b").position().x - body(scene, "a").position().x > 0.95;
    };
    EXPECT_TRUE(parted("", "", ""));
    EXPECT_FALSE(parted("", ", \"PhysicsFilteredPairsAPI\"", "rel physics:filteredPairs = [</b>]\n"));
    const auto groups = [](const std::string& filtered) {
        return "def PhysicsCollisionGroup \"g\" (prepend apiSchemas = [\"CollectionAPI:colliders\"]) {\n"
               "prepend rel collection:colliders:includes = </a>\n prepend rel physics:filteredGroups = " +
               filtered +
               " }\ndef PhysicsCollisionGroup \"h\" (prepend apiSchemas = [\"CollectionAPI:colliders\"]) {\n"
               "prepend rel collection:colliders:includes = </b> }\n";
    };
    EXPECT_FALSE(parted(groups("</h>"), "", ""));
    EXPECT_TRUE(parted(groups("</g>"), "", ""));
}

TEST(Usd, OtherFilesOfUsdAreNamed) {
    for (const auto& [text, part] : {std::pair<std::string, std::string>("PXR-USDC....", "usdcat"),
                                     std::pair<std::string, std::string>("PK\x03\x04....", "a package of USD")}) {
        try {
            load_text(text, "scene.usd");
            FAIL() << text;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::unsupported);
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    }
}

TEST(Usd, WhatIsNotFollowedIsNamed) {
    const Scene scene =
        load_usd("def Xform \"x\" (references = @other.usda@</a>) { variantSet \"v\" = { \"one\" { } }\n"
                 " float physics:nonsense = 1 }\ndef Cube \"c\" " +
                 rigid + " {}");
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "test.usda: has no effect here: physics:nonsense, references, variantSet");
}

TEST(Usd, MistakesNameTheLineThePrimAndTheValue) {
    struct Case {
        const char* prims;
        const char* message;
    };
    for (const Case& c : {
             Case{"def Cube \"c\" {", "test.usda:6: must have } before it ends"},
             Case{"def Cube \"c\" {}}", "test.usda:6: must be def, over or class"},
             Case{"def Sphere \"c\" (prepend apiSchemas = [\"PhysicsCollisionAPI\"]) { double radius = -1 }",
                  "test.usda:6: Sphere </c>: radius: must be from 0.000000 to 1000000000.000000, got -1.000000"},
             Case{"def Sphere \"c\" { double radius = nan }", "test.usda:6: must be a number, got \"nan\""},
             Case{"def PhysicsFixedJoint \"j\" { rel physics:body0 = </none> }",
                  "PhysicsFixedJoint </j>: physics:body0: must be the path of a prim of this layer, got </none>"},
             Case{"def Xform \"x\" { double3 xformOp:translate = (1, 2)\n uniform token[] xformOpOrder = "
                  "[\"xformOp:translate\"] }",
                  "Xform </x>: xformOp:translate: must have 3 numbers, got 1.000000, 2.000000"},
         }) {
        SCOPED_TRACE(c.prims);
        try {
            load_usd(c.prims);
            ADD_FAILURE() << "was read";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(c.message), std::string::npos) << error.what();
        }
    }
}

TEST(Usd, WhatIsSavedAsGltfFallsTheSame) {
    Scene scene = load_usd("def Cube \"c\" " + rigid +
                           " { double3 xformOp:translate = (0, 0, 4)\n"
                           " float3 xformOp:rotateXYZ = (10, 20, 30)\n uniform token[] xformOpOrder = "
                           "[\"xformOp:translate\", \"xformOp:rotateXYZ\"] }\n"
                           "def Plane \"ground\" (prepend apiSchemas = [\"PhysicsCollisionAPI\"]) {}");
    const std::string saved = scene::save_to_string(scene);
    Scene again = load_text(saved);
    EXPECT_EQ(scene::save_to_string(again), saved);
    run(scene, 3.0);
    run(again, 3.0);
    EXPECT_NEAR(body(scene, "c").position().y, 1.0, 1e-3);
    expect_near(body(again, "c").position(), body(scene, "c").position(), 5e-3);
}

} // namespace
