// Calls kernels for the blocks of a batch, color by color, on one thread or on all.
#pragma once

#include "jobs/thread_pool.h"
#include "kernels/kernels.h"
#include "state/state.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cairn {

inline void* blocks_of(BatchScratch& scratch, const BlockRun& run) {
    if (run.four_points) return scratch.four_blocks.data() + run.first;
    return scratch.one_blocks.data() + run.first;
}
// Blocks per chunk: two chunks for each thread, so that all threads finish at about the same time, in multiples of the
// four blocks that are solved side by side. Distributing fewer than `min_handed_out` blocks takes longer than solving
// them.
inline int blocks_per_chunk(const ThreadPool* thread_pool, int count) {
    constexpr int side_by_side = 4, min_handed_out = 12;
    if (!thread_pool || count < min_handed_out) return count;
    return (count / (2 * thread_pool->threads()) + side_by_side) / side_by_side * side_by_side;
}

// Calls kernel(kernels of the run's type, run) for the blocks of every color, one color after the other, or for chunks
// of these blocks; after each color, calls after(index of the color).
template <class F, class After>
void for_colors(BatchScratch& scratch, ThreadPool* thread_pool, F&& kernel, After&& after) {
    const SolverKernels& kernels_of = kernels().solver;
    const auto call = [&](const BlockRun& run) {
        if (run.count > 0) kernel(run.four_points ? kernels_of.four_points : kernels_of.one_point, run);
    };
    const auto work = [&](const BlockRun& run, int begin, int end) {
        call({run.four_points, run.first + begin, end - begin});
    };
    for (std::size_t k = 0; k < scratch.colors.size(); ++k) {
        const ColorRun& color = scratch.colors[k];
        if (!thread_pool) { // in small batches, splitting runs takes about as long as solving them
            call(color.four_points), call(color.one_point);
            after(k);
            continue;
        }
        const int fours = color.four_points.count, all = fours + color.one_point.count;
        for_chunks(thread_pool, all, blocks_per_chunk(thread_pool, all), [&](int begin, int end, int) {
            work(color.four_points, std::min(begin, fours), std::min(end, fours));
            work(color.one_point, std::max(begin, fours) - fours, std::max(end, fours) - fours);
        });
        after(k);
    }
}
template <class F> void for_blocks(BatchScratch& scratch, ThreadPool* thread_pool, F&& kernel) {
    for_colors(scratch, thread_pool, kernel, [](std::size_t) {});
}

// Calls kernel(kernels of the call's type, blocks) for every run of joint rows, or for chunks of these runs.
template <class F> void for_joint_blocks(BatchScratch& scratch, ThreadPool* thread_pool, F&& kernel) {
    const JointKernels& k = kernels().joints;
    const JointKernels::ForRows* const kernels_of[joint_row_types] = {&k.point, &k.turn, &k.axis};
    for (const JointCall& call : scratch.joint_calls) {
        const JointKernels::ForRows& kernels = *kernels_of[std::size_t(call.type)];
        if (!thread_pool) {
            kernel(kernels, call.run);
            continue;
        }
        const int count = call.run.count;
        for_chunks(thread_pool, count, blocks_per_chunk(thread_pool, count), [&](int begin, int end, int) {
            std::byte* const first = static_cast<std::byte*>(call.run.blocks) + std::size_t(begin) * call.block_size;
            kernel(kernels, JointBlocks{first, end - begin, end < count ? nullptr : call.run.part});
        });
    }
}

} // namespace cairn
