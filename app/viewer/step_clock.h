/// \file step_clock.h
/// Converts real time into whole steps of a fixed length. Real time only decides when a step is taken, never its
/// result: a slow frame, or a suspended laptop, changes nothing in the simulation.
#pragma once

namespace cairn::viewer {

class StepClock {
  public:
    /// Least and greatest speed: slow motion 1/32, fast motion 8.
    static constexpr double min_speed = 1.0 / 32.0, max_speed = 8.0;
    /// Longest backlog in real seconds that is caught up with; any excess is dropped.
    static constexpr double max_catch_up = 0.1;

    /// `time_step`: simulated seconds of one step, > 0.
    explicit StepClock(double time_step = 1.0 / 60.0) : time_step_(time_step) {}

    /// Advances real time: returns how many steps are due, at most `max_catch_up` seconds' worth.
    int advance(double real_seconds);
    /// Real seconds from the last `advance` until the next step is due; infinite while paused.
    double until_next_step() const;
    /// Simulated seconds by which real time is ahead of the last due step, 0 up to one step.
    double remainder() const noexcept { return accumulated_; }

    void set_paused(bool paused);
    bool paused() const noexcept { return paused_; }
    /// Pauses, and makes one step due at the next `advance`.
    void request_step();
    /// Simulated seconds per real second, clamped to the range above.
    void set_speed(double speed);
    /// Doubles (positive) or halves (negative) the speed that many times.
    void change_speed(int doublings);
    double speed() const noexcept { return speed_; }
    void set_time_step(double time_step);
    double time_step() const noexcept { return time_step_; }

    /// Counts a step that was taken, for the measured real-time factor.
    void count_step() noexcept { ++steps_in_window_; }
    /// Simulated seconds per real second, as measured over the last half second or so.
    double real_time_factor() const noexcept { return real_time_factor_; }

  private:
    double time_step_;
    double speed_ = 1.0;
    double accumulated_ = 0.0;
    bool paused_ = false;
    int requested_steps_ = 0;
    double window_seconds_ = 0.0;
    int steps_in_window_ = 0;
    double real_time_factor_ = 0.0;
};

} // namespace cairn::viewer
