#include "viewer/physics_thread.h"

#include <algorithm>
#include <utility>

namespace cairn::viewer {

float interpolation_fraction(const StageState& state, double seconds) {
    // The displayed pose lags by up to one step, so that there is always a later state to interpolate toward.
    if (state.paused) return 1.0f;
    return float(std::clamp((state.remainder + seconds * state.speed) / state.time_step, 0.0, 1.0));
}

PhysicsThread::PhysicsThread(SceneLoader loader, const std::string& path, Savers savers)
    : stage_(std::move(loader), path, std::move(savers)) {
    publish();
    thread_ = std::thread([this] { run(); });
}

PhysicsThread::~PhysicsThread() {
    queue_.close();
    thread_.join();
}

void PhysicsThread::run() {
    Clock::time_point last = Clock::now();
    while (!queue_.closed()) {
        queue_.wait(stage_.until_next_step());
        for (const Command& command : queue_.take()) stage_.apply(command);
        const Clock::time_point now = Clock::now();
        stage_.advance(std::chrono::duration<double>(now - std::exchange(last, now)).count());
        publish();
    }
}

void PhysicsThread::publish() {
    StageState state = stage_.state();
    const std::lock_guard lock(mutex_);
    published_ = std::move(state);
    published_at_ = Clock::now();
}

LatestState PhysicsThread::latest() const {
    LatestState latest;
    Clock::time_point at;
    {
        const std::lock_guard lock(mutex_);
        latest.stage = published_;
        at = published_at_;
    }
    latest.fraction = interpolation_fraction(latest.stage, std::chrono::duration<double>(Clock::now() - at).count());
    return latest;
}

} // namespace cairn::viewer
