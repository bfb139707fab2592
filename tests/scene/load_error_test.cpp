// Files that are rejected, each with the one-line message for its author.
#include "scene_text.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <iterator>
#include <ostream>
#include <random>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;

struct Refused {
    const char* label;
    std::string text;
    ErrorCode code;
    std::string message;
};
std::ostream& operator<<(std::ostream& out, const Refused& refused) { return out << refused.label; }

std::string nodes_text(const std::string& nodes, const std::string& roots = "0") {
    Parts parts;
    parts.nodes = nodes;
    parts.roots = roots;
    return document(parts);
}

std::string motion_text(const std::string& motion) {
    return nodes_text(node("", R"("motion":{)" + motion + "}," + box));
}

std::string world_text(const std::string& world) {
    Parts parts;
    parts.world = world;
    return document(parts);
}

std::string shape_text(const std::string& shape, const std::string& physics = sphere) {
    Parts parts;
    parts.shapes = shape;
    parts.nodes = node("", physics);
    return document(parts);
}

std::string material_text(const std::string& material) {
    Parts parts;
    parts.materials = "{" + material + "}";
    parts.nodes = node("", R"("collider":{"geometry":{"shape":0},"physicsMaterial":0})");
    return document(parts);
}

const std::string at_motion = "test.gltf: nodes[0].extensions.KHR_physics_rigid_bodies.motion";
const std::string at_collider = "test.gltf: nodes[0].extensions.KHR_physics_rigid_bodies.collider";
const std::string at_shape = "test.gltf: extensions.KHR_implicit_shapes.shapes[0]";
const std::string at_material = "test.gltf: extensions.KHR_physics_rigid_bodies.physicsMaterials[0]";
const std::string at_world = "test.gltf: scenes[0].extensions.CAIRN_world";

constexpr ErrorCode invalid = ErrorCode::invalid_file, unsupported = ErrorCode::unsupported;

std::vector<Refused> refused_files() {
    return {
        {"Empty", "", invalid, "test.gltf: is empty"},
        {"NotAnObject", "[]", invalid, "test.gltf: must be an object, got []"},
        {"NoAsset", "{}", invalid, "test.gltf: must have a member \"asset\""},
        {"OldVersion", R"({"asset":{"version":"1.0"}})", unsupported,
         "test.gltf: asset.version: must be a version 2 of glTF, got \"1.0\""},
        {"RequiredExtension", R"({"asset":{"version":"2.0"},"extensionsRequired":["X_y"]})", unsupported,
         "test.gltf: extensionsRequired[0]: the file requires the extension \"X_y\", which is not supported"},
        {"SceneOutOfRange", R"({"asset":{"version":"2.0"},"scene":1,"scenes":[{}]})", invalid,
         "test.gltf: scene: must be the index of one of the 1 scenes, got 1"},
        {"SceneWithoutScenes", R"({"asset":{"version":"2.0"},"scene":0})", invalid,
         "test.gltf: scene: must be the index of one of the 0 scenes, got 0"},
        {"NegativeMass", motion_text(R"("mass":-2)"), invalid, at_motion + ".mass: must be >= 0, got -2"},
        {"MassBeyondFloat", motion_text(R"("mass":1e300)"), invalid, at_motion + ".mass: must be >= 0, got 1e+300"},
        {"MassAsText", motion_text(R"("mass":"2")"), invalid, at_motion + ".mass: must be a number, got \"2\""},
        {"ShortVector", motion_text(R"("linearVelocity":[1,2])"), invalid,
         at_motion + ".linearVelocity: must be an array of 3 numbers, got [1,2]"},
        {"NullInVector", motion_text(R"("linearVelocity":[1,2,null])"), invalid,
         at_motion + ".linearVelocity[2]: must be a number, got null"},
        {"KinematicAsNumber", motion_text(R"("isKinematic":1)"), invalid,
         at_motion + ".isKinematic: must be true or false, got 1"},
        {"NegativeInertia", motion_text(R"("inertiaDiagonal":[1,1,-1])"), invalid,
         at_motion + ".inertiaDiagonal[2]: must be >= 0, got -1"},
        {"MotionAsArray", nodes_text(node("", R"("motion":[])")), invalid, at_motion + ": must be an object, got []"},
        {"ZeroRotation", nodes_text(R"({"rotation":[0,0,0,0]})"), invalid,
         "test.gltf: nodes[0].rotation: must be a unit quaternion, got [0,0,0,0]"},
        {"MatrixBesideTranslation", nodes_text(R"({"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"translation":[0,0,0]})"),
         invalid, "test.gltf: nodes[0].translation: must not stand beside a matrix, got [0,0,0]"},
        {"ShortMatrix", nodes_text(R"({"matrix":[1,2]})"), invalid,
         "test.gltf: nodes[0].matrix: must be an array of 16 numbers, got [1,2]"},
        {"ProjectiveMatrix", nodes_text(R"({"matrix":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]})"), invalid,
         "test.gltf: nodes[0].matrix: must be an affine transform, with 0, 0, 0, 1 as its last row, got an array of "
         "16"},
        {"Skewed",
         nodes_text(R"({"scale":[1,3,1],"children":[1]},{"rotation":[0,0,0.38268343,0.92387953],)" +
                    node("", box).substr(1)),
         unsupported,
         "test.gltf: nodes[1]: is skewed by a rotation below a nonuniform scale, which would distort its shapes"},
        {"RootOutOfRange", nodes_text("{}", "1"), invalid,
         "test.gltf: scenes[0].nodes[0]: must be the index of one of the 1 nodes, got 1"},
        {"NegativeIndex", nodes_text("{}", "-1"), invalid,
         "test.gltf: scenes[0].nodes[0]: must be the index of one of the nodes, got -1"},
        {"RootTwice", nodes_text("{}", "0,0"), invalid,
         "test.gltf: scenes[0].nodes[1]: must not be listed twice, got 0"},
        {"RootWithAParent", nodes_text(R"({"children":[1]},{})", "0,1"), invalid,
         "test.gltf: scenes[0].nodes[1]: must be a root, and nodes[1] is a child of nodes[0], got 1"},
        {"ChildTwice", nodes_text(R"({"children":[1,1]},{})"), invalid,
         "test.gltf: nodes[0].children[1]: must not be listed twice; nodes[1] is a child of nodes[0] already, got 1"},
        {"TwoParents", nodes_text(R"({"children":[2]},{"children":[2]},{})", "0,1"), invalid,
         "test.gltf: nodes[1].children[0]: must not be listed twice; nodes[2] is a child of nodes[0] already, got 2"},
        {"OwnParent", nodes_text(R"({"children":[0]})"), invalid,
         "test.gltf: nodes[0]: must not be its own ancestor, got an object"},
        {"Circle", nodes_text(R"({},{"children":[2]},{"children":[3]},{"children":[1]})"), invalid,
         "test.gltf: nodes[2]: must not be its own ancestor, got an object"},
        {"ChildrenAsObject", nodes_text(R"({"children":{}})"), invalid,
         "test.gltf: nodes[0].children: must be an array, got an object"},
        {"ShapeOutOfRange", nodes_text(node("", R"("collider":{"geometry":{"shape":9}})")), invalid,
         at_collider + ".geometry.shape: must be the index of one of the 3 shapes, got 9"},
        {"ShapeMissing", nodes_text(node("", R"("collider":{"geometry":{}})")), invalid,
         at_collider + ".geometry: must have a member \"shape\" or \"node\", got an object"},
        {"GeometryMissing", nodes_text(node("", R"("collider":{})")), invalid,
         at_collider + ": must have a member \"geometry\""},
        {"NoShapes", shape_text(""), invalid,
         at_collider + ".geometry.shape: must be left out, as the file has no shapes, got 0"},
        {"NodeWithoutAMesh", nodes_text(node("", R"("collider":{"geometry":{"node":0}})")), invalid,
         at_collider + ".geometry.node: must be the index of a node with a mesh that has triangles, on itself or below "
                       "it, got 0"},
        {"NodeAndShape", nodes_text(node("", R"("collider":{"geometry":{"node":0,"shape":0}})")), invalid,
         at_collider + ".geometry.node: must not stand beside a shape, got 0"},
        {"TriggerWithoutGeometry", nodes_text(node("", R"("trigger":{})")), invalid,
         "test.gltf: nodes[0].extensions.KHR_physics_rigid_bodies.trigger: must have a member \"geometry\""},
        {"JointWithoutRules", nodes_text(node("", R"("joint":{"joint":0,"connectedNode":0})")), invalid,
         "test.gltf: nodes[0].extensions.KHR_physics_rigid_bodies.joint.joint: must be left out, as the file has no "
         "joints, got 0"},
        {"DynamicPlane", nodes_text(node("", R"("motion":{},)" + plane)), unsupported,
         at_collider + ".geometry: planes and height fields have no mass and may only belong to static and kinematic "
                       "bodies"},
        {"UnknownShape", shape_text(R"({"type":"torus"})"), unsupported,
         at_shape + ".type: shapes of the type \"torus\" are not supported; there are sphere, box, capsule, cylinder, "
                    "plane and CAIRN_height_field"},
        {"PointlessCapsule", shape_text(R"({"type":"capsule","capsule":{"radiusBottom":0,"radiusTop":0}})"), invalid,
         at_shape + ".capsule: must have a positive radius at one end at least, got an object"},
        {"FlatCylinder", shape_text(R"({"type":"cylinder","cylinder":{"height":0}})"), invalid,
         at_shape + ".cylinder.height: must be > 0, got 0"},
        {"TypeMissing", shape_text(R"({"sphere":{}})"), invalid, at_shape + ": must have a member \"type\""},
        {"ZeroRadius", shape_text(R"({"type":"sphere","sphere":{"radius":0}})"), invalid,
         at_shape + ".sphere.radius: must be > 0, got 0"},
        {"FlatBox", shape_text(R"({"type":"box","box":{"size":[1,0,1]}})"), invalid,
         at_shape + ".box.size[1]: must be > 0, got 0"},
        {"SidesOfAPlane", shape_text(R"({"type":"plane","plane":{"doubleSided":2}})"), invalid,
         at_shape + ".plane.doubleSided: must be true or false, got 2"},
        {"NegativePlane", shape_text(R"({"type":"plane","plane":{"sizeX":-1}})"), invalid,
         at_shape + ".plane.sizeX: must be >= 0, got -1"},
        {"NegativeRounding", shape_text(R"({"type":"box","extensions":{"CAIRN_shape":{"rounding":-1}}})"), invalid,
         at_shape + ".extensions.CAIRN_shape.rounding: must be >= 0, got -1"},
        {"NegativeFriction", material_text(R"("staticFriction":-1)"), invalid,
         at_material + ".staticFriction: must be >= 0, got -1"},
        {"RestitutionAboveOne", material_text(R"("restitution":1.5)"), invalid,
         at_material + ".restitution: must be 0 to 1, got 1.5"},
        {"UnknownRule", material_text(R"("frictionCombine":"sum")"), invalid,
         at_material + ".frictionCombine: must be \"average\", \"minimum\", \"maximum\" or \"multiply\", got \"sum\""},
        {"ZeroTimeStep", world_text(R"("time_step":0)"), invalid, at_world + ".time_step: must be 0.0001 to 1, got 0"},
        {"HalfASubstep", world_text(R"("substeps":1.5)"), invalid,
         at_world + ".substeps: must be a whole number from 0 to 256, got 1.5"},
        {"UnknownIntegrator", world_text(R"("integrator":"verlet")"), invalid,
         at_world + ".integrator: must be \"semi_implicit_euler\", \"explicit_euler\" or \"rk4\", got \"verlet\""},
        {"CameraOnTarget", world_text(R"("camera":{"position":[1,2,3],"target":[1,2,3]})"), invalid,
         at_world + ".camera.target: must not be the camera's own position, got [1,2,3]"},
        {"UnknownField", world_text(R"("force_fields":[{"kind":"vortex"}])"), invalid,
         at_world + ".force_fields[0].kind: must be \"uniform\", \"radial\" or \"fluid\", got \"vortex\""},
        {"ShallowFluid", world_text(R"("force_fields":[{"kind":"fluid","center":[0,0,0],"half_extents":[1,0,null]}])"),
         invalid, at_world + ".force_fields[0].half_extents[1]: must be > 0, got 0"},
        {"FlatFluid", world_text(R"("force_fields":[{"kind":"fluid","center":[0,0,0],"half_extents":[1,2]}])"), invalid,
         at_world + ".force_fields[0].half_extents: must be an array of 3 numbers > 0 or null, got [1,2]"},
        {"CutOffContainer", std::string("glTF\x02\0\0\0\x64\0\0\0", 12), invalid,
         "test.gltf: is an incomplete .glb file: its header says 100 bytes, and there are 12"},
        {"CutOffHeader", "glTF\x02", invalid, "test.gltf: is a .glb file that ends within its header"},
        {"OldContainer", std::string("glTF\x01\0\0\0\x0c\0\0\0", 12), unsupported,
         "test.gltf: must be a .glb file of version 2, got 1"},
        {"ContainerWithoutJson", std::string("glTF\x02\0\0\0\x0c\0\0\0", 12), invalid,
         "test.gltf: is a .glb file without a JSON chunk"},
    };
}

class SceneRefused : public testing::TestWithParam<Refused> {};

TEST_P(SceneRefused, WithOneClearLine) {
    try {
        load_text(GetParam().text);
        FAIL() << "loaded";
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), GetParam().message);
        EXPECT_EQ(error.code(), GetParam().code);
    }
}

INSTANTIATE_TEST_SUITE_P(Files, SceneRefused, testing::ValuesIn(refused_files()),
                         [](const testing::TestParamInfo<Refused>& info) { return std::string(info.param.label); });

void expect_error(const std::function<void()>& call, ErrorCode code, const std::string& part) {
    try {
        call();
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code);
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

TEST(SceneRefusedText, CutOffJson) {
    const std::string text = document({});
    for (std::size_t length = 1; length < text.size(); ++length) {
        expect_error([&] { load_text(text.substr(0, length)); }, invalid, "test.gltf: is not valid JSON: parse error");
    }
}

TEST(SceneRefusedText, NumbersThatAreNone) {
    for (const char* number : {"NaN", "Infinity", "1e999", "-1e999"}) {
        expect_error([&] { load_text(motion_text(std::string(R"("mass":)") + number)); }, invalid,
                     "test.gltf: is not valid JSON");
    }
}

TEST(SceneRefusedText, InvalidUtf8) {
    expect_error([] { load_text(nodes_text("{\"name\":\"\xff\"}")); }, invalid, "test.gltf: is not valid JSON");
}

TEST(SceneRefusedText, DeeplyNestedJson) {
    const std::string deep = std::string(100000, '[') + std::string(100000, ']');
    expect_error([&] { load_text(deep); }, invalid, "test.gltf: is nested more than 64 levels deep");
}

TEST(SceneRefusedText, DeeplyNestedNodes) {
    std::string nodes = R"({"children":[1]})";
    for (int i = 1; i < 100000; ++i) nodes += R"(,{"children":[)" + std::to_string(i + 1) + "]}";
    expect_error([&] { load_text(nodes_text(nodes + ",{}")); }, invalid, "must be at most 256 nodes below its root");
}

TEST(SceneRefusedText, LongName) {
    expect_error([] { load_text(nodes_text(node(R"("name":")" + std::string(5000, 'x') + R"(",)", box))); }, invalid,
                 "nodes[0].name: must have at most 4096 bytes, got \"xxx");
}

TEST(SceneRefusedText, FiltersThatSayBoth) {
    Parts parts;
    parts.filters = R"({"collideWithSystems":["a"],"notCollideWithSystems":["a"]})";
    expect_error([&] { load_text(document(parts)); }, invalid,
                 "test.gltf: extensions.KHR_physics_rigid_bodies.collisionFilters[0].notCollideWithSystems: must not");
}

TEST(SceneRefusedText, ScalesThatMultiplyBeyondReason) {
    expect_error(
        [] { load_nodes(R"({"children":[1],"scale":[1e6,1e6,1e6]},)" + node(R"("scale":[1e6,1e6,1e6],)", box)); },
        invalid, "test.gltf: nodes[1]: is too far from the origin or too large, with the transforms above it");
}

TEST(SceneRefusedText, FilesThatCannotBeRead) {
    expect_error([] { scene::load("no/such/file.gltf"); }, ErrorCode::io, "no/such/file.gltf: there is no such file");
    expect_error([] { scene::load(std::filesystem::temp_directory_path()); }, ErrorCode::io, "is a folder, not a file");
}

// Damaged files are rejected or loaded, and nothing else happens. The damage is the same in every run.
TEST(SceneRefusedText, RandomDamage) {
    Parts parts;
    parts.world = R"("gravity":[0,-9.81,0],"camera":{"position":[1,2,3],"target":[0,1,0]})";
    parts.nodes = node(R"("name":"a","translation":[0,1,0],"rotation":[0,0.6,0,0.8],"children":[1],)",
                       R"("motion":{"mass":2,"centerOfMass":[0,0.1,0],"linearVelocity":[1,0,0]})") +
                  "," + node(R"("scale":[1,2,1],)", R"("collider":{"geometry":{"shape":1},"physicsMaterial":0})") +
                  "," + node("", plane);
    parts.roots = "0,2";
    const std::string whole = document(parts);
    ASSERT_EQ(load_text(whole).world.bodies().size(), 2u);
    static constexpr const char* pieces[] = {"-1", "1e300", "1e-300", "0",  "[", "]",
                                             "{",  "}",     "null",   "\"", ",", "9999999999"};
    std::mt19937 random(20);
    int loaded = 0, refused = 0;
    for (int round = 0; round < 4000; ++round) {
        std::string text = whole;
        for (unsigned damage = 1 + random() % 3; damage > 0; --damage) {
            const std::size_t place = random() % text.size();
            switch (random() % 3) {
            case 0:
                text[place] = static_cast<char>(random() % 256);
                break;
            case 1:
                text.erase(place, 1 + random() % 4);
                break;
            default:
                text.replace(place, random() % 3, pieces[random() % std::size(pieces)]);
                break;
            }
        }
        try {
            Scene scene = load_text(text);
            scene.world.step(scene.info.time_step);
            ++loaded;
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find("test.gltf: "), 0u) << error.what();
            ++refused;
        }
    }
    EXPECT_GT(loaded, 100);
    EXPECT_GT(refused, 1000);
}

} // namespace
