// The program as users run it: exit codes, one line for every error, output files complete or absent.
#include "cli_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace fs = std::filesystem;
using namespace cairn::test;

TEST_F(Cli, HelpOfEveryCommand) {
    for (const char* arguments : {"--help", "run --help", "view --help", "scenes --help", "convert --help",
                                  "validate --help", "doctor --help", "completion --help", "manual --help"}) {
        const Result result = cairn(arguments);
        EXPECT_EQ(result.code, 0) << arguments;
        EXPECT_NE(result.out.find("Usage:"), std::string::npos) << arguments;
        EXPECT_EQ(result.err, "") << arguments;
    }
}

TEST_F(Cli, WrongCallsAreOneLineAndCodeTwo) {
    expect_one_line(cairn(""), 2, "subcommand is required");
    expect_one_line(cairn("fly"), 2, "there is no command \"fly\"");
    expect_one_line(cairn("run"), 2, "scene is required");
    expect_one_line(cairn("run welcome --bounce"), 2, "--bounce");
    expect_one_line(cairn("run welcome --dt 0"), 2, "--dt: must be a number from 0.0001 to 1, got 0");
    expect_one_line(cairn("run welcome --dt nan"), 2, "--dt: must be a number from 0.0001 to 1, got nan");
    expect_one_line(cairn("run welcome --frames -1"), 2, "--frames");
    expect_one_line(cairn("run welcome --substeps 257"), 2, "--substeps");
    expect_one_line(cairn("run welcome --seconds 1 --frames 2"), 2, "excludes");
    expect_one_line(cairn("run welcome --threads 0"), 2, "--threads");
    expect_one_line(cairn("run welcome --threads 257"), 2, "--threads");
    expect_one_line(cairn("run welcome --integrator verlet"), 2, "must be one of semi-implicit, explicit, rk4");
}

TEST_F(Cli, ErrorsAtRunTimeAreOneLineAndCodeOne) {
    expect_one_line(cairn("run no_such_scene"), 1,
                    "no_such_scene: there is no such file, nor a scene of that name in ");
    expect_one_line(cairn("run ."), 1, "is a folder, not a file");
    std::ofstream(folder_ / "broken.gltf") << R"({"asset":{"version":"2.0"},"nodes":[{"mass":}]})";
    expect_one_line(cairn("run broken.gltf"), 1, "broken.gltf: is not valid JSON");
    expect_one_line(cairn("run t_handles --frames 1 --csv missing/a.csv"), 1, "missing/a.csv: cannot be written");
    expect_one_line(cairn("run t_handles --frames 1 --save missing/a.gltf"), 1, "missing/a.gltf: cannot be written");
    expect_one_line(cairn("scenes missing"), 1, "missing: cannot be listed");
    expect_one_line(cairn("view no_such_scene"), 1, "no_such_scene");
}

TEST_F(Cli, ANameOfAMillionLettersIsCutInTheLineThatTellsOfIt) {
    const std::string name = "\"rest" + std::string(1000000, '[') + "\"";
    std::ofstream(folder_ / "open.gltf") << "{\"asset\":{\"version\":\"2.0\"}, " << name.substr(0, name.size() - 1);
    const Result refused = cairn("run open.gltf");
    expect_one_line(refused, 1, "open.gltf: is not valid JSON");
    EXPECT_LT(refused.err.size(), 1300u);
    std::ofstream(folder_ / "misspelled.gltf")
        << R"({"asset":{"version":"2.0"},"extensions":{"KHR_physics_rigid_bodies":{"physicsMaterials":[{)" << name
        << ":1}]}}}";
    const Result taken = cairn("run misspelled.gltf --frames 1");
    EXPECT_EQ(taken.code, 0) << taken.err.substr(0, 1000);
    EXPECT_NE(taken.err.find("[ ... ["), std::string::npos);
    EXPECT_NE(taken.err.find("is not known and has no effect"), std::string::npos);
    EXPECT_LT(taken.err.size(), 3000u);
}

TEST_F(Cli, AMeshAloneIsNoSceneToRun) {
    std::ofstream(folder_ / "a.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    expect_one_line(cairn("run a.obj"), 1, "a.obj: is a mesh, not a scene; `cairn convert` makes a body of it");
}

TEST_F(Cli, JsonSummary) {
    const Result result = cairn("run open_plane --frames 5 --json");
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    const nlohmann::json json = nlohmann::json::parse(result.out);
    EXPECT_NE(json["scene"].get<std::string>().find("01_open_plane.gltf"), std::string::npos);
    EXPECT_EQ(json["bodies"], 28);
    EXPECT_EQ(json["steps"], 5);
    EXPECT_GE(json["threads"], 1);
    EXPECT_EQ(json["hash"].get<std::string>().size(), 16u);
    for (const char* key : {"mean", "median", "p99"}) EXPECT_GE(json["ms_per_step"][key].get<double>(), 0.0);
    for (const char* key : {"kinetic", "potential"}) EXPECT_GT(json["energy"][key].get<double>(), 0.0);
    for (const char* key : {"isa", "max_penetration", "contacts", "contact_points"}) EXPECT_TRUE(json.contains(key));
    const nlohmann::json again = nlohmann::json::parse(cairn("run open_plane --frames 5 --json").out);
    EXPECT_EQ(again["hash"], json["hash"]);
    const nlohmann::json later = nlohmann::json::parse(cairn("run open_plane --seconds 0.1 --json").out);
    EXPECT_EQ(later["steps"], 6);
    EXPECT_NE(later["hash"], json["hash"]);
}

TEST_F(Cli, OptionsReachTheWorld) {
    const nlohmann::json json = nlohmann::json::parse(
        cairn("run t_handles --frames 30 --dt 0.01 --integrator semi-implicit --substeps 2 --threads 1 --json").out);
    const nlohmann::json rk4 =
        nlohmann::json::parse(cairn("run t_handles --frames 30 --dt 0.01 --integrator rk4 --substeps 2 --json").out);
    EXPECT_NEAR(json["time_step"].get<double>(), 0.01, 1e-9);
    EXPECT_NE(json["hash"], rk4["hash"]);
}

TEST_F(Cli, TextSummary) {
    const Result result = cairn("run t_handles --frames 3");
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.out.find("3 bodies"), std::string::npos);
    EXPECT_NE(result.out.find("3 steps"), std::string::npos);
}

TEST_F(Cli, CsvHasALineForEachBodyAndMoment) {
    ASSERT_EQ(cairn("run t_handles --frames 4 --csv out.csv").code, 0);
    const std::string csv = read_all(folder_ / "out.csv");
    EXPECT_EQ(csv.substr(0, csv.find('\n')), "time,body,name,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3 * 5); // the initial state and four steps
    EXPECT_NE(csv.find("\n0,1,\"about the middle axis\",0,"), std::string::npos) << csv;
    EXPECT_FALSE(fs::exists(folder_ / "out.csv.partial"));
}

TEST_F(Cli, InterruptedRunsKeepWhatTheyHave) {
    const Result result = cairn("run t_handles --seconds 100000 --csv out.csv --json", "timeout --signal=INT 3");
    const nlohmann::json json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["interrupted"], true);
    const std::string csv = read_all(folder_ / "out.csv");
    ASSERT_FALSE(csv.empty());
    EXPECT_EQ(csv.back(), '\n');
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')),
              1 + 3 * (1 + json["steps"].get<std::size_t>()));
    EXPECT_FALSE(fs::exists(folder_ / "out.csv.partial"));
}

TEST_F(Cli, ScenesHaveTheirNumbersAndTheirNames) {
    const auto scene_of = [&](const std::string& name) {
        const Result result = cairn("run " + name + " --frames 1 --json");
        return result.code == 0 ? nlohmann::json::parse(result.out)["scene"].get<std::string>() : result.err;
    };
    fs::create_directories(folder_ / "tower"); // a folder is not a scene
    for (const char* name : {"08", "8", "tower", "08_tower", "08_tower.gltf", "tower.gltf"})
        EXPECT_NE(scene_of(name).find("/08_tower.gltf"), std::string::npos) << name << ": " << scene_of(name);
    for (const char* name : {"888", "0x8", "08_", "99999999999999999999", "_tower"})
        expect_one_line(cairn(std::string("run ") + name), 1, "nor a scene of that name in ");
}

TEST_F(Cli, NamesOfSeveralScenesAreRefusedWithTheCandidates) {
    fs::create_directories(folder_ / "scenes");
    for (const char* name : {"01_a.gltf", "01_b.gltf", "02_c.gltf", "3_c.glb", "04_01.gltf", "05_d.gltf", "05_d.glb"})
        std::ofstream(folder_ / "scenes" / name) << R"({"asset":{"version":"2.0"}})";
    const auto run = [&](const std::string& name) {
        return shell("CAIRN_SCENES=scenes \"$CAIRN\" run --frames 1 " + name);
    };
    expect_one_line(run("1"), 1, "1: may be any of 01_a.gltf, 01_b.gltf");
    expect_one_line(run("c"), 1, "c: may be any of 02_c.gltf, 3_c.glb");
    expect_one_line(run("05_d"), 1, "05_d: may be any of 05_d.glb, 05_d.gltf");
    for (const char* name : {"a", "01_a", "c.glb", "2", "03", "01", "05_d.glb"}) // 01 is the name of 04_01
        EXPECT_EQ(run(name).code, 0) << name << run(name).err;
}

TEST_F(Cli, SpeedsThatAreCutAreToldOf) {
    std::ofstream(folder_ / "fast.gltf")
        << R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0],"extensions":{"CAIRN_world":{"max_linear_speed":1}}}],)"
           R"("nodes":[{"extensions":{"KHR_physics_rigid_bodies":{"motion":{},"collider":{"geometry":{"shape":0}}}}}],)"
           R"("extensions":{"KHR_implicit_shapes":{"shapes":[{"type":"sphere"}]}}})";
    const Result result = cairn("run fast.gltf --seconds 1 --json");
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.err.find("speeds were cut to the world's limits of 1 m/s"), std::string::npos) << result.err;
    EXPECT_EQ(nlohmann::json::parse(result.out)["warnings"].size(), 1u);
    EXPECT_EQ(cairn("run fast.gltf --frames 2").err, "");
}

TEST_F(Cli, SavedScenesRunAgain) {
    ASSERT_EQ(cairn("run t_handles --frames 10 --save later.gltf").code, 0);
    const nlohmann::json on = nlohmann::json::parse(cairn("run later.gltf --frames 1 --json").out);
    EXPECT_EQ(on["bodies"], 3);
}

TEST_F(Cli, ConvertWritesBothForms) {
    ASSERT_EQ(cairn("convert welcome there.glb").code, 0);
    EXPECT_EQ(read_all(folder_ / "there.glb").substr(0, 4), "glTF");
    ASSERT_EQ(cairn("convert there.glb back.gltf").code, 0);
    ASSERT_EQ(cairn("convert back.gltf again.glb").code, 0);
    EXPECT_EQ(read_all(folder_ / "again.glb"), read_all(folder_ / "there.glb"));
    const nlohmann::json one = nlohmann::json::parse(cairn("run back.gltf --frames 20 --json").out);
    const nlohmann::json other = nlohmann::json::parse(cairn("run there.glb --frames 20 --json").out);
    EXPECT_EQ(one["hash"], other["hash"]);
}

const char* tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

TEST_F(Cli, ConvertMakesScenesOfMeshes) {
    std::ofstream(folder_ / "rock.obj") << tetrahedron;
    ASSERT_EQ(cairn("convert rock.obj rock.gltf --scale 2 --density 600").code, 0);
    const nlohmann::json hull = nlohmann::json::parse(read_all(folder_ / "rock.gltf"));
    EXPECT_NE(hull.dump().find("\"convexHull\":true"), std::string::npos);
    EXPECT_NE(hull.dump().find("\"motion\":{}"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(cairn("run rock.gltf --frames 1 --json").out)["bodies"], 1);
    ASSERT_EQ(cairn("convert rock.obj rock.glb --as mesh").code, 0);
    EXPECT_NE(read_all(folder_ / "rock.glb").find("\"convexHull\":false"), std::string::npos);
    ASSERT_EQ(cairn("convert rock.obj rock.glb --floor").code, 0);
    EXPECT_NE(read_all(folder_ / "rock.glb").find("\"floor\""), std::string::npos);
}

TEST_F(Cli, ConvertRefusesWhatItCannotDo) {
    std::ofstream(folder_ / "rock.obj") << tetrahedron;
    std::ofstream(folder_ / "bad.obj") << "v 0 0 0\nv 1 0\n";
    std::ofstream(folder_ / "flat.obj") << "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
    expect_one_line(cairn("convert rock.obj rock.gltf --as parts"), 2,
                    "--as: must be one of hull, mesh, got parts; --decompose makes a hull several convex parts");
    expect_one_line(cairn("convert rock.obj rock.gltf --scale 0"), 2, "--scale");
    expect_one_line(cairn("convert rock.obj rock.obj"), 2, "out: must end in .gltf, .glb, got rock.obj");
    expect_one_line(cairn("convert welcome a.gltf --as mesh"), 1,
                    "is a scene, and --as, --scale and --density are for");
    expect_one_line(cairn("convert bad.obj a.gltf"), 1, "bad.obj:2: must have a number that fits a float, got \"\"");
    expect_one_line(cairn("convert flat.obj a.gltf"), 1, "Hull points");
    expect_one_line(cairn("convert missing.stl a.gltf"), 1, "missing.stl: there is no such file");
    EXPECT_FALSE(fs::exists(folder_ / "a.gltf"));
}

// The animation is verified by a script that uses only the glTF specification (check_animation.py).
TEST_F(Cli, AnimationsPlayTheRun) {
    for (const char* scene : {"welcome", "t_handles"}) {
        SCOPED_TRACE(scene);
        ASSERT_EQ(cairn(std::string("run ") + scene + " --frames 40 --animate run.glb --csv run.csv").code, 0);
        const std::string line = "python3 '" CAIRN_TEST_CHECK_ANIMATION "' '" + (folder_ / "run.glb").string() + "' '" +
                                 (folder_ / "run.csv").string() + "' >'" + (folder_ / ".out").string() + "' 2>&1";
        EXPECT_EQ(std::system(line.c_str()), 0) << read_all(folder_ / ".out");
        EXPECT_NE(read_all(folder_ / ".out").find("key frames agree"), std::string::npos);
    }
    expect_one_line(cairn("run t_handles --frames 1 --animate missing/a.glb"), 1, "missing/a.glb: cannot be written");
}

// The animation is also verified by three.js, a widespread library, which `./dev test` installs where npm is available.
TEST_F(Cli, AnimationsPlayTheRunInThreeJs) {
    const fs::path reader = CAIRN_TEST_THREE;
    if (!fs::exists(reader / "node_modules")) GTEST_SKIP() << "three.js is not there: npm ci in " << reader;
    for (const char* scene : {"welcome", "t_handles", "ragdolls"}) {
        SCOPED_TRACE(scene);
        ASSERT_EQ(cairn(std::string("run ") + scene + " --frames 40 --animate run.glb --csv run.csv").code, 0);
        const std::string line = "cd '" + folder_.string() + "' && node '" + (reader / "check_animation.mjs").string() +
                                 "' run.glb run.csv >.out 2>&1";
        EXPECT_EQ(std::system(line.c_str()), 0) << read_all(folder_ / ".out");
        EXPECT_NE(read_all(folder_ / ".out").find("poses agree"), std::string::npos);
    }
}

TEST_F(Cli, ScenesAreListed) {
    const Result result = cairn("scenes");
    EXPECT_EQ(result.code, 0);
    EXPECT_GE(std::count(result.out.begin(), result.out.end(), '\n'), 12);
    const nlohmann::json json = nlohmann::json::parse(cairn("scenes --json").out);
    ASSERT_GE(json.size(), 12u);
    EXPECT_EQ(json[0]["name"], "01_open_plane");
    for (const auto& entry : json) {
        EXPECT_FALSE(entry["title"].get<std::string>().empty());
        EXPECT_GT(entry["bodies"].get<int>(), 0);
    }
}

// Output is written to a temporary file, which gets its final name only when it is complete.
TEST_F(Cli, KilledInMidWriteTheOldFileIsWhole) {
    std::ofstream(folder_ / "out.csv") << "old\n";
    const Result result =
        cairn("run t_handles --seconds 100000 --csv out.csv", "timeout --signal=KILL --foreground 0.5");
    EXPECT_EQ(result.code, 137);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(read_all(folder_ / "out.csv"), "old\n");
}

// A limit on the size of files acts like a full disk: it is reached while writing.
TEST_F(Cli, NoRoomForAFileIsAnErrorAndTheOldOneIsKept) {
    const std::string limit = "trap '' XFSZ; ulimit -f 8;"; // 4 KiB
    for (const char* option : {"--csv out.csv", "--save out.gltf", "--animate out.glb", "--png out.png"}) {
        const std::string name = std::string(option).substr(std::string(option).find(' ') + 1);
        std::ofstream(folder_ / name) << "old\n";
        const Result result = cairn(std::string("run pyramid --frames 60 ") + option, limit);
        expect_one_line(result, 1, name + ": cannot be written");
        EXPECT_EQ(read_all(folder_ / name), "old\n") << name;
    }
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(folder_)) files += entry.path().filename().string()[0] != '.';
    EXPECT_EQ(files, 4u) << "something was left behind";
}

TEST_F(Cli, NoDisplayIsOneLine) {
    expect_one_line(cairn("view welcome", "env -u DISPLAY -u WAYLAND_DISPLAY"), 1, "display");
}

TEST_F(Cli, ValidatePrintsATable) {
    const Result result = cairn("validate --case free_fall --case 17 --case impulses");
    EXPECT_EQ(result.code, 0) << result.out;
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(result.out.substr(0, 11), "1 free_fall");
    EXPECT_NE(result.out.find("\n17 impulses"), std::string::npos);
    EXPECT_EQ(result.out.find("3 oscillator"), std::string::npos);
    std::size_t rows = 0;
    for (std::size_t at = 0; (at = result.out.find(" pass\n", at)) != std::string::npos; ++at) ++rows;
    --rows; // the summary line
    const std::string last = std::to_string(rows) + " of " + std::to_string(rows) + " rows pass\n";
    ASSERT_GT(result.out.size(), last.size());
    EXPECT_EQ(result.out.substr(result.out.size() - last.size()), last);
}

TEST_F(Cli, ValidateKnowsItsCases) {
    const Result result = cairn("validate --case pendulums");
    expect_one_line(result, 2, "--case: must be the name or number of a case (1 free_fall, 2 projectile, ");
    EXPECT_NE(result.err.find("4 pendulum"), std::string::npos);
    EXPECT_NE(result.err.find("got pendulums"), std::string::npos);
    expect_one_line(cairn("validate --case 17 --case 99"), 2, "got 99");
    expect_one_line(cairn("validate 17"), 2, "17");
}

TEST_F(Cli, ValidateAsJson) {
    const Result result = cairn("validate --case tumbling_box --json");
    const nlohmann::json json = nlohmann::json::parse(result.out);
    ASSERT_GT(json["rows"].size(), 10u);
    std::size_t passed = 0;
    for (const nlohmann::json& row : json["rows"]) {
        EXPECT_EQ(row["number"], 6);
        EXPECT_EQ(row["case"], "tumbling_box");
        EXPECT_FALSE(row["quantity"].get<std::string>().empty());
        for (const char* key : {"dt", "bar"}) EXPECT_GT(row[key].get<double>(), 0) << key;
        for (const char* key : {"expected", "measured"}) EXPECT_TRUE(row[key].is_number()) << key;
        EXPECT_TRUE(row["note"].is_string());
        passed += row["pass"].get<bool>() ? 1 : 0;
    }
    EXPECT_EQ(json["total"], json["rows"].size());
    EXPECT_EQ(json["passed"], passed);
    EXPECT_EQ(result.code, passed == json["rows"].size() ? 0 : 1);
    EXPECT_TRUE(json["published"].is_array());
    EXPECT_EQ(cairn("validate --case 6 --json").out, result.out); // the output is reproducible to the last digit
}

TEST_F(Cli, ValidateWritesAReport) {
    const Result result = cairn("validate --case 1 --case 17 --report new/report");
    EXPECT_EQ(result.code, 0) << result.err;
    const std::string page = read_all(folder_ / "new/report/index.html");
    EXPECT_EQ(page.substr(0, 15), "<!DOCTYPE html>");
    EXPECT_EQ(page.substr(page.size() - 8), "</html>\n");
    for (const char* outside : {"src=", "url(", "@import", "<script", "<link"})
        EXPECT_EQ(page.find(outside), std::string::npos) << outside;
    EXPECT_NE(page.find("<section id=\"impulses\">"), std::string::npos);
    EXPECT_NE(page.find("(slope 1.00)"), std::string::npos); // slope of the error of Euler's method in free fall
    EXPECT_EQ(page.find("nan"), std::string::npos);
    const std::string plot = read_all(folder_ / "new/report/free_fall_1.svg");
    EXPECT_EQ(plot.substr(0, 4), "<svg");
    EXPECT_EQ(plot.substr(plot.size() - 7), "</svg>\n");
    EXPECT_NE(page.find(plot.substr(0, plot.size() - 1)), std::string::npos); // the page contains the plot
    const std::string table = read_all(folder_ / "new/report/table.md");
    EXPECT_NE(table.find("\n## 17 impulses\n"), std::string::npos);
    for (const fs::directory_entry& file : fs::directory_iterator(folder_ / "new/report"))
        EXPECT_NE(file.path().filename().string().front(), '.') << file.path(); // no temporary file is left
}

TEST_F(Cli, ValidateRefusesAFolderThatCannotBe) {
    std::ofstream(folder_ / "file") << "text";
    expect_one_line(cairn("validate --case 17 --report file"), 1, "file: cannot take a report");
    expect_one_line(cairn("validate --case 17 --report file/report"), 1, "file/report: cannot take a report");
    EXPECT_EQ(read_all(folder_ / "file"), "text");
}

TEST_F(Cli, FullDiskIsAnError) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this system";
    const std::string line =
        std::string("CAIRN_SCENES='" CAIRN_TEST_SCENES "' '" CAIRN_TEST_BINARY "' scenes >/dev/full 2>'") +
        (folder_ / ".err").string() + "'";
    const int status = std::system(line.c_str());
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_EQ(read_all(folder_ / ".err"), "cairn: stdout: cannot be written: No space left on device\n");
}

} // namespace
