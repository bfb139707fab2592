// Sweeps under mpirun: any number of processes gives the same bytes.
#include "cli_sweep.h"

#include "../sanitized.h"

namespace cairn::test {
namespace {

class Ranks : public CliSweep {
  protected:
    void SetUp() override {
        CliSweep::SetUp();
        if (!CAIRN_TEST_HAS_RANKS) GTEST_SKIP() << "built without MPI (Debian: libopenmpi-dev openmpi-bin)";
        if (cairn_test::is_sanitized) GTEST_SKIP() << "Open MPI itself leaks memory and races";
    }

    // Open MPI runs as root, and with more processes than there are cores, only with these options.
    static constexpr const char* mpirun =
        "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_btl_base_warn_component_unused=0\n"
        "run() { timeout -k 5 120 mpirun --oversubscribe -n \"$@\"; }\n";
};

TEST_F(Ranks, AnyNumberOfThemGivesTheSameBytes) {
    write_plan(300);
    ASSERT_EQ(cairn("sweep plan.json --out alone").code, 0);
    for (const char* ranks : {"2", "3", "4"}) {
        const Result result =
            shell(std::string(mpirun) + "run " + ranks + " \"$CAIRN\" sweep plan.json --out r" + ranks);
        ASSERT_EQ(result.code, 0) << result.out << result.err;
        EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 5) << "one summary: " << result.out;
        for (const char* file : {"rows.csv", "rows.npy", "summary.json"}) {
            EXPECT_EQ(bytes(std::string("alone/") + file), bytes(std::string("r") + ranks + "/" + file))
                << ranks << file;
        }
    }
}

TEST_F(Ranks, WhenOneIsKilledTheRunEndsAndResumesToTheSameBytes) {
    write_plan(1500, 1.0);
    // The process to be killed is identified by a file that it writes at its start.
    const Result killed =
        shell(std::string(mpirun) +
              "run 3 bash -c 'echo $$ >pid.$OMPI_COMM_WORLD_RANK; exec \"$CAIRN\" sweep plan.json --out "
              "out' & runner=$!\n"
              "for i in $(seq 300); do sleep 0.05; [ -n \"$(find out -size +4k)\" ] && break; done\n"
              "kill -9 $(cat pid.1); wait $runner");
    EXPECT_NE(killed.code, 0);
    EXPECT_NE(killed.err.find("signal 9"), std::string::npos) << killed.err;
    EXPECT_FALSE(fs::exists(folder_ / "out" / "rows.csv"));
    const Result resumed = shell(std::string(mpirun) + "run 2 \"$CAIRN\" sweep plan.json --out out --resume");
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    ASSERT_EQ(cairn("sweep plan.json --out alone").code, 0);
    EXPECT_EQ(bytes("out/rows.csv"), bytes("alone/rows.csv"));
}

TEST_F(Ranks, AnErrorInOneEndsAll) {
    write_plan(4000, 0.1);
    const Result full = shell(std::string(mpirun) +
                              "run 2 bash -c '[ $OMPI_COMM_WORLD_RANK = 1 ] && ulimit -f 16; exec \"$CAIRN\" sweep "
                              "plan.json --out out'");
    EXPECT_NE(full.code, 0);
    EXPECT_NE(full.err.find("cairn: rank 1: out/shards/"), std::string::npos) << full.err;
}

TEST_F(CliSweep, WithoutMpiTheMessageSaysWhatToInstall) {
    write_plan(10);
    // Simulates a program that was built without MPI: the library it would load is not beside it.
    const Result result = shell("cp \"$CAIRN\" ./alone; OMPI_COMM_WORLD_SIZE=2 ./alone sweep plan.json --out out");
    expect_one_line(result, 1, "install libopenmpi-dev and openmpi-bin and build again, or use --shard I/N");
}

} // namespace
} // namespace cairn::test
