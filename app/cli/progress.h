// A line on the terminal that shows how far a run has come.
#pragma once

#include <chrono>
#include <cstdint>

namespace cairn::cli {

// Draws on stderr, at most ten times a second, and only if that is a terminal. The line is cleared in the end.
class ProgressLine {
  public:
    explicit ProgressLine(std::uint64_t total, const char* unit = "steps"); // unit: of what it counts
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    void show(std::uint64_t done);

  private:
    std::uint64_t total_;
    const char* unit_;
    bool on_terminal_, drawn_ = false;
    std::chrono::steady_clock::time_point next_;
};

} // namespace cairn::cli
