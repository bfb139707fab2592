// Loading of well-formed files.
#include "scene_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;

const Body only_body(const Scene& scene) {
    EXPECT_EQ(scene.world.bodies().size(), 1u);
    return scene.world.body(scene.world.bodies().at(0));
}

void expect_equal(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance = 1e-6) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << "component " << i;
}

TEST(SceneLoad, EmptyMotionMakesADynamicBody) {
    const Scene scene = load_nodes(node(R"("name":"ball","translation":[1,2,3],)", R"("motion":{},)" + sphere));
    const Body body = only_body(scene);
    EXPECT_EQ(body.type(), BodyType::dynamic);
    EXPECT_EQ(body.name(), "ball");
    expect_equal(body.position(), {1, 2, 3});
    EXPECT_NEAR(body.mass(), 1000.0 * 4.0 / 3.0 * 3.14159265 * 0.125, 0.1);
}

TEST(SceneLoad, ColliderWithoutMotionIsStatic) {
    const Scene scene = load_nodes(node("", plane));
    EXPECT_EQ(only_body(scene).type(), BodyType::static_);
    const ShapeId shape = only_body(scene).shapes().at(0);
    EXPECT_FALSE(std::get<Plane>(scene.world.shape(shape)).half_extents.has_value());
}

TEST(SceneLoad, KinematicMotion) {
    const Scene scene =
        load_nodes(node("", R"("motion":{"isKinematic":true,"mass":3,"linearVelocity":[0,1,0]},)" + box));
    EXPECT_EQ(only_body(scene).type(), BodyType::kinematic);
    expect_equal(only_body(scene).linear_velocity(), {0, 1, 0});
}

TEST(SceneLoad, MassAndGravityFactor) {
    const Scene scene = load_nodes(node("", R"("motion":{"mass":7.5,"gravityFactor":-0.5},)" + box));
    EXPECT_FLOAT_EQ(only_body(scene).mass(), 7.5f);
    EXPECT_FLOAT_EQ(only_body(scene).gravity_scale(), -0.5f);
    // The moments of inertia of a box of 1 x 2 x 3 m: m (y^2 + z^2) / 12 and so on.
    const MassProperties properties = only_body(scene).mass_properties();
    const glm::dmat3 inertia(only_body(scene).world_inertia());
    EXPECT_NEAR(inertia[0][0], 7.5 * 13 / 12, 1e-4);
    EXPECT_NEAR(inertia[1][1], 7.5 * 10 / 12, 1e-4);
    EXPECT_NEAR(inertia[2][2], 7.5 * 5 / 12, 1e-4);
    expect_equal(properties.center_of_mass, {0, 0, 0});
}

TEST(SceneLoad, MassZeroIsInfinite) {
    const Scene scene = load_nodes(node("", R"("motion":{"mass":0},)" + box));
    EXPECT_EQ(only_body(scene).type(), BodyType::dynamic);
    EXPECT_TRUE(std::isinf(only_body(scene).mass()));
}

TEST(SceneLoad, InertiaZeroNeverTurns) {
    const Scene scene = load_nodes(node("", R"("motion":{"mass":2,"inertiaDiagonal":[0,0,0]},)" + box));
    EXPECT_EQ(only_body(scene).mass_properties().inertia_diagonal, Vec3(0.0f));
    EXPECT_FLOAT_EQ(only_body(scene).mass(), 2.0f);
}

TEST(SceneLoad, GivenCenterOfMassAndInertia) {
    const Scene scene = load_nodes(node("", R"("motion":{"mass":2,"centerOfMass":[0,-0.25,0],"inertiaDiagonal":[1,2,3],
        "inertiaOrientation":[0,0,0.70710678,0.70710678]},)" +
                                                box));
    const MassProperties properties = only_body(scene).mass_properties();
    expect_equal(properties.center_of_mass, {0, -0.25, 0});
    expect_equal(only_body(scene).center_of_mass(), {0, -0.25, 0});
    const Mat3 inertia = only_body(scene).world_inertia();
    EXPECT_NEAR(inertia[0][0], 2.0f, 1e-5); // rotated by 90 degrees about z: x and y are exchanged
    EXPECT_NEAR(inertia[1][1], 1.0f, 1e-5);
    EXPECT_NEAR(inertia[2][2], 3.0f, 1e-5);
}

TEST(SceneLoad, MotionWithoutAColliderHasAMassAndAWarning) {
    const Scene scene = load_nodes(node("", R"("motion":{"mass":2})"));
    EXPECT_FLOAT_EQ(only_body(scene).mass(), 2.0f);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("nodes[0].extensions.KHR_physics_rigid_bodies.motion"), std::string::npos);
}

TEST(SceneLoad, VelocitiesAreInTheNodesAxes) {
    // The parent is rotated by 90 degrees about y, which maps z to x.
    const Scene scene = load_nodes(R"({"children":[1],"rotation":[0,0.70710678,0,0.70710678]},)" +
                                   node("", R"("motion":{"angularVelocity":[0,0,1],"linearVelocity":[0,0,2]},)" + box));
    expect_equal(only_body(scene).angular_velocity(), {1, 0, 0});
    expect_equal(only_body(scene).linear_velocity(), {2, 0, 0});
}

TEST(SceneLoad, TransformsComposeDownTheHierarchy) {
    const Scene scene =
        load_nodes(R"({"children":[1],"translation":[10,0,0],"rotation":[0,0.70710678,0,0.70710678]},)" +
                   node(R"("translation":[0,0,5],)", R"("motion":{},)" + sphere));
    expect_equal(only_body(scene).position(), {15, 0, 0});
}

TEST(SceneLoad, MatrixIsTheSameAsItsParts) {
    // Rotation by 90 degrees about y, scale 2, translation (1, 2, 3).
    const Scene scene = load_nodes(node(R"("matrix":[0,0,-2,0, 0,2,0,0, 2,0,0,0, 1,2,3,1],)", R"("motion":{},)" + box));
    expect_equal(only_body(scene).position(), {1, 2, 3});
    EXPECT_NEAR(std::fabs(only_body(scene).rotation().y), 0.70710678, 1e-6);
    const Box shape = std::get<Box>(scene.world.shape(only_body(scene).shapes().at(0)));
    expect_equal(shape.half_extents, {1, 2, 3});
}

TEST(SceneLoad, ScaleIsBakedIntoShapesAndNegativeScaleIsItsSize) {
    const Scene scene = load_nodes(node(R"("scale":[1,-2,3],)", R"("motion":{},)" + box));
    const Box shape = std::get<Box>(scene.world.shape(only_body(scene).shapes().at(0)));
    expect_equal(shape.half_extents, {0.5, 2, 4.5});
}

TEST(SceneLoad, ZeroScaleDisablesTheCollider) {
    const Scene scene = load_nodes(node(R"("scale":[0,0,0],)", box));
    EXPECT_TRUE(only_body(scene).shapes().empty());
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("disabled by a scale of zero"), std::string::npos);
}

TEST(SceneLoad, CollidersBelowAMotionAreOneBody) {
    const Scene scene = load_nodes(node(R"("children":[1,2],"scale":[2,2,2],)", R"("motion":{})") + "," +
                                   node(R"("translation":[0,1,0],)", box) + "," +
                                   node(R"("children":[3],"translation":[0,-1,0],)", sphere) + "," +
                                   node(R"("translation":[1,0,0],)", sphere));
    const std::vector<ShapeId> shapes = only_body(scene).shapes();
    ASSERT_EQ(shapes.size(), 3u);
    expect_equal(scene.world.shape_def(shapes[0]).position, {0, 2, 0});
    expect_equal(scene.world.shape_def(shapes[1]).position, {0, -2, 0});
    expect_equal(scene.world.shape_def(shapes[2]).position, {2, -2, 0});
    EXPECT_FLOAT_EQ(std::get<Sphere>(scene.world.shape(shapes[1])).radius, 1.0f);
}

TEST(SceneLoad, MotionBelowAMotionIsABodyOfItsOwn) {
    const Scene scene = load_nodes(node(R"("children":[1],)", R"("motion":{},)" + box) + "," +
                                   node(R"("translation":[5,0,0],)", R"("motion":{},)" + sphere));
    ASSERT_EQ(scene.world.bodies().size(), 2u);
    for (const BodyId id : scene.world.bodies()) EXPECT_EQ(scene.world.body(id).shapes().size(), 1u);
}

TEST(SceneLoad, StaticCollidersAreSeparateUnlessMarkedAsABody) {
    const std::string children = node("", box) + "," + node(R"("translation":[5,0,0],)", box);
    EXPECT_EQ(load_nodes(R"({"children":[1,2]},)" + children).world.bodies().size(), 2u);
    const Scene marked = load_nodes(R"({"children":[1,2],"extensions":{"CAIRN_body":{}}},)" + children);
    EXPECT_EQ(only_body(marked).shapes().size(), 2u);
}

TEST(SceneLoad, Damping) {
    const Scene scene = load_nodes(R"({"extensions":{"CAIRN_body":{"linear_damping":0.5,"angular_damping":0.25},
        "KHR_physics_rigid_bodies":{"motion":{},)" +
                                   box + "}}}");
    EXPECT_FLOAT_EQ(only_body(scene).linear_damping(), 0.5f);
    EXPECT_FLOAT_EQ(only_body(scene).angular_damping(), 0.25f);
}

TEST(SceneLoad, WhatIsDisabledOrNeverSleeps) {
    const Scene scene = load_nodes(R"({"extensions":{"CAIRN_body":{"allow_sleep":false,"enabled":false},
        "KHR_physics_rigid_bodies":{"motion":{"mass":3,"linearVelocity":[1,0,0]},)" +
                                   box + "}}}");
    const Body body = only_body(scene);
    EXPECT_FALSE(body.enabled() || body.allow_sleep());
    EXPECT_EQ(body.type(), BodyType::dynamic);
    EXPECT_EQ(body.mass(), 3.0f);
    EXPECT_EQ(body.linear_velocity(), Vec3(1.0f, 0.0f, 0.0f));
}

TEST(SceneLoad, Materials) {
    Parts parts;
    parts.nodes = node("", R"("motion":{},"collider":{"geometry":{"shape":1},"physicsMaterial":1})");
    parts.materials += R"(,{"staticFriction":0.9,"dynamicFriction":0.7,"restitution":0.2,"frictionCombine":"multiply",
        "restitutionCombine":"maximum","extensions":{"CAIRN_material":{"density":500,"rolling_friction":0.01,
        "torsional_friction":0.02}}})";
    const Scene scene = load_text(document(parts));
    const ShapeDef& def = scene.world.shape_def(only_body(scene).shapes().at(0));
    EXPECT_FLOAT_EQ(def.material.static_friction, 0.9f);
    EXPECT_FLOAT_EQ(def.material.dynamic_friction, 0.7f);
    EXPECT_FLOAT_EQ(def.material.restitution, 0.2f);
    EXPECT_EQ(def.material.friction_combine, CombineRule::multiply);
    EXPECT_EQ(def.material.restitution_combine, CombineRule::maximum);
    EXPECT_FLOAT_EQ(def.material.rolling_friction, 0.01f);
    EXPECT_FLOAT_EQ(def.material.torsional_friction, 0.02f);
    EXPECT_NEAR(only_body(scene).mass(), 3000.0f, 0.01f);
}

TEST(SceneLoad, FinitePlane) {
    Parts parts;
    parts.shapes += R"(,{"type":"plane","plane":{"sizeX":4,"sizeZ":6,"doubleSided":false}})";
    parts.nodes = node(R"("scale":[2,1,1],)", R"("collider":{"geometry":{"shape":3}})");
    const Scene scene = load_text(document(parts));
    const Plane shape = std::get<Plane>(scene.world.shape(only_body(scene).shapes().at(0)));
    ASSERT_TRUE(shape.half_extents.has_value());
    EXPECT_FLOAT_EQ(shape.half_extents->x, 4.0f);
    EXPECT_FLOAT_EQ(shape.half_extents->y, 3.0f);
}

TEST(SceneLoad, StripsAndSheets) {
    Parts parts;
    parts.shapes +=
        R"(,{"type":"plane","plane":{"sizeX":4,"doubleSided":true}},{"type":"plane","plane":{"sizeX":0,"sizeZ":6}},
        {"type":"plane","plane":{"sizeX":0,"sizeZ":0,"doubleSided":true}})";
    for (int i = 3; i < 6; ++i) {
        parts.nodes = node("", R"("collider":{"geometry":{"shape":)" + std::to_string(i) + "}}");
        const Scene scene = load_text(document(parts));
        const Plane shape = std::get<Plane>(scene.world.shape(only_body(scene).shapes().at(0)));
        EXPECT_EQ(shape.double_sided, i != 4);
        ASSERT_EQ(shape.half_extents.has_value(), i != 5);
        if (i == 3) {
            EXPECT_EQ(shape.half_extents->x, 2.0f);
            EXPECT_TRUE(std::isinf(shape.half_extents->y));
        } else if (i == 4) {
            EXPECT_TRUE(std::isinf(shape.half_extents->x));
            EXPECT_EQ(shape.half_extents->y, 3.0f);
        }
    }
}

TEST(SceneLoad, Rounding) {
    Parts parts;
    parts.shapes +=
        R"(,{"type":"box","extensions":{"CAIRN_shape":{"rounding":0.1}}},
        {"type":"cylinder","extensions":{"CAIRN_shape":{"rounding":0.2}}},
        {"type":"sphere","extensions":{"CAIRN_shape":{"rounding":0.2}}})";
    parts.nodes = node(R"("scale":[2,2,2],)", R"("collider":{"geometry":{"shape":3}})");
    Scene scene = load_text(document(parts));
    EXPECT_FLOAT_EQ(std::get<Box>(scene.world.shape(only_body(scene).shapes().at(0))).rounding, 0.2f);
    EXPECT_TRUE(scene.warnings.empty());
    parts.nodes = node(R"("scale":[2,1,2],)", R"("collider":{"geometry":{"shape":4}})");
    scene = load_text(document(parts));
    EXPECT_FLOAT_EQ(std::get<Cylinder>(scene.world.shape(only_body(scene).shapes().at(0))).rounding, 0.4f);
    EXPECT_EQ(scene.warnings.size(), 1u) << "unevenly scaled";
    parts.nodes = node("", R"("collider":{"geometry":{"shape":5}})");
    EXPECT_EQ(load_text(document(parts)).warnings.size(), 1u) << "balls have no edges";
}

TEST(SceneLoad, WorldSettings) {
    Parts parts;
    parts.world = R"("title":"A title","hint":"A hint","gravity":[0,-1.62,0],"substeps":12,"adaptive_substeps":false,
        "integrator":"rk4","time_step":0.01,"sleep":false,"restitution_speed":0.5,
        "camera":{"position":[1,2,3],"target":[0,1,0],"vertical_fov_degrees":30},
        "force_fields":[{"kind":"uniform","direction":[1,0,0]},
                        {"kind":"radial","center":[0,5,0],"strength":3,"exponent":-2,"is_force":true},
                        {"kind":"fluid","center":[0,2,0],"direction":[1,0,0],"half_extents":[3,null,4],"density":800,
                         "drag":0.5,"skin_friction":0.02}])";
    const Scene scene = load_text(document(parts));
    EXPECT_EQ(scene.info.title, "A title");
    EXPECT_EQ(scene.info.hint, "A hint");
    EXPECT_FLOAT_EQ(scene.info.time_step, 0.01f);
    const WorldDef& settings = scene.world.settings();
    EXPECT_EQ(settings.gravity, Vec3(0.0f, -1.62f, 0.0f));
    EXPECT_EQ(settings.substeps, 12);
    EXPECT_FALSE(settings.adaptive_substeps);
    EXPECT_EQ(settings.integrator, Integrator::rk4);
    EXPECT_FALSE(settings.enable_sleep);
    EXPECT_FLOAT_EQ(settings.restitution_speed, 0.5f);
    ASSERT_TRUE(scene.info.camera.has_value());
    EXPECT_EQ(scene.info.camera->position, Position(1, 2, 3));
    EXPECT_FLOAT_EQ(scene.info.camera->vertical_fov_degrees, 30.0f);
    ASSERT_EQ(scene.force_fields.size(), 3u);
    EXPECT_TRUE(scene.world.is_valid(scene.force_fields[1]));
    const ForceField& fluid = scene.world.force_field(scene.force_fields[2]);
    EXPECT_EQ(fluid.kind, ForceField::Kind::fluid);
    EXPECT_EQ(fluid.center, Position(0, 2, 0));
    EXPECT_EQ(fluid.direction, Vec3(1, 0, 0));
    EXPECT_EQ(fluid.half_extents, Vec3(3, std::numeric_limits<float>::infinity(), 4));
    EXPECT_EQ(fluid.density, 800.0f);
    EXPECT_EQ(fluid.drag, 0.5f);
    EXPECT_EQ(fluid.skin_friction, 0.02f);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(SceneLoad, UnknownWorldSettingIsWarnedOf) {
    Parts parts;
    parts.world = R"("gravitiy":[0,0,0])";
    const Scene scene = load_text(document(parts));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0],
              "test.gltf: scenes[0].extensions.CAIRN_world: the member \"gravitiy\" is not known and "
              "has no effect; did you mean \"gravity\"?");
}

TEST(SceneLoad, ColorsOfNodesAndOfMeshes) {
    Parts parts;
    parts.nodes = R"({"extras":{"cairn_color":[0.25,0.5,1]},"extensions":{"KHR_physics_rigid_bodies":{)" + box +
                  "}}}," + node(R"("mesh":0,)", sphere);
    parts.roots = "0,1";
    parts.more = R"(,"meshes":[{"primitives":[{"material":0}]}],
        "materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,0.5,0.25,1]}}])";
    const Scene scene = load_text(document(parts));
    ASSERT_EQ(scene.appearances.size(), 2u);
    EXPECT_EQ(scene.appearances[0].color, Vec3(0.25f, 0.5f, 1.0f));
    EXPECT_EQ(scene.appearances[1].color, Vec3(1.0f, 0.5f, 0.25f));
    EXPECT_EQ(scene.world.body_of(scene.appearances[1].shape), scene.appearances[1].body);
}

// A mesh whose texture cannot be shown is gray instead of white, with a warning.
TEST(SceneLoad, TexturesAreGrayAndSaidToBe) {
    Parts parts;
    parts.nodes = node(R"("mesh":0,)", sphere) + "," + node(R"("mesh":1,)", sphere);
    parts.roots = "0,1";
    parts.more = R"(,"meshes":[{"primitives":[{"material":0,"attributes":{"POSITION":0}}]},
        {"primitives":[{"material":1,"attributes":{"POSITION":0}}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
        "bufferViews":[{"buffer":0,"byteLength":36}],
        "buffers":[{"byteLength":36,"uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
        "materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}},
        {"pbrMetallicRoughness":{"baseColorFactor":[1,0.5,0,1],"baseColorTexture":{"index":0}}}])";
    const Scene scene = load_text(document(parts));
    ASSERT_EQ(scene.visuals.size(), 2u);
    EXPECT_EQ(scene.visuals[0].color, Vec3(0.4f));
    EXPECT_EQ(scene.visuals[1].color, 0.4f * Vec3(1.0f, 0.5f, 0.0f));
    ASSERT_EQ(scene.warnings.size(), 2u); // one for each mesh
    EXPECT_EQ(scene.warnings[0], "test.gltf: meshes[0].primitives[0].attributes: has no TEXCOORD_0 (its texture is not "
                                 "shown: a plain gray, tinted by the base color)");
}

TEST(SceneLoad, BinaryContainer) {
    std::string json = document({});
    while (json.size() % 4 != 0) json += ' ';
    const auto word = [](std::size_t value) {
        std::string bytes;
        for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
        return bytes;
    };
    const std::string file = "glTF" + word(2) + word(20 + json.size()) + word(json.size()) + "JSON" + json;
    EXPECT_TRUE(load_text(file).world.bodies().empty());
}

} // namespace
