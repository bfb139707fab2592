// Islands: dynamic bodies connected by contacts or joints. They are kept from step to step: merged when a contact
// begins (the bodies of the smaller one are relabeled), and split only after a contact was lost and a body has come to
// rest. An island falls asleep and wakes as a whole. Static and kinematic bodies belong to none.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

void create_island(Bodies& bodies, Islands& islands, std::int32_t body); // with one awake body
// Removes a body from its island, which is freed if that leaves it empty.
void remove_from_island(Bodies& bodies, Islands& islands, std::int32_t body);

// Merges the islands of the two bodies of a contact or joint, and wakes both.
void link_islands(Bodies& bodies, Islands& islands, StepEvents& events, std::int32_t body_a, std::int32_t body_b);

// Wakes the island of a dynamic body, if it sleeps, and resets the body's time at rest.
void wake_body(Bodies& bodies, Islands& islands, StepEvents& events, std::int32_t body);
void wake_island(Bodies& bodies, Islands& islands, StepEvents& events, std::int32_t island);

// Puts islands to sleep of which all bodies were told to sleep (Islands::sleep_requests): after contacts have been
// found, and before any body has moved. Removes the contacts of these islands from `solved`.
void apply_sleep_requests(Bodies& bodies, const Contacts& contacts, Islands& islands, StepEvents& events,
                          std::vector<std::uint32_t>& solved);

// Wakes bodies that may rest on a body, or on one shape, that is about to change.
void wake_around(Bodies& bodies, const Shapes& shapes, Islands& islands, const BroadPhase& broad_phase,
                 StepEvents& events, std::int32_t body);
void wake_around_shape(Bodies& bodies, const Shapes& shapes, Islands& islands, const BroadPhase& broad_phase,
                       StepEvents& events, std::uint32_t shape);

// After finalize: wakes sleeping bodies near moving kinematic planes, as planes make no pairs with sleeping bodies.
void wake_around_moving_planes(Bodies& bodies, const Shapes& shapes, Islands& islands, const BroadPhase& broad_phase,
                               StepEvents& events);

// After finalize: splits at most one island, and puts islands at rest to sleep.
void update_sleep(Bodies& bodies, const Contacts& contacts, Islands& islands, const Joints& joints,
                  const WorldDef& settings, StepEvents& events, const std::vector<std::uint32_t>& solved,
                  SolverScratch& solver);

// Tells the broad phase which islands fell asleep or woke since its last update.
void flush_sleep(const Bodies& bodies, const Shapes& shapes, Islands& islands, BroadPhase& broad_phase);

} // namespace cairn
