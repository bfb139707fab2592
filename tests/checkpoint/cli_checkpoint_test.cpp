// A run that is resumed from a checkpoint ends as if it had never been interrupted.
#include "cli_run.h"

#include <random>

namespace cairn::test {
namespace {

TEST_F(CliRun, ThatIsResumedEndsAsOneThatWasNeverInterrupted) {
    const std::string scene = "13_pile --every 4 --columns position,contacts ";
    const auto whole = summary(scene + "--frames 90 --csv whole.csv");
    for (const std::string type : {"csv", "npy"}) {
        const std::string table = " --csv out." + type, folder = "ck_" + type;
        summary(scene + "--frames 57 --threads 1 --checkpoint " + folder + " --checkpoint-every 25" + table);
        const auto resumed =
            summary(scene + "--frames 90 --threads 3 --checkpoint " + folder + " --resume " + folder + table);
        expect_same_end(resumed, whole);
        EXPECT_EQ(resumed["resumed_from"]["step"], 57) << "the last step has a checkpoint, too";
        EXPECT_EQ(resumed["resumed_from"]["checkpoint"], folder + "/step_57");
        EXPECT_EQ(resumed["checkpoints"]["last_step"], 90);
    }
    EXPECT_EQ(bytes("out.csv"), bytes("whole.csv"));
    ASSERT_EQ(cairn("run " + scene + "--frames 90 --csv whole.npy").code, 0);
    EXPECT_EQ(bytes("out.npy"), bytes("whole.npy"));
    const Result text = cairn("run 13_pile --frames 90 --resume ck_csv");
    EXPECT_NE(text.out.find("90 steps of 0.0166667 s, the last 0 of them from ck_csv/step_90"), std::string::npos)
        << text.out;
}

TEST_F(CliRun, ScenesWithJointsGoOnAsTheyWere) {
    for (const std::string scene : {"25_ragdolls", "31_chain_reaction", "28_cars", "33_bullets"}) {
        const auto whole = summary(scene + " --frames 200");
        summary(scene + " --frames 77 --checkpoint ck_" + scene);
        expect_same_end(summary(scene + " --frames 200 --resume ck_" + scene), whole);
    }
}

// Breaking joints change the definitions: the scene alone does not say which joints exist.
TEST_F(CliRun, JointsThatHaveBrokenStayBroken) {
    std::string text = read_all(fs::path(CAIRN_TEST_SCENES) / "25_ragdolls.gltf");
    const std::string mark = "\"CAIRN_joint\":{";
    ASSERT_NE(text.find(mark), std::string::npos);
    for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos; at += mark.size())
        text.insert(at + mark.size(), "\"break_force\":3000,");
    put("weak.gltf", text);
    const auto whole = summary("weak.gltf --frames 200 --columns joints --csv whole.csv");
    summary("weak.gltf --frames 120 --columns joints --csv out.csv --checkpoint ck");
    const std::string broken = bytes("out.csv"); // NaN in the last row, and none in the first
    EXPECT_NE(broken.find("nan", broken.rfind('\n', broken.size() - 2)), std::string::npos);
    EXPECT_EQ(broken.substr(0, broken.find('\n', broken.find('\n') + 1)).find("nan,"), std::string::npos);
    EXPECT_GT(nlohmann::json::parse(bytes("ck/step_120/index.json"))["checkpoint"]["sections"][1], 0);
    expect_same_end(summary("weak.gltf --frames 200 --columns joints --csv out.csv --resume ck"), whole);
    EXPECT_EQ(bytes("out.csv"), bytes("whole.csv"));
}

// The motors have new targets in each step, and approach them at limited speed.
TEST_F(CliRun, JointsThatFollowATableGoOnWhereTheyWere) {
    put("poses.csv", "time,turn,lift,elbow\n0,0,0,0\n0.3,3,-1,1\n1,-3,1,2\n2,2,-2,0.5\n");
    const std::string arm = "'" CAIRN_TEST_DATA "/arm.urdf' --fixed-base --targets poses.csv --columns joints --csv ";
    const auto whole = summary(arm + "whole.csv --frames 120");
    summary(arm + "out.csv --frames 31 --checkpoint ck");
    expect_same_end(summary(arm + "out.csv --frames 120 --checkpoint ck --resume ck"), whole);
    EXPECT_EQ(bytes("out.csv"), bytes("whole.csv"));
}

TEST_F(CliRun, KilledAtAnyMomentItLosesWhatCameAfterTheLastCheckpointOnly) {
    const std::string scene = "25_ragdolls --frames 1500 --every 7 --csv ";
    const auto whole = summary(scene + "whole.csv");
    std::mt19937 random(3);
    int kills = 0;
    Result result;
    for (int attempt = 0; attempt < 6; ++attempt) {
        const std::string delay = "0." + std::to_string(100 + random() % 300);
        const std::string run = "run " + scene + "out.csv --json --checkpoint ck --checkpoint-every 10 --resume ck";
        result = shell("mkdir -p ck; \"$CAIRN\" " + run + " & sleep " + delay + "; kill -9 $!; wait $!");
        if (result.code == 0) break;
        EXPECT_EQ(result.code, 137) << result.err;
        if (fs::exists(folder_ / "out.csv")) { // it was killed at its very end
            EXPECT_EQ(bytes("out.csv"), bytes("whole.csv")) << "what is half written has not the name of what is whole";
        }
        ++kills;
    }
    if (result.code != 0) result = cairn("run " + scene + "out.csv --json --checkpoint ck --resume ck");
    expect_same_end(summary_of(result), whole);
    EXPECT_EQ(bytes("out.csv"), bytes("whole.csv"));
    EXPECT_GT(kills, 0);
}

TEST_F(CliRun, ASignalToEndLeavesACheckpointOfThatMoment) {
    const std::string scene = "13_pile --frames 300 --every 5 --csv out.csv --checkpoint ck --json ";
    const Result ended = shell("\"$CAIRN\" run " + scene + "--checkpoint-every 10 & runner=$!\n" +
                               wait_for_a_checkpoint + "kill -TERM $runner; wait $runner");
    const auto first = summary_of(ended);
    ASSERT_EQ(first["interrupted"], true);
    EXPECT_EQ(first["checkpoints"]["last_step"], first["steps"]);
    EXPECT_TRUE(fs::exists(folder_ / "out.csv")) << "the part that there is";
    const auto resumed = summary(scene + "--resume ck");
    EXPECT_EQ(resumed["resumed_from"]["step"], first["steps"]);
    expect_same_end(resumed, summary("13_pile --frames 300 --every 5 --csv whole.csv"));
    EXPECT_EQ(bytes("out.csv"), bytes("whole.csv"));
}

TEST_F(CliRun, ADamagedCheckpointIsPassedOverForAnOlderOneAndTheTableIsCutThere) {
    const std::string scene = "13_pile --csv out.csv --columns energy --checkpoint ck ";
    const auto whole = summary("13_pile --frames 60 --csv whole.csv --columns energy");
    summary(scene + "--frames 50 --checkpoint-every 20");
    std::string part = bytes("ck/step_50/part_0");
    part[part.size() / 2] = char(part[part.size() / 2] ^ 4);
    put("ck/step_50/part_0", part);
    const Result resumed = cairn("run --json " + scene + "--frames 60 --resume ck");
    EXPECT_NE(resumed.err.find("cairn: warning: ck/step_50/part_0: checksum: is damaged: must be "), std::string::npos)
        << resumed.err;
    EXPECT_NE(resumed.err.find("; an older checkpoint is tried\n"), std::string::npos) << resumed.err;
    EXPECT_EQ(summary_of(resumed)["resumed_from"]["step"], 40);
    expect_same_end(summary_of(resumed), whole);
    EXPECT_EQ(bytes("out.csv"), bytes("whole.csv"));
}

TEST_F(CliRun, WhatCannotBeGoneOnWithIsSaidToBeginLater) {
    summary("13_pile --frames 20 --csv out.csv --checkpoint ck");
    const Result resumed = cairn("run 13_pile --frames 24 --csv - --columns energy --animate late.glb --resume ck");
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_EQ(std::count(resumed.out.begin(), resumed.out.end(), '\n'), 6) << "a line, and steps 20 to 24";
    EXPECT_NE(resumed.err.find("cairn: warning: - begins after step 20, from which the run continues"),
              std::string::npos)
        << resumed.err;
    EXPECT_NE(resumed.err.find("cairn: warning: late.glb begins after step 20"), std::string::npos) << resumed.err;
}

TEST_F(CliRun, CheckpointsAreAsManyAsAreKeptAndAsOftenAsTheClockSays) {
    summary("25_ragdolls --frames 60 --checkpoint a --checkpoint-every 10 --keep 3");
    EXPECT_TRUE(fs::exists(folder_ / "a/step_40") && fs::exists(folder_ / "a/step_60"));
    EXPECT_FALSE(fs::exists(folder_ / "a/step_30"));
    const auto often = summary("25_ragdolls --frames 60 --checkpoint b --checkpoint-seconds 0.01");
    EXPECT_GT(often["checkpoints"]["written"], 1);
    EXPECT_EQ(summary("25_ragdolls --frames 60 --checkpoint c")["checkpoints"]["written"], 1) << "of the end";
}

} // namespace
} // namespace cairn::test
