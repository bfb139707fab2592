#include "viewer/headless.h"

#include <cairn/error.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;
namespace fs = std::filesystem;

fs::path new_path(const char* name) {
    return fs::temp_directory_path() /
           (std::to_string(std::chrono::steady_clock::now().time_since_epoch().count()) + name);
}

bool has_ffmpeg() { return std::system("ffmpeg -version >/dev/null 2>&1") == 0; }

TEST(VideoWriter, WritesAVideoThatTakesItsNameWhenClosed) {
    if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
    const fs::path path = new_path(".mp4");
    VideoWriter writer(path, 64, 48, 30.0);
    std::vector<std::uint8_t> picture(64 * 48 * 3);
    for (int i = 0; i < 10; ++i) {
        for (std::size_t k = 0; k < picture.size(); ++k) picture[k] = std::uint8_t(k + 20u * std::size_t(i));
        writer.add(picture);
    }
    EXPECT_FALSE(fs::exists(path));
    writer.close();
    writer.close(); // the second close has no effect
    ASSERT_TRUE(fs::exists(path));
    EXPECT_GT(fs::file_size(path), 500u);
    EXPECT_THROW(writer.add(picture), Error);
    fs::remove(path);
}

TEST(VideoWriter, RefusesOddSizesAndPicturesOfAnotherSize) {
    EXPECT_THROW(VideoWriter(new_path(".mp4"), 65, 48), Error);
    EXPECT_THROW(VideoWriter(new_path(".mp4"), 64, 48, 0.0), Error);
    if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
    const fs::path path = new_path(".mp4");
    {
        VideoWriter writer(path, 64, 48);
        EXPECT_THROW(writer.add(std::vector<std::uint8_t>(10)), Error);
    }
    fs::remove(path);
}

TEST(VideoWriter, MissingFfmpegIsAClearError) {
    const char* before = std::getenv("PATH");
    const std::string path = before ? before : "";
    setenv("PATH", "/nonexistent", 1);
    try {
        VideoWriter writer(new_path(".mp4"), 64, 48);
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::unsupported);
        EXPECT_NE(std::string(error.what()).find("ffmpeg"), std::string::npos);
    }
    setenv("PATH", path.c_str(), 1);
}

TEST(VideoWriter, FfmpegFailingIsAnError) {
    if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
    const fs::path path = new_path(".mp4"), programs = new_path("");
    fs::create_directory(programs);
    std::ofstream(programs / "ffmpeg") << "#!/bin/sh\nexit 1\n";
    fs::permissions(programs / "ffmpeg", fs::perms::owner_all);
    const std::string before = std::getenv("PATH");
    setenv("PATH", (programs.string() + ":" + before).c_str(), 1);
    VideoWriter writer(path, 64, 48);
    setenv("PATH", before.c_str(), 1);
    fs::remove_all(programs);
    const std::vector<std::uint8_t> picture(64 * 48 * 3);
    const auto write_all = [&] {
        for (int i = 0; i < 200; ++i) writer.add(picture);
        writer.close();
    };
    EXPECT_THROW(write_all(), Error);
    EXPECT_FALSE(fs::exists(path));
}

TEST(VideoWriter, TheExtensionDecidesTheFormat) {
    if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
    EXPECT_THROW(VideoWriter(new_path(".avi"), 64, 48), Error);
    const std::vector<std::pair<const char*, std::string>> starts{
        {".webm", "\x1A\x45\xDF\xA3"}, {".MKV", "\x1A\x45\xDF\xA3"}, {".gif", "GIF89a"}};
    for (const auto& [extension, start] : starts) {
        const fs::path path = new_path(extension);
        const int width = start == "GIF89a" ? 65 : 64;
        VideoWriter writer(path, width, 48);
        const std::vector<std::uint8_t> picture(static_cast<std::size_t>(width) * 48 * 3);
        for (int i = 0; i < 10; ++i) writer.add(picture);
        writer.close();
        std::ifstream file(path, std::ios::binary);
        std::string found(start.size(), ' ');
        file.read(found.data(), std::streamsize(found.size()));
        EXPECT_EQ(found, start) << extension;
        fs::remove(path);
    }
}

} // namespace
