// A progress line on the terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace cairn::cli {

// Shows the completed share, the rate and the remaining time on stderr, at most ten times a second, and only if stderr
// is a terminal and no output file goes to the terminal. The line is cleared at the end.
class ProgressLine {
  public:
    // `unit`: name of the counted items; `simulated`: simulated seconds per item, or 0.
    explicit ProgressLine(std::uint64_t total, const char* unit, double simulated = 0.0);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    void show(std::uint64_t done, const std::string& note = {}); // `note` is appended to the line

  private:
    std::string line(std::uint64_t done, double seconds, const std::string& note) const;

    std::uint64_t total_;
    const char* unit_;
    double simulated_;
    bool on_terminal_, drawn_ = false;
    std::chrono::steady_clock::time_point start_, next_;
};

} // namespace cairn::cli
