#include "viewer/commands.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <thread>
#include <vector>

namespace {

using namespace cairn::viewer;

TEST(CommandQueue, HandsOutWhatWasPushedInOrderAndOnce) {
    CommandQueue queue;
    for (int i = 0; i < 5; ++i) queue.push(command::ChangeSpeed{i});
    const std::vector<Command> taken = queue.take();
    ASSERT_EQ(taken.size(), 5u);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(std::get<command::ChangeSpeed>(taken[std::size_t(i)]).doublings, i);
    EXPECT_TRUE(queue.take().empty());
}

TEST(CommandQueue, LosesNothingBetweenThreads) {
    constexpr int writers = 4, each = 2000;
    CommandQueue queue;
    std::vector<std::thread> threads;
    for (int writer = 0; writer < writers; ++writer)
        threads.emplace_back([&queue, writer] {
            for (int i = 0; i < each; ++i) queue.push(command::ChangeSpeed{writer * each + i});
        });
    std::array<int, writers> next{};
    int total = 0;
    while (total < writers * each) {
        queue.wait(1.0);
        for (const Command& command : queue.take()) {
            const int value = std::get<command::ChangeSpeed>(command).doublings;
            EXPECT_EQ(value % each, next[std::size_t(value / each)]++); // each writer's own order is kept
            ++total;
        }
    }
    for (std::thread& thread : threads) thread.join();
}

TEST(CommandQueue, WaitEndsByACommandByClosingOrByTime) {
    using Clock = std::chrono::steady_clock;
    CommandQueue queue;
    queue.wait(0.01); // no command comes
    const Clock::time_point start = Clock::now();
    std::thread writer([&queue] { queue.push(command::TogglePause{}); });
    queue.wait(1e308);
    writer.join();
    EXPECT_EQ(queue.take().size(), 1u);
    std::thread closer([&queue] { queue.close(); });
    queue.wait(1e308);
    closer.join();
    EXPECT_TRUE(queue.closed());
    EXPECT_LT(std::chrono::duration<double>(Clock::now() - start).count(), 60.0);
}

} // namespace
