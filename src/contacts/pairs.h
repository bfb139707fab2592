// Creates and destroys contacts as the fat boxes of shapes begin or cease to overlap.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

#include <optional>

namespace cairn {

// Runs the broad phase, on all threads of the pool if there is one; creates contacts for new pairs, and destroys those
// of pairs that ended.
void update_pairs(Bodies& bodies, Shapes& shapes, Contacts& contacts, Islands& islands, const Joints& joints,
                  BroadPhase& broad_phase, StepEvents& events, ThreadPool* thread_pool = nullptr);

// Calls update_pairs between steps once most slots are dead, so that creating and removing bodies without stepping
// takes no more memory than the live ones need. Contacts of removed bodies end as they would in the next step.
void reclaim_slots(Bodies& bodies, Shapes& shapes, Contacts& contacts, Islands& islands, const Joints& joints,
                   BroadPhase& broad_phase, StepEvents& events);

// The coefficients of two materials combined, by the rules of KHR_physics_rigid_bodies.
struct PairMaterial {
    float friction, static_friction, restitution, rolling_radius, torsion_radius;
};
PairMaterial combined_material(const Material& a, const Material& b);
// The material of a shape; for meshes and height fields, the material with this number.
const Material& material_of(const Shapes& shapes, std::uint32_t shape, std::uint32_t number);
// Writes the combined materials of a contact's shapes into its record.
void combine_materials(const Shapes& shapes, Contacts& contacts, std::uint32_t contact);

// Whether the contacts of a shape keep the kinds of their tests when it becomes another shape of its type.
bool kinds_stay(const Shapes& shapes, const Contacts& contacts, std::uint32_t shape, const Geometry& changed);
// Updates what the contacts of a shape have copied from it, when it has changed but its tests keep their kinds.
void renew_contacts(const Shapes& shapes, Contacts& contacts, std::uint32_t shape);

// Whether wide kernels support a shape: balls, sharp boxes, capsules with equal ends, and bounded one-sided surfaces.
bool has_wide_kernels(const Geometry& geometry);
// How two shapes are tested, by their types and whether wide kernels support each of them; nothing for two surfaces.
// `swapped`: b is the first shape of the test.
std::optional<PairKind> pair_kind(const Geometry& a, const Geometry& b, bool& swapped);
// Whether a pair must not use the wide kernel for its types: a small shape A rests on a large round side of B that
// touches it in more than one place (flat_side.h).
bool rests_on_round_side(const Geometry& a, const Geometry& b);
CollideKernel wide_kernel(PairKind kind);

// Returns an empty contact, in use, with this body A.
std::uint32_t new_contact(Contacts& contacts, std::int32_t body_a);
// Ends the use of a contact.
void free_contact(Contacts& contacts, std::uint32_t contact);

} // namespace cairn
