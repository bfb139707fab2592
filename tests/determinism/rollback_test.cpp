// Going back and stepping again, a thousand times: as `cairn_bench --rollback` measures it.
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
    EXPECT_GT(result.contacts, 700u);  // a heap in motion: about 800, more or fewer with every change of the arithmetic
    EXPECT_GE(result.min_awake, 250u); // the heap is kept awake
    EXPECT_LE(result.min_awake, 440u); // and the stacks sleep
    double sum = 0;
    for (const double ms : result.milliseconds) sum += ms;
    std::printf("%.2f ms a rollback: %.2f restoring, 8 x %.2f stepping, %.2f saving; %.2f ms of the processor\n",
                sum / 1000, result.restore, result.step, result.save, result.processor);
    // Ten times what real time asks for, of the processor: machines that test are busy.
    EXPECT_LT(result.processor, 10 * 1000.0 / 60);
}

// What a body spared itself, to look whether its boxes still fit, was not in the snapshot: boxes differed, and with
// them the order of contacts.
TEST(Rollback, HasTheBoxesOfAStraightRun) {
    for (const int stride : {11, 53, 101}) {
        const cairn::bench::RollbackResult result =
            cairn::bench::measure_rollback({.rollbacks = 250, .stride = stride});
        EXPECT_EQ(result.wrong, 0u) << stride;
    }
}

} // namespace
} // namespace cairn_test
