// Checkpoints under mpirun: each process writes its part, and any other number of processes can resume.
#include "cli_run.h"

#include "../sanitized.h"

#include <random>

namespace cairn::test {
namespace {

class SharedRun : public CliRun {
  protected:
    void SetUp() override {
        CliRun::SetUp();
        if (!CAIRN_TEST_HAS_RANKS) GTEST_SKIP() << "built without MPI (Debian: libopenmpi-dev openmpi-bin)";
        if (cairn_test::is_sanitized) GTEST_SKIP() << "Open MPI itself leaks memory and races";
    }
    // Open MPI runs as root, and with more processes than there are cores, only with these options.
    static constexpr const char* begin =
        "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_btl_base_warn_component_unused=0\n"
        "run() { timeout -k 5 120 mpirun --oversubscribe -n \"$@\"; }\n";
    Result mpirun(int ranks, const std::string& arguments) const {
        return shell(begin + ("run " + std::to_string(ranks) + " \"$CAIRN\" run --json " + arguments));
    }
};

// The pile is divided among the ranks once it has landed.
TEST_F(SharedRun, IsGoneOnWithByAnyNumberOfRanksAndThreads) {
    const std::string scene = "13_pile --every 5 --csv ";
    const auto whole = summary(scene + "whole.csv --frames 72");
    const auto first = summary_of(mpirun(3, scene + "out.csv --frames 66 --checkpoint ck --checkpoint-every 33"));
    EXPECT_EQ(first["checkpoints"]["written"], 2);
    for (const char* part : {"part_0", "part_1", "part_2"}) EXPECT_TRUE(fs::exists(folder_ / "ck/step_66" / part));
    const auto size = [&](const char* part) { return double(fs::file_size(folder_ / "ck/step_66" / part)); };
    EXPECT_NEAR(size("part_0"), size("part_2"), 1);
    fs::copy(folder_ / "ck", folder_ / "spare", fs::copy_options::recursive);
    for (const auto& [ranks, threads] : {std::pair(1, 2), std::pair(2, 1), std::pair(4, 1)}) {
        fs::remove_all(folder_ / "ck");
        fs::copy(folder_ / "spare", folder_ / "ck", fs::copy_options::recursive);
        const std::string again =
            scene + "out.csv --frames 72 --checkpoint ck --resume ck --threads " + std::to_string(threads);
        const auto resumed = ranks == 1 ? summary(again) : summary_of(mpirun(ranks, again));
        expect_same_end(resumed, whole);
        EXPECT_EQ(resumed["resumed_from"]["step"], 66);
        EXPECT_EQ(bytes("out.csv"), bytes("whole.csv")) << ranks << " ranks";
    }
}

// A rank may also be killed while parts or the index are written, as there is a checkpoint after every other step.
TEST_F(SharedRun, LosesLittleWhenAnyRankIsKilledAtAnyMoment) {
    const std::string scene = "25_ragdolls --frames 1000 --every 11 --csv ";
    const auto whole = summary(scene + "whole.csv");
    const std::string run = "run --json " + scene + "out.csv --checkpoint ck --resume ck --checkpoint-every ";
    std::mt19937 random(5);
    std::uint64_t last = 0;
    for (const int ranks : {2, 3, 4}) {
        const std::string victim = std::to_string(int(random() % unsigned(ranks))),
                          delay = "0." + std::to_string(100 + random() % 300);
        const Result killed =
            shell(std::string(begin) + "rm -f pid.*; mkdir -p ck; ls ck >before; run " + std::to_string(ranks) +
                  " bash -c 'echo $$ >pid.$OMPI_COMM_WORLD_RANK; exec \"$CAIRN\" " + run + "2' & runner=$!\n" +
                  "for i in $(seq 400); do sleep 0.05; [ -s pid." + victim +
                  " ] && ! ls ck | cmp -s - before && break; done\n" + "sleep " + delay + "; kill -9 $(cat pid." +
                  victim + "); wait $runner");
        ASSERT_NE(killed.code, 0) << "it had come to its end before it was killed";
        EXPECT_NE(killed.err.find("signal 9"), std::string::npos) << killed.err;
        EXPECT_FALSE(fs::exists(folder_ / "out.csv"));
        std::uint64_t newest = 0;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "ck"))
            if (fs::exists(entry.path() / "index.json"))
                newest = std::max(newest, std::uint64_t(std::stoull(entry.path().filename().string().substr(5))));
        EXPECT_GE(newest, last) << "what was whole stays";
        last = newest;
    }
    const auto resumed = summary_of(cairn(run + "500"));
    EXPECT_GT(last, 0u);
    EXPECT_EQ(resumed["resumed_from"]["step"], last);
    expect_same_end(resumed, whole);
    EXPECT_EQ(bytes("out.csv"), bytes("whole.csv"));
}

// The clocks of processes differ: that of rank 0 decides.
TEST_F(SharedRun, HasCheckpointsByTheClockOfTheFirstRank) {
    const auto shared = summary_of(mpirun(3, "25_ragdolls --frames 100 --checkpoint ck --checkpoint-seconds 0.02"));
    EXPECT_GT(shared["checkpoints"]["written"], 1);
    expect_same_end(shared, summary("25_ragdolls --frames 100"));
}

TEST_F(SharedRun, PassesOverWhatAnyRankFindsDamaged) {
    const auto whole = summary("25_ragdolls --frames 50");
    summary_of(mpirun(4, "25_ragdolls --frames 40 --checkpoint ck --checkpoint-every 25"));
    for (const char* part : {"part_0", "part_3"}) {
        const std::string file = std::string("ck/step_40/") + part, before = bytes(file);
        std::string text = before;
        text[10] = char(text[10] ^ 1);
        put(file, text);
        const Result resumed = mpirun(2, "25_ragdolls --frames 50 --resume ck");
        EXPECT_NE(resumed.err.find("cairn: warning: " + file + ": checksum: is damaged"), std::string::npos)
            << resumed.err;
        EXPECT_EQ(summary_of(resumed)["resumed_from"]["step"], 25);
        expect_same_end(summary_of(resumed), whole);
        put(file, before);
    }
    EXPECT_EQ(summary_of(mpirun(2, "25_ragdolls --frames 50 --resume ck"))["resumed_from"]["step"], 40);
}

TEST_F(SharedRun, EndsWhenOneRankCannotWriteItsPart) {
    const Result full =
        shell(std::string(begin) +
              "run 2 bash -c '[ $OMPI_COMM_WORLD_RANK = 1 ] && ulimit -f 16; exec \"$CAIRN\" run 13_pile "
              "--frames 30 --checkpoint ck --checkpoint-every 10'");
    EXPECT_NE(full.code, 0);
    EXPECT_NE(full.err.find("cairn: rank 1: ck/step_10/part_1: cannot be written: File too large (of the checkpoint of "
                            "step 10; there is no older checkpoint)"),
              std::string::npos)
        << full.err;
    EXPECT_FALSE(fs::exists(folder_ / "ck/step_10/index.json"));
}

TEST_F(SharedRun, IsRefusedByAllWhenTheCheckpointIsOfAnotherScene) {
    summary("07_pyramid --frames 5 --checkpoint ck");
    const Result other = mpirun(2, "13_pile --frames 9 --resume ck");
    EXPECT_NE(other.code, 0);
    EXPECT_NE(other.err.find("cairn: rank 0: ck/step_5/index.json: start: is of a run with another initial state"),
              std::string::npos)
        << other.err;
}

} // namespace
} // namespace cairn::test
