// Restoring a snapshot and stepping again, a thousand times, as measured by `cairn_bench --rollback`.
#include "bench/rollback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace cairn_test {
namespace {

TEST(Rollback, OfEightFramesAThousandTimesEndsWhereAStraightRunDoes) {
    const cairn::bench::RollbackResult result = cairn::bench::measure_rollback({});
    EXPECT_EQ(result.wrong, 0u);
    ASSERT_EQ(result.milliseconds.size(), 1000u);
    EXPECT_EQ(result.bodies, 500u);
    EXPECT_EQ(result.joints, 60u);
    EXPECT_GT(result.contacts, 700u);  // a heap in motion: about 800, depending on the arithmetic
    EXPECT_GE(result.min_awake, 250u); // the heap is kept awake
    EXPECT_LE(result.min_awake, 440u); // and the stacks sleep
    double sum = 0;
    for (const double ms : result.milliseconds) sum += ms;
    std::printf("%.2f ms a rollback: %.2f restoring, 8 x %.2f stepping, %.2f saving; %.2f ms of the processor\n",
                sum / 1000, result.restore, result.step, result.save, result.processor);
    // Processor time, with a bar of ten times the budget of real time, because test machines are busy.
    EXPECT_LT(result.processor, 10 * 1000.0 / 60);
}

// The travel up to which a body's fat boxes need no check was missing in the snapshot: after a restore boxes differed,
// and with them the order of contacts.
TEST(Rollback, HasTheBoxesOfAStraightRun) {
    for (const int stride : {11, 53, 101}) {
        const cairn::bench::RollbackResult result =
            cairn::bench::measure_rollback({.rollbacks = 250, .stride = stride});
        EXPECT_EQ(result.wrong, 0u) << stride;
    }
}

} // namespace
} // namespace cairn_test
