#include "cli/progress.h"

#include <fmt/core.h>

#include <cstdio>
#include <string>
#include <unistd.h>

namespace cairn::cli {

ProgressLine::ProgressLine(std::uint64_t total, const char* unit)
    : total_(total), unit_(unit), on_terminal_(isatty(STDERR_FILENO) == 1), next_(std::chrono::steady_clock::now()) {}

ProgressLine::~ProgressLine() {
    if (drawn_) fmt::print(stderr, "\r\033[K");
}

void ProgressLine::show(std::uint64_t done) {
    const auto now = std::chrono::steady_clock::now();
    if (!on_terminal_ || now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    drawn_ = true;
    constexpr std::uint64_t width = 40;
    const std::uint64_t filled = total_ > 0 ? done * width / total_ : width;
    fmt::print(stderr, "\r[{}{}] {}/{} {}", std::string(filled, '#'), std::string(width - filled, ' '), done, total_,
               unit_);
    std::fflush(stderr);
}

} // namespace cairn::cli
