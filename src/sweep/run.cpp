#include "sweep/run.h"

#include "sweep/runner.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace cairn::sweep {

namespace {

class Workers {
  public:
    Workers(const Plan& plan, const Start& start, Store& store, const std::vector<std::uint64_t>& chunks,
            Source& source)
        : plan_(plan), start_(start), store_(store), chunks_(chunks), source_(source) {}

    void work() {
        try {
            Runner runner(plan_, start_);
            std::vector<double> numbers;
            for (std::uint64_t i = source_.next(); i < chunks_.size() && !stop_; i = source_.next()) {
                one(runner, chunks_[i], numbers);
            }
        } catch (...) {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (!error_) error_ = std::current_exception();
            stop_ = true;
        }
        const std::lock_guard<std::mutex> lock(mutex_);
        ++finished_;
        changed_.notify_all();
    }

    // Waits until all threads have finished.
    void wait(int threads, const std::function<bool(const Count&)>& goes_on) {
        std::unique_lock<std::mutex> lock(mutex_);
        while (finished_ < threads) {
            changed_.wait_for(lock, std::chrono::milliseconds(20));
            const Count now = count_;
            lock.unlock();
            source_.poll();
            if (!goes_on(now)) stop_ = true;
            lock.lock();
        }
    }
    void stop() { stop_ = true; }
    Count result() const {
        if (error_) std::rethrow_exception(error_);
        return count_;
    }

  private:
    void one(Runner& runner, std::uint64_t chunk, std::vector<double>& numbers) {
        const std::uint64_t first = store_.chunks().first(chunk), count = store_.chunks().rows_in(chunk);
        const std::size_t width = plan_.numbers();
        numbers.resize(static_cast<std::size_t>(count) * width);
        std::uint64_t failed = 0;
        for (std::uint64_t i = 0; i < count; ++i) {
            if (stop_ || !runner.run(first + i, std::span<double>(numbers).subspan(i * width, width), stop_)) return;
            failed += runner.failure().empty() ? 0 : 1;
        }
        store_.append(chunk, numbers);
        const std::lock_guard<std::mutex> lock(mutex_);
        count_.rows += count;
        count_.failed += failed;
    }

    const Plan& plan_;
    const Start& start_;
    Store& store_;
    const std::vector<std::uint64_t>& chunks_;
    Source& source_;
    std::atomic<bool> stop_{false};
    std::mutex mutex_; // guards the members below
    std::condition_variable changed_;
    int finished_ = 0;
    Count count_;
    std::exception_ptr error_;
};

} // namespace

Count run_chunks(const Plan& plan, const Start& start, Store& store, const std::vector<std::uint64_t>& chunks,
                 int threads, Source& source, const std::function<bool(const Count&)>& goes_on) {
    Workers workers(plan, start, store, chunks, source);
    {
        std::vector<std::jthread> pool;
        try {
            for (int i = 0; i < threads; ++i) pool.emplace_back([&] { workers.work(); });
            workers.wait(threads, goes_on);
        } catch (...) {
            workers.stop();
            throw;
        }
    } // the threads are joined here
    return workers.result();
}

} // namespace cairn::sweep
