// After the solver: updates shape poses and the bounds of the broad phase, and measures how long bodies have been at
// rest.
#pragma once

#include "state/solver_scratch.h"
#include "state/state.h"

namespace cairn {

// Finalizes one dynamic body; safe to run concurrently for different bodies. Shapes that have left their fat boxes are
// appended to `escaped`, to be reported to the broad phase later, and bodies that moved far relative to their size to
// `fast`.
void finalize_body(Bodies& bodies, Shapes& shapes, const BroadPhase& broad_phase, const WorldDef& settings,
                   std::int32_t body, float dt, FinalizeScratch& own);

// How many bodies ahead loops over bodies prefetch. The functions load into the cache: the motion of a body; all that
// the end of a step needs of a dynamic body; and, once that is in the cache, of its first shape.
inline constexpr std::size_t bodies_ahead = 8;
void prefetch_motion(const Bodies& bodies, std::int32_t body);
void prefetch_body(const Bodies& bodies, std::int32_t body);
void prefetch_shape_of(const Bodies& bodies, const Shapes& shapes, const BroadPhase& broad_phase, std::int32_t body);

// Finalizes all kinematic bodies that move.
void finalize_kinematics(Bodies& bodies, Shapes& shapes, BroadPhase& broad_phase, float dt);

// Updates a body's shapes and proxies in the broad phase after the body was moved outside a step.
void update_proxies(Bodies& bodies, Shapes& shapes, BroadPhase& broad_phase, std::int32_t body);

// Extends the proxies of a body along its velocity after this was set outside a step. Otherwise the broad phase would
// find what the body hits in the first step only after that step.
void sweep_proxies(Bodies& bodies, Shapes& shapes, BroadPhase& broad_phase, std::int32_t body);

// Updates a body's shapes and proxies after continuous collision moved the body back along its path.
void place_again(Bodies& bodies, Shapes& shapes, BroadPhase& broad_phase, std::int32_t body, float dt);

// Adds a shape to the broad phase, according to its type and its body's type.
void add_proxy(Bodies& bodies, const Shapes& shapes, BroadPhase& broad_phase, std::uint32_t shape);
// Updates the proxy of a shape whose geometry (of the same type) or position on its body has changed.
void renew_proxy(Bodies& bodies, const Shapes& shapes, BroadPhase& broad_phase, std::uint32_t shape);

} // namespace cairn
