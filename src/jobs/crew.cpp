#include "jobs/crew.h"

#include <algorithm>
#include <csignal>
#include <utility>

namespace cairn {

namespace {

// Looks of a worker that found nothing to do: with pauses, then giving way, then it sleeps. A stage of a step follows
// the last within microseconds; waking a thread takes ten times as long.
constexpr int looks_with_pause = 2000, looks_giving_way = 500;

void pause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    __asm__ __volatile__("yield");
#endif
}

} // namespace

Crew::Crew(int threads) {
    workers_.reserve(std::size_t(std::max(threads - 1, 0)));
    try {
        for (int i = 1; i < threads; ++i) workers_.emplace_back([this, i] { help(i); });
    } catch (...) {
        dismiss();
        throw;
    }
}

Crew::~Crew() { dismiss(); }

void Crew::dismiss() {
    ends_ = true;
    ++wakes_;
    wakes_.notify_all();
    for (std::thread& worker : workers_) worker.join();
}

bool Crew::take_chunk(int thread) {
    std::uint64_t at = cursor_.load(std::memory_order_acquire);
    for (;;) {
        const std::uint32_t chunk = std::uint32_t(at);
        if (chunk >= chunk_count_.load(std::memory_order_relaxed)) return false;
        const int count = count_.load(std::memory_order_relaxed), grain = grain_.load(std::memory_order_relaxed);
        const Work work = work_.load(std::memory_order_relaxed);
        const void* const context = context_.load(std::memory_order_relaxed);
        if (!cursor_.compare_exchange_weak(at, at + 1, std::memory_order_acq_rel, std::memory_order_acquire)) continue;
        // The stage cannot end before this chunk: what was read belongs to it.
        const int begin = int(chunk) * grain, end = count - begin < grain ? count : begin + grain;
        try {
            work(context, begin, end, thread);
        } catch (...) {
            const std::lock_guard lock(failure_mutex_);
            failure_ = std::current_exception();
        }
        done_.fetch_add(1, std::memory_order_release);
        return true;
    }
}

void Crew::run(int count, int grain, Work work, const void* context) {
    const std::uint32_t chunks = std::uint32_t((count - 1) / grain + 1);
    count_.store(count, std::memory_order_relaxed);
    grain_.store(grain, std::memory_order_relaxed);
    work_.store(work, std::memory_order_relaxed);
    context_.store(context, std::memory_order_relaxed);
    chunk_count_.store(chunks, std::memory_order_relaxed);
    done_.store(0, std::memory_order_relaxed);
    ++stage_;
    cursor_.store(stage_ << 32); // in one order with sleepers_: either this sees a sleeper, or it sees the stage
    if (sleepers_.load() > 0) {
        ++wakes_;
        wakes_.notify_all();
    }
    while (take_chunk(0)) {}
    for (int looks = 0; done_.load(std::memory_order_acquire) != chunks; ++looks) {
        if (looks < looks_with_pause)
            pause();
        else
            std::this_thread::yield();
    }
    // Closed before anything of the next stage is written: see take_chunk.
    cursor_.store((stage_ << 32) | closed, std::memory_order_release);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void Crew::help(int thread) {
    // The program's signals are for the program's own threads.
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, nullptr);
    while (!ends_.load(std::memory_order_relaxed)) {
        if (take_chunk(thread)) continue;
        wait_for_work();
    }
}

void Crew::wait_for_work() {
    const std::uint64_t seen = cursor_.load(std::memory_order_relaxed);
    auto changed = [&] { return cursor_.load(std::memory_order_relaxed) != seen || ends_.load(); };
    for (int looks = 0; looks < looks_with_pause; ++looks) {
        if (changed()) return;
        pause();
    }
    for (int looks = 0; looks < looks_giving_way; ++looks) {
        if (changed()) return;
        std::this_thread::yield();
    }
    const std::uint32_t wakes = wakes_.load();
    ++sleepers_;
    // Closed, or all of its chunks taken.
    const bool idle = std::uint32_t(cursor_.load()) >= chunk_count_.load() && !ends_.load();
    if (idle) wakes_.wait(wakes);
    --sleepers_;
}

} // namespace cairn
