// The measuring functions, grouped by the files that define them; list.cpp lists the cases.
#pragma once

#include "validation/validation.h"

namespace cairn::validation {

// free_motion.cpp, joints.cpp
Result measure_free_fall();
Result measure_projectile();
Result measure_oscillator();
Result measure_pendulum();
Result measure_free_top();
Result measure_tumbling_box();
Result measure_gyroscope();
Result measure_impulses();
Result measure_chain_and_net();

// friction.cpp
Result measure_rolling_down();
Result measure_roll_or_slip();
Result measure_slope();
Result measure_tipping();
Result measure_sliding_stop();
Result measure_slide_to_roll();
Result measure_spinning_box();

// collisions.cpp
Result measure_bounces();
Result measure_head_on();
Result measure_oblique();
Result measure_cradle();
Result measure_closed_pile();

// structures.cpp
Result measure_stack_forces();
Result measure_moved_worlds();
Result measure_towers();

// turntable.cpp
Result measure_turntable();

// masonry.cpp
Result measure_masonry();

// bicycle.cpp
Result measure_bicycle();

// wheelset.cpp
Result measure_wheelset();

// capstan.cpp
Result measure_capstan();

// silo.cpp
Result measure_silo();

// rollers.cpp
Result measure_rollers();

// impacts.cpp
Result measure_billiards();
Result measure_shots();

// literature.cpp
Result measure_rolling_benchmark();
Result measure_bouncing_benchmark();
Result measure_pile_benchmark();
Result measure_kapla_benchmark();

} // namespace cairn::validation
