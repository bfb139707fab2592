// Scenes survive being saved and loaded, and the second file is the first one, byte for byte.
#include "scene_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>

namespace cairn::scene {

void PrintTo(const SceneEntry& entry, std::ostream* out) { *out << entry.name; }

} // namespace cairn::scene

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;

template <class V> void expect_near(const V& a, const V& b, int size, const char* what) {
    for (int i = 0; i < size; ++i) {
        if (std::isinf(a[i]) && a[i] == b[i]) continue;
        EXPECT_NEAR(a[i], b[i], 1e-6 * (1.0 + std::fabs(a[i]))) << what << ", component " << i;
    }
}

// Equal but for the rounding of rotations to float.
void expect_same_world(const World& a, const World& b) {
    ASSERT_EQ(a.bodies().size(), b.bodies().size());
    for (std::size_t i = 0; i < a.bodies().size(); ++i) {
        const Body first = a.body(a.bodies()[i]), second = b.body(b.bodies()[i]);
        SCOPED_TRACE(first.name());
        EXPECT_EQ(first.name(), second.name());
        EXPECT_EQ(first.type(), second.type());
        expect_near(first.position(), second.position(), 3, "position");
        expect_near(first.rotation(), second.rotation(), 4, "rotation");
        expect_near(first.linear_velocity(), second.linear_velocity(), 3, "linear velocity");
        expect_near(first.angular_velocity(), second.angular_velocity(), 3, "angular velocity");
        EXPECT_EQ(first.linear_damping(), second.linear_damping());
        EXPECT_EQ(first.gravity_scale(), second.gravity_scale());
        EXPECT_EQ(first.mass(), second.mass());
        if (first.type() == BodyType::dynamic) {
            const MassProperties p = first.mass_properties(), q = second.mass_properties();
            expect_near(p.center_of_mass, q.center_of_mass, 3, "center of mass");
            expect_near(p.inertia_diagonal, q.inertia_diagonal, 3, "inertia");
            expect_near(p.inertia_orientation, q.inertia_orientation, 4, "inertia orientation");
        }
        EXPECT_EQ(first.shapes().size(), second.shapes().size());
    }
}

// The first line in which two texts differ.
std::string first_difference(const std::string& a, const std::string& b) {
    std::istringstream first(a), second(b);
    std::string x, y;
    while (x == y && std::getline(first, x) && std::getline(second, y)) {}
    return x + "\n" + y;
}

// Loading what was saved and saving it again gives the same bytes, and nothing is lost.
void expect_stable(const Scene& scene) {
    const std::string first = scene::save_to_string(scene);
    const Scene again = load_text(first);
    EXPECT_TRUE(again.warnings.empty()) << again.warnings.front();
    const std::string second = scene::save_to_string(again);
    EXPECT_TRUE(second == first) << first_difference(first, second);
    EXPECT_EQ(load_text(second).world.state_hash(), again.world.state_hash());
    expect_same_world(scene.world, again.world);
    EXPECT_EQ(again.appearances.size(), scene.appearances.size());
}

class ShippedScene : public testing::TestWithParam<scene::SceneEntry> {};

TEST_P(ShippedScene, IsListedWithATitleAHintAndItsBodies) {
    EXPECT_EQ(GetParam().error, "");
    EXPECT_FALSE(GetParam().title.empty());
    EXPECT_FALSE(GetParam().hint.empty());
    const Scene scene = scene::load(GetParam().path);
    EXPECT_EQ(scene.world.bodies().size(), GetParam().bodies);
    EXPECT_TRUE(scene.info.camera.has_value());
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
}

TEST_P(ShippedScene, IsTheSameAfterBeingSaved) { expect_stable(scene::load(GetParam().path)); }

TEST_P(ShippedScene, IsTheSameAfterBeingSavedInMotion) {
    Scene scene = scene::load(GetParam().path);
    for (int i = 0; i < 30; ++i) scene.world.step(scene.info.time_step);
    expect_stable(scene);
}

TEST_P(ShippedScene, RunsAndStaysInReach) {
    Scene scene = scene::load(GetParam().path);
    for (int i = 0; i < 120; ++i) scene.world.step(scene.info.time_step);
    for (const BodyId id : scene.world.bodies()) {
        const Body body = scene.world.body(id);
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_TRUE(std::isfinite(body.position()[axis]) && std::isfinite(body.linear_velocity()[axis]))
                << body.name();
            ASSERT_LT(std::fabs(body.position()[axis]), 100.0) << body.name();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedScene, testing::ValuesIn(scene::list_scenes(CAIRN_TEST_SCENES)),
                         [](const auto& info) { return info.param.name; });

TEST(SceneLibrary, HasScenes) { EXPECT_GE(scene::list_scenes(CAIRN_TEST_SCENES).size(), 12u); }

TEST(SceneSave, EverythingAFileCanSay) {
    Parts parts;
    parts.world = R"("title":"Title \"quoted\"","hint":"Grüße","gravity":[0.1,-1.62,0],"substeps":12,"integrator":"rk4",
        "time_step":0.01,"sleep":false,"camera":{"position":[1,2,3],"target":[0,0.1,0],"vertical_fov_degrees":33.3},
        "force_fields":[{"kind":"uniform","direction":[1,0,0.3]},
                        {"kind":"radial","center":[0,5.1,0],"strength":0.7,"exponent":-1,"is_force":true}])";
    parts.shapes += R"(,{"type":"plane","plane":{"sizeX":4.2,"sizeZ":6.4}})";
    parts.materials += R"(,{"staticFriction":0.91,"dynamicFriction":0.7,"restitution":0.2,"frictionCombine":"multiply",
        "restitutionCombine":"minimum","extensions":{"CAIRN_material":{"density":512.3,"rolling_friction":0.01}}})";
    parts.nodes =
        node(R"("name":"mixed","translation":[0.1,2.7,-3.3],"rotation":[0.1,0.2,0.3,0.9273618],"children":[1,2],)",
             R"("motion":{"mass":3.3,"linearVelocity":[0.1,0.2,0.3],"angularVelocity":[-1,0.7,5],)"
             R"("gravityFactor":0.3})") +
        "," + node(R"("translation":[0.3,0,0],)", R"("collider":{"geometry":{"shape":1},"physicsMaterial":1})") + "," +
        node(R"("rotation":[0,0.6,0,0.8],"translation":[0,0.7,0],)", sphere) + "," +
        node(R"("name":"given",)", R"("motion":{"mass":2.2,"centerOfMass":[0,-0.25,0.1],"inertiaDiagonal":[1.1,0,3.3],
            "inertiaOrientation":[0.1,0.2,0.3,0.9273618]},)" +
                                       box) +
        "," + node(R"("name":"heavy",)", R"("motion":{"mass":0},)" + sphere) + "," +
        node(R"("name":"bare",)", R"("motion":{"mass":4,"inertiaDiagonal":[1,2,3]})") + "," +
        node(R"("name":"wall","rotation":[0.70710678,0,0,0.70710678],)", R"("collider":{"geometry":{"shape":3}})") +
        "," + R"({"name":"group","children":[8,9],"extensions":{"CAIRN_body":{}}},)" + node("", box) + "," +
        node(R"("translation":[0,0.1,0],)", box) + "," +
        node(R"("name":"mover",)", R"("motion":{"isKinematic":true,"angularVelocity":[0,1,0]},)" + box) + "," +
        R"({"extensions":{"CAIRN_body":{"linear_damping":0.1,"angular_damping":0.2},"KHR_physics_rigid_bodies":
            {"motion":{},)" +
        box + R"(}},"extras":{"cairn_color":[0.1,0.2,0.3]}})";
    parts.roots = "0,3,4,5,6,7,10,11";
    expect_stable(load_text(document(parts)));
}

TEST(SceneSave, PlanesThatFaceElsewhere) {
    Scene scene{World(), {}, {}, {}, {}};
    BodyDef def;
    def.type = BodyType::static_;
    const BodyId body = scene.world.create_body(def);
    scene.world.add_shape(body, Plane{{1, 2, -0.5f}, {1, 0, 0}, {}});
    scene.world.add_shape(body, Plane{{0, 0, 1}, {0, 1, 0}, glm::vec2(2, 3)});
    const std::string text = scene::save_to_string(scene);
    const Scene again = load_text(text);
    EXPECT_EQ(scene::save_to_string(again), text);
    // The rectangle reaches 2 m along y and 3 m along x; the ray would miss it with the sides exchanged.
    const auto hit = again.world.cast_ray({2.9, 1.9, 1}, {0, 0, -1}, 1.5);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->normal.z, 1.0f, 1e-6);
    EXPECT_FALSE(again.world.cast_ray({1.9, 2.9, 1}, {0, 0, -1}, 1.5) &&
                 std::fabs(again.world.cast_ray({1.9, 2.9, 1}, {0, 0, -1}, 1.5)->normal.z - 1.0f) < 1e-6);
}

TEST(SceneSave, EmptyWorld) { expect_stable(Scene{World(), {}, {}, {}, {}}); }

TEST(SceneSave, WritesAFileAndLeavesNothingBeside) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "cairn_save_test";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const Scene scene = load_nodes(node(R"("name":"ball",)", R"("motion":{},)" + sphere));
    scene::save(scene, folder / "ball.gltf");
    scene::save(scene, folder / "ball.gltf"); // over the old one
    const std::vector<scene::SceneEntry> entries = scene::list_scenes(folder);
    ASSERT_EQ(entries.size(), 1u);
    EXPECT_EQ(entries[0].bodies, 1u);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
    EXPECT_THROW(scene::save(scene, folder / "missing" / "ball.gltf"), Error);
    std::filesystem::remove_all(folder);
}

TEST(SceneLibrary, FindsScenesByNameAndSaysWhatIsMissing) {
    setenv("CAIRN_SCENES", CAIRN_TEST_SCENES, 1);
    EXPECT_EQ(scene::find_scene("welcome").filename(), "welcome.gltf");
    EXPECT_EQ(scene::find_scene("open_plane").filename(), "01_open_plane.gltf");
    EXPECT_EQ(scene::find_scene("01_open_plane").filename(), "01_open_plane.gltf");
    EXPECT_EQ(scene::find_scene("01_open_plane.gltf").filename(), "01_open_plane.gltf");
    EXPECT_THROW(scene::find_scene("no_such_scene"), Error);
    EXPECT_THROW(scene::find_scene(""), Error);
    unsetenv("CAIRN_SCENES");
}

TEST(SceneLibrary, ListsBrokenFilesWithTheirError) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "cairn_list_test";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "broken.gltf") << "{";
    std::ofstream(folder / "readme.txt") << "no scene";
    const std::vector<scene::SceneEntry> entries = scene::list_scenes(folder);
    ASSERT_EQ(entries.size(), 1u);
    EXPECT_EQ(entries[0].name, "broken");
    EXPECT_NE(entries[0].error.find("is not valid JSON"), std::string::npos);
    std::filesystem::remove_all(folder);
}

} // namespace
