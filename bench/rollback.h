// The cost of rollbacks, as in a networked game when the input of another player arrives late.
#pragma once

#include <cairn/world.h>

#include <cstddef>
#include <vector>

namespace cairn::bench {

struct RollbackOptions {
    int rollbacks = 1000;
    int stride = 37; // index difference of the bodies that are pushed in successive frames
    int frames = 8;  // number of frames of each rollback
    int threads = 1;
};

struct RollbackResult {
    std::vector<double> milliseconds;       // per rollback: restoring, the steps, and saving
    double restore = 0, step = 0, save = 0; // means, ms; `step` of one step
    double processor = 0;                   // mean processor time of a rollback on all threads, ms
    // Number of rollbacks after which a state differed from that of a world without rollbacks.
    std::size_t wrong = 0;
    std::size_t bodies = 0, min_awake = 0, max_awake = 0;
    std::size_t contacts = 0, joints = 0; // at the end
    SnapshotSizes sizes;                  // of the last snapshot
    std::size_t bytes = 0;                // size of the last snapshot without its definitions
};

// 500 bodies: a heap of boxes and balls in a pen, hanging chains, and stacks that fall asleep. In every frame a body is
// pushed, but this becomes known only `frames` frames later: then the world is rolled back and repeats those steps with
// the pushes.
RollbackResult measure_rollback(const RollbackOptions& options);

} // namespace cairn::bench
