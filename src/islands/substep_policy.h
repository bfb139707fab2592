// How many substeps an island takes: one function of what the island bears now.
//
// A soft contact with the reduced mass m sinks under a load F by F / (m omega^2), with omega in proportion to the
// number of substeps n. So the overlap depends on the demand F / m, an acceleration, alone, and n in proportion to its
// root keeps overlaps alike. In a heap many contacts share the weight, and the world's own number is enough. In a
// slender structure (a tower, a heavy box on light ones) one contact carries a good part of all the weight, its share.
// For shapes narrower than 1.5 cm the demand grows as their width falls, so that overlaps stay small beside it. Hence
//
//     n = max(usual, share x sqrt(demand)),    demand in m/s^2,
//
// where `usual` is the world's number, or 11 where joints are: the error of soft rows in motion falls with the square
// of n. It looks at the scene alone, so that results do not depend on threads. docs/decisions/substeps.md has the
// measurements.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

inline constexpr int max_substeps = 256; // that a world may ask for
inline constexpr float stiff_factor = 2; // of the frequency: contacts with what does not move, and joints

// What the policy looks at.
struct IslandLoad {
    bool has_joints;
    float share;  // of the island's weight that its most loaded contact carries
    float demand; // m/s^2: the greatest ratio of load to reduced mass of a contact
};
int wanted_substeps(const WorldDef& settings, const IslandLoad& load);

// Of an island in this pass; what its contacts carried is forgotten, to be measured anew in the solver.
int island_substeps(const WorldDef& settings, const StepPasses& passes, Island& island);

// What a contact that begins may have to carry: the weight of the body above. Normal from A to B.
float first_load(const Bodies& bodies, const WorldDef& settings, const ContactInfo& contact, math::Vec3 normal);
// After a step: the normal force that a contact carried, and the sum of the inverse masses that bore it. Others may be
// at work on other contacts of the island.
void note_load(Island& island, ContactInfo& contact, float force, float inverse_mass);

} // namespace cairn
