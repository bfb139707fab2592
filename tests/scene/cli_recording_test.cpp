// cairn record, replay, info and diff.
#include "cli_program.h"

#include <nlohmann/json.hpp>

namespace cairn::test {
namespace {

class CliRecording : public Cli {
  protected:
    nlohmann::json json(const std::string& arguments) const {
        const Result result = cairn(arguments);
        EXPECT_EQ(result.err, "");
        return nlohmann::json::parse(result.out);
    }
};

TEST_F(CliRecording, OfASceneReplaysToTheSameState) {
    const Result recorded = cairn("record pyramid -o run.mcap --seconds 1.5 --threads 1");
    EXPECT_EQ(recorded.code, 0) << recorded.err;
    EXPECT_EQ(recorded.out.rfind("run.mcap: 90 steps of 0.0166667 s of ", 0), 0u) << recorded.out;
    const std::string hash = recorded.out.substr(recorded.out.rfind(' ') + 1, 16);
    for (const char* threads : {"1", "8"}) {
        const Result replayed = cairn(std::string("replay run.mcap --verify --threads ") + threads);
        EXPECT_EQ(replayed.code, 0) << replayed.err;
        EXPECT_EQ(replayed.out.rfind("run.mcap: 90 of 90 steps the same", 0), 0u) << replayed.out;
        EXPECT_NE(replayed.out.find(hash), std::string::npos) << replayed.out;
    }
    const nlohmann::json straight = json("run pyramid --seconds 1.5 --json");
    EXPECT_EQ(straight["hash"], hash);
    const nlohmann::json info = json("info run.mcap --json");
    EXPECT_EQ(info["steps"], 90);
    EXPECT_EQ(info["source"], "07_pyramid.gltf");
    EXPECT_EQ(info["from_start"], true);
    EXPECT_EQ(info["commands"]["World::step"], 90);
}

TEST_F(CliRecording, IsEnteredAtAnyTimeAndSavedAsAScene) {
    ASSERT_EQ(cairn("record tower -o run.mcap --seconds 3").code, 0);
    const nlohmann::json at = json("replay run.mcap --at 1.5 --save there.gltf --json");
    EXPECT_EQ(at["steps"], 90);
    EXPECT_EQ(at["hash"], json("run tower --seconds 1.5 --json")["hash"]);
    EXPECT_EQ(cairn("run there.gltf --frames 1").code, 0);
    expect_one_line(cairn("replay run.mcap --at 9"), 1, "--at: must be within the 3 s of run.mcap, got 9");
}

TEST_F(CliRecording, AnswersWhatIf) {
    ASSERT_EQ(cairn("record tower -o run.mcap --seconds 2").code, 0);
    const Result result = cairn("replay run.mcap --at 1 --what-if gravity=0,2,0 --what-if friction=0.1");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("recorded: "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("what if:  "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("greatest distance after 120 steps: body "), std::string::npos) << result.out;
    expect_one_line(cairn("replay run.mcap --what-if gravity=1,2"), 1, "must have three numbers");
    expect_one_line(cairn("replay run.mcap --what-if color=red"), 1, "must be gravity=X,Y,Z, substeps=N");
    expect_one_line(cairn("replay run.mcap --what-if restitution=2"), 1, "must be from 0 to 1");
    expect_one_line(cairn("replay run.mcap --verify --what-if substeps=3"), 1, "cannot be verified");
}

TEST_F(CliRecording, OfTwoRunsTellsWhereTheyPart) {
    ASSERT_EQ(cairn("record tower -o a.mcap --frames 60").code, 0);
    ASSERT_EQ(cairn("record tower -o b.mcap --frames 60 --threads 1").code, 0);
    ASSERT_EQ(cairn("record tower -o c.mcap --frames 40").code, 0);
    ASSERT_EQ(cairn("record tower -o d.mcap --frames 60 --dt 0.02").code, 0);
    Result result = cairn("diff a.mcap b.mcap");
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.out, "the same: 60 steps\n");
    result = cairn("diff a.mcap c.mcap");
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(result.out, "the same for 40 steps; a.mcap has 60, c.mcap has 40\n");
    result = cairn("diff a.mcap d.mcap");
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(result.out.rfind("they differ from step 1 on: body ", 0), 0u) << result.out;
}

TEST_F(CliRecording, ThatIsCutOffOrNoneSaysSo) {
    ASSERT_EQ(cairn("record 25_ragdolls -o run.mcap --seconds 8").code, 0);
    ASSERT_EQ(shell("head -c -200 run.mcap > cut.mcap").code, 0);
    const Result cut = cairn("replay cut.mcap --verify");
    EXPECT_EQ(cut.code, 0);
    EXPECT_NE(cut.err.find("warning: cut.mcap was cut off; its first "), std::string::npos) << cut.err;
    expect_one_line(cairn("replay none.mcap"), 1, "none.mcap: cannot be read");
    expect_one_line(shell("echo hello > text.mcap; \"$CAIRN\" info text.mcap"), 1, "text.mcap: is not a recording");
    expect_one_line(cairn("record nothing -o run.mcap"), 1, "nothing");
    EXPECT_EQ(cairn("replay run.mcap --verify").code, 0); // the old file is unchanged
    expect_one_line(cairn("record tower -o run.txt"), 2, "must end in .mcap");
}

} // namespace
} // namespace cairn::test
