// Recordings for tests.
#pragma once

#include "random_changes.h"
#include "recording/recorder.h"
#include "recording/recording.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace cairn::test {

// A file that is removed at the end of the test.
class TemporaryFile {
  public:
    explicit TemporaryFile(const std::string& extension) {
        const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
        // The name is random, so that two runs of the tests at a time use different files.
        const std::string run = std::to_string(std::random_device()());
        std::string name = std::string("cairn_") + test->test_suite_name() + "_" + test->name() + "_" + run + extension;
        for (char& c : name) c = c == '/' ? '_' : c;
        path_ = std::filesystem::path(testing::TempDir()) / name;
        std::filesystem::remove(path_);
    }
    ~TemporaryFile() { std::filesystem::remove(path_); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    const std::filesystem::path& path() const { return path_; }
    std::string bytes() const {
        std::ifstream stream(path_, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

  private:
    std::filesystem::path path_;
};

struct RecordedRun {
    std::vector<std::uint64_t> hashes; // before the first step, and after each step
    std::string bytes;                 // contents of the file
};

// Records random changes.
inline RecordedRun record_changes(std::uint32_t seed, int changes, recording::RecorderOptions options = {}) {
    const TemporaryFile file(".mcap");
    RecordedRun run;
    options.source = "random changes";
    recording::Recorder recorder(file.path(), options);
    World world;
    world.set_command_listener(recorder.listener());
    RandomChanges random(seed);
    random.populate(world);
    run.hashes.push_back(world.state_hash());
    for (int i = 0; i < changes; ++i) {
        const std::uint64_t before = recorder.steps();
        random.change(world);
        if (recorder.steps() > before) run.hashes.push_back(world.state_hash());
    }
    world.step(1.0f / 60.0f); // so that no change follows the last step
    run.hashes.push_back(world.state_hash());
    recorder.close();
    run.bytes = file.bytes();
    return run;
}

} // namespace cairn::test
