#include "jobs/thread_pool.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

using cairn::ThreadPool;

class CrewOf : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Threads, CrewOf, testing::Values(1, 2, 3, 8));

TEST_P(CrewOf, DoesEachItemOnceInChunksOfAtMostTheGrain) {
    ThreadPool thread_pool(GetParam());
    for (const int count : {0, 1, 7, 64, 1000}) {
        for (const int grain : {1, 3, 64, 5000}) {
            std::vector<std::atomic<int>> done(static_cast<std::size_t>(count));
            std::atomic<bool> fits = true;
            thread_pool.for_chunks(count, grain, [&](int begin, int end, int thread) {
                if (begin >= end || end - begin > grain || thread < 0 || thread >= thread_pool.threads()) fits = false;
                for (int i = begin; i < end; ++i) ++done[static_cast<std::size_t>(i)];
            });
            EXPECT_TRUE(fits) << count << " by " << grain;
            for (const auto& times : done) EXPECT_EQ(times, 1) << count << " by " << grain;
        }
    }
}

// A stage counts its chunks with 20 bits: this one has more chunks than that.
TEST_P(CrewOf, DoesEachItemOnceWhereThereAreMoreChunksThanOneStageHolds) {
    ThreadPool thread_pool(GetParam());
    const int count = (1 << 20) + 1000;
    std::vector<std::uint8_t> done(static_cast<std::size_t>(count));
    thread_pool.for_chunks(count, 1, [&](int begin, int end, int) {
        for (int i = begin; i < end; ++i) ++done[static_cast<std::size_t>(i)];
    });
    for (int i = 0; i < count; ++i) ASSERT_EQ(done[static_cast<std::size_t>(i)], 1) << "item " << i;
}

// Short stages in quick succession, with few chunks: a late worker could take a chunk of the wrong stage.
TEST_P(CrewOf, KeepsManyShortStagesApart) {
    ThreadPool thread_pool(GetParam());
    std::vector<std::int64_t> sums(16, 0);
    for (int stage = 0; stage < 50000; ++stage) {
        const int count = 2 + stage % 7;
        thread_pool.for_chunks(count, 1, [&sums, stage](int begin, int, int) { sums[std::size_t(begin)] += stage; });
    }
    for (int i = 0; i < 8; ++i) {
        std::int64_t expected = 0;
        for (int stage = 0; stage < 50000; ++stage)
            if (i < 2 + stage % 7) expected += stage;
        EXPECT_EQ(sums[std::size_t(i)], expected) << "item " << i;
    }
}

TEST_P(CrewOf, WakesWhenItHasSlept) {
    ThreadPool thread_pool(GetParam());
    for (int round = 0; round < 5; ++round) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        std::atomic<int> done = 0;
        thread_pool.for_chunks(100, 1, [&](int, int, int) { ++done; });
        EXPECT_EQ(done, 100);
    }
}

TEST_P(CrewOf, HandsOnAnExceptionAndWorksOn) {
    ThreadPool thread_pool(GetParam());
    std::atomic<int> done = 0;
    auto throws = [&](int begin, int, int) {
        ++done;
        if (begin == 5) throw std::runtime_error("five");
    };
    EXPECT_THROW(thread_pool.for_chunks(20, 1, throws), std::runtime_error);
    if (GetParam() > 1) {
        EXPECT_EQ(done, 20);
    }
    done = 0;
    thread_pool.for_chunks(20, 1, [&](int, int, int) { ++done; });
    EXPECT_EQ(done, 20);
}

TEST_P(CrewOf, ComesAndGoesWithoutWork) {
    for (int i = 0; i < 20; ++i) ThreadPool thread_pool(GetParam());
}

} // namespace
