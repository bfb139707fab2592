// Scenes survive saving and loading, and the second file equals the first byte for byte.
#include "mesh_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;

template <class V> void expect_alike(const V& a, const V& b, int size, const char* what) {
    for (int i = 0; i < size; ++i) {
        if (std::isinf(a[i]) && a[i] == b[i]) continue;
        EXPECT_NEAR(a[i], b[i], 1e-6 * (1.0 + std::fabs(a[i]))) << what << ", component " << i;
    }
}

// Equal except for rounding rotations to float.
void expect_same_world(const World& a, const World& b) {
    ASSERT_EQ(a.bodies().size(), b.bodies().size());
    for (std::size_t i = 0; i < a.bodies().size(); ++i) {
        const Body first = a.body(a.bodies()[i]), second = b.body(b.bodies()[i]);
        SCOPED_TRACE(first.name());
        EXPECT_TRUE(first.name() == second.name() && first.type() == second.type());
        expect_alike(first.position(), second.position(), 3, "position");
        expect_alike(first.rotation(), second.rotation(), 4, "rotation");
        expect_alike(first.linear_velocity(), second.linear_velocity(), 3, "linear velocity");
        expect_alike(first.angular_velocity(), second.angular_velocity(), 3, "angular velocity");
        EXPECT_EQ(first.linear_damping(), second.linear_damping());
        EXPECT_TRUE(first.allow_sleep() == second.allow_sleep() && first.enabled() == second.enabled());
        EXPECT_EQ(first.gravity_scale(), second.gravity_scale());
        EXPECT_EQ(first.mass(), second.mass());
        if (first.type() == BodyType::dynamic) {
            const MassProperties p = first.mass_properties(), q = second.mass_properties();
            expect_alike(p.center_of_mass, q.center_of_mass, 3, "center of mass");
            expect_alike(p.inertia_diagonal, q.inertia_diagonal, 3, "inertia");
            expect_alike(p.inertia_orientation, q.inertia_orientation, 4, "inertia orientation");
        }
        EXPECT_EQ(first.shapes().size(), second.shapes().size());
    }
}

std::string first_difference(const std::string& a, const std::string& b) {
    std::istringstream first(a), second(b);
    std::string x, y;
    while (x == y && std::getline(first, x) && std::getline(second, y)) {}
    return x + "\n" + y;
}

// Loading a saved scene and saving it again gives the same bytes, and nothing is lost.
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

// The names only: reading the files would take a third of a second in each test, which is a process of its own.
std::vector<std::string> shipped_scenes() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(CAIRN_TEST_SCENES))
        if (entry.path().extension() == ".gltf") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

class ShippedScene : public testing::TestWithParam<std::string> {
  protected:
    static Scene load() { return scene::load(fs::path(CAIRN_TEST_SCENES) / (GetParam() + ".gltf")); }
};

TEST_P(ShippedScene, IsListedWithATitleAHintAndItsBodies) {
    const std::vector<scene::SceneEntry> all = scene::list_scenes(CAIRN_TEST_SCENES);
    const auto entry = std::find_if(all.begin(), all.end(), [](const auto& e) { return e.name == GetParam(); });
    ASSERT_NE(entry, all.end());
    EXPECT_EQ(entry->error, "");
    EXPECT_FALSE(entry->title.empty());
    EXPECT_FALSE(entry->hint.empty());
    const Scene scene = load();
    EXPECT_EQ(scene.world.bodies().size(), entry->bodies);
    EXPECT_TRUE(scene.info.camera.has_value());
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
}

TEST_P(ShippedScene, IsTheSameAfterBeingSaved) { expect_stable(load()); }

TEST_P(ShippedScene, IsTheSameAfterBeingSavedInMotion) {
    Scene scene = load();
    for (int i = 0; i < 30; ++i) scene.world.step(scene.info.time_step);
    expect_stable(scene);
}

TEST_P(ShippedScene, RunsAndStaysInReach) {
    Scene scene = load();
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

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedScene, testing::ValuesIn(shipped_scenes()),
                         [](const auto& info) { return info.param; });

TEST(SceneLibrary, HasScenes) { EXPECT_GE(scene::list_scenes(CAIRN_TEST_SCENES).size(), 12u); }

TEST(SceneSave, EverythingAFileCanSay) {
    Parts parts;
    parts.world = R"("title":"Title \"quoted\"","hint":"Grüße","gravity":[0.1,-1.62,0],"substeps":12,"integrator":"rk4",
        "time_step":0.01,"sleep":false,"camera":{"position":[1,2,3],"target":[0,0.1,0],"vertical_fov_degrees":33.3},
        "force_fields":[{"kind":"uniform","direction":[1,0,0.3]},
                        {"kind":"radial","center":[0,5.1,0],"strength":0.7,"exponent":-1,"is_force":true},
                        {"kind":"fluid","center":[0,2.1,0],"half_extents":[3.3,null,4],"density":800,"drag":0.5},
                        {"kind":"fluid","center":[0,0.3,0],"direction":[1,0,0],"skin_friction":0.02}])";
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
        R"({"extensions":{"CAIRN_body":{"linear_damping":0.1,"angular_damping":0.2,"allow_sleep":false,"enabled":false},
            "KHR_physics_rigid_bodies":{"motion":{"linearVelocity":[1,2,3]},)" +
        box + R"(}},"extras":{"cairn_color":[0.1,0.2,0.3]}})";
    parts.roots = "0,3,4,5,6,7,10,11";
    expect_stable(load_text(document(parts)));
}

// Bodies of any type may be in a group; removing a body removes it from its group, and a group of one is dissolved.
TEST(SceneSave, Characters) {
    Scene scene{World(), {}, {}, {}, {}};
    BodyDef def;
    def.type = BodyType::kinematic;
    const CharacterDef mine{.up = {0, 0, 1}, .max_slope = 0.5f, .step_height = 0.1f, .skin = 0.01f, .flies = true};
    for (int i = 0; i < 2; ++i) {
        const BodyId body = scene.world.create_body(def);
        scene.world.add_shape(body, Capsule{});
        scene.world.body(body).set_character(i == 0 ? CharacterDef{} : mine);
    }
    scene.world.body(scene.world.bodies()[1]).set_walk_velocity({1, 2, 3});
    const std::string text = scene::save_to_string(scene);
    Scene again = load_text(text);
    EXPECT_TRUE(again.warnings.empty());
    EXPECT_EQ(scene::save_to_string(again), text);
    const std::vector<BodyId> all = again.world.bodies();
    ASSERT_TRUE(again.world.body(all[0]).is_character() && again.world.body(all[1]).is_character());
    EXPECT_EQ(again.world.body(all[0]).character().step_height, CharacterDef{}.step_height);
    const CharacterDef read = again.world.body(all[1]).character();
    EXPECT_EQ(read.up, mine.up);
    EXPECT_EQ(read.max_slope, mine.max_slope);
    EXPECT_EQ(read.step_height, mine.step_height);
    EXPECT_EQ(read.skin, mine.skin);
    EXPECT_TRUE(read.flies);
    EXPECT_EQ(again.world.body(all[1]).walk_velocity(), Vec3(1, 2, 3));
    // Values that no character can have are rejected with their location.
    for (const auto& [from, to] : {std::pair("\"skin\":0.01", "\"skin\":-1"), std::pair("\"skin\":0.01", "\"skin\":7"),
                                   std::pair("\"flies\":true", "\"flies\":3")}) {
        std::string wrong = text;
        const std::size_t at = wrong.find(from);
        ASSERT_NE(at, std::string::npos) << from << " in " << text;
        wrong.replace(at, std::string(from).size(), to);
        try {
            load_text(wrong);
            ADD_FAILURE() << to << " was taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::invalid_file);
            EXPECT_NE(std::string(error.what()).find("character"), std::string::npos) << error.what();
        }
    }
}

TEST(SceneSave, GroupsOfBodies) {
    Scene scene{World(), {}, {}, {}, {}};
    std::vector<BodyId> bodies;
    for (int i = 0; i < 7; ++i) {
        BodyDef def;
        def.type = i == 2 ? BodyType::static_ : BodyType::dynamic;
        def.position = {2.0 * i, 1.0, 0.0};
        bodies.push_back(scene.world.create_body(def));
        scene.world.add_shape(bodies.back(), Box{});
    }
    scene.groups = {{bodies[0], bodies[6]}, {bodies[5], bodies[2], bodies[1]}, {bodies[3], bodies[4]}};
    scene.world.destroy_body(bodies[6]);
    scene.world.destroy_body(bodies[5]);
    const std::string text = scene::save_to_string(scene);
    const Scene again = load_text(text);
    EXPECT_TRUE(again.warnings.empty());
    EXPECT_EQ(scene::save_to_string(again), text);
    const std::vector<BodyId> all = again.world.bodies();
    ASSERT_EQ(all.size(), 5u);
    EXPECT_EQ(again.groups, (std::vector<std::vector<BodyId>>{{all[1], all[2]}, {all[3], all[4]}}));
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
    // The rectangle extends 2 m along y and 3 m along x; the ray would miss it if the sides were exchanged.
    const auto hit = again.world.cast_ray({2.9, 1.9, 1}, {0, 0, -1}, 1.5);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->normal.z, 1.0f, 1e-6);
    EXPECT_FALSE(again.world.cast_ray({1.9, 2.9, 1}, {0, 0, -1}, 1.5) &&
                 std::fabs(again.world.cast_ray({1.9, 2.9, 1}, {0, 0, -1}, 1.5)->normal.z - 1.0f) < 1e-6);
}

// A scene with every element that needs a buffer or a list of its own.
Scene rich_scene() {
    MeshParts parts = tetrahedron("");
    const int heights = parts.accessor(parts.view(packed(std::vector<float>{0, 0.1f, 2, 3, 4, 5})), 5126, 6, "SCALAR");
    parts.shapes =
        R"({"type":"CAIRN_height_field","extensions":{"CAIRN_height_field":{"columns":3,"rows":2,)"
        R"("spacing":[1,2],"heights":)" +
        std::to_string(heights) +
        R"(}}},{"type":"capsule","capsule":{"height":1.2,"radiusBottom":0.3,"radiusTop":0.1}},)"
        R"({"type":"cylinder","cylinder":{"height":0.7,"radiusBottom":0,"radiusTop":0.4}},{"type":"sphere"})";
    parts.filters = R"({"collisionSystems":["b","a"],"collideWithSystems":["a"]},{"notCollideWithSystems":["c"]})";
    parts.joints = R"({"limits":[{"linearAxes":[0,1,2],"min":0,"max":0.1,"stiffness":9,"damping":1}],"drives":[)"
                   R"({"type":"angular","mode":"acceleration","axis":2,"maxForce":7,"velocityTarget":1,"damping":2}]})";
    const std::string of_node_1 = R"("geometry":{"node":1,"convexHull":true})";
    parts.nodes =
        node("", R"("collider":{"geometry":{"shape":0},"collisionFilter":1})") + R"(,{"mesh":0},)" +
        node(R"("name":"rocks","translation":[0,5,0],"rotation":[0.1,0.2,0.3,0.9273618],"children":[3,4,5],)",
             R"("motion":{"angularVelocity":[1,0.3,0]},"collider":{)" + of_node_1 + R"(,"collisionFilter":0})") +
        "," + node(R"("translation":[2,0.1,0],)", R"("collider":{)" + of_node_1 + "}") + "," +
        node(R"("name":"pin","translation":[0,1,0],"rotation":[0,0.6,0,0.8],)",
             R"("joint":{"joint":0,"connectedNode":8,"enableCollision":true})") +
        R"(,{"mesh":0,"translation":[0,0.3,0],"scale":[-1,2,1]},)" +
        node(R"("translation":[9,0,0],"children":[7],)", mesh_of_node_1) + R"(,{"mesh":0},)" +
        node(R"("translation":[-4,3,0],"children":[9],)", R"("motion":{},"collider":{"geometry":{"shape":2}})") + "," +
        node(R"("translation":[0,2,0],)", R"("trigger":{"geometry":{"shape":1},"collisionFilter":1})") + "," +
        node(R"("mesh":0,"translation":[0,0,20],)", R"("trigger":{"geometry":{"shape":3}})");
    parts.roots = "0,2,6,8,10";
    return load_text(parts.text());
}

TEST(SceneSave, RoundedShapes) {
    Scene scene{World(), {}, {}, {}, {}};
    const std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Hull sharp(corners);
    Hull round = sharp;
    round.rounding = 0.3f;
    const std::vector<Shape> shapes = {Box{{0.5f, 0.25f, 1}, 0.1f}, Cylinder{0.5f, 0.25f, 0.125f, 0.07f}, sharp, round};
    for (const Shape& shape : shapes) {
        BodyDef def;
        def.position = {3 * double(scene.world.bodies().size()), 5, 0};
        scene.world.add_shape(scene.world.create_body(def), shape);
    }
    expect_stable(scene);
    const std::string text = scene::save_to_string(scene);
    EXPECT_NE(text.find("\"CAIRN_shape\""), std::string::npos);
    const World again = load_text(text).world;
    std::vector<float> roundings;
    for (const BodyId body : again.bodies())
        roundings.push_back(rounding_of(again.shape(again.body(body).shapes().at(0))));
    EXPECT_EQ(roundings, (std::vector<float>{0.1f, 0.07f, 0.0f, 0.3f}));
}

TEST(SceneSave, SheetsAndStrips) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    Scene scene{World(), {}, {}, {}, {}};
    const std::vector<Plane> planes = {Plane{{0, 1, 0}, {1, 0, 0}, {}, true},
                                       Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(2, 3), true},
                                       Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(infinity, 3), false},
                                       Plane{{1, 0, 0}, {0, 0, 1}, glm::vec2(2, infinity), true}};
    for (const Plane& plane : planes) {
        BodyDef def;
        def.type = BodyType::static_;
        def.position = {3 * double(scene.world.bodies().size()), 5, 0};
        scene.world.add_shape(scene.world.create_body(def), plane);
    }
    expect_stable(scene);
    const World again = load_text(scene::save_to_string(scene)).world;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const Plane plane = std::get<Plane>(again.shape(again.body(again.bodies()[i]).shapes().at(0)));
        EXPECT_EQ(plane.double_sided, planes[i].double_sided) << i;
        EXPECT_EQ(plane.half_extents, planes[i].half_extents) << i;
    }
}

TEST(SceneSave, MeshesFiltersTriggersAndJoints) {
    const Scene scene = rich_scene();
    ASSERT_EQ(scene.world.joints().size(), 1u);
    ASSERT_EQ(scene.visuals.size(), 3u);
    const std::string first = scene::save_to_string(scene);
    const Scene again = load_text(first);
    const std::string second = scene::save_to_string(again);
    EXPECT_TRUE(second == first) << first_difference(first, second);
    expect_same_world(scene.world, again.world);
    EXPECT_EQ(again.collision_systems, (std::vector<std::string>{"a", "b"})); // no shape is in system c
    ASSERT_EQ(again.world.joints().size(), 1u);
    const JointDef& joint = again.world.joint_def(again.world.joints()[0]);
    EXPECT_EQ(joint.name, "pin");
    EXPECT_TRUE(joint.enable_collision);
    EXPECT_EQ(std::get<GeneralJoint>(joint.joint).drives.at(0).max_force, 7.0f);
    EXPECT_EQ(std::get<GeneralJoint>(joint.joint).limits.at(0).stiffness, 9.0f);
    EXPECT_EQ(again.world.body(joint.body_a).name(), "rocks");
    EXPECT_NEAR(joint.frame_a.position.y, 1.0, 1e-6);
    ASSERT_EQ(again.visuals.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto same = std::find_if(again.visuals.begin(), again.visuals.end(), [&](const scene::VisualMesh& v) {
            return v.surface->vertices == scene.visuals[i].surface->vertices &&
                   v.surface->indices == scene.visuals[i].surface->indices &&
                   v.body.is_null() == scene.visuals[i].body.is_null();
        });
        EXPECT_NE(same, again.visuals.end()) << i;
    }
    for (const BodyId id : scene.world.bodies()) {
        const std::vector<ShapeId> before = scene.world.body(id).shapes();
        const BodyId other = again.world.bodies().at(id.index());
        const std::vector<ShapeId> after = again.world.body(other).shapes();
        ASSERT_EQ(before.size(), after.size());
        for (std::size_t i = 0; i < before.size(); ++i) {
            EXPECT_EQ(scene.world.shape(before[i]).index(), again.world.shape(after[i]).index());
            EXPECT_EQ(scene.world.shape_def(before[i]).is_trigger, again.world.shape_def(after[i]).is_trigger);
        }
    }
}

TEST(SceneSave, HullsThatShareDataAreWrittenOnce) {
    const std::string text = scene::save_to_string(rich_scene());
    std::size_t meshes = 0;
    for (std::size_t at = text.find("\"POSITION\""); at != std::string::npos; at = text.find("\"POSITION\"", at + 1)) {
        ++meshes;
    }
    EXPECT_EQ(meshes, 4u); // a hull of two colliders, a triangle mesh, and two visuals
}

TEST(SceneSave, BinaryFilesHoldTheSame) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "cairn_save_binary_test";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const Scene scene = rich_scene();
    scene::save(scene, folder / "a.glb");
    const Scene again = scene::load(folder / "a.glb");
    expect_same_world(scene.world, again.world);
    scene::save(again, folder / "b.glb");
    scene::save(again, folder / "b.gltf");
    scene::save(scene::load(folder / "b.gltf"), folder / "c.glb");
    const auto bytes = [&](const char* name) {
        std::ifstream stream(folder / name, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(stream), {});
    };
    EXPECT_EQ(bytes("a.glb").substr(0, 4), "glTF");
    EXPECT_TRUE(bytes("a.glb") == bytes("b.glb"));
    EXPECT_TRUE(bytes("a.glb") == bytes("c.glb"));
    std::filesystem::remove_all(folder);
}

TEST(SceneSave, FiltersSetByHandKeepTheirMeaning) {
    Scene scene{World(), {}, {}, {}, {}};
    const CollisionFilter filters[] = {{1, ~std::uint64_t{}}, {0b100, 0b101},        {0b1001, 0b1100},
                                       {0b100, ~0b1000ull},   {0, ~std::uint64_t{}}, {0b10, 0}};
    for (const CollisionFilter& filter : filters) {
        BodyDef def;
        def.type = BodyType::static_;
        ShapeDef shape;
        shape.filter = filter;
        scene.world.add_shape(scene.world.create_body(def), Sphere{}, shape);
    }
    scene.collision_systems = {"layer_3"}; // of bit 1; the generated name for bit 3 must differ
    const std::string text = scene::save_to_string(scene);
    const Scene again = load_text(text);
    EXPECT_EQ(scene::save_to_string(again), text);
    const auto meet = [](const Scene& s, std::size_t a, std::size_t b) {
        const auto filter = [&](std::size_t i) {
            return s.world.shape_def(s.world.body(s.world.bodies().at(i)).shapes().at(0)).filter;
        };
        return (filter(a).layers & filter(b).collides_with) != 0 && (filter(b).layers & filter(a).collides_with) != 0;
    };
    for (std::size_t a = 0; a < 6; ++a) {
        for (std::size_t b = 0; b < 6; ++b) EXPECT_EQ(meet(scene, a, b), meet(again, a, b)) << a << " and " << b;
    }
}

// Without the fix each load moved the origin of a body a little, as it was computed anew with every added shape.
TEST(SceneSave, BodiesOfManyPartsStayInTheirPlace) {
    std::ostringstream nodes, children;
    for (int i = 1; i <= 14; ++i) {
        const double x = 0.137 * i * (i % 3 - 1), y = 0.211 * i * (i % 2);
        std::ostringstream members;
        members << R"("translation":[)" << x << "," << y << ",0.3],";
        nodes << "," << node(members.str(), i % 2 == 0 ? box : sphere);
        children << (i == 1 ? "" : ",") << i;
    }
    const std::string place = R"("translation":[-4.028587818145752,3.558683633804321,3.0201091766357422],)";
    const Scene scene =
        load_nodes(node(place + R"("rotation":[0,0.70710684,0,0.70710677],"children":[)" + children.str() + "],",
                        R"("motion":{"mass":1})") +
                   nodes.str());
    const Position p = scene.world.body(scene.world.bodies().at(0)).position();
    EXPECT_NEAR(p.x, -4.028587818145752, 1e-14);
    EXPECT_NEAR(p.y, 3.558683633804321, 1e-14);
    EXPECT_NEAR(p.z, 3.0201091766357422, 1e-14);
    expect_stable(scene);
}

TEST(SceneSave, TorsionalFrictionOfZeroIsNotTheDefault) {
    Scene scene{World(), {}, {}, {}, {}};
    ShapeDef def;
    def.material.torsional_friction = 0.0f;
    scene.world.add_shape(scene.world.create_body(), Sphere{}, def);
    const Scene again = load_text(scene::save_to_string(scene));
    const ShapeId shape = again.world.body(again.world.bodies().at(0)).shapes().at(0);
    EXPECT_EQ(again.world.shape_def(shape).material.torsional_friction, 0.0f);
}

TEST(SceneSave, JointsAndMeshesOfRemovedBodiesAreLeftOut) {
    Scene scene = rich_scene();
    scene.world.destroy_body(scene.world.joint_def(scene.world.joints().at(0)).body_a);
    const Scene again = load_text(scene::save_to_string(scene));
    EXPECT_TRUE(again.world.joints().empty());
    EXPECT_EQ(again.visuals.size(), 2u);
}

TEST(SceneSave, NamesOfAnyBytesAreSaved) {
    Scene scene{World(), {}, {}, {}, {}};
    BodyDef def;
    def.name = "caf\xe9"; // Latin-1
    scene.world.create_body(def);
    const Scene again = load_text(scene::save_to_string(scene));
    EXPECT_EQ(again.world.body(again.world.bodies().at(0)).name(), "caf\xef\xbf\xbd");
}

TEST(SceneSave, EmptyWorld) { expect_stable(Scene{World(), {}, {}, {}, {}}); }

TEST(SceneSave, WritesAFileAndLeavesNothingBeside) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "cairn_save_test";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const Scene scene = load_nodes(node(R"("name":"ball",)", R"("motion":{},)" + sphere));
    scene::save(scene, folder / "ball.gltf");
    scene::save(scene, folder / "ball.gltf"); // overwrites the first file
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
