// The sample files of the Khronos drafts, which are not part of the project: the environment variable CAIRN_KHR_SAMPLES
// names their folder.
#pragma once

#include "scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

inline constexpr float dt = 1.0f / 60.0f;

class KhrSampleTest : public testing::Test {
  protected:
    void SetUp() override {
        const char* chosen = std::getenv("CAIRN_KHR_SAMPLES");
        if (chosen == nullptr || !std::filesystem::is_directory(chosen)) {
            GTEST_SKIP() << "set CAIRN_KHR_SAMPLES to a folder with the drafts' samples";
        }
        for (const auto& entry : std::filesystem::recursive_directory_iterator(chosen)) {
            if (entry.path().extension() == ".gltf") files_.push_back(entry.path());
        }
        std::sort(files_.begin(), files_.end());
        ASSERT_FALSE(files_.empty());
    }

    cairn::scene::Scene load(const std::string& name) const {
        for (const std::filesystem::path& file : files_) {
            if (file.stem() == name) return cairn::scene::load(file);
        }
        throw cairn::Error(cairn::ErrorCode::io, name, {}, "there is no such sample");
    }

    std::vector<std::filesystem::path> files_;
};
