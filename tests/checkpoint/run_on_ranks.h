// Ranks as threads of the test.
#pragma once

#include "../determinism/local_ranks.h"

#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace cairn_test {

// Calls work(communicator) on each of that many ranks in parallel; on a single rank, without a communicator.
inline void run_on_ranks(int ranks, const std::function<void(cairn::Communicator*)>& work) {
    if (ranks == 1) return work(nullptr);
    const auto post = std::make_shared<Post>(ranks);
    std::vector<std::thread> all;
    for (int rank = 0; rank < ranks; ++rank) {
        all.emplace_back([&, rank] {
            LocalRank communicator(post, rank);
            work(&communicator);
        });
    }
    for (std::thread& thread : all) thread.join();
}

} // namespace cairn_test
