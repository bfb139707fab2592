// After the solver: shapes to their new places, bounds to the broad phase, time at rest measured.
#pragma once

#include "state/solver_scratch.h"
#include "state/state.h"

namespace cairn {

// One dynamic body; others may be at work on other bodies. Shapes that have left their fat boxes go to `escaped`: the
// broad phase is told later. Bodies that moved farther than their cores may go to `fast`.
void finalize_body(Bodies& bodies, Shapes& shapes, const BroadPhase& broad_phase, const WorldDef& settings,
                   std::int32_t body, float dt, FinalizeScratch& own);

// Asks the cache for how a body moves; for all that the end of a step needs of a dynamic one; and then, with that at
// hand, of its first shape.
inline constexpr std::size_t bodies_ahead = 8;
void prefetch_motion(const Bodies& bodies, std::int32_t body);
void prefetch_body(const Bodies& bodies, std::int32_t body);
void prefetch_shape_of(const Bodies& bodies, const Shapes& shapes, const BroadPhase& broad_phase, std::int32_t body);

// Kinematic bodies.
void finalize_kinematics(Bodies& bodies, Shapes& shapes, BroadPhase& broad_phase, float dt);

// Places a body's shapes and tells the broad phase, for a body that was moved from outside a step.
void update_proxies(Bodies& bodies, Shapes& shapes, BroadPhase& broad_phase, std::int32_t body);

// Tells the broad phase where a body flies to whose velocity was set from outside a step: it would find what is hit in
// the first step only after that.
void sweep_proxies(Bodies& bodies, Shapes& shapes, BroadPhase& broad_phase, std::int32_t body);

// Places a body's shapes and tells the broad phase, for a body that was put back along its way after the solver.
void place_again(Bodies& bodies, Shapes& shapes, BroadPhase& broad_phase, std::int32_t body, float dt);

// Puts a shape into the broad phase, by its type and its body's.
void add_proxy(Bodies& bodies, const Shapes& shapes, BroadPhase& broad_phase, std::uint32_t shape);
// Of one that is there, and has another geometry of its type now, or another place on its body.
void renew_proxy(Bodies& bodies, const Shapes& shapes, BroadPhase& broad_phase, std::uint32_t shape);

} // namespace cairn
