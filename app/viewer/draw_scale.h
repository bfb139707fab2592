/// \file draw_scale.h
/// Chooses the fraction of the window's resolution, in each dimension, at which frames are drawn: with software
/// rendering, a picture of fewer pixels is preferred to a low frame rate.
#pragma once

#include <array>
#include <cstddef>

namespace cairn::viewer {

class DrawScale {
  public:
    /// Longest acceptable frame time, s.
    static constexpr double wanted = 1.0 / 30.0;

    float value() const noexcept { return levels[level_]; }
    /// Reports the time of a frame, s.
    void count_frame(double seconds);

  private:
    static constexpr std::array<float, 3> levels{1.0f, 0.75f, 0.5f};
    // Number of frames that a choice is based on; the first frame after a change is skipped.
    static constexpr int frames = 10;

    void change(std::size_t level);

    std::size_t level_ = 0;
    int count_ = 0;
    double sum_ = 0.0;
};

} // namespace cairn::viewer
