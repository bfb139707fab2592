#include "cli/interrupt.h"

#include <csignal>

namespace cairn::cli {

namespace {

volatile std::sig_atomic_t interrupted = 0;

// The third signal ends the program at once. Not the second, because `timeout` and some shells send two, to the process
// and to its group, which would lose the results.
extern "C" void note_interrupt(int signal) {
    interrupted = interrupted + 1;
    if (interrupted >= 2) std::signal(signal, SIG_DFL);
}

} // namespace

InterruptGuard::InterruptGuard() {
    interrupted = 0;
    // Without SA_RESTART, so that waiting for the reader of a FIFO is interrupted.
    struct sigaction action {};
    action.sa_handler = note_interrupt;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

InterruptGuard::~InterruptGuard() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

bool InterruptGuard::requested() const { return interrupted != 0; }

} // namespace cairn::cli
