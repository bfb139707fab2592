// How many substeps an island takes.
#pragma once

#include "state/state.h"

namespace cairn {

// Islands with joints take so many substeps, unless they have many: the error of soft rows falls with their square.
inline constexpr int joint_substeps = 11;
inline constexpr int most_substeps = 256;
inline constexpr float load_gain = 0.25f; // of the low-pass filter over steps

// Substeps of an island with so many contacts in this pass, by what it carried in the last steps (substeps.cpp).
int island_substeps(const State& state, Island& island, std::int32_t contacts);
// What a contact that begins may have to carry: the weight of the body above. Normal from A to B.
float first_load(const State& state, const ContactInfo& contact, math::Vec3 normal);
// After a step: the normal force that a contact carried, and the sum of the inverse masses that bore it. Others may be
// at work on other contacts of the island.
void note_load(Island& island, ContactInfo& contact, float force, float inverse_mass);

} // namespace cairn
