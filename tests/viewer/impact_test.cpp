// The textbook formula for an impact, compared with the engine.
#include "viewer/impact.h"
#include "viewer/stage.h"

#include "test_scene.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;

Material smooth(float restitution) {
    Material material;
    material.static_friction = material.dynamic_friction = material.torsional_friction = 0.0f;
    material.restitution = restitution;
    material.restitution_combine = CombineRule::maximum;
    return material;
}

ShapeDef smooth_shape(float restitution) {
    ShapeDef def;
    def.material = smooth(restitution);
    return def;
}

// Steps until the first impact, and explains it.
Impact first_impact(World& world, float step) {
    for (int i = 0; i < 2000; ++i) {
        World before;
        before.restore(world.save());
        world.step(step);
        if (!world.contact_hits().empty())
            return explain_impact(before, {world.step_count(), world.contact_hits()[0]}, step);
    }
    ADD_FAILURE() << "nothing was hit";
    return {};
}

TEST(Impact, OfABallOnTheGroundHasNoTermsOfTurning) {
    World world;
    world.add_shape(world.create_body(test::static_body()), Plane{}, smooth_shape(0.5f));
    BodyDef def = test::body_at({0.0, 3.0, 0.0});
    def.mass = 2.0f;
    world.add_shape(world.create_body(def), Sphere{0.25f}, smooth_shape(0.5f));
    const Impact impact = first_impact(world, 1.0f / 240.0f);
    const double speed = std::sqrt(2.0 * 9.81 * 2.75);
    EXPECT_EQ(impact.restitution, 0.5);
    EXPECT_EQ(impact.second.inverse_mass, 0.0);
    EXPECT_NEAR(impact.denominator, 0.5, 1e-4);
    EXPECT_NEAR(impact.relative_speed, -speed, 0.02 * speed);
    EXPECT_NEAR(impact.impulse, 1.5 * 2.0 * speed, 0.02 * 3.0 * speed);
    EXPECT_NEAR(impact.given, impact.impulse, 0.02 * impact.impulse);
    EXPECT_NEAR(impact.first.velocity_then.y, impact.first.velocity_after.y, 0.03 * speed);
    EXPECT_FLOAT_EQ(impact.normal.y, 1.0f); // from the ground to the ball
}

TEST(Impact, OfTwoBallsIsSharedByTheirMasses) {
    World world{{.gravity = {0.0f, 0.0f, 0.0f}}};
    for (const auto& [x, speed, mass] : {std::tuple(-1.0, 3.0f, 1.0f), {1.0, -1.0f, 3.0f}}) {
        BodyDef def = test::body_at({x, 0.0, 0.0});
        def.linear_velocity = {speed, 0.0f, 0.0f};
        def.mass = mass;
        world.add_shape(world.create_body(def), Sphere{0.25f}, smooth_shape(0.5f));
    }
    const Impact impact = first_impact(world, 1.0f / 60.0f);
    EXPECT_NEAR(impact.relative_speed, -4.0, 1e-3);
    EXPECT_NEAR(impact.impulse, 1.5 * 4.0 * 0.75, 1e-2); // (1 + e) v_rel times the reduced mass
    EXPECT_NEAR(impact.given, impact.impulse, 0.05);
    // The surfaces are 1.5 m apart and approach at 4 m/s.
    EXPECT_NEAR(double(impact.step - 1) / 60.0 + impact.time, 1.5 / 4.0, 1e-5);
    for (const ImpactSide* side : {&impact.first, &impact.second})
        EXPECT_NEAR(side->velocity_then.x, side->velocity_after.x, 0.05);
}

// A box that falls on a corner starts to spin: here the rotational terms of the formula matter most.
TEST(Impact, OfABoxOnItsCornerMakesItTurnAsTheFormulaSays) {
    World world{{.gravity = {0.0f, 0.0f, 0.0f}}};
    world.add_shape(world.create_body(test::static_body()), Plane{}, smooth_shape(0.4f));
    BodyDef def = test::body_at({0.0, 2.0, 0.0});
    def.linear_velocity = {0.0f, -4.0f, 0.0f};
    def.rotation = glm::normalize(Quat(0.93f, 0.20f, 0.05f, 0.30f));
    def.mass = 5.0f;
    world.add_shape(world.create_body(def), Box{{0.5f, 0.3f, 0.2f}}, smooth_shape(0.4f));
    const Impact impact = first_impact(world, 1.0f / 240.0f);
    EXPECT_GT(impact.first.turn_term, 0.3 * impact.first.inverse_mass);
    EXPECT_NEAR(impact.given, impact.impulse, 0.03 * impact.impulse);
    EXPECT_LT(glm::length(impact.first.velocity_then - impact.first.velocity_after), 0.1f);
    EXPECT_LT(glm::length(impact.first.turning_then - impact.first.turning_after),
              0.05f * glm::length(impact.first.turning_then));
}

TEST(Impact, TheStageFindsTheLastOneBeforeNowAndShowsItSlowly) {
    Stage stage(test::load_boxes, "2");
    stage.apply(command::SetPaused{true});
    stage.apply(command::Spawn{small_sphere_preset(), {2.0, 4.0, 0.0}});
    for (int i = 0; i < 80; ++i) stage.step();
    const StageState before = stage.state();
    const BodyId box = before.layout->bodies[2].id, ball = before.layout->bodies[3].id;
    stage.apply(command::ExplainImpact{ball, {}});
    ASSERT_TRUE(stage.state().impact);
    const Impact impact = *stage.state().impact;
    EXPECT_EQ(impact.first.body == ball ? impact.second.body : impact.first.body, box);
    EXPECT_EQ(stage.state().impact_partners, std::vector<BodyId>{box});
    // The world is not changed.
    EXPECT_EQ(stage.state().current->transforms[3].position, before.current->transforms[3].position);
    stage.apply(command::WatchImpact{});
    for (int i = 0; i < 2000 && (i < 2 || !stage.state().paused); ++i) {
        stage.advance(1.0 / 60.0);
        if (i == 2) {
            EXPECT_LT(stage.state().timeline.now, impact.step);
            EXPECT_EQ(stage.state().speed, 1.0 / 32.0);
        }
    }
    EXPECT_TRUE(stage.state().paused);
    EXPECT_EQ(stage.state().timeline.now, impact.step + 6);
    EXPECT_EQ(stage.state().speed, 1.0);
    stage.apply(command::SeekTo{impact.step - 1});
    stage.advance(0.0);
    stage.apply(command::ExplainImpact{ball, {}});
    EXPECT_FALSE(stage.state().impact); // the impact is still in the future
}

} // namespace
