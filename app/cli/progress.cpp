#include "cli/progress.h"

#include "cli/outputs.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sys/ioctl.h>
#include <unistd.h>

namespace cairn::cli {

namespace {

// A duration as "12 s", "3 min 05 s", "2 h 07 min".
std::string duration_text(double seconds) {
    if (!(seconds < 360000.0)) return "over 100 h";
    const int whole = static_cast<int>(std::ceil(seconds));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::size_t terminal_width() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

void draw(const std::string& text) {
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr)); // a failure is harmless
    std::fflush(stderr);
}

} // namespace

ProgressLine::ProgressLine(std::uint64_t total, const char* unit, double simulated)
    : total_(total), unit_(unit), simulated_(simulated), on_terminal_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()), next_(start_ + std::chrono::milliseconds(200)) {
    if (output_is_on_terminal()) on_terminal_ = false;
}

ProgressLine::~ProgressLine() {
    if (drawn_) draw("\r\033[K");
}

std::string ProgressLine::line(std::uint64_t done, double seconds, const std::string& note) const {
    const double share = total_ > 0 ? static_cast<double>(done) / static_cast<double>(total_) : 1.0;
    std::string text = fmt::format(" {:3.0f} %  {}/{} {}", 100.0 * share, done, total_, unit_);
    if (done > 0 && seconds > 0.0) {
        const double rate = static_cast<double>(done) / seconds;
        if (simulated_ > 0.0) {
            text += fmt::format(", {:.3g} a second ({:.3g} x real time)", rate, rate * simulated_);
        } else if (rate >= 1.0) {
            text += fmt::format(", {:.3g} a second", rate);
        }
        text += fmt::format(", {} left", duration_text(static_cast<double>(total_ - done) / rate));
    }
    text += note;
    const std::size_t width = terminal_width();
    if (text.size() + 12 < width) { // space for a bar
        const std::size_t bar = std::min<std::size_t>(30, width - text.size() - 4);
        const auto filled = static_cast<std::size_t>(share * static_cast<double>(bar));
        text = "[" + std::string(filled, '#') + std::string(bar - filled, ' ') + "]" + text;
    }
    return text.substr(0, width - 1);
}

void ProgressLine::show(std::uint64_t done, const std::string& note) {
    const auto now = std::chrono::steady_clock::now();
    if (!on_terminal_ || now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    drawn_ = true;
    draw("\r" + line(done, std::chrono::duration<double>(now - start_).count(), note) + "\033[K");
}

} // namespace cairn::cli
