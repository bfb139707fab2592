// The scenes together cover all features of the engine.
#include "scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

namespace cairn_test {
namespace {

using namespace cairn;

void note(const Shape& shape, std::set<std::string>& found) {
    if (const auto* box = std::get_if<Box>(&shape)) found.insert(box->rounding > 0 ? "rounded box" : "box");
    if (std::holds_alternative<Sphere>(shape)) found.insert("sphere");
    if (const auto* plane = std::get_if<Plane>(&shape)) {
        const std::string side = plane->double_sided ? "double-sided " : "";
        if (!plane->half_extents)
            found.insert(side + "plane");
        else if (std::isinf(plane->half_extents->x) || std::isinf(plane->half_extents->y))
            found.insert(side + "strip");
        else
            found.insert(side + "rectangle");
    }
    if (const auto* capsule = std::get_if<Capsule>(&shape))
        found.insert(capsule->radius_top ? "tapered capsule" : "capsule");
    if (const auto* cylinder = std::get_if<Cylinder>(&shape)) {
        const std::string rounded = cylinder->rounding > 0 ? "rounded " : "";
        if (!cylinder->radius_top)
            found.insert(rounded + "cylinder");
        else
            found.insert(rounded + (*cylinder->radius_top > 0 ? "tapered cylinder" : "cone"));
    }
    if (const auto* hull = std::get_if<Hull>(&shape)) found.insert(hull->rounding > 0 ? "rounded hull" : "hull");
    if (std::holds_alternative<Mesh>(shape)) found.insert("mesh");
    if (std::holds_alternative<HeightField>(shape)) found.insert("height field");
}

TEST(DeterminismScenes, UseEveryShapeJointAndIntegrator) {
    std::set<std::string> shapes;
    std::set<std::size_t> joints;
    std::set<Integrator> integrators;
    std::set<JointSolver> solvers;
    bool has_trigger = false, has_conveyor = false, has_moving_mesh = false, has_compound = false;
    for (const NamedScene& named : scenes()) {
        Scene& scene = named.make();
        World world{scene.settings()};
        scene.build(world);
        integrators.insert(world.settings().integrator);
        for (const BodyId id : world.bodies()) {
            const Body body = world.body(id);
            has_compound |= body.shapes().size() > 1;
            for (const ShapeId shape : body.shapes()) {
                note(world.shape(shape), shapes);
                has_trigger |= world.shape_def(shape).is_trigger;
                has_conveyor |= world.shape_def(shape).surface_velocity != Vec3(0.0f);
                has_moving_mesh |=
                    body.type() == BodyType::kinematic && std::holds_alternative<Mesh>(world.shape(shape));
            }
        }
        for (const JointId joint : world.joints()) {
            joints.insert(world.joint_def(joint).joint.index());
            solvers.insert(world.joint_def(joint).solver);
        }
    }
    const std::set<std::string> all_shapes{"sphere",
                                           "box",
                                           "rounded box",
                                           "plane",
                                           "double-sided plane",
                                           "rectangle",
                                           "double-sided rectangle",
                                           "strip",
                                           "double-sided strip",
                                           "capsule",
                                           "tapered capsule",
                                           "cylinder",
                                           "rounded cylinder",
                                           "tapered cylinder",
                                           "cone",
                                           "rounded cone",
                                           "hull",
                                           "rounded hull",
                                           "mesh",
                                           "height field"};
    EXPECT_EQ(shapes, all_shapes);
    EXPECT_EQ(joints.size(), std::variant_size_v<Joint>);
    EXPECT_EQ(integrators.size(), 3u);
    EXPECT_EQ(solvers.size(), 3u);
    EXPECT_TRUE(has_trigger);
    EXPECT_TRUE(has_conveyor);
    EXPECT_TRUE(has_moving_mesh);
    EXPECT_TRUE(has_compound);
}

// The events that the scenes are named for occur within the compared steps.
TEST(DeterminismScenes, TouchSleepWakeTriggerBreakAndSplit) {
    std::size_t asleep = 0, awake = 0, entered = 0, left = 0, broke = 0, hits = 0, ends = 0;
    int max_substeps = 0;
    for (const NamedScene& named : scenes()) {
        Scene& scene = named.make();
        World world{scene.settings()};
        scene.build(world);
        std::size_t touched = 0;
        for (int i = 0; i < golden_steps; ++i) {
            scene.step(world);
            for (const SleepEvent& event : world.sleep_events()) ++(event.asleep ? asleep : awake);
            for (const TriggerEvent& event : world.trigger_events()) ++(event.inside ? entered : left);
            for (const JointEvent& event : world.joint_events()) broke += event.broke;
            hits += world.contact_hits().size();
            touched += world.contact_begins().size();
            ends += world.contact_ends().size();
            max_substeps = std::max(max_substeps, world.statistics().max_substeps);
        }
        EXPECT_GT(touched, 0u) << named.name;
    }
    EXPECT_GT(asleep, 100u);
    EXPECT_GT(awake, 20u);
    EXPECT_GT(entered, 10u);
    EXPECT_GT(left, 10u);
    EXPECT_GE(broke, 1u);
    EXPECT_GT(hits, 500u);
    EXPECT_GT(ends, 500u);
    EXPECT_GT(max_substeps, 12);
}

} // namespace
} // namespace cairn_test
