// When memory is limited, the program ends with one line that says what it was doing.
#include "cli_program.h"

#include "../sanitized.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace {

using namespace cairn::test;

class CliMemory : public Cli {
  protected:
    // Counts how often the program ran out of memory under limits (KiB) from low to high. It may also succeed, or fail
    // to load its shared libraries; any other end is a failure of the test.
    int times_out_of_memory(const std::string& arguments, const std::string& doing, int low, int high, int step) const {
        int times = 0;
        for (int limit = low; limit <= high; limit += step) {
            const Result result = cairn(arguments, "ulimit -c 0 -v " + std::to_string(limit) + "; exec");
            if (result.code == 0 || result.err.find("shared librar") != std::string::npos) continue;
            EXPECT_EQ(result.code, 1) << limit << ": " << result.err;
            EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << limit << ": " << result.err;
            EXPECT_EQ(result.err.find("cairn: out of memory while "), 0u) << limit << ": " << result.err;
            if (result.err.find(doing) != std::string::npos) ++times;
        }
        return times;
    }
};

TEST_F(CliMemory, RunningOutOfItIsOneLineThatSaysWhatWasDone) {
    if (cairn_test::is_sanitized) GTEST_SKIP() << "sanitizers take all addresses there are";
    std::ofstream file(folder_ / "many.gltf");
    file << R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0)";
    constexpr int count = 10000;
    for (int i = 1; i < count; ++i) file << ',' << i;
    file << R"(]}],"nodes":[)";
    for (int i = 0; i < count; ++i) {
        file << (i == 0 ? "" : ",") << R"({"name":"n)" << i << R"(","translation":[)" << i % 100 * 1.1 << ",1,"
             << i / 100 * 1.1
             << R"(],"extensions":{"KHR_physics_rigid_bodies":{"motion":{},"collider":{"geometry":{"shape":0}}}}})";
    }
    file << R"(],"extensions":{"KHR_implicit_shapes":{"shapes":[{"type":"sphere"}]}}})";
    file.close();
    EXPECT_GT(
        times_out_of_memory("run many.gltf --frames 2 --threads 1", "while reading many.gltf", 30000, 100000, 5000), 3);
    EXPECT_GT(times_out_of_memory("convert many.gltf out.gltf", "while writing out.gltf", 50000, 140000, 15000), 0);
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
        files += entry.path().filename().string().find(".part") != std::string::npos;
    EXPECT_EQ(files, 0u) << "something was left behind";
}

TEST_F(CliMemory, LongRunsTakeNoMoreThanShortOnes) {
    if (cairn_test::is_sanitized) GTEST_SKIP() << "sanitizers take all addresses there are";
    std::ofstream(folder_ / "empty.gltf")
        << R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[],"extensions":{"CAIRN_world":{}}}]})";
    const auto runs = [&](int limit, int steps) {
        return cairn("run empty.gltf --threads 1 --frames " + std::to_string(steps),
                     "ulimit -v " + std::to_string(limit) + "; exec")
                   .code == 0;
    };
    int limit = 20000; // KiB
    while (limit < 1000000 && !runs(limit, 10)) limit += 5000;
    EXPECT_TRUE(runs(limit + 25000, 6000000)); // 8 bytes for each step would be 47 MiB
}

} // namespace
