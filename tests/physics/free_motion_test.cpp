// Motion without contacts, and impulses on free bodies (rows 1, 2, 3 and 17 of docs/validation.md).
#include "support.h"

namespace cairn_test {
namespace {

// Where the discrete path is ahead of the exact one: by this times g h t, with substeps of h seconds.
double fall_offset(Integrator integrator) {
    switch (integrator) {
    case Integrator::semi_implicit_euler:
        return -0.5;
    case Integrator::explicit_euler:
        return 0.5;
    case Integrator::rk4:
        return 0.0;
    }
    return 0;
}

constexpr Integrator integrators[] = {Integrator::semi_implicit_euler, Integrator::explicit_euler, Integrator::rk4};

class FreeMotion : public EveryStep {};
CAIRN_AT_EVERY_STEP(FreeMotion);

// Relative to the way that was fallen. Velocities are float: a relative rounding of 6e-8 each step.
constexpr double round_off = 1e-5;

TEST_P(FreeMotion, FreeFallFollowsTheDiscreteFormOfEachIntegrator) {
    for (const Integrator integrator : integrators) {
        WorldDef settings;
        settings.integrator = integrator;
        World world{settings};
        BodyDef def;
        def.position = {0, 100, 0};
        const BodyId ball = add_body(world, Sphere{}, def);
        const double h = double(dt()) / settings.substeps;
        for (const double seconds : {0.5, 1.0, 2.0}) {
            while (world.step_count() < std::uint64_t(steps_in(seconds))) world.step(dt());
            const double t = double(world.step_count()) * double(dt());
            const double fallen = 0.5 * gravity * t * t - fall_offset(integrator) * gravity * h * t;
            EXPECT_NEAR((100 - world.body(ball).position().y) / fallen, 1, round_off)
                << int(integrator) << " after " << t;
            EXPECT_NEAR(double(world.body(ball).linear_velocity().y) / (-gravity * t), 1, round_off) << int(integrator);
        }
    }
}

TEST_P(FreeMotion, ProjectileHasTheRangeHeightAndTimeOfTheDiscreteForm) {
    const double v = 20 * std::sqrt(0.5);
    for (const Integrator integrator : integrators) {
        WorldDef settings;
        settings.integrator = integrator;
        World world{settings};
        BodyDef def;
        def.linear_velocity = {float(v), float(v), 0};
        const BodyId ball = add_body(world, Sphere{}, def);
        const double h = double(dt()) / settings.substeps;
        const double v_discrete = v + fall_offset(integrator) * gravity * h; // the parabola's, at the start
        double height = 0, range = 0, time = 0;
        while (time == 0) {
            world.step(dt());
            ASSERT_LT(world.time(), 4.0);
            const Position p = world.body(ball).position();
            const double v_y = double(world.body(ball).linear_velocity().y) + fall_offset(integrator) * gravity * h;
            height = std::max(height, p.y + (v_y > 0 ? v_y * v_y / (2 * gravity) : 0));
            if (p.y < 0) { // where the parabola through the last two points meets the ground
                const double t = double(world.step_count()) * double(dt());
                const double back = (-v_y - std::sqrt(v_y * v_y + 2 * gravity * p.y)) / gravity;
                time = t - back;
                range = p.x - v * back;
            }
        }
        EXPECT_NEAR(time / (2 * v_discrete / gravity), 1, round_off) << int(integrator);
        EXPECT_NEAR(range / (2 * v_discrete * v / gravity), 1, round_off) << int(integrator);
        EXPECT_NEAR(height / (v_discrete * v_discrete / (2 * gravity)), 1, round_off) << int(integrator);
        if (integrator == Integrator::rk4) {
            EXPECT_NEAR(range, 40.775, 0.001);
            EXPECT_NEAR(height, 10.194, 0.001);
            EXPECT_NEAR(time, 2.883, 0.001);
        }
    }
}

// A ball of 1 kg on a spring of 1 Hz: a field that attracts in proportion to the distance.
struct Oscillator {
    static constexpr double omega = 2 * pi;
    World world;
    BodyId ball;
    double spring = double(float(omega * omega));

    explicit Oscillator(Integrator integrator, double x = 1) : world(settings(integrator)) {
        ForceField field;
        field.kind = ForceField::Kind::radial;
        field.strength = float(omega * omega);
        field.exponent = 1;
        world.add_force_field(field);
        BodyDef def;
        def.mass = 1.0f;
        def.position = {x, 0, 0};
        ball = add_body(world, Sphere{}, def);
    }
    // One substep each step, so that the step is the h of the formulas.
    static WorldDef settings(Integrator integrator) {
        WorldDef def = without_gravity();
        def.integrator = integrator;
        def.substeps = 1;
        def.adaptive_substeps = false;
        def.enable_sleep = false;
        return def;
    }
    double energy() {
        const double x = world.body(ball).position().x, v = double(world.body(ball).linear_velocity().x);
        return 0.5 * v * v + 0.5 * spring * x * x;
    }
    // Greatest relative change of energy in so many seconds.
    double energy_error(double dt, double seconds) {
        const double start = energy();
        double most = 0;
        for (int i = 0; i < int(std::lround(seconds / dt)); ++i) {
            world.step(float(dt));
            most = std::max(most, std::abs(energy() / start - 1));
        }
        return most;
    }
    double position_error(double dt, double seconds) {
        for (int i = 0; i < int(std::lround(seconds / dt)); ++i) world.step(float(dt));
        return std::abs(world.body(ball).position().x - std::cos(std::sqrt(spring) * seconds));
    }
};

TEST(OscillatorTest, ExplicitEulerGainsTheEnergyThatTheoryGivesEachStep) {
    Oscillator oscillator(Integrator::explicit_euler);
    const double dt = 1.0 / 60, start = oscillator.energy();
    run(oscillator.world, float(dt), 120);
    const double growth = std::log(1 + oscillator.spring * dt * dt);
    EXPECT_NEAR(std::log(oscillator.energy() / start) / (120 * growth), 1, 0.01);
}

TEST(OscillatorTest, SemiImplicitEulerKeepsItsEnergyWithinHalfOmegaH) {
    Oscillator oscillator(Integrator::semi_implicit_euler);
    const double bound = Oscillator::omega / 60 / 2;
    // The band is +- omega h / 2 about its middle, wherever in it the start lies.
    double least = 1e9, most = 0;
    for (int i = 0; i < 60 * 1000; ++i) {
        oscillator.world.step(1.0f / 60);
        least = std::min(least, oscillator.energy());
        most = std::max(most, oscillator.energy());
    }
    EXPECT_NEAR((most - least) / (most + least) / bound, 1, 0.01);
}

TEST(OscillatorTest, RungeKuttaLosesOneMillionthOfItsEnergyEachSecond) {
    Oscillator oscillator(Integrator::rk4);
    const double dt = 1.0 / 60, start = oscillator.energy();
    const int seconds = 2000;
    run(oscillator.world, float(dt), 60 * seconds);
    const double wh = std::sqrt(oscillator.spring) * dt, loss = std::pow(wh, 6) / 72 / dt; // 1.1e-6 per second
    EXPECT_NEAR(std::log(start / oscillator.energy()) / (loss * seconds), 1, 0.01);
}

TEST(OscillatorTest, ErrorsShrinkWithTheOrderOfTheIntegrator) {
    auto order = [](double coarse, double fine) { return std::log2(coarse / fine); };
    auto energy = [](Integrator integrator, double dt) { return Oscillator(integrator).energy_error(dt, 1); };
    auto position = [](double dt) { return Oscillator(Integrator::rk4).position_error(dt, 1.25); };
    EXPECT_NEAR(order(energy(Integrator::explicit_euler, 1.0 / 1000), energy(Integrator::explicit_euler, 1.0 / 2000)),
                1, 0.05);
    EXPECT_NEAR(
        order(energy(Integrator::semi_implicit_euler, 1.0 / 1000), energy(Integrator::semi_implicit_euler, 1.0 / 2000)),
        1, 0.05);
    EXPECT_NEAR(order(position(1.0 / 16), position(1.0 / 32)), 4, 0.1);
    EXPECT_NEAR(order(position(1.0 / 32), position(1.0 / 64)), 4, 0.1);
}

TEST(ImpulseTest, ImpulseAtTheEndOfARodMovesAndTurnsIt) {
    World world{without_gravity()};
    const double mass = 3, length = 2, impulse = 5;
    BodyDef def;
    def.mass_properties = MassProperties{};
    def.mass_properties->mass = float(mass);
    const float inertia = float(mass * length * length / 12);
    def.mass_properties->inertia_diagonal = {inertia * 1e-3f, inertia, inertia};
    const BodyId rod = add_body(world, Box{{float(length / 2), 0.01f, 0.01f}}, def);
    world.body(rod).apply_impulse_at({0, float(impulse), 0}, {length / 2, 0, 0});
    for (int i = 0; i < 2; ++i) {
        EXPECT_NEAR(double(world.body(rod).linear_velocity().y) / (impulse / mass), 1, 1e-5);
        EXPECT_NEAR(double(world.body(rod).angular_velocity().z) / (6 * impulse / (mass * length)), 1, 1e-5);
        world.step(1.0f / 60);
    }
}

} // namespace
} // namespace cairn_test
