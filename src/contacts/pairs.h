// Contacts of pairs whose bounds begin or cease to overlap.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

#include <optional>

namespace cairn {

// Runs the broad phase, by all threads of the pool if there is one; creates contacts for new pairs, destroys those of
// pairs that ended.
void update_pairs(Bodies& bodies, Shapes& shapes, Contacts& contacts, Islands& islands, const Joints& joints,
                  BroadPhase& broad_phase, StepEvents& events, ThreadPool* thread_pool = nullptr);

// Does so between steps as well once most slots are dead: bodies that come and go while nothing steps take no more
// memory than those that are there. Contacts of what has been removed end as they would in the next step.
void reclaim_slots(Bodies& bodies, Shapes& shapes, Contacts& contacts, Islands& islands, const Joints& joints,
                   BroadPhase& broad_phase, StepEvents& events);

// Coefficients of two materials together, by the rules of KHR_physics_rigid_bodies.
struct PairMaterial {
    float friction, static_friction, restitution, rolling_radius, torsion_radius;
};
PairMaterial combined_material(const Material& a, const Material& b);
// Of a shape; of meshes and height fields, that with this number.
const Material& material_of(const Shapes& shapes, std::uint32_t shape, std::uint32_t number);
// Those of the shapes of a contact, into its record.
void combine_materials(const Shapes& shapes, Contacts& contacts, std::uint32_t contact);

// Whether the contacts of a shape are tested as before when it becomes another of its type.
bool kinds_stay(const Shapes& shapes, const Contacts& contacts, std::uint32_t shape, const Geometry& changed);
// What the contacts of a shape have of it, when it has changed but is tested as before.
void renew_contacts(const Shapes& shapes, Contacts& contacts, std::uint32_t shape);

// Wide kernels know balls, sharp boxes, capsules with equal ends, and surfaces that have ends and one side.
bool has_wide_kernels(const Geometry& geometry);
// How the two are tested; nothing for two surfaces. By their types, and whether wide kernels know each of them.
// `swapped`: b is the first shape of the test.
std::optional<PairKind> pair_kind(const Geometry& a, const Geometry& b, bool& swapped);
// Whether no wide kernel does it although one knows both types: what is small, as A, on a large round side of B that
// touches it in more than one place (flat_side.h).
bool rests_on_round_side(const Geometry& a, const Geometry& b);
CollideKernel wide_kernel(PairKind kind);

// An empty contact, in use, whose body A this is; and its end.
std::uint32_t new_contact(Contacts& contacts, std::int32_t body_a);
void free_contact(Contacts& contacts, std::uint32_t contact);

} // namespace cairn
