// Capsules and cylinders, collision filters, triggers, joints and visual meshes, as the Khronos drafts define them.
#include "mesh_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;

ShapeId only_shape_id(const Scene& scene) {
    EXPECT_EQ(scene.world.bodies().size(), 1u);
    return scene.world.body(scene.world.bodies().at(0)).shapes().at(0);
}

Scene load_shape(const std::string& shape, const std::string& members = "") {
    Parts parts;
    parts.shapes = shape;
    parts.nodes = node(members, sphere);
    return load_text(document(parts));
}

TEST(SceneColumns, CapsulesAndCylindersHaveTheDraftsDefaults) {
    const Scene capsule = load_shape(R"({"type":"capsule"})"), cylinder = load_shape(R"({"type":"cylinder"})");
    const Capsule a = std::get<Capsule>(capsule.world.shape(only_shape_id(capsule)));
    const Cylinder b = std::get<Cylinder>(cylinder.world.shape(only_shape_id(cylinder)));
    EXPECT_EQ(a.half_height, 0.25f);
    EXPECT_EQ(a.radius, 0.25f);
    EXPECT_FALSE(a.radius_top.has_value());
    EXPECT_EQ(b.half_height, 0.25f);
    EXPECT_EQ(b.radius, 0.25f);
    EXPECT_FALSE(b.radius_top.has_value());
}

TEST(SceneColumns, TaperedOnes) {
    const Scene scene = load_shape(R"({"type":"cylinder","cylinder":{"height":3,"radiusBottom":2,"radiusTop":0.5}})",
                                   R"("scale":[2,-3,2],)");
    const Cylinder shape = std::get<Cylinder>(scene.world.shape(only_shape_id(scene)));
    EXPECT_EQ(shape.half_height, 4.5f);
    EXPECT_EQ(shape.radius, 4.0f);
    EXPECT_EQ(shape.radius_top, 1.0f);
    EXPECT_EQ(scene.world.shape_def(only_shape_id(scene)).rotation, Quat(1, 0, 0, 0));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(SceneColumns, ATipBelowIsTurnedUp) {
    const Scene scene = load_shape(R"({"type":"cylinder","cylinder":{"height":2,"radiusBottom":0,"radiusTop":1}})");
    const Cylinder shape = std::get<Cylinder>(scene.world.shape(only_shape_id(scene)));
    EXPECT_EQ(shape.radius, 1.0f);
    EXPECT_EQ(shape.radius_top, 0.0f);
    // A ray from above hits the base at y = 1, far from the axis.
    const auto hit = scene.world.cast_ray({0.9, 5, 0}, {0, -1, 0}, 10);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->point.y, 1.0, 1e-6);
}

TEST(SceneColumns, UnevenScalesKeepThemRoundAndWarn) {
    const Scene capsule = load_shape(R"({"type":"capsule","capsule":{"height":1}})", R"("scale":[1,2,3],)");
    const Capsule shape = std::get<Capsule>(capsule.world.shape(only_shape_id(capsule)));
    EXPECT_EQ(shape.half_height, 1.0f);
    EXPECT_EQ(shape.radius, 0.75f);
    ASSERT_EQ(capsule.warnings.size(), 1u);
    EXPECT_NE(capsule.warnings[0].find("a nonuniformly scaled capsule keeps round ends"), std::string::npos);
    EXPECT_EQ(load_shape(R"({"type":"cylinder"})", R"("scale":[1,1,2],)").warnings.size(), 1u);
}

// --- filters

Scene load_filters(const std::string& filters, const std::string& nodes, const std::string& roots) {
    Parts parts;
    parts.filters = filters;
    parts.nodes = nodes;
    parts.roots = roots;
    return load_text(document(parts));
}

std::string filtered(int filter) {
    return node("", R"("collider":{"geometry":{"shape":0},"collisionFilter":)" + std::to_string(filter) + "}");
}

bool meet(const Scene& scene, std::size_t a, std::size_t b) {
    const auto filter = [&](std::size_t i) {
        return scene.world.shape_def(scene.world.body(scene.world.bodies().at(i)).shapes().at(0)).filter;
    };
    const CollisionFilter x = filter(a), y = filter(b);
    return (x.layers & y.collides_with) != 0 && (y.layers & x.collides_with) != 0;
}

TEST(SceneFilters, SystemsAreLayersByName) {
    const Scene scene = load_filters(
        R"({"collisionSystems":["wood"],"collideWithSystems":["stone","wood"]},
           {"collisionSystems":["wood"],"collideWithSystems":["wood"]},
           {"collisionSystems":["stone"]},
           {"collisionSystems":["air"],"notCollideWithSystems":["stone"]},
           {"collisionSystems":["stone","wood"],"collideWithSystems":["stone","wood"]})",
        filtered(0) + "," + filtered(1) + "," + filtered(2) + "," + filtered(3) + "," + filtered(4) + "," +
            node("", sphere),
        "0,1,2,3,4,5");
    EXPECT_EQ(scene.collision_systems, (std::vector<std::string>{"air", "stone", "wood"}));
    EXPECT_TRUE(meet(scene, 0, 1));
    EXPECT_TRUE(meet(scene, 0, 2));
    EXPECT_FALSE(meet(scene, 1, 2));
    EXPECT_FALSE(meet(scene, 2, 3));
    EXPECT_FALSE(meet(scene, 0, 3)); // wood lists the systems that it collides with, and air is not among them
    EXPECT_TRUE(meet(scene, 1, 4));  // one of the last shape's systems is sufficient
    EXPECT_TRUE(meet(scene, 2, 5));
    EXPECT_TRUE(meet(scene, 3, 5));
    EXPECT_FALSE(meet(scene, 1, 5)); // a shape without a system is not listed either
    EXPECT_TRUE(meet(scene, 5, 5));
}

TEST(SceneFilters, AsManySystemsAsThereAreLayers) {
    const auto with = [](int count) {
        std::string names;
        for (int i = 0; i < count; ++i) names += (i == 0 ? "\"s" : ",\"s") + std::to_string(i) + "\"";
        return R"({"collisionSystems":[)" + names + "]}";
    };
    EXPECT_EQ(load_filters(with(63), filtered(0), "0").collision_systems.size(), 63u);
    try {
        load_filters(with(64), filtered(0), "0");
        FAIL() << "loaded";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "test.gltf: extensions.KHR_physics_rigid_bodies.collisionFilters[0]."
                                   "collisionSystems[63]: must be one of at most 63 different systems in a file, got "
                                   "\"s63\"");
    }
}

// --- triggers

TEST(SceneTriggers, AreShapesThatTouchNothing) {
    const Scene scene = load_nodes(node("", R"("motion":{"mass":2},"trigger":{"geometry":{"shape":1}},)" + sphere));
    const std::vector<ShapeId> shapes = scene.world.body(scene.world.bodies().at(0)).shapes();
    ASSERT_EQ(shapes.size(), 2u);
    EXPECT_FALSE(scene.world.shape_def(shapes[0]).is_trigger);
    EXPECT_TRUE(scene.world.shape_def(shapes[1]).is_trigger);
    EXPECT_TRUE(std::holds_alternative<Box>(scene.world.shape(shapes[1])));
    const Vec3 inertia = scene.world.body(scene.world.bodies()[0]).mass_properties().inertia_diagonal;
    EXPECT_NEAR(inertia.x, 0.4 * 2 * 0.25, 1e-6); // of the ball only
}

TEST(SceneTriggers, AloneIsAStaticBody) {
    const Scene scene = load_nodes(node("", R"("trigger":{"geometry":{"shape":1}})"));
    EXPECT_EQ(scene.world.body(scene.world.bodies().at(0)).type(), BodyType::static_);
    EXPECT_TRUE(scene.world.shape_def(only_shape_id(scene)).is_trigger);
}

TEST(SceneTriggers, OfSeveralPartsAreOneBody) {
    const std::string part = R"("trigger":{"geometry":{"shape":1}})";
    const std::string nodes = "," + node("", part) + "," + node(R"("children":[3],)", "") + "," + node("", part);
    const Scene scene = load_nodes(node(R"("children":[1,2],)", R"("trigger":{"nodes":[1,3]})") + nodes);
    ASSERT_EQ(scene.world.bodies().size(), 1u);
    EXPECT_EQ(scene.world.body(scene.world.bodies()[0]).shapes().size(), 2u);
    const auto refused = [&](const std::string& list) {
        EXPECT_THROW(load_nodes(node(R"("children":[1,2],)", R"("trigger":{"nodes":)" + list + "}") + nodes), Error)
            << list;
    };
    refused("[]");
    refused("[0]"); // not a descendant
    refused("[2]"); // not a trigger
    refused("[9]");
}

// --- joints

const char* hinge = R"({"limits":[{"linearAxes":[0,1,2],"min":0,"max":0},{"angularAxes":[2,0],"min":-0.5,"max":0.5,
    "stiffness":10,"damping":2}],"drives":[{"type":"angular","mode":"acceleration","axis":1,"maxForce":5,
    "positionTarget":1,"stiffness":3,"velocityTarget":-2,"damping":4},{"type":"linear","mode":"force","axis":0}]})";

MeshParts joined(const std::string& rules) {
    MeshParts parts = tetrahedron("");
    parts.shapes = R"({"type":"sphere"})";
    parts.joints = rules;
    parts.nodes =
        node(R"("name":"door","translation":[5,0,0],"scale":[2,2,2],"children":[1],)", R"("motion":{},)" + sphere) +
        "," +
        node(R"("name":"joint","translation":[0,1,0],"rotation":[0,0.70710678,0,0.70710678],)",
             R"("joint":{"joint":0,"connectedNode":2,"enableCollision":true})") +
        R"(,{"translation":[7,8,9]})";
    parts.roots = "0,2";
    return parts;
}

TEST(SceneJoints, AreReadWithTheirFrames) {
    const Scene scene = load_text(joined(hinge).text());
    ASSERT_EQ(scene.world.joints().size(), 1u);
    const JointDef& def = scene.world.joint_def(scene.world.joints()[0]);
    EXPECT_EQ(def.name, "joint");
    EXPECT_EQ(def.body_a, scene.world.bodies().at(0));
    EXPECT_TRUE(def.body_b.is_null());
    EXPECT_EQ(def.frame_a.position, Position(0, 2, 0)); // includes the scale of the body's node
    EXPECT_NEAR(def.frame_a.rotation.y, 0.70710678, 1e-6);
    EXPECT_EQ(def.frame_b.position, Position(7, 8, 9));
    EXPECT_TRUE(def.enable_collision);
    const auto& joint = std::get<GeneralJoint>(def.joint);
    ASSERT_EQ(joint.limits.size(), 2u);
    EXPECT_EQ(joint.limits[0].kind, JointAxis::linear);
    EXPECT_EQ(joint.limits[0].axes, (std::array<bool, 3>{true, true, true}));
    EXPECT_EQ(joint.limits[0].max, 0.0f);
    EXPECT_FALSE(joint.limits[0].stiffness.has_value());
    EXPECT_EQ(joint.limits[1].kind, JointAxis::angular);
    EXPECT_EQ(joint.limits[1].axes, (std::array<bool, 3>{true, false, true}));
    EXPECT_EQ(joint.limits[1].min, -0.5f);
    EXPECT_EQ(joint.limits[1].stiffness, 10.0f);
    EXPECT_EQ(joint.limits[1].damping, 2.0f);
    ASSERT_EQ(joint.drives.size(), 2u);
    EXPECT_EQ(joint.drives[0].kind, JointAxis::angular);
    EXPECT_TRUE(joint.drives[0].is_acceleration);
    EXPECT_EQ(joint.drives[0].axis, 1);
    EXPECT_EQ(joint.drives[0].max_force, 5.0f);
    EXPECT_EQ(joint.drives[0].position_target, 1.0f);
    EXPECT_EQ(joint.drives[0].velocity_target, -2.0f);
    EXPECT_EQ(joint.drives[0].stiffness, 3.0f);
    EXPECT_EQ(joint.drives[0].damping, 4.0f);
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_TRUE(scene.idle_joints.empty());
}

TEST(SceneJoints, MistakesAreNamed) {
    const std::string at = "test.gltf: extensions.KHR_physics_rigid_bodies.physicsJoints[0]";
    const auto expect_refused = [&](const std::string& rules, const std::string& message) {
        try {
            load_text(joined(rules).text());
            FAIL() << rules;
        } catch (const Error& error) {
            EXPECT_EQ(error.what(), message);
        }
    };
    expect_refused(R"({"limits":[{"min":1}]})",
                   at + ".limits[0]: must have either linearAxes or angularAxes, got an object");
    expect_refused(R"({"limits":[{"linearAxes":[0],"angularAxes":[1]}]})",
                   at + ".limits[0]: must have either linearAxes or angularAxes, got an object");
    expect_refused(R"({"limits":[{"linearAxes":[]}]})", at + ".limits[0].linearAxes: must list 1 to 3 axes, got []");
    expect_refused(R"({"limits":[{"linearAxes":[1,1]}]})",
                   at + ".limits[0].linearAxes[1]: must not be listed twice, got 1");
    expect_refused(R"({"limits":[{"linearAxes":[3]}]})",
                   at + ".limits[0].linearAxes[0]: must be a whole number from 0 to 2, got 3");
    expect_refused(R"({"limits":[{"linearAxes":[0],"min":2,"max":1}]})",
                   at + ".limits[0].max: must be at least min, got 1");
    expect_refused(R"({"limits":[{"linearAxes":[0],"stiffness":-1}]})",
                   at + ".limits[0].stiffness: must be >= 0, got -1");
    expect_refused(R"({"drives":[{"type":"x","mode":"force","axis":0}]})",
                   at + ".drives[0].type: must be \"linear\" or \"angular\", got \"x\"");
    expect_refused(R"({"drives":[{"type":"linear","mode":"x","axis":0}]})",
                   at + ".drives[0].mode: must be \"force\" or \"acceleration\", got \"x\"");
    expect_refused(R"({"drives":[{"type":"linear","mode":"force"}]})", at + ".drives[0]: must have a member \"axis\"");
}

// --- what is looked at

TEST(SceneVisuals, MeshesOfNodesBelongToTheirBodies) {
    MeshParts parts = tetrahedron("");
    parts.shapes = R"({"type":"sphere"})";
    parts.nodes = node(R"("translation":[5,0,0],"scale":[2,2,2],"children":[1],)", R"("motion":{},)" + sphere) +
                  R"(,{"mesh":0,"translation":[0,1,0]},{"mesh":0,"translation":[7,8,9]},)" +
                  node(R"("mesh":0,)", sphere);
    parts.meshes.insert(parts.meshes.rfind("}]}"), R"(,"material":0)");
    parts.more = R"(,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,0.5,0.25,1]}}])";
    parts.roots = "0,2,3";
    const Scene scene = load_text(parts.text());
    ASSERT_EQ(scene.visuals.size(), 3u);
    EXPECT_EQ(scene.visuals[0].body, scene.world.bodies().at(0));
    EXPECT_EQ(scene.visuals[0].local.position, Position(0, 2, 0));
    EXPECT_EQ(scene.visuals[0].color, Vec3(1, 0.5f, 0.25f));
    ASSERT_EQ(scene.visuals[0].surface->vertices.size(), 4u);
    EXPECT_EQ(scene.visuals[0].surface->vertices[3], Vec3(0, 0, 6));
    EXPECT_EQ(scene.visuals[0].surface->indices.size(), 12u);
    EXPECT_TRUE(scene.visuals[1].body.is_null()); // a visual without a body
    EXPECT_EQ(scene.visuals[1].local.position, Position(7, 8, 9));
    EXPECT_EQ(scene.visuals[2].body, scene.world.bodies().at(1));
    EXPECT_EQ(scene.visuals[1].surface, scene.visuals[2].surface);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(SceneVisuals, CompressedMeshesAreLeftOutWithAWarning) {
    MeshParts parts = tetrahedron("");
    parts.nodes = R"({"mesh":0})";
    parts.meshes.insert(parts.meshes.rfind("}]}"), R"(,"extensions":{"KHR_draco_mesh_compression":{}})");
    const Scene scene = load_text(parts.text());
    EXPECT_TRUE(scene.visuals.empty());
    ASSERT_EQ(scene.warnings.size(), 2u); // the second warning: the scene has no body
    EXPECT_NE(scene.warnings[0].find("meshes[0].primitives[0]: is compressed"), std::string::npos);
    parts.nodes = node("", hull_of_node_1) + R"(,{"mesh":0})"; // a collider's mesh must not be omitted
    EXPECT_THROW(load_text(parts.text()), Error);
}

TEST(SceneMaterials, SurfacesThatMove) {
    Parts parts;
    parts.materials = R"({"extensions":{"CAIRN_material":{"surface_velocity":[1,0,-2]}}})";
    const std::string belt = R"("collider":{"geometry":{"shape":1},"physicsMaterial":0})";
    parts.nodes = node("", belt);
    const Scene scene = load_text(document(parts));
    EXPECT_EQ(scene.world.shape_def(only_shape_id(scene)).surface_velocity, Vec3(1, 0, -2));
    parts.nodes = node("", R"("motion":{},)" + belt);
    EXPECT_THROW(load_text(document(parts)), Error);
}

} // namespace
