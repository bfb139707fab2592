// Motion without contacts, compared with closed forms: gravity, damping, fields, forces, torques, impulses, free
// rotation.
#include "test_world.h"

#include <ostream>
#include <string>
#include <tuple>
#include <vector>

namespace cairn::test {
namespace {

Body add_ball(World& world, const Position& position = {0.0, 0.0, 0.0}) {
    return world.body(add_body(world, body_at(position), Sphere{}));
}

// --- gravity and damping

TEST(Motion, FreeFallFollowsTheParabola) {
    for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::explicit_euler, Integrator::rk4}) {
        WorldDef def;
        def.integrator = integrator;
        World world(def);
        BodyDef ball = body_at({0.0, 100.0, 0.0});
        ball.linear_velocity = {3.0f, 4.0f, -1.0f};
        const Body body = world.body(add_body(world, ball, Sphere{}));
        run(world, 120);
        EXPECT_NEAR(body.position().x, 6.0, 1e-3);
        EXPECT_NEAR(body.position().z, -2.0, 1e-3);
        // The Euler methods have an error of g h t / 2, where h is the length of a substep.
        const double lag = 0.5 * 9.81 * 2 * frame / world.usual_substeps(float(frame));
        const double tolerance = integrator == Integrator::rk4 ? 1e-3 : 1.01 * lag + 1e-3;
        EXPECT_NEAR(body.position().y, 100.0 + 8.0 - 0.5 * 9.81 * 4, tolerance);
        EXPECT_NEAR(body.linear_velocity().y, 4.0f - 2 * 9.81f, 1e-3f);
    }
}

TEST(Motion, GravityScaleMultipliesGravity) {
    World world;
    std::vector<Body> balls;
    for (const float scale : {-1.0f, 0.0f, 0.5f, 1.0f, 3.0f}) {
        BodyDef def = body_at({5.0 * double(balls.size()), 0.0, 0.0});
        def.gravity_scale = scale;
        balls.push_back(world.body(add_body(world, def, Sphere{})));
        EXPECT_EQ(balls.back().gravity_scale(), scale);
    }
    run(world, 60);
    for (const Body& ball : balls) EXPECT_NEAR(ball.linear_velocity().y, -9.81f * ball.gravity_scale(), 1e-3f);
    balls[1].set_gravity_scale(2.0f);
    run(world, 60);
    EXPECT_NEAR(balls[1].linear_velocity().y, -2 * 9.81f, 1e-3f);
}

TEST(Motion, DampingIsExponential) {
    for (const float rate : {0.1f, 1.0f, 10.0f}) {
        World world(weightless());
        BodyDef def;
        def.linear_velocity = {10.0f, 0.0f, 0.0f};
        def.angular_velocity = {0.0f, 10.0f, 0.0f};
        def.linear_damping = rate;
        def.angular_damping = 2 * rate;
        const Body body = world.body(add_body(world, def, Sphere{}));
        run(world, 60);
        EXPECT_NEAR(body.linear_velocity().x, 10 * std::exp(-rate), 10 * std::exp(-rate) * 0.002);
        EXPECT_NEAR(body.angular_velocity().y, 10 * std::exp(-2 * rate), 10 * std::exp(-2 * rate) * 0.01);
    }
}

TEST(Motion, StrongestDampingStopsWithoutTurningBack) {
    World world(weightless());
    BodyDef def;
    def.linear_velocity = {10.0f, 0.0f, 0.0f};
    def.linear_damping = 1e30f;
    const Body body = world.body(add_body(world, def, Sphere{}));
    run(world, 10);
    EXPECT_GE(body.linear_velocity().x, 0.0f);
    EXPECT_LT(body.linear_velocity().x, 1e-6f);
    EXPECT_TRUE(is_sane(world));
}

// --- forces and impulses

TEST(Motion, ForceActsForOneStepOnly) {
    World world(weightless());
    Body body = add_ball(world);
    body.add_force({100.0f, 0.0f, 0.0f});
    body.add_force({0.0f, 50.0f, 0.0f});
    EXPECT_EQ(body.linear_velocity(), Vec3(0.0f));
    world.step(frame);
    const Vec3 v = body.linear_velocity();
    EXPECT_NEAR(v.x, 100.0f * frame / body.mass(), 1e-6f);
    EXPECT_NEAR(v.y, 50.0f * frame / body.mass(), 1e-6f);
    run(world, 10);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(body.linear_velocity()[i], v[i], 1e-8f) << "but for rounding it goes on as it is";
}

TEST(Motion, ForceAtAPointTurnsToo) {
    World world(weightless());
    Body body = add_ball(world, {1.0, 2.0, 3.0});
    const float inertia = 0.4f * body.mass() * 0.25f;
    body.add_force_at({0.0f, 100.0f, 0.0f}, {1.5, 2.0, 3.0});
    world.step(frame);
    EXPECT_NEAR(body.linear_velocity().y, 100.0f * frame / body.mass(), 1e-6f);
    EXPECT_NEAR(body.angular_velocity().z, 50.0f * frame / inertia, 1e-5f);
    EXPECT_NEAR(body.angular_velocity().x, 0.0f, 1e-6f);
}

TEST(Motion, TorqueTurns) {
    for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::explicit_euler, Integrator::rk4}) {
        WorldDef def = weightless();
        def.integrator = integrator;
        World world(def);
        Body body = world.body(add_body(world, {}, Box{{0.2f, 0.3f, 0.4f}}));
        const Mat3 inertia = body.world_inertia();
        for (int i = 0; i < 30; ++i) {
            body.add_torque({0.0f, 0.0f, 10.0f});
            world.step(frame);
        }
        EXPECT_NEAR(body.angular_velocity().z, 10.0f * 0.5f / inertia[2][2], 1e-4f);
        EXPECT_NEAR(glm::length(world.angular_momentum()), 5.0, 1e-3);
    }
}

TEST(Motion, ImpulsesChangeVelocityAtOnce) {
    World world(weightless());
    Body body = add_ball(world, {1.0, 2.0, 3.0});
    const float mass = body.mass(), inertia = 0.4f * mass * 0.25f;
    body.apply_impulse({mass, 0.0f, 0.0f});
    EXPECT_NEAR(body.linear_velocity().x, 1.0f, 1e-6f);
    body.apply_impulse_at({0.0f, mass, 0.0f}, {1.0, 2.0, 3.5});
    EXPECT_NEAR(body.linear_velocity().y, 1.0f, 1e-6f);
    EXPECT_NEAR(body.angular_velocity().x, -0.5f * mass / inertia, 1e-4f);
    body.apply_angular_impulse({0.0f, 0.0f, 2 * inertia});
    EXPECT_NEAR(body.angular_velocity().z, 2.0f, 1e-5f);
}

TEST(Motion, ImpulseOnATurnedBoxUsesItsTurnedInertia) {
    World world(weightless());
    BodyDef def;
    def.rotation = glm::angleAxis(0.8f, glm::normalize(Vec3(1.0f, 2.0f, -1.0f)));
    Body body = world.body(add_body(world, def, Box{{0.1f, 0.5f, 0.9f}}));
    const Vec3 impulse(3.0f, -2.0f, 5.0f);
    body.apply_angular_impulse(impulse);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(body.angular_momentum()[i], impulse[i], 1e-4f);
    const Vec3 expected = glm::inverse(body.world_inertia()) * impulse;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(body.angular_velocity()[i], expected[i], 1e-5f);
}

// --- fields

TEST(Fields, UniformFieldAcceleratesAllMassesAlikeAndAForceDoesNot) {
    for (const bool is_force : {false, true}) {
        World world(weightless());
        ForceField field;
        field.direction = {2.0f, 0.0f, -1.0f};
        field.is_force = is_force;
        world.add_force_field(field);
        for (const float mass : {1.0f, 10.0f}) {
            BodyDef def = body_at({0.0, 5.0 * mass, 0.0});
            def.mass = mass;
            const Body body = world.body(add_body(world, def, Sphere{}));
            EXPECT_EQ(body.mass(), mass);
        }
        run(world, 60);
        for (const BodyId id : world.bodies()) {
            const Body body = world.body(id);
            EXPECT_NEAR(body.linear_velocity().x, is_force ? 2.0f / body.mass() : 2.0f, 1e-4f);
            EXPECT_NEAR(body.linear_velocity().z, is_force ? -1.0f / body.mass() : -1.0f, 1e-4f);
        }
    }
}

TEST(Fields, RadialFieldPullsWithThePowerOfTheDistance) {
    for (const float exponent : {-2.0f, -1.0f, 0.0f, 1.0f})
        for (const double distance : {2.0, 10.0}) {
            World world(weightless());
            ForceField field;
            field.kind = ForceField::Kind::radial;
            field.center = {1.0, 2.0, 3.0};
            field.strength = 0.5f;
            field.exponent = exponent;
            world.add_force_field(field);
            const Body body = add_ball(world, {1.0, 2.0 + distance, 3.0});
            run(world, 6);
            const double expected = -0.5 * std::pow(distance, double(exponent)) * 0.1;
            EXPECT_NEAR(body.linear_velocity().y, expected, std::fabs(expected) * 0.02) << "exponent " << exponent;
            EXPECT_NEAR(body.linear_velocity().x, 0.0f, 1e-7f);
        }
}

TEST(Fields, PointGravityKeepsACircularOrbit) {
    WorldDef def = weightless();
    def.integrator = Integrator::rk4;
    World world(def);
    ForceField sun;
    sun.kind = ForceField::Kind::radial;
    sun.strength = 1000.0f;
    sun.exponent = -2.0f;
    world.add_force_field(sun);
    BodyDef planet = body_at({10.0, 0.0, 0.0});
    planet.linear_velocity = {0.0f, 0.0f, -10.0f}; // the speed of a circular orbit, sqrt(1000 / 10)
    const Body body = world.body(add_body(world, planet, Sphere{0.1f}));
    for (int i = 0; i < 1000; ++i) {
        world.step(frame);
        ASSERT_NEAR(glm::length(body.position()), 10.0, 0.01) << "step " << i;
    }
}

TEST(Fields, AreChangedAndRemoved) {
    World world(weightless());
    ForceField field;
    field.direction = {1.0f, 0.0f, 0.0f};
    const ForceFieldId id = world.add_force_field(field);
    const Body body = add_ball(world);
    run(world, 60);
    field.direction = {0.0f, 2.0f, 0.0f};
    world.set_force_field(id, field);
    run(world, 60);
    world.remove_force_field(id);
    EXPECT_FALSE(world.is_valid(id));
    run(world, 60);
    EXPECT_NEAR(body.linear_velocity().x, 1.0f, 1e-4f);
    EXPECT_NEAR(body.linear_velocity().y, 2.0f, 1e-4f);
}

TEST(Fields, WakeWhatSleeps) {
    World world;
    add_ground(world);
    const BodyId crate = add_crate(world, {0.0, 0.5, 0.0});
    run(world, 200);
    ASSERT_FALSE(world.body(crate).is_awake());
    ForceField up;
    up.direction = {0.0f, 20.0f, 0.0f};
    world.add_force_field(up);
    run(world, 60);
    EXPECT_GT(world.body(crate).position().y, 2.0);
}

// --- free rotation

struct Top {
    const char* name;
    Vec3 half_extents, spin;
};
std::ostream& operator<<(std::ostream& out, const Top& top) { return out << top.name; }

class FreeRotation : public testing::TestWithParam<std::tuple<Top, Integrator>> {};

TEST_P(FreeRotation, KeepsEnergyAndAngularMomentum) {
    const auto& [top, integrator] = GetParam();
    WorldDef def = weightless();
    def.integrator = integrator;
    def.substeps = 8; // Runge-Kutta loses energy for the fastest tops with fewer
    World world(def);
    BodyDef body;
    body.angular_velocity = top.spin;
    add_body(world, body, Box{top.half_extents});
    const double energy = world.kinetic_energy(), momentum = glm::length(world.angular_momentum());
    for (int i = 0; i < 300; ++i) {
        ASSERT_TRUE(stays_sane(world, 1));
        ASSERT_NEAR(world.kinetic_energy(), energy, 0.02 * energy) << "step " << i;
        ASSERT_NEAR(glm::length(world.angular_momentum()), momentum, 0.01 * momentum) << "step " << i;
    }
}

const Top tops[] = {{"brick", {0.1f, 0.2f, 0.4f}, {0.1f, 5.0f, 0.1f}},
                    {"plate", {0.5f, 0.02f, 0.5f}, {1.0f, 8.0f, 2.0f}},
                    {"rod_1_to_50", {0.01f, 0.5f, 0.01f}, {10.0f, 3.0f, 1.0f}},
                    {"twirling_rod_1_to_10", {0.05f, 0.5f, 0.05f}, {3.0f, 100.0f, 2.0f}},
                    {"twirling_rod_1_to_50", {0.01f, 0.5f, 0.01f}, {3.0f, 100.0f, 2.0f}},
                    {"rod_1_to_500", {0.001f, 0.5f, 0.001f}, {10.0f, 3.0f, 1.0f}}};
INSTANTIATE_TEST_SUITE_P(Tops, FreeRotation,
                         testing::Combine(testing::ValuesIn(tops),
                                          testing::Values(Integrator::semi_implicit_euler, Integrator::rk4)),
                         [](const auto& info) {
                             const bool is_rk4 = std::get<1>(info.param) == Integrator::rk4;
                             return std::string(std::get<0>(info.param).name) + (is_rk4 ? "_rk4" : "_semi_implicit");
                         });

// --- whole-world measures

TEST(Measures, EnergyAndMomentumAreTheSumsOverBodies) {
    World world;
    double energy = 0, potential = 0;
    glm::dvec3 momentum(0.0), angular(0.0);
    for (int i = 0; i < 5; ++i) {
        BodyDef def = body_at({3.0 * i, 1.0 + i, -2.0 * i});
        def.linear_velocity = {1.0f * float(i), 2.0f, -1.0f};
        def.angular_velocity = {0.5f, float(i), 1.0f};
        const Body body = world.body(add_body(world, def, Box{{0.1f, 0.2f, 0.3f}}));
        const double m = body.mass();
        energy += body.kinetic_energy();
        potential += m * 9.81 * (1.0 + i);
        momentum += m * glm::dvec3(def.linear_velocity);
        angular += glm::cross(body.center_of_mass(), m * glm::dvec3(def.linear_velocity)) +
                   glm::dvec3(body.angular_momentum());
    }
    add_body(world, body_at({0.0, 50.0, 0.0}, BodyType::kinematic), Box{});
    EXPECT_NEAR(world.kinetic_energy(), energy, 1e-6 * energy);
    EXPECT_NEAR(world.potential_energy(), potential, 1e-6 * potential);
    EXPECT_LT(glm::length(world.linear_momentum() - momentum), 1e-6 * glm::length(momentum));
    EXPECT_LT(glm::length(world.angular_momentum() - angular), 1e-5 * glm::length(angular));
}

TEST(Measures, ThrownTogetherBodiesKeepTheirMomentum) {
    World world(weightless());
    for (int i = 0; i < 20; ++i) {
        const double a = 2 * pi * i / 20;
        BodyDef def = body_at({5 * std::cos(a), 5 * std::sin(a), 0.1 * i});
        def.linear_velocity = Vec3(float(-3 * std::cos(a)), float(-3 * std::sin(a) + 0.3), 0.1f);
        if (i % 2)
            add_body(world, def, Sphere{0.4f});
        else
            add_body(world, def, Box{{0.3f, 0.4f, 0.5f}});
    }
    const glm::dvec3 linear = world.linear_momentum(), angular = world.angular_momentum();
    run(world, 240);
    EXPECT_LT(glm::length(world.linear_momentum() - linear), 1e-3 * 20 * 500);
    EXPECT_LT(glm::length(world.angular_momentum() - angular), 1e-2 * 20 * 500);
}

} // namespace
} // namespace cairn::test
