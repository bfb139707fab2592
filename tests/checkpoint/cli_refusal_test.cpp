// Checkpoints that cannot be resumed or written are reported in one line: what failed, where, the value, and what was
// expected.
#include "cli_run.h"

#include <unistd.h>

namespace cairn::test {
namespace {

class CliRunRefusal : public CliRun {};

TEST_F(CliRunRefusal, OfCheckpointsOfAnotherRun) {
    put("poses.csv", "time,turn\n0,0\n1,1\n");
    put("other.csv", "time,turn\n0,0\n1,2\n");
    const std::string arm = "'" CAIRN_TEST_DATA "/arm.urdf' --fixed-base --targets ";
    summary("13_pile --frames 5 --checkpoint ck");
    summary(arm + "poses.csv --frames 5 --checkpoint ck_arm");
    const std::string start = "ck/step_5/index.json: start: is of a run with another initial state, from another scene "
                              "or other options (by checksum): must be ";
    expect_one_line(cairn("run 07_pyramid --resume ck"), 1, start);
    expect_one_line(cairn("run 13_pile --substeps 9 --resume ck"), 1, start);
    expect_one_line(
        cairn("run 13_pile --dt 0.01 --resume ck"), 1,
        "ck/step_5/index.json: time_step: is of a run with another time step: must be 0.01, got 0.016666668");
    EXPECT_NE(cairn("run " + arm + "other.csv --resume ck_arm")
                  .err.find("ck_arm/step_5/index.json: targets: is of a run with other --targets"),
              std::string::npos);
    expect_one_line(cairn("run 13_pile --frames 4 --resume ck"), 1,
                    "--frames: must be at least 5 steps, those that the checkpoint in ck has completed, got 4 steps");
}

TEST_F(CliRunRefusal, OfCheckpointsOfAnotherVersion) {
    summary("07_pyramid --frames 5 --checkpoint ck");
    nlohmann::ordered_json index = nlohmann::ordered_json::parse(bytes("ck/step_5/index.json"));
    index["checkpoint"]["run"]["version"] = "0.0.1";
    put("contents.json", index["checkpoint"].dump());
    const Result sum =
        shell("python3 -c 'import zlib; print(\"%08x\" % zlib.crc32(open(\"contents.json\",\"rb\").read()), "
              "end=\"\")'");
    ASSERT_EQ(sum.code, 0) << sum.err; // the checksum is zlib's crc32, as docs/scale.md says
    index["crc32"] = sum.out;
    put("ck/step_5/index.json", index.dump());
    expect_one_line(cairn("run 07_pyramid --resume ck"), 1,
                    "ck/step_5/index.json: version: was written by another version of this program: must be ");
}

TEST_F(CliRunRefusal, OfFoldersWithoutAWholeCheckpoint) {
    expect_one_line(cairn("run 07_pyramid --resume none"), 1,
                    "--resume: must be a folder with checkpoints, and has none, got none");
    summary("07_pyramid --frames 5 --checkpoint ck");
    put("ck/step_5/part_0", "short");
    const Result result = cairn("run 07_pyramid --resume ck");
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find("ck/step_5/part_0: size: must be "), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(" bytes, got 5"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("cairn: ck: has no whole checkpoint, of 1 that were begun"), std::string::npos)
        << result.err;
}

// The same command line of a batch job is used for its first start and for all later ones.
TEST_F(CliRunRefusal, DoesNotComeWhereTheFirstStartOfAJobFindsNoneYet) {
    const Result first = cairn("run 07_pyramid --frames 5 --checkpoint ck --resume ck");
    EXPECT_EQ(first.code, 0) << first.err;
    EXPECT_NE(first.err.find("cairn: there is no checkpoint in ck yet: the run begins at its start"), std::string::npos)
        << first.err;
    EXPECT_EQ(summary("07_pyramid --frames 8 --checkpoint ck --resume ck")["resumed_from"]["step"], 5);
}

TEST_F(CliRunRefusal, OfFoldersWithCheckpointsThatWouldBeLost) {
    summary("07_pyramid --frames 5 --checkpoint ck");
    expect_one_line(cairn("run 07_pyramid --frames 9 --checkpoint ck"), 1,
                    "--checkpoint: has checkpoints, the last of step 5: continue with --resume ck, or choose another "
                    "folder, got ck");
    summary("07_pyramid --frames 5 --checkpoint other");
    expect_one_line(cairn("run 07_pyramid --frames 9 --checkpoint other --resume ck"), 1,
                    "--checkpoint: has checkpoints");
    summary("07_pyramid --frames 9 --checkpoint third --resume ck");
    EXPECT_TRUE(fs::exists(folder_ / "third/step_9/index.json"));
}

TEST_F(CliRunRefusal, OfTwoRunsInOneFolder) {
    const Result result = shell("\"$CAIRN\" run 13_pile --seconds 1000 --checkpoint ck --checkpoint-every 5 >first & "
                                "runner=$!\n" +
                                std::string(wait_for_a_checkpoint) +
                                "\"$CAIRN\" run 13_pile --seconds 1000 --checkpoint ck --resume ck; code=$?\n"
                                "kill -9 $runner; wait $runner; exit $code");
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find("cairn: ck: is being written to by another program"), std::string::npos) << result.err;
}

TEST_F(CliRunRefusal, OfTwoRunsWithOneTable) {
    const Result result =
        shell("\"$CAIRN\" run 13_pile --seconds 1000 --checkpoint ck --checkpoint-every 5 --csv out.csv & "
              "runner=$!\n" +
              std::string(wait_for_a_checkpoint) +
              "\"$CAIRN\" run 13_pile --frames 5 --checkpoint other --csv out.csv; code=$?\n"
              "kill -9 $runner; wait $runner; exit $code");
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find("cairn: out.csv: cannot be written: another program is writing .out.unfinished.csv"),
              std::string::npos)
        << result.err;
    EXPECT_TRUE(fs::exists(folder_ / ".out.unfinished.csv"));
}

TEST_F(CliRunRefusal, OfDisksWithoutRoomKeepsTheLastCheckpointAndTheTable) {
    const std::string run = "13_pile --columns energy --checkpoint ck --csv ";
    summary(run + "out.csv --frames 10");
    fs::rename(folder_ / "out.csv", folder_ / ".out.unfinished.csv"); // as if the run had been killed at that time
    const Result full =
        shell("ulimit -f 16; exec \"$CAIRN\" run " + run + "out.csv --frames 30 --checkpoint-every 20 --resume ck");
    expect_one_line(full, 1,
                    "ck/step_20/part_0: cannot be written: File too large (of the checkpoint of step 20; the last "
                    "complete checkpoint is of step 10)");
    const Result resumed = cairn("run --json " + run + "out.csv --frames 30 --resume ck");
    EXPECT_NE(resumed.err.find("ck/step_20: was not finished: it has no index.json"), std::string::npos) << resumed.err;
    fs::remove_all(folder_ / "ck");
    expect_same_end(summary_of(resumed), summary(run + "whole.csv --frames 30"));
    EXPECT_EQ(bytes("out.csv"), bytes("whole.csv"));
}

TEST_F(CliRunRefusal, OfFoldersWithoutTheRightToWrite) {
    put("file", "");
    expect_one_line(cairn("run 13_pile --checkpoint file/ck"), 1, "file/ck: cannot be made: ");
    if (geteuid() == 0) return; // root may write everywhere
    fs::create_directories(folder_ / "locked");
    fs::permissions(folder_ / "locked", fs::perms::owner_read | fs::perms::owner_exec);
    expect_one_line(cairn("run 13_pile --checkpoint locked"), 1, "locked: cannot be written to: Permission denied");
}

TEST_F(CliRunRefusal, OfTablesWhoseBeginningIsAnother) {
    const std::string run = "13_pile --frames 20 --columns energy --csv out.csv ";
    summary(run + "--checkpoint ck");
    const std::string again = "run 13_pile --frames 30 --resume ck --csv out.csv ";
    expect_one_line(cairn(again + "--columns momentum"), 1,
                    "out.csv: has other columns than the run that continues: --columns must be as before");
    expect_one_line(cairn(again + "--columns energy --every 2"), 1,
                    "out.csv: was begun with other times, and is to be continued: must be --every 1 --from 0 --until "
                    "the end, got --every 2");
    std::string table = bytes("out.csv");
    table[table.size() - 3] = table[table.size() - 3] == '1' ? '2' : '1';
    put("out.csv", table);
    const Result changed = cairn(again + "--columns energy");
    expect_one_line(changed, 1,
                    "out.csv: cannot be continued: its first " + std::to_string(table.size()) +
                        " bytes are in neither");
    EXPECT_EQ(bytes("out.csv"), table) << "what is there stays";
}

TEST_F(CliRunRefusal, OfWrongCalls) {
    expect_one_line(cairn("run 13_pile --checkpoint-every 5"), 2, "--checkpoint-every requires --checkpoint");
    expect_one_line(cairn("run 13_pile --keep 5"), 2, "--keep requires --checkpoint");
    expect_one_line(cairn("run 13_pile --checkpoint ck --keep 0"), 2, "must be a number from 1 to 1000000, got 0");
    expect_one_line(cairn("run 13_pile --checkpoint ck --checkpoint-every 5 --checkpoint-seconds 5"), 2, "excludes");
    expect_one_line(cairn("run 13_pile --checkpoint ''"), 2, "must be the name of a folder");
}

} // namespace
} // namespace cairn::test
