// The threads of a world: the calling thread, which always takes part, and the workers. A stage cuts its items into
// chunks. Each thread has a range of them at home, the same part of the items in every stage, so that what it wrote in
// the last one is still in its cache; whoever has done his own helps with the others'. A stage ends when its chunks are
// done, not when all workers have arrived, so that a worker that the operating system has put aside holds nobody up.
// How the items are cut must not matter to the results; which thread takes which chunk is left to chance.
//
// Between stages workers look for work for some 100 microseconds, then give way to others, then sleep.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace cairn {

class ThreadPool {
  public:
    static constexpr int max_threads = 256;

    // `threads`: the caller's and the workers', 1 to max_threads. One is the calling thread alone: then everything
    // below is an ordinary loop. Throws std::system_error if the system has no more threads.
    explicit ThreadPool(int threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int threads() const { return int(workers_.size()) + 1; }

    // work(begin, end, thread) for chunks of at most `grain` of the items 0..count, each once; thread is below
    // threads(). By one thread at a time, and not from within `work`. If `work` throws, one of the exceptions arrives
    // here after all chunks have ended.
    template <class F> void for_chunks(int count, int grain, const F& work) {
        if (count <= 0) return;
        if (workers_.empty() || count <= grain) {
            for (int begin = 0; begin < count; begin += grain)
                work(begin, count - begin < grain ? count : begin + grain, 0);
            return;
        }
        auto call = [](const void* f, int begin, int end, int thread) {
            (*static_cast<const F*>(f))(begin, end, thread);
        };
        // As many items at a time as a stage has numbers for.
        constexpr std::int64_t max_chunks = std::int64_t(index_mask);
        const std::int64_t most = max_chunks * grain;
        for (std::int64_t first = 0; first < count; first += most)
            run(int(first), int(count - first < most ? count : first + most), grain, call, &work);
    }

  private:
    using Work = void (*)(const void*, int, int, int);

    // The chunks of a stage that are at home with one thread: the number of the stage, one behind the last chunk, and
    // the next to be taken. In one word, so that a chunk is taken only of the stage that was looked at.
    struct alignas(64) Range {
        std::atomic<std::uint64_t> word{0};
    };
    static constexpr int index_bits = 20;
    static constexpr std::uint64_t index_mask = (std::uint64_t(1) << index_bits) - 1;

    void run(int first, int end, int grain, Work work, const void* context);
    void help(int thread);
    void dismiss();
    bool take_chunk(int thread);
    bool take_chunk_of(Range& range, int thread);
    void wait_for_stage(std::uint64_t seen);

    // The stage at work. May be read without a lock: what was read is used only if a chunk of the stage is taken, and
    // then the stage has not ended.
    std::vector<Range> ranges_; // one per thread
    std::atomic<int> first_{0}, end_{0}, grain_{1};
    std::atomic<Work> work_{nullptr};
    std::atomic<const void*> context_{nullptr};
    alignas(64) std::atomic<std::uint64_t> stage_{0}; // its number, once all its ranges are there
    alignas(64) std::atomic<std::uint32_t> done_{0};
    alignas(64) std::atomic<int> sleepers_{0};
    std::atomic<std::uint32_t> wakes_{0};
    std::atomic<bool> ends_{false};

    std::mutex failure_mutex_;
    std::exception_ptr failure_;
    std::vector<std::thread> workers_;
};

// The greatest of what several threads say. Compilers' builtins: the library of Emscripten 3.1 has no std::atomic_ref.
inline void raise(float& greatest, float value) {
    float seen;
    __atomic_load(&greatest, &seen, __ATOMIC_RELAXED);
    while (seen < value &&
           !__atomic_compare_exchange(&greatest, &seen, &value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {}
}

// ThreadPool::for_chunks with a thread_pool that may be none: then all at once.
template <class F> void for_chunks(ThreadPool* thread_pool, int count, int grain, const F& work) {
    if (thread_pool)
        thread_pool->for_chunks(count, grain, work);
    else if (count > 0)
        work(0, count, 0);
}

} // namespace cairn
