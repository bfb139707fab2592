// After the solver: shapes to their new places, bounds to the broad phase, time at rest measured.
#pragma once

#include "dynamics/state.h"

namespace cairn {

void finalize_bodies(State& state, float dt, bool is_last_pass);

// Places a body's shapes and tells the broad phase, for a body that was moved from outside a step.
void update_proxies(State& state, std::int32_t body);

// Puts a shape into the broad phase, by its type and its body's.
void add_proxy(State& state, std::uint32_t shape);

} // namespace cairn
