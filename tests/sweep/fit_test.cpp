// Fits recover the parameters with which measurements were generated.
#include "plan_folder.h"

#include "sweep/fit.h"

#include <fmt/format.h>

#include <cmath>
#include <random>

namespace cairn::test {
namespace {

class SweepFit : public PlanFolder {
  protected:
    static constexpr int moments = 15; // measured times of each throw

    // A ball that is thrown horizontally over a floor: it bounces, and friction slows it down at each contact.
    static std::string throws(const std::string& parameters) {
        return parameters + R"json("seconds": 1.5, "set": {"ball.velocity.x": "vx", "ball.velocity.y": "vy",
            "ball.friction": "mu", "floor.friction": "mu", "ball.restitution": "e", "floor.restitution": "e"},
            "measure": [{"name": "x", "of": "ball.position.x",
            "at": [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.1, 1.2, 1.3, 1.4, 1.5], "deviation": 0.06},
                        {"name": "y", "of": "ball.position.y",
            "at": [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.1, 1.2, 1.3, 1.4, 1.5], "deviation": 0.01}])json";
    }

    // Measurements of that many throws with the given parameters, with a noise of 1 % on every measured value.
    std::string recorded(double mu, double e, int count, unsigned seed) const {
        std::mt19937 random(seed);
        const auto between = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        std::normal_distribution<double> noise(0.0, 0.01); // of about 6 m in x, 1 m in y
        std::string table = "vx,vy";
        for (const char axis : {'x', 'y'}) {
            for (int i = 0; i < moments; ++i) table += fmt::format(",{}_{}", axis, i);
        }
        for (int i = 0; i < count; ++i) {
            const double vx = between(2, 6), vy = between(-3, 1);
            const std::vector<Row> rows = rows_of(plan(throws(fmt::format(
                "\"parameters\": [{{\"name\": \"mu\", \"values\": [{}]}}, {{\"name\": \"e\", \"values\": [{}]}}, "
                "{{\"name\": \"vx\", \"values\": [{}]}}, {{\"name\": \"vy\", \"values\": [{}]}}],",
                mu, e, vx, vy))));
            table += fmt::format("\n{},{}", vx, vy);
            for (const char axis : {'x', 'y'}) {
                for (int k = 0; k < moments; ++k) {
                    table += fmt::format(",{}", rows[0].at(fmt::format("{}_{}", axis, k)) +
                                                    (axis == 'x' ? 6.0 : 1.0) * noise(random));
                }
            }
        }
        return table + "\n";
    }

    sweep::Plan to_fit() const {
        return plan(
            throws(R"json("parameters": [{"name": "mu", "from": 0.01, "to": 0.6}, {"name": "e", "from": 0, "to": 1},
                                             {"name": "vx"}, {"name": "vy"}],)json"),
            sweep::Purpose::fit);
    }
};

TEST_F(SweepFit, FrictionAndRestitutionOfTwentyThrowsWithNoiseAreFoundWithinThreePercent) {
    write_scene(0.0f, 1.0, false);
    unsigned seed = 1;
    for (const auto& [mu, e] : std::vector<std::pair<double, double>>{{0.12, 0.7}, {0.08, 0.45}}) {
        const fs::path data = write("data.csv", recorded(mu, e, 20, seed++));
        const sweep::Plan read = to_fit();
        const sweep::Start start = sweep::load_start(read);
        const sweep::Measurements measured = sweep::read_measurements(read, data);
        std::vector<double> found;
        for (const int threads : seed == 2 ? std::vector<int>{1, 2} : std::vector<int>{2}) {
            const sweep::Fit fit =
                sweep::fit(read, start, measured, {threads, 300}, [](std::uint64_t, double) { return true; });
            ASSERT_EQ(fit.parameters.size(), 2u);
            EXPECT_NEAR(fit.parameters[0].value, mu, 0.03 * mu);
            EXPECT_NEAR(fit.parameters[1].value, e, 0.03 * e);
            EXPECT_EQ(fit.numbers, std::size_t{20 * 2 * moments});
            // The true values are within the estimated errors.
            EXPECT_LT(std::fabs(fit.parameters[0].value - mu), 4.0 * fit.parameters[0].error);
            EXPECT_LT(fit.parameters[0].error, 0.05 * mu);
            found.push_back(fit.parameters[0].value);
        }
        EXPECT_EQ(found.front(), found.back()) << "threads must not matter";
    }
}

TEST_F(SweepFit, WhatTheMeasurementsDoNotTellHasNoError) {
    write_scene(0.0f, 1.0, false);
    const sweep::Plan read = plan(R"json("seconds": 0.2,
        "parameters": [{"name": "mu", "from": 0, "to": 1}, {"name": "v"}], "set": {"ball.velocity.x": "v",
            "ball.friction": "mu"},
        "measure": [{"name": "x", "of": "ball.position.x"}])json",
                                  sweep::Purpose::fit);
    const sweep::Measurements measured =
        sweep::read_measurements(read, write("data.csv", "v,x\n1,0.2\n2,0.4\n3,0.6\n"));
    const sweep::Fit fit =
        sweep::fit(read, sweep::load_start(read), measured, {1, 40}, [](std::uint64_t, double) { return true; });
    ASSERT_EQ(fit.parameters.size(), 1u);
    EXPECT_FALSE(std::isfinite(fit.parameters[0].error));
    EXPECT_LE(fit.evaluations, 41u);
}

TEST_F(SweepFit, BadMeasurementsAreToldWithTheirPlace) {
    write_scene();
    const sweep::Plan read = to_fit();
    const sweep::Start start = sweep::load_start(read);
    for (const auto& [text, part] : std::vector<std::pair<std::string, std::string>>{
             {"", "must have a first line"},
             {"vx,vy,z_0\n1,1,1\n", ":1: column 3: must be a parameter or a measure"},
             {"vx,vy,x_0,x_0\n1,1,1,1\n", "must be named once only"},
             {"vx,vy\n1,1\n", "must have a column with the name of a measure"},
             {"vx,vy,x_0\n", "must have a line of numbers"},
             {"vx,vy,x_0\n1,1\n", ":2: must have 3 fields"},
             {"vx,vy,x_0\n1,1,nan\n", ":2: column 3: must be a number"}}) {
        try {
            sweep::read_measurements(read, write("data.csv", text));
            FAIL() << text;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find("data.csv"), std::string::npos) << error.what();
        }
    }
    const auto goes_on = [](std::uint64_t, double) { return true; };
    const auto fit_of = [&](const std::string& table) {
        return sweep::fit(read, start, sweep::read_measurements(read, write("data.csv", table)), {1, 10}, goes_on);
    };
    EXPECT_THROW(fit_of("vx,x_0\n1,1\n"), Error) << "vy has no range";
    EXPECT_THROW(fit_of("vx,vy,mu,e,x_0\n1,1,1,1,1\n"), Error) << "nothing is left";
}

} // namespace
} // namespace cairn::test
