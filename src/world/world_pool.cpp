// A pool of worlds that are simulated by a shared set of threads.
#include "jobs/thread_pool.h"
#include "world/impl.h"
#include "world/validate.h"

#include <cairn/world_pool.h>

#include <cmath>
#include <exception>
#include <mutex>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace cairn {

namespace {

int checked_threads(int count) {
    if (count < 1 || count > ThreadPool::max_threads)
        refuse("WorldPool threads", std::to_string(count), "must be 1 to 256");
    return count;
}

// Exchanges the step memory of two worlds, except their threads and the layouts of their joints, which stay valid until
// the joints change.
void exchange(StepScratch& a, StepScratch& b) {
    std::swap(a, b);
    std::swap(a.thread_pool, b.thread_pool);
    std::swap(a.direct, b.direct);
    std::swap(a.solver.joint_layouts, b.solver.joint_layouts);
}

} // namespace

struct WorldPool::Impl {
    explicit Impl(int count) : threads(count), scratches(std::size_t(count)) {}

    void visit(World& world, std::size_t index, int thread, const std::function<void(World&, std::size_t)>& work) {
        StepScratch& scratch = scratches[std::size_t(thread)];
        exchange(world.impl_->step, scratch);
        std::exception_ptr error;
        try {
            work(world, index);
        } catch (...) {
            error = std::current_exception();
        }
        if (world.impl_) { // unless the world was moved from, together with its memory
            exchange(world.impl_->step, scratch);
            if (world.impl_->failed_call) scratch = {}; // in the middle of a step, so it is inconsistent
        }
        if (error) std::rethrow_exception(error);
    }

    // Visits all worlds on all threads. Rethrows the error of the world with the lowest index.
    void visit_all(const std::function<void(World&, std::size_t)>& work) {
        std::mutex mutex;
        std::exception_ptr first;
        std::size_t failed = worlds.size();
        threads.for_chunks(int(worlds.size()), 1, [&](int begin, int end, int thread) {
            for (std::size_t i = std::size_t(begin); i < std::size_t(end); ++i) try {
                    visit(worlds[i], i, thread, work);
                } catch (...) {
                    const std::lock_guard lock(mutex);
                    if (i < failed) first = std::current_exception(), failed = i;
                }
        });
        if (first) std::rethrow_exception(first);
    }

    std::vector<World> worlds;
    ThreadPool threads;
    std::vector<StepScratch> scratches; // one per thread
};

WorldPool::WorldPool(const Snapshot& start, std::size_t count, int threads) {
    constexpr std::size_t most = 1'000'000'000;
    if (count > most) refuse("WorldPool count", std::to_string(count), "must be at most 1000000000");
    try {
        impl_ = std::make_unique<Impl>(checked_threads(threads));
    } catch (const std::system_error& error) {
        throw Error(ErrorCode::unsupported, "WorldPool threads", std::to_string(threads),
                    std::string("the system has not so many threads left (") + error.what() + ")");
    }
    impl_->worlds.resize(count);
    for (World& world : impl_->worlds) world.restore(start);
}
WorldPool::~WorldPool() = default;
WorldPool::WorldPool(WorldPool&&) noexcept = default;
WorldPool& WorldPool::operator=(WorldPool&&) noexcept = default;

WorldPool::Impl& WorldPool::impl() const {
    if (!impl_) throw Error(ErrorCode::wrong_state, "WorldPool", {}, "was moved from");
    return *impl_;
}

std::size_t WorldPool::size() const noexcept { return impl_ ? impl_->worlds.size() : 0; }
int WorldPool::threads() const { return impl().threads.threads(); }

World& WorldPool::world(std::size_t index) {
    if (index >= impl().worlds.size())
        refuse("WorldPool::world index", std::to_string(index), "must be below " + std::to_string(size()));
    return impl_->worlds[index];
}
const World& WorldPool::world(std::size_t index) const { return const_cast<WorldPool*>(this)->world(index); }

void WorldPool::step(float dt, int count) {
    if (count < 0) refuse("WorldPool::step count", std::to_string(count), "must be >= 0");
    if (!(dt > 0) || !std::isfinite(dt)) refuse("WorldPool::step dt", std::to_string(dt), "must be finite and > 0");
    impl().visit_all([&](World& world, std::size_t) {
        for (int i = 0; i < count; ++i) world.step(dt);
    });
}

void WorldPool::for_each(const std::function<void(World&, std::size_t)>& work) {
    if (!work) refuse("WorldPool::for_each work", "", "must be a function");
    impl().visit_all(work);
}

} // namespace cairn
