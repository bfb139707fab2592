// Destinations of the program's output: files, links, devices, FIFOs, pipes and standard output.
#include "cli_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace fs = std::filesystem;
using namespace cairn::test;

class CliOutput : public Cli {
  protected:
    // Every option that writes a file, with a file name for it.
    static constexpr std::array<std::array<const char*, 2>, 6> all{{{"--csv", "a.csv"},
                                                                    {"--png", "a.png"},
                                                                    {"--png", "a.jpg"},
                                                                    {"--video", "a.mp4"},
                                                                    {"--save", "a.gltf"},
                                                                    {"--animate", "a.glb"}}};
    std::size_t files() const {
        std::size_t count = 0;
        for (const auto& entry : fs::directory_iterator(folder_)) count += entry.path().filename() != ".script";
        return count - 2; // .out and .err
    }
    static bool has_ffmpeg() { return std::system("ffmpeg -version >/dev/null 2>&1") == 0; }
};

const std::string short_run = "run t_handles --frames 3 --width 64 --height 48 ";

TEST_F(CliOutput, LinksAreFollowedAndStay) {
    for (const auto& [option, name] : all) {
        if (std::string(option) == "--video" && !has_ffmpeg()) continue;
        SCOPED_TRACE(name);
        fs::create_directories(folder_ / "there");
        const std::string target = std::string("there/") + name;
        fs::create_symlink(target, folder_ / name); // to a file that does not exist yet
        for (int i = 0; i < 2; ++i) {
            const Result result = cairn(short_run + option + " " + name);
            EXPECT_EQ(result.code, 0) << result.err;
            EXPECT_TRUE(fs::is_symlink(folder_ / name));
            EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder_ / target)));
        }
        const auto there = fs::directory_iterator(folder_ / "there");
        EXPECT_EQ(std::distance(there, fs::directory_iterator()), 1) << "something was left behind";
        fs::remove_all(folder_ / "there");
    }
    fs::create_symlink("b.csv", folder_ / "c.csv");
    fs::create_symlink("c.csv", folder_ / "b.csv");
    expect_one_line(cairn("run t_handles --frames 1 --csv b.csv"), 1, "b.csv: cannot be written: ");
}

TEST_F(CliOutput, FifosStayFifos) {
    for (const auto& [option, name] : all) {
        if (std::string(option) == "--video" && !has_ffmpeg()) continue;
        const Result result = shell(std::string("mkfifo ") + name + "; cat " + name + " >got & \"$CAIRN\" " +
                                    short_run + option + " " + name + "; code=$?; wait; exit $code");
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_TRUE(fs::is_fifo(folder_ / name)) << name;
        EXPECT_GT(fs::file_size(folder_ / "got"), 100u) << name;
    }
}

TEST_F(CliOutput, NobodyAtAFifoIsWaitedForUntilAnInterrupt) {
    // The interrupt is sent once the program has a handler for it (the second lowest bit of SigCgt) and has slept for a
    // while, which may take long on a busy machine.
    const Result result = shell(R"(set -m; mkfifo a.csv
        timeout --signal=KILL 60 "$CAIRN" run t_handles --csv a.csv & waits=$!
        slept=0
        while [ $slept -lt 10 ] && kill -0 $waits; do
            sleep 0.03
            program=$(cat /proc/$waits/task/$waits/children)
            status=/proc/${program% }/status
            if grep -q '^SigCgt:.*[2367abef]$' $status && grep -q '^State:.S' $status
            then slept=$((slept + 1)); else slept=0; fi
        done 2>/dev/null
        kill -INT $program; wait $waits)");
    EXPECT_EQ(result.code, 1) << result.err; // if it were killed: 137
    EXPECT_EQ(result.err, "cairn: a.csv: cannot be written: Interrupted system call\n");
}

TEST_F(CliOutput, DevicesAreWrittenToAndStay) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this system";
    for (const auto& [option, name] : all) {
        if (std::string(option) == "--video" && !has_ffmpeg()) continue;
        EXPECT_EQ(cairn(short_run + option + " /dev/null").code, 0) << option;
        EXPECT_TRUE(fs::is_character_file("/dev/null"));
        expect_one_line(cairn(short_run + option + " /dev/full"), 1,
                        "/dev/full: cannot be written: No space left on device");
        EXPECT_TRUE(fs::is_character_file("/dev/full"));
    }
}

TEST_F(CliOutput, StandardOutputHasManyNamesAndMessagesGoToTheOther) {
    for (const char* name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
        SCOPED_TRACE(name);
        for (const char* to :
             {"", " | cat", " >file; cat file"}) { // to a file, through a pipe, and to a file that has another name
            const Result result = shell("\"$CAIRN\" run t_handles --frames 4 --csv " + std::string(name) + to);
            EXPECT_EQ(result.code, 0) << result.err;
            EXPECT_EQ(result.out.substr(0, 10), "time,body,");
            EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1 + 3 * 5) << result.out;
            EXPECT_NE(result.err.find("4 steps"), std::string::npos) << result.err;
        }
        EXPECT_TRUE(fs::is_symlink("/dev/stdout"));
    }
    const Result scene = cairn("convert t_handles -");
    EXPECT_EQ(scene.code, 0) << scene.err;
    EXPECT_EQ(nlohmann::json::parse(scene.out)["asset"]["version"], "2.0");
    expect_one_line(cairn("run t_handles --csv - --save /dev/stdout"), 1, "must be another file than that of --csv");
    expect_one_line(cairn("run t_handles --save a.glb --animate ./a.glb"), 1,
                    "must be another file than that of --save");
}

TEST_F(CliOutput, DescriptorsOfTheShellAreWrittenTo) {
    const Result result = shell(
        "\"$CAIRN\" run t_handles --frames 4 --csv /dev/fd/7 --save >(cat >saved) 7>seven; code=$?; wait; exit $code");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(read_all(folder_ / "seven").substr(0, 10), "time,body,");
    for (int i = 0; i < 50 && read_all(folder_ / "saved").size() < 100; ++i) shell("sleep 0.1");
    EXPECT_NE(read_all(folder_ / "saved").find("\"asset\""), std::string::npos);
}

TEST_F(CliOutput, ReadersThatGoAwayEndTheRunQuietly) {
    const Result head =
        shell("set -o pipefail; \"$CAIRN\" run t_handles --seconds 100000 --csv - --save a.gltf | head -3");
    EXPECT_EQ(head.code, 141) << head.err; // as with `yes | head`
    EXPECT_EQ(head.err, "");
    EXPECT_EQ(std::count(head.out.begin(), head.out.end(), '\n'), 3);
    EXPECT_EQ(files(), 0u) << "something was left behind";
    const Result list = shell("set -o pipefail; { \"$CAIRN\" scenes; } | true");
    EXPECT_EQ(list.err, "");
    const Result closed = shell("\"$CAIRN\" scenes >&-");
    EXPECT_EQ(closed.code, 1);
    EXPECT_EQ(closed.err, "cairn: stdout: cannot be written: Bad file descriptor\n");
    EXPECT_EQ(shell("\"$CAIRN\" run no_such_scene 2>&-").code, 1);
    EXPECT_EQ(shell("\"$CAIRN\" --help >/dev/full").code, 1);
}

TEST_F(CliOutput, WhatCannotBeWrittenIsSaidBeforeAnythingRuns) {
    const std::string forever = "run t_handles --seconds 100000 ";
    for (const auto& [option, name] : all) {
        const Result result = cairn(forever + option + " missing/" + name, "timeout 20");
        expect_one_line(result, 1, std::string("missing/") + name + ": cannot be written: there is no folder missing");
        EXPECT_FALSE(fs::exists(folder_ / "missing"));
    }
    fs::create_directories(folder_ / "folder.csv");
    expect_one_line(cairn(forever + "--csv folder.csv", "timeout 20"), 1, "folder.csv: is a folder, not a file");
    std::ofstream(folder_ / "file") << "text";
    expect_one_line(cairn(forever + "--csv file/a.csv", "timeout 20"), 1, "file is no folder");
    EXPECT_EQ(files(), 2u);
}

TEST_F(CliOutput, ReplacedFilesKeepTheirRights) {
    std::ofstream(folder_ / "a.csv") << "old";
    fs::permissions(folder_ / "a.csv", fs::perms::owner_read | fs::perms::owner_write);
    ASSERT_EQ(cairn(short_run + "--csv a.csv").code, 0);
    EXPECT_EQ(fs::status(folder_ / "a.csv").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(CliOutput, UnknownExtensionsAreRefusedWithTheKnownOnes) {
    const std::string forever = "run t_handles --seconds 100000 ";
    expect_one_line(cairn(forever + "--png a.webp"), 2, "--png: must end in .png, .jpg, .jpeg, got a.webp");
    expect_one_line(cairn(forever + "--video a.avi"), 2,
                    "--video: must end in .mp4, .mkv, .mov, .webm, .gif, got a.avi");
    expect_one_line(cairn(forever + "--video a"), 2, "--video: must end in ");
    expect_one_line(cairn(forever + "--save a.json"), 2, "--save: must end in .gltf, .glb, got a.json");
    expect_one_line(cairn(forever + "--animate a.gltf.zip"), 2, "--animate: must end in .glb, .gltf, got a.gltf.zip");
    expect_one_line(cairn(forever + "--csv a.json"), 2, "--csv: must end in .csv, .npy, got a.json");
    expect_one_line(cairn(forever + "--csv ''"), 2, "--csv: must be the name of a file");
    expect_one_line(cairn("view welcome --report a.txt"), 2, "--report: must end in .json, got a.txt");
    expect_one_line(cairn(forever + "--video a.mp4 --width 641"), 1,
                    "--width: must be even for videos other than .gif");
    expect_one_line(cairn(forever + "--video a.webm --height 99"), 1, "--height: must be even");
    EXPECT_EQ(files(), 0u);
}

TEST_F(CliOutput, TheExtensionDecidesTheFormat) {
    ASSERT_EQ(cairn(short_run + "--png a.jpg --save a.GLB --animate b.gltf").code, 0);
    EXPECT_EQ(read_all(folder_ / "a.jpg").substr(0, 3), "\xFF\xD8\xFF");
    EXPECT_EQ(read_all(folder_ / "a.GLB").substr(0, 4), "glTF");
    const nlohmann::json animated = nlohmann::json::parse(read_all(folder_ / "b.gltf"));
    EXPECT_EQ(animated["animations"][0]["name"], "simulation");
    EXPECT_EQ(animated["buffers"][0]["uri"].get<std::string>().substr(0, 5), "data:");
    if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
    ASSERT_EQ(cairn("run t_handles --frames 3 --width 65 --height 49 --video a.gif").code, 0);
    EXPECT_EQ(read_all(folder_ / "a.gif").substr(0, 6), "GIF89a");
}

TEST_F(CliOutput, LongAndStrangeNamesOfFilesAreNames) {
    const std::string longest = std::string(251, 'a') + ".csv"; // 255 bytes
    EXPECT_EQ(cairn(short_run + "--csv " + longest).code, 0);
    EXPECT_TRUE(fs::exists(folder_ / longest));
    const Result result =
        shell("\"$CAIRN\" convert t_handles $'\\xff.gltf' && \"$CAIRN\" run $'\\xff.gltf' --frames 1 --json");
    // The name is not valid UTF-8; without the fix that was an error after the run.
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(nlohmann::json::parse(result.out)["bodies"], 3);
    EXPECT_EQ(cairn("scenes . --json").code, 0);
}

TEST_F(CliOutput, ALimitOfTheSizeOfFilesIsAnErrorNotASignal) {
    const Result result = shell("ulimit -f 8; \"$CAIRN\" run t_handles --seconds 60 --csv a.csv");
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(result.err, "cairn: a.csv: cannot be written: File too large\n");
    EXPECT_EQ(files(), 0u) << "something was left behind";
}

} // namespace
