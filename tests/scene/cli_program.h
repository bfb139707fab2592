// The program as users run it: started by a shell in a temporary folder of its own.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/wait.h>

namespace cairn::test {

namespace fs = std::filesystem;

struct Result {
    int code = -1;
    std::string out, err;
};

inline std::string read_all(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

class Cli : public testing::Test {
  protected:
    void SetUp() override {
        const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) / (std::string("cairn_cli_") + test->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    // Runs `cairn ARGUMENTS` in a shell, in the test's own folder.
    Result cairn(const std::string& arguments, const std::string& before = "") const {
        return shell(before + " '" + CAIRN_TEST_BINARY "' " + arguments);
    }

    // Runs a shell command in that folder, where "$CAIRN" is the program.
    Result shell(const std::string& text) const {
        const fs::path out = folder_ / ".out", err = folder_ / ".err";
        std::ofstream(folder_ / ".script")
            << "export CAIRN_SCENES='" CAIRN_TEST_SCENES "' CAIRN='" CAIRN_TEST_BINARY "'\n"
            << text << "\n";
        const std::string line =
            "cd '" + folder_.string() + "' && bash .script >'" + out.string() + "' 2>'" + err.string() + "'";
        const int status = std::system(line.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_all(out), read_all(err)};
    }

    static void expect_one_line(const Result& result, int code, const std::string& part) {
        EXPECT_EQ(result.code, code) << result.out << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        EXPECT_EQ(result.err.substr(0, 7), "cairn: ");
        EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
    }

    fs::path folder_;
};

} // namespace cairn::test
