#include "viewer/integrators.h"

#include <cairn/cairn.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace cairn;
using namespace cairn::viewer;

TEST(Integrators, TheExactSolutionKeepsItsEnergyAndSolvesTheEquation) {
    for (const LabSystem system : lab_systems) {
        const double start = energy_of(system, start_of(system));
        for (double t = 0.0; t < 7.0; t += 0.137) {
            const LabState now = exact(system, t);
            EXPECT_NEAR(energy_of(system, now) / start, 1.0, 1e-10) << name_of(system) << " " << t;
            // Many short steps of an accurate integrator must give the same result.
            const double h = 1e-5;
            const LabState next = step(system, Integrator::rk4, now, h), known = exact(system, t + h);
            for (std::size_t i = 0; i < 2; ++i) {
                EXPECT_NEAR(next.place[i], known.place[i], 1e-11) << name_of(system) << " " << t;
                EXPECT_NEAR(next.velocity[i], known.velocity[i], 1e-9) << name_of(system) << " " << t;
            }
        }
        const LabState again = exact(system, period_of(system));
        EXPECT_NEAR(again.place[0], start_of(system).place[0], 1e-9) << name_of(system);
    }
}

TEST(Integrators, ExplicitEulerGainsEnergyAndTheOthersDoNot) {
    for (const LabSystem system : lab_systems) {
        const double start = energy_of(system, start_of(system));
        const auto end = [&](Integrator integrator) {
            return energy_of(system, trajectory(system, integrator, 1.0 / 240.0, 5.0).back()) / start;
        };
        const double gain = start < 0.0 ? -1.0 : 1.0; // the energy of an orbit is negative, and so is that of the top
        EXPECT_GT(gain * end(Integrator::explicit_euler), gain * 1.0 + 0.05) << name_of(system);
        if (system == LabSystem::top) // the force on the top depends on its velocity
            EXPECT_GT(gain * end(Integrator::semi_implicit_euler), gain * 1.0 + 0.05);
        else
            EXPECT_NEAR(end(Integrator::semi_implicit_euler), 1.0, 0.15) << name_of(system);
        EXPECT_NEAR(end(Integrator::rk4), 1.0, 1e-3) << name_of(system);
    }
}

TEST(Integrators, ErrorsShrinkByTheOrderOfTheMethod) {
    for (const LabSystem system : lab_systems) {
        const auto order = [&](Integrator integrator) {
            const double t = period_of(system);
            // Steps short enough for the order to show, but for RK4 not so short that rounding dominates.
            const double h = integrator == Integrator::rk4 ? 1.0 / 480.0 : 1.0 / 1920.0;
            return std::log2(greatest_error(system, integrator, h, t) / greatest_error(system, integrator, h / 2.0, t));
        };
        EXPECT_NEAR(order(Integrator::explicit_euler), 1.0, 0.25) << name_of(system);
        EXPECT_NEAR(order(Integrator::semi_implicit_euler), 1.0, 0.15) << name_of(system);
        EXPECT_NEAR(order(Integrator::rk4), 4.0, 0.25) << name_of(system);
    }
}

// The integrators of the lesson are those of the engine, up to rounding in single precision.
TEST(Integrators, TheyAreThoseOfTheEngine) {
    for (const LabSystem system : {LabSystem::spring, LabSystem::orbit}) {
        for (const Integrator integrator : lab_integrators) {
            WorldDef def;
            def.gravity = {0.0f, 0.0f, 0.0f};
            def.substeps = 1;
            def.adaptive_substeps = false;
            def.integrator = integrator;
            World world(def);
            ForceField field;
            field.kind = ForceField::Kind::radial;
            field.strength = float(4.0 * M_PI * M_PI);
            field.exponent = system == LabSystem::spring ? 1.0f : -2.0f;
            world.add_force_field(field);
            LabState state = start_of(system);
            BodyDef body;
            body.position = {state.place[0], state.place[1], 0.0};
            body.linear_velocity = {float(state.velocity[0]), float(state.velocity[1]), 0.0f};
            body.allow_sleep = false;
            const BodyId id = world.create_body(body);
            for (int i = 0; i < 120; ++i) {
                world.step(1.0f / 120.0f);
                state = step(system, integrator, state, 1.0 / 120.0);
            }
            EXPECT_NEAR(world.body(id).position().x, state.place[0], 2e-4) << name_of(system) << name_of(integrator);
            EXPECT_NEAR(world.body(id).position().y, state.place[1], 2e-4) << name_of(system) << name_of(integrator);
        }
    }
}

TEST(Charts, AnErrorChartHasItsSlopesAndATable) {
    const Chart chart = error_chart(LabSystem::spring);
    ASSERT_EQ(chart.curves.size(), 3u);
    EXPECT_EQ(chart.curves[0].label, "explicit Euler, slope 1.0");
    EXPECT_EQ(chart.curves[2].label, "Runge-Kutta 4, slope 4.0");
    const std::string table = chart_csv(chart);
    EXPECT_EQ(table.substr(0, table.find('\n')),
              "\"length of a step, s\",\"explicit Euler, slope 1.0\",\"semi-implicit Euler, slope 1.0\","
              "\"Runge-Kutta 4, slope 4.0\"");
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 7);
}

TEST(Charts, AxesHoldWhatIsShownAndTicksAreRound) {
    Chart chart;
    chart.curves.push_back({"a", {0.0, 1.0, 2.0}, {-3.0, 5.0, NAN}});
    const ChartAxis y = y_axis(chart);
    EXPECT_GT(y.share(-3.0), 0.0);
    EXPECT_LT(y.share(5.0), 1.0);
    EXPECT_NEAR(y.value(y.share(2.5)), 2.5, 1e-12);
    std::vector<std::string> labels;
    for (const ChartTick& tick : ticks_of(y, 5)) labels.push_back(tick.label);
    EXPECT_EQ(labels, (std::vector<std::string>{"-2", "0", "2", "4"}));
    chart.log_y = true;
    chart.curves[0].y = {1e-7, 1e-3, 0.0};
    const ChartAxis log = y_axis(chart);
    EXPECT_EQ(ticks_of(log, 5).front().label, "1e-7");
    EXPECT_EQ(ticks_of(ChartAxis{false, 0.5e6, 2.5e6}, 2).front().label, "1e6");
}

} // namespace
