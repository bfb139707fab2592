// The program itself, run as a user would.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <string>

#include <sys/wait.h>

namespace {

struct Outcome {
    int exit_code = -1;
    std::string output;
};

Outcome run_bench(const std::string& arguments) {
    Outcome outcome;
    std::FILE* pipe = popen((std::string(CAIRN_TEST_BENCH) + " " + arguments).c_str(), "r");
    if (!pipe) return outcome;
    char buffer[4096];
    for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) outcome.output.append(buffer, n);
    const int status = pclose(pipe);
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
}

TEST(BenchProgram, reports_every_engine_on_every_scene) {
    const Outcome outcome = run_bench("--scenes tower,pile_mixed --n 30 --steps 40 --rounds 2 --json 2>/dev/null");
    ASSERT_EQ(outcome.exit_code, 0);
    const auto results = nlohmann::json::parse(outcome.output).at("results");
    bool has_cairn_tower = false;
    for (const auto& result : results) {
        EXPECT_EQ(result.at("bodies"), 30);
        EXPECT_EQ(result.at("rounds"), 2);
        EXPECT_GT(result.at("mean_ms"), 0);
        EXPECT_LE(result.at("median_ms"), result.at("p99_ms"));
        EXPECT_GT(result.at("points"), 0);
        EXPECT_EQ(result.at("lost"), 0);
        EXPECT_EQ(result.at("drift").is_null(), result.at("scene") == "pile_mixed");
        if (result.at("engine") != "cairn" || result.at("scene") != "tower") continue;
        has_cairn_tower = true;
        EXPECT_TRUE(result.at("repeatable"));
        EXPECT_LT(result.at("drift"), 0.01);
        EXPECT_LT(result.at("penetration_max"), 0.02);
        EXPECT_GT(result.at("stages_ms").at("solve"), 0);
    }
    EXPECT_TRUE(has_cairn_tower);
}

TEST(BenchProgram, refuses_what_it_does_not_know) {
    EXPECT_EQ(run_bench("--scenes nowhere 2>/dev/null").exit_code, 2);
    EXPECT_EQ(run_bench("--engines nobody 2>/dev/null").exit_code, 2);
    EXPECT_EQ(run_bench("--rounds 0 2>/dev/null").exit_code, 2);
    EXPECT_EQ(run_bench("--scenes tumbler --n 5000 2>/dev/null").exit_code, 2);
}

TEST(BenchProgram, lists_scenes_and_engines) {
    const Outcome outcome = run_bench("--list");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.output.find("many_pyramids"), std::string::npos);
    EXPECT_NE(outcome.output.find("cairn"), std::string::npos);
}

} // namespace
