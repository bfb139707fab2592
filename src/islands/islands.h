// Islands: dynamic bodies connected by contacts. They are kept from step to step: merged when a contact begins
// (the smaller is relabeled), split only when something in them has come to rest after a contact was lost. An
// island falls asleep and wakes as a whole. Static and kinematic bodies belong to none.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

void create_island(Bodies& bodies, Islands& islands, std::int32_t body); // of one awake body
// It may leave the island empty: then it is gone.
void remove_from_island(Bodies& bodies, Islands& islands, std::int32_t body);

// The bodies of an active contact are in one island from now on; if one of the two was asleep, it wakes.
void link_islands(Bodies& bodies, Islands& islands, StepEvents& events, std::int32_t body_a, std::int32_t body_b);

// Wakes the island of a dynamic body (nothing happens if it is awake), and starts its time of rest anew.
void wake_body(Bodies& bodies, Islands& islands, StepEvents& events, std::int32_t body);
void wake_island(Bodies& bodies, Islands& islands, StepEvents& events, std::int32_t island);

// Islands of which all bodies were told to sleep (Islands::told) do so, now that it is known what touches what, and
// before anything has moved. The contacts of those are no longer among the solved ones.
void put_told_to_sleep(Bodies& bodies, const Contacts& contacts, Islands& islands, StepEvents& events,
                       std::vector<std::uint32_t>& solved);

// Wakes what may rest on a body, or on one shape, that is about to change.
void wake_around(Bodies& bodies, const Shapes& shapes, Islands& islands, const BroadPhase& broad_phase,
                 StepEvents& events, std::int32_t body);
void wake_around_shape(Bodies& bodies, const Shapes& shapes, Islands& islands, const BroadPhase& broad_phase,
                       StepEvents& events, std::uint32_t shape);

// After finalize: planes make no pairs with what sleeps, so what sleeps at a kinematic one that moves is looked for.
void wake_around_moving_planes(Bodies& bodies, const Shapes& shapes, Islands& islands, const BroadPhase& broad_phase,
                               StepEvents& events);

// After finalize: splits at most one island, puts those at rest to sleep.
void update_sleep(Bodies& bodies, const Contacts& contacts, Islands& islands, const Joints& joints,
                  const WorldDef& settings, StepEvents& events, const std::vector<std::uint32_t>& solved,
                  SolverScratch& solver);

// Tells the broad phase who slept and woke since its last update.
void flush_sleep(const Bodies& bodies, const Shapes& shapes, Islands& islands, BroadPhase& broad_phase);

} // namespace cairn
