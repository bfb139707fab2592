// Robots on the command line: fixed bases, floors, joint targets, missing meshes, xacro.
#include "cli_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace cairn::test;

std::string inertial(double mass, const std::string& xyz = "0 0 0") {
    return "<inertial><origin xyz=\"" + xyz + "\"/><mass value=\"" + std::to_string(mass) +
           R"("/><inertia ixx="0.02" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.02"/></inertial>)";
}

// A base on the ground, an arm of 0.5 m that rotates about y, and a hand that slides along it.
std::string arm(const std::string& limit = R"(effort="100" velocity="0")", const std::string& more = "") {
    return "<robot name=\"arm\"><link name=\"base\">" + inertial(5) +
           R"(<collision><origin xyz="0 0 0.1"/><geometry><box size="0.4 0.4 0.2"/></geometry></collision></link>)" +
           "<link name=\"upper\">" + inertial(2, "0.5 0 0") + "</link><link name=\"hand\">" + inertial(0.5) +
           "</link>" +
           R"(<joint name="elbow" type="revolute"><parent link="base"/><child link="upper"/><origin xyz="0 0 1"/>)" +
           R"(<axis xyz="0 -1 0"/><limit lower="-2" upper="2" )" + limit + "/></joint>" +
           R"(<joint name="slide" type="prismatic"><parent link="upper"/><child link="hand"/><axis xyz="1 0 0"/>)" +
           R"(<limit lower="0" upper="1" effort="100" velocity="0"/></joint>)" + more + "</robot>";
}

class CliRobot : public Cli {
  protected:
    void write(const char* name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

    // The last pose of a body in a CSV file: its position, and its quaternion x, y, z, w.
    std::vector<double> last(const std::string& body) const {
        std::istringstream lines(read_all(folder_ / "out.csv"));
        std::vector<double> pose;
        for (std::string line; std::getline(lines, line);) {
            const std::size_t at = line.find("\"" + body + "\",");
            if (at == std::string::npos) continue;
            std::istringstream fields(line.substr(at + body.size() + 3));
            pose.clear();
            for (std::string field; pose.size() < 7 && std::getline(fields, field, ',');)
                pose.push_back(std::stod(field));
        }
        return pose;
    }
    // The angle by which a link has rotated about a horizontal axis.
    static double angle(const std::vector<double>& pose) { return 2 * std::asin(std::hypot(pose.at(4), pose.at(5))); }
};

TEST_F(CliRobot, ABaseThatIsFixedDoesNotFall) {
    write("arm.urdf", arm());
    ASSERT_EQ(cairn("run arm.urdf --seconds 1 --csv out.csv").code, 0);
    EXPECT_LT(last("base").at(1), -4.0);
    ASSERT_EQ(cairn("run arm.urdf --seconds 1 --csv out.csv --fixed-base").code, 0);
    EXPECT_EQ(last("base").at(1), 0.0);
    EXPECT_LT(last("hand").at(1), 0.9); // the arm swings
    ASSERT_EQ(cairn("convert arm.urdf arm.gltf --fixed-base --floor").code, 0);
    EXPECT_EQ(nlohmann::json::parse(cairn("run arm.gltf --frames 1 --json").out)["bodies"], 4);
    expect_one_line(cairn("run t_handles --fixed-base"), 1,
                    "must be a robot in URDF, MJCF or SDF for its base to be fixed");
    write("free.urdf",
          "<robot name=\"r\"><link name=\"world\"/><link name=\"a\">" + inertial(1) +
              R"(</link><joint name="j" type="floating"><parent link="world"/><child link="a"/></joint></robot>)");
    const Result fixed = cairn("run free.urdf --frames 60 --json --fixed-base");
    EXPECT_EQ(nlohmann::json::parse(fixed.out)["energy"]["kinetic"], 0.0) << fixed.err;
}

TEST_F(CliRobot, AFloorHoldsWhatStandsOnIt) {
    write("box.urdf", "<robot name=\"r\"><link name=\"a\">" + inertial(1) +
                          R"(<collision><geometry><box size="1 1 1"/></geometry></collision></link></robot>)");
    ASSERT_EQ(cairn("run box.urdf --seconds 2 --csv out.csv --floor").code, 0);
    EXPECT_NEAR(last("a").at(1), 0.0, 1e-3); // its initial height
    EXPECT_NEAR(last("floor").at(1), -0.5, 1e-6);
    ASSERT_EQ(cairn("run t_handles --frames 1 --floor").code, 0);
}

TEST_F(CliRobot, JointsFollowTheirTargets) {
    write("arm.urdf", arm());
    write("poses.csv", "time,elbow,slide\r\n0,0,0\r\n1,0.8,0.3\r\n2,0.8,0.3\r\n");
    const Result result = cairn("run arm.urdf --seconds 3 --fixed-base --targets poses.csv --csv out.csv");
    ASSERT_EQ(result.code, 0) << result.err;
    const double turned = angle(last("upper"));
    EXPECT_NEAR(turned, 0.8, 0.01);
    const std::vector<double> upper = last("upper"), hand = last("hand");
    EXPECT_NEAR(std::hypot(hand[0] - upper[0], hand[1] - upper[1]), 0.3, 0.01);
    const Result stiff =
        cairn("run arm.urdf --seconds 3 --fixed-base --targets poses.csv --csv out.csv --servo-frequency 40");
    ASSERT_EQ(stiff.code, 0) << stiff.err;
    EXPECT_NEAR(angle(last("upper")), 0.8, 0.002); // the stiff servo deflects less
}

// A hip with two rotation axes becomes one universal joint.
TEST_F(CliRobot, BothAxesOfAHipFollowTheirTargets) {
    write("hip.xml",
          R"(<mujoco><option timestep="0.005"/><compiler angle="radian"/><worldbody><body name="pelvis" pos="0 0 2">
        <geom type="box" size=".2 .2 .1"/><body name="thigh" pos="0 0 -.2"><joint name="roll" axis="1 0 0"/>
        <joint name="pitch" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0 0 -.5" size=".05"/></body></body>
        </worldbody></mujoco>)");
    write("poses.csv", "time,roll+pitch.position1,roll+pitch.position2\n0,0,0\n1,0.3,-0.5\n");
    const Result result = cairn(
        "run hip.xml --seconds 3 --targets poses.csv --servo-frequency 20 --columns joints --from 3 --csv out.csv");
    ASSERT_EQ(result.code, 0) << result.err;
    const std::string table = read_all(folder_ / "out.csv");
    std::istringstream header(table.substr(0, table.find('\n'))), row(table.substr(table.find('\n') + 1));
    std::string name, value;
    int seen = 0;
    while (std::getline(header, name, ',') && std::getline(row, value, ',')) {
        if (name != "roll+pitch.position1" && name != "roll+pitch.position2") continue;
        EXPECT_NEAR(std::stod(value), name.back() == '1' ? 0.3 : -0.5, 0.01);
        ++seen;
    }
    EXPECT_EQ(seen, 2);
    write("half.csv", "time,roll+pitch\n0,0\n");
    expect_one_line(cairn("run hip.xml --targets half.csv"), 1, "(roll+pitch.position1, roll+pitch.position2)");
}

// A weak spring that the file gives a joint is no servo: 2 N m/rad do not lift 0.5 m of leg.
TEST_F(CliRobot, AServoFrequencyThatIsGivenIsThatOfJointsWithSpringsToo) {
    write(
        "leg.xml",
        R"(<mujoco><compiler angle="radian"/><worldbody><body name="hip" pos="0 0 2"><geom type="box" size=".2 .2 .1"/>
        <body name="leg"><joint name="knee" axis="0 1 0" stiffness="2" damping="1"/>
        <geom type="capsule" fromto=".3 0 0 .8 0 0" size=".05"/></body></body></worldbody></mujoco>)");
    write("poses.csv", "time,knee\n0,0\n");
    const auto turned = [&](const std::string& options) {
        const Result result = cairn("run leg.xml --fixed-base --seconds 3 --targets poses.csv --csv out.csv" + options);
        EXPECT_EQ(result.code, 0) << result.err;
        return angle(last("leg"));
    };
    EXPECT_GT(turned(""), 0.5);
    EXPECT_LT(turned(" --servo-frequency 20"), 0.02);
}

// Six links of 15 kg in all, stretched out horizontally. The second joint carries the last five of them.
TEST_F(CliRobot, AnArmHoldsItsPoseWithTheTorqueOfTheClosedForm) {
    const double masses[] = {4, 4, 3, 2, 1.5, 0.5}, lengths[] = {0.15, 0.4, 0.35, 0.1, 0.1, 0.05};
    const char* axes[] = {"0 0 1", "0 1 0", "0 1 0", "1 0 0", "0 1 0", "1 0 0"};
    std::ostringstream robot;
    robot << "<robot name=\"arm\"><link name=\"l\">" << inertial(4) << "</link>";
    std::string names = "time", zeros = "0";
    double torque = 0, reach = 0;
    for (int i = 0; i < 6; ++i) {
        const double m = masses[i], l = lengths[i], across = m * l * l / 12 + m * 0.05 * 0.05 / 4;
        robot << "<link name=\"l" << i << "\"><inertial><origin xyz=\"" << l / 2 << " 0 0\"/><mass value=\"" << m
              << "\"/><inertia ixx=\"" << m * 0.05 * 0.05 / 2 << R"(" ixy="0" ixz="0" iyz="0" iyy=")" << across
              << "\" izz=\"" << across << "\"/></inertial></link><joint name=\"j" << i
              << "\" type=\"revolute\"><parent link=\"l" << (i == 0 ? "" : std::to_string(i - 1))
              << "\"/><child link=\"l" << i << "\"/><origin xyz=\"" << (i == 0 ? 0.1 : lengths[i - 1])
              << " 0 0\"/><axis xyz=\"" << axes[i]
              << R"("/><limit lower="-3" upper="3" effort="300" velocity="2"/></joint>)";
        names += ",j" + std::to_string(i);
        zeros += ",0";
        if (i > 0) torque += m * 9.81 * (reach + l / 2);
        if (i > 0) reach += l;
    }
    write("arm.urdf", robot.str() + "</robot>");
    write("hold.csv", names + "\n" + zeros + "\n");
    const Result result =
        cairn("run arm.urdf --fixed-base --targets hold.csv --seconds 10 --columns joints --from 10 --csv out.csv");
    ASSERT_EQ(result.code, 0) << result.err;
    const std::string table = read_all(folder_ / "out.csv");
    std::istringstream header(table.substr(0, table.find('\n'))), row(table.substr(table.find('\n') + 1));
    std::string name, value;
    int seen = 0;
    while (std::getline(header, name, ',') && std::getline(row, value, ',')) {
        if (name == "j1.torque_z") {
            EXPECT_NEAR(std::fabs(std::stod(value)), torque, 0.001 * torque);
            ++seen;
        }
        if (name.find(".position") != std::string::npos) {
            EXPECT_NEAR(std::stod(value), 0.0, 0.03) << name;
            ++seen;
        }
    }
    EXPECT_EQ(seen, 7);
}

TEST_F(CliRobot, TargetsMoveNoFasterThanTheLimitsOfSpeed) {
    write("arm.urdf", arm(R"(effort="100" velocity="0.5")"));
    write("poses.csv", "time,\"elbow\"\n0,1.5");
    const Result result = cairn("run arm.urdf --seconds 1 --fixed-base --targets poses.csv --csv out.csv");
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_NEAR(angle(last("upper")), 0.5, 0.02);
    EXPECT_NE(result.err.find("the velocity limits of 1 joint hold for the targets of motors"), std::string::npos);
    ASSERT_EQ(cairn("run arm.urdf --seconds 4 --fixed-base --targets poses.csv --csv out.csv").code, 0);
    EXPECT_NEAR(angle(last("upper")), 1.5, 0.02);
}

TEST_F(CliRobot, MistakesInTargetsNameLineAndColumn) {
    write("arm.urdf",
          arm(R"(effort="100" velocity="0")",
              "<link name=\"leaf\">" + inertial(1) +
                  R"(</link><joint name="loose" type="floating"><parent link="hand"/><child link="leaf"/></joint>)"));
    const auto expect = [&](const std::string& text, const std::string& part) {
        write("t.csv", text);
        SCOPED_TRACE(text.substr(0, 60));
        expect_one_line(cairn("run arm.urdf --seconds 100000 --targets t.csv"), 1, "t.csv" + part);
    };
    expect("", ":1: must have a first line");
    expect("elbow,time\n", ":1: column 1: must be named \"time\", got \"elbow\"");
    expect("time\n0\n", ":1: must name a joint after the time");
    expect("time,elbow,elbow\n0,0,0\n", ":1: column 3: must be named once only");
    expect("time,elbow\n", ":1: must have a line of numbers");
    expect("time,elbow\n0,0\n1,x\n", ":3: column 2: must be a number, got \"x\"");
    expect("time,elbow\n0,0\n1,nan\n", ":3: column 2: must be a number");
    expect("time,elbow\n0,0\n1,\n", ":3: column 2: must be a number, got \"\"");
    expect("time,elbow\n0,1e300\n", ":2: column 2: must be within 1000000");
    expect("time,elbow\n0,0\n0,1\n", ":3: column 1: must be a later time");
    expect("time,elbow\n0,0,1\n", ":2: must have 2 fields as the first line, has 3");
    expect("time,\"elbow\n0,0\n", ":1: column 2: must end with a quote");
    expect("time,elbo\n0,0\n", ":1: column 2: must be the name of a hinge, a slider or an axis of a universal joint "
                               "(elbow, slide), got \"elbo\"");
    expect("time,loose\n0,0\n",
           ":1: column 2: is another joint; must be a hinge, a slider or an axis of a universal joint (elbow, slide)");
    expect(std::string(30000, ','), ":1: column 10002: must be one of at most 10000 columns");
    expect_one_line(cairn("run arm.urdf --targets none.csv"), 1, "none.csv: there is no such file");
    expect_one_line(cairn("run arm.urdf --servo-frequency 5"), 2, "--targets");
}

TEST_F(CliRobot, OneMissingMeshDoesNotRefuseARobotThatHasItsInertia) {
    const std::string mesh = R"(<collision><geometry><mesh filename="none.stl"/></geometry></collision>)";
    const std::string cad = R"(<collision><geometry><mesh filename="there.dae"/></geometry></collision>)";
    write("there.dae", "<COLLADA/>");
    write("r.urdf", "<robot name=\"r\"><link name=\"a\">" + inertial(3) + mesh + cad + "</link></robot>");
    const Result result = cairn("run r.urdf --frames 1 --json");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.err.find("collision 1: mesh filename: there is no such file"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("(the shape is left out)"), std::string::npos);
    EXPECT_NE(result.err.find("collision 2: mesh filename: must be an .stl or .obj file"), std::string::npos);
    write("r.urdf", "<robot name=\"r\"><link name=\"a\">" + mesh + "</link></robot>"); // the mass would be unknown
    expect_one_line(cairn("run r.urdf --frames 1"), 1, "there is no such file");
    write("r.urdf",
          "<robot name=\"r\"><link name=\"a\">" + inertial(3) +
              R"(<collision><geometry><mesh filename="../../outside.stl"/></geometry></collision></link></robot>)");
    const Result outside = cairn("run r.urdf --frames 1 --json");
    EXPECT_EQ(outside.code, 0) << outside.err;
    EXPECT_NE(outside.err.find("or below it, also where links lead"), std::string::npos) << outside.err;
}

TEST_F(CliRobot, XacroFilesAreToldForWhatTheyAre) {
    const std::string part = "is a xacro file (";
    write("r.urdf.xacro", "<robot name=\"r\" xmlns:xacro=\"http://ros.org/wiki/xacro\">\n"
                          "<xacro:property name=\"m\" value=\"1\"/><link name=\"a\"/></robot>");
    expect_one_line(
        cairn("run r.urdf.xacro"), 1,
        "r.urdf.xacro:2: is a xacro file (\"xacro:property\"), from which the program xacro of ROS makes a URDF "
        "file: xacro r.urdf.xacro > robot.urdf");
    write("r.urdf", "<robot name=\"r\"><link name=\"a\"><inertial><mass value=\"${m}\"/></inertial></link></robot>");
    expect_one_line(cairn("run r.urdf"), 1, part);
    // The output of xacro keeps its XML namespace and a comment that mentions it.
    write("r.urdf",
          "<!-- <xacro:include/> --><robot name=\"r\" xmlns:xacro=\"http://ros.org/wiki/xacro\"><link name=\"a\">" +
              inertial(1) + "</link></robot>");
    EXPECT_EQ(cairn("run r.urdf --frames 1").code, 0);
}

} // namespace
