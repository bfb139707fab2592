#include "viewer/draw_scale.h"

namespace cairn::viewer {

void DrawScale::change(std::size_t level) {
    level_ = level;
    count_ = -1;
    sum_ = 0.0;
}

void DrawScale::count_frame(double seconds) {
    if (++count_ < 1) return;
    sum_ += seconds;
    if (count_ < frames) return;
    const double mean = sum_ / frames;
    count_ = 0;
    sum_ = 0.0;
    if (mean > wanted && level_ + 1 < levels.size()) {
        change(level_ + 1);
    } else if (level_ > 0) {
        // The cost of a frame grows at most in proportion to its pixels, so the larger scale will not have to be
        // reverted.
        const double more = static_cast<double>(levels[level_ - 1] / levels[level_]);
        if (mean * more * more < wanted) change(level_ - 1);
    }
}

} // namespace cairn::viewer
