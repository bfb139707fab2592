// Contacts of pairs whose bounds begin or cease to overlap.
#pragma once

#include "state/state.h"

#include <optional>

namespace cairn {

// Runs the broad phase; creates contacts for new pairs, destroys those of pairs that ended.
void update_pairs(State& state);

// Coefficients of the two materials together, by the rules of KHR_physics_rigid_bodies.
void combine_materials(State& state, std::uint32_t contact);

// How the two are tested; nothing for two surfaces. `swapped`: b is the first shape of the test.
std::optional<PairKind> pair_kind(const Geometry& a, const Geometry& b, bool& swapped);
CollideKernel wide_kernel(PairKind kind);

// An empty contact, in use; and its end.
std::uint32_t new_contact(State& state);
void free_contact(State& state, std::uint32_t contact);

} // namespace cairn
