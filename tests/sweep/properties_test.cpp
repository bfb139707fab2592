// Properties that can be set and measured, by their paths.
#include "plan_folder.h"

#include "sweep/address.h"
#include "sweep/expression.h"

#include <fmt/format.h>

#include <cmath>

namespace cairn::test {
namespace {

class SweepProperties : public PlanFolder {
  protected:
    // The error message for an invalid plan.
    std::string refusal(const std::string& members) const {
        try {
            const sweep::Plan read = plan(members);
            const sweep::Start start = sweep::load_start(read);
            const sweep::Runner runner(read, start);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }
    void expect_refusal(const std::string& members, const std::string& part) const {
        const std::string text = refusal(members);
        EXPECT_NE(text.find(part), std::string::npos) << members << "\n" << text;
        EXPECT_NE(text.find("plan.json"), std::string::npos) << text;
    }
};

TEST_F(SweepProperties, WhatIsSetIsMeasuredAsItWasSet) {
    write_scene();
    // Values that are exact in float.
    const std::vector<std::pair<std::string, double>> values{{"world.gravity.x", 0.5},
                                                             {"world.gravity.y", -3.25},
                                                             {"world.substeps", 9},
                                                             {"world.restitution_speed", 1},
                                                             {"world.recovery_speed", 2},
                                                             {"world.sleep_speed", 0.25},
                                                             {"world.sleep_time", 0.75},
                                                             {"ball.position.x", -0.5},
                                                             {"ball.position.y", 7.5},
                                                             {"ball.velocity.z", 1.5},
                                                             {"ball.angular_velocity.x", 0.125},
                                                             {"ball.mass", 3},
                                                             {"ball.gravity_scale", 0.5},
                                                             {"ball.linear_damping", 0.25},
                                                             {"ball.angular_damping", 0.5},
                                                             {"'wide crate'.friction", 0.5},
                                                             {"'wide crate'.enabled", 0},
                                                             {"ball.static_friction", 0.75},
                                                             {"ball.dynamic_friction", 0.25},
                                                             {"bodies[1].shapes[0].restitution", 0.5},
                                                             {"ball.rolling_friction", 0.125},
                                                             {"ball.torsional_friction", 0.25},
                                                             {"hinge.enabled", 0},
                                                             {"hinge.lower", 1.5},
                                                             {"hinge.upper", 2.5},
                                                             {"hinge.angle.motor_velocity", 3},
                                                             {"hinge.motor_max_force", 20},
                                                             {"joints[0].motor_stiffness", 50},
                                                             {"hinge.motor_damping", 4},
                                                             {"hinge.motor_position", 0.5},
                                                             {"hinge.friction", 0.25},
                                                             {"hinge.break_force", 1000},
                                                             {"hinge.break_torque", 2000}};
    std::string set, measure;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto& [path, value] = values[i];
        set += (i > 0 ? ", " : "") + ("\"" + path + "\": " + std::to_string(value));
        measure += (i > 0 ? ", " : "") + fmt::format("{{\"name\": \"m{}\", \"of\": \"{}\", \"at\": 0}}", i, path);
    }
    const std::vector<Row> rows =
        rows_of(plan("\"seconds\": 0.01, \"set\": {" + set + "}, \"measure\": [" + measure + "]"));
    ASSERT_EQ(rows.size(), 1u);
    for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_EQ(rows[0].at(fmt::format("m{}", i)), values[i].second) << values[i].first;
    }
}

TEST_F(SweepProperties, ARotationIsSetByAllOfItsComponentsAtOnce) {
    write_scene();
    const std::vector<Row> rows =
        rows_of(plan(R"json("parameters": [{"name": "a", "values": [0.3, -1, 2.5]}], "seconds": 0.01,
            "set": {"ball.rotation.z": "sin(a / 2)", "ball.rotation.w": "cos(a / 2)"},
            "measure": [{"name": "z", "of": "ball.rotation.z", "at": 0}, {"name": "w",
            "of": "ball.rotation.w", "at": 0}])json"));
    for (const Row& row : rows) {
        EXPECT_NEAR(row.at("z"), std::sin(0.5 * row.at("a")), 1e-6);
        EXPECT_NEAR(row.at("w"), std::cos(0.5 * row.at("a")), 1e-6);
    }
}

TEST_F(SweepProperties, ExpressionsOfSettingsSeeTheSceneAsItWas) {
    write_scene();
    const std::vector<Row> rows = rows_of(plan(R"json("seconds": 0.01,
        "set": {"ball.position.x": "ball.position.y + 1", "ball.position.y": "2 * ball.position.y"},
        "measure": [{"name": "x", "of": "ball.position.x", "at": 0}, {"name": "y", "of": "ball.position.y",
            "at": 0}])json"));
    EXPECT_EQ(rows[0].at("x"), 3.0);
    EXPECT_EQ(rows[0].at("y"), 4.0);
}

TEST_F(SweepProperties, APropertyWithANameOfAMillionLettersIsRefused) {
    write_scene();
    expect_refusal("\"set\": {\"ball.mass" + std::string(1000000, '(') + "\": 1}", "\": does not name a property");
}

TEST_F(SweepProperties, BadPathsAndExpressionsAreToldWithTheirPlace) {
    write_scene();
    const auto measure = [](const std::string& of) {
        return "\"measure\": [{\"name\": \"m\", \"of\": \"" + of + "\"}]";
    };
    expect_refusal(measure("bal.position.x"),
                   "measure[0].of: bal.position.x: there is no body \"bal\"; there are world, "
                   "floor, ball, 'wide crate', door");
    expect_refusal(measure("ball.frictoin"), "there is no property \"frictoin\"; there are position");
    expect_refusal(measure("ball.position"), "must continue with one of x, y, z");
    expect_refusal(measure("ball.position.w"), "has no \"w\"");
    expect_refusal(measure("ball.mass.x"), "must end after \"mass\"");
    expect_refusal(measure("bodies[9].mass"), "there are 4 bodies, numbered from 0");
    expect_refusal(measure("bodies[x].mass"), "whole numbers in brackets");
    expect_refusal(measure("'wide crate.mass"), "must have a closing '");
    expect_refusal(measure("ball.touches"), "must continue with the name of a body");
    expect_refusal(measure("ball..mass"), "must have a name before and after each dot");
    expect_refusal(measure("ball.mass +"), "is not a valid expression");
    expect_refusal(measure("ball.mass, 2"), "must be one expression");
    expect_refusal(measure("foo(2)"), "foo: must be a parameter, a measure before this one, a function");
    expect_refusal(measure(" "), "is empty");
    expect_refusal("\"set\": {\"ball.speed\": 2}", "can be measured, but not set");
    expect_refusal("\"set\": {\"ball.mass\": \"later\"}, " + measure("1"), "set.ball.mass: later: must be a parameter");
    expect_refusal("\"stop\": [\"ball.mass >\"]", "stop[0]");
}

TEST_F(SweepProperties, BadPlansAreToldWithTheirPlace) {
    write_scene();
    expect_refusal("\"sconds\": 1", "\"sconds\": is unknown");
    expect_refusal("\"seconds\": 0", "seconds: must be");
    expect_refusal(R"json("parameters": [{"name": "a", "values": []}])json", "parameters[0].values: must have a value");
    expect_refusal(R"json("parameters": [{"name": "a", "from": 1, "to": 2}])json",
                   "parameters[0]: must have \"values\"");
    expect_refusal(R"json("parameters": [{"name": "a", "from": 0, "to": 2, "count": 3, "log": true}])json",
                   "parameters[0].from");
    expect_refusal(R"json("parameters": [{"name": "2a", "values": [1]}])json", "begin with no digit");
    expect_refusal(R"json("parameters": [{"name": "a", "values": [1]}, {"name": "a", "values": [1]}])json",
                   "is taken already");
    expect_refusal(R"json("parameters": [{"name": "time", "values": [1]}])json", "is taken already");
    expect_refusal(R"json("parameters": [{"name": "a", "from": 0, "to": 1, "count": 1000000},
                                     {"name": "b", "from": 0, "to": 1, "count": 1000000}])json",
                   "must have at most 1000000000 rows, got 1000000000000");
    expect_refusal(R"json("sample": {"random": 1000000000000})json", "sample.random: must be a whole number");
    expect_refusal(R"json("sample": {"sobol": 3, "random": 3})json", "must be the only kind of sample");
    expect_refusal(R"json("sample": "latin")json", "must be \"grid\" or an object");
    expect_refusal(R"json("measure": [{"name": "m", "of": "1", "at": 20}])json", "measure[0].at: must be 0 to 10");
    expect_refusal(R"json("measure": [{"name": "m", "of": "1", "take": "median"}])json", "must be \"end\"");
}

TEST_F(SweepProperties, ATableGivesTheRows) {
    write_scene();
    write("rows.csv", "height,\"push\"\n1,2\n3,-4\n\n");
    const std::vector<Row> rows = rows_of(plan(R"json("sample": {"table": "rows.csv"}, "seconds": 0.01,
            "set": {"ball.position.y": "height", "ball.velocity.x": "push"},
            "measure": [{"name": "y", "of": "ball.position.y", "at": 0}, {"name": "v",
            "of": "ball.velocity.x"}])json"));
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[1].at("y"), 3.0);
    EXPECT_EQ(rows[1].at("v"), -4.0);
    for (const auto& [text, part] :
         std::vector<std::pair<std::string, std::string>>{{"", "must have a first line"},
                                                          {"a\n", "must have a line of numbers"},
                                                          {"a,b\n1\n", ":2: must have 2 fields"},
                                                          {"a\nx\n", ":2: column 1: must be a number"},
                                                          {"a,a\n1,1\n", "is taken already"}}) {
        write("rows.csv", text);
        const std::string message = refusal("\"sample\": {\"table\": \"rows.csv\"}");
        EXPECT_NE(message.find(part), std::string::npos) << text << "\n" << message;
        EXPECT_NE(message.find("rows.csv"), std::string::npos) << message;
    }
}

} // namespace
} // namespace cairn::test
