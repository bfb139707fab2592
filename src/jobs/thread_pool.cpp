#include "jobs/thread_pool.h"

#include <algorithm>
#include <csignal>
#include <utility>

namespace cairn {

namespace {

// How often an idle worker polls for work: with pauses, then yielding, before it sleeps. The stages of a step follow
// each other within microseconds; waking a thread takes ten times as long.
constexpr int looks_with_pause = 2000, looks_giving_way = 500;

void pause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    __asm__ __volatile__("yield");
#endif
}

// Blocks all signals in workers, so that the program's own threads handle them.
void leave_signals_alone() {
#if defined(__unix__)
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, nullptr);
#endif
}

// Sleeps until woken, unless the word has changed since it was read as `seen`.
void sleep_while(std::atomic<std::uint32_t>& word, std::uint32_t seen) {
#if defined(__EMSCRIPTEN_PTHREADS__)
    // Emscripten 3.1's library polls every 8 ms instead of waiting: a delay of half a frame.
    __builtin_wasm_memory_atomic_wait32(reinterpret_cast<std::int32_t*>(&word), std::int32_t(seen), -1);
#else
    word.wait(seen);
#endif
}

void wake_all(std::atomic<std::uint32_t>& word) {
#if defined(__EMSCRIPTEN_PTHREADS__)
    __builtin_wasm_memory_atomic_notify(reinterpret_cast<std::int32_t*>(&word), ~0u);
#else
    word.notify_all();
#endif
}

} // namespace

ThreadPool::ThreadPool(int threads) : ranges_(std::size_t(std::max(threads, 1))) {
    workers_.reserve(std::size_t(std::max(threads - 1, 0)));
    try {
        for (int i = 1; i < threads; ++i) workers_.emplace_back([this, i] { help(i); });
    } catch (...) {
        dismiss();
        throw;
    }
}

ThreadPool::~ThreadPool() { dismiss(); }

void ThreadPool::dismiss() {
    ends_ = true;
    ++wakes_;
    wake_all(wakes_);
    for (std::thread& worker : workers_) worker.join();
}

bool ThreadPool::take_chunk_of(Range& range, int thread) {
    std::uint64_t word = range.word.load(std::memory_order_acquire);
    for (;;) {
        const std::uint64_t chunk = word & index_mask, last = (word >> index_bits) & index_mask;
        if (chunk >= last) return false;
        const int first = first_.load(std::memory_order_relaxed), end = end_.load(std::memory_order_relaxed);
        const int grain = grain_.load(std::memory_order_relaxed);
        const Work work = work_.load(std::memory_order_relaxed);
        const void* const context = context_.load(std::memory_order_relaxed);
        if (!range.word.compare_exchange_weak(word, word + 1, std::memory_order_acq_rel, std::memory_order_acquire))
            continue;
        // The stage cannot end before this chunk is done, so the values read belong to it.
        const int begin = first + int(chunk) * grain;
        try {
            work(context, begin, end - begin < grain ? end : begin + grain, thread);
        } catch (...) {
            const std::lock_guard lock(failure_mutex_);
            failure_ = std::current_exception();
        }
        done_.fetch_add(1, std::memory_order_release);
        return true;
    }
}

// Takes a chunk of the thread's own range, or else of the others', starting with the next thread's.
bool ThreadPool::take_chunk(int thread) {
    const std::size_t threads = ranges_.size();
    for (std::size_t i = 0; i < threads; ++i)
        if (take_chunk_of(ranges_[(std::size_t(thread) + i) % threads], thread)) return true;
    return false;
}

void ThreadPool::run(int first, int end, int grain, Work work, const void* context) {
    const std::uint64_t chunks = std::uint64_t((end - first - 1) / grain + 1), threads = ranges_.size();
    first_.store(first, std::memory_order_relaxed);
    end_.store(end, std::memory_order_relaxed);
    grain_.store(grain, std::memory_order_relaxed);
    work_.store(work, std::memory_order_relaxed);
    context_.store(context, std::memory_order_relaxed);
    done_.store(0, std::memory_order_relaxed);
    const std::uint64_t stage = stage_.load(std::memory_order_relaxed) + 1;
    for (std::uint64_t i = 0; i < threads; ++i) {
        const std::uint64_t begin = chunks * i / threads, last = chunks * (i + 1) / threads;
        ranges_[i].word.store(stage << (2 * index_bits) | last << index_bits | begin, std::memory_order_release);
    }
    // Sequentially consistent with sleepers_: either this sees a sleeper, or the sleeper sees the stage.
    stage_.store(stage);
    if (sleepers_.load() > 0) {
        ++wakes_;
        wake_all(wakes_);
    }
    while (take_chunk(0)) {}
    for (int looks = 0; done_.load(std::memory_order_acquire) != chunks; ++looks) {
        if (looks < looks_with_pause)
            pause();
        else
            std::this_thread::yield();
    }
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void ThreadPool::help(int thread) {
    leave_signals_alone();
    while (!ends_.load(std::memory_order_relaxed)) {
        const std::uint64_t seen = stage_.load(std::memory_order_acquire);
        while (take_chunk(thread)) {}
        wait_for_stage(seen);
    }
}

// Waits until the stage is another one than `seen`.
void ThreadPool::wait_for_stage(std::uint64_t seen) {
    auto changed = [&] { return stage_.load() != seen || ends_.load(); };
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
    if (!changed()) sleep_while(wakes_, wakes);
    --sleepers_;
}

} // namespace cairn
