// What going back in time costs, as a game over a network does when the input of another player comes late.
#pragma once

#include <cairn/world.h>

#include <cstddef>
#include <vector>

namespace cairn::bench {

struct RollbackOptions {
    int rollbacks = 1000;
    int stride = 37; // of the bodies that are pushed one after another
    int frames = 8;  // that each goes back
    int threads = 1;
};

struct RollbackResult {
    std::vector<double> milliseconds;       // of each: restoring, the steps, and saving
    double restore = 0, step = 0, save = 0; // means, ms; of one step
    double processor = 0;                   // ms of processor time that a rollback takes, on all threads: the mean
    std::size_t wrong = 0;                  // rollbacks after which a state was not that of a world without any
    std::size_t bodies = 0, min_awake = 0, max_awake = 0;
    std::size_t contacts = 0, joints = 0; // at the end
    SnapshotSizes sizes;                  // of the last snapshot
    std::size_t bytes = 0;                // of it, without its definitions
};

// 500 bodies: a heap of boxes and balls in a pen, chains that hang, and stacks that fall asleep. In every frame a body
// is pushed, which is known only `frames` frames later: then the world goes back and takes those steps again, now with
// what is known.
RollbackResult measure_rollback(const RollbackOptions& options);

} // namespace cairn::bench
