// Tables of runs: the choice of columns and of times, and the two formats.
#include "cli_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace cairn::test;

using Table = std::vector<std::vector<std::string>>;

Table table_of(const std::string& text) {
    Table table;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        table.emplace_back();
        for (std::string field; std::getline(fields, field, ',');) table.back().push_back(field);
    }
    return table;
}

class CliTable : public Cli {
  protected:
    Table run(const std::string& arguments) const {
        const Result result = cairn("run " + arguments + " --csv -");
        EXPECT_EQ(result.code, 0) << result.err;
        return table_of(result.out);
    }
};

TEST_F(CliTable, ColumnsAreChosen) {
    const Table places = run("t_handles --frames 2 --columns position");
    EXPECT_EQ(places.at(0), (std::vector<std::string>{"time", "body", "name", "px", "py", "pz"}));
    EXPECT_EQ(places.size(), 1u + 3 * 3);
    const Table sums = run("08 --frames 2 --columns contacts,energy,momentum");
    EXPECT_EQ(sums.at(0), (std::vector<std::string>{"time", "kinetic", "potential", "mx", "my", "mz", "lx", "ly", "lz",
                                                    "contacts", "contact_points", "max_penetration"}));
    ASSERT_EQ(sums.size(), 1u + 3); // one line for the whole world at each time
    EXPECT_EQ(sums[1][9], "0");
    EXPECT_EQ(sums[3][9], "40");
    const Table both = run("t_handles --frames 1 --columns velocity,energy");
    EXPECT_EQ(both.at(0), (std::vector<std::string>{"time", "body", "name", "vx", "vy", "vz", "kinetic", "potential"}));
    // The same in every line of a time.
    for (std::size_t i = 2; i <= 3; ++i) EXPECT_EQ(both.at(i).at(6), both.at(1).at(6));
    const std::string refused = "run t_handles --seconds 100000 --csv a.csv --columns ";
    expect_one_line(cairn(refused + "positions"), 2, "must be some of position, rotation, ");
    expect_one_line(cairn(refused + "position,,energy"), 2, "separated by commas, got ");
    expect_one_line(cairn(refused + "''"), 2, "--columns");
    expect_one_line(cairn("run t_handles --columns energy"), 2, "--csv");
}

// A rod of 2 kg that its hinge holds horizontal: the torque is m g r about the axis, the force m g upwards.
TEST_F(CliTable, JointsHaveTheirPositionsForcesAndTorques) {
    std::ofstream(folder_ / "arm.urdf")
        << R"(<robot name="r"><link name="world"/><link name="rod"><inertial><origin xyz="0.5 0 0"/><mass value="2"/>)"
           R"(<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link>)"
           R"(<joint name="a, b" type="continuous"><parent link="world"/><child link="rod"/><axis xyz="0 -1 0"/>)"
           "</joint>"
           R"(</robot>)";
    std::ofstream(folder_ / "level.csv") << "time,\"a, b\"\n0,0\n";
    const Table table = run("arm.urdf --seconds 5 --targets level.csv --columns joints --servo-frequency 20");
    ASSERT_EQ(table.at(0).size(), 1u + 2 * 7); // the comma in the joint's name splits the header here
    EXPECT_EQ(table[0][1], "\"a");
    EXPECT_EQ(table[0][2], " b.position\"");
    const std::vector<std::string>& last = table.back();
    ASSERT_EQ(last.size(), 8u);
    EXPECT_NEAR(std::stod(last[1]), 0.0, 0.01);
    EXPECT_NEAR(std::stod(last[3]), 2 * 9.81, 0.01 * 2 * 9.81);
    EXPECT_NEAR(std::fabs(std::stod(last[7])), 2 * 9.81 * 0.5, 0.01 * 2 * 9.81 * 0.5); // closed form, within 1 %
}

TEST_F(CliTable, MomentsAreChosen) {
    const auto times = [&](const std::string& arguments) {
        std::vector<double> result;
        const Table table = run("t_handles --dt 0.01 --seconds 1 --columns energy " + arguments);
        for (std::size_t i = 1; i < table.size(); ++i) result.push_back(std::stod(table[i][0]));
        return result;
    };
    EXPECT_EQ(times("").size(), 101u);
    const std::vector<double> tens = times("--every 10");
    ASSERT_EQ(tens.size(), 11u);
    EXPECT_NEAR(tens[3], 0.3, 1e-6);
    const std::vector<double> window = times("--from 0.3 --until 0.5");
    ASSERT_EQ(window.size(), 21u);
    EXPECT_NEAR(window.front(), 0.3, 1e-6);
    EXPECT_NEAR(window.back(), 0.5, 1e-6);
    EXPECT_EQ(times("--from 0.25 --until 0.55 --every 10").size(), 3u);
    EXPECT_EQ(times("--until 0").size(), 1u);
    EXPECT_EQ(times("--until 1e9").size(), 101u);
    const std::string refused = "run t_handles --seconds 10 --csv a.csv ";
    expect_one_line(cairn(refused + "--from 3 --until 2"), 1, "--until: must not be before --from, 3, got 2");
    expect_one_line(cairn(refused + "--from 11"), 1, "--from: must not be after the end of the run, 10 s, got 11");
    expect_one_line(cairn(refused + "--every 0"), 2, "--every");
    expect_one_line(cairn(refused + "--from 0.001 --until 0.002"), 1, "select no step");
    expect_one_line(cairn(refused + "--from 0.5 --every 1000"), 1, "select no step");
    EXPECT_EQ(cairn("run t_handles --seconds 1 --csv a.csv --from 1 --every 60").code, 0); // only the last step
    expect_one_line(cairn(refused + "--from nan"), 2, "--from");
    expect_one_line(cairn("run t_handles --every 2"), 1, "are for --csv, --animate and --video, and there is none");
    ASSERT_EQ(cairn("run t_handles --frames 60 --every 20 --animate a.gltf").code, 0);
    const nlohmann::json animated = nlohmann::json::parse(read_all(folder_ / "a.gltf"));
    const std::size_t input = animated["animations"][0]["samplers"][0]["input"];
    EXPECT_EQ(animated["accessors"][input]["count"], 4);
}

TEST_F(CliTable, ArraysOfNumPyHaveTheSameNumbers) {
    const std::string arguments = "run t_handles --frames 4 --columns position,velocity,contacts";
    ASSERT_EQ(cairn(arguments + " --csv a.csv").code, 0);
    ASSERT_EQ(cairn(arguments + " --csv a.npy").code, 0);
    const Table table = table_of(read_all(folder_ / "a.csv"));
    const std::string array = read_all(folder_ / "a.npy");
    ASSERT_EQ(array.substr(0, 8), std::string("\x93NUMPY\1\0", 8));
    std::uint16_t length = 0;
    std::memcpy(&length, array.data() + 8, sizeof length);
    EXPECT_EQ((10u + length) % 64, 0u);
    const std::string header = array.substr(10, length);
    EXPECT_EQ(header.find("{'descr': [('time', '<f8'), ('body', '<i8'), ('px', '<f8'), "), 0u) << header;
    EXPECT_NE(header.find("('vx', '<f4'), "), std::string::npos);
    EXPECT_NE(header.find("], 'fortran_order': False, 'shape': (15,), }"), std::string::npos) << header;
    EXPECT_EQ(header.back(), '\n');
    const std::size_t row = 8 * 5 + 4 * 3 + 8 * 3;
    ASSERT_EQ(array.size(), 10u + length + 15 * row);
    for (std::size_t i = 0; i < 15; ++i) {
        const char* at = array.data() + 10 + length + i * row;
        double time = 0, px = 0;
        float vx = 0;
        std::memcpy(&time, at, 8);
        std::memcpy(&px, at + 16, 8);
        std::memcpy(&vx, at + 40, 4);
        EXPECT_EQ(time, std::stod(table.at(i + 1).at(0)));
        EXPECT_EQ(px, std::stod(table[i + 1][3]));
        EXPECT_EQ(vx, std::stof(table[i + 1][6]));
    }
    // A pipe cannot be rewound to fix the header, and yet gives the same bytes.
    ASSERT_EQ(shell("mkfifo b.npy; cat b.npy >got & \"$CAIRN\" " + arguments + " --csv b.npy; wait").code, 0);
    EXPECT_EQ(read_all(folder_ / "got"), array);
    expect_one_line(cairn(arguments + " --csv /dev/full"), 1, "No space left on device");
}

TEST_F(CliTable, ArraysMayHaveManyAndStrangeNames) {
    std::string robot = R"(<robot name="r"><link name="world"/>)";
    for (int i = 0; i < 700; ++i) {
        const std::string n = std::to_string(i);
        robot += "<link name=\"l" + n +
                 R"("><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" )" +
                 R"(izz="1"/></inertial></link><joint name="it's \ )" + "\xC3\xA4" + n +
                 R"(" type="continuous"><parent link="world"/><child link="l)" + n + "\"/></joint>";
    }
    std::ofstream(folder_ / "r.urdf") << robot + "</robot>";
    const Result result = cairn("run r.urdf --frames 1 --columns joints --csv a.npy");
    ASSERT_EQ(result.code, 0) << result.err;
    const Result read = shell(
        "python3 -c \"import ast, struct; b = open('a.npy', 'rb').read(); assert b[6] == 2, b[6]; n, = "
        "struct.unpack('<I', b[8:12]); d = ast.literal_eval(b[12:12 + n].decode('latin1')); names = [f[0] for f in "
        "d['descr']]; assert len(set(names)) == 1 + 7 * 700; assert d['shape'] == (2,); assert (12 + n) % 64 == 0; "
        "assert len(b) == 12 + n + 2 * (8 + 4 * 7 * 700); print(names[1] == 'it\\x27s \\x5c \\xc3\\xa4' + "
        "names[1][9:])\"");
    EXPECT_EQ(read.out, "True\n") << read.err;
}

TEST_F(CliTable, TheSummaryHasTheMomenta) {
    const nlohmann::json json = nlohmann::json::parse(cairn("run t_handles --frames 1 --json").out);
    for (const char* kind : {"linear", "angular"}) {
        ASSERT_EQ(json["momentum"][kind].size(), 3u);
        for (const auto& part : json["momentum"][kind]) EXPECT_TRUE(part.is_number());
    }
    const Table table = run("t_handles --frames 1 --columns momentum");
    EXPECT_NEAR(json["momentum"]["angular"][1].get<double>(), std::stod(table.back().at(5)), 1e-9);
}

TEST_F(CliTable, ProgressIsShownOnTerminalsAlone) {
    const std::string in_terminal =
        "python3 -c \"import pty, sys; sys.exit(pty.spawn(sys.argv[1:]) >> 8)\" \"$CAIRN\" run t_handles ";
    const Result shown = shell("stty cols 120 2>/dev/null; " + in_terminal + "--seconds 3000");
    EXPECT_EQ(shown.code, 0) << shown.out << shown.err;
    EXPECT_NE(shown.out.find("/180000 steps, "), std::string::npos) << shown.out;
    EXPECT_NE(shown.out.find(" x real time), "), std::string::npos);
    EXPECT_NE(shown.out.find(" left"), std::string::npos);
    EXPECT_NE(shown.out.find("\r\033[K"), std::string::npos); // the line is cleared at the end
    const Result table = shell(in_terminal + "--seconds 3000 --columns energy --every 1000 --csv -");
    EXPECT_EQ(table.out.find(" left"), std::string::npos); // otherwise it would be in the table
    EXPECT_EQ(cairn("run t_handles --seconds 3000").err, "");
}

} // namespace
