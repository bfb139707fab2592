// One world under mpirun: any number of processes gives the same bits as one process.
#include "cli_sweep.h"

#include "../sanitized.h"

#include <nlohmann/json.hpp>

namespace cairn::test {
namespace {

class SharedWorld : public CliSweep {
  protected:
    void SetUp() override {
        CliSweep::SetUp();
        if (!CAIRN_TEST_HAS_RANKS) GTEST_SKIP() << "built without MPI (Debian: libopenmpi-dev openmpi-bin)";
        if (cairn_test::is_sanitized) GTEST_SKIP() << "Open MPI itself leaks memory and races";
    }
    // Open MPI runs as root, and with more processes than there are cores, only with these options.
    Result mpirun(const std::string& arguments) const {
        return shell("export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
                     "OMPI_MCA_btl_base_warn_component_unused=0\n"
                     "timeout -k 5 120 mpirun --oversubscribe " +
                     arguments);
    }
};

// A pile of 1,000 bodies, which is divided among the ranks once it has landed; ragdolls, which are not; and bullets,
// whose impacts request normals from the ranks that own the contacts.
TEST_F(SharedWorld, AnyNumberOfRanksGivesTheSameStateAndTheSameFile) {
    for (const std::string scene : {"13_pile --frames 75", "25_ragdolls --frames 15", "33_bullets --frames 40"}) {
        const Result alone = cairn("run " + scene + " --every 10 --json --csv alone.csv");
        ASSERT_EQ(alone.code, 0) << alone.err;
        const auto hash = nlohmann::json::parse(alone.out)["hash"];
        for (const std::string ranks : {"2", "3"}) {
            const Result result = mpirun("-n " + ranks + " \"$CAIRN\" run " + scene + " --every 10 --json --csv r.csv");
            ASSERT_EQ(result.code, 0) << result.out << result.err;
            const auto summary = nlohmann::json::parse(result.out); // a single one, from rank 0
            EXPECT_EQ(summary["hash"], hash) << scene << ", " << ranks << " ranks";
            ASSERT_EQ(summary["ranks"].size(), std::size_t(std::stoi(ranks)));
            EXPECT_GT(summary["ranks"][1]["messages"], 0);
            EXPECT_EQ(bytes("r.csv"), bytes("alone.csv")) << scene << ", " << ranks << " ranks";
        }
    }
}

TEST_F(SharedWorld, WhenOneIsKilledTheRunEndsAndLeavesNoFile) {
    const Result killed = mpirun("-n 3 bash -c 'echo $$ >pid.$OMPI_COMM_WORLD_RANK; exec \"$CAIRN\" run 13_pile "
                                 "--seconds 1000 --csv out.csv' & runner=$!\n"
                                 "for i in $(seq 200); do sleep 0.05; [ -s pid.1 ] && break; done; sleep 1\n"
                                 "kill -9 $(cat pid.1); wait $runner");
    EXPECT_NE(killed.code, 0);
    EXPECT_NE(killed.err.find("signal 9"), std::string::npos) << killed.err;
    EXPECT_FALSE(fs::exists(folder_ / "out.csv"));
}

TEST_F(SharedWorld, RanksWithDifferentScenesAreToldSo) {
    const Result result = mpirun("-n 1 \"$CAIRN\" run 13_pile --frames 5 : -n 1 \"$CAIRN\" run 07_pyramid --frames 5");
    EXPECT_NE(result.code, 0);
    EXPECT_NE(result.err.find("cairn: rank 1: state: "), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("after step 0 is not that of rank 0"), std::string::npos) << result.err;
}

TEST_F(SharedWorld, AFileThatCannotBeWrittenEndsAll) {
    const Result result = mpirun("-n 2 \"$CAIRN\" run 13_pile --frames 5 --csv no/such/folder.csv");
    EXPECT_NE(result.code, 0);
    EXPECT_NE(result.err.find("cairn: rank 0: "), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("no/such"), std::string::npos) << result.err;
}

TEST_F(CliSweep, RunWithoutMpiSaysWhatToInstall) {
    const Result result = shell("cp \"$CAIRN\" ./alone; OMPI_COMM_WORLD_SIZE=2 ./alone run 13_pile --frames 1");
    expect_one_line(result, 1, "install libopenmpi-dev and openmpi-bin and build again, or start it without mpirun");
}

} // namespace
} // namespace cairn::test
