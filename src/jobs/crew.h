// The threads of a world. A stage hands out its items in chunks to whoever is free: the calling thread, which always
// takes part, and the workers. It ends when its chunks are done, not when all workers have arrived, so that a worker
// that the operating system has put aside holds nobody up. How the items are cut into chunks must not matter to the
// results; which thread takes which chunk is left to chance.
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

class Crew {
  public:
    static constexpr int most_threads = 256;

    // `threads`: the caller's and the workers', 1 to most_threads. One is the calling thread alone: then everything
    // below is an ordinary loop. Throws std::system_error if the system has no more threads.
    explicit Crew(int threads);
    ~Crew();
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

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
        run(count, grain, call, &work);
    }

  private:
    using Work = void (*)(const void*, int, int, int);

    void run(int count, int grain, Work work, const void* context);
    void help(int thread);
    void dismiss();
    bool take_chunk(int thread);
    void wait_for_work();

    // The stage at work. The cursor holds its number in the upper half and its next chunk in the lower, or `closed`:
    // a worker may read the rest without a lock, because it is used only if the cursor has not changed meanwhile.
    static constexpr std::uint64_t closed = 0xffffffffu;
    alignas(64) std::atomic<std::uint64_t> cursor_{closed};
    std::atomic<std::uint32_t> chunk_count_{0};
    std::atomic<int> count_{0}, grain_{1};
    std::atomic<Work> work_{nullptr};
    std::atomic<const void*> context_{nullptr};
    alignas(64) std::atomic<std::uint32_t> done_{0};
    alignas(64) std::atomic<int> sleepers_{0};
    std::atomic<std::uint32_t> wakes_{0};
    std::atomic<bool> ends_{false};

    std::mutex failure_mutex_;
    std::exception_ptr failure_;
    std::uint64_t stage_ = 0; // number of the stage at work
    std::vector<std::thread> workers_;
};

// The greatest of what several threads say.
template <class AtomicFloat> void raise(AtomicFloat&& greatest, float value) {
    float seen = greatest.load(std::memory_order_relaxed);
    while (seen < value && !greatest.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {}
}

// Crew::for_chunks with a crew that may be none: then all at once.
template <class F> void for_chunks(Crew* crew, int count, int grain, const F& work) {
    if (crew)
        crew->for_chunks(count, grain, work);
    else if (count > 0)
        work(0, count, 0);
}

} // namespace cairn
