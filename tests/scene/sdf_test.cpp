// Models and worlds in SDF.
#include "scene_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;
namespace fs = std::filesystem;

std::string document(const std::string& elements) {
    return std::string("<sdf version=\"1.9\">").append(elements).append("</sdf>");
}
Scene load_sdf(const std::string& elements) { return load_text(document(elements), "test.sdf"); }
Scene load_world(const std::string& elements) {
    return load_sdf(std::string("<world name=\"w\">").append(elements).append("</world>"));
}
const std::string ball_collision =
    "<collision name=\"c\"><geometry><sphere><radius>0.1</radius></sphere></geometry></collision>";

TEST(Sdf, PosesAreRelativeToWhatTheyName) {
    Scene scene =
        load_world(R"(<gravity>0 0 0</gravity><frame name="f"><pose>0 0 10 0 0 1.5707963267948966</pose></frame>
        <model name="m"><pose relative_to="f">1 0 0 0 0 0</pose>
          <link name="a"><pose>0 2 0 0 0 0</pose></link>
          <link name="b"><pose relative_to="a" degrees="true">1 0 0 0 0 90</pose></link>
          <frame name="g" attached_to="b"><pose>0 1 0 0 0 0</pose></frame>
          <link name="c"><pose relative_to="g"/></link>
          <model name="inner"><pose>0 0 3 0 0 0</pose><link name="d"/></model>
          <link name="e"><pose relative_to="inner::d">0 0 1 0 0 0</pose></link>
        </model>
        <model name="n" placement_frame="tip"><pose>5 5 5 0 0 0</pose><link name="base"/>
          <frame name="tip"><pose>0 0 2 0 0 0</pose></frame></model>)");
    // The frame maps x to y: the model is at 0 1 10, and its y axis is the world's -x axis.
    expect_near(body(scene, "m::a").position(), seen({-2, 1, 10}));
    expect_near(body(scene, "m::b").position(), seen({-2, 2, 10}));
    expect_near(body(scene, "m::c").position(), seen({-2, 1, 10})); // b's y axis is the world's -y axis
    expect_near(body(scene, "m::inner::d").position(), seen({0, 1, 13}));
    expect_near(body(scene, "m::e").position(), seen({0, 1, 14}));
    expect_near(body(scene, "n::base").position(), seen({5, 5, 3}));
}

TEST(Sdf, LinksHaveTheMassThatTheFileSays) {
    Scene scene = load_world(R"(<model name="m">
        <link name="given"><inertial><pose>0 0 1 0 0 0</pose><mass>3</mass>
          <inertia><ixx>1</ixx><iyy>2</iyy><izz>2.5</izz></inertia></inertial></link>
        <link name="none"/>
        <link name="auto"><inertial auto="true"/><collision name="c"><density>500</density>
          <geometry><box><size>1 2 3</size></box></geometry></collision></link></model>)");
    const MassProperties given = body(scene, "m::given").mass_properties();
    EXPECT_FLOAT_EQ(given.mass, 3.0f);
    EXPECT_NEAR(given.center_of_mass.z, 1.0f, 1e-6f);
    EXPECT_FLOAT_EQ(body(scene, "m::none").mass(), 1.0f); // the default of the format
    const MassProperties automatic = body(scene, "m::auto").mass_properties();
    EXPECT_NEAR(automatic.mass, 3000.0f, 0.01f);
    EXPECT_NEAR(automatic.inertia_diagonal.x, 3000.0f / 12.0f * 13.0f, 0.1f);
}

TEST(Sdf, JointsTurnAboutTheirAxesFromTheAnchorOfTheChild) {
    Scene scene = load_world(R"(<gravity>0 0 0</gravity><model name="m"><link name="a"/>
        <link name="b"><pose>2 0 0 0 0 1</pose></link>
        <joint name="base" type="fixed"><parent>world</parent><child>a</child></joint>
        <joint name="j" type="revolute"><parent>a</parent><child>b</child><pose relative_to="a">1 0 0 0 0 0</pose>
          <axis><xyz expressed_in="__model__">0 0 1</xyz>
          <limit><lower>-1</lower><upper>0.5</upper><effort>7</effort><velocity>3</velocity></limit>
          <dynamics><friction>0.25</friction><damping>2</damping></dynamics></axis></joint>
        </model>)");
    EXPECT_EQ(body(scene, "m::a").type(), BodyType::static_);
    const JointId id = scene.world.find_joint("m::j").value();
    const HingeJoint hinge = std::get<HingeJoint>(scene.world.joint_def(id).joint);
    EXPECT_FLOAT_EQ(hinge.angle.limits->lower, -1.0f);
    EXPECT_FLOAT_EQ(hinge.angle.limits->upper, 0.5f);
    EXPECT_FLOAT_EQ(hinge.angle.friction, 0.25f);
    EXPECT_FLOAT_EQ(hinge.angle.motor->max_force, 7.0f);
    EXPECT_FLOAT_EQ(hinge.angle.motor->spring->damping, 2.0f);
    ASSERT_EQ(scene.speed_limits.size(), 1u);
    EXPECT_FLOAT_EQ(scene.speed_limits[0].speed, 3.0f);
    Body b = body(scene, "m::b");
    b.set_angular_velocity({0.0f, 5.0f, 0.0f}); // upwards, along the joint's axis
    b.set_linear_velocity(Vec3(seen({0.0, 5.0, 0.0})));
    for (int i = 0; i < 20; ++i) scene.world.step(0.005f);
    const double angle = static_cast<double>(scene.world.joint_state(id).positions[0]);
    EXPECT_GT(angle, 0.1);
    expect_near(b.position(), seen({1.0 + std::cos(angle), std::sin(angle), 0.0}), 1e-3);
}

TEST(Sdf, UniversalJointsHaveBothAxes) {
    Scene scene = load_world(R"(<model name="m"><link name="a"/><link name="b"><pose>0 0 -1 0 0 0</pose></link>
        <joint name="j" type="universal"><parent>world</parent><child>a</child>
          <axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2></joint>
        <joint name="s" type="prismatic"><parent>a</parent><child>b</child>
          <axis><xyz>0 0 1</xyz><limit><lower>-0.5</lower><upper>0</upper></limit></axis></joint></model>)");
    run(scene, 3.0);
    EXPECT_NEAR(scene.world.joint_state(scene.world.find_joint("m::s").value()).positions[0], -0.5f, 1e-3f);
    expect_near(body(scene, "m::a").position(), glm::dvec3(0.0), 1e-3);
    Body b = body(scene, "m::b");
    b.set_linear_velocity({1.0f, 0.0f, 1.0f}); // moves about both axes
    run(scene, 0.3);
    const JointState state = scene.world.joint_state(scene.world.find_joint("m::j").value());
    EXPECT_GT(std::fabs(state.positions[0]), 0.05f);
    EXPECT_GT(std::fabs(state.positions[1]), 0.05f);
}

TEST(Sdf, FixedLinksAreOneBodyAndModelsDoNotTouchThemselves) {
    const std::string inertial = "<inertial><mass>1</mass></inertial>";
    const auto model = [&](const std::string& name, const std::string& more, const std::string& at) {
        return "<model name=\"" + name + "\"><pose>" + at + " 0 0 0</pose>" + more + "<link name=\"a\">" + inertial +
               ball_collision + "</link><link name=\"b\"><pose>0.15 0 0 0 0 0</pose>" + inertial + ball_collision +
               "</link></model>";
    };
    Scene scene = load_world(
        "<gravity>0 0 0</gravity>" + model("plain", "", "0 0 0") +
        model("self", "<self_collide>true</self_collide>", "0 9 0") + model("other", "", "0.2 0.15 0") +
        model("one", R"(<joint name="f" type="fixed"><parent>a</parent><child>b</child></joint>)", "0 -9 0"));
    EXPECT_FALSE(scene.world.find_body("one::b"));
    EXPECT_FLOAT_EQ(body(scene, "one::a").mass(), 2.0f);
    EXPECT_EQ(body(scene, "one::a").shapes().size(), 2u);
    const glm::dvec3 before = body(scene, "other::a").position();
    run(scene, 1.0);
    const auto gap = [&](const char* a, const char* b) {
        return glm::length(body(scene, a).position() - body(scene, b).position());
    };
    EXPECT_GT(gap("self::a", "self::b"), 0.19);
    EXPECT_LT(gap("plain::a", "other::b") + gap("other::a", "other::b"), 10.0);
    // The other model still collides with it.
    EXPECT_GT(glm::length(body(scene, "other::a").position() - before), 0.005);
}

TEST(Sdf, FrictionAndBouncesAreThoseOfTheSurface) {
    const auto surface = [](const std::string& mu) {
        return "<surface><friction><ode><mu>" + mu + "</mu><mu2>" + mu +
               "</mu2></ode></friction><bounce><restitution_coefficient>0.5</restitution_coefficient></bounce></"
               "surface>";
    };
    Scene scene =
        load_world("<gravity>0 0 -10</gravity><model name=\"ground\"><static>true</static><link name=\"l\">"
                   "<collision name=\"c\">" +
                   surface("0.4") +
                   "<geometry><plane><normal>0 0 1</normal></plane></geometry></collision></link></model>"
                   "<model name=\"box\"><pose>0 0 0.5 0 0 0</pose><link name=\"l\"><collision name=\"c\">" +
                   surface("0.9") + "<geometry><box><size>1 1 1</size></box></geometry></collision></link></model>");
    body(scene, "box::l").set_linear_velocity({2.0f, 0.0f, 0.0f});
    run(scene, 2.0);
    EXPECT_NEAR(body(scene, "box::l").position().x, 4.0 / (2.0 * 0.4 * 10.0), 0.02); // the smaller of both frictions
}

TEST(Sdf, PhysicsSetsTheStepAndGravityIsTurned) {
    Scene scene = load_world(R"(<physics type="ode"><max_step_size>0.004</max_step_size></physics>
        <gravity>1 2 -3</gravity>
        <model name="m"><link name="l"/><link name="f"><gravity>false</gravity></link></model>)");
    EXPECT_FLOAT_EQ(scene.info.time_step, 0.004f);
    EXPECT_LT(glm::length(scene.world.settings().gravity - Vec3(1.0f, -3.0f, -2.0f)), 1e-5f);
    run(scene, 1.0);
    EXPECT_NEAR(body(scene, "m::l").linear_velocity().x, 1.0f, 1e-3f);
    EXPECT_EQ(body(scene, "m::f").linear_velocity(), Vec3(0.0f));
}

TEST(Sdf, WhatIsSavedAsGltfFallsTheSame) {
    Scene scene = load_world("<model name=\"m\"><pose>0 0 1 0.3 0.2 0.1</pose><link name=\"a\">" + ball_collision +
                             "</link><link name=\"b\"><pose>1 0 0 0 0 0</pose>" + ball_collision +
                             R"(</link><joint name="j" type="ball"><parent>a</parent><child>b</child></joint></model>
        <model name="ground"><static>true</static><link name="l"><collision name="c"><geometry><plane/></geometry>
        </collision></link></model>)");
    const std::string saved = scene::save_to_string(scene);
    Scene again = load_text(saved);
    EXPECT_EQ(scene::save_to_string(again), saved);
    run(scene, 2.0);
    run(again, 2.0);
    expect_near(body(again, "m::b").position(), body(scene, "m::b").position(), 2e-3);
    EXPECT_NEAR(body(scene, "m::b").position().y, 0.1, 0.02);
}

class SdfFiles : public testing::Test {
  protected:
    void SetUp() override {
        above_ = fs::canonical(testing::TempDir()) / ("cairn_sdf_" + std::to_string(::getpid()));
        folder_ = above_ / "worlds";
        fs::remove_all(above_);
        fs::create_directories(folder_ / "models" / "ball" / "meshes");
        write("models/ball/model.config", "<model><sdf version=\"1.6\">ball.sdf</sdf></model>");
        write("models/ball/ball.sdf",
              document("<model name=\"ball\"><link name=\"l\"><collision name=\"c\"><geometry><mesh><uri>model://ball/"
                       "meshes/b.obj</uri></mesh></geometry></collision></link></model>"));
        write("models/ball/meshes/b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    }
    void TearDown() override { fs::remove_all(above_); }
    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
    Scene load(const std::string& elements) const {
        write("world.sdf", document("<world name=\"w\">" + elements + "</world>"));
        return scene::load(folder_ / "world.sdf");
    }
    fs::path above_, folder_;
};

TEST_F(SdfFiles, IncludedModelsComeFromTheFolderOfModels) {
    Scene scene =
        load("<include><uri>model://ball</uri><name>first</name><pose>0 0 5 0 0 0</pose></include>"
             "<include><uri>models/ball</uri><static>true</static></include>"
             "<include><uri>model://nowhere</uri></include><include><uri>https://example.org/x</uri></include>");
    EXPECT_EQ(scene.world.bodies().size(), 2u);
    EXPECT_EQ(body(scene, "ball::l").type(), BodyType::static_);
    expect_near(body(scene, "first::l").position(), seen({0, 0, 5}));
    EXPECT_TRUE(std::holds_alternative<Hull>(scene.world.shape(body(scene, "first::l").shapes().at(0))));
    ASSERT_EQ(scene.warnings.size(), 2u);
    EXPECT_NE(scene.warnings[0].find("there is no such model"), std::string::npos) << scene.warnings[0];
    EXPECT_NE(scene.warnings[1].find("must name a model on this disk"), std::string::npos) << scene.warnings[1];
}

TEST_F(SdfFiles, NothingOutsideOfTheFolderIsRead) {
    fs::create_directories(above_ / "secret");
    std::ofstream(above_ / "secret" / "model.sdf") << document("<model name=\"s\"><link name=\"l\"/></model>");
    fs::create_directory_symlink(above_ / "secret", folder_ / "link");
    for (const std::string& uri :
         {std::string("../secret"), (above_ / "secret").string(), std::string("model://../secret"),
          std::string("file://../secret"), std::string("link"), std::string("model://link"),
          std::string("models/../../secret"), "model:///" + (above_ / "secret").string()}) {
        SCOPED_TRACE(uri);
        const Scene scene = load("<include><uri>" + uri + "</uri></include>");
        EXPECT_EQ(scene.world.bodies().size(), 0u);
        ASSERT_EQ(scene.warnings.size(), 1u);
        EXPECT_NE(scene.warnings[0].find("(the model is left out)"), std::string::npos) << scene.warnings[0];
    }
}

// Without the fix a mesh outside the folder, or a damaged mesh of a visual, made the whole world invalid.
TEST_F(SdfFiles, MeshesThatMayNotOrCannotBeReadAreLeftOut) {
    std::ofstream(above_ / "secret.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    write("torn.stl", "solid torn\nfacet\n");
    const auto geometry = [](const std::string& uri) {
        return "<geometry><mesh><uri>" + uri + "</uri></mesh></geometry>";
    };
    const Scene scene = load("<model name=\"m\"><link name=\"l\"><collision name=\"c\">" + geometry("../secret.obj") +
                             "</collision><visual name=\"v\">" + geometry("../secret.obj") +
                             "</visual><visual name=\"w\">" + geometry("torn.stl") + "</visual></link></model>");
    EXPECT_TRUE(scene.world.body(scene.world.bodies().at(0)).shapes().empty());
    EXPECT_TRUE(scene.visuals.empty());
    ASSERT_EQ(scene.warnings.size(), 3u);
    EXPECT_NE(scene.warnings[0].find("or below it, also where links lead"), std::string::npos) << scene.warnings[0];
    EXPECT_NE(scene.warnings[0].find("(the collision is left out)"), std::string::npos) << scene.warnings[0];
    EXPECT_NE(scene.warnings[1].find("(it is not shown)"), std::string::npos) << scene.warnings[1];
    EXPECT_NE(scene.warnings[2].find("torn.stl"), std::string::npos) << scene.warnings[2];
}

TEST_F(SdfFiles, IncludesThatGoRoundAreRefused) {
    write("models/ball/ball.sdf", document("<model name=\"b\"><include><uri>model://ball</uri></include></model>"));
    EXPECT_THROW(load("<include><uri>model://ball</uri></include>"), Error);
}

TEST_F(SdfFiles, MistakesNameElementAndValue) {
    struct Case {
        const char* elements;
        const char* message;
    };
    for (const Case& c : {
             Case{"<model name=\"m\"><link name=\"l\"><pose>1 2</pose></link></model>",
                  "link \"l\": pose: must have 6 numbers, got \"1 2\""},
             Case{"<model name=\"m\"><link name=\"l\"><pose relative_to=\"x\"/></link></model>",
                  "relative_to: must be the name of a link, joint, frame or model, got \"x\""},
             Case{"<model name=\"m\"><link name=\"l\"><pose relative_to=\"l\"/></link></model>",
                  "must not refer to itself through other frames"},
             Case{"<model name=\"m\"><link name=\"l\"><inertial><mass>-1</mass></inertial></link></model>",
                  "inertial: mass: must be from 0 to 1000000000000, got \"-1\""},
             Case{"<model name=\"m\"><link name=\"l\"/><link name=\"l\"/></model>",
                  "must not have the name of another"},
             Case{"<model name=\"m\"><link name=\"a\"/><joint name=\"j\" type=\"hinge\"><parent>world</parent>"
                  "<child>a</child></joint></model>",
                  "joint \"j\": type: must be one of revolute, continuous"},
             Case{"<model name=\"m\"><link name=\"a\"/><joint name=\"j\" type=\"ball\"><parent>b</parent>"
                  "<child>a</child></joint></model>",
                  "parent: must be the name of a link, joint, frame or model, got \"b\""},
         }) {
        SCOPED_TRACE(c.elements);
        try {
            load(c.elements);
            ADD_FAILURE() << "was read";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(c.message), std::string::npos) << error.what();
            EXPECT_EQ(std::string(error.what()).find("world.sdf:1: "), 0u) << error.what();
        }
    }
}

} // namespace
