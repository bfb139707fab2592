// `cairn sweep` and `cairn fit` as users run them.
#include "cli_sweep.h"

#include <nlohmann/json.hpp>

#include <unistd.h>

namespace cairn::test {
namespace {

TEST_F(CliSweep, WritesTablesAReportAndASummary) {
    write_plan(60);
    const Result result = cairn("sweep plan.json");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("60 rows"), std::string::npos) << result.out;
    const std::string csv = bytes("plan.results/rows.csv");
    EXPECT_EQ(csv.substr(0, csv.find('\n')), "index,mu,g,z,energy,rest,time,outcome");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 61);
    const std::string npy = bytes("plan.results/rows.npy");
    EXPECT_EQ(npy.substr(1, 5), "NUMPY");
    EXPECT_NE(npy.find("'shape': (60,)"), std::string::npos);
    EXPECT_EQ(npy.size() % 64, 60u * 8u * 8u % 64u);
    const std::string html = bytes("plan.results/report.html");
    EXPECT_NE(html.find("<svg"), std::string::npos);
    EXPECT_EQ(html.find("http", html.find("<body>")), html.find("http://www.w3.org/2000/svg")) << "needs other files";
    EXPECT_EQ(html.substr(html.size() - 8), "</html>\n");
    const nlohmann::json json = nlohmann::json::parse(bytes("plan.results/summary.json"));
    EXPECT_EQ(json["rows"], 60);
    EXPECT_EQ(json["columns"].size(), 5u);
}

TEST_F(CliSweep, ThreadsAndShardsGiveTheSameBytes) {
    write_plan(90);
    ASSERT_EQ(cairn("sweep plan.json --out one --threads 1").code, 0);
    ASSERT_EQ(cairn("sweep plan.json --out three --threads 3").code, 0);
    for (const char* shard : {"2/3", "3/3", "1/3"}) {
        const Result result = cairn(std::string("sweep plan.json --out parts --shard ") + shard);
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_EQ(fs::exists(folder_ / "parts" / "rows.csv"), std::string(shard) == "1/3") << "of a part alone";
    }
    for (const char* file : {"rows.csv", "rows.npy", "summary.json", "report.html"}) {
        EXPECT_EQ(bytes(std::string("one/") + file), bytes(std::string("three/") + file)) << file;
        EXPECT_EQ(bytes(std::string("one/") + file), bytes(std::string("parts/") + file)) << file;
    }
    expect_one_line(cairn("sweep plan.json --out one"), 1, "one: has rows of this sweep: continue with --resume");
    expect_one_line(cairn("sweep plan.json --shard 4/3"), 2, "must be I/N");
}

TEST_F(CliSweep, WhatWasKilledGoesOnToTheSameBytes) {
    write_plan(1500, 1.0);
    const Result killed =
        shell("\"$CAIRN\" sweep plan.json --out killed >/dev/null 2>&1 & pid=$!\n"
              "for i in $(seq 200); do sleep 0.05; [ -n \"$(find killed -size +8k)\" ] && break; done\n"
              "kill -9 $pid; wait $pid; echo $?");
    EXPECT_EQ(killed.out, "137\n") << "it was done before it could be killed";
    EXPECT_FALSE(fs::exists(folder_ / "killed" / "rows.csv"));
    EXPECT_EQ(cairn("sweep plan.json --out killed --resume").code, 0);
    EXPECT_EQ(cairn("sweep plan.json --out whole").code, 0);
    EXPECT_EQ(bytes("killed/rows.csv"), bytes("whole/rows.csv"));
    EXPECT_EQ(bytes("killed/summary.json"), bytes("whole/summary.json"));
}

TEST_F(CliSweep, AnInterruptKeepsWhatIsThere) {
    write_plan(100000, 2.0);
    const Result result = shell("\"$CAIRN\" sweep plan.json --out out & pid=$!\n"
                                "for i in $(seq 200); do sleep 0.05; [ -n \"$(find out -size +8k)\" ] && break; done\n"
                                "kill -INT $pid; wait $pid");
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find("interrupted: "), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("of 100000 rows are in out; continue with --resume"), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(folder_ / "out" / "rows.csv"));
}

TEST_F(CliSweep, APlanReadsNothingOutsideOfItsFolder) {
    const fs::path inside = folder_ / "inside";
    fs::create_directories(inside / "sub");
    fs::copy_file(fs::path(CAIRN_TEST_SCENES) / "12_t_handles.gltf", folder_ / "scene.gltf");
    fs::copy_file(folder_ / "scene.gltf", inside / "sub" / "scene.gltf");
    std::ofstream(folder_ / "rows.csv") << "a\n1\n";
    fs::create_symlink("../scene.gltf", inside / "link.gltf");
    fs::create_symlink("../rows.csv", inside / "link.csv");
    fs::create_symlink("sub/scene.gltf", inside / "inner_link.gltf");
    const auto check = [&](const std::string& scene, const std::string& table) {
        std::ofstream(inside / "plan.json")
            << "{\"scene\": \"" << scene << "\", \"measure\": [], \"seconds\": 0.01"
            << (table.empty() ? "" : ", \"sample\": {\"table\": \"" + table + "\"}") << "}";
        return cairn("sweep inside/plan.json --check");
    };
    for (const char* scene : {"../scene.gltf", "sub/../../scene.gltf", "link.gltf"}) {
        expect_one_line(check(scene, ""), 1, "scene: must not lead out of the plan's folder");
    }
    expect_one_line(check((folder_ / "scene.gltf").string(), ""), 1, "scene: must not lead out of the plan's folder");
    // The file is in the current directory instead.
    expect_one_line(check("scene.gltf", ""), 1, "there is no such file");
    for (const char* table : {"../rows.csv", "link.csv", "/etc/passwd"}) {
        expect_one_line(check("t_handles", table), 1, "sample.table: must not lead out of the plan's folder");
    }
    for (const char* scene : {"sub/scene.gltf", "inner_link.gltf", "t_handles"}) {
        const Result result = check(scene, "");
        EXPECT_EQ(result.code, 0) << result.err;
    }
}

TEST_F(CliSweep, ARowOfItsOwnIsThatOfTheTable) {
    write_plan(20);
    ASSERT_EQ(cairn("sweep plan.json").code, 0);
    const std::string csv = bytes("plan.results/rows.csv");
    std::string line = csv.substr(csv.find("\n7,") + 1);
    line = line.substr(0, line.find('\n'));
    const Result result = cairn("sweep plan.json --row 7");
    EXPECT_EQ(result.code, 0) << result.err;
    std::string joined;
    for (std::size_t at = result.out.find(" = "); at != std::string::npos; at = result.out.find(" = ", at + 1)) {
        if (!joined.empty()) joined += ',';
        joined += result.out.substr(at + 3, result.out.find('\n', at) - at - 3);
    }
    EXPECT_EQ(joined, line);
    expect_one_line(cairn("sweep plan.json --row 20"), 1, "--row: must be below 20");
    const Result checked = cairn("sweep plan.json --check --out elsewhere");
    EXPECT_NE(checked.out.find("20 rows of index, mu, g, z"), std::string::npos) << checked.out;
    EXPECT_FALSE(fs::exists(folder_ / "elsewhere"));
}

TEST_F(CliSweep, RowsThatFailAreToldAndTheOthersRun) {
    std::ofstream(folder_ / "plan.json") << R"({"scene": "slopes", "seconds": 0.1,
        "parameters": [{"name": "m", "values": [1, -1, 2, 0]}], "set": {"bodies[2].mass": "m"},
        "measure": [{"name": "z", "of": "bodies[2].position.z"}]})";
    const Result result = cairn("sweep plan.json");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("2 ran to the end, 0 stopped before, 2 failed"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("row 1: plan.json: set.bodies[2].mass: "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("row 3: "), std::string::npos) << result.out;
    expect_one_line(cairn("sweep missing.json"), 1, "missing.json: there is no such file");
}

TEST_F(CliSweep, ADiskWithoutRoomEndsItWithALine) {
    write_plan(4000, 0.1);
    const Result full = shell("ulimit -f 16; exec \"$CAIRN\" sweep plan.json --out out");
    expect_one_line(full, 1, "out/shards/0.rows: cannot be written: File too large");
    EXPECT_FALSE(fs::exists(folder_ / "out" / "rows.csv"));
    const Result resumed = cairn("sweep plan.json --out out --resume");
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    ASSERT_EQ(cairn("sweep plan.json --out whole").code, 0);
    EXPECT_EQ(bytes("out/rows.csv"), bytes("whole/rows.csv"));
}

TEST_F(CliSweep, AFolderThatCannotBeWrittenIsToldBeforeAnythingRuns) {
    write_plan(10);
    std::ofstream(folder_ / "file") << "";
    expect_one_line(cairn("sweep plan.json --out file/results"), 1, "file/results/shards: cannot be made");
    if (geteuid() == 0) return; // root may write everywhere
    fs::create_directories(folder_ / "locked");
    fs::permissions(folder_ / "locked", fs::perms::owner_read | fs::perms::owner_exec);
    expect_one_line(cairn("sweep plan.json --out locked/results"), 1, "locked/results/shards: cannot be made");
}

TEST_F(CliSweep, FitPrintsWhatItFound) {
    std::ofstream(folder_ / "plan.json") << R"({"scene": "slopes", "seconds": 1,
        "parameters": [{"name": "mu", "from": 0, "to": 0.4}, {"name": "g"}],
        "set": {"bodies[2].friction": "mu", "slope.friction": "mu", "world.gravity.y": "-g"},
        "measure": [{"name": "z", "of": "bodies[2].position.z", "at": [0.5, 1]}]})";
    std::ofstream(folder_ / "truth.csv") << "mu,g\n0.15,9\n0.15,12\n";
    std::ofstream(folder_ / "make.json") << R"({"scene": "slopes", "seconds": 1, "sample": {"table": "truth.csv"},
        "set": {"bodies[2].friction": "mu", "slope.friction": "mu", "world.gravity.y": "-g"},
        "measure": [{"name": "z", "of": "bodies[2].position.z", "at": [0.5, 1]}]})";
    ASSERT_EQ(cairn("sweep make.json").code, 0);
    ASSERT_EQ(shell("cut -d, -f3,4,5 make.results/rows.csv >data.csv").code, 0);
    const Result result = cairn("fit plan.json data.csv --json");
    ASSERT_EQ(result.code, 0) << result.err;
    const nlohmann::json json = nlohmann::json::parse(result.out);
    EXPECT_NEAR(json["parameters"][0]["value"].get<double>(), 0.15, 1e-4);
    EXPECT_LT(json["residual"].get<double>(), 1e-4);
    const Result text = cairn("fit plan.json data.csv");
    EXPECT_EQ(text.out.substr(0, 8), "mu = 0.1") << text.out;
    expect_one_line(cairn("fit plan.json nothing.csv"), 1, "nothing.csv: there is no such file");
}

} // namespace
} // namespace cairn::test
