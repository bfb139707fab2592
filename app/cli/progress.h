// A line on the terminal that shows how far a run has come.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace cairn::cli {

// Draws on stderr, at most ten times a second, and only if that is a terminal on which no output file is shown. How
// much is done, how fast it goes, how long it will still take. The line is cleared in the end.
class ProgressLine {
  public:
    // `unit` is what it counts; `simulated`, if not 0, how many seconds of the scene one of them is.
    explicit ProgressLine(std::uint64_t total, const char* unit, double simulated = 0.0);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    void show(std::uint64_t done, const std::string& note = {}); // which ends the line

  private:
    std::string line(std::uint64_t done, double seconds, const std::string& note) const;

    std::uint64_t total_;
    const char* unit_;
    double simulated_;
    bool on_terminal_, drawn_ = false;
    std::chrono::steady_clock::time_point start_, next_;
};

} // namespace cairn::cli
