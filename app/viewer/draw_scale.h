/// \file draw_scale.h
/// Where the processor draws, a picture of fewer pixels is better than one that jerks: chooses the share of the
/// window's pixels, each way, that frames are drawn with.
#pragma once

#include <array>
#include <cstddef>

namespace cairn::viewer {

class DrawScale {
  public:
    /// Longest time of a frame that is good enough, s.
    static constexpr double wanted = 1.0 / 30.0;

    float value() const noexcept { return levels[level_]; }
    /// A frame took so long, s.
    void count_frame(double seconds);

  private:
    static constexpr std::array<float, 3> levels{1.0f, 0.75f, 0.5f};
    static constexpr int frames = 10; // that a choice is made from; the first after a change is not among them

    void change(std::size_t level);

    std::size_t level_ = 0;
    int count_ = 0;
    double sum_ = 0.0;
};

} // namespace cairn::viewer
