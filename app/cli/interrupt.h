// Handling of Ctrl-C: a long run stops after its present step and closes its files.
#pragma once

namespace cairn::cli {

// During its lifetime, the first SIGINT or SIGTERM sets a flag; the third ends the program at once.
class InterruptGuard {
  public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    bool requested() const;
};

} // namespace cairn::cli
