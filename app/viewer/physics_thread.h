/// \file physics_thread.h
/// The stage on a thread of its own. The window posts commands and copies the latest state; neither waits for a step to
/// finish.
#pragma once

#include "viewer/stage.h"

#include <chrono>
#include <mutex>
#include <thread>

namespace cairn::viewer {

/// A state, and the fraction for interpolation in the real time since.
struct LatestState {
    StageState stage;
    /// Interpolation between `stage.previous` (0) and `stage.current` (1).
    float fraction = 1.0f;
};

/// The interpolation fraction between the previous and the current state, `seconds` of real time after the state was
/// published.
float interpolation_fraction(const StageState& state, double seconds);

class PhysicsThread {
  public:
    /// Loads the first scene on the calling thread, so that its exceptions reach the caller, then starts the thread.
    PhysicsThread(SceneLoader loader, const std::string& path, Savers savers = {});
    /// Finishes the present step and stops.
    ~PhysicsThread();
    PhysicsThread(const PhysicsThread&) = delete;
    PhysicsThread& operator=(const PhysicsThread&) = delete;

    void post(Command command) { queue_.push(std::move(command)); }
    LatestState latest() const;

  private:
    using Clock = std::chrono::steady_clock;
    void run();
    void publish();

    Stage stage_; // used only by the thread while it runs
    CommandQueue queue_;
    mutable std::mutex mutex_; // guards the next two members
    StageState published_;
    Clock::time_point published_at_;
    std::thread thread_; // last: all other members must exist when it starts
};

} // namespace cairn::viewer
