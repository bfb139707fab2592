#include "viewer/step_clock.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cairn::viewer {

namespace {
constexpr double measuring_window = 0.5; // s of real time
// Sixty frames of 1/60 s must make sixty steps, although 1/60 is not exact in binary.
constexpr double rounding_allowance = 1e-9; // of a step
} // namespace

int StepClock::advance(double real_seconds) {
    real_seconds = std::max(real_seconds, 0.0);
    window_seconds_ += real_seconds;
    if (window_seconds_ >= measuring_window) {
        real_time_factor_ = steps_in_window_ * time_step_ / window_seconds_;
        window_seconds_ = 0.0;
        steps_in_window_ = 0;
    }
    if (paused_) return std::exchange(requested_steps_, 0);
    // The cap must allow at least one step, however long it is.
    const double cap = std::max(max_catch_up * speed_, time_step_);
    accumulated_ = std::min(accumulated_ + real_seconds * speed_, cap);
    const int due = int(std::floor(accumulated_ / time_step_ + rounding_allowance));
    accumulated_ = std::max(accumulated_ - due * time_step_, 0.0);
    return due;
}

double StepClock::until_next_step() const {
    if (paused_) return requested_steps_ > 0 ? 0.0 : std::numeric_limits<double>::infinity();
    return (time_step_ - accumulated_) / speed_;
}

void StepClock::set_paused(bool paused) {
    paused_ = paused;
    requested_steps_ = 0;
    accumulated_ = 0.0;
}

void StepClock::request_step() {
    const int already = paused_ ? requested_steps_ : 0;
    set_paused(true);
    requested_steps_ = already + 1;
}

void StepClock::set_speed(double speed) { speed_ = std::clamp(speed, min_speed, max_speed); }

void StepClock::change_speed(int doublings) { set_speed(std::ldexp(speed_, doublings)); }

void StepClock::set_time_step(double time_step) {
    time_step_ = time_step;
    accumulated_ = 0.0;
}

} // namespace cairn::viewer
