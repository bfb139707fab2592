// The blocks of a batch, color by color: how kernels are called for them, by one thread or by all.
#pragma once

#include "jobs/thread_pool.h"
#include "kernels/kernels.h"
#include "state/state.h"

#include <algorithm>
#include <cstddef>

namespace cairn {

inline const SolverKernels::ForPoints& kernels_for(const BlockRun& run) {
    return run.four_points ? kernels().solver.four_points : kernels().solver.one_point;
}
inline void* blocks_of(BatchScratch& scratch, const BlockRun& run) {
    if (run.four_points) return scratch.four_blocks.data() + run.first;
    return scratch.one_blocks.data() + run.first;
}
// Two chunks for each thread, so that they end together; whole groups of the four blocks that are solved side by side.
// Handing out fewer blocks than these takes longer than solving them.
inline int blocks_per_chunk(const ThreadPool* thread_pool, int count) {
    constexpr int side_by_side = 4, min_handed_out = 12;
    if (!thread_pool || count < min_handed_out) return count;
    return (count / (2 * thread_pool->threads()) + side_by_side) / side_by_side * side_by_side;
}

// Calls kernel(its kernels, run) for the blocks of every color, one color after the other, or for chunks of them; after
// each color after(its place among the colors).
template <class F, class After>
void for_colors(BatchScratch& scratch, ThreadPool* thread_pool, F&& kernel, After&& after) {
    const auto call = [&](const BlockRun& run) {
        if (run.count > 0) kernel(kernels_for(run), run);
    };
    const auto work = [&](const BlockRun& run, int begin, int end) {
        call({run.four_points, run.first + begin, end - begin});
    };
    for (std::size_t k = 0; k < scratch.colors.size(); ++k) {
        const ColorRun& color = scratch.colors[k];
        if (!thread_pool) { // in small batches, cutting runs would take as long as much of what is in them
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

// Calls f(run) for every run of joint rows, or for chunks of them.
template <class F> void for_joint_runs(BatchScratch& scratch, ThreadPool* thread_pool, F&& f) {
    for (const JointRun& run : scratch.joint_layout->runs) {
        if (!thread_pool) {
            f(run);
            continue;
        }
        const int count = int(run.count);
        for_chunks(thread_pool, count, blocks_per_chunk(thread_pool, count), [&](int begin, int end, int) {
            JointRun part = run;
            part.first += std::uint32_t(begin);
            part.count = std::uint32_t(end - begin);
            f(part);
        });
    }
}

// Calls kernel(its kernels, its blocks) for the blocks of a run.
template <class F> void with_joint_blocks(BatchScratch& scratch, const JointRun& run, F&& kernel) {
    const JointKernels& k = kernels().joints;
    const std::size_t first = std::size_t(run.first);
    switch (run.type) {
    case JointRowType::point:
        kernel(k.point, scratch.point_blocks.data() + first);
        break;
    case JointRowType::turn:
        kernel(k.turn, scratch.turn_blocks.data() + first);
        break;
    case JointRowType::axis:
        kernel(k.axis, scratch.axis_blocks.data() + first);
        break;
    }
}

// Calls kernel(its kernels, its blocks, count) for the blocks of every run of joint rows, or for chunks of them.
template <class F> void for_joint_blocks(BatchScratch& scratch, ThreadPool* thread_pool, F&& kernel) {
    for_joint_runs(scratch, thread_pool, [&](const JointRun& run) {
        with_joint_blocks(scratch, run,
                          [&](const JointKernels::ForRows& k, void* blocks) { kernel(k, blocks, int(run.count)); });
    });
}

} // namespace cairn
