// The threads of a world: the calling thread, which always takes part, and the workers. A stage divides its items into
// chunks. Each thread has a range of chunks of its own, the same part of the items in every stage, so that its data
// from the last stage is still in its cache; a thread that has finished its range takes chunks of the others' (work
// stealing). A stage ends when its chunks are done, not when all workers have arrived, so that a worker that the
// operating system has suspended delays nobody. Results must not depend on how items are divided; which thread takes
// which chunk is nondeterministic.
//
// Between stages, workers poll for some 100 microseconds, then yield, then sleep.
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

    // `threads`: the number of threads with the calling one, 1 to max_threads. With one, everything below is an
    // ordinary loop. Throws std::system_error if the system cannot create the threads.
    explicit ThreadPool(int threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int threads() const { return int(workers_.size()) + 1; }

    // Calls work(begin, end, thread) for chunks of at most `grain` of the items 0..count, each once; thread is less
    // than threads(). Not reentrant, and only for one calling thread at a time. If `work` throws, one of the exceptions
    // is rethrown here after all chunks have ended.
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
        // At most as many items at a time as a range can number chunks for.
        constexpr std::int64_t max_chunks = std::int64_t(index_mask);
        const std::int64_t most = max_chunks * grain;
        for (std::int64_t first = 0; first < count; first += most)
            run(int(first), int(count - first < most ? count : first + most), grain, call, &work);
    }

  private:
    using Work = void (*)(const void*, int, int, int);

    // The chunks of a stage that belong to one thread: the number of the stage, one past the last chunk, and the next
    // chunk to be taken. They are in one word, so that a chunk is taken only if the stage is still the one that was
    // read.
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

    // The current stage. Its data may be read without a lock: it is used only if a chunk of the stage is taken, and
    // then the stage has not ended.
    std::vector<Range> ranges_; // one per thread
    std::atomic<int> first_{0}, end_{0}, grain_{1};
    std::atomic<Work> work_{nullptr};
    std::atomic<const void*> context_{nullptr};
    alignas(64) std::atomic<std::uint64_t> stage_{0}; // number of the stage, set after its ranges
    alignas(64) std::atomic<std::uint32_t> done_{0};
    alignas(64) std::atomic<int> sleepers_{0};
    std::atomic<std::uint32_t> wakes_{0};
    std::atomic<bool> ends_{false};

    std::mutex failure_mutex_;
    std::exception_ptr failure_;
    std::vector<std::thread> workers_;
};

// Atomic maximum of a value shared by several threads. By compiler builtins, as the library of Emscripten 3.1 has no
// std::atomic_ref.
inline void raise(float& greatest, float value) {
    float seen;
    __atomic_load(&greatest, &seen, __ATOMIC_RELAXED);
    while (seen < value &&
           !__atomic_compare_exchange(&greatest, &seen, &value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {}
}

// ThreadPool::for_chunks; without a thread pool, a single call for all items.
template <class F> void for_chunks(ThreadPool* thread_pool, int count, int grain, const F& work) {
    if (thread_pool)
        thread_pool->for_chunks(count, grain, work);
    else if (count > 0)
        work(0, count, 0);
}

} // namespace cairn
