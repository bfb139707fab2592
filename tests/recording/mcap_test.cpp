// The official reader for MCAP files can read recordings.
#include "recorded.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace cairn::test {
namespace {

TEST(Mcap, IsReadByTheOfficialReader) {
    const std::filesystem::path folder = CAIRN_TEST_MCAP;
    if (std::system("node --version >/dev/null 2>&1") != 0 || !std::filesystem::exists(folder / "node_modules"))
        GTEST_SKIP() << "no node, or no @mcap/core: ./dev test fetches it with npm";
    for (const bool compress : {true, false}) {
        recording::RecorderOptions options;
        options.compress = compress;
        const RecordedRun run = record_changes(1, 900, options);
        const TemporaryFile file(".mcap");
        std::ofstream(file.path(), std::ios::binary) << run.bytes;
        const std::string line = "node '" + (folder / "check.mjs").string() + "' '" + file.path().string() + "' " +
                                 std::to_string(run.hashes.size() - 1);
        EXPECT_EQ(std::system(line.c_str()), 0) << line;
    }
}

} // namespace
} // namespace cairn::test
